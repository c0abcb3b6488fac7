// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file picture.h
/// Pictures for the independent tools: linear RGB in floats, and the stored references with mean and standard error of
/// each pixel.

#ifndef WITNESS_PICTURE_H
#define WITNESS_PICTURE_H

#include <cstddef>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

namespace witness
{

/// Red, green, blue of every pixel, row by row from the top.
struct Picture
{
    int width = 0, height = 0;
    std::vector<double> values;

    std::size_t Size() const { return values.size(); }
    bool SameSize(const Picture& other) const { return width == other.width && height == other.height; }
};

/// A picture with the standard error of its mean; zero everywhere if unknown.
struct Reference
{
    Picture mean, error;
    int batches = 1;  ///< independent pictures in the mean; 1: the error is unknown
};

/// The file exists but cannot be decoded, or has too few channels.
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

/// Values as stored, without any colour conversion. @throws MissingPicture, UnreadablePicture
Picture ReadPicture(const std::string& path);

/// One channel of a file, three times over. @throws MissingPicture, UnreadablePicture
Picture ReadChannel(const std::string& path, const std::string& channel);

/// As ReadPicture for an ordinary picture. @throws MissingPicture, UnreadablePicture
Reference ReadReference(const std::string& path);

/// OpenEXR with channels R, G, B (mean, float) and error.R, error.G, error.B (half).
/// @throws std::runtime_error
void WriteReference(const std::string& path, const Reference& reference);

/// 8-bit sRGB PNG for people, each pixel `zoom` wide and high. @throws std::runtime_error
void WritePreview(const std::string& path, const Picture& picture, int zoom);

/// The decoded pixels in a common form: a line "width height channels type", then the values as stored, little-endian.
/// @throws MissingPicture, UnreadablePicture
void WritePixels(const std::string& path, std::ostream& out);

/// Mean and standard error over independent pictures of one size.
Reference Average(const std::vector<Picture>& batches);

}  // namespace witness

#endif
