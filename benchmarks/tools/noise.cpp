// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file noise.cpp
/// How far pictures are from their reference, in linear light between 0 and 1.
///
///     noise reference OUT.exr PICTURE...    mean of independent pictures and its standard error
///     noise errors REFERENCE PICTURE...     each picture against it; with --layers FILE --more-than N one
///                                           picture, and its pixels that took more than N samples apart
///     noise prefixes REFERENCE PICTURE... --counts N,N    the mean of the first so many pictures
///
/// A reference made of several pictures knows its own mean square error, which is independent of the
/// picture's and is taken off; a result below zero is given as zero. Pictures that are larger than the
/// reference by a border of the same width on all sides are cut to size. One JSON object a line.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "picture.h"

namespace
{

using nlohmann::json;
using witness::Picture;
using witness::Reference;

/// What a 16-bit PNG does to every competitor's picture, done to all alike.
Picture Clipped(Picture picture)
{
    for (double& value : picture.values)
    {
        if (!std::isfinite(value))
            throw std::runtime_error("a picture has values that are infinite or not a number");
        value = std::clamp(value, 0.0, 1.0);
    }
    return picture;
}

Picture Inner(const Picture& picture, int width, int height)
{
    const int border = (picture.width - width) / 2;
    if (border < 0 || picture.width - width != 2 * border || picture.height - height != 2 * border)
        throw std::runtime_error("a picture of " + std::to_string(picture.width) + " x " +
                                 std::to_string(picture.height) + " is no " + std::to_string(width) + " x " +
                                 std::to_string(height) + " with a border");
    Picture inner{width, height, {}};
    inner.values.reserve(3 * std::size_t(width) * height);
    for (int y = border; y < border + height; ++y)
    {
        const auto row = picture.values.begin() + 3 * (std::ptrdiff_t(y) * picture.width + border);
        inner.values.insert(inner.values.end(), row, row + 3 * width);
    }
    return inner;
}

double MeanSquare(const Picture& picture)
{
    double sum = 0.0;
    for (const double value : picture.values)
        sum += value * value;
    return sum / picture.Size();
}

/// The figures of a picture; `limits` are values V for which the share of pixels is wanted that are off
/// by more than 2 sqrt(V) in any channel.
json Errors(const Picture& picture, const Reference& reference, const std::vector<double>& limits)
{
    const double own = MeanSquare(reference.error);
    double squares = 0.0, sum = 0.0;
    std::vector<double> worst;
    for (std::size_t i = 0; i < picture.Size(); ++i)
    {
        const double off = picture.values[i] - reference.mean.values[i];
        squares += off * off;
        sum += off;
        if (i % 3 == 0)
            worst.push_back(std::fabs(off));
        else
            worst.back() = std::max(worst.back(), std::fabs(off));
    }
    json result{{"mse", std::max(0.0, squares / picture.Size() - own)},
                {"mean", sum / picture.Size()},
                {"reference_mse", own}};
    for (const double limit : limits)
        result["beyond"].push_back(
            std::count_if(worst.begin(), worst.end(), [&](double off) { return off > 2.0 * std::sqrt(limit); }) /
            double(worst.size()));
    return result;
}

/// The mean square error of the pixels that took more than `least` samples, and how many they are.
json ErrorsOfMore(const Picture& picture, const Reference& reference, const Picture& samples, double least)
{
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.Size(); ++i)
        if (samples.values[i] > least)
        {
            const double off = picture.values[i] - reference.mean.values[i], own = reference.error.values[i];
            squares += off * off - own * own;
            ++count;
        }
    return {{"mse_more", count == 0 ? 0.0 : std::max(0.0, squares / count)},
            {"share_more", count / double(picture.Size())}};
}

struct Arguments
{
    std::string reference, picture, out, layers;
    std::vector<std::string> pictures;
    std::vector<double> limits;
    std::vector<std::size_t> counts;
    int width = 0, height = 0;
    double moreThan = 0.0;
};

void MakeReference(const Arguments& arguments)
{
    std::vector<Picture> batches;
    for (const std::string& path : arguments.pictures)
        batches.push_back(Inner(Clipped(witness::ReadPicture(path)), arguments.width, arguments.height));
    witness::WriteReference(arguments.out, witness::Average(batches));
}

void PrintErrors(const Arguments& arguments)
{
    const Reference reference = witness::ReadReference(arguments.reference);
    for (const std::string& path : arguments.pictures)
    {
        const Picture picture =
            Inner(Clipped(witness::ReadPicture(path)), reference.mean.width, reference.mean.height);
        json line = Errors(picture, reference, arguments.limits);
        line["picture"] = path;
        if (!arguments.layers.empty())
            line.update(ErrorsOfMore(picture, reference, Inner(witness::ReadChannel(arguments.layers, "samples"),
                                                               picture.width, picture.height), arguments.moreThan));
        std::cout << line.dump() << '\n';
    }
}

void PrintPrefixes(const Arguments& arguments)
{
    const Reference reference = witness::ReadReference(arguments.reference);
    Picture sum = reference.mean;
    std::fill(sum.values.begin(), sum.values.end(), 0.0);
    for (std::size_t i = 0; i < arguments.pictures.size(); ++i)
    {
        const Picture picture = Inner(witness::ReadPicture(arguments.pictures[i]), sum.width, sum.height);
        for (std::size_t k = 0; k < sum.Size(); ++k)
            sum.values[k] += picture.values[k];
        if (std::find(arguments.counts.begin(), arguments.counts.end(), i + 1) == arguments.counts.end())
            continue;
        Picture mean = sum;
        for (double& value : mean.values)
            value /= double(i + 1);
        json line = Errors(Clipped(std::move(mean)), reference, {});
        line["count"] = i + 1;
        std::cout << line.dump() << '\n';
    }
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app{"Errors of pictures against a reference"};
    app.require_subcommand(1);
    Arguments arguments;
    CLI::App* reference = app.add_subcommand("reference", "mean and standard error of independent pictures");
    reference->add_option("out", arguments.out)->required();
    reference->add_option("--size", [&](const std::vector<std::string>& size)
                          { arguments.width = std::stoi(size[0]), arguments.height = std::stoi(size[1]); return true; },
                          "width and height of the inner part")
        ->expected(2)->required();
    reference->add_option("pictures", arguments.pictures)->required();
    CLI::App* errors = app.add_subcommand("errors", "each picture against the reference");
    errors->add_option("reference", arguments.reference)->required();
    errors->add_option("pictures", arguments.pictures)->required();
    errors->add_option("--limits", arguments.limits, "values of variance, for shares of pixels")->delimiter(',');
    CLI::Option* layers = errors->add_option("--layers", arguments.layers, "what +N wrote beside the picture");
    errors->add_option("--more-than", arguments.moreThan, "samples")->needs(layers);
    CLI::App* prefixes = app.add_subcommand("prefixes", "means of the first pictures");
    prefixes->add_option("reference", arguments.reference)->required();
    prefixes->add_option("pictures", arguments.pictures)->required();
    prefixes->add_option("--counts", arguments.counts)->delimiter(',')->required();
    CLI11_PARSE(app, argc, argv);
    try
    {
        std::cout.precision(9);
        if (*reference)
            MakeReference(arguments);
        else if (*errors)
            PrintErrors(arguments);
        else
            PrintPrefixes(arguments);
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "noise: %s\n", error.what());
        return 1;
    }
    return 0;
}
