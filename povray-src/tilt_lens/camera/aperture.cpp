// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/aperture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "tilt_lens/camera/aperture_picture.h"
#include "tilt_lens/camera/blade_arc.h"
#include "tilt_lens/camera/concentric.h"
#include "tilt_lens/math/kernels.h"
#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

template<class... Functions>
struct Overloaded : Functions...
{
    using Functions::operator()...;
};
template<class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

inline AperturePoint PointOnDisc(double u, double v)
{
    AperturePoint point;
    OnDisc(u, v, point.a, point.b);
    return point;
}

} // namespace

struct Aperture::Outline
{
    int blades, edges;                  ///< polygon edges, equally many per blade
    std::vector<AperturePoint> corner;
    double density;

    AperturePoint Map(double u, double v) const
    {
        double position, radius;
        FindPosition(u, v, edges, position, radius);
        return PointAt(position, radius);
    }

    AperturePoint PointAt(double position, double radius) const
    {
        // position may round up to a whole turn
        const int edge = std::min(static_cast<int>(position), edges - 1);
        const double t = position - edge;
        const AperturePoint &p = corner[edge], &q = corner[edge + 1];
        return {radius * (p.a + t * (q.a - p.a)), radius * (p.b + t * (q.b - p.b))};
    }

    void Map(const double* u, const double* v, double* a, double* b, int count) const
    {
        double positions[4], radii[4];
        for (int i = 0; i < count; ++i)
        {
            if (i % 4 == 0)
                kernels->findPositions(u + i, v + i, edges, positions, radii);
            const AperturePoint point = PointAt(positions[i % 4], radii[i % 4]);
            a[i] = point.a;
            b[i] = point.b;
        }
    }

    int EdgeTowards(const AperturePoint& point) const
    {
        const double first = std::atan2(corner[0].b, corner[0].a);
        double turns = (std::atan2(point.b, point.a) - first) / (2 * kPi);
        turns -= std::floor(turns);
        // blades span equal angles, unlike the chords of one blade
        const int blade = std::min(static_cast<int>(turns * blades), blades - 1);
        int edge = blade * (edges / blades);
        for (int span = edges / blades; span > 1;)
        {
            const int half = span / 2;
            const bool beyond = Cross(corner[edge + half], point) >= 0;
            edge += beyond ? half : 0;
            span = beyond ? span - half : half;
        }
        return edge;
    }

    double Density(const AperturePoint& point) const
    {
        const int edge = EdgeTowards(point);
        const AperturePoint &p = corner[edge], &q = corner[edge + 1];
        const double side = (q.a - p.a) * (point.b - p.b) - (q.b - p.b) * (point.a - p.a);
        return side >= 0 ? density : 0.0;
    }

    /// Relative radius: 0 at the centre, 1 on the edge.
    double Size(const AperturePoint& point) const
    {
        const int edge = EdgeTowards(point);
        const AperturePoint &p = corner[edge], &q = corner[edge + 1];
        const AperturePoint along{q.a - p.a, q.b - p.b};
        return Cross(point, along) / Cross(p, along);
    }
};

struct Aperture::Oval
{
    Aperture shape;
    double width, height;

    AperturePoint Map(double u, double v) const
    {
        const AperturePoint point = shape(u, v);
        return {width * point.a, height * point.b};
    }

    double Density(const AperturePoint& point) const { return shape.Density({point.a / width, point.b / height}) / (width * height); }
};

struct Aperture::Grade
{
    Aperture shape;
    double power;    ///< n of Aperture::Graded()
    bool rim;        ///< bright at the rim, else in the middle

    /// Equal areas of the square get equal light.
    AperturePoint Map(double u, double v) const
    {
        const double x = 2 * u - 1, y = 2 * v - 1;
        const double size = std::max(std::fabs(x), std::fabs(y)), square = size * size;
        if (size == 0)
            return shape(u, v);
        const double moved = rim ? std::pow(square, 1 / (power + 1)) : -std::expm1(std::log1p(-square) / (power + 1));
        const double factor = std::sqrt(moved) / size;
        return shape(0.5 + 0.5 * factor * x, 0.5 + 0.5 * factor * y);
    }

    double Density(const AperturePoint& point) const
    {
        const auto* const outline = std::get_if<Shared<Outline>>(&shape.shape);
        const double even = shape.Density(point), size = outline ? (*outline)->Size(point) : std::hypot(point.a, point.b);
        if (even == 0)
            return 0;
        const double bright = rim ? size * size : std::max(0.0, 1 - size * size);
        return even * (power + 1) * std::pow(bright, power);
    }
};

Aperture Aperture::Disc()
{
    return Aperture();
}

