// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "base/image/exr_float.h"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfMatrixAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfVecAttribute.h>

#include <utility>

#include "base/image/encoding.h"
#include "base/image/metadata.h"

#include "base/povdebug.h"

namespace pov_base
{

namespace OpenEXR
{

namespace
{

/// OpenEXR 2 has its own type, OpenEXR 3 uint64_t.
using Place = decltype(std::declval<Imf::OStream&>().tellp());

class FloatStream : public Imf::OStream
{
  public:
    explicit FloatStream(pov_base::OStream& file) : Imf::OStream("OpenEXR output"), file(file) {}

    void write(const char* bytes, int count)
    {
        if (!file.write(bytes, count))
            throw POV_EXCEPTION(kFileDataErr, "Error while writing EXR output (is the disk full?)");
    }

    Place tellp() { return file.tellg(); }

    void seekp(Place position)
    {
        if (!file.seekg(position))
            throw POV_EXCEPTION(kFileDataErr, "Error while writing EXR output");
    }

  private:
    pov_base::OStream& file;
};

void Insert(Imf::Header& header, const std::string& name, const std::vector<float>& v)
{
    if (name == "screenWindowWidth")
        header.screenWindowWidth() = v.at(0);
    else if (name == "screenWindowCenter")
        header.screenWindowCenter() = Imath::V2f(v.at(0), v.at(1));
    else if (v.size() == 1)
        header.insert(name, Imf::FloatAttribute(v[0]));
    else if (v.size() == 2)
        header.insert(name, Imf::V2fAttribute(Imath::V2f(v[0], v[1])));
    else if (v.size() == 3)
        header.insert(name, Imf::V3fAttribute(Imath::V3f(v[0], v[1], v[2])));
    else if (v.size() == 16)
    {
        Imath::M44f matrix;
        std::copy(v.begin(), v.end(), &matrix[0][0]);
        header.insert(name, Imf::M44fAttribute(matrix));
    }
    else
        throw POV_EXCEPTION_STRING("An EXR attribute of a kind that is not known");
}

void InsertOrigin(Imf::Header& header)
{
    Metadata about;
    std::string comments;
    for (const std::string& line : {about.getComment1(), about.getComment2(), about.getComment3(), about.getComment4()})
        if (!line.empty())
            comments += line + "\n";
    if (!comments.empty())
        header.insert("comments", Imf::StringAttribute(comments));
    header.insert("software", Imf::StringAttribute(about.getSoftware()));
    header.insert("creation", Imf::StringAttribute(about.getDateTime()));
}

} // namespace

void WriteFloats(OStream& file, unsigned int width, unsigned int height, const std::vector<std::string>& channels, const FloatRows& rows,
                 const FloatAttributes& attributes)
{
    Imf::Header header(width, height, 1.0f, Imath::V2f(0.0f, 0.0f), 1.0f, Imf::INCREASING_Y, Imf::ZIP_COMPRESSION);
    Imf::FrameBuffer pixels;
    std::vector<std::vector<float>> row(channels.size(), std::vector<float>(width, 0.0f));
    for (size_t i = 0; i < channels.size(); i++)
    {
        header.channels().insert(channels[i], Imf::Channel(Imf::FLOAT));
        // stride 0: each row reuses the buffer
        pixels.insert(channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(row[i].data()), sizeof(float), 0));
    }
    for (const FloatAttributes::value_type& attribute : attributes)
        Insert(header, attribute.first, attribute.second);
    InsertOrigin(header);

    FloatStream stream(file);
    try
    {
        Imf::OutputFile output(stream, header);
        output.setFrameBuffer(pixels);
        for (unsigned int y = 0; y < height; y++)
        {
            rows(y, row);
            output.writePixels();
        }
    }
    catch (const pov_base::Exception&)
    {
        throw;
    }
    catch (const std::exception& error)
    {
        throw POV_EXCEPTION(kFileDataErr, error.what());
    }
}

void WriteFloatImage(OStream& file, const Image& image, const Image::WriteOptions& options)
{
    const unsigned int width = image.GetWidth(), height = image.GetHeight();
    const bool alpha = image.HasTransparency() && options.alphachannel;
    // OpenEXR's convention is linear light and premultiplied colours
    const bool premultiplied = options.premultiplyOverride ? options.premultiply : true;
    const GammaCurvePtr gamma = TranscodingGammaCurve::Get(options.workingGamma, NeutralGammaCurve::Get());

    std::vector<std::string> names = {"R", "G", "B"};
    if (alpha)
        names.push_back("A");
    const auto row = [&](unsigned int y, std::vector<std::vector<float>>& channels)
    {
        for (unsigned int x = 0; x < width; x++)
        {
            float v[4];
            GetEncodedRGBAValue(&image, x, y, gamma, v[0], v[1], v[2], v[3], premultiplied);
            for (size_t c = 0; c < names.size(); c++)
                channels[c][x] = v[c];
        }
    };
    WriteFloats(file, width, height, names, row, FloatAttributes());
}

} // namespace OpenEXR

} // namespace pov_base
