// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/focus_aids.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{

namespace
{

/// Colours at 0, 1/3, 2/3 and 1.
const Rgb kBehind[4] = {{0.97, 0.97, 0.97}, {0.62, 0.79, 0.91}, {0.22, 0.50, 0.76}, {0.04, 0.20, 0.46}};
const Rgb kBefore[4] = {{0.97, 0.97, 0.97}, {0.99, 0.76, 0.48}, {0.89, 0.46, 0.06}, {0.50, 0.22, 0.02}};

const Rgb kBox{0.10, 0.10, 0.10}, kInk{1.0, 1.0, 1.0};

const Rgb kNearLimit{0.95, 0.50, 0.05}, kFarLimit{0.05, 0.30, 0.95}, kSharpPlane{1.0, 1.0, 1.0};
// low enough to leave surfaces behind all three visible
const double kNearOpacity = 0.25, kFarOpacity = 0.50, kSharpOpacity = 0.20, kLineOpacity = 0.75;

/// Five rows of three dots; the left dot counts 4.
struct Glyph
{
    char character;
    unsigned char rows[5];
};
const Glyph kGlyphs[] = {{'0', {7, 5, 5, 5, 7}}, {'1', {2, 6, 2, 2, 7}}, {'4', {5, 5, 7, 1, 1}}, {'6', {7, 4, 7, 5, 7}},
                         {'-', {0, 0, 7, 0, 0}}, {'A', {2, 5, 7, 5, 5}}, {'B', {6, 5, 6, 5, 6}}, {'C', {7, 4, 4, 4, 7}},
                         {'E', {7, 4, 6, 4, 7}}, {'F', {7, 4, 6, 4, 4}}, {'L', {4, 4, 4, 4, 7}}, {'O', {7, 5, 5, 5, 7}},
                         {'P', {7, 5, 7, 4, 4}}, {'R', {6, 5, 6, 5, 5}}, {'S', {7, 4, 7, 1, 7}}, {'U', {5, 5, 5, 5, 7}},
                         {'X', {5, 5, 2, 5, 5}}};

struct Number
{
    double blur;
    const char* text;
    bool always;
};
const Number kNumbers[] = {{-64, "-64", true}, {-16, "-16", false}, {-4, "-4", false}, {-1, "-1", false}, {0, "0", true},
                           {1, "1", false},    {4, "4", false},     {16, "16", false}, {64, "64", true}};

enum Dots
{
    kAdvance = 4,
    kMargin = 2,
    kText = 5,
    kBar = 5,
    kTick = 2,
    kBoxHeight = kMargin + kText + 1 + kBar + kTick + kText + kMargin
};

Rgb Mixed(const Rgb& a, const Rgb& b, double share)
{
    return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share, a.blue + (b.blue - a.blue) * share};
}

/// Greatest 1, 2 or 5 times a power of ten up to `length`.
double RoundLength(double length)
{
    const double power = std::pow(10.0, std::floor(std::log10(length)));
    return power * (length >= 5.0 * power ? 5.0 : length >= 2.0 * power ? 2.0 : 1.0);
}

} // namespace

double FocusMapPosition(double blur)
{
    return std::copysign(std::min(1.0, std::log1p(std::fabs(blur)) / std::log1p(kMapLimit)), blur);
}

Rgb FocusMapColour(double blur)
{
    const double place = FocusMapPosition(blur), along = 3.0 * std::fabs(place);
    const Rgb* stops = place < 0.0 ? kBehind : kBefore;
    const int stop = std::min(2, int(along));
    return Mixed(stops[stop], stops[stop + 1], along - stop);
}

FocusMapScale::FocusMapScale(int pictureWidth, int pictureHeight)
{
    if (pictureWidth < 64 || pictureHeight < 40)
        return;
    unit = std::max(1, std::min(pictureWidth / 320, pictureHeight / 120));
    width = pictureWidth - 2 * kMargin * unit;
    height = kBoxHeight * unit;
    left = kMargin * unit;
    top = pictureHeight - height - kMargin * unit;
    pixels.assign(size_t(width) * height, kBox);

    const int from = (kMargin + 3 * kAdvance / 2) * unit, span = width - 2 * from;
    const int bar = (kMargin + kText + 1) * unit, numbers = bar + (kBar + kTick) * unit;
    for (int x = 0; x < span; x++)
    {
        const double place = 2.0 * (x + 0.5) / span - 1.0;
        const double blur = std::copysign(std::expm1(std::fabs(place) * std::log1p(kMapLimit)), place);
        Fill(from + x, bar, 1, kBar * unit, FocusMapColour(blur));
    }
    const bool roomy = span >= 120 * unit;
    for (const Number& number : kNumbers)
        if (roomy || number.always)
        {
            const int x = from + int(std::lround(0.5 * (FocusMapPosition(number.blur) + 1.0) * span));
            Fill(x - unit / 2, bar + kBar * unit, unit, (kTick - 1) * unit, kInk);
            Write(x, numbers, number.text);
        }
    Write(from + 2 * kAdvance * unit, kMargin * unit, "FAR");
    Write(from + span - 2 * kAdvance * unit, kMargin * unit, "CLOSE");
    if (roomy)
        Write(from + span / 2, kMargin * unit, "BLUR PX");
}

