// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must come first
#include "base/configbase.h"

#include "frontend/state_key.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include <boost/scoped_ptr.hpp>

#include "base/file_list.h"
#include "base/platformbase.h"
#include "base/stringutilities.h"
#include "frontend/configfrontend.h"
#include "frontend/renderfrontend.h"

#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

const char* const kFile = "file ";

struct Option
{
    const char* name;
    POVMSType key, type;
};

const Option kOptions[] = {
    {"Width", kPOVAttrib_Width, kPOVMSType_Int},
    {"Height", kPOVAttrib_Height, kPOVMSType_Int},
    {"Start_Column", kPOVAttrib_Left, kPOVMSType_Float},
    {"End_Column", kPOVAttrib_Right, kPOVMSType_Float},
    {"Start_Row", kPOVAttrib_Top, kPOVMSType_Float},
    {"End_Row", kPOVAttrib_Bottom, kPOVMSType_Float},
    {"Render_Block_Size", kPOVAttrib_RenderBlockSize, kPOVMSType_Int},
    {"Render_Block_Step", kPOVAttrib_RenderBlockStep, kPOVMSType_Int},
    {"Render_Pattern", kPOVAttrib_RenderPattern, kPOVMSType_Int},
    {"Preview_Start_Size", kPOVAttrib_PreviewStartSize, kPOVMSType_Int},
    {"Preview_End_Size", kPOVAttrib_PreviewEndSize, kPOVMSType_Int},
    {"Quality", kPOVAttrib_Quality, kPOVMSType_Int},
    {"Antialias", kPOVAttrib_Antialias, kPOVMSType_Bool},
    {"Antialias_Depth", kPOVAttrib_AntialiasDepth, kPOVMSType_Int},
    {"Antialias_Threshold", kPOVAttrib_AntialiasThreshold, kPOVMSType_Float},
    {"Antialias_Gamma", kPOVAttrib_AntialiasGamma, kPOVMSType_Float},
    {"Sampling_Method", kPOVAttrib_SamplingMethod, kPOVMSType_Int},
    {"Jitter", kPOVAttrib_Jitter, kPOVMSType_Bool},
    {"Jitter_Amount", kPOVAttrib_JitterAmount, kPOVMSType_Float},
    {"Output_Alpha", kPOVAttrib_OutputAlpha, kPOVMSType_Bool},
    {"High_Reproducibility", kPOVAttrib_HighReproducibility, kPOVMSType_Bool},
    {"Radiosity_From_File", kPOVAttrib_RadiosityFromFile, kPOVMSType_Bool},
    {"Radiosity_Vain_Pretrace", kPOVAttrib_RadiosityVainPretrace, kPOVMSType_Bool},
    {"Bounding", kPOVAttrib_Bounding, kPOVMSType_Bool},
    {"Bounding_Method", kPOVAttrib_BoundingMethod, kPOVMSType_Int},
    {"Bounding_Threshold", kPOVAttrib_BoundingThreshold, kPOVMSType_Int},
    {"Remove_Bounds", kPOVAttrib_RemoveBounds, kPOVMSType_Bool},
    {"Split_Unions", kPOVAttrib_SplitUnions, kPOVMSType_Bool},
    {"Version", kPOVAttrib_Version, kPOVMSType_Float},
    {"Clock", kPOVAttrib_Clock, kPOVMSType_Float},
};

std::string Text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string Value(POVMS_Object& options, const Option& option)
{
    if (!options.Exist(option.key))
        return "not given";
    switch (option.type)
    {
        case kPOVMSType_Bool: return options.GetBool(option.key) ? "on" : "off";
        case kPOVMSType_Int: return std::to_string(options.GetInt(option.key));
        default: return Text(options.GetFloat(option.key));
    }
}

/// One per line, sorted.
std::string Declared(POVMS_Object& options)
{
    std::vector<std::string> lines;
    POVMS_List list;
    if (options.Exist(kPOVAttrib_Declare))
        options.Get(kPOVAttrib_Declare, list);
    for (int i = 1; i <= list.GetListSize(); i++)
    {
        POVMS_Object item;
        POVMS_Attribute value;
        list.GetNth(i, item);
        item.Get(kPOVAttrib_Value, value);
        lines.push_back("Declare " + item.GetString(kPOVAttrib_Identifier) + "=" +
                        (value.Type() == kPOVMSType_CString ? item.GetString(kPOVAttrib_Value) : Text(item.GetFloat(kPOVAttrib_Value))) +
                        "\n");
    }
    std::sort(lines.begin(), lines.end());
    std::string text;
    for (const std::string& line : lines)
        text += line;
    return text;
}

