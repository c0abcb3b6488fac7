// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Compares rays with long double, and cameras with 50 digits.

#include <cfloat>
#include <cstdio>
#include <map>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "random_cameras.h"
#include "reference_camera.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{
namespace
{

static_assert(LDBL_MANT_DIG >= 64, "the rays' reference needs more digits than double has");

const FocusFamily kFamilies[] = {FocusFamily::LensTurn, FocusFamily::FocusTurn, FocusFamily::FocalPlane, FocusFamily::FocalPoints};
const char* const kFamilyNames[] = {"lens turn", "focus turn", "focal plane", "focal points"};

/// Error in last places (2^-52).
template<typename Real>
double Ulps(const Vec<Real>& value, const Vec<Real>& truth)
{
    return double((value - truth).Length() / truth.Length()) * 0x1p52;
}

using Long = boost::multiprecision::cpp_bin_float_50;

template<typename Real>
Vec<Real> As(const Vec3& v)
{
    return Vec<Real>(v);
}

LensRay ExactRay(const Lens& lens, double x, double y, double a, double b, Vec<long double>& direction)
{
    using V = Vec<long double>;
    const V chief = V(lens.direction) + V(lens.right) * x + V(lens.up) * y;
    const V point = V(lens.lensX) * a + V(lens.lensY) * b;
    using Real = long double;
    const Real w = Real(lens.focusMiddle) + Real(x) * lens.focusRight + Real(y) * lens.focusUp;
    direction = chief - point * w;
    return {{double(point.x), double(point.y), double(point.z)}, {}, 0.0};
}

TEST(Precision, ARayIsFormedToAFewUnitsOfTheLastPlace)
{
    Random random(21);
    double worst = 0.0, sum = 0.0;
    int rays = 0;
    for (int i = 0; i < 10000; i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, kFamilies[i % 4], i % 8 < 4, lens);
        for (int j = 0; j < 100; j++, rays++)
        {
            const double x = random(-0.5, 0.5), y = random(-0.5, 0.5), a = random(-0.7, 0.7), b = random(-0.7, 0.7);
            Vec<long double> truth;
            const LensRay exact = ExactRay(lens, x, y, a, b, truth), ray = MakeRay(lens, x, y, a, b);
            const double ulps = Ulps(As<long double>(ray.direction), truth);
            if (!(ulps <= 4.0) || !(Length(ray.origin - exact.origin) <= 0x1p-50 * lens.diameter))
                FAIL() << ulps << " ulp\n" << request << "\nx " << x << " y " << y << " a " << a << " b " << b;
            worst = std::max(worst, ulps);
            sum += ulps;
        }
    }
    std::printf("[          ] %d rays: mean %.2f ulp, worst %.2f ulp\n", rays, sum / rays, worst);
}

struct Tally
{
    double worst = 0.0, sum = 0.0;
    std::uint64_t rays = 0;
};

TEST(Precision, CamerasKeepTheirDigitsFromStatementToRay)
{
    Random random(22);
    Tally tallies[4];
    const int cameras = 20000;
    for (int i = 0; i < cameras; i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, kFamilies[i % 4], i % 8 < 4, lens);
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5), a = random(-0.7, 0.7), b = random(-0.7, 0.7);
        const LensRay ray = MakeRay(lens, x, y, a, b);
        const auto truth = ReferenceCamera<Long>(request.camera, request.given).Ray(x, y, a, b);
        const double ulps = Ulps(As<Long>(ray.direction), truth.direction);
        const double origin = double((As<Long>(ray.origin) - truth.origin).Length()) / lens.diameter * 0x1p52;
        if (!(ulps <= 4.0) || !(origin <= 4.0) || !(Length(ray.direction) > 0.0))
            FAIL() << ulps << " ulp, origin " << origin << '\n' << request << "\nx " << x << " y " << y << " a " << a << " b " << b;
        Tally& tally = tallies[i % 4];
        tally.worst = std::max(tally.worst, ulps);
        tally.sum += ulps;
        tally.rays++;
    }
    for (int family = 0; family < 4; family++)
    {
        const Tally& t = tallies[family];
        std::printf("[          ] %-12s %d cameras: mean %.2f, worst %.1f ulp\n", kFamilyNames[family], int(t.rays), t.sum / t.rays,
                    t.worst);
    }
}

TEST(Precision, ScalesFrom1em9To1e9AreAlike)
{
    Random random(24);
    for (int i = 0; i < 10000; i++)
    {
        Lens lens;
        Request request = SolvableRequest(random, kFamilies[i % 4], i % 8 < 4, lens);
        const double scale = random.Power(-9, 9);
        request.camera.location = scale * request.camera.location;
        for (Vec3* v : {&request.camera.direction, &request.camera.right, &request.camera.up, &request.given.focalPoint,
                        &request.given.points[0], &request.given.points[1], &request.given.points[2]})
            *v = scale * *v;
        request.given.planeDistance *= scale;
        request.given.scale = scale;
        lens = Solved(request);
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5), a = random(-0.7, 0.7), b = random(-0.7, 0.7);
        const LensRay ray = MakeRay(lens, x, y, a, b);
        const auto truth = ReferenceCamera<Long>(request.camera, request.given).Ray(x, y, a, b);
        ASSERT_LE(Ulps(As<Long>(ray.direction), truth.direction), 4.0) << request;
    }
}

} // namespace
} // namespace tilt_lens
