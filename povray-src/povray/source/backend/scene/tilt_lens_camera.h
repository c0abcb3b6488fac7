// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_camera.h
/// The `tilt_lens` block of a camera as POV-Ray's Camera carries it: what was written, where it was
/// written, and how camera transformations act on it.

#ifndef POVRAY_BACKEND_TILT_LENS_CAMERA_H
#define POVRAY_BACKEND_TILT_LENS_CAMERA_H

#include <string>
#include <vector>

#include "backend/frame.h"
#include "base/povms.h"
#include "base/stringutilities.h"
#include "tilt_lens/camera/focus_aids.h"
#include "tilt_lens/camera/optics.h"

namespace pov
{

using namespace pov_base;

class Camera;

inline tilt_lens::Vec3 FromPov(const VECTOR v) { return {v[X], v[Y], v[Z]}; }

/// A place in a scene file, for messages.
struct TiltLensPlace
{
    UCS2String file;
    POV_LONG line = 0, column = 0, offset = 0;
};

/// What a camera statement says of items whose values POV-Ray's camera does not show.
struct WrittenItems
{
    bool aperture = false;                    ///< it is written; its value may be the default, 0
    double variance = 0.0, confidence = 0.9;  ///< as written, or allowed; the camera has the default for what is not

    struct Warning
    {
        TiltLensPlace place;
        std::string text;
    };
    std::vector<Warning> warnings;  ///< of values that are an error where the camera has `tilt_lens`
};

struct TiltLensCamera
{
    bool given = false;  ///< the camera has a `tilt_lens` block; all else is unused without
    bool open = false;   ///< the block belongs to the camera statement that is being parsed
    WrittenItems written;
    TiltLensPlace place; ///< of the block's first word
    tilt_lens::Statement statement;
    tilt_lens::FocusAids aids;  ///< what a preview draws in place of the lens's picture

    /// What the block makes of the camera that it belongs to. Solved once, when a camera statement ends; NULL before and
    /// after a transformation.
    shared_ptr<const tilt_lens::Lens> lens;

    /// Carries plane, points and scale of the lens with the camera.
    void Transform(const TRANSFORM* trans);

    /// Solves the block for its camera.
    /// @throws tilt_lens::OpticsError
    static void Solve(Camera& camera);
};

} // namespace pov

#endif
