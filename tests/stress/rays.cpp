// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file rays.cpp
/// Compares solver and rays with 50 digits: `stress_rays SET CAMERAS SEED` writes JSON. SET: `random` or one of extreme_cameras.h.
///
/// Errors are in last places (2^-52 of the direction's length) and in pixels of 100,000: on the film to the point whose true ray has this
/// direction, or, if smaller, as an angle. A lens that reaches the film flips the former map.
///
/// In a narrow picture, a last place exceeds a millionth of a pixel. There the error is relative to rounding to nearest.

#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <nlohmann/json.hpp>

#include "../unit/reference_camera.h"
#include "extreme_cameras.h"
#include "error_spread.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{
namespace
{

using Exact = boost::multiprecision::cpp_bin_float_50;
using V = Vec<Exact>;
using nlohmann::json;

const double kPictureWidth = 1e5;

/// Beyond it, 1e-6 of a pixel is below a direction's last place.
const double kNarrow = 1e-6 / 0x1p-52;

const std::uint64_t kObviousEvery = 8;

struct Errors
{
    double ulps, pixels, origin, condition, pixelsPerRadian;
    double roundedPixels;  ///< error of the rounded true direction
    double roundings;  ///< angle over the largest by rounding
};

double AsDouble(const Exact& value)
{
    return value.convert_to<double>();
}

/// Offset, pixels, of the film point with this true direction.
double FilmOffset(const V& right, const V& up, const V& truth, const V& direction)
{
    const Exact a = direction.Dot(right.Cross(up)), b = truth.Dot(direction.Cross(up)), c = truth.Dot(right.Cross(direction));
    const Exact determinant = truth.Dot(right.Cross(up));
    if (!(a * determinant > 0))
        return HUGE_VAL;
    const double dx = AsDouble(b / a), dy = AsDouble(c / a);
    return std::hypot(dx, dy) * kPictureWidth;
}

Exact AngleBetween(const V& a, const V& b)
{
    return a.Cross(b).Length() / (a.Length() * b.Length());
}

/// Half a last place of each number; subnormals round as the least normal one.
Exact MostByRounding(const V& direction)
{
    Exact sum = 0;
    for (const Exact& number : {direction.x, direction.y, direction.z})
    {
        const double size = std::max(std::abs(AsDouble(number)), DBL_MIN);
        const Exact half = std::ldexp(0.5, std::ilogb(size) - 52);
        sum += half * half;
    }
    return Root(sum) / direction.Length();
}

Errors ErrorsOf(const ReferenceCamera<Exact>& reference, const CameraFrame& camera, const LensRay& ray, double x, double y, double a,
                double b)
{
    const ReferenceRay<Exact> truth = reference.Ray(x, y, a, b);
    const V k = reference.Focus(), l = truth.origin, direction(ray.direction), right(camera.right), up(camera.up);
    const V rounded(Vec3{AsDouble(truth.direction.x), AsDouble(truth.direction.y), AsDouble(truth.direction.z)});
    const Exact size = truth.direction.Length();
    const Exact perRadian = reference.Chief(x, y).Length() / right.Length() * kPictureWidth;
    const auto pixelsOff = [&](const V& found)
    {
        const bool forward = truth.direction.Dot(found) > 0;
        return std::min(forward ? AsDouble(AngleBetween(truth.direction, found) * perRadian) : HUGE_VAL,
                        FilmOffset(right - l * k.Dot(right), up - l * k.Dot(up), truth.direction, found));
    };
    const Exact radius = reference.Radius();
    const double origin = radius == 0 ? 0.0 : AsDouble((V(ray.origin) - l).Length() / (radius + Exact(DBL_MIN))) * 0x1p52;
    const Exact sum = reference.Chief(0, 0).Length() + abs(Exact(x)) * right.Length() + abs(Exact(y)) * up.Length();
    const Exact condition = sum * (1 + k.Length() * l.Length()) / size;
    const bool narrow = AsDouble(perRadian) > kNarrow;
    return {AsDouble((direction - truth.direction).Length() / size) * 0x1p52,
            pixelsOff(direction),
            origin,
            AsDouble(condition),
            AsDouble(perRadian),
            narrow ? pixelsOff(rounded) : 0.0,
            narrow ? AsDouble(AngleBetween(truth.direction, direction) / MostByRounding(truth.direction)) : 0.0};
}

/// The difference of the point of sharp focus and the lens point.
Vec3 Obvious(const Lens& lens, double x, double y, double a, double b)
{
    const Vec3 chief = lens.direction + x * lens.right + y * lens.up;
    const double distance = 1.0 / Length(lens.focus);
    const Vec3 normal = Normalized(lens.focus);
    const Vec3 P = chief * (distance / Dot(normal, chief));
    return Normalized(P - (a * lens.lensX + b * lens.lensY));
}

bool ReachesFilm(const Lens& lens)
{
    return std::hypot(Dot(lens.lensX, lens.axis), Dot(lens.lensY, lens.axis)) >= lens.filmDistance;
}

struct Run
{
    std::uint64_t cameras = 0, refused = 0, rays = 0, broken = 0, obviousBroken = 0, reachFilm = 0;
    Spread ulps, wellPosed, pixels, narrowPixels, narrowRounded, narrowRoundings, reachPixels, obviousPixels, origin;
    std::map<std::string, std::uint64_t> refusals;
    json worst = json::object();

