// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file aperture_picture.h
/// The tables behind Aperture::Picture (aperture.h): how bright the opening is at each place, and points drawn from that.

#ifndef TILT_LENS_APERTURE_PICTURE_H
#define TILT_LENS_APERTURE_PICTURE_H

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "tilt_lens/camera/aperture.h"

namespace tilt_lens
{

/// A piecewise constant distribution over [0, 1] in equal cells, inverted in constant expected time
/// with H.-C. Chen and Y. Asau's index table (1974).
class CellDistribution
{
  public:
    static constexpr int cells = 256;

    /// @return the total weight; 0 leaves a distribution that must not be sampled
    double Build(const double* weight);

    struct Place
    {
        int cell;
        double position;  ///< in [0, 1]
    };

    /// The value below which lies the part u, in [0, 1), of the weight.
    Place Invert(double u) const;

    /// Density at a position, 1 being that of an even distribution.
    double Density(double position) const;

  private:
    /// Part of the weight below each cell. Single precision keeps a picture within the processor's
    /// second cache; a cell with less than 1e-7 of its column is lost in black anyway.
    std::array<float, cells + 1> bound;
    std::array<std::uint8_t, cells> first;  ///< cell where the search for i/cells begins
};

/// Brightness over the square around the lens, as Aperture::Picture describes it.
class AperturePicture
{
  public:
    /// @throws std::invalid_argument  no place has a positive weight
    explicit AperturePicture(const std::function<double(double u, double v)>& weight);

    /// The point of uniform u, v in [0, 1).
    AperturePoint Map(double u, double v) const;

    /// Of such points, per area of aperture coordinates.
    double Density(const AperturePoint& point) const;

  private:
    CellDistribution marginal;
    std::vector<CellDistribution> conditional;  ///< of each column
};

}  // namespace tilt_lens

#endif
