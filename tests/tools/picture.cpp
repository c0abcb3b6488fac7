// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ostream>

#include <OpenImageIO/imageio.h>

namespace witness
{

namespace
{

struct Decoded
{
    OIIO::ImageSpec spec;
    std::vector<float> values;
};

std::unique_ptr<OIIO::ImageInput> OpenPicture(const std::string& path)
{
    if (!std::filesystem::exists(path))
        throw MissingPicture("no such picture: " + path);
    // stored values: no division by alpha
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &wish);
    if (!input)
        throw UnreadablePicture(path + ": " + OIIO::geterror());
    return input;
}

Decoded Decode(const std::string& path)
{
    const std::unique_ptr<OIIO::ImageInput> input = OpenPicture(path);
    Decoded decoded{input->spec(), {}};
    const OIIO::ImageSpec& spec = decoded.spec;
    decoded.values.resize(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, decoded.values.data()))
        throw UnreadablePicture(path + ": " + input->geterror());
    return decoded;
}

int ChannelNamed(const OIIO::ImageSpec& spec, const std::string& name)
{
    const auto found = std::find(spec.channelnames.begin(), spec.channelnames.end(), name);
    return found == spec.channelnames.end() ? -1 : static_cast<int>(found - spec.channelnames.begin());
}

Picture Channels(const Decoded& decoded, const int (&channels)[3])
{
    Picture picture{decoded.spec.width, decoded.spec.height, {}};
    const std::size_t pixels = static_cast<std::size_t>(picture.width) * picture.height;
    picture.values.reserve(3 * pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (const int channel : channels)
            picture.values.push_back(decoded.values[pixel * decoded.spec.nchannels + channel]);
    return picture;
}

Picture Colours(const Decoded& decoded, const std::string& path)
{
    if (decoded.spec.nchannels == 1)
        return Channels(decoded, {0, 0, 0});
    const int r = ChannelNamed(decoded.spec, "R"), g = ChannelNamed(decoded.spec, "G"), b = ChannelNamed(decoded.spec, "B");
    if (r < 0 || g < 0 || b < 0)
        throw UnreadablePicture(path + ": has no channels R, G, B");
    return Channels(decoded, {r, g, b});
}

double ToSrgb(double linear)
{
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

void Write(const std::string& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* data)
{
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path);
    if (!output || !output->open(path, spec))
        throw std::runtime_error("cannot write " + path + ": " + (output ? output->geterror() : OIIO::geterror()));
    if (!output->write_image(type, data) || !output->close())
        throw std::runtime_error("cannot write " + path + ": " + output->geterror());
}

} // namespace

Picture ReadPicture(const std::string& path)
{
    return Colours(Decode(path), path);
}

Picture ReadChannel(const std::string& path, const std::string& channel)
{
    const Decoded decoded = Decode(path);
    const int found = ChannelNamed(decoded.spec, channel);
    if (found < 0)
        throw UnreadablePicture(path + ": has no channel " + channel);
    return Channels(decoded, {found, found, found});
}

Reference ReadReference(const std::string& path)
{
    const Decoded decoded = Decode(path);
    Reference reference;
    reference.mean = Colours(decoded, path);
    const int r = ChannelNamed(decoded.spec, "error.R"), g = ChannelNamed(decoded.spec, "error.G"),
              b = ChannelNamed(decoded.spec, "error.B");
    if (r >= 0 && g >= 0 && b >= 0)
    {
        reference.error = Channels(decoded, {r, g, b});
        reference.batches = decoded.spec.get_int_attribute("witness:batches", 1);
        return reference;
    }
    reference.error = reference.mean;
    std::fill(reference.error.values.begin(), reference.error.values.end(), 0.0);
    return reference;
}

void WriteReference(const std::string& path, const Reference& reference)
{
    OIIO::ImageSpec spec(reference.mean.width, reference.mean.height, 6, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"R", "G", "B", "error.R", "error.G", "error.B"};
    const OIIO::TypeDesc f = OIIO::TypeDesc::FLOAT, h = OIIO::TypeDesc::HALF;
    spec.channelformats = {f, f, f, h, h, h};
    spec.attribute("compression", "zip");
    spec.attribute("witness:batches", reference.batches);
    // mixed types would need a packed buffer
    std::vector<float> values;
    values.reserve(2 * reference.mean.Size());
    for (std::size_t pixel = 0; pixel < reference.mean.Size(); pixel += 3)
    {
        for (std::size_t c = 0; c < 3; ++c)
            values.push_back(static_cast<float>(reference.mean.values[pixel + c]));
        for (std::size_t c = 0; c < 3; ++c)
            values.push_back(static_cast<float>(reference.error.values[pixel + c]));
    }
    Write(path, spec, OIIO::TypeDesc::FLOAT, values.data());
}

void WritePreview(const std::string& path, const Picture& picture, int zoom)
{
    const int width = picture.width * zoom, height = picture.height * zoom;
    std::vector<std::uint8_t> values;
    values.reserve(static_cast<std::size_t>(width) * height * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
            {
                const std::size_t at = (static_cast<std::size_t>(y / zoom) * picture.width + x / zoom) * 3 + c;
                values.push_back(static_cast<std::uint8_t>(std::lround(255.0 * ToSrgb(picture.values[at]))));
            }
    Write(path, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::UINT8), OIIO::TypeDesc::UINT8, values.data());
}

void WritePixels(const std::string& path, std::ostream& out)
{
    const std::unique_ptr<OIIO::ImageInput> input = OpenPicture(path);
    const OIIO::ImageSpec spec = input->spec();
    std::vector<char> bytes(spec.image_bytes(true));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UNKNOWN, bytes.data()))
        throw UnreadablePicture(path + ": " + input->geterror());
    out << spec.width << ' ' << spec.height << ' ' << spec.nchannels << ' ' << spec.format.c_str();
    for (const std::string& name : spec.channelnames)
        out << ' ' << name;
    out << '\n';
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

Reference Average(const std::vector<Picture>& batches)
{
    Reference result;
    result.batches = static_cast<int>(batches.size());
    result.mean = result.error = batches.at(0);
    const double n = static_cast<double>(batches.size());
    for (std::size_t i = 0; i < result.mean.Size(); ++i)
    {
        double sum = 0.0, squares = 0.0;
        for (const Picture& batch : batches)
            sum += batch.values[i];
        const double mean = sum / n;
        for (const Picture& batch : batches)
            squares += (batch.values[i] - mean) * (batch.values[i] - mean);
        result.mean.values[i] = mean;
        result.error.values[i] = batches.size() > 1 ? std::sqrt(squares / (n - 1.0) / n) : 0.0;
    }
    return result;
}

} // namespace witness
