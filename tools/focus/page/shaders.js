// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Shaders. Pixels count from the picture's upper left corner; "film" is a point of the frame, x and y in [-0.5, 0.5], right and up. See
/// docs/focus.md for the method.
///
/// Optional parts are compiled by #ifdef, because graphics processors compute both sides of a branch.

export const EVERYWHERE = `#version 300 es
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
}`;

const SCENE = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D preview;
uniform vec2 size;          // of the picture being made, pixels
uniform vec4 toPreview;     // film of the picture -> film of the preview: xy + zw * film
uniform float axisLength;   // of the chief ray along the axis: vergence = axisLength / distance
uniform vec3 focus;         // w of the plane of sharp focus: x + y film.x + z film.y
uniform vec4 lensSpan;      // image of the lens per unit of vergence, in film: columns for its right and up
uniform vec2 lensLean;      // variation of its axial components over the frame

vec2 filmOf(vec2 pixel) { return vec2(pixel.x / size.x - 0.5, 0.5 - pixel.y / size.y); }

ivec2 previewPixel(vec2 film) {
    vec2 there = toPreview.xy + toPreview.zw * film;
    return ivec2(floor(vec2(there.x + 0.5, 0.5 - there.y) * vec2(textureSize(preview, 0))));
}

bool isInside(ivec2 p) { ivec2 s = textureSize(preview, 0); return p.x >= 0 && p.y >= 0 && p.x < s.x && p.y < s.y; }

float focusAt(vec2 film) { return focus.x + focus.y * film.x + focus.z * film.y; }

// pixels, down positive, that the lens's right and up rim span per unit of vergence
mat2 spanAt(vec2 film) {
    vec2 a = lensSpan.xy - lensLean.x * film, b = lensSpan.zw - lensLean.y * film;
    return mat2(a.x * size.x, -a.y * size.y, b.x * size.x, -b.y * size.y);
}
`;

/// Lens points; a power of two.
export const LIST = 4096;

export const GATHER = SCENE + `
uniform sampler2D reach;    // for each tile of the preview: largest |vergence difference| that may reach it
uniform float tile;         // side of such a tile, pixels of the preview
uniform float pixelsPerVergence; // radius of the blur
uniform int taps, pass;
#ifdef BLADES
uniform float corners, turn; // of the diaphragm
#endif
uniform sampler2D lensPoints; // LIST points of the diaphragm (xy) and of the disc around it (zw)
uniform sampler2D mean;     // of the passes before
out vec4 result;

const float PI = 3.14159265358979;
const int LIST = ${LIST};

// first index in the list of lens points, every interval of which is evenly spread
int startAt(vec2 p) {
    float noise = fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715))));
    return int(noise * float(LIST)) + pass * taps;
}

vec4 lensPoint(int i) { return texelFetch(lensPoints, ivec2(i & (LIST - 1), 0), 0); }

bool inDiaphragm(vec2 p) {
#ifdef BLADES
    float half_ = PI / corners, angle = mod(atan(p.y, p.x) - turn, 2.0 * half_) - half_;
    return length(p) * cos(angle) <= cos(half_);
#else
    return dot(p, p) <= 1.0;
#endif
}

vec4 surfaceAt(vec2 pixel, out float difference) {
    vec2 film = filmOf(pixel);
    ivec2 p = previewPixel(film);
    vec4 found = texelFetch(preview, clamp(p, ivec2(0), textureSize(preview, 0) - 1), 0);
    difference = axisLength * found.a - focusAt(film);
    return found;
}

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, size.y - gl_FragCoord.y), film = filmOf(pixel);
    ivec2 here = previewPixel(film);
    if (!isInside(here)) {
        result = vec4(0.0);
        return;
    }
    float own;
    vec4 self = surfaceAt(pixel, own);
    mat2 span = spanAt(film);
    int start = startAt(pixel);
    float ownRadius = abs(own) * pixelsPerVergence;

    // rays that meet this surface, or a farther one beside it; nearer surfaces are added below
    vec3 sum = self.rgb;
    float count = 1.0;
    if (ownRadius > 0.5) {
        sum = vec3(0.0);
        count = 0.0;
        for (int i = 0; i < taps; i++) {
            float difference;
            vec4 there = surfaceAt(pixel + span * lensPoint(start + i).xy * own, difference);
            float nearer = (there.a - self.a) * axisLength * pixelsPerVergence;
            float weight = 1.0 - smoothstep(0.15, 0.3, nearer / max(ownRadius, 3.0));
            sum += weight * there.rgb;
            count += weight;
        }
        if (count < 0.01) {
            sum = self.rgb;
            count = 1.0;
        }
    }
    vec3 colour = sum / count;

    // nearer blurred surfaces: each spreads over its image of the diaphragm
    float widest = texelFetch(reach, clamp(here / int(tile), ivec2(0), textureSize(reach, 0) - 1), 0).r;
    if (widest * pixelsPerVergence > 1.0) {
        vec4 front = vec4(0.0);
        mat2 back = inverse(span);
#ifdef BLADES
        float area = corners / (2.0 * PI) * sin(2.0 * PI / corners);
#else
        float area = 1.0;
#endif
        for (int i = 0; i < taps; i++) {
            vec2 offset = span * lensPoint(start + i).zw * widest;
            float difference;
            vec4 there = surfaceAt(pixel + offset, difference);
            float nearer = (there.a - self.a) * axisLength * pixelsPerVergence;
            float radius = abs(difference) * pixelsPerVergence;
            if (radius > 1.0 && nearer > 0.0 && inDiaphragm(back * offset / difference)) {
                float weight = smoothstep(0.15, 0.3, nearer / max(ownRadius, 3.0));
                front += weight * vec4(there.rgb, 1.0) * (widest * widest) / (difference * difference * area * float(taps));
            }
        }
        float covered = min(front.a, 1.0);
        if (front.a > 0.0)
            colour = mix(colour, front.rgb / front.a, covered);
    }
    vec3 before = pass == 0 ? vec3(0.0) : texelFetch(mean, ivec2(gl_FragCoord.xy), 0).rgb;
    result = vec4(mix(before, colour, 1.0 / float(pass + 1)), 1.0);
}`;

export const DISPLAY = SCENE + `
uniform sampler2D mean;     // the blurred picture, perhaps of another size
uniform float gamma;        // of the scene's colours
uniform float pixelsOfBlur; // diameter per unit of vergence
uniform vec3 peakingColour; // in the scene's colour space
uniform vec3 limits[3];     // w of the near limit, the plane of sharp focus, the far limit
uniform vec3 tints[3];      // in the scene's colour space
uniform vec3 gridX[3], gridY[3]; // chief ray (centre, right, up) along the plane's own directions
uniform vec3 empty;         // where there is no picture yet
out vec4 result;

