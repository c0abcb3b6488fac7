// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Brightness along a line, with differences in 8-bit levels to the first picture; moments of spots, edges, blur, steepness.

#include <cstdio>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brightness.h"
#include "sharpness.h"

namespace
{

using nlohmann::json;

struct LineOptions
{
    std::vector<std::string> pictures, names, colours;
    std::vector<double> line;
    std::string csv, plot, title;
    int points = 0;
    double limit = -1.0;
};

struct Curve
{
    std::string name;
    std::vector<double> levels;
    double difference = 0.0;  ///< to the first curve
};

void WriteCsv(const std::string& path, const std::vector<Curve>& curves, double length)
{
    std::ofstream out(path);
    out << "pixels";
    for (const Curve& curve : curves)
        out << ",\"" << curve.name << '"';
    out << std::fixed << std::setprecision(4) << '\n';
    const std::size_t count = curves.front().levels.size();
    for (std::size_t i = 0; i < count; ++i)
    {
        out << length * static_cast<double>(i) / static_cast<double>(count - 1);
        for (const Curve& curve : curves)
            out << ',' << curve.levels[i];
        out << '\n';
    }
    if (!out.flush())
        throw std::runtime_error("cannot write " + path);
}

/// A quote is written twice.
std::string Quoted(const std::string& text)
{
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? "''" : std::string(1, c);
    return quoted + "'";
}

void WritePlot(const LineOptions& options, const std::vector<Curve>& curves, double length)
{
    std::ostringstream script;
    script << "set terminal svg size 560,260 font 'sans,11' background '#ffffff' noenhanced\n"
           << "set output " << Quoted(options.plot) << "\nset datafile separator ','\n"
           << "set title " << Quoted(options.title) << "\nset xlabel 'pixels along the line'\n"
           << "set ylabel 'level'\nset yrange [0:255]\nset xrange [0:" << length << "]\n"
           << "set key below\nset grid lc rgb '#dddddd'\nplot ";
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
        const std::string colour = i < options.colours.size() ? options.colours[i] : "#000000";
        script << (i ? ", " : "") << Quoted(options.csv) << " using 1:" << i + 2 << " skip 1 with lines lw " << (i ? 1.2 : 3) << " lc rgb "
               << Quoted(colour) << " title " << Quoted(curves[i].name);
    }
    script << '\n';
    std::FILE* gnuplot = popen("gnuplot", "w");
    if (!gnuplot)
        throw std::runtime_error("cannot start gnuplot");
    std::fputs(script.str().c_str(), gnuplot);
    if (pclose(gnuplot) != 0)
        throw std::runtime_error("gnuplot failed; is the package gnuplot-nox installed?");
}

bool RunLine(const LineOptions& options)
{
    const paper::Point from{options.line[0], options.line[1]}, to{options.line[2], options.line[3]};
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const int count = options.points ? options.points : static_cast<int>(std::ceil(length)) + 1;
    std::vector<Curve> curves;
    bool within = true;
    json report = json::array();
    for (std::size_t i = 0; i < options.pictures.size(); ++i)
    {
        Curve curve{i < options.names.size() ? options.names[i] : options.pictures[i],
                    paper::Profile(witness::ReadPicture(options.pictures[i]), from, to, count)};
        if (i > 0)
        {
            curve.difference = paper::AverageDifference(curve.levels, curves.front().levels);
            report.push_back({{"name", curve.name}, {"average_difference", curve.difference}});
            within = within && (options.limit < 0.0 || curve.difference <= options.limit);
        }
        curves.push_back(std::move(curve));
    }
    if (!options.csv.empty())
        WriteCsv(options.csv, curves, length);
    if (!options.plot.empty())
        WritePlot(options, curves, length);
    std::cout << json{{"points", count}, {"against", curves.front().name}, {"curves", report}}.dump() << '\n';
    return within;
}

void RunMoments(const std::string& path)
{
    const witness::Picture picture = witness::ReadPicture(path);
    json result = json::array();
    for (const json& window : json::parse(std::cin))
    {
        const paper::Moments m = paper::MomentsIn(picture, window.at(0).get<int>(), window.at(1).get<int>(), window.at(2).get<int>(),
                                                  window.at(3).get<int>());
        result.push_back({{"sum", m.sum}, {"x", m.centroid.x}, {"y", m.centroid.y}, {"xx", m.xx}, {"xy", m.xy}, {"yy", m.yy}});
    }
    std::cout << result.dump() << '\n';
}

