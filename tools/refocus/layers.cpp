// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "layers.h"

#include <algorithm>
#include <cmath>

#include <OpenImageIO/imageio.h>

namespace refocus
{

namespace
{

std::vector<double> Numbers(const OIIO::ImageSpec& spec, const std::string& name, std::size_t count, const std::string& path)
{
    const OIIO::ParamValue* found = spec.find_attribute(name);
    if (found == nullptr || found->type().basetype != OIIO::TypeDesc::FLOAT ||
        std::size_t(found->type().numelements() * found->type().aggregate) < count)
        throw Mistake(path + " has no attribute " + name +
                      ": it is not a file of layers (+N) of a camera with tilt_lens and an "
                      "aperture.");
    const float* values = static_cast<const float*>(found->data());
    return {values, values + count};
}

Picture Read(const std::string& path, OIIO::ImageSpec& spec)
{
    const auto file = OIIO::ImageInput::open(path);
    if (!file)
        throw Mistake("cannot read " + path + ": " + OIIO::geterror());
    if (std::string(file->format_name()) != "openexr")
        throw Mistake(path + " is no OpenEXR file; render with +FE, which keeps linear colours.");
    spec = file->spec();
    Picture picture{spec.width, spec.height, spec.nchannels, {}, spec.channelnames};
    picture.values.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.values.data()))
        throw Mistake("cannot read " + path + ": " + file->geterror());
    return picture;
}

std::vector<float> Channel(const Picture& picture, const std::string& name, const std::string& path)
{
    const auto found = std::find(picture.names.begin(), picture.names.end(), name);
    if (found == picture.names.end())
        throw Mistake(path + " has no channel " + name + ": give the file of layers (+N), NAME.layers.exr, of a tilt_lens camera.");
    std::vector<float> values;
    for (std::size_t at = found - picture.names.begin(); at < picture.values.size(); at += picture.channels)
        values.push_back(picture.values[at]);
    return values;
}

void ReadCamera(Layers& layers, const OIIO::ImageSpec& spec, const std::string& path)
{
    const std::vector<double> m = Numbers(spec, "worldToCamera", 16, path);
    const double width = Numbers(spec, "screenWindowWidth", 1, path)[0];
    const std::vector<double> centre = Numbers(spec, "screenWindowCenter", 2, path);
    const std::vector<double> view = Numbers(spec, "tiltLens:fieldOfView", 2, path);
    const double height = 2.0 * std::tan(view[1] * M_PI / 360.0);
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 3; i++)
            layers.location[i] -= m[12 + axis] * m[4 * i + axis];
    for (int row = 0; row < layers.height; row++)
        for (int column = 0; column < layers.width; column++)
        {
            const double x = centre[0] + ((column + 0.5) / layers.width - 0.5) * width;
            const double y = centre[1] + (0.5 - (row + 0.5) / layers.height) * height;
            Vec3 direction;
            for (int i = 0; i < 3; i++)
                direction[i] = x * m[4 * i] + y * m[4 * i + 1] + m[4 * i + 2];
            layers.directions.push_back(direction);
        }
}

/// K for the header's plane: the median over the pixels.
double BlurFactor(const Layers& layers)
{
    std::vector<double> found;
    for (std::size_t i = 0; i < layers.blur.size(); i++)
    {
        const double vergence = layers.BlurWith(layers.focus, i);  // for K = 1
        if (std::isfinite(layers.blur[i]) && std::abs(layers.blur[i]) > 0.01 && vergence != 0.0)
            found.push_back(layers.blur[i] / vergence);
    }
    if (found.empty())
        throw Mistake("no pixel of the layers is blurred: nothing tells the size of the lens.");
    std::nth_element(found.begin(), found.begin() + found.size() / 2, found.end());
    return found[found.size() / 2];
}

} // namespace

double Dot(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double Layers::BlurWith(const Plane& plane, std::size_t pixel) const
{
    const double offset = plane.distance - Dot(plane.normal, location);
    if (std::abs(offset) < 1e-6 * (std::abs(plane.distance) + 1.0))  // the header's numbers have 24 bits
        throw Mistake("the plane goes through the camera; give another.");
    return blurFactor * (1.0 / depth[pixel] - Dot(plane.normal, directions[pixel]) / offset);
}

Picture ReadPicture(const std::string& path)
{
    OIIO::ImageSpec spec;
    return Read(path, spec);
}

Layers ReadLayers(const std::string& path)
{
    OIIO::ImageSpec spec;
    const Picture file = Read(path, spec);
    Layers layers;
    layers.width = file.width;
    layers.height = file.height;
    layers.depth = Channel(file, "depth.Z", path);
    layers.blur = Channel(file, "blur", path);
    const std::vector<float> x = Channel(file, "position.X", path), y = Channel(file, "position.Y", path),
                             z = Channel(file, "position.Z", path);
    for (std::size_t i = 0; i < x.size(); i++)
        layers.positions.push_back({x[i], y[i], z[i]});
    ReadCamera(layers, spec, path);
    const std::vector<double> normal = Numbers(spec, "tiltLens:focusNormal", 3, path);
    layers.focus = {{normal[0], normal[1], normal[2]}, Numbers(spec, "tiltLens:focusDistance", 1, path)[0]};
    // OpenImageIO's name for OpenEXR's attribute "aperture"
    layers.fStop = Numbers(spec, "FNumber", 1, path)[0];
    layers.blurFactor = 1.0;
    layers.blurFactor = BlurFactor(layers);
    return layers;
}

void WritePicture(const Picture& picture, const std::string& path)
{
    const auto file = OIIO::ImageOutput::create(path);
    if (!file || std::string(file->format_name()) != "openexr")
        throw Mistake("the output " + path + " must be an OpenEXR file, NAME.exr.");
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::HALF);
    spec.channelnames = picture.names;
    if (!file->open(path, spec) || !file->write_image(OIIO::TypeDesc::FLOAT, picture.values.data()) || !file->close())
        throw Mistake("cannot write " + path + ": " + file->geterror());
}

} // namespace refocus
