// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_tracer.h
/// TracePixel's part in `tilt_lens` pictures: camera rays in, light out. TracePixel has one where its view has a
/// lens with an aperture, and calls it a friend: what a ray needs of POV-Ray is private there.

#ifndef POVRAY_BACKEND_TILT_LENS_TRACER_H
#define POVRAY_BACKEND_TILT_LENS_TRACER_H

#include <cstdint>
#include <vector>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/lighting/area_light_sampler.h"
#include "backend/render/trace.h"
#include "backend/scene/tilt_lens_view.h"
#include "backend/support/sample_seeds.h"
#include "tilt_lens/math/vec3.h"
#include "tilt_lens/sampling/camera_rays.h"

namespace pov
{

class Ray;
class TracePixel;

/// What a pixel cost, and how good it is.
struct TiltLensEffort
{
    unsigned int samples;
    double variance;  ///< as TileSampler::Variance() gives it
};

class TiltLensTracer : public AreaLightSampler, private SampleSeedSource
{
  public:
    /// Lives as long as its owner, which it uses. NULL where the view has no lens with an aperture.
    static shared_ptr<TiltLensTracer> Create(TracePixel& owner, const shared_ptr<TiltLensView>& view);

    /// That of a TracePixel, or NULL.
    static TiltLensTracer* Of(const TracePixel& owner);

    /// A pixel of a preview or of a radiosity pretrace: not for the final picture, so a few samples do,
    /// one where only the places that are seen matter.
    void TracePreview(DBL x, DBL y, DBL width, DBL height, Colour& colour);

    /// A tile of the final picture.
    /// @param width, height  of the whole picture, in pixels
    /// @param alone   whether the tile may share nothing with others, because a pixel depends on what else its tile traced
    /// @param pixels  row by row
    void TraceTile(const POVRect& rect, unsigned int width, unsigned int height, bool alone, std::vector<Colour>& pixels);

    /// Before the first tile, all threads together trace some pixels, so that progress can be told.
    void EstimateWork();

    /// Of the last tile, pixel by pixel; empty for focus aids.
    const std::vector<TiltLensEffort>& Effort() const { return effort; }

    virtual bool ChoosePoint(const LightSource& light, unsigned int radiosityDepth, int& u, int& v);

    virtual unsigned int Seed() const { return pixel->Hash(index); }

    /// @name For picture layers, which all cameras have.
    /// @{

    /// Where the ray through the middle of a pixel first meets something, transparent or not.
    /// @param[out] point  world coordinates
    /// @param[out] depth  along the camera's axis where it has one, else the length of the ray
    static bool FirstPoint(TracePixel& trace, unsigned int x, unsigned int y, DBL width, DBL height,
                           tilt_lens::Vec3& point, DBL& depth);
    /// @}

  private:
    TracePixel& trace;
    const shared_ptr<TiltLensView> view;
    const bool interiorsVary;  ///< among the rays of the picture: a part of the lens lies within an object
    std::vector<TiltLensEffort> effort;

    /// The sample that is being traced.
    const tilt_lens::PixelSampler* pixel = NULL;  ///< its pixel's sequence; NULL while none is traced
    unsigned int index = 0;
    unsigned int areaLightsMet = 0;
    /// Points of area lights in this tile: asked, and those beside them that were not.
    std::uint64_t areaLightPoints = 0, areaLightPointsSkipped = 0;
    /// Rays that a lens of glass let not through, in this tile.
    std::uint64_t refusedRays = 0;

    TiltLensTracer(TracePixel& owner, const shared_ptr<TiltLensView>& view);

    /// @param ray  as CameraRayOfPov() makes it; may be used again
    void TraceRun(tilt_lens::CameraRayBatch& rays, const tilt_lens::SampleRun& run, Ray& ray,
                  tilt_lens::SampleResult* results);
    /// @name Of the sample that `pixel` and `index` name.
    /// @{
    void TraceSample(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result);
    void TraceColours(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result);
    void TraceCameraRay(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result);
    void TraceRay(const Ray& ray, Trace::TraceTicket ticket, double weight, tilt_lens::Radiance& radiance);
    /// @}
    void TraceRays(const tilt_lens::CameraRays& rays, unsigned int place, const tilt_lens::SampleRun& run, Ray& ray,
                   tilt_lens::SampleResult* results);
    void FindCircles(const tilt_lens::CameraRays& rays, unsigned int place, unsigned int count, const DBL* distances,
                     tilt_lens::SampleResult* results) const;
    Ray CameraRayOfPov() const;
    void Begin(Ray& ray, const tilt_lens::CameraRays& rays, unsigned int place) const;
    void BeginSpecially(Ray& ray, const tilt_lens::CameraRays& rays, unsigned int place);
    void EnterInteriors(Ray& ray) const;
    void LeadGenerators();
    void BeginNumbers();
    void SeedSubsurface(unsigned int seed);
    void TraceAid(DBL x, DBL y, DBL width, DBL height, Colour& colour);
    void TraceAidTile(const POVRect& rect, unsigned int width, unsigned int height, std::vector<Colour>& pixels);
    bool MiddleRayOfGlass(Ray& ray, const tilt_lens::FilmPoint& film) const;
    static bool ChiefCameraRay(TracePixel& trace, Ray& ray, DBL x, DBL y, DBL width, DBL height);
    static DBL FirstHit(TracePixel& trace, const Ray& ray);
};

} // namespace pov

#endif
