// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file film_point.h
/// Points of the film, and where a lens with distortion shows them.
///
/// Distortion is a map of the film onto itself, about the lens's axis: a point of the picture shows what an ideal lens would show
/// at another point. For a turned lens it turns along, as if the picture were first made on a film at right angles to the axis.
/// With r the tangent of a chief ray's angle to the axis,
///
///     r_ideal = r_picture (1 + K r_picture^2 + K2 r_picture^4)       (r in units of half the film's width, s at the film's distance)
///
/// A real lens's pupil does not stay in its place when it is seen from aside, which shifts a ray towards a near point more than one
/// towards a far one. Therefore K = K1 + NEAR f/D, D being the distance along the lens's axis to what the picture's point is focused on:
/// for a turned lens it changes over the picture. With w = k.chief/(t.chief) for 1/D it changes evenly along each line through the axis.
///
/// The ideal point is a polynomial of the picture's, so that each ray finds it directly; the way back is its root.
/// Everything else (the plane of sharp focus, blur, rays through the lens) is that of the ideal point.
///
/// Source of the polynomial, and of distortion that is linear in 1/D: D. C. Brown, "Close-Range Camera Calibration",
/// Photogrammetric Engineering 37(8), 1971.

#ifndef TILT_LENS_FILM_POINT_H
#define TILT_LENS_FILM_POINT_H

#include <optional>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// A point of the film as the picture shows it, upright: 0 is the middle, +-0.5 the edges of the frame.
struct FilmPoint
{
    double x, y;  ///< to the right, upward
};

/// The chief ray through an ideal lens, not normalised: it ends where `direction`, `right` and `up` of the lens do.
inline Vec3 IdealChiefRay(const Lens& lens, const FilmPoint& ideal)
{
    return lens.direction + ideal.x * lens.right + ideal.y * lens.up;
}

/// Calls use(corner) for the four corners of the frame.
template <typename Use>
void ForCorners(const Use& use)
{
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5})
            use(FilmPoint{x, y});
}

/// @param column, row    in pixels from the upper left corner of the picture; the middle of a pixel is at its number + 0.5
/// @param width, height  of the whole picture, in pixels
inline FilmPoint FilmPointAt(double column, double row, double width, double height)
{
    return {column / width - 0.5, 0.5 - row / height};
}

/// The film point whose chief ray leads there through an ideal lens. Nothing for a direction away from the scene.
/// @param along  direction, of any length
std::optional<FilmPoint> IdealFilmPointOf(const Lens& lens, const Vec3& along);

/// Where an ideal lens would show what this one shows at a point of the picture. For a lens with distortion or lateral colour.
/// @param magnified  how much larger than usual this colour's image is
FilmPoint IdealFilmPoint(const Lens& lens, const FilmPoint& picture, double magnified = 1.0);

/// The inverse: where this lens shows what an ideal one would show at a point. Nothing where it shows it nowhere, because the
/// picture folds back before it (a negative K1 or K2). For any lens.
std::optional<FilmPoint> PictureFilmPoint(const Lens& lens, const FilmPoint& ideal);

/// By how much distortion stretches what an ideal lens shows there, in the direction in which it does so most.
/// @param picture  film point of the picture
double PictureStretch(const Lens& lens, const FilmPoint& picture);

/// Squared tangent of the angle to the lens's axis at which the picture folds back: farther out it would show again, mirrored,
/// what is nearer. Infinite where it never does.
/// @param cube  of the third power of the tangent, along the direction that is asked about
double FoldOf(double distortion2, double distortion4, double cube = 0.0);

} // namespace tilt_lens

#endif
