// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file aperture_picture.h
/// Tables of Aperture::Picture().

#ifndef TILT_LENS_APERTURE_PICTURE_H
#define TILT_LENS_APERTURE_PICTURE_H

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "tilt_lens/camera/aperture.h"

namespace tilt_lens
{

/// Piecewise constant over [0, 1]. The index table of H.-C. Chen and Y. Asau (1974) inverts it in constant expected time.
class CellDistribution
{
  public:
    static constexpr int cells = 256;

    /// @return  total weight; if 0, do not sample
    double Build(const double* weight);

    struct Place
    {
        int cell;
        double position;
    };

    /// @param u  in [0, 1)
    Place Invert(double u) const;

    double Density(double position) const;

  private:
    std::array<float, cells + 1> bound;
    std::array<std::uint8_t, cells> first;
};

class AperturePicture
{
  public:
    /// Throws as Aperture::Picture().
    explicit AperturePicture(const std::function<double(double u, double v)>& weight);

    AperturePoint Map(double u, double v) const;

    double Density(const AperturePoint& point) const;

  private:
    CellDistribution marginal;
    std::vector<CellDistribution> conditional;
};

} // namespace tilt_lens

#endif
