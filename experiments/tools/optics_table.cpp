// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Equation (1) of Nakane et al.:
//
//     tan(theta_L) = f_p tan(theta_F) / (U + f_p)
//
// theta_F: plane of sharp focus to film, U: its distance on the axis, f_p: film distance (the paper's focal length), theta_L: the lens's
// angle.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>

#include <CLI/CLI.hpp>

#include "tilt_lens/lens_camera/solve.h"

namespace
{

using tilt_lens::Lens;
using tilt_lens::Statement;

const long double kDegree = std::acos(-1.0L) / 180.0L;

/// Degrees, scene units; errors in double's epsilon.
struct Row
{
    double focusTilt, distance, filmDistance;
    double equation, solved, reversed;
    double error, reverseError, focalLength;
};

tilt_lens::CameraFrame Camera(double filmDistance)
{
    return {{}, {0, 0, 1}, {0.036 / filmDistance, 0, 0}, {0, 0.024 / filmDistance, 0}};
}

double Relative(long double value, long double truth)
{
    const long double epsilon = std::numeric_limits<double>::epsilon();
    return static_cast<double>(std::fabs(value - truth) / std::fabs(truth) / epsilon);
}

Row Solve(double focusTilt, double distance, double filmDistance)
{
    Row row{focusTilt, distance, filmDistance, 0, 0, 0, 0, 0, 0};
    const long double tangent = filmDistance * std::tan(focusTilt * kDegree) / (static_cast<long double>(distance) + filmDistance);
    row.equation = static_cast<double>(std::atan(tangent) / kDegree);

    Statement plane;
    plane.family = tilt_lens::FocusFamily::FocusTurn;
    plane.focusTilt = focusTilt;
    plane.focalPoint = {0, 0, distance};
    const Lens lens = tilt_lens::Solve(Camera(filmDistance), plane);
    row.solved = tilt_lens::TiltOf(lens);
    row.focalLength = lens.focalLength;
    row.error = Relative(-lens.normal.y / static_cast<long double>(lens.normal.z), tangent);

    Statement turned;
    turned.tilt = row.solved;
    turned.focalPoint = {0, 0, distance};
    const Lens back = tilt_lens::Solve(Camera(filmDistance), turned);
    const long double focusTangent = -back.focus.y / static_cast<long double>(back.focus.z);
    row.reversed = static_cast<double>(std::atan(focusTangent) / kDegree);
    row.reverseError = Relative(focusTangent, std::tan(focusTilt * kDegree));
    return row;
}

void WriteLine(std::ostream& out, const Row& row)
{
    char line[256];
    std::snprintf(line, sizeof line, "%.6g,%.6g,%.6g,%.12f,%.12f,%.12f,%.9g,%.2f,%.2f\n", row.focusTilt, row.distance, row.filmDistance,
                  row.equation, row.solved, row.reversed, row.focalLength, row.error, row.reverseError);
    out << line;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Equation (1) of the paper by Nakane et al. against the solver, both ways.");
    std::string csv;
    double limit = 8.0;  // a dozen roundings, at angles up to 85 degrees
    app.add_option("--csv", csv, "table to write")->required();
    app.add_option("--limit", limit, "largest relative error, in units of 2^-52")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    std::ofstream out(csv);
    out << "theta_F,U,f_p,theta_L by equation (1),theta_L solved,theta_F in reverse,f,"
           "error (2^-52),reverse error (2^-52)\n";
    double worst = 0.0, worstReverse = 0.0;
    int rows = 0;
    for (const double filmDistance : {0.024, 0.05, 0.09, 0.2})
        for (const double distance : {0.3, 1.0, 5.0, 100.0})
            for (const double focusTilt : {-80.0, -45.0, -10.0, 1.0, 30.0, 60.0, 85.0})
            {
                const Row row = Solve(focusTilt, distance, filmDistance);
                WriteLine(out, row);
                worst = std::max(worst, row.error);
                worstReverse = std::max(worstReverse, row.reverseError);
                ++rows;
            }
    if (!out.flush())
    {
        std::cerr << "optics_table: cannot write " << csv << '\n';
        return 1;
    }
    std::cout << "{\"rows\": " << rows << ", \"worst\": " << worst << ", \"worst_reverse\": " << worstReverse << "}\n";
    return worst <= limit && worstReverse <= limit ? 0 : 2;
}
