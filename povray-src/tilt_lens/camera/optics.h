// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file optics.h
/// From what a scene says about a lens to the lens, the film and the plane of sharp focus.
///
/// Model: an ideal thin lens, tilted about its own centre, which is the camera's location; the film
/// is flat and parallel to the camera's `right` and `up`. The chief rays pass the lens centre unbent,
/// so a tilt moves no image point, and a shift moves the frame over the film.
///
/// With z the camera axis, the film at -s z, t the unit lens normal, f the focal length, the plane of
/// sharp focus is k.X = 1 with
///
///     k = t/f - z/s                                       (X relative to the lens centre)
///
/// which is Scheimpflug's rule and the thin lens equation in one line. Everything here follows from
/// it; nothing is divided by a distance that may vanish. k = 0 would be a plane at infinity.
///
/// Sources: T. Nakane et al., "Simulating tilt-shift lens using distributed ray tracing" (equation 1
/// there is a special case); H. M. Merklinger, "Principles of View Camera Focus" (the hinge rule);
/// A. Kensler, "Tilt-Shift Rendering Using a Thin Lens Model", Ray Tracing Gems II, chapter 31 (same
/// model; the formulas here are derived anew and do not divide where that chapter does).

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

class GlassLens;
class GlassOfColours;
struct Prescription;

/// The perspective camera as POV-Ray holds it after all transformations. World frame, scene units.
struct CameraFrame
{
    Vec3 location;   ///< centre of the lens
    Vec3 direction;  ///< from the lens centre to the middle of the frame
    Vec3 right, up;  ///< the frame's full width and height at the end of `direction`
};

/// What says where the focus lies. Each family excludes the others.
enum class FocusFamily
{
    LensTurn,    ///< `tilt`, `swing`, and the focal point or the film's distance; also the default, both zero
    FocusTurn,   ///< `focus_tilt`, `focus_swing`, and the focal point
    FocalPlane,  ///< `focal_plane`
    FocalPoints, ///< `focal_points`
    SharpPoints  ///< `sharp_points`
};

/// A `tilt_lens` block as it is written: film side in millimetres, angles in degrees, points and
/// planes in world coordinates and scene units.
struct Statement
{
    double filmWidth = 36.0;            ///< mm
    std::optional<double> focalLength;  ///< mm; without it the angle of view fixes the film distance
    double sceneUnit = 1000.0;          ///< mm in one scene unit
    FocusFamily family = FocusFamily::LensTurn;
    double tilt = 0.0, swing = 0.0;            ///< degrees, of the lens
    double focusTilt = 0.0, focusSwing = 0.0;  ///< degrees, of the plane of sharp focus
    Vec3 planeNormal{0.0, 0.0, 1.0};           ///< any length but 0
    double planeDistance = 0.0;                ///< along the unit normal, from the world's origin
    Vec3 points[3];                            ///< on the plane of sharp focus
    std::vector<Vec3> sharpPoints;             ///< to which the plane of sharp focus leaves the least greatest blur
    std::optional<double> sharpWithin;         ///< mm on the film, greatest blur of these: sets the diameter in place of fStop
    double shiftRight = 0.0, shiftUp = 0.0;    ///< mm
    std::optional<double> fStop;               ///< focal length / diameter
    int blades = 0;                            ///< straight edges of the diaphragm; 0: round
    double bladesAngle = 0.0;                  ///< degrees, counter-clockwise as the camera sees it
    double bladeCurvature = 0.0;               ///< radius of the lens over that of the blades' edges; 0: straight
    double squeeze = 1.0;                      ///< height of the aperture over its width; the larger is the diameter
    Character character;                       ///< what a real lens does otherwise than an ideal one
    std::shared_ptr<const Prescription> prescription;  ///< of a lens of glass, at its size; null: none
    bool dispersion = false;                   ///< its indices depend on the wavelength
    bool denoise = true;                       ///< the picture is rebuilt from its pixels (reconstruction.h)
    std::uint32_t sampleSeed = 0;              ///< of the pattern of samples: another one, other noise

    /// Of the family LensTurn, in place of the focal point: where the film stands. At most one of the two.
    std::optional<double> filmDistance;  ///< mm from the lens centre to the film along the axis; with focalLength only
    std::optional<double> focusScale;    ///< scene units from the film to what the lens is focused on while it is not turned

    Vec3 focalPoint{0.0, 0.0, 1.0};  ///< world; from `focal_point`, or `look_at` without one
    double aperture = 0.0;           ///< POV-Ray's number: twice the lens diameter, scene units; 0: none
    double scale = 1.0;              ///< all scalings of the camera: cube root of the determinant
};

/// A lens, its film and its plane of sharp focus, ready to make rays. World frame unless said
/// otherwise, relative to the lens centre, scene units.
struct Lens
{
    Vec3 axisRight, axisUp, axis;  ///< orthonormal: along `right`, towards `up`, film normal into the scene
    Vec3 normal;                   ///< unit lens normal t, t.axis > 0
    double focalLength = 0.0;      ///< f
    double filmDistance = 0.0;     ///< s, along the axis
    double diameter = 0.0;         ///< of the aperture; 0: a pinhole
    Vec3 focus;                    ///< k: the plane of sharp focus is k.X = 1
    Vec3 direction, right, up;     ///< chief ray through (x, y) in [-0.5, 0.5]^2: direction + x right + y up
    double focusMiddle = 0.0, focusRight = 0.0, focusUp = 0.0;  ///< k.direction, k.right, k.up
    Vec3 lensX, lensY;             ///< lens point of aperture coordinates (a, b): a lensX + b lensY; unit disc = lens
    double millimetre = 0.0;       ///< one millimetre of film, in scene units

