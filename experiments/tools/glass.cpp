// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The box scene by a tilted lens of glass: rays from each pixel through every surface. --model: an ideal lens with some properties
// (double_gauss_camera.h); --line: the rays' displacement by each property, in pixels.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "box_scene.h"
#include "double_gauss_camera.h"
#include "lens_points.h"
#include "picture.h"

namespace
{

using nlohmann::json;
using paper::GlassCamera;
using paper::Model;
using paper::Ray;
using paper::Vector;

const std::map<std::string, Model> kModelNames = {
    {"thin", Model::Thin}, {"distortion", Model::Distortion}, {"field", Model::Field}, {"pupil", Model::Pupil}, {"glass", Model::Glass}};

/// Lines x y x y ...
bool Near(const std::vector<double>& lines, double reach, double x, double y)
{
    for (std::size_t i = 0; i + 3 < lines.size(); i += 4)
    {
        const double dx = lines[i + 2] - lines[i], dy = lines[i + 3] - lines[i + 1];
        const double u = x - lines[i], v = y - lines[i + 1];
        const double t = std::clamp((u * dx + v * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        if (std::hypot(u - t * dx, v - t * dy) <= reach)
            return true;
    }
    return false;
}

/// Black beyond `reach` of the lines, if there are any.
witness::Picture Photograph(const paper::Setting& setting, const GlassCamera& camera, Model model, int samples,
                            const std::vector<double>& lines, double reach)
{
    const paper::BoxScene scene;
    witness::Picture picture{setting.width, setting.height, {}};
    for (int row = 0; row < setting.height; ++row)
        for (int column = 0; column < setting.width; ++column)
        {
            if (reach > 0.0 && !Near(lines, reach, column + 0.5, row + 0.5))
            {
                picture.values.insert(picture.values.end(), 3, 0.0);
                continue;
            }
            Vector sum;
            int arrived = 0;
            const auto seed = static_cast<std::uint32_t>(row * setting.width + column + 1);
            for (const witness::LensPoint& p : witness::LensPoints(samples, seed, 0, 0.0))
                if (const auto ray = camera.Shoot(model, column + 0.5 + p.jitterX, row + 0.5 + p.jitterY, p.a, p.b))
                {
                    sum = sum + scene.Seen(*ray);
                    ++arrived;
                }
            if (arrived == 0)
                throw std::runtime_error("a pixel that no ray leaves");
            // no vignetting, as in POV-Ray
            sum = (1.0 / arrived) * sum;
            picture.values.insert(picture.values.end(), {sum.x, sum.y, sum.z});
        }
    return picture;
}

double Between(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1]);
}

/// Mean distances, pixels, at the visible surface: between successive models, first and last, character and last.
json MeasureLine(const GlassCamera& camera, const paper::Character& character, double x0, double y0, double x1, double y1)
{
    const paper::BoxScene scene;
    const int places = 40, rays = 128;
    double steps[paper::kModels] = {};  // the last: from the thin lens to the glass
    double fromCharacter = 0.0;
    int passed = 0, vignetted = 0;
    for (int i = 0; i < places; ++i)
    {
        const double t = (i + 0.5) / places, x = x0 + t * (x1 - x0), y = y0 + t * (y1 - y0);
        const auto chief = camera.Shoot(Model::Thin, x, y, 0.0, 0.0);
        if (!chief)
            throw std::runtime_error("a line that leaves what the lens shows");
        const double depth = camera.Depth(chief->origin + scene.Distance(*chief) * chief->direction);
        for (const witness::LensPoint& p : witness::LensPoints(rays, i + 1, 0, 0.0))
        {
            vignetted += camera.Vignetted(x, y, p.a, p.b);
            const auto all = camera.ShootAll(x, y, p.a, p.b);
            if (!all)
                continue;
            ++passed;
            std::array<double, 2> met[paper::kModels];
            for (int m = 0; m < paper::kModels; ++m)
                met[m] = camera.PixelAt((*all)[m], depth);
            for (int m = 0; m + 1 < paper::kModels; ++m)
                steps[m] += Between(met[m], met[m + 1]);
            steps[paper::kModels - 1] += Between(met[0], met[paper::kModels - 1]);
            const auto like = camera.ShootCharacter(character, x, y, p.a, p.b);
            fromCharacter += Between(camera.PixelAt(*like, depth), met[paper::kModels - 1]);
        }
    }
    for (double& step : steps)
        step /= passed;
    return {{"distortion", steps[0]},
            {"field", steps[1]},
            {"pupil", steps[2]},
            {"rest", steps[3]},
            {"all", steps[4]},
            {"character", fromCharacter / passed},
            {"vignetted", static_cast<double>(vignetted) / (passed + vignetted)}};
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Photographs the box scene through a lens of glass.");
    paper::Setting setting;
    std::string output;
    Model model = Model::Glass;
    int samples = 256;
    std::vector<double> lines;
    double reach = 0.0;
    bool measure = false;
    app.add_option("output", output, "OpenEXR picture")->required();
    app.add_option("--width", setting.width)->capture_default_str()->check(CLI::Range(2, 4096));
    app.add_option("--height", setting.height)->capture_default_str()->check(CLI::Range(2, 4096));
    app.add_option("--samples", samples, "rays a pixel")->capture_default_str()->check(CLI::Range(1, 65536));
    app.add_option("--focal-length", setting.focalLength, "mm")->capture_default_str();
    app.add_option("--f-stop", setting.fStop)->capture_default_str();
    app.add_option("--tilt", setting.tilt, "degrees, positive forward")->capture_default_str();
    app.add_option("--moved", setting.moved, "mm of the file by which the first element stands farther forward");
    app.add_option("--film-distance", setting.filmDistance, "mm, from H', on the camera's axis")->required();
    app.add_option("--model", model, "thin, distortion, field, pupil or glass")->transform(CLI::CheckedTransformer(kModelNames));
    app.add_option("--line", lines, "x y x y ...: lines of the film, pixels");
    app.add_option("--reach", reach, "photograph only so many pixels on both sides of the lines");
    app.add_flag("--measure", measure, "how far aside the rays of the lines go");
    CLI11_PARSE(app, argc, argv);
    try
    {
        const GlassCamera camera(setting, model == Model::Thin && !measure);
        witness::WriteReference(output, witness::Average({Photograph(setting, camera, model, samples, lines, reach)}));
        const paper::Character character = measure ? camera.Fitted() : paper::Character{};
        json measured = json::array();
        for (std::size_t i = 0; measure && i + 3 < lines.size(); i += 4)
            measured.push_back(MeasureLine(camera, character, lines[i], lines[i + 1], lines[i + 2], lines[i + 3]));
        std::cout << json{{"lines", measured},
                          {"character",
                           {{"distortion", {character.distortion1, character.distortion2, character.distortionNear}},
                            {"left", {character.leftWithoutNear, character.left}},
                            {"field_curvature", character.fieldCurvature}}},
                          {"separation", camera.Glass().Separation()},
                          {"entrance_pupil", camera.Glass().EntrancePupil()},
                          {"exit_pupil", camera.Glass().ExitPupil()}}
                         .dump()
                  << '\n';
    }
    catch (const std::exception& error)
    {
        std::cerr << "glass: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
