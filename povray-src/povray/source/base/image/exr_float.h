// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file exr_float.h
/// Writes OpenEXR files of 32-bit floats; POV-Ray's writer has 16 bits.

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

/// Fills vectors, as long as the picture is wide, with a row counted from the top.
typedef std::function<void(unsigned int row, std::vector<std::vector<float>>& channels)> FloatRows;

/// 1, 2, 3 or 16 numbers (matrix row by row).
typedef std::map<std::string, std::vector<float>> FloatAttributes;

/// `screenWindowWidth` and `screenWindowCenter` become the header's fields.
/// @throws pov_base::Exception  unwritable file
void WriteFloats(OStream& file, unsigned int width, unsigned int height, const std::vector<std::string>& channels, const FloatRows& rows,
                 const FloatAttributes& attributes);

/// As POV-Ray's 16-bit writer.
/// @throws pov_base::Exception  unwritable file
void WriteFloatImage(OStream& file, const Image& image, const Image::WriteOptions& options);

} // namespace OpenEXR

} // namespace pov_base

#endif
