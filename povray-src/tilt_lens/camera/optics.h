// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file optics.h
/// Solves a `tilt_lens` statement for the lens, the film and the plane of sharp focus.
///
/// Model (docs/optics.md): a thin lens, tilted about its centre, the camera's location; a flat film parallel to `right` and `up`. With z
/// the camera axis, the film at -s z, t the unit lens normal and f the focal length, the plane of sharp focus is k.X = 1 with
///
///     k = t/f - z/s                                       (X relative to the lens centre).
///
/// k = 0 is a plane at infinity; no formula divides by a distance that may vanish.
///
/// Sources: T. Nakane et al., "Simulating tilt-shift lens using distributed ray tracing" (equation 1); H. M. Merklinger, "Principles of
/// View Camera Focus"; A. Kensler, "Tilt-Shift Rendering Using a Thin Lens Model", Ray Tracing Gems II, chapter 31.

#ifndef TILT_LENS_OPTICS_H
#define TILT_LENS_OPTICS_H

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tilt_lens/camera/character.h"
#include "tilt_lens/math/vec3.h"

namespace tilt_lens
{

struct Prescription;

/// POV-Ray's camera after all transformations; world frame, scene units.
struct CameraFrame
{
    Vec3 location;   ///< lens centre
    Vec3 direction;  ///< lens centre to frame centre
    Vec3 right, up;  ///< frame's width and height
};

enum class FocusFamily
{
    LensTurn,    ///< `tilt`, `swing`, focal point or film distance
    FocusTurn,
    FocalPlane,
    FocalPoints,
    SharpPoints
};

/// Film in mm, angles in degrees; points and planes in world coordinates, scene units.
struct Statement
{
    double filmWidth = 36.0;
    std::optional<double> focalLength;  ///< mm; absent: the angle of view gives the film distance
    double sceneUnit = 1000.0;          ///< mm per scene unit
    FocusFamily family = FocusFamily::LensTurn;
    double tilt = 0.0, swing = 0.0;
    double focusTilt = 0.0, focusSwing = 0.0;  ///< turn the plane of sharp focus
    Vec3 planeNormal{0.0, 0.0, 1.0};           ///< any length but 0
    double planeDistance = 0.0;                ///< along the unit normal, from the world's origin
    Vec3 points[3];
    std::vector<Vec3> sharpPoints;             ///< their greatest blur is minimised
    std::optional<double> sharpWithin;         ///< greatest blur of sharpPoints, mm on the film; replaces fStop
    double shiftRight = 0.0, shiftUp = 0.0;    ///< mm
    std::optional<double> fStop;
    int blades = 0;                            ///< 0: round
    double bladesAngle = 0.0;                  ///< counter-clockwise as the camera sees it
    double bladeCurvature = 0.0;               ///< lens radius over edge radius; 0: straight
    double squeeze = 1.0;                      ///< aperture's height over width
    Character character;
    std::shared_ptr<const Prescription> prescription;  ///< scaled lens of glass; null: thin lens
    bool dispersion = false;
    double budget = 0.0;                       ///< mean samples per pixel; 0: the variance rules
    bool denoise = true;
    std::uint32_t sampleSeed = 0;

    /// At most one of these two replaces the focal point; with LensTurn only.
    std::optional<double> filmDistance;  ///< mm along the axis; needs focalLength
    std::optional<double> focusScale;    ///< scene units from film to focus, before the lens turns

