// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layer_picture.h
/// The front end's part in `Output_Layers`: gathers the layers of the tiles and writes them to one OpenEXR file
/// beside the picture.

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
    /// The layers of the picture that these options describe, or NULL where they ask for none. All pixels
    /// begin as zeros. Removes an older file, except where a render is continued.
    /// @throws pov_base::Exception  I/O restrictions forbid the file
    static shared_ptr<LayerPicture> Create(POVMS_Object& options);

    /// What is wrong with the options for layers, as a sentence or two; empty if nothing.
    static std::string Problem(POVMS_Object& options);

    /// What a user should know of these options though the program can go on: 32 bits of a colour in a file that
    /// has no place for them. Empty if nothing.
    static std::string Remark(POVMS_Object& options);

    /// Takes what concerns the layers of a message of the class kPOVMsgClass_ViewImage, for a view that
    /// has them, and keeps the layers of a tile in the state file.
    static void Take(const ViewData& view, POVMSType ident, POVMS_Object& message);

    /// After a state file was read: demands that its tiles have layers.
    /// @throws pov_base::Exception  the render was begun without them
    void RequireComplete() const;

    /// Writes the file: under another name first, so that no half of one ever bears the final name.
    /// @throws pov_base::Exception  it cannot be written
    void Write() const;

  private:
    const pov_base::Path file;
    const unsigned int width, height;
    std::map<std::string, std::vector<std::vector<float> > > channels;  ///< rows, those without a tile being empty
    pov_base::OpenEXR::FloatAttributes attributes;
    std::vector<bool> covered;  ///< by pixel: has layers
    bool incomplete;            ///< some finished tile came without

    LayerPicture(const pov_base::Path& file, unsigned int width, unsigned int height);

    void TakeTile(POVMS_Object& message);
    void TakeAttributes(POVMS_Object& message);
    void RequireTile(POVMS_Object& message);
};

} // namespace pov_frontend

#endif
