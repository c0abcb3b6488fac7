// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file film_point.h
/// Film points, and their images under distortion (docs/optics.md, "Away from the ideal lens").
///
/// A picture point shows another point of an ideal lens's picture. With r the tangent of a chief ray's angle to the lens's axis,
///
///     r_ideal = r_picture (1 + K r_picture^2 + K2 r_picture^4)       (r in units of half the film's width, s at the film's distance)
///
/// and K = K1 + NEAR f/D, D being the axial focus distance (D. C. Brown, "Close-Range Camera Calibration", Photogrammetric Engineering
/// 37(8), 1971). Focus, blur and rays are those of the ideal point.

#ifndef TILT_LENS_FILM_POINT_H
#define TILT_LENS_FILM_POINT_H

#include <optional>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// Upright: 0 is the centre, +-0.5 are the frame's edges.
struct FilmPoint
{
    double x, y;
};

template<class Number>
TILT_LENS_INLINED VecOf<Number> Broadcast(const Vec3& v)
{
    const Number zero{};
    return {v.x - zero, v.y - zero, v.z - zero};
}

/// Ideal lens's chief ray, not normalised.
template<class Number>
TILT_LENS_INLINED VecOf<Number> IdealChiefRay(const Lens& lens, const Number& x, const Number& y)
{
    return Broadcast<Number>(lens.direction) + x * Broadcast<Number>(lens.right) + y * Broadcast<Number>(lens.up);
}

inline Vec3 IdealChiefRay(const Lens& lens, const FilmPoint& ideal)
{
    return IdealChiefRay(lens, ideal.x, ideal.y);
}

template<typename Use>
void ForCorners(const Use& use)
{
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            use(FilmPoint{x, y});
}

/// @param column, row    pixels from the upper left corner; pixel centres are at + 0.5
/// @param width, height  whole picture, pixels
inline FilmPoint FilmPointAt(double column, double row, double width, double height)
{
    return {column / width - 0.5, 0.5 - row / height};
}

/// Inverse of IdealChiefRay(), for any length; none if the ray leads away from the scene.
std::optional<FilmPoint> IdealFilmPointOf(const Lens& lens, const Vec3& along);

/// @param magnified  relative size of this colour's image
FilmPoint IdealFilmPoint(const Lens& lens, const FilmPoint& picture, double magnified = 1.0);

/// The inverse, without lateral colour. None beyond the fold.
std::optional<FilmPoint> PictureFilmPoint(const Lens& lens, const FilmPoint& ideal);

/// Largest magnification by distortion, over all directions.
double PictureStretch(const Lens& lens, const FilmPoint& picture);

/// Squared tangent of the angle to the lens's axis at which the picture folds back; infinite: never.
/// @param cube  coefficient of the tangent's third power
double FoldOf(double distortion2, double distortion4, double cube = 0.0);

} // namespace tilt_lens

#endif