/// Hexadecimal 64-bit FNV-1a. "unknown" for a pipe or device, which cannot be read twice.
std::string Hash(const std::string& name)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(name, ignored))
        return "unknown";
    std::ifstream stream(name, std::ios::binary);
    std::vector<char> buffer(1 << 16);
    std::uint64_t hash = 0xcbf29ce484222325u;
    while (stream.read(buffer.data(), std::streamsize(buffer.size())), stream.gcount() > 0)
        for (std::streamsize i = 0; i < stream.gcount(); i++)
            hash = (hash ^ static_cast<unsigned char>(buffer[size_t(i)])) * 0x100000001b3u;
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

struct Line
{
    std::string name, value;
    bool operator==(const Line& other) const { return name == other.name && value == other.value; }
};

std::vector<Line> Lines(const std::string& key)
{
    std::vector<Line> lines;
    for (size_t from = 0, end; (end = key.find('\n', from)) != std::string::npos; from = end + 1)
    {
        const std::string line = key.substr(from, end - from);
        // names of files may contain '=', their hashes cannot; values of Declare may
        const size_t equals = line.compare(0, std::strlen(kFile), kFile) == 0 ? line.rfind('=') : line.find('=');
        lines.push_back({line.substr(0, equals), equals == std::string::npos ? "" : line.substr(equals + 1)});
    }
    return lines;
}

const Line* Find(const std::vector<Line>& lines, const std::string& name)
{
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const Line& line) { return line.name == name; });
    return found == lines.end() ? NULL : &*found;
}

std::string Difference(const std::string& before, const std::string& now)
{
    const std::vector<Line> old = Lines(before), present = Lines(now);
    for (const Line& line : present)
    {
        const Line* was = Find(old, line.name);
        const bool file = line.name.compare(0, std::strlen(kFile), kFile) == 0;
        if (was == NULL)
            return "its render did not have " + line.name + (file ? "" : "=" + line.value);
        if (!(*was == line) && file)
            return "the contents of " + line.name + " have changed";
        if (!(*was == line))
            return line.name + " was " + was->value + " and now is " + line.value;
    }
    for (const Line& line : old)
        if (Find(present, line.name) == NULL)
            return "its render had " + line.name + ", which now is missing";
    return "its files were read in another order";
}

/// True if tiles of one picture lie inside the other.
bool Fits(const std::string& before, const std::string& now)
{
    const std::vector<Line> old = Lines(before), present = Lines(now);
    for (const char* name : {"Width", "Height"})
    {
        const Line *was = Find(old, name), *is = Find(present, name);
        if (was == NULL || is == NULL || std::atol(was->value.c_str()) > std::atol(is->value.c_str()))
            return false;
    }
    return true;
}

struct Start
{
    enum Kind
    {
        kNothing,
        kNoState,
        kNoKey,
        kKey
    } kind;
    std::string key;
};

const Start kEmpty = {Start::kNothing, ""}, kForeign = {Start::kNoState, ""};

Start ReadKey(IStream& stream, POV_LONG length)
{
    const POV_LONG begin = sizeof(Backup_File_Header), least = 20;
    if (length <= begin)
        return kEmpty;
    unsigned char head[least] = {};
    const POV_LONG there = std::min(length - begin, least);
    stream.seekg(begin, IOBase::seek_set);
    if (!stream.read(head, size_t(there)) || std::memcmp(head, "POVRAYMS", size_t(std::min<POV_LONG>(there, 8))) != 0)
        return kForeign;
    const POV_LONG size = POV_LONG(head[12]) << 24 | head[13] << 16 | head[14] << 8 | head[15];
    if (there < least || begin + least + size > length)
        return kEmpty;
    POVMS_Message message;
    try
    {
        stream.seekg(begin, IOBase::seek_set);
        message.Read(stream);
        if (message.GetIdentifier() == kPOVMsgIdent_StateKey)
            return {Start::kKey, message.GetString(kPOVAttrib_StateKey)};
    }
    catch (const std::exception&)
    {
        return kForeign;
    }
    return {Start::kNoKey, ""};
}

