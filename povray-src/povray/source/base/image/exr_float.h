// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file exr_float.h
/// OpenEXR files of 32-bit floating point numbers. POV-Ray's own writer knows 16 bits alone.

#ifndef POVRAY_BASE_EXR_FLOAT_H
#define POVRAY_BASE_EXR_FLOAT_H

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/configbase.h"
#include "base/fileinputoutput.h"
#include "base/image/image.h"

namespace pov_base
{

namespace OpenEXR
{

/// Puts a row of a picture, counted from the top, into the vectors, which have its width: one for each channel.
typedef std::function<void(unsigned int row, std::vector<std::vector<float> >& channels)> FloatRows;

/// An attribute of the file: one number, two, three or the sixteen of a matrix, row by row.
typedef std::map<std::string, std::vector<float> > FloatAttributes;

/// Writes channels of 32 bits, asking for one row after the other, so that nobody has to hold them all. The attributes
/// `screenWindowWidth` and `screenWindowCenter` go where OpenEXR wants them.
/// @throws pov_base::Exception  the file cannot be written
void WriteFloats(OStream& file, unsigned int width, unsigned int height, const std::vector<std::string>& channels,
                 const FloatRows& rows, const FloatAttributes& attributes);

/// Writes a picture's colours with 32 bits; otherwise as POV-Ray writes them with 16.
/// @throws pov_base::Exception  the file cannot be written
void WriteFloatImage(OStream& file, const Image& image, const Image::WriteOptions& options);

} // namespace OpenEXR

} // namespace pov_base

#endif
