// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Solves camera and block for lens and plane of sharp focus as docs/optics.md does, in doubles; tests/focus compares it with the library.
/// Scene units unless mm is said, degrees, world coordinates.
///
///     camera   { location, direction, right, up }
///     block    { family: "lensTurn" | "focusTurn" | "plane" | "points" | "sharp", filmWidth, focalLength (mm, or null: the
///                angle of view counts), sceneUnit, tilt, swing, focusTilt, focusSwing, planeNormal, planeDistance,
///                points: [A, B, C], sharpPoints: [A, B, C, ...], shift: [right, up], fStop (or null), blades, bladesAngle,
///                focalPoint, aperture (twice the diameter, if fStop is null), scale }

import { planeOfLeastBlur } from "./sharp.js";
import { add, along, cross, dot, length, subtract, times, unit } from "./vector.js";

const DEGREE = Math.PI / 180;
/// Relative to the operands, of a difference that ought to be 0.
const ROUNDING = 1e-14;
const WIDEST_STOP = 0.5;

/// No lens fulfils it. The message appears beside `knob`.
export class LensError extends Error {
    constructor(knob, message) {
        super(message);
        this.knob = knob;
    }
}

/// Right, up, and the film's normal into the scene.
export function axesOf(camera) {
    const right = unit(camera.right);
    const upAcross = along(camera.up, -dot(camera.up, right), right);
    const up = unit(upAcross);
    let axis = cross(right, up);
    if (dot(axis, camera.direction) < 0)
        axis = times(-1, axis);
    const independent = length(upAcross) > ROUNDING * length(camera.up) &&
        dot(axis, camera.direction) > ROUNDING * length(camera.direction);
    if (!independent)
        throw new LensError("camera", "The camera spans no picture: direction, right and up must be independent.");
    return { right, up, axis };
}

const toCamera = (axes, v) => [dot(v, axes.right), dot(v, axes.up), dot(v, axes.axis)];
const toWorld = (axes, v) => add(add(times(v[0], axes.right), times(v[1], axes.up)), times(v[2], axes.axis));

/// In camera axes, turned about the horizontal and the vertical axis.
function turnedNormal(tilt, swing, knob, what) {
    if (!(Math.abs(tilt) < 90 && Math.abs(swing) < 90))
        throw new LensError(knob, `${what} must be turned by less than 90 degrees.`);
    const t = tilt * DEGREE, s = swing * DEGREE;
    return unit([-Math.sin(s) * Math.cos(t), -Math.sin(t) * Math.cos(s), Math.cos(t) * Math.cos(s)]);
}

/// n/d of the plane n.X = d; n is a unit vector.
function focusOfPlane(normal, distance, reach, knob) {
    if (!(Math.abs(distance) > ROUNDING * reach))
        throw new LensError(knob, "This plane passes through the lens. Move it, or one of its points.");
    return times(1 / distance, normal);
}

function focalPointInCamera(axes, camera, block) {
    const point = toCamera(axes, subtract(block.focalPoint, camera.location));
    if (!(point[2] > 0))
        throw new LensError("points", "The point lies behind the camera.");
    return point;
}

function focusOfSharpPoints(axes, camera, block) {
    const ways = block.sharpPoints.map(point => subtract(point, camera.location));
    const behind = ways.findIndex(way => !(dot(way, axes.axis) > ROUNDING * (length(way) + length(camera.location))));
    if (behind >= 0)
        throw new LensError("points", `Point ${behind + 1} is not in front of the lens.`);
    const k = planeOfLeastBlur(block.sharpPoints, camera, axes.axis);
    if (!k)
        throw new LensError("points", "The picture has all points on one line. Move one of them off it, or add another.");
    return toCamera(axes, k);
}

