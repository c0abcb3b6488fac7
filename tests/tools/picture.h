// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file picture.h
/// Linear RGB in floats.

#ifndef WITNESS_PICTURE_H
#define WITNESS_PICTURE_H

#include <cstddef>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace witness
{

struct Picture
{
    int width = 0, height = 0;
    std::vector<double> values;

    std::size_t Size() const { return values.size(); }
    bool SameSize(const Picture& other) const { return width == other.width && height == other.height; }
};

struct Reference
{
    Picture mean, error;
    int batches = 1;  ///< independent pictures in the mean; 1: the error is unknown
};

/// The file is undecodable, or has too few channels.
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

/// Returns values as stored.
/// @throws MissingPicture, UnreadablePicture
Picture ReadPicture(const std::string& path);

/// Returns one channel three times over.
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

Reference Average(const std::vector<Picture>& batches);

} // namespace witness

#endif
