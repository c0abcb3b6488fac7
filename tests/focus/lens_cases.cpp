// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_cases.cpp
/// Prints random cameras, their lenses and blur in pixels, as JSON: lens_cases SEED COUNT.

#include <cstdlib>
#include <iomanip>
#include <iostream>

#include "random_cameras.h"
#include "tilt_lens/lens_camera/sharp_points.h"

using namespace tilt_lens;

namespace
{

const char* const kFamilies[] = {"lensTurn", "focusTurn", "plane", "points", "sharp"};
const double kWidth = 960.0;
const double kLargestFocus = 1000.0;

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
    out << ", \"shift\": [" << s.shiftRight << ", " << s.shiftUp << "], \"sharpPoints\": [";
    for (std::size_t i = 0; i < s.sharpPoints.size(); i++)
        out << (i ? ", [" : "[") << s.sharpPoints[i].x << ", " << s.sharpPoints[i].y << ", " << s.sharpPoints[i].z << "]";
    out << "]}";
}

Request WithSharpPoints(const Request& other, Random& random)
{
    Request request = other;
    Statement& s = request.given;
    const int count = 3 + int(random.Power(0.0, 1.3));
    const double off = random.Power(-6.0, -1.0), narrow = random.Coin() ? 1.0 : random.Power(-4.0, 0.0);
    const Vec3 u = s.points[1] - s.points[0], v = s.points[2] - s.points[0], axis = AxisOf(request.camera);
    for (int i = 0; i < count; i++)
    {
        const Vec3 point = s.points[0] + random(-0.5, 0.5) * u + narrow * random(-0.5, 0.5) * v;
        const bool again = i > 0 && random(0.0, 1.0) < 0.1;
        s.sharpPoints.push_back((again ? s.sharpPoints.back() : point) +
                                off * random(-1.0, 1.0) * Dot(point - request.camera.location, axis) * axis);
    }
    s.family = FocusFamily::SharpPoints;
    return request;
}

Request NextRequest(int number, Random& random, Lens& lens)
{
    const FocusFamily family = FocusFamily(number % 5);
    const bool focalLengthGiven = number / 5 % 2 == 0;
    if (family != FocusFamily::SharpPoints)
        return SolvableRequest(random, family, focalLengthGiven, lens);
    for (;;)
    {
        const Request request = WithSharpPoints(SolvableRequest(random, FocusFamily::FocalPoints, focalLengthGiven, lens), random);
        try
        {
            lens = Solve(request.camera, request.given);
        }
        catch (const OpticsError&)
        {
            continue;
        }
        // a plane nearly through the lens has a k with too few digits
        const double distance = Length(request.given.sharpPoints[0] - request.camera.location);
        if (CouldBeBuilt(lens) && Length(lens.focus) * distance < kLargestFocus)
            return request;
    }
}

void PrintSharpPoints(std::ostream& out, const Request& request, const Lens& lens)
{
    const double pixels = kWidth / request.given.filmWidth;
    out << ", \"sharpBlurs\": [";
    const std::vector<double> blurs = SharpPointBlurs(request.camera.location, request.given, lens);
    for (std::size_t i = 0; i < blurs.size(); i++)
        out << (i ? ", " : "") << blurs[i] * pixels;
    Statement held = request.given;
    held.sharpWithin = 1.0 / pixels;
    const std::optional<double> without = BlurWithoutTilt(request.camera.location, request.given, lens);
    out << "]";
    List{out}("stopWithinPixel", WithWidestStop(request.camera, held).fStop)("blurWithoutTilt", without ? *without * pixels : HUGE_VAL);
}

void PrintBlur(std::ostream& out, const Lens& lens, Random& random)
{
    out << ", \"blur\": [";
    for (int i = 0; i < 8; i++)
    {
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5), w = lens.focusMiddle + x * lens.focusRight + y * lens.focusUp;
        const Vec3 chief = lens.direction + x * lens.right + y * lens.up;
        const double T = i < 4 && w > 0.0 ? random(0.5, 2.0) / w : random.Power(0.0, 5.0);
        const Vec3 point = T * chief;
        out << (i ? ", " : "") << "[" << x << ", " << y << ", " << T << ", " << BlurDiameter(lens, chief, T, kWidth) << ", "
            << Dot(point, lens.axis) << "]";
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
        const Request request = NextRequest(i, random, lens);
        std::cout << (i ? ",\n" : "\n") << "{\"width\": " << kWidth;
        List list{std::cout};
        const CameraFrame& c = request.camera;
        list("location", c.location)("direction", c.direction)("right", c.right)("up", c.up);
        PrintBlock(std::cout, request.given);
        list("tilt", TiltOf(lens))("swing", SwingOf(lens))("focalLength", lens.focalLength)("filmDistance", lens.filmDistance);
        list("diameter", lens.diameter)("hinge", HingeDistanceOf(lens))("axisFocus", AxisFocusOf(lens))("lensX", lens.lensX);
        list("lensY", lens.lensY)("near", PlaneOfBlur(lens, 1.0, kWidth));
        PrintBlur(std::cout, lens, random);
        if (request.given.family == FocusFamily::SharpPoints)
            PrintSharpPoints(std::cout, request, lens);
        std::cout << "}";
    }
    std::cout << "]\n";
}
