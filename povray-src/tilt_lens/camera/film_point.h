// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file film_point.h
/// Film points, and their images under distortion.
///
/// Distortion maps the film onto itself about the lens's axis: a point of the picture shows the content of another point of an ideal lens's
/// picture. For a turned lens the axis turns along, as if the picture were first formed on a film at right angles to it.
/// With r the tangent of a chief ray's angle to the axis,
///
///     r_ideal = r_picture (1 + K r_picture^2 + K2 r_picture^4)       (r in units of half the film's width, s at the film's distance)
///
/// The entrance pupil of a real lens moves with the angle, which shifts rays towards near points more than rays towards far ones.
/// Therefore K = K1 + NEAR f/D, D being the distance of the focus along the lens's axis; for a turned lens it varies over the picture. 1/D
/// = k.chief/(t.chief) is linear along each line through the axis.
///
/// The ideal point is a polynomial of the picture's point, so that each ray computes it directly; the inverse is its root. The plane of
/// sharp focus, blur and rays through the lens are those of the ideal point.
///
/// Source: D. C. Brown, "Close-Range Camera Calibration", Photogrammetric Engineering 37(8), 1971, for the polynomial and for distortion
/// that is linear in 1/D.

#ifndef TILT_LENS_FILM_POINT_H
#define TILT_LENS_FILM_POINT_H

#include <optional>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// A point of the picture, upright: 0 is the centre, +-0.5 are the edges of the frame.
struct FilmPoint
{
    double x, y;  ///< right, up
};

/// A vector in each lane of registers, or once; bit for bit, zeros with their signs included.
template<class Number>
TILT_LENS_INLINED VecOf<Number> Broadcast(const Vec3& v)
{
    const Number zero{};
    return {v.x - zero, v.y - zero, v.z - zero};
}

/// Chief ray of the ideal lens, not normalised: it ends in the plane of the frame given by `direction`, `right` and `up`.
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

/// @param column, row    pixels from the upper left corner; the centre of a pixel is at its number + 0.5
/// @param width, height  of the whole picture, in pixels
inline FilmPoint FilmPointAt(double column, double row, double width, double height)
{
    return {column / width - 0.5, 0.5 - row / height};
}

/// The film point whose chief ray through an ideal lens has this direction; none if it leads away from the scene.
/// @param along  of any length
std::optional<FilmPoint> IdealFilmPointOf(const Lens& lens, const Vec3& along);

/// The ideal lens's film point that this lens shows at a point of its picture. For a lens with distortion or lateral colour.
/// @param magnified  relative size of this colour's image
FilmPoint IdealFilmPoint(const Lens& lens, const FilmPoint& picture, double magnified = 1.0);

/// The inverse for any lens: where the picture shows a film point of the ideal lens. None if it lies beyond the fold of a distortion with
/// negative K1 or K2.
std::optional<FilmPoint> PictureFilmPoint(const Lens& lens, const FilmPoint& ideal);

/// Largest stretching of the ideal picture by distortion, over all directions at a point.
/// @param picture  film point of the picture
double PictureStretch(const Lens& lens, const FilmPoint& picture);

/// Squared tangent of the angle to the lens's axis at which the picture folds back: beyond it, the picture would repeat, mirrored.
/// Infinite if it never folds.
/// @param cube  coefficient of the third power of the tangent, along the direction in question
double FoldOf(double distortion2, double distortion4, double cube = 0.0);

}  // namespace tilt_lens

#endif
