// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_camera.h
/// The `tilt_lens` block in POV-Ray's Camera.

#ifndef POVRAY_BACKEND_TILT_LENS_CAMERA_H
#define POVRAY_BACKEND_TILT_LENS_CAMERA_H

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "base/povms.h"
#include "base/stringutilities.h"
#include "tilt_lens/camera/focus_aids.h"
#include "tilt_lens/lens_camera/solve.h"

namespace pov
{

using namespace pov_base;

class Camera;

inline tilt_lens::Vec3 FromPov(const VECTOR v)
{
    return {v[X], v[Y], v[Z]};
}

/// @param trans  may be NULL
tilt_lens::Vec3 TransformedPoint(const tilt_lens::Vec3& p, const TRANSFORM* trans);

struct TiltLensPlace
{
    UCS2String file;
    POV_LONG line = 0, column = 0, offset = 0;
};

/// For a block behind the camera's identifier.
struct CameraItems
{
    bool angle = false, aperture = false, variance = false;
    bool focalPoint = false;  ///< `focal_point` or `look_at`
};

struct FocusTarget
{
    enum Kind
    {
        NotUsed,
        Object,
        Picture
    } kind = NotUsed;
    std::string name;
    shared_ptr<ObjectBase> object;
    double x = 0.0, y = 0.0;       ///< from the lower left corner, 0 to 1
    tilt_lens::Vec3 found;         ///< world

    std::string Written() const;
};

struct TiltLensCamera
{
    bool given = false;  ///< else only `items`, focalPoint and scale are used
    CameraItems items;
    TiltLensPlace place;
    std::set<std::string> words;
    tilt_lens::Statement statement;
    tilt_lens::FocusAids aids;

    FocusTarget focusTarget;                ///< replaces the statement's focalPoint
    std::vector<FocusTarget> pointTargets;  ///< replace its points or sharpPoints

    /// Becomes the statement's sharpWithin by the picture's width.
    std::optional<double> sharpWithinPixels;

    /// False before FindFocus().
    bool IsComplete() const;

    tilt_lens::Vec3& TargetPoint(std::size_t i);

    /// Item that limits the blur of sharp_points, or NULL.
    const char* BlurLimitWord() const;

    /// NULL before the focus is found, and after a transformation.
    shared_ptr<const tilt_lens::SolvedLens> lens;

    void Transform(const TRANSFORM* trans);

    /// @throws tilt_lens::OpticsError
    static void Solve(Camera& camera);
};

} // namespace pov

#endif
