// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Renders a case of tests/oracle/cases with the unpatched program, or shows its solved camera.

#include <fstream>
#include <iostream>
#include <tuple>
#include <utility>

#include <CLI/CLI.hpp>

#include "oracle_render.h"

namespace
{

using nlohmann::json;

witness::OracleCase LoadCase(const std::string& path)
{
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error("cannot open " + path);
    try
    {
        return witness::ReadCase(json::parse(file));
    }
    catch (const std::exception& error)
    {
        throw std::runtime_error(path + ": " + error.what());
    }
}

json Triple(const witness::Vector& v)
{
    return {v.x, v.y, v.z};
}

void ShowCamera(const std::string& path)
{
    const witness::OracleCase description = LoadCase(path);
    const witness::CameraSolved camera = witness::SolveCase(description.camera,
                                                            static_cast<double>(description.width) / description.height);
    std::cout << json{{"location", Triple(camera.location)}, {"direction", Triple(camera.direction)},
                      {"right", Triple(camera.right)},       {"up", Triple(camera.up)},
                      {"focus", Triple(camera.focus)},       {"lens_normal", Triple(camera.lensNormal)},
                      {"lens_x", Triple(camera.lensX)},      {"lens_y", Triple(camera.lensY)},
                      {"focal_length", camera.focalLength},  {"film_distance", camera.filmDistance}}
                     .dump(2)
              << '\n';
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Renders tilted lenses with the unpatched POV-Ray, one pinhole at a time.");
    app.require_subcommand(1);
    std::string casePath, output;
    witness::RenderSettings settings;

    CLI::App* camera = app.add_subcommand("camera", "print the camera that a case describes");
    camera->add_option("case", casePath, "case, JSON")->required();

    CLI::App* render = app.add_subcommand("render", "render a case");
    render->add_option("case", casePath, "case, JSON")->required();
    render->add_option("output", output, "OpenEXR picture of mean and standard error")->required();
    render->add_option("--povray", settings.povray, "the unpatched program")->capture_default_str();
    render->add_option("--work", settings.work, "folder for frames")->required();
    render->add_option("--batches", settings.batches, "independent sets of points")->capture_default_str()->check(CLI::Range(1, 1024));
    render->add_option("--samples", settings.samples, "points in a set")->capture_default_str()->check(CLI::Range(1, 65536));
    render->add_option("--processes", settings.processes, "side by side")->capture_default_str()->check(CLI::Range(1, 64));
    render->add_option("--seed", settings.seed, "of the first set")->capture_default_str();
    std::pair<int, int> pixels;
    CLI::Option* size = render->add_option("--size", pixels, "width and height instead of the case's");
    CLI11_PARSE(app, argc, argv);

    try
    {
        if (*camera)
        {
            ShowCamera(casePath);
            return 0;
        }
        witness::OracleCase description = LoadCase(casePath);
        if (*size)
            std::tie(description.width, description.height) = pixels;
        settings.scenes = std::filesystem::path(casePath).parent_path();
        witness::WriteReference(output, witness::RenderOracle(description, settings));
    }
    catch (const std::exception& error)
    {
        std::cerr << "oracle: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
