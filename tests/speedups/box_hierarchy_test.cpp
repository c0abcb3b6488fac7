// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "speedups/box_hierarchy.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace speedups
{
namespace
{

struct RayOfTest
{
    std::array<double, 3> origin, direction;
};

/// Extended precision: 0 from inside, infinity for a miss. Touching counts.
long double EntryOf(const BoxItem& item, const RayOfTest& ray)
{
    const long double never = std::numeric_limits<long double>::infinity();
    long double enter = 0.0L, leave = never;
    for (int axis = 0; axis < 3; axis++)
    {
        const long double from = ray.origin[axis], slope = ray.direction[axis];
        const long double lower = item.lower[axis] - from, upper = item.upper[axis] - from;
        if (slope == 0.0L)
        {
            if (lower > 0.0L || upper < 0.0L)
                return never;
            continue;
        }
        enter = std::max(enter, std::min(lower / slope, upper / slope));
        leave = std::min(leave, std::max(lower / slope, upper / slope));
    }
    return enter <= leave ? enter : never;
}

class Scene
{
  public:
    explicit Scene(std::vector<BoxItem> itsItems) : items(std::move(itsItems)), hierarchy(Numbered()) {}

    std::vector<BoxItem> items;
    BoxHierarchy hierarchy;

    std::multiset<long> Visited(const RayOfTest& ray, double limit) const
    {
        std::multiset<long> visited;
        hierarchy.Walk<Float4>(ray.origin.data(), ray.direction.data(), limit, [&](const void* what) { visited.insert(NumberOf(what)); });
        return visited;
    }

    double Nearest(const RayOfTest& ray) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        hierarchy.Walk<Float4>(ray.origin.data(), ray.direction.data(), nearest,
                               [&](const void* what) { nearest = std::min(nearest, double(EntryOf(items[NumberOf(what)], ray))); });
        return nearest;
    }

    void ExpectAllVisited(const RayOfTest& ray, double limit) const
    {
        const std::multiset<long> visited = Visited(ray, limit);
        for (std::size_t i = 0; i < items.size(); i++)
        {
            const long double entry = EntryOf(items[i], ray);
            const bool must = std::isfinite(entry) && entry <= limit;
            EXPECT_GE(visited.count(i), must ? 1u : 0u) << "box " << i;
            EXPECT_LE(visited.count(i), 1u) << "box " << i;
        }
    }

    void ExpectNearestFound(const RayOfTest& ray) const
    {
        long double truth = std::numeric_limits<long double>::infinity();
        for (const BoxItem& item : items)
            truth = std::min(truth, EntryOf(item, ray));
        EXPECT_EQ(Nearest(ray), double(truth));
    }

  private:
    static long NumberOf(const void* what) { return reinterpret_cast<std::intptr_t>(what) - 1; }

    std::vector<BoxItem> Numbered()
    {
        for (std::size_t i = 0; i < items.size(); i++)
            items[i].what = reinterpret_cast<const void*>(i + 1);
        return items;
    }
};

class Dice
{
  public:
    explicit Dice(unsigned int seed) : random(seed) {}

    double Between(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random); }
    double Sign() { return Between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0; }
    double Magnitude(double least, double most) { return Sign() * std::pow(10.0, Between(std::log10(least), std::log10(most))); }

    BoxItem Box(double world, double size)
    {
        BoxItem item;
        for (int axis = 0; axis < 3; axis++)
        {
            item.lower[axis] = float(Between(-world, world));
            item.upper[axis] = item.lower[axis] + float(Between(0.0, size));
        }
        item.what = nullptr;
        return item;
    }

    RayOfTest Ray(double world)
    {
        RayOfTest ray;
        for (int axis = 0; axis < 3; axis++)
        {
            ray.origin[axis] = Between(-world, world);
            ray.direction[axis] = Between(-1.0, 1.0);
        }
        return ray;
    }

    std::mt19937 random;
};

