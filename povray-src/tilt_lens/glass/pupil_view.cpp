// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/pupil_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

/// Bisection finds the pupil's border to 1/4000 of its size.
constexpr int kSpokes = 32;
constexpr int kHalvings = 11;

/// Sides of ray grids if the pupil's centre is blocked: over twice the paraxial pupil, then over the last surface. Multiples of four.
constexpr int kPupilGrid = 24;
constexpr int kSurfaceGrid = 64;

/// Spokes are measured again from the area's centre if their lengths differ by a larger factor.
constexpr double kRound = 1.3;

/// Enlargement for borders between spokes and table entries, and where rims cut the pupil.
constexpr double kMargin = 1.04;
constexpr double kCoveredMargin = 0.08;

struct FourPupilPoints
{
    double l[4], m[4];
};

struct Seen
{
    const GlassLens& lens;
    const Vec3& film;

    bool Passes(const PupilPoint& direction) const
    {
        std::optional<GlassRay> ray = RayTowards(film, direction);
        StopPoint stop;
        return ray && lens.Trace(*ray, stop) == Passage::Passed;
    }

    /// Arguments and result as for GlassLens::Trace().
    unsigned int Passing(const FourPupilPoints& directions, bool rims = true) const
    {
        FourGlassRays rays;
        unsigned int passing = 0;
        for (int i = 0; i < 4; i++)
        {
            const PupilPoint direction{directions.l[i], directions.m[i]};
            const double square = SquaredAlong(direction);
            rays.origin[0][i] = film.x, rays.origin[1][i] = film.y, rays.origin[2][i] = film.z;
            rays.direction[0][i] = direction.l, rays.direction[1][i] = direction.m, rays.direction[2][i] = std::sqrt(square);
            passing |= (square > 0.0 ? 1u : 0u) << i;
        }
        FourStopPoints stop;
        return passing & lens.Trace(rays, stop, rims);
    }

    /// Direction cosines.
    double Size() const
    {
        const CardinalPoints& points = lens.Cardinal();
        const double radius = std::fabs(points.exitMagnification) * lens.StopRadius();
        const double distance = std::fabs(points.exitPupil - film.z);
        const double size = std::isfinite(radius) ? radius / std::hypot(radius, distance) : 0.25;
        return std::clamp(size, 1e-6, 1.0);
    }

    std::optional<PupilPoint> MeanOf(const PupilPoint& middle, double half, int side) const
    {
        PupilPoint sum{0.0, 0.0};
        int passed = 0;
        for (int i = 0; i < side * side; i += 4)
        {
            FourPupilPoints at;
            for (int j = 0; j < 4; j++)
            {
                at.l[j] = middle.l + half * (2.0 * (i / side + 0.5) / side - 1.0);
                at.m[j] = middle.m + half * (2.0 * (i % side + j + 0.5) / side - 1.0);
            }
            const unsigned int passing = Passing(at);
            for (int j = 0; j < 4; j++)
                if ((passing >> j & 1u) != 0)
                {
                    sum = {sum.l + at.l[j], sum.m + at.m[j]};
                    passed++;
                }
        }
        if (passed == 0)
            return {};
        return PupilPoint{sum.l / passed, sum.m / passed};
    }

    std::optional<PupilPoint> Inside(const std::optional<PupilPoint>& near) const
    {
        const PupilPoint aim = ParaxialAim(lens.Cardinal(), film);
        if (Passes(aim))
            return aim;
        if (near && Passes(*near))
            return near;
        std::optional<PupilPoint> mean = MeanOf(aim, 2.0 * Size(), kPupilGrid);
        if (!mean)
        {
            const double rear = lens.Cardinal().rearVertex - film.z, across = std::hypot(film.x, film.y);
            const Vec3 middle = Normalized(Vec3{-film.x, -film.y, rear});
            const double reach = lens.RearRadius() / std::hypot(rear, std::max(0.0, across - lens.RearRadius()));
            mean = MeanOf({middle.x, middle.y}, std::min(1.0, 1.2 * reach), kSurfaceGrid);
        }
        return mean && Passes(*mean) ? mean : std::optional<PupilPoint>();
    }
};

/// From an inner direction to the border, with rims and with the stop alone.
struct Spoke
{
    double open, stop;
};

using Spokes = std::array<Spoke, kSpokes>;

PupilPoint Along(int spoke)
{
    const double angle = 2.0 * kPi * (spoke + 0.5) / kSpokes;
    return {std::cos(angle), std::sin(angle)};
}

/// Four searches side by side.
class FourSpokes
{
  public:
    FourSpokes(const Seen& itsSeen, const PupilPoint& itsFrom, int first) : seen(itsSeen), from(itsFrom)
    {
        for (int i = 0; i < 4; i++)
            along[i] = Along(first + i);
    }

    void Begin(int i, double itsPasses, double itsEnds)
    {
        passes[i] = itsPasses;
        ends[i] = itsEnds;
    }

