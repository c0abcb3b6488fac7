// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file picture_layers.h
/// Messages to the front end for `Output_Layers`, of the class kPOVMsgClass_ViewImage:
/// - kPOVMsgIdent_Layers, one per tile, before its colours: rectangle, layer names, and values, layer by layer;
/// - kPOVMsgIdent_LayerAttributes, one per render.

#ifndef POVRAY_BASE_PICTURE_LAYERS_H
#define POVRAY_BASE_PICTURE_LAYERS_H

#include <string>
#include <vector>

#include "base/configbase.h"
#include "base/povms.h"

namespace pov_base
{

enum
{
    kPOVMsgIdent_Layers = 'LayT',
    kPOVMsgIdent_LayerAttributes = 'LayA',

    kPOVAttrib_OutputLayers = 'OuLa',
    kPOVAttrib_LayerNames = 'LayN',  ///< string: names, one per line
    kPOVAttrib_LayerSizes = 'LayS',  ///< numbers per attribute
    kPOVAttrib_LayerValues = 'LayV'   ///< vector of floats
};

inline std::string JoinedNames(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += name + "\n";
    return text;
}

inline std::vector<std::string> SplitNames(const std::string& text)
{
    std::vector<std::string> names;
    for (size_t from = 0, end; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
        names.push_back(text.substr(from, end - from));
    return names;
}

} // namespace pov_base

#endif
