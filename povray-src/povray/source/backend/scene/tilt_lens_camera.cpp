// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cstdio>

#include "backend/frame.h"
#include "backend/math/matrices.h"
#include "backend/scene/camera.h"
#include "backend/scene/tilt_lens_camera.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

Vec3 TransformedPoint(const Vec3& p, const TRANSFORM* trans)
{
    VECTOR v = {p.x, p.y, p.z};
    if (trans != NULL)
        MTransPoint(v, v, trans);
    return FromPov(v);
}

namespace
{

Vec3 TransformedNormal(const Vec3& n, const TRANSFORM* trans)
{
    VECTOR v = {n.x, n.y, n.z};
    MTransNormal(v, v, trans);
    return FromPov(v);
}

double Determinant(const TRANSFORM* trans)
{
    const MATRIX& m = trans->matrix;
    return Dot(Vec3{m[0][0], m[0][1], m[0][2]}, Cross(Vec3{m[1][0], m[1][1], m[1][2]}, Vec3{m[2][0], m[2][1], m[2][2]}));
}

bool IsMoved(const Camera& camera)
{
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++)
            if (camera.Trans->matrix[row][column] != (row == column ? 1.0 : 0.0))
                return true;
    return false;
}

} // namespace

std::string FocusTarget::Written() const
{
    if (kind == Object)
        return "focus_on " + name;
    char text[64];
    std::snprintf(text, sizeof text, "focus_at <%g, %g>", x, y);
    return text;
}

bool TiltLensCamera::IsComplete() const
{
    bool has = focusTarget.kind == FocusTarget::NotUsed && (!sharpWithinPixels || statement.sharpWithin);
    for (const FocusTarget& target : pointTargets)
        has = has && target.kind == FocusTarget::NotUsed;
    return has;
}

Vec3& TiltLensCamera::TargetPoint(std::size_t i)
{
    return statement.family == tilt_lens::FocusFamily::SharpPoints ? statement.sharpPoints[i] : statement.points[i];
}

const char* TiltLensCamera::BlurLimitWord() const
{
    return sharpWithinPixels ? "sharp_within" : statement.sharpWithin ? "circle_of_confusion" : NULL;
}

void TiltLensCamera::Transform(const TRANSFORM* trans)
{
    lens.reset();
    tilt_lens::Statement& s = statement;
    const Vec3 normal = Normalized(s.planeNormal);
    const Vec3 onPlane = TransformedPoint(normal * s.planeDistance, trans);
    s.planeNormal = Normalized(TransformedNormal(normal, trans));
    s.planeDistance = Dot(s.planeNormal, onPlane);
    for (Vec3& point : s.points)
        point = TransformedPoint(point, trans);
    for (Vec3& point : s.sharpPoints)
        point = TransformedPoint(point, trans);
    s.focalPoint = TransformedPoint(s.focalPoint, trans);
    s.scale *= std::cbrt(std::fabs(Determinant(trans)));
}

void TiltLensCamera::Solve(Camera& camera)
{
    const tilt_lens::CameraFrame frame{FromPov(camera.Location), FromPov(camera.Direction), FromPov(camera.Right), FromPov(camera.Up)};
    try
    {
        camera.TiltLens.lens.reset(new tilt_lens::SolvedLens(tilt_lens::Solve(frame, camera.TiltLens.statement)));
    }
    catch (const tilt_lens::OpticsError& error)
    {
        if (!IsMoved(camera))
            throw;
        throw tilt_lens::OpticsError(error.what() + std::string(" Points and planes were moved by the camera's transformations, which act "
                                                                "on its items."));
    }
}

} // namespace pov
