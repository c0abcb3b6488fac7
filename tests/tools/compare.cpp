// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Compares two pictures: prints a JSON object, exits with a code per kind of failure.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "measure.h"
#include "picture.h"

namespace
{

using nlohmann::json;
using witness::Picture;
using witness::Reference;

enum ExitCode
{
    kOk = 0,
    kFailure = 1,
    kDifferent = 2,
    kMissingReference = 3,
    kMissingPicture = 4,
    kWrongSize = 5,
    kUnreadable = 6,
    kNotFinite = 7
};

struct Arguments
{
    std::string picture, reference, output;
    double rmseMax = 0.0, meanMax = 0.0, localMeanMax = 0.0;
    int zoom = 4;
    witness::ZTestSettings z;
};

struct Verdict
{
    ExitCode code;
    std::string reason;
};

Picture LoadPicture(const std::string& path)
{
    try
    {
        return witness::ReadPicture(path);
    }
    catch (const witness::MissingPicture& error)
    {
        throw Verdict{kMissingPicture, error.what()};
    }
}

Reference LoadReference(const std::string& path)
{
    try
    {
        return witness::ReadReference(path);
    }
    catch (const witness::MissingPicture& error)
    {
        throw Verdict{kMissingReference, error.what()};
    }
}

struct Pair
{
    Picture picture;
    Reference reference;
};

Pair LoadPair(const Arguments& arguments)
{
    Pair pair{{}, LoadReference(arguments.reference)};
    pair.picture = LoadPicture(arguments.picture);
    if (!pair.picture.SameSize(pair.reference.mean))
    {
        std::ostringstream reason;
        reason << "the picture is " << pair.picture.width << " x " << pair.picture.height << ", the reference " << pair.reference.mean.width
               << " x " << pair.reference.mean.height;
        throw Verdict{kWrongSize, reason.str()};
    }
    if (!witness::IsFinite(pair.picture))
        throw Verdict{kNotFinite, "the picture has values that are infinite or not a number"};
    if (!witness::IsFinite(pair.reference.mean) || !witness::IsFinite(pair.reference.error))
        throw Verdict{kNotFinite, "the reference has values that are infinite or not a number"};
    return pair;
}

json Describe(const witness::Figures& figures)
{
    json worst = json::array();
    for (const witness::PixelDifference& pixel : figures.worst)
        worst.push_back({{"x", pixel.x}, {"y", pixel.y}, {"difference", pixel.difference}});
    return {{"rmse", figures.rootMeanSquare},
            {"mean", figures.signedMean},
            {"largest", figures.largest},
            {"largest_local_mean", figures.largestLocalMean},
            {"different_pixels", figures.different},
            {"worst", worst}};
}

[[noreturn]] void Conclude(const json& report, bool same, const std::string& reason)
{
    std::cout << report.dump() << '\n';
    throw Verdict{same ? kOk : kDifferent, same ? "" : reason};
}

void CompareLimits(const Arguments& arguments)
{
    const Pair pair = LoadPair(arguments);
    const witness::Figures figures = Measure(pair.picture, pair.reference.mean);
    json report = Describe(figures);
    std::ostringstream reason;
    if (!(figures.rootMeanSquare <= arguments.rmseMax))
        reason << "RMSE " << figures.rootMeanSquare << " is over " << arguments.rmseMax << "; ";
    if (!(std::fabs(figures.signedMean) <= arguments.meanMax))
        reason << "signed mean " << figures.signedMean << " is over " << arguments.meanMax << "; ";
    if (arguments.localMeanMax > 0.0 && !(figures.largestLocalMean <= arguments.localMeanMax))
        reason << "local mean " << figures.largestLocalMean << " is over " << arguments.localMeanMax << "; ";
    Conclude(report, reason.str().empty(), reason.str());
}

void CompareNoisy(const Arguments& arguments)
{
    const Pair pair = LoadPair(arguments);
    json report = Describe(Measure(pair.picture, pair.reference.mean));
    const witness::ZTest test = TestNoisy(pair.picture, pair.reference, arguments.z);
    report["z"] = {{"passing", test.passing},
                   {"largest", test.largest},
                   {"pixel_limit", test.pixelLimit},
                   {"largest_box", test.largestBox},
                   {"box_limit", test.boxLimit}};
    std::ostringstream reason;
    reason << 100.0 * test.passing << " % of the pixels are within " << test.pixelLimit << " standard errors; the worst box is off by "
           << test.largestBox << ", allowed " << test.boxLimit;
    Conclude(report, test.passed, reason.str());
}

void CompareExact(const Arguments& arguments)
{
    const Pair pair = LoadPair(arguments);
    std::ostringstream a, b;
    witness::WritePixels(arguments.picture, a);
    witness::WritePixels(arguments.reference, b);
    json report = Describe(Measure(pair.picture, pair.reference.mean));
    Conclude(report, a.str() == b.str(), "the decoded pixels differ");
}

void Preview(const Arguments& arguments)
{
    const Pair pair = LoadPair(arguments);
    Picture difference = pair.picture;
    for (std::size_t i = 0; i < difference.Size(); ++i)
        difference.values[i] = std::fabs(16.0 * (pair.picture.values[i] - pair.reference.mean.values[i]));
    witness::WritePreview(arguments.output + "/new.png", pair.picture, arguments.zoom);
    witness::WritePreview(arguments.output + "/reference.png", pair.reference.mean, arguments.zoom);
    witness::WritePreview(arguments.output + "/difference.png", difference, arguments.zoom);
    json report = Describe(Measure(pair.picture, pair.reference.mean, 20));
    Conclude(report, true, "");
}

Picture Middle(const Picture& whole, int width, int height)
{
    const int left = (whole.width - width) / 2, top = (whole.height - height) / 2;
    Picture middle{width, height, {}};
    for (int y = 0; y < height; ++y)
    {
        const auto row = whole.values.begin() + (static_cast<std::size_t>(y + top) * whole.width + left) * 3;
        middle.values.insert(middle.values.end(), row, row + width * 3);
    }
    return middle;
}

void Average(const std::vector<std::string>& paths, const std::string& output)
{
    std::vector<Picture> pictures;
    for (const std::string& path : paths)
    {
        const Picture whole = LoadPicture(path);
        const int width = pictures.empty() ? whole.width : pictures.front().width;
        const int height = pictures.empty() ? whole.height : pictures.front().height;
        if (whole.width < width || whole.height < height || (whole.width - width) % 2 != 0 || (whole.height - height) % 2 != 0)
            throw Verdict{kWrongSize, path + " does not have " + paths.front() + " as its middle"};
        if (!witness::IsFinite(whole))
            throw Verdict{kNotFinite, path + " has values that are infinite or not a number"};
        pictures.push_back(Middle(whole, width, height));
    }
    witness::WriteReference(output, witness::Average(pictures));
}

void ShowError(const std::string& path)
{
    const Reference reference = LoadReference(path);
    double squares = 0.0;
    for (const double error : reference.error.values)
        squares += error * error;
    const json report = {{"standard_error", std::sqrt(squares / static_cast<double>(reference.error.Size()))},
                         {"batches", reference.batches}};
    std::cout << report.dump() << '\n';
}

/// Answers each picture's name with the number of bytes of WritePixels(), then these; or with a line "failed: ".
void AnswerWithPixels()
{
    for (std::string path; std::getline(std::cin, path); std::cout.flush())
        try
        {
            std::ostringstream pixels;
            witness::WritePixels(path, pixels);
            const std::string text = pixels.str();
            std::cout << text.size() << '\n' << text;
        }
        catch (const std::exception& error)
        {
            std::string why = error.what();
            std::replace(why.begin(), why.end(), '\n', ' ');
            std::cout << "failed: " << why << '\n';
        }
}

void AddPair(CLI::App* command, Arguments& arguments)
{
    command->add_option("picture", arguments.picture, "the new picture")->required();
    command->add_option("reference", arguments.reference, "what it is compared with")->required();
}

/// @throws Verdict
void Run(int argc, char** argv)
{
    CLI::App app("Compares pictures. Exit codes: 0 same, 1 failure, 2 different, 3 reference missing, "
                 "4 picture missing, 5 wrong size, 6 unreadable, 7 not finite.");
    app.require_subcommand(1);
    Arguments arguments;
    std::vector<std::string> pictures;

    CLI::App* limits = app.add_subcommand("limits", "RMSE and signed mean within limits");
    AddPair(limits, arguments);
    limits->add_option("--rmse-max", arguments.rmseMax, "linear, all channels")->required();
    limits->add_option("--mean-max", arguments.meanMax, "absolute")->required();
    limits->add_option("--local-mean-max", arguments.localMeanMax, "over 8 by 8 pixels; 0: not looked at");
    CLI::App* noisy = app.add_subcommand("noisy", "z-test against a reference with standard errors");
    AddPair(noisy, arguments);
    noisy->add_option("--floor", arguments.z.floor, "least standard error")->capture_default_str();
    CLI::App* exact = app.add_subcommand("exact", "equality of the decoded pixels");
    AddPair(exact, arguments);
    CLI::App* preview = app.add_subcommand("preview", "new.png, reference.png, difference.png (x 16) for people");
    AddPair(preview, arguments);
    preview->add_option("folder", arguments.output, "existing folder")->required();
    preview->add_option("--zoom", arguments.zoom, "width of a pixel")->capture_default_str()->check(CLI::Range(1, 64));
    CLI::App* pixels = app.add_subcommand("pixels", "write the decoded pixels to the standard output");
    pixels->add_option("picture", arguments.picture, "picture; without it, those that the standard input names");
    CLI::App* error = app.add_subcommand("error", "root mean square of a reference's standard errors");
    error->add_option("picture", arguments.reference, "reference")->required();
    CLI::App* average = app.add_subcommand("average", "mean and standard error of independent pictures");
    average->add_option("output", arguments.output, "OpenEXR picture")->required();
    average->add_option("pictures", pictures, "pictures of one size")->required();

    try
    {
        app.parse(argc, argv);
    }
    catch (const CLI::ParseError& wrong)
    {
        throw Verdict{app.exit(wrong) == 0 ? kOk : kFailure, ""};
    }
    if (*limits)
        CompareLimits(arguments);
    else if (*noisy)
        CompareNoisy(arguments);
    else if (*exact)
        CompareExact(arguments);
    else if (*preview)
        Preview(arguments);
    else if (*pixels && arguments.picture.empty())
        AnswerWithPixels();
    else if (*pixels)
        witness::WritePixels(arguments.picture, std::cout);
    else if (*error)
        ShowError(arguments.reference);
    else
        Average(pictures, arguments.output);
}

} // namespace

int main(int argc, char** argv)
{
    Verdict verdict{kOk, ""};
    try
    {
        Run(argc, argv);
    }
    catch (const Verdict& end)
    {
        verdict = end;
    }
    catch (const witness::MissingPicture& error)
    {
        verdict = {kMissingPicture, error.what()};
    }
    catch (const witness::UnreadablePicture& error)
    {
        verdict = {kUnreadable, error.what()};
    }
    catch (const std::exception& error)
    {
        verdict = {kFailure, error.what()};
    }
    if (!verdict.reason.empty())
        std::cerr << "compare: " << verdict.reason << '\n';
    return verdict.code;
}
