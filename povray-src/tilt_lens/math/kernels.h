// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file kernels.h
/// Functions that use vector registers. The folder kernels/ is compiled twice: into `plain`, and on x86 for AVX2 into `avx2`.

#ifndef TILT_LENS_KERNELS_H
#define TILT_LENS_KERNELS_H

#include <cstddef>
#include <cstdint>

namespace tilt_lens
{

struct CameraSamples;
struct CircleOfConfusion;
struct FilterInput;
struct FilterOutput;
struct FourGlassPoints;
struct FourGlassRays;
struct FourGlassSamples;
struct FourPupils;
struct FourStopPoints;
struct GlassFilm;
struct GlassSurface;
struct GroupTable;
struct Lens;
struct PixelSums;
struct PupilNode;
struct Quads;
struct RayArrays;
struct SampleResult;
struct SequencePoints;
struct SpreadPlanes;

struct Kernels
{
    /// @name Samples
    /// @{

    /// @param first  Sobol point of the group's first sample, bits reversed
    /// @param seeds  scrambling of each dimension
    void (*findPoints)(const std::uint32_t* first, const std::uint32_t* seeds, const GroupTable& steps, SequencePoints& points);

    /// As FilmPointAt(), with weights 1.
    void (*findFilmPoints)(double column, double row, double width, double height, const Quads& quads, const SequencePoints& points,
                           CameraSamples& samples);

    /// Adds one stratum. False, with nothing added, if a radiance is not finite.
    bool (*addRadiances)(const SampleResult* results, std::uint32_t ofFirstBuffer, std::uint32_t count, bool emitters, PixelSums& pixel);
    /// @}

    /// @name Rays
    /// @{

    void (*mapToDisc)(const double* u, const double* v, double* a, double* b, int count);

    void (*findPositions)(const double* u, const double* v, double edges, double* positions, double* radii);

    /// Without distortion.
    /// @param begin, end  multiples of 4
    /// @return            false, with invalid rays, if a squared length may overflow or underflow
    bool (*makeRays)(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end);

    /// @param surfaces  the first of each ray's lens; lenses differ in indices alone
    /// @param count     of a lens's surfaces
    unsigned int (*traceGlass)(const GlassSurface* const (&surfaces)[4], std::size_t count, double stopScale, bool rims,
                               FourGlassRays& rays, FourStopPoints& stop);

    void (*findPupils)(const GlassFilm& film, const PupilNode* nodes, const FourGlassPoints& points, FourPupils& pupils);

    /// @param a, b  points of the unit disc
    /// @return      one bit per ray that exists
    unsigned int (*aimAtPupils)(const FourPupils& pupils, const double* a, const double* b, FourGlassRays& rays);

    /// World frame.
    void (*leaveGlass)(const GlassFilm& film, const FourGlassPoints& points, const FourGlassRays& rays, FourGlassSamples& samples);
    /// @}

    /// @name Reconstruction
    /// @{

    /// False, with nothing changed, if the circle holds only its own pixel.
    bool (*spreadSample)(SpreadPlanes& planes, int column, int row, const CircleOfConfusion& circle, const double* radiance, float weight);

    void (*filterBlock)(const FilterInput& input, const FilterOutput& output);

    void (*estimateSpread)(const FilterInput& input, const FilterOutput& output);
    /// @}
};

namespace plain
{
extern const Kernels kKernels;
}

#ifdef TILT_LENS_AVX2
namespace avx2
{
extern const Kernels kKernels;
}
#endif

/// Variant for this processor; tests replace it.
extern const Kernels* kernels;

} // namespace tilt_lens

#endif
