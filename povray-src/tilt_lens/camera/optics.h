// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file optics.h
/// Solves a `tilt_lens` statement for the lens, the film and the plane of sharp focus.
///
/// The folder camera/ answers: where does the ray of a film point and a lens point go? It holds the thin lens with aberrations and
/// vignetting, the aperture's shape, blur, and focus aids. It knows neither lenses of glass nor pixels' samples nor POV-Ray.
///
/// Model (docs/optics.md): a thin lens, tilted about its centre, the camera's location; a flat film parallel to `right` and `up`. With z
/// the camera axis, the film at -s z, t the unit lens normal and f the focal length, the plane of sharp focus is k.X = 1 with
///
///     k = t/f - z/s                                       (X relative to the lens centre).
///
/// All formulas follow from it and divide by no distance that may vanish. k = 0 is a plane at infinity.
///
/// Sources: T. Nakane et al., "Simulating tilt-shift lens using distributed ray tracing" (equation 1 there is a special case); H. M.
/// Merklinger, "Principles of View Camera Focus" (the hinge rule); A. Kensler, "Tilt-Shift Rendering Using a Thin Lens Model", Ray
/// Tracing Gems II, chapter 31 (same model; these formulas avoid its divisions).

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

/// POV-Ray's perspective camera after all transformations. World frame, scene units.
struct CameraFrame
{
    Vec3 location;   ///< lens centre
    Vec3 direction;  ///< lens centre to frame centre
    Vec3 right, up;  ///< full width and height of the frame at the end of `direction`
};

enum class FocusFamily
{
    LensTurn,    ///< `tilt`, `swing`, and focal point or film distance; default: neither turn
    FocusTurn,
    FocalPlane,
    FocalPoints,
    SharpPoints
};

/// A `tilt_lens` block as written: film in mm, angles in degrees; points and planes in world coordinates, scene units.
struct Statement
{
    double filmWidth = 36.0;            ///< mm
    std::optional<double> focalLength;  ///< mm; absent: the angle of view gives the film distance
    double sceneUnit = 1000.0;          ///< mm per scene unit
    FocusFamily family = FocusFamily::LensTurn;
    double tilt = 0.0, swing = 0.0;            ///< of the lens
    double focusTilt = 0.0, focusSwing = 0.0;  ///< of the plane of sharp focus
    Vec3 planeNormal{0.0, 0.0, 1.0};           ///< any length but 0
    double planeDistance = 0.0;                ///< along the unit normal, from the world's origin
    Vec3 points[3];                            ///< on the plane of sharp focus
    std::vector<Vec3> sharpPoints;             ///< given the least greatest blur by the plane of sharp focus
    std::optional<double> sharpWithin;         ///< greatest blur of these, mm on the film; replaces fStop
    double shiftRight = 0.0, shiftUp = 0.0;    ///< mm
    std::optional<double> fStop;
    int blades = 0;                            ///< 0: round
    double bladesAngle = 0.0;                  ///< degrees, counter-clockwise from the camera
    double bladeCurvature = 0.0;               ///< lens radius over edge radius; 0: straight
    double squeeze = 1.0;                      ///< aperture's height over width; the larger is the diameter
    Character character;
    std::shared_ptr<const Prescription> prescription;  ///< scaled lens of glass (solve.h); null: thin lens
    bool dispersion = false;
    double budget = 0.0;                       ///< mean samples of a pixel, replaces the variance (sampling/budget.h); 0: none
    bool denoise = true;                       ///< reconstruct the picture (reconstruction.h)
    std::uint32_t sampleSeed = 0;

    /// Position of the film, in place of the focal point. LensTurn only; at most one of the two.
    std::optional<double> filmDistance;  ///< mm along the axis; with focalLength only
    std::optional<double> focusScale;    ///< scene units from film to focus, before the lens turns

    Vec3 focalPoint{0.0, 0.0, 1.0};  ///< world; `focal_point`, else `look_at`
    double aperture = 0.0;           ///< POV-Ray's number: twice the lens diameter, scene units; 0: pinhole
    double scale = 1.0;              ///< product of the camera's scalings: cube root of the determinant
};

/// A solved thin lens with film and plane of sharp focus. World axes relative to the lens centre, scene units, unless noted.
struct Lens
{
    Vec3 axisRight, axisUp, axis;  ///< orthonormal: along `right`, towards `up`, film normal into the scene
    Vec3 normal;                   ///< unit lens normal t, t.axis > 0
    double focalLength = 0.0;      ///< f
    double filmDistance = 0.0;     ///< s, along the axis
    double diameter = 0.0;         ///< aperture; 0: pinhole
    Vec3 focus;                    ///< k: the plane of sharp focus is k.X = 1
    Vec3 direction, right, up;     ///< chief ray through (x, y) in [-0.5, 0.5]^2: direction + x right + y up
    double focusMiddle = 0.0, focusRight = 0.0, focusUp = 0.0;  ///< k.direction, k.right, k.up
    Vec3 lensX, lensY;             ///< lens point of aperture coordinates (a, b): a lensX + b lensY; unit disc = lens
    double millimetre = 0.0;       ///< of film, scene units

