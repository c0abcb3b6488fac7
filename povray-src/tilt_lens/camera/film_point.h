// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file film_point.h
/// Film points, and their images under distortion.
///
/// Distortion maps the film onto itself about the lens's axis: a picture point shows another point of an ideal lens's picture. For a
/// turned lens the axis turns along. With r the tangent of a chief ray's angle to the axis,
///
///     r_ideal = r_picture (1 + K r_picture^2 + K2 r_picture^4)       (r in units of half the film's width, s at the film's distance).
///
/// A real entrance pupil moves with the angle, which shifts rays towards near points more. Therefore K = K1 + NEAR f/D, D being the focus
/// distance along the lens's axis: 1/D = k.chief/(t.chief) is linear along each line through the axis.
///
/// Plane of sharp focus, blur and rays are those of the ideal point, which each ray computes; the inverse is the polynomial's root.
///
/// Source: D. C. Brown, "Close-Range Camera Calibration", Photogrammetric Engineering 37(8), 1971, for the polynomial and distortion
/// linear in 1/D.

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

/// A vector in each lane of registers, or once; bit for bit, with signs of zeros.
template<class Number>
TILT_LENS_INLINED VecOf<Number> Broadcast(const Vec3& v)
{
    const Number zero{};
    return {v.x - zero, v.y - zero, v.z - zero};
}

/// Ideal lens's chief ray, not normalised: ends in the frame's plane of `direction`, `right` and `up`.
/// @param x, y  see FilmPoint; numbers, or registers of them
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

/// Film point of the ideal lens's chief ray; none if it leads away from the scene.
/// @param along  of any length
std::optional<FilmPoint> IdealFilmPointOf(const Lens& lens, const Vec3& along);

/// The ideal lens's film point shown at a picture point, by distortion or lateral colour.
/// @param magnified  relative size of this colour's image
FilmPoint IdealFilmPoint(const Lens& lens, const FilmPoint& picture, double magnified = 1.0);

/// The inverse for any lens. None beyond the fold of a distortion with negative K1 or K2.
std::optional<FilmPoint> PictureFilmPoint(const Lens& lens, const FilmPoint& ideal);

/// Largest stretching of the ideal picture by distortion, over all directions.
/// @param picture  film point of the picture
double PictureStretch(const Lens& lens, const FilmPoint& picture);

/// Squared tangent of the angle to the lens's axis at which the picture folds back, to repeat mirrored; infinite: never.
/// @param cube  coefficient of the tangent's third power along the direction in question
double FoldOf(double distortion2, double distortion4, double cube = 0.0);

} // namespace tilt_lens

#endif
