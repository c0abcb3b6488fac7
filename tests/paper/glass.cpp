// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A second "photograph" of the box scene, by a lens of glass tilted as a whole: rays from each
// pixel of the film through every refracting surface to the scene of scenes/paper/box_objects.inc,
// of which this is a second description. With --thin an ideal thin lens instead, which shows that
// the two descriptions of the scene are the same.

#include <cmath>
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "glass_lens.h"
#include "lens_points.h"
#include "picture.h"

namespace
{

using paper::Ray;
using witness::Cross;
using witness::Dot;
using witness::Unit;
using witness::Vector;

const double kPi = std::acos(-1.0);

struct Setting
{
    int width = 240, height = 160, samples = 256;
    double focalLength = 50.0, fStop = 2.8, tilt = 0.0, filmDistance = 0.0, sceneUnit = 10.0;
    bool thin = false;
};

/// box_objects.inc: even light and sunlight on a board and a box, centimetres.
class BoxScene
{
  public:
    Vector Seen(const Ray& ray) const
    {
        const Hit box = HitBox(ray);
        const double floor = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : HUGE_VAL;
        if (box.distance < floor)
        {
            const Vector at =
                Local(ray.origin + box.distance * ray.direction) - Vector{0.5, 0.5, 0.5};
            return Lit(ray, box.distance, box.normal,
                       Odd(at) ? Vector{0.12, 0.06, 0.05} : Vector{0.9, 0.72, 0.4});
        }
        if (floor == HUGE_VAL)
            return {0.35, 0.45, 0.6};
        const Vector at = 0.25 * (ray.origin + floor * ray.direction);
        return Lit(ray, floor, {0.0, 1.0, 0.0},
                   Odd({at.x, 0.0, at.z}) ? Vector{0.05, 0.05, 0.06} : Vector{0.85, 0.83, 0.78});
    }

  private:
    struct Hit
    {
        double distance = HUGE_VAL;
        Vector normal;  ///< world
    };

    static bool Odd(const Vector& at)
    {
        const auto sum = static_cast<long>(std::floor(at.x) + std::floor(at.y) + std::floor(at.z));
        return sum & 1;
    }

    /// From the world into the box's own axes, where it is not rotated.
    Vector Local(const Vector& v) const
    {
        return {mCosine * v.x - mSine * v.z, v.y, mSine * v.x + mCosine * v.z};
    }
    Vector World(const Vector& v) const
    {
        return {mCosine * v.x + mSine * v.z, v.y, -mSine * v.x + mCosine * v.z};
    }

    Hit HitBox(const Ray& ray) const
    {
        const Vector o = Local(ray.origin), d = Local(ray.direction);
        const double origin[] = {o.x, o.y, o.z}, direction[] = {d.x, d.y, d.z};
        const double low[] = {-6.0, 0.0, -6.0}, high[] = {6.0, 8.0, 6.0};
        double enter = 1e-9, leave = HUGE_VAL;
        Vector normal;
        for (int i = 0; i < 3; ++i)
        {
            double a = (low[i] - origin[i]) / direction[i],
                   b = (high[i] - origin[i]) / direction[i];
            const double side = a < b ? -1.0 : 1.0;
            if (a > b)
                std::swap(a, b);
            if (a > enter)
            {
                enter = a;
                normal = {i == 0 ? side : 0.0, i == 1 ? side : 0.0, i == 2 ? side : 0.0};
            }
            leave = std::min(leave, b);
        }
        if (enter >= leave || Dot(normal, normal) == 0.0)
            return {};
        return {enter, World(normal)};
    }

    Vector Lit(const Ray& ray, double distance, const Vector& normal, const Vector& pigment) const
    {
        const Vector at = ray.origin + distance * ray.direction;
        double light = std::max(0.0, Dot(normal, mSun));
        if (light > 0.0 && HitBox({at + 1e-6 * normal, mSun}).distance < HUGE_VAL)
            light = 0.0;
        return (0.3 + 0.7 * light) * pigment;
    }

    const Vector mSun = Unit({-600.0, 1000.0, -700.0});
    const double mCosine = std::cos(35.0 * kPi / 180.0), mSine = std::sin(35.0 * kPi / 180.0);
};

/// Film and lens of box_camera.inc. Camera frame in mm: lens centre (thin) or H (glass) at
/// the origin.
class Camera
{
  public:
    explicit Camera(const Setting& setting)
        : mSetting(setting), mGlass(setting.focalLength, setting.fStop)
    {
        mAxis = Unit(Vector{0.0, 3.0, 0.0} - mLocation);
        mRight = Unit(Cross({0.0, 1.0, 0.0}, mAxis));
        mUp = Cross(mAxis, mRight);
        const double angle = setting.tilt * kPi / 180.0;
        mLensUp = {0.0, std::cos(angle), std::sin(angle)};
        mLensAxis = {0.0, -std::sin(angle), std::cos(angle)};
    }

    const paper::GlassLens& Glass() const { return mGlass; }

    /// A ray into the scene, world, scene units; nothing where the lens stops it.
    std::optional<Ray> Shoot(double x, double y, double a, double b) const
    {
        const double s = mSetting.filmDistance, height = 36.0 * mSetting.height / mSetting.width;
        const Vector chief{36.0 / s * (x / mSetting.width - 0.5),
                           height / s * (0.5 - y / mSetting.height), 1.0};
        std::optional<Ray> ray = mSetting.thin ? Thin(chief, a, b) : Thick(chief, a, b);
        if (!ray)
            return std::nullopt;
        return Ray{mLocation + (1.0 / mSetting.sceneUnit) * World(ray->origin),
                   World(ray->direction)};
    }

