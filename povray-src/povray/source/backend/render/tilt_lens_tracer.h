// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_tracer.h
/// Traces the camera rays of `tilt_lens` pictures. A TracePixel owns one if its view has a lens with an aperture, and is its friend,
/// because tracing needs TracePixel's private members.

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

struct TiltLensEffort
{
    unsigned int samples;
    double variance;  ///< see TileSampler::Variance()
};

class TiltLensTracer : public AreaLightSampler, private SampleSeedSource
{
  public:
    /// @return  NULL if the view has no lens with an aperture
    /// @param owner  must outlive the result
    static shared_ptr<TiltLensTracer> Create(TracePixel& owner, const shared_ptr<TiltLensView>& view);

    /// @return  NULL if there is none
    static TiltLensTracer* Of(const TracePixel& owner);

    /// A pixel of a preview or of a radiosity pretrace, not of the final picture: a few samples, or one for a pretrace.
    void TracePreview(DBL x, DBL y, DBL width, DBL height, Colour& colour);

    /// A tile of the final picture.
    /// @param width, height  of the whole picture, in pixels
    /// @param alone          true if the tile may share no samples with others, because its pixels depend on the order of tracing
    /// @param pixels         row by row
    void TraceTile(const POVRect& rect, unsigned int width, unsigned int height, bool alone, std::vector<Colour>& pixels);

    /// Traces test pixels before the first tile, shared among all threads, to weight the progress display.
    void EstimateWork();

    /// Of the last tile, row by row; empty for focus aids.
    const std::vector<TiltLensEffort>& Effort() const { return effort; }

    virtual bool ChoosePoint(const LightSource& light, unsigned int radiosityDepth, int& u, int& v);

    virtual unsigned int Seed() const { return pixel->Hash(index); }

    /// @name For picture layers, with any camera.
    /// @{

    /// First hit of the ray through a pixel's centre, transparent surfaces included.
    /// @param[out] point  world coordinates
    /// @param[out] depth  along the camera's axis if it has one, else the length of the ray
    static bool FirstPoint(TracePixel& trace, unsigned int x, unsigned int y, DBL width, DBL height,
                           tilt_lens::Vec3& point, DBL& depth);
    /// @}

  private:
    TracePixel& trace;
    const shared_ptr<TiltLensView> view;
    const bool interiorsVary;  ///< the lens is partly inside an object, so that rays start in different interiors
    std::vector<TiltLensEffort> effort;

    /// The current sample.
    const tilt_lens::PixelSampler* pixel = NULL;  ///< its pixel's sequence; NULL if none is being traced
    unsigned int index = 0;
    unsigned int areaLightsMet = 0;
    /// Area light points in this tile: sampled, and skipped.
    std::uint64_t areaLightPoints = 0, areaLightPointsSkipped = 0;
    /// Rays in this tile that a lens of glass blocked.
    std::uint64_t refusedRays = 0;

    TiltLensTracer(TracePixel& owner, const shared_ptr<TiltLensView>& view);

    /// @param ray  from CameraRayOfPov(); reusable
    void TraceRun(tilt_lens::CameraRayBatch& rays, const tilt_lens::SampleRun& run, Ray& ray,
                  tilt_lens::SampleResult* results);
    /// @name For the sample of `pixel` and `index`.
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
    static bool ChiefCameraRay(TracePixel& trace, Ray& ray, DBL x, DBL y, DBL width, DBL height);
    static DBL FirstHit(TracePixel& trace, const Ray& ray);
};

} // namespace pov

#endif