std::vector<BoxItem> Boxes(unsigned int seed, int number, double world, double size)
{
    Dice dice(seed);
    std::vector<BoxItem> items;
    for (int i = 0; i < number; i++)
        items.push_back(dice.Box(world, size));
    return items;
}

TEST(BoxHierarchy, FindsNothingWhenEmpty)
{
    const Scene scene({});
    scene.ExpectNearestFound({{0, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(scene.hierarchy.Bytes(), 0u);
}

TEST(BoxHierarchy, FindsAllAndTheNearest)
{
    for (const int number : {1, 2, 7, 8, 9, 64, 65, 1000, 20000})
    {
        const Scene scene(Boxes(number, number, 10.0, 10.0 / std::cbrt(number)));
        Dice dice(number + 1);
        for (int i = 0; i < (number > 1000 ? 20 : 200); i++)
        {
            const RayOfTest ray = dice.Ray(15.0);
            scene.ExpectAllVisited(ray, std::numeric_limits<double>::infinity());
            scene.ExpectAllVisited(ray, dice.Between(0.0, 20.0));
            scene.ExpectNearestFound(ray);
        }
    }
}

TEST(BoxHierarchy, VisitsFewBoxesInVain)
{
    const Scene scene(Boxes(5, 20000, 10.0, 0.2));
    Dice dice(6);
    std::size_t visited = 0;
    for (int i = 0; i < 100; i++)
    {
        const RayOfTest ray = dice.Ray(10.0);
        double nearest = std::numeric_limits<double>::infinity();
        scene.hierarchy.Walk<Float4>(ray.origin.data(), ray.direction.data(), nearest, [&](const void* what)
        {
            visited++;
            nearest = std::min(nearest, double(EntryOf(scene.items[reinterpret_cast<std::intptr_t>(what) - 1], ray)));
        });
    }
    EXPECT_LT(visited, 400u);
}

TEST(BoxHierarchy, MemoryIsAsDocumented)
{
    for (const int number : {1000, 20000, 100000})
        EXPECT_LE(Scene(Boxes(number, number, 10.0, 0.04)).hierarchy.Bytes(), 110u * number);
}

/// Rounding decides for these rays.
TEST(BoxHierarchy, FindsBoxesByRaysAlongAxesAndOnFaces)
{
    std::vector<BoxItem> items;
    for (int x = -2; x <= 2; x++)
        for (int y = -2; y <= 2; y++)
            for (int z = -2; z <= 2; z++)
                items.push_back({{float(x), float(y), float(z)}, {x + 0.5f, y + 0.5f, float(z + std::abs(x + y) % 2 * 0.5)}, nullptr});
    const Scene scene(items);
    for (int i = 0; i < 27; i++)
        for (int j = 0; j < 125; j++)
        {
            const RayOfTest ray = {{j % 5 * 0.5 - 1.0, j / 5 % 5 * 0.5 - 1.0, j / 25 * 0.5 - 1.0},
                                   {double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 - 1)}};
            if (i != 13)
                scene.ExpectAllVisited(ray, std::numeric_limits<double>::infinity());
        }
}

TEST(BoxHierarchy, FindsBoxesFromTinyToHuge)
{
    Dice dice(11);
    for (int round = 0; round < 200; round++)
    {
        std::vector<BoxItem> items;
        for (int i = 0; i < 30; i++)
        {
            BoxItem item;
            for (int axis = 0; axis < 3; axis++)
            {
                item.lower[axis] = dice.Magnitude(1e-9, 1e12);
                item.upper[axis] = item.lower[axis] + float(std::fabs(dice.Magnitude(1e-9, 1e12)));
            }
            items.push_back(item);
        }
        const Scene scene(items);
        for (const BoxItem& aim : items)
        {
            RayOfTest ray;
            for (int axis = 0; axis < 3; axis++)
            {
                ray.origin[axis] = dice.Magnitude(1e-9, 1e12);
                ray.direction[axis] = (dice.Sign() < 0.0 ? aim.lower : aim.upper)[axis] - ray.origin[axis];
            }
            scene.ExpectAllVisited(ray, std::numeric_limits<double>::infinity());
        }
    }
}

/// Coincident boxes without thickness cannot be split, but the stack suffices.
TEST(BoxHierarchy, FindsCoincidentBoxes)
{
    std::vector<BoxItem> items(5000, BoxItem{{-1, -1, -1}, {1, 1, 1}, nullptr});
    for (int i = 0; i < 3000; i++)
        items.push_back({{-1, -1, -1.0f / (i + 1)}, {1, 1, 1.0f / (i + 1)}, nullptr});
    // bins separate one at a time
    for (int i = 0; i < 60; i++)
        for (int j = 0; j < 3; j++)
            items.push_back({{float(std::pow(10.0, 20 - i)), 0, 0}, {float(std::pow(10.0, 20 - i)), 1, 1}, nullptr});
    const Scene scene(items);
    scene.ExpectAllVisited({{0.1, 0.2, -5}, {0, 0, 1}}, std::numeric_limits<double>::infinity());
    scene.ExpectAllVisited({{-1, 0.5, 0.5}, {1, 0, 0}}, std::numeric_limits<double>::infinity());
    scene.ExpectAllVisited({{3, 4, 5}, {-0.5, -0.7, -0.9}}, std::numeric_limits<double>::infinity());
}

TILT_LENS_FOR_AVX2 unsigned int EnterByAvx2(const EightBoxes& boxes, const RayOfTest& ray, float limit, float* begin)
{
    return BoxRay<Float8>(ray.origin.data(), ray.direction.data()).Enter(boxes, limit, begin);
}

TEST(BoxRay, IsTheSameOnEveryProcessor)
{
    if (!HasAvx2())
        GTEST_SKIP() << "This processor has no AVX2.";
    Dice dice(17);
    for (int round = 0; round < 20000; round++)
    {
        EightBoxes boxes;
        for (int i = 0; i < 8; i++)
            for (int axis = 0; axis < 3; axis++)
            {
                boxes.planes[axis][i] = dice.Magnitude(1e-6, 1e6);
                boxes.planes[axis + 3][i] = boxes.planes[axis][i] + float(std::fabs(dice.Magnitude(1e-6, 1e8)));
            }
        RayOfTest ray = dice.Ray(100.0);
        if (round % 4 == 0)
            ray.direction[round / 4 % 3] = std::copysign(round % 8 == 0 ? 0.0 : 1e-40, dice.Sign());
        const BoxRay<Float4> boxRay(ray.origin.data(), ray.direction.data());
        const float limit = std::fabs(dice.Magnitude(1e-3, 1e9));
        alignas(32) float plain[8], byAvx2[8];
        EXPECT_EQ(boxRay.Enter(boxes, limit, plain), EnterByAvx2(boxes, ray, limit, byAvx2));
        for (int i = 0; i < 8; i++)
            EXPECT_EQ(plain[i], byAvx2[i]);
    }
}

TILT_LENS_FOR_AVX2 std::vector<const void*> WalkByAvx2(const BoxHierarchy& hierarchy, const RayOfTest& ray, double limit)
{
    std::vector<const void*> visited;
    hierarchy.Walk<Float8>(ray.origin.data(), ray.direction.data(), limit, [&](const void* what) { visited.push_back(what); });
    return visited;
}

TEST(BoxHierarchy, IsWalkedAlikeOnEveryProcessor)
{
    if (!HasAvx2())
        GTEST_SKIP() << "This processor has no AVX2.";
    const Scene scene(Boxes(19, 5000, 10.0, 1.0));
    Dice dice(20);
    for (int i = 0; i < 500; i++)
    {
        const RayOfTest ray = dice.Ray(15.0);
        const double limit = dice.Between(0.0, 20.0);
        std::vector<const void*> plain;
        scene.hierarchy.Walk<Float4>(ray.origin.data(), ray.direction.data(), limit, [&](const void* what) { plain.push_back(what); });
        EXPECT_EQ(plain, WalkByAvx2(scene.hierarchy, ray, limit));
    }
}

} // namespace
} // namespace speedups
