// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file noise.cpp
/// Pictures against their reference, in linear light.
///
///     noise reference OUT.exr PICTURE...    mean of independent pictures and its standard error
///     noise errors REFERENCE PICTURE...
///     noise claims REFERENCE PICTURE... --variance V --more-than N    whether independent pictures with NAME.layers.exr keep
///                                           V, also in pixels of more than N samples, and their standard error
///     noise prefixes REFERENCE PICTURE... --counts N,N    the mean of the first so many pictures
///     noise lamps REFERENCE WITHOUT PICTURE...    the share of the lamps' light kept, above white too, and of dark disc
///                                                 pixels; both references need --unclipped
///     noise groups REFERENCE PICTURE... --side N  squared errors in groups of N by N pixels
///
/// The reference's own mean square error is taken off; results are at least zero. Larger pictures are cut to the reference's size; --at
/// LEFT,TOP takes a part. One JSON object a line.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "lamp_light.h"
#include "picture.h"

namespace
{

using nlohmann::json;
using witness::Picture;
using witness::Reference;

/// As in every competitor's 16-bit PNG.
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

Reference Clipped(Reference reference)
{
    for (std::size_t i = 0; i < reference.mean.Size(); ++i)
        if (reference.mean.values[i] > 1.0)
            reference.mean.values[i] = 1.0, reference.error.values[i] = 0.0;
    return reference;
}

/// From `at` (left, top); without it, within a border.
Picture Inner(const Picture& picture, int width, int height, const std::vector<int>& at = {})
{
    const int border = (picture.width - width) / 2;
    const int left = at.empty() ? border : at.at(0), top = at.empty() ? border : at.at(1);
    if (at.empty() ? border < 0 || picture.width - width != 2 * border || picture.height - height != 2 * border
                   : left < 0 || top < 0 || left + width > picture.width || top + height > picture.height)
        throw std::runtime_error("a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) + " is no " +
                                 std::to_string(width) + " x " + std::to_string(height) +
                                 (at.empty() ? " with a border" : " from there on"));
    Picture inner{width, height, {}};
    inner.values.reserve(3 * std::size_t(width) * height);
    for (int y = top; y < top + height; ++y)
    {
        const auto row = picture.values.begin() + 3 * (std::ptrdiff_t(y) * picture.width + left);
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

json Errors(const Picture& picture, const Reference& reference)
{
    const double own = MeanSquare(reference.error);
    double squares = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < picture.Size(); ++i)
    {
        const double off = picture.values[i] - reference.mean.values[i];
        squares += off * off;
        sum += off;
    }
    return {{"mse", std::max(0.0, squares / picture.Size() - own)}, {"mean", sum / picture.Size()}, {"reference_mse", own}};
}

/// Square error as in the summary of a picture: relative to the brightness above white.
double MeanRelativeSquare(const Picture& picture, const Reference& reference)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.Size(); ++i)
    {
        const double bright = std::max(1.0, reference.mean.values[i]), off = picture.values[i] - reference.mean.values[i];
        sum += (off * off - reference.error.values[i] * reference.error.values[i]) / (bright * bright);
    }
    return sum / double(picture.Size());
}

class Claims
{
  public:
    Claims(const Reference& reference, double variance, double moreThan) :
        m_reference(reference), m_variance(variance), m_moreThan(moreThan)
    {
    }

    void Add(const Picture& picture, const Picture& samples)
    {
        for (std::size_t pixel = 0; pixel < picture.Size(); pixel += 3)
        {
            double worst = 0.0, sum = 0.0;
            for (std::size_t i = pixel; i < pixel + 3; ++i)
            {
                const double off = picture.values[i] - m_reference.mean.values[i], own = m_reference.error.values[i];
                worst = std::max(worst, std::fabs(off));
                sum += off * off - own * own;
            }
            m_sum += sum;
            m_worst.push_back(worst);
            if (samples.values[pixel] > m_moreThan)
            {
                m_sumOfMore += sum;
                m_more += 3;
            }
        }
        ++m_pictures;
    }

    json Found() const
    {
        const double values = double(m_reference.mean.Size()) * m_pictures;
        return {{"mse", std::max(0.0, m_sum / values)},
                {"reference_mse", MeanSquare(m_reference.error)},
                {"beyond", Beyond()},
                {"room", Room()},
                {"share_more", m_more / values},
                {"mse_more", m_more == 0.0 ? 0.0 : std::max(0.0, m_sumOfMore / m_more)}};
    }

  private:
    double Beyond() const
    {
        const double bound = 2.0 * std::sqrt(m_variance);
        return double(std::count_if(m_worst.begin(), m_worst.end(), [=](double worst) { return worst > bound; })) / double(m_worst.size());
    }

    /// Factor by which the squared errors could grow until 5 % of the pixels are beyond.
    double Room() const
    {
        std::vector<double> worst = m_worst;
        const auto one = worst.begin() + std::ptrdiff_t(0.95 * double(worst.size()));
        std::nth_element(worst.begin(), one, worst.end());
        return 4.0 * m_variance / std::max(1e-12, *one * *one);
    }

    const Reference& m_reference;
    double m_variance, m_moreThan;
    int m_pictures = 0;
    std::vector<double> m_worst;  ///< greatest error of each pixel's colours
    double m_sum = 0.0, m_sumOfMore = 0.0, m_more = 0.0;
};

struct Arguments
{
    std::string reference, out, without;
    std::vector<std::string> pictures;
    std::vector<int> at;
    std::vector<std::size_t> counts;
    int width = 0, height = 0, side = 8;
    bool unclipped = false;
    double variance = 0.0, moreThan = 0.0;
};

