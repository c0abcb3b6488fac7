// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/emitter_sampling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

namespace
{

/// Part of the picture's width by which glass moves a disc at most, about.
constexpr double glassMargin = 0.1;

} // namespace

EmitterSampling::EmitterSampling(const LensSampler& plain, const SamplingLimits& limits, const std::vector<Emitter>& all) :
    plain(plain), settings(limits.settings), usable(limits.max / Settings::emitterStratum * Settings::emitterStratum)
{
    if (limits.AllowAims())
        Add(limits, all);
}

void EmitterSampling::Add(const SamplingLimits& limits, const std::vector<Emitter>& more)
{
    for (const Emitter& emitter : more)
        Keep(emitter, limits.FirstRound() * limits.variance);
    bins.clear();
    Distribute();
}

void EmitterSampling::Draw(const Targets& targets, const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const
{
    if (targets.targets.empty())
        return plain.Draw(run, points, samples);
    for (std::uint32_t i = 0; i < run.count; i++)
        samples.Put(run.Place() + i, Draw(targets, run[i], points[run.Place() + i]));
}

/// Film position, pixels, of the ray from a lens point through `through`; false if there is none.
bool EmitterSampling::PixelPositionOf(const Vec3& through, const AperturePoint& point, double& x, double& y) const
{
    const std::optional<Vec3> along = ChiefThrough(plain.lens, through, point.a * plain.lens.lensX + point.b * plain.lens.lensY);
    const std::optional<FilmPoint> ideal = along ? IdealFilmPointOf(plain.lens, *along) : std::optional<FilmPoint>();
    const std::optional<FilmPoint> film = ideal ? PictureFilmPoint(plain.lens, *ideal) : ideal;
    if (!film)
        return false;
    x = (film->x + 0.5) * plain.width;
    y = (0.5 - film->y) * plain.height;
    return true;
}

/// @param margin  around the picture
bool EmitterSampling::MeetsFrame(const Box& box, double margin) const
{
    return box.right > -margin && box.bottom > -margin && box.left < plain.width + margin && box.top < plain.height + margin;
}

/// Bounding box of a point's circle of confusion, from few points on an enlarged circle around the aperture. A lens of glass counts as thin.
EmitterSampling::Box EmitterSampling::BlurBoxOf(const Vec3& centre, bool& whole) const
{
    const double radius = plain.aperture.BoundingRadius() / std::cos(kPi / Settings::blurBoxPoints);
    Box box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    whole = true;
    for (int i = 0; i < Settings::blurBoxPoints; i++)
    {
        double x, y;
        const double turn = 2.0 * kPi * i / Settings::blurBoxPoints;
        whole = whole && PixelPositionOf(centre, {radius * std::cos(turn), radius * std::sin(turn)}, x, y);
        if (!whole)
            break;
        box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
    }
    return box;
}

/// Along the shorter side of a pixel. A sphere's image is elongated, increasingly towards the picture's edge.
double EmitterSampling::SizeOfPixelAt(const Vec3& point) const
{
    const double ahead = Dot(point, plain.lens.axis);
    const double pixels = std::max(plain.width / Length(plain.lens.right), plain.height / Length(plain.lens.up));
    return ahead * ahead / (pixels * Dot(plain.lens.direction, plain.lens.axis) * Length(point));
}

std::vector<EmitterSampling::SharpImage> EmitterSampling::SharpImages() const
{
    std::vector<SharpImage> images;
    for (const Kept& emitter : kept)
    {
        SharpImage image{0.0, 0.0, emitter.imageRadius};
        if (PixelPositionOf(emitter.centre, {0.0, 0.0}, image.x, image.y))
            images.push_back(image);
    }
    return images;
}

double EmitterSampling::PixelsCovered() const
{
    double sum = 0.0;
    for (const Kept& emitter : kept)
    {
        const double across = std::min(plain.width, emitter.covers.right) - std::max(0.0, emitter.covers.left);
        const double along = std::min(plain.height, emitter.covers.bottom) - std::max(0.0, emitter.covers.top);
        sum += std::max(0.0, across) * std::max(0.0, along);
    }
    return sum;
}

/// @param leastVariance  of one plain sample
bool EmitterSampling::Keep(const Emitter& emitter, double leastVariance)
{
    const double ahead = Dot(emitter.centre, plain.lens.axis);
    const double distance = Length(emitter.centre);
    if (!(ahead > 0.0 && distance > plain.lens.diameter + 2.0 * emitter.radius && emitter.radiance > 0.0))
        return false;
    bool whole;
    Box covers = BlurBoxOf(emitter.centre, whole);
    if (!whole)
        return false;

    const double imageRadius = emitter.radius / SizeOfPixelAt(emitter.centre);
    const double across = covers.right - covers.left, along = covers.bottom - covers.top;
    const double hits = kPi * imageRadius * imageRadius / std::max(1.0, kPi / 4.0 * across * along);
    const double emission = hits * emitter.radiance;
    const double contrast = emitter.radiance - emitter.around;
    const bool foundByChance = hits > 1.0, negligible = hits * contrast * contrast < leastVariance;
    if (foundByChance || negligible)
        return false;
    const bool chooseLensPoint = std::min(across, along) > settings.lensPointBlur;
    std::shared_ptr<const GlassSight> sight;
    if (const GlassCamera* const glass = plain.camera->Glass())
    {
        if (!chooseLensPoint || !MeetsFrame(covers, glassMargin * plain.width))
            return false;
        sight = std::make_shared<const GlassSight>(*glass, emitter.centre);
        covers = PixelsOf(sight->Box());
    }
    covers = {covers.left - imageRadius, covers.right + imageRadius, covers.top - imageRadius, covers.bottom + imageRadius};
    kept.push_back({emitter.centre, emitter.radius, imageRadius, emission, chooseLensPoint, covers, sight});
    return true;
}

/// Lists each bin's possibly visible emitters, so that a pixel tests few.
void EmitterSampling::Distribute()
{
    binSide = std::max(Settings::leastEmitterBinSide,
                       std::uint32_t(std::ceil(std::max(plain.width, plain.height) / Settings::emitterBins)));
    columns = std::uint32_t(std::ceil(plain.width / binSide));
    const std::uint32_t rows = std::uint32_t(std::ceil(plain.height / binSide));
    bins.resize(kept.empty() ? 0 : std::size_t(columns) * rows);
    // brightest first: a full bin keeps the first ones
    std::stable_sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.emission > b.emission; });
    for (std::uint32_t i = 0; i < kept.size(); i++)
    {
        const Box& box = kept[i].covers;
        if (!MeetsFrame(box, 0.0))
            continue;
        const std::uint32_t left = std::uint32_t(std::max(0.0, box.left)) / binSide;
        const std::uint32_t right = std::uint32_t(std::min(plain.width - 1.0, box.right)) / binSide;
        const std::uint32_t top = std::uint32_t(std::max(0.0, box.top)) / binSide;
        const std::uint32_t bottom = std::uint32_t(std::min(plain.height - 1.0, box.bottom)) / binSide;
        for (std::uint32_t row = top; row <= bottom; row++)
            for (std::uint32_t column = left; column <= right; column++)
                if (auto& list = bins[std::size_t(row) * columns + column]; list.size() < Settings::emittersOfBin)
                    list.push_back(i);
    }
}

