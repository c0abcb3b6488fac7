// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "layers.h"
#include "spread_pixels.h"

namespace
{

using namespace refocus;

constexpr double kLargest = 200.0;  // pixels: the time grows with its square

struct Arguments
{
    std::string picture, layers, output;
    std::vector<double> at, plane;
    double fStop = 0.0;
};

Plane NewPlane(const Arguments& arguments, const Layers& layers)
{
    if (!arguments.plane.empty())
    {
        const Plane plane{{arguments.plane[0], arguments.plane[1], arguments.plane[2]}, arguments.plane[3]};
        if (Dot(plane.normal, plane.normal) == 0.0)
            throw Mistake("--plane: the normal <0, 0, 0> has no direction.");
        return plane;
    }
    if (arguments.at.empty())
        return layers.focus;
    const double column = std::floor(arguments.at[0]), row = std::floor(arguments.at[1]);
    if (!(column >= 0 && column < layers.width && row >= 0 && row < layers.height))
        throw Mistake("--at: the picture has the columns 0 to " + std::to_string(layers.width - 1) + " and the rows 0 to " +
                      std::to_string(layers.height - 1) + ".");
    const std::size_t pixel = std::size_t(row) * layers.width + std::size_t(column);
    if (!std::isfinite(layers.depth[pixel]))
        throw Mistake("--at: there is no object in this pixel; choose another.");
    return {layers.focus.normal, Dot(layers.focus.normal, layers.positions[pixel])};
}

std::vector<float> Missing(const Layers& layers, const Plane& plane, double scale)
{
    std::vector<float> diameters;
    std::size_t sharper = 0, cut = 0;
    for (std::size_t i = 0; i < layers.depth.size(); i++)
    {
        const double blur = std::abs(layers.BlurWith(plane, i)) * scale, old = std::abs(layers.blur[i]);
        sharper += blur < old - 1.0;
        cut += blur > kLargest;
        const double missing = blur > old ? std::sqrt(blur * blur - old * old) : 0.0;
        diameters.push_back(float(std::min(missing, kLargest)));
    }
    if (sharper > 0)
        std::fprintf(stderr,
                     "refocus: %.1f%% of the pixels should be sharper than they were rendered, and stay as they are. "
                     "Render with a larger f_stop, and give --f-stop here.\n",
                     100.0 * sharper / layers.depth.size());
    if (cut > 0)
        std::fprintf(stderr, "refocus: %.1f%% of the pixels are blurred by more than %g pixels, and get that much.\n",
                     100.0 * cut / layers.depth.size(), kLargest);
    return diameters;
}

void Refocus(const Arguments& arguments)
{
    const Picture picture = ReadPicture(arguments.picture);
    const Layers layers = ReadLayers(arguments.layers);
    if (picture.width != layers.width || picture.height != layers.height)
        throw Mistake("picture and layers differ in size: they are not of one render.");
    const Plane plane = NewPlane(arguments, layers);
    const double scale = arguments.fStop > 0.0 ? layers.fStop / arguments.fStop : 1.0;
    WritePicture(Spread(picture, Missing(layers, plane, scale), layers.depth), arguments.output);
    std::printf("plane { <%.6g, %.6g, %.6g>, %.6g }, f/%.6g\n", plane.normal[0], plane.normal[1], plane.normal[2], plane.distance,
                layers.fStop / scale);
}

} // namespace

int main(int count, char** words)
{
    Arguments arguments;
    CLI::App app("Blurs a picture for another plane of sharp focus, from its layers (+FE +N): an approximate preview.");
    app.add_option("picture", arguments.picture, "the picture, OpenEXR")->required();
    app.add_option("layers", arguments.layers, "its layers, NAME.layers.exr")->required();
    app.add_option("output", arguments.output, "the preview, OpenEXR")->required();
    auto* at = app.add_option("--at", arguments.at, "focus on this pixel: COLUMN ROW, from 0; the plane keeps its direction")->expected(2);
    app.add_option("--plane", arguments.plane, "sharp plane: NX NY NZ D, as in plane { <NX, NY, NZ>, D }")->expected(4)->excludes(at);
    app.add_option("--f-stop", arguments.fStop, "f-number (default: that of the render)")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, count, words);
    try
    {
        Refocus(arguments);
    }
    catch (const Mistake& mistake)
    {
        std::fprintf(stderr, "refocus: %s\n", mistake.what());
        return 1;
    }
    return 0;
}
