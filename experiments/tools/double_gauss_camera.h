// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file double_gauss_camera.h
/// The camera of scenes/paper/box_camera.inc with a tilted lens of glass, or a thin lens with some of its properties.

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
    double moved = 0.0;  ///< mm of the first element in its file
};

enum class Model
{
    Thin,        ///< chief rays unbent through one point, one plane of sharp focus, a round pupil
    Distortion,  ///< chief rays bent as by the glass
    Field,       ///< and focused as by the glass: its curved
                 ///< field and astigmatism
    Pupil,       ///< and from where they leave the glass: the pupil's place, shape and rims
    Glass        ///< and each ray in its own direction: spherical aberration, coma and the rest
};
constexpr int kModels = 5;

struct Character
{
    double distortion1, distortion2;  ///< of the squared distance from the lens's axis, in half widths of the film, and its square
    double distortionNear;            ///< by which the first is greater at Nearness() 1
    double fieldCurvature;            ///< mm by which the image lies before the film half a film's width beside the axis
    double left, leftWithoutNear;     ///< root mean square pixels by which chief rays miss those of the glass
};

class GlassCamera
{
  public:
    /// @param thinOnly nothing is traced; Model::Thin at any f-number
    explicit GlassCamera(const Setting& setting, bool thinOnly = false);

    const GlassLens& Glass() const { return mGlass; }

    /// From a film point (pixels) through the unit circle about the exit pupil; world, scene units.
    std::optional<Ray> Shoot(Model model, double x, double y, double a, double b) const;

    /// By model, through one point of the stop; none where the glass blocks.
    std::optional<std::array<Ray, kModels>> ShootAll(double x, double y, double a, double b) const;

    bool Vignetted(double x, double y, double a, double b) const;

    /// Least squares over the frame: chief rays, then mean focus (without astigmatism).
    Character Fitted() const;

    /// An ideal lens, the stop points of ShootAll().
    std::optional<Ray> ShootCharacter(const Character& character, double x, double y, double a, double b) const;

    /// Along the camera's axis, scene units.
    double Depth(const Vector& point) const;

    std::array<double, 2> PixelAt(const Ray& ray, double depth) const;

  private:
    /// Along the lens's axis, for an ideal lens. `chief`: camera frame, 1 along the camera's axis.
    double Nearness(const Vector& chief) const;

    struct Distortion
    {
        std::array<double, 3> factors;  ///< of the squared tangent, its square, and of the squared tangent by Nearness()
        double left;                    ///< root mean square residual, pixels
    };
    Distortion FittedDistortion(bool near) const;

    /// First order in the pupil: slopes against the axis at (x, y) in H's plane.
    struct Bundle
    {
        /// In H, change with x, with y.
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

} // namespace paper

#endif
