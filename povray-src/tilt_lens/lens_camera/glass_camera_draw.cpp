// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Samples rays through a lens of glass, four side by side.

#include "tilt_lens/lens_camera/glass_camera.h"

#include <algorithm>
#include <array>

#include "tilt_lens/camera/frame_table.h"
#include "tilt_lens/camera/partly_covered.h"
#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// Least axial component of a ray's direction, which scales the direction.
constexpr double kLeastAlong = 0.01;

template<class Number>
TILT_LENS_INLINED VecOf<Number> AlongAxes(const VecOf<Number>& v, const Vec3& axisX, const Vec3& axisY, const Vec3& axisZ)
{
    return {v.x * axisX.x + v.y * axisY.x + v.z * axisZ.x, v.x * axisX.y + v.y * axisY.y + v.z * axisZ.y,
            v.x * axisX.z + v.y * axisY.z + v.z * axisZ.z};
}

void Copy(std::size_t i, const FourGlassRays& from, FourGlassRays& to)
{
    for (int axis = 0; axis < 3; axis++)
    {
        to.origin[axis][i] = from.origin[axis][i];
        to.direction[axis][i] = from.direction[axis][i];
    }
}

} // namespace

/// Views of four film points, side by side.
struct GlassCamera::FourPupils
{
    double place[3][4];                           ///< film points, lens frame, mm
    double l[4], m[4], radial[4], tangential[4];  ///< ellipses of directions
    double axisL[4], axisM[4];                    ///< radial axes of the ellipses
    double brightness[4];
    unsigned int seen = 0;                        ///< one bit for each film point that receives light
};

/// Bilinear interpolation in the table, side by side.
template<class Vector>
struct GlassCamera::Interpolation
{
    const Node* upperLeft[kVectorWidth<Vector>];
    Vector weights[4];

    TILT_LENS_INLINED Interpolation(const std::vector<Node>& nodes, const double* x, const double* y)
    {
        Vector right, down;
        for (std::size_t i = 0; i < kVectorWidth<Vector>; i++)
        {
            const TablePlace place = PlaceOf(kTableSide, {x[i], y[i]});
            upperLeft[i] = &nodes[place.at];
            right[i] = place.right;
            down[i] = place.down;
        }
        weights[0] = (1.0 - right) * (1.0 - down);
        weights[1] = right * (1.0 - down);
        weights[2] = (1.0 - right) * down;
        weights[3] = right * down;
    }

    TILT_LENS_INLINED Vector operator()(double Node::*number) const
    {
        constexpr std::size_t corners[4] = {0, 1, kTableSide, kTableSide + 1};
        Vector mean{};
        for (int corner = 0; corner < 4; corner++)
        {
            Vector value{};
            for (std::size_t i = 0; i < kVectorWidth<Vector>; i++)
                value[i] = upperLeft[i][corners[corner]].*number;
            mean += weights[corner] * value;
        }
        return mean;
    }
};

GlassCamera::Node GlassCamera::Between(const FilmPoint& film) const
{
    const double x[] = {film.x, film.x}, y[] = {film.y, film.y};
    const Interpolation<Double2> mean(nodes, x, y);
    return {mean(&Node::l)[0], mean(&Node::m)[0], mean(&Node::radial)[0], mean(&Node::tangential)[0], mean(&Node::open)[0],
            mean(&Node::natural)[0]};
}

/// Scales the direction to the axial length of the film point's chief ray, so that ray parameters compare with those of ideal rays.
template<class Number>
TILT_LENS_INLINED LensRayOf<Number> GlassCamera::ToWorld(const Number& x, const Number& y, const GlassRayOf<Number>& ray) const
{
    const VecOf<Number> origin = AlongAxes(ray.origin, axisX, axisY, lens->normal);
    const VecOf<Number> direction = AlongAxes(ray.direction, axisX, axisY, lens->normal);
    const Number least = Number() + kLeastAlong, along = Dot(direction, Broadcast<Number>(lens->axis));
    const Number scale = Dot(lens->direction, lens->axis) / Max(along, least), unit = Number() + lens->millimetre;
    return {unit * origin, scale * direction, lens->focusMiddle + x * lens->focusRight + y * lens->focusUp};
}

template<class Vector>
TILT_LENS_INLINED void GlassCamera::FindPupils(const FourGlassPoints& points, FourPupils& pupils) const
{
    for (std::size_t i = 0; i < 4; i += kVectorWidth<Vector>)
    {
        const Vector x = Load<Vector>(points.x + i), y = Load<Vector>(points.y + i);
        const VecOf<Vector> place{filmMiddle.x + x * filmRight.x + y * filmUp.x, filmMiddle.y + x * filmRight.y + y * filmUp.y,
                                  filmMiddle.z + x * filmRight.z + y * filmUp.z};
        const PupilPointOf<Vector> aim = ParaxialAim(glass.Cardinal(), place), axis = RadialAxis(place);
        const Interpolation<Vector> mean(nodes, points.x + i, points.y + i);
        const Vector open = mean(&Node::open);
        StoreVectors(pupils.place, i, place);
        Store(pupils.l + i, aim.l + mean(&Node::l));
        Store(pupils.m + i, aim.m + mean(&Node::m));
        Store(pupils.radial + i, mean(&Node::radial));
        Store(pupils.tangential + i, mean(&Node::tangential));
        Store(pupils.axisL + i, axis.l);
        Store(pupils.axisM + i, axis.m);
        Store(pupils.brightness + i, BrightnessOf(open, natural == 0.0 ? Vector() : mean(&Node::natural)));
        pupils.seen |= SignBits(open > 0.0) << i;
    }
}