    /// @name Aberrations; 0 for an ideal lens.
    /// @{
    bool distorts = false;         ///< by the next three (film_point.h)
    double distortion2 = 0.0, distortion4 = 0.0;  ///< of the tangent's square and fourth power
    double distortionNear = 0.0;   ///< of the squared tangent over the focus's axial distance; scene units
    double fieldCurvature = 0.0;   ///< c: the surface of sharp focus is k.X + c a^2/b = 1, X being a across the lens's axis
                                   ///< and b along it; 1/(scene units)
    double lateralColour = 0.0;    ///< size of the red end's image over mid-spectrum's, minus 1
    double axialColour = 0.0;      ///< vergence lost at the red end; 1/(scene units)
    /// @}
};

/// No lens fulfils the statement. The text names fault, value found, values allowed, and remedy.
class OpticsError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// A thin lens of the statement's focal length and f-number; Solve() (solve.h) solves every statement.
/// @param given  without a blur limit (`sharpWithin`), which Solve() turns into an f-number
/// @throws OpticsError  a degenerate camera; a lens turned by 90 degrees or more, or backward; a plane of focus through or behind the
///                      lens centre; a focal length that cannot reach the plane, or a focus nearer than it; a focus scale that no film
///                      position fits; non-finite numbers or non-positive lengths
Lens SolveThinLens(const CameraFrame& camera, const Statement& given);

/// 1/mm: inverse film distance for a thin lens of this focal length (mm); negative infinity if it cannot focus as stated.
/// @throws OpticsError  a degenerate camera
double FilmVergence(const CameraFrame& camera, const Statement& given, double focalLength);

/// Valid but probably unintended: a lens tilt past 15 degrees, a tilt without an aperture, a lens whose rim passes through the film. One
/// or two sentences each.
std::vector<std::string> Warnings(const Lens& lens, const Statement& given);

/// @name Numbers for a photographer.
/// @{

/// Degrees that yield this lens normal, signed as `tilt` and `swing`.
double TiltOf(const Lens& lens);
double SwingOf(const Lens& lens);

/// Degrees between the plane of sharp focus and the film.
double FocusAngleOf(const Lens& lens);

/// Distance J from the lens centre to the hinge line, in the plane parallel to the film: J = f / sin(tilt) (Merklinger). Infinite for a
/// lens parallel to the film.
double HingeDistanceOf(const Lens& lens);

/// Along the axis to the plane of sharp focus. Infinite or negative if it does not cross in front.
double AxisFocusOf(const Lens& lens);

/// Depth of field on the axis, for a blur of `pixels` in a frame `width` pixels wide. far is infinite past the hyperfocal distance; both
/// are if nothing on the axis is sharp.
struct SharpRange
{
    double near = 0.0, far = 0.0;  ///< scene units from the lens centre
};
SharpRange SharpRangeOf(const Lens& lens, double width, double pixels);
/// @}

/// @name Blur in the picture.
///
/// The circle of confusion, the film patch that one surface point's light reaches, is the lens outline times the difference of vergences
/// (ray.h). Its longest diameter is the lens's own, since one diameter of every lens is parallel to the film; distortion stretches it
/// further. "Blur" is this diameter in pixels, throughout the program. A polygon or bokeh picture counts as the disc around it. Positive
/// before the plane of sharp focus (nearer to the camera), negative behind it, 0 on it and for a pinhole.
/// @{

/// Blur per vergence difference, for a frame `width` pixels wide.
double BlurPerVergence(const Lens& lens, double width);

/// Blur of the surface point T * chief; finite for infinite T.
/// @param chief  direction + x right + y up, not normalised
double BlurDiameter(const Lens& lens, const Vec3& chief, double T, double width);

/// k of the plane k.X = 1 with the given blur; 0: the plane of sharp focus. All such planes meet in the hinge line, or are parallel for a
/// lens parallel to the film. Not with distortion or field curvature; no pinholes.
Vec3 PlaneOfBlur(const Lens& lens, double pixels, double width);

/// 1/T at which a chief ray meets the given blur; negative behind the lens. No pinholes.
double VergenceOfBlur(const Lens& lens, const Vec3& chief, double pixels, double width);
/// @}

} // namespace tilt_lens

#endif
