// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "box_scene.h"

#include <algorithm>
#include <cmath>

namespace paper
{

using witness::Dot;
using witness::Unit;

namespace
{

const double kTurn = 35.0 * std::acos(-1.0) / 180.0;

bool Odd(const Vector& at)
{
    const auto sum = static_cast<long>(std::floor(at.x) + std::floor(at.y) + std::floor(at.z));
    return sum & 1;
}

double FloorDistance(const Ray& ray)
{
    return ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : HUGE_VAL;
}

} // namespace

BoxScene::BoxScene() : mSun(Unit(Vector{-600.0, 1000.0, -700.0})), mCosine(std::cos(kTurn)), mSine(std::sin(kTurn)) {}

double BoxScene::Distance(const Ray& ray) const
{
    return std::min(HitBox(ray).distance, FloorDistance(ray));
}

Vector BoxScene::Seen(const Ray& ray) const
{
    const Hit box = HitBox(ray);
    const double floor = FloorDistance(ray);
    if (box.distance < floor)
    {
        const Vector at = Local(ray.origin + box.distance * ray.direction) - Vector{0.5, 0.5, 0.5};
        return Lit(ray, box.distance, box.normal, Odd(at) ? Vector{0.12, 0.06, 0.05} : Vector{0.9, 0.72, 0.4});
    }
    if (floor == HUGE_VAL)
        return {0.35, 0.45, 0.6};
    const Vector at = 0.25 * (ray.origin + floor * ray.direction);
    return Lit(ray, floor, {0.0, 1.0, 0.0}, Odd({at.x, 0.0, at.z}) ? Vector{0.05, 0.05, 0.06} : Vector{0.85, 0.83, 0.78});
}

Vector BoxScene::Local(const Vector& v) const
{
    return {mCosine * v.x - mSine * v.z, v.y, mSine * v.x + mCosine * v.z};
}

Vector BoxScene::World(const Vector& v) const
{
    return {mCosine * v.x + mSine * v.z, v.y, -mSine * v.x + mCosine * v.z};
}

BoxScene::Hit BoxScene::HitBox(const Ray& ray) const
{
    const Vector o = Local(ray.origin), d = Local(ray.direction);
    const double origin[] = {o.x, o.y, o.z}, direction[] = {d.x, d.y, d.z};
    const double low[] = {-6.0, 0.0, -6.0}, high[] = {6.0, 8.0, 6.0};
    double enter = 1e-9, leave = HUGE_VAL;
    Vector normal;
    for (int i = 0; i < 3; ++i)
    {
        double a = (low[i] - origin[i]) / direction[i], b = (high[i] - origin[i]) / direction[i];
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
        return {HUGE_VAL, {}};
    return {enter, World(normal)};
}

Vector BoxScene::Lit(const Ray& ray, double distance, const Vector& normal, const Vector& pigment) const
{
    const Vector at = ray.origin + distance * ray.direction;
    double light = std::max(0.0, Dot(normal, mSun));
    if (light > 0.0 && HitBox({at + 1e-6 * normal, mSun}).distance < HUGE_VAL)
        light = 0.0;
    return (0.3 + 0.7 * light) * pigment;
}

} // namespace paper