    /// @name Not those of an ideal lens, for which they are 0.
    /// @{
    bool distorts = false;         ///< the film is mapped (film_point.h), by these three factors
    double distortion2 = 0.0, distortion4 = 0.0;  ///< of the angle's tangent, squared and to the fourth
    double distortionNear = 0.0;   ///< of the squared tangent over the distance, along the lens's axis, of the focus; scene units
    double fieldCurvature = 0.0;   ///< c: the surface of sharp focus is k.X + c a^2/b = 1, X being a across the lens's axis
                                   ///< and b along it; 1/(scene units)
    double lateralColour = 0.0;    ///< by which the image of the red end is larger than that of the middle of the spectrum, relative
    double axialColour = 0.0;      ///< vergence that the film sees less of there; 1/(scene units)
    std::shared_ptr<const GlassLens> glass;  ///< what rays go through in place of the ideal lens (glass_camera.h), with its stop set
    double groups = 0.0;           ///< where the groups of glass stand that focus it (inner_focus.h); 0: as for infinity
    std::shared_ptr<const GlassOfColours> glassOfColours;  ///< the same for each part of the spectrum; null: one wavelength
    /// @}
};

/// A statement that no lens can follow. what() says what is wrong, the value found, what is allowed
/// and what to do.
class OpticsError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// Solves a statement for a camera.
/// @throws OpticsError  a degenerate camera; a lens turned 90 degrees or more; a plane of focus
///                      through the lens centre or behind the lens; a lens turned backward; a focal
///                      length that cannot reach the plane or whose focus is nearer than itself; a focus scale that
///                      no place of the film fits; numbers that are not finite, lengths that are not positive; glass that is not so
///                      wide or ends behind the film.
Lens Solve(const CameraFrame& camera, const Statement& given);

/// Sensible pictures that are probably not what was meant: a lens tilt past 15 degrees, a tilt
/// without an aperture, a lens whose rim passes through the film. One sentence or two each.
std::vector<std::string> Warnings(const Lens& lens, const Statement& given);

/// @name Numbers a photographer checks.
/// @{

/// Lens tilt and swing in degrees that make this lens normal, signs as in `tilt` and `swing`.
double TiltOf(const Lens& lens);
double SwingOf(const Lens& lens);

/// Angle in degrees between the plane of sharp focus and the film.
double FocusAngleOf(const Lens& lens);

/// Distance J of the hinge line from the lens centre, in the plane parallel to the film through that
/// centre: J = f / sin(tilt) (Merklinger). Infinite for a lens parallel to the film.
double HingeDistanceOf(const Lens& lens);

/// Where the plane of sharp focus crosses the axis: distance from the lens centre. Infinite or
/// negative where it does not cross in front.
double AxisFocusOf(const Lens& lens);

/// Near and far limit of sharpness on the axis, for a blur of `pixels` in a frame `width` pixels wide.
/// far is infinite past the hyperfocal distance; both are infinite where nothing on the axis is sharp.
struct SharpRange
{
    double near = 0.0, far = 0.0;  ///< scene units from the lens centre
};
SharpRange SharpRangeOf(const Lens& lens, double width, double pixels);
/// @}

/// @name Blur in the picture.
///
/// The circle of confusion is the patch of film that light from one point of a surface reaches through
/// the whole lens. On the film it is the outline of the lens times the vergence difference 1/T - w
/// (ray.h): an ellipse for a tilted lens, whose longest diameter is the lens's own, since one diameter
/// of every lens lies parallel to the film; distortion stretches it further. That longest diameter, in pixels, is what "blur" means
/// wherever this program gives it as a number. A polygon or a bokeh picture counts as the disc around it.
/// Positive before the plane of sharp focus (nearer to the camera), negative behind it, 0 on it and
/// everywhere for a pinhole.
/// @{

/// Diameter of the circle of confusion, in pixels, per unit of vergence difference, for a frame `width`
/// pixels wide.
double BlurPerVergence(const Lens& lens, double width);

/// Signed diameter of the circle of confusion, in pixels, of the surface point T * chief; finite for T
/// infinite.
/// @param chief  direction + x right + y up, not normalised
double BlurDiameter(const Lens& lens, const Vec3& chief, double T, double width);

/// The surface of all points whose signed blur is `pixels`, as k of the plane k.X = 1 about the lens
/// centre: the plane of sharp focus for 0. All of them meet in the hinge line, as the covers of a book
/// do; for a lens parallel to the film they are parallel planes. Of the ideal
/// lens, without distortion and field curvature; not for a pinhole.
Vec3 PlaneOfBlur(const Lens& lens, double pixels, double width);

/// Inverse of the parameter T at which a chief ray meets the surface of that blur, of any lens but a pinhole; negative where it
/// meets the surface behind the lens.
double VergenceOfBlur(const Lens& lens, const Vec3& chief, double pixels, double width);
/// @}

} // namespace tilt_lens

#endif