void RunEdges(const std::string& path, int inside, int first, int last)
{
    const witness::Picture picture = witness::ReadPicture(path);
    json result = json::array();
    for (int row = first; row <= last; ++row)
    {
        const paper::Edges edges = paper::EdgesIn(picture, row, inside);
        result.push_back({{"row", row}, {"left", edges.left}, {"right", edges.right}});
    }
    std::cout << result.dump() << '\n';
}

void RunBlur(const std::string& sharpPath, const std::string& blurredPath, double widest)
{
    const witness::Picture sharp = witness::ReadPicture(sharpPath), blurred = witness::ReadPicture(blurredPath);
    json result = json::array();
    for (const json& window : json::parse(std::cin))
    {
        const paper::Blur blur = paper::BlurBetween(
            sharp, blurred, {window.at(0).get<int>(), window.at(1).get<int>(), window.at(2).get<int>(), window.at(3).get<int>()}, widest);
        result.push_back({{"diameter", blur.diameter}, {"residual", blur.residual}});
    }
    std::cout << result.dump() << '\n';
}

CLI::App* AddLine(CLI::App& app, LineOptions& options)
{
    CLI::App* line = app.add_subcommand("line", "brightness along a line; exit code 2 past the limit");
    line->add_option("pictures", options.pictures, "the first is what the others are compared with")->required();
    line->add_option("--from-to", options.line, "x y x y in pixels from the upper left corner")->required()->expected(4);
    line->add_option("--name", options.names, "one for each picture");
    line->add_option("--colour", options.colours, "of each curve, #rrggbb");
    line->add_option("--points", options.points, "on the line; default: one a pixel")->check(CLI::Range(2, 1000000));
    line->add_option("--csv", options.csv, "table to write");
    line->add_option("--plot", options.plot, "SVG to write; needs --csv")->needs("--csv");
    line->add_option("--title", options.title, "of the plot");
    line->add_option("--limit", options.limit, "largest average absolute difference, 8-bit levels");
    return line;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Measures brightness in pictures.");
    app.require_subcommand(1);
    LineOptions options;
    CLI::App* line = AddLine(app, options);
    std::string picture, blurred;
    double widest = 0.0, reach = 0.0;
    std::vector<double> steepLine;
    int inside = 0, first = 0, last = 0;
    CLI::App* moments = app.add_subcommand("moments", "second moments in windows: JSON [[left, top, width, height], ...] on stdin");
    moments->add_option("picture", picture)->required();
    CLI::App* edges = app.add_subcommand("edges", "left and right edge of a bright thing, row by row");
    edges->add_option("picture", picture)->required();
    edges->add_option("--inside", inside, "a column inside of it")->required();
    edges->add_option("--first", first, "row")->required();
    edges->add_option("--last", last, "row")->required();
    CLI::App* blur = app.add_subcommand("blur", "diameter of the disc that makes the second picture of the first, in windows on "
                                                "stdin as for moments");
    blur->add_option("sharp", picture)->required();
    blur->add_option("blurred", blurred)->required();
    blur->add_option("--widest", widest, "pixels")->required();
    CLI::App* steep = app.add_subcommand("steepness", "mean along a line, levels per pixel");
    steep->add_option("picture", picture)->required();
    steep->add_option("--from-to", steepLine, "x y x y in pixels")->required()->expected(4);
    steep->add_option("--reach", reach, "on both sides of the line, pixels")->required();
    CLI11_PARSE(app, argc, argv);
    try
    {
        if (*line)
            return RunLine(options) ? 0 : 2;
        if (*moments)
            RunMoments(picture);
        else if (*blur)
            RunBlur(picture, blurred, widest);
        else if (*steep)
            std::cout << paper::MeanSteepness(witness::ReadPicture(picture), {steepLine[0], steepLine[1]}, {steepLine[2], steepLine[3]},
                                              reach)
                      << '\n';
        else
            RunEdges(picture, inside, first, last);
    }
    catch (const std::exception& error)
    {
        std::cerr << "profile: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
