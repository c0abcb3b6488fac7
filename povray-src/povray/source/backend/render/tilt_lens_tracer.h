// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_tracer.h
/// Bridge from the camera library to POV-Ray's tracing; a friend of TracePixel.

#ifndef POVRAY_BACKEND_TILT_LENS_TRACER_H
#define POVRAY_BACKEND_TILT_LENS_TRACER_H

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/lighting/area_light_sampler.h"
#include "backend/render/trace.h"
#include "backend/scene/tilt_lens_view.h"
#include "backend/support/sample_seeds.h"
#include "tilt_lens/samples/sample_tracer.h"

namespace pov
{

class Ray;
class TracePixel;

inline Colour ToColour(const tilt_lens::Radiance& v)
{
    return Colour(v[pRED], v[pGREEN], v[pBLUE], v[pFILTER], v[pTRANSM]);
}

class TiltLensTracer : private SampleSeedSource, private tilt_lens::RayTracer
{
  public:
    /// @param owner  must outlive the result
    /// @return       NULL without a lens with an aperture
    static shared_ptr<TiltLensTracer> Create(TracePixel& owner, const shared_ptr<TiltLensView>& view);

    /// May be NULL.
    static TiltLensTracer* Of(const TracePixel& owner);

    const shared_ptr<TiltLensView> view;
    tilt_lens::SampleTracer samples;
    AreaLightSampler areaLights;

    /// Takes a row of the search for lamps. Without radiosity: its samples would depend on the order of the rows.
    void Search(std::size_t row);

    void TracePreview(DBL x, DBL y, DBL width, DBL height, Colour& colour);

    /// With whole grids of area lights; returns the distance to the hit.
    DBL TraceAlone(const Ray& ray, unsigned int x, unsigned int y, Colour& colour);

    const Camera& GetCamera() const;
    RenderStatistics& Stats();

  private:
    TracePixel& trace;
    tilt_lens::SampleTracer plainSamples;
    const bool interiorsVary;  ///< rays start in different objects' interiors

    const tilt_lens::PixelSampler* pixel = NULL;
    unsigned int index = 0;
    unsigned int radiosityDepth = 0;  ///< at which rays begin

    TiltLensTracer(TracePixel& owner, const shared_ptr<TiltLensView>& view);

    virtual void Trace(const tilt_lens::CameraRays& rays, const tilt_lens::RayRange& range, tilt_lens::Hit* hits);
    virtual unsigned int Seed() const { return pixel->Hash(index); }

    DBL Follow(const Ray& ray, pov::Trace::TraceTicket ticket, Colour& colour);
    pov::Trace::TraceTicket NewTicket() const;
    void EnterInteriors(Ray& ray) const;
    void LeadGenerators();
    void SeedSubsurface(unsigned int seed);
};

} // namespace pov

#endif