    /// The pixel whose chief ray meets a point of the scene: where the picture shows it.
    std::pair<double, double> Locate(const Vector& point) const
    {
        const auto pinhole = [this](const Vector& at)
        {
            const Vector d = at - mLocation;
            const double scale = mSetting.filmDistance / 36.0 * mSetting.width / Dot(d, mAxis);
            return std::pair<double, double>{0.5 * mSetting.width + scale * Dot(d, mRight),
                                             0.5 * mSetting.height - scale * Dot(d, mUp)};
        };
        const auto wanted = pinhole(point);
        std::pair<double, double> pixel = wanted;
        for (int i = 0; i < 20; ++i)
        {
            const auto ray = Shoot(pixel.first, pixel.second, 0.0, 0.0);
            if (!ray)
                throw std::runtime_error("the lens does not show this point");
            const double step = Dot(point - ray->origin, mAxis) / Dot(ray->direction, mAxis);
            const auto met = pinhole(ray->origin + step * ray->direction);
            pixel.first += wanted.first - met.first;
            pixel.second += wanted.second - met.second;
        }
        return pixel;
    }

  private:
    Vector World(const Vector& v) const { return v.x * mRight + v.y * mUp + v.z * mAxis; }
    Vector FromLens(const Vector& v) const
    {
        return Vector{v.x, 0.0, 0.0} + v.y * mLensUp + v.z * mLensAxis;
    }
    Vector ToLens(const Vector& v) const { return {v.x, Dot(v, mLensUp), Dot(v, mLensAxis)}; }

    /// Through an ideal lens: from its point toward the image of the film point, 1/u + 1/v = 1/f.
    std::optional<Ray> Thin(const Vector& chief, double a, double b) const
    {
        const double radius = 0.5 * mSetting.focalLength / mSetting.fStop;
        const Vector point = FromLens({radius * a, radius * b, 0.0});
        const double v = mSetting.filmDistance * Dot(chief, mLensAxis), f = mSetting.focalLength;
        const Vector image = (f / (v - f) * mSetting.filmDistance) * chief;
        return Ray{point, Unit(image - point)};
    }

    std::optional<Ray> Thick(const Vector& chief, double a, double b) const
    {
        const Vector film =
            ToLens(-mSetting.filmDistance * chief) - Vector{0.0, 0.0, mGlass.Separation()};
        // a little more than the paraxial pupil: the stop decides
        const double radius = 1.15 * mGlass.PupilRadius();
        const Vector aim{radius * a, radius * b, mGlass.ExitPupil()};
        Vector direction = Unit(aim - film);
        if (direction.z < 0.0)
            direction = -1.0 * direction;
        const std::optional<Ray> out = mGlass.Trace({film, direction});
        if (!out)
            return std::nullopt;
        return Ray{FromLens(out->origin), FromLens(out->direction)};
    }

    Setting mSetting;
    paper::GlassLens mGlass;
    const Vector mLocation{0.0, 32.0, -50.0};
    Vector mAxis, mRight, mUp, mLensUp, mLensAxis;
};

witness::Picture Photograph(const Setting& setting, const Camera& camera)
{
    const BoxScene scene;
    witness::Picture picture{setting.width, setting.height, {}};
    for (int row = 0; row < setting.height; ++row)
        for (int column = 0; column < setting.width; ++column)
        {
            Vector sum;
            int arrived = 0;
            const auto seed = static_cast<std::uint32_t>(row * setting.width + column + 1);
            for (const witness::LensPoint& p : witness::LensPoints(setting.samples, seed, 0, 0.0))
                if (const auto ray =
                        camera.Shoot(column + 0.5 + p.jitterX, row + 0.5 + p.jitterY, p.a, p.b))
                {
                    sum = sum + scene.Seen(*ray);
                    ++arrived;
                }
            if (arrived == 0)
                throw std::runtime_error("a pixel that no ray leaves");
            // The mean over the rays that pass: no vignetting, no fall-off of light, as in POV-Ray.
            sum = (1.0 / arrived) * sum;
            picture.values.insert(picture.values.end(), {sum.x, sum.y, sum.z});
        }
    return picture;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Photographs the box scene through a lens of glass.");
    Setting setting;
    std::string output;
    app.add_option("output", output, "OpenEXR picture")->required();
    app.add_option("--width", setting.width)->capture_default_str()->check(CLI::Range(2, 4096));
    app.add_option("--height", setting.height)->capture_default_str()->check(CLI::Range(2, 4096));
    app.add_option("--samples", setting.samples, "rays a pixel")
        ->capture_default_str()
        ->check(CLI::Range(1, 65536));
    app.add_option("--focal-length", setting.focalLength, "mm")->capture_default_str();
    app.add_option("--f-stop", setting.fStop)->capture_default_str();
    app.add_option("--tilt", setting.tilt, "degrees, positive forward")->capture_default_str();
    app.add_option("--film-distance", setting.filmDistance, "mm, from H', on the camera's axis")
        ->required();
    std::vector<double> points;
    app.add_option("--locate", points, "x y z ...: points of the scene to find in the picture");
    app.add_flag("--thin", setting.thin, "an ideal thin lens in its place");
    CLI11_PARSE(app, argc, argv);
    try
    {
        const Camera camera(setting);
        witness::WriteReference(output, witness::Average({Photograph(setting, camera)}));
        nlohmann::json located = nlohmann::json::array();
        for (std::size_t i = 0; i + 2 < points.size(); i += 3)
        {
            const auto [x, y] = camera.Locate({points[i], points[i + 1], points[i + 2]});
            located.push_back({x, y});
        }
        std::cout << nlohmann::json{{"located", located},
                                    {"focal_length", camera.Glass().FocalLength()},
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
