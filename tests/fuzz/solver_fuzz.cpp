// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file solver_fuzz.cpp
/// libFuzzer's target for the solver. The result must be finite rays with a direction, or an error.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/lens_camera/solve.h"
#include "tilt_lens/samples/sequence.h"

namespace
{

using namespace tilt_lens;

class Bytes
{
  public:
    Bytes(const std::uint8_t* itsData, std::size_t itsSize) : data(itsData), size(itsSize) {}

    template<typename T>
    T Take()
    {
        T value{};
        const std::size_t count = sizeof value < size ? sizeof value : size;
        std::memcpy(&value, data, count);
        data += count;
        size -= count;
        return value;
    }
    double Number() { return Take<double>(); }
    Vec3 Vector()
    {
        const double x = Number(), y = Number(), z = Number();
        return {x, y, z};
    }

  private:
    const std::uint8_t* data;
    std::size_t size;
};

[[noreturn]] void Fail(const char* what)
{
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

Statement StatementFrom(Bytes& bytes, unsigned flags)
{
    Statement s;
    s.family = FocusFamily(flags & 3);
    if (flags & 4)
        s.focalLength = bytes.Number();
    if (flags & 8)
        s.fStop = bytes.Number();
    else
        s.aperture = bytes.Number();
    if (flags & 16)
        s.filmWidth = bytes.Number();
    if (flags & 32)
        s.sceneUnit = bytes.Number();
    if (flags & 64)
        s.scale = bytes.Number();
    s.tilt = s.focusTilt = bytes.Number();
    s.swing = s.focusSwing = bytes.Number();
    s.planeNormal = s.points[0] = bytes.Vector();
    s.focalPoint = s.points[1] = bytes.Vector();
    s.points[2] = bytes.Vector();
    s.planeDistance = bytes.Number();
    s.shiftRight = bytes.Number();
    s.shiftUp = bytes.Number();
    s.blades = bytes.Take<std::int16_t>();
    s.bladesAngle = bytes.Number();
    const unsigned more = bytes.Take<std::uint8_t>();  // absent in older inputs
    if (s.family == FocusFamily::FocalPoints && more != 0)
    {
        s.family = FocusFamily::SharpPoints;
        s.sharpPoints.assign(s.points, s.points + 3);
        for (unsigned i = 0; i < more % 4; i++)
            s.sharpPoints.push_back(bytes.Vector());
        if (more & 4)
            s.sharpWithin = bytes.Number();
    }
    return s;
}

void Use(const Lens& lens, const Statement& s, std::uint32_t seed)
{
    for (const std::string& warning : Warnings(lens, s))
        if (warning.empty())
            Fail("a warning without words");
    const double told[] = {TiltOf(lens), SwingOf(lens), FocusAngleOf(lens)};
    for (double number : told)
        if (!(number >= -90.0 && number <= 90.0))
            Fail("an angle past 90 degrees");
    const SharpRange range = SharpRangeOf(lens, 100000.0, 1.0);
    if (range.near != range.near || range.far != range.far || HingeDistanceOf(lens) != HingeDistanceOf(lens))
        Fail("a number in the report is none");

    const PixelSampler sampler(seed, seed >> 16, 0);
    const Aperture disc = Aperture::Disc();
    for (std::uint32_t i = 0; i < 8; i++)
    {
        const SequencePoint sample = sampler(i);
        const AperturePoint p = disc(sample.lensU, sample.lensV);
        const double x = i < 4 ? (i & 1 ? 0.5 : -0.5) : sample.pixelX - 0.5;
        const double y = i < 4 ? (i & 2 ? 0.5 : -0.5) : sample.pixelY - 0.5;
        const LensRay ray = MakeRay(lens, x, y, p.a, p.b);
        const double length = Length(ray.direction);
        if (!IsFinite(ray.origin) || !(length > 0.0) || !IsFinite(ray.direction / length))
            Fail("a ray without numbers");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const unsigned flags = bytes.Take<std::uint8_t>();
    const std::uint32_t seed = bytes.Take<std::uint32_t>();
    CameraFrame camera;
    if (flags & 128)
        camera = {bytes.Vector(), bytes.Vector(), bytes.Vector(), bytes.Vector()};
    else
        camera = {bytes.Vector(), {0, 0, 1.6}, {1.6, 0, 0}, {0, 1.2, 0}};
    const Statement s = StatementFrom(bytes, flags);
    try
    {
        Use(Solve(camera, s), s, seed);
    }
    catch (const OpticsError& error)
    {
        const std::string words = error.what();
        if (words.size() < 40 || words.back() != '.')
            Fail("an error without words");
    }
    return 0;
}