function givenFocus(axes, camera, block) {
    if (block.family === "sharp")
        return focusOfSharpPoints(axes, camera, block);
    if (block.family === "points") {
        const [a, b, c] = block.points;
        const normal = cross(unit(subtract(b, a)), unit(subtract(c, a)));
        if (!(length(normal) > 1e-12))
            throw new LensError("points", "The three points lie on one line. Move one of them off it.");
        const inCamera = toCamera(axes, unit(normal)), point = toCamera(axes, subtract(a, camera.location));
        return focusOfPlane(inCamera, dot(inCamera, point), length(point) + length(camera.location), "points");
    }
    if (block.family === "plane") {
        if (!(length(block.planeNormal) > 0))
            throw new LensError("points", "The plane has no direction.");
        const normal = unit(block.planeNormal);
        return focusOfPlane(toCamera(axes, normal), block.planeDistance - dot(normal, camera.location),
            Math.abs(block.planeDistance) + length(camera.location), "points");
    }
    const normal = turnedNormal(block.focusTilt, block.focusSwing, "focusTurn", "The plane of sharp focus");
    const point = focalPointInCamera(axes, camera, block);
    return focusOfPlane(normal, dot(normal, point), length(point) + length(camera.location), "focusTurn");
}

function solveLensTurn(t, P, focalLength, angleFilmDistance) {
    const distance = dot(P, t), aside = t[0] * P[0] + t[1] * P[1];
    if (!(distance > 0))
        throw new LensError("turn", "The lens is turned so far that the point lies behind it. Turn it less.");
    if (focalLength === null) {
        const s = angleFilmDistance, f = s * distance / (s + P[2]);
        return { t, f, s, k: [t[0] / f, t[1] / f, t[2] / distance - aside / (s * distance)] };
    }
    const f = focalLength;
    if (!(distance - f > ROUNDING * f))
        throw new LensError("focalLength", "The focus is nearer than the focal length. Focus farther away, or take a shorter lens.");
    return { t, f, s: f * P[2] / (distance - f), k: [t[0] / f, t[1] / f, 1 / P[2] - aside / (f * P[2])] };
}

/// Plane of sharp focus as stated; the lens follows.
function solvePlane(k, focalLength, angleFilmDistance, knob) {
    if (focalLength === null) {
        const q = [k[0], k[1], k[2] + 1 / angleFilmDistance], size = length(q);
        if (!(q[2] > ROUNDING * size))
            throw new LensError(knob, "This plane would need a lens turned backward. Turn it, or move it away from the camera.");
        return { t: times(1 / size, q), f: 1 / size, s: angleFilmDistance, k };
    }
    const f = focalLength, sine = f * Math.hypot(k[0], k[1]);
    if (!(1 - sine > ROUNDING))
        throw new LensError("focalLength", "No tilt of this lens reaches this plane. Take a shorter focal length, or turn the plane less.");
    const t = [f * k[0], f * k[1], Math.sqrt((1 - sine) * (1 + sine))];
    const vergence = t[2] / f - k[2];
    if (!(vergence * f > ROUNDING))
        throw new LensError("focalLength", "This plane is nearer than the lens can focus. Focus farther away, or take a shorter lens.");
    return { t, f, s: 1 / vergence, k };
}

/// Film distance for the angle of view, scene units.
export function filmDistanceOfView(camera, block) {
    const { axis } = axesOf(camera);
    return block.filmWidth * (block.scale ?? 1) / block.sceneUnit * dot(axis, camera.direction) / length(camera.right);
}

function solveFor(axes, camera, block, millimetre) {
    const angleFilmDistance = filmDistanceOfView(camera, block);
    const focalLength = block.focalLength === null ? null : block.focalLength * millimetre;
    if (block.family !== "lensTurn")
        return solvePlane(givenFocus(axes, camera, block), focalLength, angleFilmDistance,
            block.family === "focusTurn" ? "focusTurn" : "points");
    const t = turnedNormal(block.tilt, block.swing, "turn", "The lens");
    return solveLensTurn(t, focalPointInCamera(axes, camera, block), focalLength, angleFilmDistance);
}

/// Times the radius, by the smallest rotation of the axis to t.
function spanOfLens(axes, t, radius) {
    const bend = 1 / (1 + t[2]);
    return [[1 - t[0] * t[0] * bend, -t[0] * t[1] * bend, -t[0]], [-t[0] * t[1] * bend, 1 - t[1] * t[1] * bend, -t[1]]]
        .map(v => times(radius, toWorld(axes, v)));
}

