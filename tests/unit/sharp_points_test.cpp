// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_cameras.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/lens_camera/sharp_points.h"

namespace tilt_lens
{

namespace
{

Request WithPoints(Random& random, bool focalLengthGiven, int count)
{
    Request request = RandomRequest(random, FocusFamily::SharpPoints, focalLengthGiven);
    const Vec3 axis = AxisOf(request.camera), right = Normalized(request.camera.right), up = Cross(axis, right);
    const double distance = Dot(request.given.focalPoint - request.camera.location, axis);
    for (int i = 0; i < count; i++)
    {
        const double x = random(-0.3, 0.3), y = random(-0.3, 0.3);
        const double z = 1.0 + 0.5 * x - 0.8 * y + random(-0.2, 0.2);
        request.given.sharpPoints.push_back(request.camera.location + distance * z * (axis + x * right + y * up));
    }
    return request;
}

double GreatestOf(const Request& request)
{
    return GreatestBlur(SharpPointBlurs(request.camera.location, request.given, Solved(request)));
}

Request Moved(Random& random, const Request& request, const Lens& lens, double size)
{
    Request moved = request;
    const Vec3 k = lens.focus + size * Length(lens.focus) * random.Direction();
    moved.given.family = FocusFamily::FocalPlane;
    moved.given.planeNormal = Normalized(k);
    moved.given.planeDistance = 1.0 / Length(k) + Dot(moved.given.planeNormal, request.camera.location);
    return moved;
}

} // namespace

TEST(SharpPoints, NoOtherPlaneBlursLess)
{
    Random random(1);
    int lenses = 0;
    for (int i = 0; i < 600; i++)
    {
        const Request request = WithPoints(random, i % 2 == 0, 3 + i % 6);
        try
        {
            const Lens lens = Solved(request);
            const double least = GreatestOf(request);
            for (int j = 0; j < 10; j++)
                ASSERT_GE(GreatestOf(Moved(random, request, lens, random.Power(-7.0, -1.0))), least * (1.0 - 1e-9)) << request;
            lenses++;
        }
        catch (const OpticsError&)
        {
            continue;
        }
    }
    EXPECT_GT(lenses, 300);
}

TEST(SharpPoints, FourPointsBindByTurns)
{
    Random random(2);
    for (int i = 0; i < 200; i++)
    {
        const Request request = WithPoints(random, false, 4);
        std::vector<double> blurs;
        try
        {
            blurs = SharpPointBlurs(request.camera.location, request.given, Solved(request));
        }
        catch (const OpticsError&)
        {
            continue;
        }
        const double greatest = GreatestBlur(blurs);
        for (double blur : blurs)
            EXPECT_NEAR(std::fabs(blur), greatest, 1e-9 * greatest) << request;
        EXPECT_TRUE(*std::min_element(blurs.begin(), blurs.end()) < 0.0 && *std::max_element(blurs.begin(), blurs.end()) > 0.0) << request;
    }
}

TEST(SharpPoints, ThreeAreFocalPoints)
{
    Random random(3);
    for (int i = 0; i < 200; i++)
    {
        Lens lens;
        Request request = SolvableRequest(random, FocusFamily::FocalPoints, i % 2 == 0, lens);
        const Vec3 axis = AxisOf(request.camera);
        request.given.family = FocusFamily::SharpPoints;
        request.given.sharpPoints.assign(request.given.points, request.given.points + 3);
        bool before = true;
        for (const Vec3& point : request.given.sharpPoints)
            before = before && Dot(point - request.camera.location, axis) > 1e-6;
        if (!before)
        {
            EXPECT_THROW(Solved(request), OpticsError) << request;
            continue;
        }
        const Lens same = Solved(request);
        EXPECT_LT(Length(same.focus - lens.focus), 1e-13 * Length(lens.focus)) << request;
        EXPECT_NEAR(same.diameter, lens.diameter, 1e-13 * lens.diameter) << request;
    }
}

TEST(SharpPoints, WidestApertureHoldsAll)
{
    Random random(4);
    int held = 0;
    for (int i = 0; i < 300; i++)
    {
        Request request = WithPoints(random, i % 2 == 0, 4 + i % 4);
        Character& character = request.given.character;
        if (i % 3 == 1)
            character.distortion1 = 0.02, character.distortionNear = 0.01;
        if (i % 3 == 2)
            character.fieldCurvature = 0.1;
        request.given.fStop.reset();
        request.given.aperture = 0.0;
        request.given.sharpWithin = request.given.filmWidth * random.Power(-5.0, -3.0);
        Lens lens;
        try
        {
            lens = Solved(request);
        }
        catch (const OpticsError&)
        {
            continue;
        }
        const double greatest = GreatestOf(request), stop = lens.focalLength / lens.diameter;
        ASSERT_LE(greatest, *request.given.sharpWithin * (1.0 + 1e-9)) << request;
        if (stop > kWidestStop * (1.0 + 1e-9))
        {
            held++;
            ASSERT_NEAR(greatest, *request.given.sharpWithin, 1e-9 * greatest) << request;
        }
        const double limit = *request.given.sharpWithin;
        request.given.sharpWithin.reset();
        request.given.fStop = stop;
        ASSERT_NEAR(Solved(request).diameter, lens.diameter, 1e-12 * lens.diameter) << request << " within " << limit;
    }
    EXPECT_GT(held, 100);
}

TEST(SharpPoints, KnowsTheBestLensWithoutTilt)
{
    Random random(5);
    int lenses = 0;
    for (int i = 0; i < 60; i++)
    {
        Request request = WithPoints(random, i % 2 == 0, 5);
        request.given.aperture = 0.0;
        request.given.fStop = 8.0;
        try
        {
            const Lens lens = Solved(request);
            const auto without = BlurWithoutTilt(request.camera.location, request.given, lens);
            if (!without)
                continue;
            EXPECT_GE(*without, GreatestOf(request)) << request;
            Request parallel = request;
            parallel.given.family = FocusFamily::FocalPlane;
            parallel.given.planeNormal = lens.axis;
            double best = HUGE_VAL;
            const double distance = Dot(request.given.focalPoint - request.camera.location, lens.axis);
            for (int step = 0; step < 500; step++)
            {
                parallel.given.planeDistance = Dot(request.camera.location, lens.axis) + distance * (0.3 + 0.004 * step);
                best = std::min(best, GreatestOf(parallel));
            }
            EXPECT_LE(*without, best * (1.0 + 1e-9)) << request;
            EXPECT_GT(*without, best / 1.1) << request;
            lenses++;
        }
        catch (const OpticsError&)
        {
            continue;
        }
    }
    EXPECT_GT(lenses, 20);
}

} // namespace tilt_lens