/// Rays from the film points through points of their ellipses.
/// @param a, b  points of the unit disc
/// @return      one bit for each ray that exists
template<class Vector>
TILT_LENS_INLINED unsigned int GlassCamera::Aim(const FourPupils& pupils, const double* a, const double* b, FourGlassRays& rays)
{
    unsigned int found = 0;
    for (std::size_t i = 0; i < 4; i += kVectorWidth<Vector>)
    {
        const Vector along = Load<Vector>(pupils.radial + i) * Load<Vector>(a + i);
        const Vector across = Load<Vector>(pupils.tangential + i) * Load<Vector>(b + i);
        const Vector axisL = Load<Vector>(pupils.axisL + i), axisM = Load<Vector>(pupils.axisM + i);
        const PupilPointOf<Vector> direction{Load<Vector>(pupils.l + i) + along * axisL - across * axisM,
                                             Load<Vector>(pupils.m + i) + along * axisM + across * axisL};
        const Vector square = SquaredAlong(direction);
        StoreVectors(rays.origin, i, LoadVectors<Vector>(pupils.place, i));
        StoreVectors(rays.direction, i, VecOf<Vector>{direction.l, direction.m, SquareRoot(square)});
        found |= SignBits(square > 0.0) << i;
    }
    return found;
}

/// Draws directions until one of each film point passes the lens.
/// @param waiting     one bit for each film point that needs a ray
/// @param[out] drawn  the rays that leave the lens
/// @return            one bit for each of them
template<class Vector>
TILT_LENS_INLINED unsigned int GlassCamera::DrawRays(const GlassLens& colour, const FourGlassPoints& points, const FourPupils& pupils,
                                                     unsigned int waiting, FourGlassRays& drawn, std::uint32_t (&refused)[4]) const
{
    const unsigned int wanted = waiting;
    std::array<double, 4> u, v, a, b;
    std::copy(points.u, points.u + 4, u.begin());
    std::copy(points.v, points.v + 4, v.begin());
    UniformNumbers uniform[4] = {UniformNumbers(points.seed[0]), UniformNumbers(points.seed[1]), UniformNumbers(points.seed[2]),
                                 UniformNumbers(points.seed[3])};
    for (int tries = 0; waiting != 0 && tries <= kTries; tries++)
    {
        FourGlassRays rays;
        disc.Map(u.data(), v.data(), a.data(), b.data(), 4);
        FourStopPoints stop;
        const unsigned int passed = Aim<Vector>(pupils, a.data(), b.data(), rays) & colour.Trace(rays, stop);
        for (int i = 0; i < 4; i++)
        {
            if ((waiting >> i & 1u) == 0)
                continue;
            if ((passed >> i & 1u) != 0)
            {
                Copy(i, rays, drawn);
                waiting &= ~(1u << i);
                continue;
            }
            refused[i]++;
            u[i] = uniform[i]();
            v[i] = uniform[i]();
        }
    }
    return wanted & ~waiting;
}

template<class Vector>
TILT_LENS_INLINED void GlassCamera::DrawBy(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const
{
    FourPupils pupils;
    FindPupils<Vector>(points, pupils);
    FourGlassRays drawn{};
    std::fill(samples.refused, samples.refused + 4, 0u);
    const unsigned int found = DrawRays<Vector>(colour, points, pupils, points.wanted & pupils.seen, drawn, samples.refused);
    for (std::size_t i = 0; i < 4; i += kVectorWidth<Vector>)
    {
        const LensRayOf<Vector> ray = ToWorld<Vector>(Load<Vector>(points.x + i), Load<Vector>(points.y + i),
                                                      {LoadVectors<Vector>(drawn.origin, i), LoadVectors<Vector>(drawn.direction, i)});
        StoreVectors(samples.origin, i, ray.origin);
        StoreVectors(samples.direction, i, ray.direction);
        Store(samples.w + i, ray.w);
    }
    for (std::size_t i = 0; i < 4; i++)
        samples.weight[i] = (found >> i & 1u) != 0 ? pupils.brightness[i] : 0.0;
}

void GlassCamera::DrawPlainly(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const
{
    DrawBy<Double2>(colour, points, samples);
}

TILT_LENS_FOR_AVX2 void GlassCamera::DrawByAvx2(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const
{
    DrawBy<Double4>(colour, points, samples);
}

void GlassCamera::DrawThrough(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const
{
    HasAvx2() ? DrawByAvx2(colour, points, samples) : DrawPlainly(colour, points, samples);
}

GlassSample GlassCamera::DrawThrough(const GlassLens& colour, const FilmPoint& film, double u, double v, std::uint32_t seed) const
{
    FourGlassSamples samples;
    DrawThrough(colour, {{film.x}, {film.y}, {u}, {v}, {seed}, 1}, samples);
    const auto vector = [](const double (&from)[3][4]) { return Vec3{from[0][0], from[1][0], from[2][0]}; };
    return {{vector(samples.origin), vector(samples.direction), samples.w[0]}, samples.weight[0], samples.refused[0]};
}

std::optional<LensRay> GlassCamera::MiddleRay(const FilmPoint& film) const
{
    const Node node = Between(film);
    const Vec3 place = FilmInLens(film);
    std::optional<GlassRay> ray = RayTowards(place, BoundsOf(node, place).centre);
    StopPoint stop;
    if (!(node.open > 0.0) || !ray || glass.Trace(*ray, stop) != Passage::Passed)
        return {};
    return ToWorld(film.x, film.y, *ray);
}

} // namespace tilt_lens
