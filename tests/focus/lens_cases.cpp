// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_cases.cpp
/// Prints random cameras, their lenses and blur in pixels by the library, as JSON, for comparison with the page's formulas:
/// lens_cases SEED COUNT.

#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "random_cameras.h"

using namespace tilt_lens;

namespace
{

const char* const kFamilies[] = {"lensTurn", "focusTurn", "plane", "points"};
const double kWidth = 960.0;

struct List
{
    std::ostream& out;
    List& operator()(const char* name, const Vec3& v)
    {
        out << ", \"" << name << "\": [" << v.x << ", " << v.y << ", " << v.z << "]";
        return *this;
    }
    List& operator()(const char* name, double value)
    {
        out << ", \"" << name << "\": ";
        if (std::isfinite(value))
            out << value;
        else
            out << "null";
        return *this;
    }
    List& operator()(const char* name, const std::optional<double>& value)
    {
        return (*this)(name, value ? *value : std::numeric_limits<double>::infinity());
    }
};

void PrintBlock(std::ostream& out, const Statement& s)
{
    out << ", \"block\": {\"family\": \"" << kFamilies[int(s.family)] << "\"";
    List list{out};
    list("filmWidth", s.filmWidth)("focalLength", s.focalLength)("sceneUnit", s.sceneUnit)("tilt", s.tilt);
    list("swing", s.swing)("focusTilt", s.focusTilt)("focusSwing", s.focusSwing)("planeNormal", s.planeNormal);
    list("planeDistance", s.planeDistance)("fStop", s.fStop)("focalPoint", s.focalPoint)("aperture", s.aperture);
    list("scale", s.scale)("A", s.points[0])("B", s.points[1])("C", s.points[2]);
    out << ", \"shift\": [" << s.shiftRight << ", " << s.shiftUp << "]}";
}

/// Blur of surface points all over the picture, near the plane of sharp focus and far from it.
void PrintBlur(std::ostream& out, const Lens& lens, Random& random)
{
    out << ", \"blur\": [";
    for (int i = 0; i < 8; i++)
    {
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5), w = lens.focusMiddle + x * lens.focusRight + y * lens.focusUp;
        const Vec3 chief = lens.direction + x * lens.right + y * lens.up;
        const double T = i < 4 && w > 0.0 ? random(0.5, 2.0) / w : random.Power(0.0, 5.0);
        const Vec3 point = T * chief;
        out << (i ? ", " : "") << "[" << x << ", " << y << ", " << T << ", " << BlurDiameter(lens, chief, T, kWidth)
            << ", " << Dot(point, lens.axis) << "]";
    }
    out << "]";
}

} // namespace

int main(int count, char** words)
{
    if (count != 3)
        return 2;
    Random random(std::strtoull(words[1], NULL, 10));
    const int cases = std::atoi(words[2]);
    std::cout << std::setprecision(17) << "[";
    for (int i = 0; i < cases; i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, FocusFamily(i % 4), i / 4 % 2 == 0, lens);
        std::cout << (i ? ",\n" : "\n") << "{\"width\": " << kWidth;
        List list{std::cout};
        const CameraFrame& c = request.camera;
        list("location", c.location)("direction", c.direction)("right", c.right)("up", c.up);
        PrintBlock(std::cout, request.given);
        list("tilt", TiltOf(lens))("swing", SwingOf(lens))("focalLength", lens.focalLength)("filmDistance", lens.filmDistance);
        list("diameter", lens.diameter)("hinge", HingeDistanceOf(lens))("axisFocus", AxisFocusOf(lens))("lensX", lens.lensX);
        list("lensY", lens.lensY)("near", PlaneOfBlur(lens, 1.0, kWidth));
        PrintBlur(std::cout, lens, random);
        std::cout << "}";
    }
    std::cout << "]\n";
}