/// @throws LensError no lens fulfils it
export function solve(camera, block) {
    const axes = axesOf(camera), millimetre = (block.scale ?? 1) / block.sceneUnit;
    const solved = solveFor(axes, camera, block, millimetre);
    const focus = toWorld(axes, solved.k), rightLength = length(camera.right);
    const diameter = block.fStop === null ? block.aperture * (block.scale ?? 1) / 2 : solved.f / block.fStop;
    let direction = camera.direction;
    if (block.focalLength !== null)
        direction = along(direction, solved.s * rightLength / (block.filmWidth * millimetre) - dot(axes.axis, direction), axes.axis);
    const perMillimetre = rightLength / block.filmWidth, unshifted = direction;
    direction = add(direction, toWorld(axes, [block.shift[0] * perMillimetre, block.shift[1] * perMillimetre, 0]));
    const [lensX, lensY] = spanOfLens(axes, solved.t, diameter / 2);
    const lens = {
        location: camera.location, axisRight: axes.right, axisUp: axes.up, axis: axes.axis,
        normal: toWorld(axes, solved.t), focalLength: solved.f, filmDistance: solved.s, diameter, focus, lensX, lensY,
        direction, unshifted, right: camera.right, up: camera.up, millimetre, focusMiddle: dot(focus, direction),
        focusRight: dot(focus, camera.right), focusUp: dot(focus, camera.up),
    };
    if (![lens.focalLength, lens.filmDistance, lens.focusMiddle, diameter, ...focus].every(Number.isFinite))
        throw new LensError("camera", "The numbers are too large or too small for a lens.");
    return lens;
}

const SHAPE = ["location", "unshifted", "direction", "right", "up", "normal", "focus", "focalLength", "diameter"];

/// Within 1e-4: texts state points by seven digits, and planes through them by fewer.
export const isSameLens = (one, other) => SHAPE.every(name => {
    const [a, b] = [one, other].map(lens => [lens[name]].flat());
    return Math.hypot(...a.map((x, i) => x - b[i])) <= 1e-4 * Math.max(Math.hypot(...a), Math.hypot(...b));
});

/// In camera axes; rounding errors become 0.
function inCamera(lens, v) {
    const least = ROUNDING * length(v);
    return [lens.axisRight, lens.axisUp, lens.axis].map(a => dot(v, a)).map(x => (Math.abs(x) > least ? x : 0));
}

const angle = (across, forward) => Math.atan2(across, forward) / DEGREE + 0;

/// Tilt and swing of the lens, degrees.
export function turnOf(lens) {
    const t = inCamera(lens, lens.normal);
    return { tilt: angle(-t[1], t[2]), swing: angle(-t[0], t[2]) };
}

/// Beyond 90 degrees if they cannot state it.
export function focusTurnOf(lens) {
    const k = inCamera(lens, lens.focus), side = k[2] < 0 ? -1 : 1;
    return { tilt: angle(-k[1] * side, k[2] * side), swing: angle(-k[0] * side, k[2] * side) };
}

/// Angle between lens and film, degrees, which real lenses limit.
export function wholeTurnOf(lens) {
    const t = inCamera(lens, lens.normal);
    return angle(Math.hypot(t[0], t[1]), t[2]);
}

/// In the plane through the lens parallel to the film; Infinity for a parallel lens.
export function hingeDistanceOf(lens) {
    const k = inCamera(lens, lens.focus);
    return 1 / Math.hypot(k[0], k[1]);
}

/// Negative or infinite unless in front of the lens.
export const axisFocusOf = lens => 1 / inCamera(lens, lens.focus)[2];

/// x, y in [-0.5, 0.5], right and up.
export const chiefRay = (lens, x, y) => along(along(lens.direction, x, lens.right), y, lens.up);

/// Per vergence, in a picture `width` pixels wide.
export const blurPerVergence = (lens, width) => lens.diameter * width / length(lens.right);