bool EmitterSampling::Reaches(const Kept& emitter, std::uint32_t x, std::uint32_t y) const
{
    const Box& box = emitter.covers;
    if (x + 1.0 < box.left || x > box.right || y + 1.0 < box.top || y > box.bottom)
        return false;
    if (!emitter.chooseLensPoint || emitter.sight)
        return true;
    // while the film point crosses the circle of confusion, this part moves across the whole lens
    const FilmPoint film = FilmPointAt(x + 0.5, y + 0.5, plain.width, plain.height);
    const Disc part = PartOfLens(emitter, film.x, film.y);
    const double blur = std::min(box.right - box.left, box.bottom - box.top) - 2.0 * emitter.imageRadius;
    const double halfPixel = 2.0 * plain.aperture.BoundingRadius() * std::sqrt(0.5) / blur;
    return std::hypot(part.centre.a, part.centre.b) < plain.aperture.BoundingRadius() + part.radius + halfPixel;
}

EmitterSampling::Targets EmitterSampling::TargetsOf(std::uint32_t x, std::uint32_t y) const
{
    Targets result;
    if (kept.empty())
        return result;
    double& emission = result.emission;
    for (const std::uint32_t i : bins[std::size_t(y / binSide) * columns + x / binSide])
    {
        if (result.targets.size() == settings.emittersOfPixel)
            break;
        Targets::Target target{i, kept[i].emission};
        if (!Reaches(kept[i], x, y) || !FindCells(x, y, target))
            continue;
        result.targets.push_back(std::move(target));
        emission += kept[i].emission;
    }
    if (result.targets.empty())
        return result;
    result.share = settings.emitterShare;
    for (Targets::Target& target : result.targets)
        target.share *= result.share / emission;
    return result;
}

CameraSample EmitterSampling::Draw(const Targets& targets, const SampleId& id, const SequencePoint& point) const
{
    if (!MayAim(targets, id.index))
        return plain.Draw(id, point);
    CameraSample sample = plain.DrawFilmPoint(id, point);
    if (Choose(targets, id, point, sample))
        Weigh(targets, sample);
    else
        sample.weight = sample.overPlain = 0.0;
    return sample;
}

