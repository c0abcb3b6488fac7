// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_camera.h
/// The `tilt_lens` block of a camera as POV-Ray's Camera carries it: what was written, where it was
/// written, and how camera transformations act on it.

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

/// What the camera around a block says, kept for a block behind the camera's identifier.
struct CameraItems
{
    bool angle = false, aperture = false;  ///< these are written
    bool focalPoint = false;               ///< so is `focal_point` or `look_at`: the statement's focalPoint is one of the two
};

/// A point in focus that is found by a ray when the scene is known.
struct FocusTarget
{
    enum Kind { NotUsed, Object, Picture } kind = NotUsed;
    std::string name;              ///< of the object
    shared_ptr<ObjectBase> object; ///< a copy of it
    double x = 0.0, y = 0.0;       ///< in the picture: from its lower left corner, 0 to 1
    tilt_lens::Vec3 found;         ///< world

    std::string Written() const;  ///< as in the scene
};

struct TiltLensCamera
{
    bool given = false;  ///< the camera has a `tilt_lens` block; all else is unused without, but for `items` and the
                         ///< statement's focalPoint and scale
    bool open = false;   ///< the block belongs to the camera statement that is being parsed
    WrittenItems written;
    CameraItems items;
    TiltLensPlace place; ///< of the block's first word
    std::set<std::string> words;  ///< the items that the block has
    tilt_lens::Statement statement;
    tilt_lens::Vec3 facade;  ///< from the lower left to the lower right corner that Tilt_Lens_Facade was told; 0 without
    tilt_lens::FocusAids aids;  ///< what a preview draws in place of the lens's picture

    FocusTarget focusTarget;                ///< in place of the statement's focalPoint
    std::vector<FocusTarget> pointTargets;  ///< in place of its points or sharpPoints; empty where it has none of them

    /// `sharp_within`, from which the picture's width makes the statement's sharpWithin.
    std::optional<double> sharpWithinPixels;

    /// Whether the statement holds all that the lens is solved from; else FindFocus() (focus_target.h) puts it there.
    bool IsComplete() const;

    /// The point of the statement that pointTargets[i] stands for.
    tilt_lens::Vec3& TargetPoint(std::size_t i);

    /// The item that sets the aperture by the blur of sharp_points, or NULL.
    const char* BlurLimitWord() const;

    /// What the block makes of the camera that it belongs to. Solved once, when a camera statement ends, or before the render
    /// where the focus has to be found; NULL before and after a transformation.
    shared_ptr<const tilt_lens::Lens> lens;

    /// Carries plane, points and scale of the lens with the camera.
    void Transform(const TRANSFORM* trans);

    /// Solves the block for its camera.
    /// @throws tilt_lens::OpticsError  which names the transformations of a camera that has some
    static void Solve(Camera& camera);
};

} // namespace pov

#endif