    Vec3 focalPoint{0.0, 0.0, 1.0};
    double aperture = 0.0;           ///< twice the lens diameter, scene units; 0: pinhole
    double scale = 1.0;              ///< cube root of the determinant of the camera's transformations
};

/// World axes relative to the lens centre, scene units.
struct Lens
{
    Vec3 axisRight, axisUp, axis;  ///< orthonormal: along `right`, towards `up`, film normal into the scene
    Vec3 normal;                   ///< unit vector t, t.axis > 0
    double focalLength = 0.0;      ///< f
    double filmDistance = 0.0;     ///< s, along the axis
    double diameter = 0.0;         ///< 0: pinhole
    Vec3 focus;                    ///< k of the plane of sharp focus
    Vec3 direction, right, up;     ///< chief ray of (x, y) in [-0.5, 0.5]^2: direction + x right + y up
    double focusMiddle = 0.0, focusRight = 0.0, focusUp = 0.0;  ///< k.direction, k.right, k.up
    Vec3 lensX, lensY;             ///< lens point of aperture coordinates (a, b): a lensX + b lensY
    double millimetre = 0.0;       ///< on the film

    /// @name Aberrations; 0 for an ideal lens.
    /// @{
    bool distorts = false;         ///< one of the next three is not 0
    double distortion2 = 0.0, distortion4 = 0.0;  ///< factors of the tangent's square and fourth power
    double distortionNear = 0.0;   ///< factor of the squared tangent over the axial focus distance; scene units
    double fieldCurvature = 0.0;   ///< c, 1/(scene units): see ray.h
    double lateralColour = 0.0;    ///< size of the red end's image over mid-spectrum's, minus 1
    double axialColour = 0.0;      ///< vergence lost at the red end; 1/(scene units)
    /// @}
};

/// No lens fulfils the statement.
class OpticsError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// Solves statements without sharpWithin; Solve() (solve.h) solves all.
/// @throws OpticsError  a degenerate camera; a lens turned by 90 degrees or more; a focus that no film position or tilt reaches; non-finite
///                      numbers or non-positive lengths
Lens SolveThinLens(const CameraFrame& camera, const Statement& given);

/// Inverse film distance, 1/mm; negative infinity if a thin lens of this focal length, mm, cannot focus as stated.
/// @throws OpticsError  a degenerate camera
double FilmVergence(const CameraFrame& camera, const Statement& given, double focalLength);

/// Sentences about a valid but probably unintended lens.
std::vector<std::string> Warnings(const Lens& lens, const Statement& given);

/// @name Numbers for a photographer.
/// @{

/// Degrees.
double TiltOf(const Lens& lens);
double SwingOf(const Lens& lens);

/// Degrees between the plane of sharp focus and the film.
double FocusAngleOf(const Lens& lens);

/// Distance from the lens centre to the hinge line, f / sin(tilt) (Merklinger); infinite without tilt.
double HingeDistanceOf(const Lens& lens);

/// Distance along the axis to the plane of sharp focus; infinite or negative if not in front.
double AxisFocusOf(const Lens& lens);

/// Depth of field on the axis, for a blur of `pixels` in a frame `width` pixels wide; infinite if nothing is sharp.
struct SharpRange
{
    double near = 0.0, far = 0.0;  ///< scene units from the lens centre
};
SharpRange SharpRangeOf(const Lens& lens, double width, double pixels);
/// @}

/// @name Blur in the picture.
///
/// Blur is the longest diameter of the circle of confusion, pixels: positive before the plane of sharp focus (nearer to the camera),
/// negative behind it. A polygon or bokeh picture counts as the disc around it.
/// @{

/// Per difference of vergences (ray.h), for a frame `width` pixels wide.
double BlurPerVergence(const Lens& lens, double width);

/// @param chief  direction + x right + y up, not normalised
/// @param T      the surface point is T * chief; may be infinite
double BlurDiameter(const Lens& lens, const Vec3& chief, double T, double width);

/// k of the plane k.X = 1. Needs an aperture, and no distortion or field curvature.
Vec3 PlaneOfBlur(const Lens& lens, double pixels, double width);

/// 1/T at which a chief ray meets the given blur; negative behind the lens. Needs an aperture.
double VergenceOfBlur(const Lens& lens, const Vec3& chief, double pixels, double width);
/// @}

}  // namespace tilt_lens

#endif
