// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must come first
#include "base/configbase.h"

#include "frontend/layer_picture.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <boost/scoped_ptr.hpp>

#include "base/stringutilities.h"
#include "frontend/configfrontend.h"
#include "frontend/renderfrontend.h"
#include "frontend/whole_file.h"

#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

const int kFloatBits = 32;

Path LayersBeside(const Path& picture)
{
    Path path = picture;
    path.SetFile(GetFileName(picture) + ASCIItoUCS2String(".layers.exr"));
    return path;
}

std::string Text(const Path& path)
{
    return UCS2toASCIIString(path());
}

} // namespace

LayerPicture::LayerPicture(const Path& itsFile, unsigned int itsWidth, unsigned int itsHeight) :
    file(itsFile), width(itsWidth), height(itsHeight), covered(size_t(itsWidth) * itsHeight, false), incomplete(false)
{
}

shared_ptr<LayerPicture> LayerPicture::Create(POVMS_Object& options)
{
    if (!options.TryGetBool(kPOVAttrib_OutputLayers, false))
        return shared_ptr<LayerPicture>();
    const Path path = LayersBeside(Path(options.TryGetUCS2String(kPOVAttrib_OutputFile, "")));
    if (POV_ALLOW_FILE_WRITE(path().c_str(), POV_File_Image_EXR) == false)
        throw POV_EXCEPTION(kCannotOpenFileErr, "IO Restrictions prohibit write access to '" + Text(path) + "'");
    // after an interruption, an older file could pass for this render's
    if (!options.TryGetBool(kPOVAttrib_ContinueTrace, false))
        POV_UCS2_REMOVE(path().c_str());
    return shared_ptr<LayerPicture>(
        new LayerPicture(path, options.TryGetInt(kPOVAttrib_Width, 160), options.TryGetInt(kPOVAttrib_Height, 120)));
}

std::string LayerPicture::Problem(POVMS_Object& options)
{
    const bool toFile = options.TryGetBool(kPOVAttrib_OutputToFile, true);
    if (!options.TryGetBool(kPOVAttrib_OutputLayers, false))
        return std::string();
    if (options.TryGetBool(kPOVAttrib_RealTimeRaytracing, false))
        return "Output_Layers with Real_Time_Raytracing, which has no final picture. Remove one of the two.";
    if (!toFile)
        return "Output_Layers without a picture file: the layers' file is named after the picture's. Remove "
               "Output_Layers (+N) or Output_To_File=off (-F).";
    if (IsStandardStream(UCS2toASCIIString(options.TryGetUCS2String(kPOVAttrib_OutputFile, ""))))
        return "Output_Layers with a picture that goes to standard output or error: the layers' file is named after the "
               "picture's. Give a file name (+O), or remove Output_Layers (+N).";
    return std::string();
}

std::string LayerPicture::Remark(POVMS_Object& options)
{
    const bool exr = options.TryGetInt(kPOVAttrib_OutputFileType, DEFAULT_OUTPUT_FORMAT) == kPOVList_FileType_OpenEXR;
    if (exr || !options.TryGetBool(kPOVAttrib_OutputToFile, true) || options.TryGetInt(kPOVAttrib_BitsPerColor, 8) != kFloatBits)
        return std::string();
    return "Bits_Per_Color=32 with a file type other than OpenEXR: only OpenEXR holds 32-bit colours, others get 16 bits "
           "at most, as they always did. Use +FE32 (Output_File_Type=E) for 32, or ask for 16.";
}

void LayerPicture::Take(const ViewData& view, POVMSType ident, POVMS_Object& message)
{
    if (!view.layers)
        return;
    switch (ident)
    {
        case kPOVMsgIdent_Layers:
            view.layers->TakeTile(message);
            if (view.imageBackup)
            {
                message.Write(*view.imageBackup);
                view.imageBackup->flush();
            }
            break;
        case kPOVMsgIdent_LayerAttributes: view.layers->TakeAttributes(message); break;
        case kPOVMsgIdent_PixelBlockSet:
        case kPOVMsgIdent_PixelSet:
            if (message.Exist(kPOVAttrib_PixelId))
                view.layers->RequireTile(message);
            break;
    }
}