    void FindBorders(bool rims)
    {
        for (unsigned int open = 0xf; open != 0;)
        {
            open &= Passing(ends, rims);
            for (int i = 0; i < 4; i++)
                if ((open >> i & 1u) != 0)
                {
                    if (ends[i] >= 4.0)
                        open &= ~(1u << i);
                    passes[i] = ends[i];
                    ends[i] *= 1.5;
                }
        }
        for (int halving = 0; halving < kHalvings; halving++)
        {
            const std::array<double, 4> middle{Border(0), Border(1), Border(2), Border(3)};
            const unsigned int passing = Passing(middle, rims);
            for (int i = 0; i < 4; i++)
                ((passing >> i & 1u) != 0 ? passes : ends)[i] = middle[i];
        }
    }

    double Border(int i) const { return 0.5 * (passes[i] + ends[i]); }

    /// One bit per spoke whose blocked step the stop alone lets pass.
    unsigned int EndAtRims() const { return Passing(ends, false); }

  private:
    const Seen& seen;
    const PupilPoint& from;
    std::array<PupilPoint, 4> along;
    std::array<double, 4> passes, ends;

    unsigned int Passing(const std::array<double, 4>& steps, bool rims) const
    {
        FourPupilPoints at;
        for (int i = 0; i < 4; i++)
        {
            at.l[i] = from.l + steps[i] * along[i].l;
            at.m[i] = from.m + steps[i] * along[i].m;
        }
        return seen.Passing(at, rims);
    }
};

Spokes SpokesFrom(const Seen& seen, const PupilPoint& inside)
{
    Spokes spokes;
    std::array<double, 4> last;
    last.fill(seen.Size());
    for (int first = 0; first < kSpokes; first += 4)
    {
        FourSpokes four(seen, inside, first);
        for (int i = 0; i < 4; i++)
            four.Begin(i, 0.0, 1.1 * last[i]);
        four.FindBorders(true);
        const unsigned int atRims = four.EndAtRims();
        for (int i = 0; i < 4; i++)
        {
            const double open = four.Border(i);
            spokes[first + i] = {open, open};
            last[i] = std::max(open, 1e-6);
            four.Begin(i, open, 1.1 * last[i]);
        }
        if (atRims == 0)
            continue;
        four.FindBorders(false);
        for (int i = 0; i < 4; i++)
            if ((atRims >> i & 1u) != 0)
                spokes[first + i].stop = four.Border(i);
    }
    return spokes;
}

bool IsRound(const Spokes& spokes)
{
    double least = HUGE_VAL, most = 0.0;
    for (const Spoke& spoke : spokes)
    {
        least = std::min(least, spoke.open);
        most = std::max(most, spoke.open);
    }
    return most < kRound * least;
}

PupilPoint MiddleOf(const Spokes& spokes, const PupilPoint& inside)
{
    double area = 0.0, l = 0.0, m = 0.0;
    for (int i = 0; i < kSpokes; i++)
    {
        const double square = spokes[i].open * spokes[i].open, third = square * spokes[i].open / 3.0;
        area += 0.5 * square;
        l += third * Along(i).l;
        m += third * Along(i).m;
    }
    return {inside.l + l / area, inside.m + m / area};
}

/// @param larger  factor on the ellipse through the farthest end
PupilEllipse EllipseAround(const Spokes& spokes, const PupilPoint& inside, const PupilPoint& radial, double larger)
{
    std::array<PupilPoint, kSpokes> ends;
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < kSpokes; i++)
    {
        const PupilPoint along = Along(i);
        const double l = inside.l + spokes[i].open * along.l, m = inside.m + spokes[i].open * along.m;
        ends[i] = {l * radial.l + m * radial.m, m * radial.l - l * radial.m};
        const double end[2] = {ends[i].l, ends[i].m};
        for (int axis = 0; axis < 2; axis++)
        {
            low[axis] = std::min(low[axis], end[axis]);
            high[axis] = std::max(high[axis], end[axis]);
        }
    }
    const double middle[2] = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
    const double half[2] = {std::max(0.5 * (high[0] - low[0]), 1e-9), std::max(0.5 * (high[1] - low[1]), 1e-9)};
    double farthest = 0.0;
    for (const PupilPoint& end : ends)
        farthest = std::max(farthest, std::hypot((end.l - middle[0]) / half[0], (end.m - middle[1]) / half[1]));
    farthest *= larger;
    return {
        {middle[0] * radial.l - middle[1] * radial.m, middle[0] * radial.m + middle[1] * radial.l}, farthest * half[0], farthest * half[1]};
}

} // namespace

std::optional<PupilView> ViewOf(const GlassLens& lens, const Vec3& film, const std::optional<PupilPoint>& near)
{
    const Seen seen{lens, film};
    std::optional<PupilPoint> inside = seen.Inside(near);
    if (!inside)
        return {};
    Spokes spokes = SpokesFrom(seen, *inside);
    const PupilPoint middle = MiddleOf(spokes, *inside);
    if (!IsRound(spokes) && seen.Passes(middle))
    {
        inside = middle;
        spokes = SpokesFrom(seen, middle);
    }
    PupilView view;
    for (const Spoke& spoke : spokes)
    {
        view.open += kPi / kSpokes * spoke.open * spoke.open;
        view.stop += kPi / kSpokes * spoke.stop * spoke.stop;
    }
    view.bounds = EllipseAround(spokes, *inside, RadialAxis(film), kMargin + kCoveredMargin * (1.0 - view.open / view.stop));
    return view;
}

} // namespace tilt_lens