Start ReadStart(IStream& stream)
{
    Backup_File_Header header = {}, whole = {};
    std::memcpy(whole.sig, RENDER_STATE_SIG, sizeof whole.sig);
    std::memcpy(whole.ver, RENDER_STATE_VER, sizeof whole.ver);
    stream.seekg(0, IOBase::seek_end);
    const POV_LONG length = stream.tellg();
    stream.seekg(0, IOBase::seek_set);
    const size_t known = sizeof whole.sig + sizeof whole.ver, there = size_t(std::min<POV_LONG>(length, sizeof header));
    if (there > 0 && !stream.read(&header, there))
        return kForeign;
    if (std::memcmp(&header, &whole, std::min(there, known)) != 0)
        return kForeign;
    return ReadKey(stream, length);
}

} // namespace

std::string StateKey(POVMS_Object& options)
{
    std::string key = std::string("the program=") + TILT_LENS_PROGRAM + "\n";
    for (const Option& option : kOptions)
        key += std::string(option.name) + "=" + Value(options, option) + "\n";
    const char* const preview = std::getenv("TILT_LENS_PREVIEW");
    key += std::string("TILT_LENS_PREVIEW=") + (preview == NULL ? "" : preview) + "\n" + Declared(options);
    for (const std::string& file : tilt_lens::SceneFiles())
    {
        std::string name = std::filesystem::path(file).filename().string();
        std::replace(name.begin(), name.end(), '\n', ' ');
        key += kFile + name + "=" + Hash(file) + "\n";
    }
    return key;
}

void WriteStateKey(OStream& file, const std::string& key)
{
    POVMS_Message message(kPOVObjectClass_PixelData, kPOVMsgClass_ViewImage, kPOVMsgIdent_StateKey);
    message.SetString(kPOVAttrib_StateKey, key.c_str());
    message.Write(file);
    file.flush();
}

std::string CompareState(const Path& file, const std::string& key, bool refuse)
{
    boost::scoped_ptr<IStream> stream(POV_PLATFORM_BASE.CreateIStream(POV_File_Data_Backup));
    if (stream == NULL || !stream->open(file().c_str()))
        return std::string();
    const Start start = ReadStart(*stream);
    stream.reset();

    const std::string name = "The state file '" + UCS2toASCIIString(file()) + "' ";
    std::string problem;
    switch (start.kind)
    {
        case Start::kNothing: POV_UCS2_REMOVE(file().c_str()); return std::string();
        case Start::kNoState: problem = name + "is not one of POV-Ray's, or is damaged. "; break;
        case Start::kNoKey: problem = name + "does not say which render it belongs to: another program wrote it. "; break;
        case Start::kKey:
            if (start.key == key)
                return std::string();
            problem = name + "belongs to another render: " + Difference(start.key, key) + ". ";
            refuse = refuse || !Fits(start.key, key);
            break;
    }
    if (refuse)
        throw POV_EXCEPTION(kCannotHandleRequestErr, problem +
                                                         (start.kind == Start::kKey ? "Undo that to continue it, or render" : "Render") +
                                                         " anew without +C (Continue_Trace), which replaces the file.");
    return start.kind == Start::kNoState ? problem + "It is replaced."
                                         : problem + "What it holds is kept, and may not fit the rest of the picture.";
}

void RequireWholeTile(const ViewData& view, POVMS_Object& message)
{
    if (message.TryGetInt(kPOVAttrib_PixelId, 0) < 0)
        throw POV_EXCEPTION(kInvalidDataSizeErr, "A tile has no number.");
    if (!view.image || !message.Exist(kPOVAttrib_PixelBlock))
        return;
    const POVMSLong left = message.GetInt(kPOVAttrib_Left), right = message.GetInt(kPOVAttrib_Right);
    const POVMSLong top = message.GetInt(kPOVAttrib_Top), bottom = message.GetInt(kPOVAttrib_Bottom);
    if (left < 0 || left > right || right >= view.image->GetWidth() || top < 0 || top > bottom || bottom >= view.image->GetHeight())
        throw POV_EXCEPTION(kInvalidDataSizeErr, "A tile lies outside the picture.");
    POVMS_Attribute pixels;
    message.Get(kPOVAttrib_PixelBlock, pixels);
    if (POVMSLong(pixels.GetFloatVector().size()) != 5 * (right - left + 1) * (bottom - top + 1))
        throw POV_EXCEPTION(kInvalidDataSizeErr, "A tile is not whole.");
}

} // namespace pov_frontend