void LayerPicture::TakeTile(POVMS_Object& message)
{
    const unsigned int left = message.GetInt(kPOVAttrib_Left), top = message.GetInt(kPOVAttrib_Top);
    const unsigned int right = message.GetInt(kPOVAttrib_Right), bottom = message.GetInt(kPOVAttrib_Bottom);
    const std::vector<std::string> names = SplitNames(message.GetString(kPOVAttrib_LayerNames));
    const std::vector<POVMSFloat> values = message.GetFloatVector(kPOVAttrib_LayerValues);
    const size_t area = size_t(right - left + 1) * (bottom - top + 1);
    if (right >= width || bottom >= height || left > right || top > bottom || values.size() != names.size() * area)
        throw POV_EXCEPTION(kInvalidDataSizeErr, "The layers of a tile do not fit the picture.");

    std::vector<POVMSFloat>::const_iterator value = values.begin();
    for (const std::string& name : names)
    {
        std::vector<std::vector<float>>& rows = channels[name];
        rows.resize(height);
        for (unsigned int y = top; y <= bottom; y++, value += right - left + 1)
        {
            rows[y].resize(width, 0.0f);
            std::copy(value, value + (right - left + 1), rows[y].begin() + left);
        }
    }
    for (unsigned int y = top; y <= bottom; y++)
        std::fill_n(covered.begin() + size_t(y) * width + left, right - left + 1, true);
}

void LayerPicture::TakeAttributes(POVMS_Object& message)
{
    const std::vector<std::string> names = SplitNames(message.GetString(kPOVAttrib_LayerNames));
    const std::vector<POVMSInt> sizes = message.GetIntVector(kPOVAttrib_LayerSizes);
    const std::vector<POVMSFloat> values = message.GetFloatVector(kPOVAttrib_LayerValues);
    std::vector<POVMSFloat>::const_iterator value = values.begin();
    for (size_t i = 0; i < names.size(); value += sizes[i], i++)
        attributes[names[i]].assign(value, value + sizes[i]);
}

void LayerPicture::RequireTile(POVMS_Object& message)
{
    unsigned int x, y;
    if (message.Exist(kPOVAttrib_PixelPositions))
    {
        const std::vector<POVMSInt> positions = message.GetIntVector(kPOVAttrib_PixelPositions);
        if (positions.size() < 2)
            return;
        x = positions[0], y = positions[1];
    }
    else
        x = message.GetInt(kPOVAttrib_Left), y = message.GetInt(kPOVAttrib_Top);
    if (x < width && y < height && !covered[size_t(y) * width + x])
        incomplete = true;
}

void LayerPicture::RequireComplete() const
{
    if (incomplete)
        throw POV_EXCEPTION(kCannotHandleRequestErr,
                            "Output_Layers with Continue_Trace, of a picture that was begun without Output_Layers: the tiles "
                            "that are done have no layers. Continue without Output_Layers, or render anew without +C.");
}

void LayerPicture::Write() const
{
    std::vector<std::string> names;
    for (const auto& channel : channels)
        names.push_back(channel.first);
    const auto row = [&](unsigned int y, std::vector<std::vector<float>>& values)
    {
        size_t i = 0;
        for (const auto& channel : channels)
        {
            const std::vector<float>& known = channel.second[y];
            std::copy(known.begin(), known.end(), values[i].begin());
            std::fill(values[i].begin() + known.size(), values[i].end(), 0.0f);
            i++;
        }
    };
    WholeFile whole(file());
    try
    {
        boost::scoped_ptr<OStream> stream(NewOStream(whole.Place().c_str(), POV_File_Image_EXR, false));
        if (stream == NULL)
            throw POV_EXCEPTION(kCannotOpenFileErr, std::strerror(errno));
        OpenEXR::WriteFloats(*stream, width, height, names, row, attributes);
        whole.Finish(stream);
    }
    catch (const pov_base::Exception& error)
    {
        throw POV_EXCEPTION(kCannotOpenFileErr, "Cannot write the layers '" + Text(file) + "' (" + error.what() +
                                                    "). Make room there, then continue with +C: what is in the "
                                                    "state file need not be rendered again.");
    }
}

} // namespace pov_frontend