/// Signed circle of confusion, pixels, of T * chief: positive before the plane of sharp focus.
export const blurDiameter = (lens, chief, T, width) => (1 / T - dot(lens.focus, chief)) * blurPerVergence(lens, width);

export function blurOfPoint(lens, point, width) {
    const X = subtract(point, lens.location), T = dot(X, lens.axis) / dot(lens.direction, lens.axis);
    return (1 - dot(lens.focus, X)) / T * blurPerVergence(lens, width);
}

export const greatestBlur = (lens, points, width) => Math.max(...points.map(point => Math.abs(blurOfPoint(lens, point, width))));

/// Keeps the sharp points within a blur, pixels.
export function widestStop(camera, block, within, width) {
    const lens = solve(camera, { ...block, fStop: 1 });
    return Math.max(WIDEST_STOP, greatestBlur(lens, block.sharpPoints, width) / within);
}

/// For a lens without tilt at its best focus and the same greatest blur; null if impossible.
export function stopWithoutTilt(camera, block, lens, points, width) {
    const vergences = points.map(point => 1 / dot(subtract(point, lens.location), lens.axis));
    const focalPoint = along(lens.location, 2 / (Math.min(...vergences) + Math.max(...vergences)), lens.axis);
    const fStop = lens.focalLength / lens.diameter;
    try {
        const untilted = solve(camera, { ...block, family: "lensTurn", tilt: 0, swing: 0, focalPoint, fStop });
        return fStop * greatestBlur(untilted, points, width) / greatestBlur(lens, points, width);
    } catch {
        return null;
    }
}

/// All points with this signed blur.
export const planeOfBlur = (lens, pixels, width) =>
    along(lens.focus, pixels / (blurPerVergence(lens, width) * dot(lens.direction, lens.axis)), lens.axis);

export function planeOf(lens) {
    const size = length(lens.focus), normal = times(1 / size, lens.focus);
    return { normal, distance: 1 / size + dot(normal, lens.location) };
}

/// x, y in [-0.5, 0.5], right and up, and the distance along the axis.
export function project(lens, point) {
    const X = subtract(point, lens.location), depth = dot(X, lens.axis);
    const [x, y] = inFrame(lens, along(times(dot(lens.direction, lens.axis) / depth, X), -1, lens.direction));
    return { x, y, depth };
}

/// Right and up need not be orthogonal.
export function inFrame(lens, v) {
    const rr = dot(lens.right, lens.right), ru = dot(lens.right, lens.up), uu = dot(lens.up, lens.up);
    const r = dot(v, lens.right), u = dot(v, lens.up), det = rr * uu - ru * ru;
    return [(r * uu - u * ru) / det, (u * rr - r * ru) / det];
}

/// [offset x, y, factor x, y] between two frames of a camera.
export function frameMap(lens, frame) {
    const far = v => dot(v, lens.axis), ratio = far(frame.direction) / far(lens.direction);
    const offset = inFrame({ right: frame.right, up: frame.up }, subtract(times(ratio, lens.direction), frame.direction));
    return [...offset, ratio * length(lens.right) / length(frame.right), ratio * length(lens.up) / length(frame.up)];
}

/// For lenses at one place with the same axes.
export function frameAround(lenses) {
    const [first] = lenses, maps = lenses.map(lens => frameMap(lens, first));
    const [x, y] = [0, 1].map(i => {
        const least = Math.min(...maps.map(map => map[i] - map[i + 2] / 2)), most = Math.max(...maps.map(map => map[i] + map[i + 2] / 2));
        return { middle: (least + most) / 2, size: most - least };
    });
    const { location, axis, right, up } = first;
    return { location, axis, direction: chiefRay(first, x.middle, y.middle), right: times(x.size, right), up: times(y.size, up) };
}

/// At x, y of the picture, at a distance along the axis.
export const pointAt = (lens, x, y, depth) =>
    along(lens.location, depth / dot(lens.direction, lens.axis), chiefRay(lens, x, y));

/// Horizontal angle of view, degrees, ignoring a shift.
export const angleOfView = lens =>
    2 * Math.atan(0.5 * length(lens.right) / dot(lens.direction, lens.axis)) / DEGREE;
