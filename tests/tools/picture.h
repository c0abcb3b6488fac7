// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file picture.h
/// Linear RGB in floats; references have mean and standard error.

#ifndef WITNESS_PICTURE_H
#define WITNESS_PICTURE_H

#include <cstddef>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace witness
{

/// Red, green, blue by rows from the top.
struct Picture
{
    int width = 0, height = 0;
    std::vector<double> values;

    std::size_t Size() const { return values.size(); }
    bool SameSize(const Picture& other) const { return width == other.width && height == other.height; }
};

/// Zero if unknown.
struct Reference
{
    Picture mean, error;
    int batches = 1;  ///< independent pictures in the mean; 1: the error is unknown
};

/// Undecodable, or too few channels.
class UnreadablePicture : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

class MissingPicture : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// As stored.
/// @throws MissingPicture, UnreadablePicture
Picture ReadPicture(const std::string& path);

/// Three times over.
/// @throws MissingPicture, UnreadablePicture
Picture ReadChannel(const std::string& path, const std::string& channel);

/// @throws MissingPicture, UnreadablePicture
Reference ReadReference(const std::string& path);

/// OpenEXR channels R, G, B (mean, float), error.R, error.G, error.B (half).
/// @throws std::runtime_error
void WriteReference(const std::string& path, const Reference& reference);

/// 8-bit sRGB, each pixel `zoom` wide and high.
/// @throws std::runtime_error
void WritePreview(const std::string& path, const Picture& picture, int zoom);

/// A line "width height channels type", then stored values, little-endian.
/// @throws MissingPicture, UnreadablePicture
void WritePixels(const std::string& path, std::ostream& out);

/// Over independent pictures of one size.
Reference Average(const std::vector<Picture>& batches);

}  // namespace witness

#endif
