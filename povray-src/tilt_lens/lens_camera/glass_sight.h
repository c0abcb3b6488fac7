// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file glass_sight.h
/// How a lens of glass shows a point of the scene: which film points see it, and through which points of the pupil.
///
/// The pupil is divided into cells of equal area. Traced rays give the film points of few corners, and interpolation those of the others.
/// Aberrations may fold the picture, so a film point may see the target through cells far from each other.

#ifndef TILT_LENS_GLASS_SIGHT_H
#define TILT_LENS_GLASS_SIGHT_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tilt_lens/lens_camera/glass_camera.h"

namespace tilt_lens
{

/// Film points.
struct FilmBox
{
    double left, right, bottom, top;
};

/// Immutable, thread-safe.
class GlassSight
{
  public:
    static constexpr int kTraced = 16;  ///< traced cells in a row or column
    static constexpr int kFine = 2;     ///< cells of a traced one in a row or column
    static constexpr int kSide = kTraced * kFine;
    static constexpr int kCount = kSide * kSide;

    /// Box around the film points that see the target through a part of the pupil.
    struct Image
    {
        float left = HUGE_VALF, right = -HUGE_VALF, bottom = HUGE_VALF, top = -HUGE_VALF;

        void Include(const Image& other)
        {
            left = std::min(left, other.left), right = std::max(right, other.right);
            bottom = std::min(bottom, other.bottom), top = std::max(top, other.top);
        }
        /// Not if it is NaN.
        void Include(const FilmPoint& film) { Include({float(film.x), float(film.x), float(film.y), float(film.y)}); }
        bool Meets(const FilmBox& box) const
        {
            return (left <= box.right) & (right >= box.left) & (bottom <= box.top) & (top >= box.bottom);
        }
    };

    /// Ascending. Numbers are in Z-order, so each square of 4, 16, 64 or 256 cells has successive ones.
    using Cells = std::vector<std::uint16_t>;

    /// @param target  relative to the lens centre, world axes, scene units
    GlassSight(const GlassCamera& camera, const Vec3& target);

    /// Thirds of the spectrum, blue to red; one if the camera has no colours.
    std::size_t Thirds() const { return trees.size(); }

    /// Around all film points that see the target.
    FilmBox Box() const;

    /// Cells through which film points in the box see the target.
    Cells CellsOf(const FilmBox& box, std::size_t third) const;
    bool Shows(std::uint16_t cell, const FilmBox& box, std::size_t third) const { return trees[third][kFirstCell + cell].Meets(box); }

    /// @param u, v  place in the cell, in [0, 1)
    static AperturePoint PointOf(std::uint16_t cell, double u, double v);
    static std::uint16_t CellAt(const AperturePoint& point);

  private:
    static constexpr int kFirstCell = (kCount - 1) / 3;

    /// Node 0 is the whole pupil, 4 n + 1 to 4 n + 4 are the quarters of node n, and the last ones are the cells.
    using Tree = std::array<Image, kFirstCell + kCount>;

    std::vector<Tree> trees;  ///< by thirds

    void Collect(const FilmBox& box, std::size_t third, int node, Cells& cells) const;
};

}  // namespace tilt_lens

#endif
