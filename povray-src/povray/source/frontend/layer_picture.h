// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layer_picture.h
/// Collects tiles' layers for `Output_Layers` and writes an OpenEXR file.

#ifndef POVRAY_FRONTEND_LAYER_PICTURE_H
#define POVRAY_FRONTEND_LAYER_PICTURE_H

#include <map>
#include <string>
#include <vector>

#include "base/configbase.h"
#include "base/image/exr_float.h"
#include "base/path.h"
#include "base/picture_layers.h"
#include "base/povmscpp.h"

namespace pov_frontend
{

struct ViewData;

class LayerPicture
{
  public:
    /// NULL if not wanted. Removes an older file unless the render is continued.
    /// @throws pov_base::Exception  I/O restrictions forbid the file
    static shared_ptr<LayerPicture> Create(POVMS_Object& options);

    /// Sentences, or empty.
    static std::string Problem(POVMS_Object& options);

    /// Warns of 32-bit colours in a file type that cannot hold them; else empty.
    static std::string Remark(POVMS_Object& options);

    /// Also keeps a tile's layers in the state file.
    static void Take(const ViewData& view, POVMSType ident, POVMS_Object& message);

    /// Call after reading a state file.
    /// @throws pov_base::Exception  the render was begun without layers
    void RequireComplete() const;

    /// @throws pov_base::Exception  unwritable file
    void Write() const;

  private:
    const pov_base::Path file;
    const unsigned int width, height;
    std::map<std::string, std::vector<std::vector<float>>> channels;
    pov_base::OpenEXR::FloatAttributes attributes;
    std::vector<bool> covered;
    bool incomplete;

    LayerPicture(const pov_base::Path& file, unsigned int width, unsigned int height);

    void TakeTile(POVMS_Object& message);
    void TakeAttributes(POVMS_Object& message);
    void RequireTile(POVMS_Object& message);
};

} // namespace pov_frontend

#endif
