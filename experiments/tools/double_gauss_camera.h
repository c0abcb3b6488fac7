// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file double_gauss_camera.h
/// The camera of scenes/paper/box_camera.inc with a lens of glass, tilted as a whole, or with an
/// ideal thin lens that has been given some of the glass's properties: each model has one more, so
/// that the difference of two pictures is what that property does.

#ifndef PAPER_DOUBLE_GAUSS_CAMERA_H
#define PAPER_DOUBLE_GAUSS_CAMERA_H

#include <array>
#include <optional>
#include <vector>

#include "double_gauss.h"

namespace paper
{

struct Setting
{
    int width = 240, height = 160;  ///< pixels of a film 36 mm wide
    double focalLength = 50.0, fStop = 2.8, tilt = 0.0, filmDistance = 0.0, sceneUnit = 10.0;
    double moved = 0.0;  ///< of the lens's first element, mm of its file
};

/// From the ideal lens to the glass.
enum class Model
{
    Thin,        ///< chief rays through one point unbent, one plane of sharp focus, a round pupil
    Distortion,  ///< chief rays bent as the glass bends them
    Field,       ///< and the rays of a film point focused where the glass focuses them: its curved
                 ///< field and astigmatism
    Pupil,       ///< and coming from where they leave the glass: the pupil's place, shape and rims
    Glass        ///< and each ray in its own direction: spherical aberration, coma and the rest
};
constexpr int kModels = 5;

/// The numbers of `tilt_lens` fitted to this lens.
struct Character
{
    double distortion1, distortion2;  ///< of the squared distance from the lens's axis, in half widths of the film, and its square
    double distortionNear;            ///< by which the first is greater at Nearness() 1
    double fieldCurvature;            ///< mm by which the image lies before the film half a film's width beside the axis
    double left, leftWithoutNear;     ///< pixels by which chief rays miss those of the glass: root mean square over the frame
};

class GlassCamera
{
  public:
    /// @param thinOnly  for Model::Thin alone, at any f-number: nothing is traced through the glass
    explicit GlassCamera(const Setting& setting, bool thinOnly = false);

    const GlassLens& Glass() const { return mGlass; }

    /// The ray of a film point (pixels) and a point in the unit circle about the exit pupil, part of which the stop
    /// covers; world, scene units.
    std::optional<Ray> Shoot(Model model, double x, double y, double a, double b) const;

    /// The ray of each model through the same point of the stop; nothing where the glass lets none pass. World, scene
    /// units.
    std::optional<std::array<Ray, kModels>> ShootAll(double x, double y, double a, double b) const;

    /// True if the ray passes the stop; a rim may still end it.
    bool Vignetted(double x, double y, double a, double b) const;

    /// By least squares over the frame: its chief rays, then the mean focus of its rays (astigmatism is left out).
    Character Fitted() const;

    /// The ray of an ideal lens with these numbers, through the same point of the stop as ShootAll(). World, scene
    /// units.
    std::optional<Ray> ShootCharacter(const Character& character, double x, double y, double a, double b) const;

    /// Along the camera's axis, scene units.
    double Depth(const Vector& point) const;

    /// Pixel where a pinhole in the lens centre shows the point of a ray at a depth.
    std::array<double, 2> PixelAt(const Ray& ray, double depth) const;

  private:
    /// Focal length over the distance, along the lens's axis, of the focus of an ideal lens for a film point.
    /// @param chief of the film point, camera frame, 1 along the camera's axis
    double Nearness(const Vector& chief) const;

    struct Distortion
    {
        std::array<double, 3> factors;  ///< of the squared tangent, its square, and of the squared tangent by Nearness()
        double left;                    ///< root mean square residual, pixels
    };
    Distortion FittedDistortion(bool near) const;

    /// The rays of one film point behind the glass, to first order in the pupil: slopes against the lens's axis where
    /// a ray crosses H's plane at (x, y).
    struct Bundle
    {
        /// For each of the two slopes: value in H, change with x, and with y.
        std::array<double, 6> slopes{};

        Vector Direction(double x, double y) const;
    };

    Vector Chief(double x, double y) const;
    Vector FromLens(const Vector& v) const;
    Vector ToLens(const Vector& v) const;
    Ray ToWorld(const Vector& origin, const Vector& direction) const;
    Ray FilmRay(double x, double y, double a, double b) const;
    Ray ThinRay(const Vector& chief, double a, double b) const;
    Ray FieldRay(const Bundle& bundle, double a, double b) const;
    Ray Through(Model model, double x, double y, const Passage& passage) const;
    Ray PupilRay(const Bundle& bundle, const Ray& out) const;
    Bundle FitBundle(double x, double y) const;
    Bundle BundleAt(double x, double y) const;

    Setting mSetting;
    GlassLens mGlass;
    const Vector mLocation{0.0, 32.0, -50.0};
    Vector mAxis, mRight, mUp;   ///< of the camera, world
    Vector mLensUp, mLensAxis;   ///< camera frame
    std::vector<Bundle> mNodes;  ///< at the corners of the pixels
};

}  // namespace paper

#endif
