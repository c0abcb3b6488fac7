// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file replay_samples.cpp
/// Samples pictures from record_samples, with any settings:
///
///     replay_samples FILE WIDTH HEIGHT SAMPLES --variances V,V --denoise 0,1 [--least N] [--most N] [--picture PREFIX]
///         < lines of settings
///
/// A part of a picture is a picture of its own. --least and --most (default: a quarter of the samples) are `blur_samples`. --picture writes
/// PREFIX0.pfm, ..., one for each object, and PREFIXtrue.pfm.
///
/// A line is NAME=VALUE,... or empty. Each line, variance and denoise yields a JSON object with the error against the mean of all samples.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "named_settings.h"
#include "recorded_sample.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

namespace
{

using namespace tilt_lens;
using nlohmann::json;

struct Recording
{
    std::uint32_t width, height, samples;
    std::vector<RecordedSample> taken;
    std::vector<std::array<double, 3>> truth;  ///< of each pixel, clipped

    Recording(const std::string& path, std::uint32_t width, std::uint32_t height, std::uint32_t samples) :
        width(width), height(height), samples(samples), taken(std::size_t(width) * height * samples), truth(std::size_t(width) * height)
    {
        std::ifstream file(path, std::ios::binary);
        std::uint16_t left = 65535, top = 65535;
        for (RecordedSample one; file.read(reinterpret_cast<char*>(&one), sizeof one);)
        {
            left = std::min(left, one.x);
            top = std::min(top, one.y);
        }
        file.clear();
        file.seekg(0);
        std::size_t count = 0;
        for (RecordedSample one; file.read(reinterpret_cast<char*>(&one), sizeof one); count++)
        {
            one.x -= left;
            one.y -= top;
            one.circle[0] -= left;
            one.circle[1] -= top;
            if (one.x >= width || one.y >= height || one.index >= samples)
                throw std::runtime_error(path + " has samples of another size of picture");
            taken[At(one.x, one.y, one.index)] = one;
        }
        if (count != taken.size())
            throw std::runtime_error(path + " has " + std::to_string(count) + " samples, not " + std::to_string(taken.size()));
        for (std::size_t pixel = 0; pixel < truth.size(); pixel++)
            for (int c = 0; c < 3; c++)
            {
                double sum = 0.0;
                for (std::uint32_t i = 0; i < samples; i++)
                    sum += std::isfinite(taken[pixel * samples + i].radiance[c]) ? taken[pixel * samples + i].radiance[c] : 0.0;
                truth[pixel][c] = std::clamp(sum / samples, 0.0, 1.0);
            }
    }

    std::size_t At(std::uint32_t x, std::uint32_t y, std::uint32_t index) const { return (std::size_t(y) * width + x) * samples + index; }
};

void Write(const std::string& path, std::uint32_t width, std::uint32_t height,
           const std::function<std::array<double, 3>(std::uint32_t, std::uint32_t)>& pixel)
{
    std::ofstream file(path, std::ios::binary);
    file << "PF\n" << width << " " << height << "\n-1.0\n";
    for (std::uint32_t y = height; y-- > 0;)
        for (std::uint32_t x = 0; x < width; x++)
            for (const double value : pixel(x, y))
            {
                const float one = float(value);
                file.write(reinterpret_cast<const char*>(&one), sizeof one);
            }
    if (!file)
        throw std::runtime_error("cannot write " + path);
}

json Replay(const Recording& recording, SamplingLimits limits, double variance, bool denoise, const std::string& picture)
{
    limits.variance = variance;
    limits.denoise = denoise;
    if (limits.min == 0)
        limits.SetUsualMinimum(true);
    const LensFootprint footprint(Lens{}, Aperture::Disc(), 1.0, 1.0);
    const Area all{0, 0, recording.width, recording.height};
    BlockCache cache(limits, recording.width, recording.height, all);
    TileSampler sampler(cache);
    sampler.Run(all, [&](const SampleId& id, SampleResult& result)
    { result = recording.taken[recording.At(id.x, id.y, id.index)].Result(footprint); });
    double error = 0.0, beyond = 0.0, samples = 0.0;
    for (std::uint32_t y = 0; y < all.height; y++)
        for (std::uint32_t x = 0; x < all.width; x++)
        {
            double worst = 0.0;
            for (int c = 0; c < 3; c++)
            {
                const double off = std::clamp(sampler.Mean(x, y)[c], 0.0, 1.0) - recording.truth[all.IndexOf(x, y)][c];
                error += off * off / 3.0;
                worst = std::max(worst, off * off);
            }
            beyond += worst > 4.0 * variance;
            samples += sampler.Samples(x, y);
        }
    if (!picture.empty())
        Write(picture, all.width, all.height, [&](std::uint32_t x, std::uint32_t y)
        {
            const Radiance mean = sampler.Mean(x, y);
            return std::array<double, 3>{mean[0], mean[1], mean[2]};
        });
    const double pixels = all.Size();
    return {
        {"variance", variance}, {"denoise", denoise}, {"mse", error / pixels}, {"beyond", beyond / pixels}, {"samples", samples / pixels}};
}

}  // namespace

int main(int count, char** values)
{
    CLI::App app("Samples pictures from recorded samples");
    std::string path;
    std::uint32_t width = 0, height = 0, samples = 0;
    std::vector<double> variances;
    std::vector<bool> denoise;
    SamplingLimits limits;
    limits.min = limits.max = 0;  // the usual ones
    std::string picture;
    app.add_option("file", path)->required();
    app.add_option("width", width)->required();
    app.add_option("height", height)->required();
    app.add_option("samples", samples)->required();
    app.add_option("--variances", variances)->delimiter(',')->required();
    app.add_option("--denoise", denoise)->delimiter(',')->required();
    app.add_option("--least", limits.min);
    app.add_option("--most", limits.max);
    app.add_option("--picture", picture);
    CLI11_PARSE(app, count, values);
    try
    {
        const Recording recording(path, width, height, samples);
        limits.max = limits.max == 0 ? samples / 4 : limits.max;
        if (limits.max > samples)
            throw std::runtime_error("--most is more than the recorded samples");
        int made = 0;
        if (!picture.empty())
            Write(picture + "true.pfm", width, height,
                  [&](std::uint32_t x, std::uint32_t y) { return recording.truth[std::size_t(y) * width + x]; });
        for (std::string line; std::getline(std::cin, line);)
        {
            limits.settings = SettingsNamed(line);
            for (const bool on : denoise)
                for (const double variance : variances)
                {
                    const std::string file = picture.empty() ? "" : picture + std::to_string(made++) + ".pfm";
                    json found = Replay(recording, limits, variance, on, file);
                    found["settings"] = line;
                    std::cout << found << "\n";
                }
        }
    }
    catch (const std::exception& error)
    {
        std::cerr << "replay_samples: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