    void Camera(Random& random, const Request& request, const FilmPoint& at);
    void Ray(const Request& request, const Lens& lens, const ReferenceCamera<Exact>& reference, double x, double y, double a, double b);
    void Refuse(const std::string& message);
    void KeepWorst(const Request& request, double x, double y, double a, double b, const Errors& e);
};

void Run::Refuse(const std::string& message)
{
    refused++;
    const std::size_t end = message.find_first_of(":(<0123456789");
    refusals[message.substr(0, end)]++;
}

void Run::KeepWorst(const Request& request, double x, double y, double a, double b, const Errors& e)
{
    std::ostringstream text;
    text << std::setprecision(17) << request << "\nx " << x << " y " << y << " a " << a << " b " << b << "\nulps " << e.ulps << " pixels "
         << e.pixels << " condition " << e.condition;
    worst["pixels"] = text.str();
}

void Run::Ray(const Request& request, const Lens& lens, const ReferenceCamera<Exact>& reference, double x, double y, double a, double b)
{
    rays++;
    const LensRay ray = MakeRay(lens, x, y, a, b);
    const double length = Length(ray.direction);
    if (!IsFinite(ray.origin) || !IsFinite(ray.direction) || !(length > 0.0) || !IsFinite(ray.direction / length))
    {
        if (broken++ == 0)
            KeepWorst(request, x, y, a, b, {});
        return;
    }
    const Errors e = ErrorsOf(reference, request.camera, ray, x, y, a, b);
    Spread& picture = ReachesFilm(lens) ? reachPixels : e.pixelsPerRadian > kNarrow ? narrowPixels : pixels;
    if (!(e.pixels <= picture.worst) && &picture == &pixels && broken == 0)
        KeepWorst(request, x, y, a, b, e);
    ulps.Add(e.ulps);
    if (e.condition <= 4.0)
        wellPosed.Add(e.ulps);
    picture.Add(e.pixels);
    if (&picture == &narrowPixels)
    {
        narrowRounded.Add(e.roundedPixels);
        narrowRoundings.Add(e.roundings);
    }
    origin.Add(e.origin);

    if (rays % kObviousEvery != 0)
        return;
    const Vec3 obvious = Obvious(lens, x, y, a, b);
    if (!IsFinite(obvious) || !(Length(obvious) > 0.0))
        obviousBroken++;
    else
        obviousPixels.Add(ErrorsOf(reference, request.camera, {ray.origin, obvious, ray.w}, x, y, a, b).pixels);
}

void Run::Camera(Random& random, const Request& request, const FilmPoint& at)
{
    cameras++;
    Lens lens;
    try
    {
        lens = Solve(request.camera, request.given);
    }
    catch (const OpticsError& error)
    {
        Refuse(error.what());
        return;
    }
    reachFilm += ReachesFilm(lens);
    const ReferenceCamera<Exact> reference(request.camera, request.given);
    const double turn = random(0.0, 2.0) * kDegree * 180.0, radius = std::sqrt(random(0.0, 1.0));
    Ray(request, lens, reference, at.x, at.y, radius * std::cos(turn), radius * std::sin(turn));
}

json Report(const Run& run)
{
    return {{"cameras", run.cameras},
            {"refused", run.refused},
            {"rays", run.rays},
            {"broken", run.broken},
            {"reach_film", run.reachFilm},
            {"obvious_broken", run.obviousBroken},
            {"ulps", run.ulps.Report()},
            {"well_posed", run.wellPosed.Report()},
            {"pixels", run.pixels.Report()},
            {"narrow_pixels", run.narrowPixels.Report()},
            {"narrow_rounded", run.narrowRounded.Report()},
            {"narrow_roundings", run.narrowRoundings.Report()},
            {"reach_pixels", run.reachPixels.Report()},
            {"origin", run.origin.Report()},
            {"obvious_pixels", run.obviousPixels.Report()},
            {"refusals", run.refusals},
            {"worst", run.worst}};
}

} // namespace
} // namespace tilt_lens

int main(int argc, char** argv)
{
    using namespace tilt_lens;
    if (argc != 4)
    {
        std::fputs("usage: stress_rays random|SET CAMERAS SEED\n", stderr);
        return 2;
    }
    const std::string name = argv[1];
    const std::uint64_t cameras = std::stoull(argv[2]), seed = std::stoull(argv[3]);
    void (*pull)(Random&, Request&, FilmPoint&) = name == "random" ? PullNothing : nullptr;
    for (const ExtremeSet& set : kExtremeSets)
        if (name == set.name)
            pull = set.pull;
    if (pull == nullptr)
    {
        std::fprintf(stderr, "stress_rays: no set %s\n", argv[1]);
        return 2;
    }
    Random random(seed);
    Run run;
    for (std::uint64_t i = 0; i < cameras; i++)
    {
        const FocusFamily families[] = {FocusFamily::LensTurn, FocusFamily::FocusTurn, FocusFamily::FocalPlane, FocusFamily::FocalPoints};
        Lens lens;
        Request request = name == "random" || name == "corners" ? SolvableRequest(random, families[i % 4], i % 8 < 4, lens)
                                                                : RandomRequest(random, families[i % 4], i % 8 < 4);
        FilmPoint at{random(-0.5, 0.5), random(-0.5, 0.5)};
        pull(random, request, at);
        run.Camera(random, request, at);
    }
    std::cout << Report(run).dump(1) << '\n';
    return 0;
}