vec3 meanAt(vec2 pixel) {
    vec2 at = pixel / size * vec2(textureSize(mean, 0)) - 0.5;
    at.y = float(textureSize(mean, 0).y) - 1.0 - at.y;
    ivec2 first = ivec2(floor(at)), last = textureSize(mean, 0) - 1;
    vec2 part = at - vec2(first);
    vec4 a = mix(texelFetch(mean, clamp(first, ivec2(0), last), 0), texelFetch(mean, clamp(first + ivec2(1, 0), ivec2(0), last), 0), part.x);
    vec4 b = mix(texelFetch(mean, clamp(first + ivec2(0, 1), ivec2(0), last), 0), texelFetch(mean, clamp(first + 1, ivec2(0), last), 0), part.x);
    vec4 c = mix(a, b, part.y);
    return c.a > 0.0 ? c.rgb / c.a : empty;
}

vec3 displayed(vec3 colour) {
    colour = clamp(colour, 0.0, 1.0);
#ifdef GAMMA
    vec3 light = pow(colour, vec3(gamma));
    colour = mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
#endif
    return colour;
}

// the colours of focus_map (povray-src/tilt_lens/camera/focus_aids.cpp)
vec3 mapColour(float blur) {
    const vec3 sharp = vec3(0.97);
    const vec3 behind[3] = vec3[3](vec3(0.62, 0.79, 0.91), vec3(0.22, 0.50, 0.76), vec3(0.04, 0.20, 0.46));
    const vec3 before[3] = vec3[3](vec3(0.99, 0.76, 0.48), vec3(0.89, 0.46, 0.06), vec3(0.50, 0.22, 0.02));
    float along = 3.0 * min(1.0, log(1.0 + abs(blur)) / log(65.0));
    int stop = min(2, int(along));
    vec3 to = blur < 0.0 ? behind[stop] : before[stop];
    vec3 from = stop == 0 ? sharp : blur < 0.0 ? behind[stop - 1] : before[stop - 1];
    return mix(from, to, along - float(stop));
}

float linear(vec3 form, vec2 film) { return form.x + form.y * film.x + form.z * film.y; }

bool onGridLine(vec2 pixel) {
    vec2 cell[3];
    for (int i = 0; i < 3; i++) {
        vec2 film = filmOf(pixel + vec2(i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0) - 0.5);
        float w = linear(limits[1], film);
        if (w <= 0.0)
            return false;
        cell[i] = vec2(linear(gridX[0], film), linear(gridY[0], film)) / w;
    }
    vec2 steps = max(abs(cell[1] - cell[0]), abs(cell[2] - cell[0]));
    bvec2 crossed = bvec2(floor(cell[1].x) != floor(cell[0].x) || floor(cell[2].x) != floor(cell[0].x),
                          floor(cell[1].y) != floor(cell[0].y) || floor(cell[2].y) != floor(cell[0].y));
    return (crossed.x && steps.x < 0.25) || (crossed.y && steps.y < 0.25);
}

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, size.y - gl_FragCoord.y), film = filmOf(pixel);
    ivec2 here = previewPixel(film);
    if (!isInside(here)) {
        result = vec4(empty, 1.0);
        return;
    }
    vec4 surface = texelFetch(preview, here, 0);
    float vergence = axisLength * surface.a, blur = (vergence - focusAt(film)) * pixelsOfBlur;
#ifdef MAP
    result = vec4(mapColour(blur), 1.0);
    return;
#endif
#ifdef BLURRED
    vec3 colour = meanAt(pixel);
#else
    vec3 colour = surface.rgb;
#endif
#ifdef PEAKING
    if (abs(blur) < 1.0)
        colour = mix(colour, peakingColour, 0.5);
#endif
#ifdef PLANES
    // from behind: far limit, plane of sharp focus, near limit, each where it is nearer than the surface
    float opacity[3] = float[3](0.25, onGridLine(pixel) ? 0.75 : 0.20, 0.50);
    for (int i = 2; i >= 0; i--) {
        float w = linear(limits[i], film);
        if (w > 0.0 && w > vergence)
            colour = mix(colour, tints[i], opacity[i]);
    }
#endif
    result = vec4(displayed(colour), 1.0);
}`;