void MakeReference(const Arguments& arguments)
{
    std::vector<Picture> batches;
    for (const std::string& path : arguments.pictures)
    {
        const Picture batch = witness::ReadPicture(path);
        batches.push_back(Inner(arguments.unclipped ? batch : Clipped(batch), arguments.width, arguments.height));
    }
    witness::WriteReference(arguments.out, witness::Average(batches));
}

void PrintErrors(const Arguments& arguments)
{
    const Reference reference = Clipped(witness::ReadReference(arguments.reference));
    for (const std::string& path : arguments.pictures)
    {
        json line = Errors(Inner(Clipped(witness::ReadPicture(path)), reference.mean.width, reference.mean.height, arguments.at),
                           reference);
        line["picture"] = path;
        std::cout << line.dump() << '\n';
    }
}

void PrintClaims(const Arguments& arguments)
{
    const Reference bright = witness::ReadReference(arguments.reference), reference = Clipped(bright);
    const auto inner = [&](const Picture& picture) { return Inner(picture, reference.mean.width, reference.mean.height); };
    Claims claims(reference, arguments.variance, arguments.moreThan);
    double squares = 0.0;
    for (const std::string& path : arguments.pictures)
    {
        const std::string layers = path.substr(0, path.rfind('.')) + ".layers.exr";
        const Picture picture = inner(witness::ReadPicture(path));
        claims.Add(Clipped(picture), inner(witness::ReadChannel(layers, "samples")));
        squares += MeanRelativeSquare(picture, bright);
    }
    json found = claims.Found();
    found["true"] = std::sqrt(std::max(0.0, squares / double(arguments.pictures.size())));
    std::cout << found.dump() << '\n';
}

void PrintLamps(const Arguments& arguments)
{
    const Picture with = witness::ReadReference(arguments.reference).mean, without = witness::ReadReference(arguments.without).mean;
    const LampLight light(with, without);
    for (const std::string& path : arguments.pictures)
    {
        const LampLight::Kept kept = light.Of(witness::ReadPicture(path));
        std::cout << json{{"kept", kept.share}, {"dark", kept.dark}, {"disc_pixels", kept.discPixels}}.dump() << '\n';
    }
}

void PrintGroups(const Arguments& arguments)
{
    const Reference reference = Clipped(witness::ReadReference(arguments.reference));
    const int width = reference.mean.width, height = reference.mean.height, side = arguments.side;
    const int across = (width + side - 1) / side, down = (height + side - 1) / side;
    for (const std::string& path : arguments.pictures)
    {
        const Picture picture = Inner(Clipped(witness::ReadPicture(path)), width, height);
        std::vector<double> squares(std::size_t(across) * down, 0.0);
        for (std::size_t i = 0; i < picture.Size(); ++i)
        {
            const int pixel = int(i / 3), x = pixel % width, y = pixel / width;
            const double off = picture.values[i] - reference.mean.values[i], own = reference.error.values[i];
            squares[std::size_t(y / side) * across + std::size_t(x / side)] += off * off - own * own;
        }
        std::cout << json{{"squares", squares}, {"reference_mse", MeanSquare(reference.error)}}.dump() << '\n';
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
        json line = Errors(Clipped(std::move(mean)), reference);
        line["count"] = i + 1;
        std::cout << line.dump() << '\n';
    }
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app{"Errors of pictures against a reference"};
    app.require_subcommand(1);
    Arguments arguments;
    CLI::App* reference = app.add_subcommand("reference", "mean and standard error of independent pictures");
    reference->add_option("out", arguments.out)->required();
    reference
        ->add_option("--size",
                     [&](const std::vector<std::string>& size)
    {
        arguments.width = std::stoi(size[0]), arguments.height = std::stoi(size[1]);
        return true;
    }, "width and height of the inner part")
        ->expected(2)
        ->required();
    reference->add_option("pictures", arguments.pictures)->required();
    reference->add_flag("--unclipped", arguments.unclipped, "keep what is above white");
    CLI::App* errors = app.add_subcommand("errors", "each picture against the reference");
    errors->add_option("reference", arguments.reference)->required();
    errors->add_option("pictures", arguments.pictures)->required();
    errors->add_option("--at", arguments.at, "where the part begins that is compared")->delimiter(',')->expected(2);
    CLI::App* claims = app.add_subcommand("claims", "whether independent pictures keep what they promise");
    claims->add_option("reference", arguments.reference)->required();
    claims->add_option("pictures", arguments.pictures)->required()->expected(2, 1000);
    claims->add_option("--variance", arguments.variance)->required();
    claims->add_option("--more-than", arguments.moreThan, "samples")->required();
    CLI::App* prefixes = app.add_subcommand("prefixes", "means of the first pictures");
    prefixes->add_option("reference", arguments.reference)->required();
    prefixes->add_option("pictures", arguments.pictures)->required();
    prefixes->add_option("--counts", arguments.counts)->delimiter(',')->required();
    CLI::App* lamps = app.add_subcommand("lamps", "the light of lamps that each picture keeps");
    lamps->add_option("reference", arguments.reference)->required();
    lamps->add_option("without", arguments.without, "a reference of the scene without lamps")->required();
    lamps->add_option("pictures", arguments.pictures)->required();
    CLI::App* groups = app.add_subcommand("groups", "squared errors in groups of pixels");
    groups->add_option("reference", arguments.reference)->required();
    groups->add_option("pictures", arguments.pictures)->required();
    groups->add_option("--side", arguments.side, "pixels")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try
    {
        std::cout.precision(9);
        if (*reference)
            MakeReference(arguments);
        else if (*errors)
            PrintErrors(arguments);
        else if (*claims)
            PrintClaims(arguments);
        else if (*lamps)
            PrintLamps(arguments);
        else if (*groups)
            PrintGroups(arguments);
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