void FocusMapScale::Fill(int x, int y, int w, int h, const Rgb& colour)
{
    for (int v = std::max(0, y); v < std::min(height, y + h); v++)
        for (int u = std::max(0, x); u < std::min(width, x + w); u++)
            pixels[size_t(v) * width + u] = colour;
}

void FocusMapScale::Write(int centre, int y, const char* text)
{
    int x = centre - (kAdvance * int(std::strlen(text)) - 1) * unit / 2;
    for (; *text != '\0'; text++, x += kAdvance * unit)
        for (const Glyph& glyph : kGlyphs)
            for (int row = 0; row < kText && glyph.character == *text; row++)
                for (int column = 0; column < 3; column++)
                    if (glyph.rows[row] & (4 >> column))
                        Fill(x + column * unit, y + row * unit, unit, unit, kInk);
}

std::optional<Rgb> FocusMapScale::At(int x, int y) const
{
    const int u = x - left, v = y - top;
    if (unit == 0 || u < 0 || u >= width || v < 0 || v >= height)
        return {};
    return pixels[size_t(v) * width + u];
}

FocusPlanes::FocusPlanes(const Lens& itsLens, int itsWidth, int itsHeight) : lens(itsLens), width(itsWidth), height(itsHeight)
{
    // grid lines follow the camera's right where the plane allows
    const Vec3 normal = Length(lens.focus) > 0.0 ? Normalized(lens.focus) : lens.axis;
    const Vec3 across = lens.axisRight - Dot(lens.axisRight, normal) * normal;
    gridX = Normalized(Length(across) > 0.1 ? across : lens.axisUp - Dot(lens.axisUp, normal) * normal);
    gridY = Cross(normal, gridX);
    // about ten lines over the frame
    const double axisFocus = AxisFocusOf(lens), nearest = 1.0 / Length(lens.focus);
    const double crossing = axisFocus > 0.0 && std::isfinite(axisFocus) ? axisFocus : nearest;
    const double distance = std::isfinite(crossing) ? crossing : lens.filmDistance;
    spacing = RoundLength(0.15 * distance * Length(lens.right) / Dot(lens.direction, lens.axis));
}

Vec3 FocusPlanes::Chief(double x, double y) const
{
    return ChiefRay(lens, FilmPointAt(x, y, width, height));
}

/// True if the grid cells of the pixel's corners differ.
bool FocusPlanes::OnGridLine(double x, double y) const
{
    double cell[3][2];
    const double corners[3][2] = {{x, y}, {x + 1.0, y}, {x, y + 1.0}};
    for (int i = 0; i < 3; i++)
    {
        const Vec3 chief = Chief(corners[i][0], corners[i][1]);
        const double w = FocusVergence(lens, chief);
        if (!(w > 0.0))
            return false;
        const Vec3 point = chief / w;
        cell[i][0] = Dot(point, gridX) / spacing;
        cell[i][1] = Dot(point, gridY) / spacing;
    }
    for (int i = 0; i < 2; i++)
    {
        const double step = std::max(std::fabs(cell[1][i] - cell[0][i]), std::fabs(cell[2][i] - cell[0][i]));
        const double at = std::floor(cell[0][i]);
        if (step < 0.25 && (std::floor(cell[1][i]) != at || std::floor(cell[2][i]) != at))
            return true;
    }
    return false;
}

std::vector<Veil> FocusPlanes::Before(int x, int y, double T) const
{
    const Vec3 chief = Chief(x + 0.5, y + 0.5);
    const auto passes = [&](double pixels)
    {
        const double vergence = VergenceOfBlur(lens, chief, pixels, width);
        return vergence > 0.0 && 1.0 / vergence < T;
    };
    std::vector<Veil> veils;
    if (passes(1.0))
        veils.push_back({kNearLimit, kNearOpacity});
    if (passes(0.0))
        veils.push_back({kSharpPlane, OnGridLine(x, y) ? kLineOpacity : kSharpOpacity});
    if (passes(-1.0))
        veils.push_back({kFarLimit, kFarOpacity});
    return veils;
}

} // namespace tilt_lens
