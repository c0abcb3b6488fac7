// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file post_blur.cpp
/// Blurs a pinhole picture by its depth: pixels are spread over their circles of confusion, sums divided by weights (M. Potmesil and
/// I. Chakravarty, "A Lens and Aperture Camera Model for Synthetic Image Generation", SIGGRAPH 1981), for a tilted plane of focus.
///
/// White minus black fog: 1 - exp(-distance/fog).

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "picture.h"

namespace
{

using witness::Picture;

/// Unit: the picture's height on the film.
struct Camera
{
    double width = 0.0, distance = 0.0;       ///< film
    double lens = 0.0;                        ///< radius, scene units
    double focus = 0.0, focusSlope = 0.0;     ///< 1/distance of the plane of focus: axis, per height
    double fog = 0.0;                         ///< scene units
};

double Radius(const Camera& camera, const Picture& picture, int column, int row, double fogged)
{
    const double x = ((column + 0.5) / picture.width - 0.5) * camera.width;
    const double y = 0.5 - (row + 0.5) / picture.height;
    const double chief = std::sqrt(x * x + y * y + camera.distance * camera.distance);
    const double away = fogged < 1.0 ? -camera.fog * std::log1p(-std::max(fogged, 1e-6)) : INFINITY;
    const double vergence = chief / away - (camera.focus + camera.focusSlope * y);
    return std::fabs(vergence) * camera.lens * picture.height;
}

struct Gathered
{
    std::vector<double> light, weight;
};

void Spread(const Picture& picture, int column, int row, double radius, Gathered& gathered)
{
    const int reach = static_cast<int>(std::ceil(radius));
    const double share = 1.0 / std::max(1.0, M_PI * radius * radius);
    const double* light = &picture.values[3 * (std::size_t(row) * picture.width + column)];
    for (int y = std::max(0, row - reach); y <= std::min(picture.height - 1, row + reach); ++y)
        for (int x = std::max(0, column - reach); x <= std::min(picture.width - 1, column + reach); ++x)
        {
            const double covered = std::clamp(radius + 0.5 - std::hypot(x - column, y - row), 0.0, 1.0);
            const std::size_t pixel = std::size_t(y) * picture.width + x;
            gathered.weight[pixel] += covered * share;
            for (int channel = 0; channel < 3; ++channel)
                gathered.light[3 * pixel + channel] += covered * share * light[channel];
        }
}

Picture Blur(const Picture& picture, const Picture& white, const Picture& black, const Camera& camera)
{
    Gathered gathered{std::vector<double>(picture.Size()), std::vector<double>(picture.Size() / 3)};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
        {
            const std::size_t red = 3 * (std::size_t(row) * picture.width + column);
            const double radius = Radius(camera, picture, column, row, white.values[red] - black.values[red]);
            Spread(picture, column, row, std::max(0.5, radius), gathered);
        }
    Picture blurred = picture;
    for (std::size_t i = 0; i < blurred.Size(); ++i)
        blurred.values[i] = gathered.light[i] / gathered.weight[i / 3];
    return blurred;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app{"Blurs a pinhole picture by its depth"};
    std::string sharp, white, black, out;
    Camera camera;
    app.add_option("sharp", sharp, "the pinhole picture, linear")->required();
    app.add_option("white", white, "the same in white fog")->required();
    app.add_option("black", black, "the same in black fog")->required();
    app.add_option("out", out, "OpenEXR")->required();
    app.add_option("--fog", camera.fog, "the fog's distance")->required();
    app.add_option("--width", camera.width)->required();
    app.add_option("--distance", camera.distance)->required();
    app.add_option("--lens", camera.lens)->required();
    app.add_option("--focus", camera.focus)->required();
    app.add_option("--focus-slope", camera.focusSlope)->required();
    CLI11_PARSE(app, argc, argv);
    try
    {
        const Picture picture = witness::ReadPicture(sharp);
        const Picture inWhite = witness::ReadPicture(white), inBlack = witness::ReadPicture(black);
        if (!picture.SameSize(inWhite) || !picture.SameSize(inBlack))
            throw std::runtime_error("the three pictures are not of one size");
        const Picture blurred = Blur(picture, inWhite, inBlack, camera);
        witness::WriteReference(out, witness::Average({blurred}));
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "post_blur: %s\n", error.what());
        return 1;
    }
    return 0;
}