Aperture Aperture::Polygon(int blades, double angleRadians, double curvature)
{
    if (blades < 3 || blades > maxBlades)
        throw std::invalid_argument("The number of diaphragm blades makes no opening. Found: " + std::to_string(blades) +
                                    ". Allowed: 3 to " + std::to_string(maxBlades) + ". Give another number, or none for a round opening.");
    if (!std::isfinite(angleRadians))
        throw std::invalid_argument("The angle of the diaphragm blades is not a finite number. Found: " + std::to_string(angleRadians) +
                                    ". Allowed: any finite angle. Correct or omit it.");

    if (!(curvature >= 0 && curvature <= 1))
        throw std::invalid_argument("The curvature of the diaphragm blades makes no opening. Found: " + std::to_string(curvature) +
                                    ". Allowed: 0 (straight) to 1 (a circle). Give another number, or none.");

    constexpr int enough = 512;  // least chords around a curved opening
    const int chords = curvature > 0 ? (enough + blades - 1) / blades : 1;
    const std::vector<AperturePoint> arc = Arc(blades, curvature, chords);
    auto outline = std::make_shared<Outline>();
    outline->blades = blades;
    outline->edges = blades * chords;
    const double triangle = chords > 1 ? Cross(arc[0], arc[1]) : std::sin(2 * kPi / blades);
    outline->density = 2 / (outline->edges * triangle);
    for (int i = 0; i < blades; ++i)
    {
        const double angle = angleRadians + 2 * kPi * i / blades;
        const double a = std::cos(angle), b = std::sin(angle);
        outline->corner.push_back({a, b});
        for (int j = 1; j < chords; ++j)
            outline->corner.push_back({arc[j].a * a - arc[j].b * b, arc[j].a * b + arc[j].b * a});
    }
    outline->corner.push_back(outline->corner.front());

    return Aperture(Shared<Outline>(std::move(outline)));
}

Aperture Aperture::Picture(const std::function<double(double u, double v)>& weight)
{
    return Aperture(std::make_shared<const AperturePicture>(weight));
}

Aperture Aperture::Squeezed(const Aperture& shape, double ratio)
{
    if (!(ratio > 0) || !std::isfinite(ratio))
        throw std::invalid_argument("The aperture is squeezed to nothing. Found: " + std::to_string(ratio) +
                                    ". Allowed: any finite ratio above 0. Give another, or 1 for none.");
    return Aperture(std::make_shared<const Oval>(Oval{shape, ratio > 1 ? 1 / ratio : 1.0, ratio < 1 ? ratio : 1.0}));
}

Aperture Aperture::Graded(const Aperture& shape, double amount)
{
    const double size = std::fabs(amount);
    if (!(size < 1) || !(shape.IsDisc() || std::holds_alternative<Shared<Outline>>(shape.shape)))
        throw std::invalid_argument("The aperture cannot be made brighter at its rim or in its middle. Found: " + std::to_string(amount) +
                                    ". Allowed: more than -1 and less than 1, for a disc or blades. Give another, or 0 for even light.");
    return Aperture(std::make_shared<const Grade>(Grade{shape, size / (1 - size), amount > 0}));
}

AperturePoint Aperture::operator()(double u, double v) const
{
    const auto map = [&](const auto& table) { return table->Map(u, v); };
    return std::visit(Overloaded{map, [&](Round) { return PointOnDisc(u, v); }}, shape);
}

void Aperture::Map(const double* u, const double* v, double* a, double* b, int count) const
{
    const auto oneByOne = [&](const auto& table)
    {
        for (int i = 0; i < count; ++i)
        {
            const AperturePoint point = table->Map(u[i], v[i]);
            a[i] = point.a;
            b[i] = point.b;
        }
    };
    std::visit(Overloaded{oneByOne, [&](Round) { kernels->mapToDisc(u, v, a, b, count); },
                          [&](const Shared<Outline>& outline) { outline->Map(u, v, a, b, count); }},
               shape);
}

double Aperture::Density(const AperturePoint& point) const
{
    const auto density = [&](const auto& table) { return table->Density(point); };
    return std::visit(Overloaded{density, [&](Round) { return point.a * point.a + point.b * point.b <= 1 ? 1 / kPi : 0.0; }}, shape);
}

double Aperture::BoundingRadius() const
{
    return std::visit(Overloaded{[](const auto&) { return 1.0; }, [](const Shared<AperturePicture>&) { return std::sqrt(2.0); },
                                 [](const Shared<Oval>& oval) { return oval->shape.BoundingRadius(); }},
                      shape);
}

} // namespace tilt_lens