/// At which the lens coordinate u aims; null: none, a plain sample.
/// @param[in,out] u  becomes a coordinate of this technique alone
const EmitterSampling::Targets::Target* EmitterSampling::TargetOf(const Targets& targets, double& u) const
{
    if (u >= targets.share)
    {
        u = (u - targets.share) / (1.0 - targets.share);
        return nullptr;
    }
    std::size_t i = 0;
    while (i + 1 < targets.targets.size() && u >= targets.targets[i].share)
        u -= targets.targets[i++].share;
    u = std::min(u / targets.targets[i].share, std::nextafter(1.0, 0.0));
    return &targets.targets[i];
}

/// False if there is no ray.
bool EmitterSampling::Choose(const Targets& targets, const SampleId& id, const SequencePoint& point, CameraSample& sample) const
{
    double u = point.lensU;
    if (const Targets::Target* const target = TargetOf(targets, u))
    {
        sample.expectedEmission = targets.emission;
        return Aim(kept[target->emitter], u, id, point, sample);
    }
    plain.DrawLensPoint(id, u, point.lensV, sample);
    return sample.weight != 0.0;
}

void EmitterSampling::Weigh(const Targets& targets, CameraSample& sample) const
{
    sample.weight = 1.0;
    double plainDensity = 1.0;
    if (!plain.vignetting.None())
    {
        const FilmPoint film{sample.x, sample.y};
        const double brightness = plain.vignetting.Brightness(film);
        sample.weight = plain.vignetting.Passes(film, sample.point) ? brightness : 0.0;
        sample.expectedEmission *= brightness * plain.vignetting.OpenShare(film);
        plainDensity = plain.vignetting.DrawDensity(film);
    }
    double density = (1.0 - targets.share) * plainDensity;
    for (const Targets::Target& target : targets.targets)
        density += target.share * Density(kept[target.emitter], sample);
    sample.weight /= density;
    sample.overPlain = plainDensity / density;
}

/// Disc that contains the lens points through which a film point sees an emitter: on the ray, l (1 - s w) = P - s D, and l lies in the
/// lens plane.
EmitterSampling::Disc EmitterSampling::PartOfLens(const Kept& emitter, double x, double y) const
{
    const LensRay middle = MakeRay(plain.lens, x, y, 0.0, 0.0);
    const Vec3& chief = middle.direction;
    const double along = Dot(chief, plain.lens.normal), s = Dot(emitter.centre, plain.lens.normal) / along;
    const double divisor = 1.0 - s * middle.w;
    const Vec3 point = (emitter.centre - s * chief) / divisor;
    const double lensRadius = 0.5 * plain.lens.diameter;
    return {{Dot(point, plain.lens.lensX) / (lensRadius * lensRadius), Dot(point, plain.lens.lensY) / (lensRadius * lensRadius)},
            emitter.radius * Length(chief) / std::fabs(along * divisor * lensRadius)};
}

/// False if the sample misses lens or pixel.
/// @param u  in [0, 1), replaces the first lens coordinate
bool EmitterSampling::Aim(const Kept& emitter, double u, const SampleId& id, const SequencePoint& point, CameraSample& sample) const
{
    const double v = point.lensV;
    if (emitter.chooseLensPoint)
    {
        const Disc part = PartOfLens(emitter, sample.x, sample.y);
        const AperturePoint inDisc = Aperture::Disc()(u, v);
        sample.point = {part.centre.a + part.radius * inDisc.a, part.centre.b + part.radius * inDisc.b};
        return plain.aperture.Density(sample.point) > 0.0;
    }
    sample.point = plain.aperture(u, v);
    double x, y;
    if (!PixelPositionOf(emitter.centre, sample.point, x, y))
        return false;
    const AperturePoint inDisc = Aperture::Disc()(point.pixelX, point.pixelY);
    x += emitter.imageRadius * inDisc.a;
    y += emitter.imageRadius * inDisc.b;
    const FilmPoint film = FilmPointAt(x, y, plain.width, plain.height);
    sample.x = film.x;
    sample.y = film.y;
    return x >= id.x && x < id.x + 1.0 && y >= id.y && y < id.y + 1.0;
}

double EmitterSampling::Density(const Kept& emitter, const CameraSample& sample) const
{
    if (emitter.chooseLensPoint)
    {
        const Disc part = PartOfLens(emitter, sample.x, sample.y);
        if (!(std::hypot(sample.point.a - part.centre.a, sample.point.b - part.centre.b) <= part.radius))
            return 0.0;
        const double even = plain.aperture.Density(sample.point);
        return even > 0.0 ? 1.0 / (kPi * part.radius * part.radius * even) : 0.0;
    }
    double x, y;
    if (!PixelPositionOf(emitter.centre, sample.point, x, y))
        return 0.0;
    const double off = std::hypot((sample.x + 0.5) * plain.width - x, (0.5 - sample.y) * plain.height - y);
    return off <= emitter.imageRadius ? 1.0 / (kPi * emitter.imageRadius * emitter.imageRadius) : 0.0;
}

}  // namespace tilt_lens
