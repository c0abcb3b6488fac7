// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The lens as text for a scene: the `tilt_lens` block in three forms, and the items of the camera that go with it.

import { along, cross, dot, length, subtract, times, unit } from "./vector.js";
import { angleOfView, planeOf, turnOf } from "./lens.js";

export const FORMS = { points: "three points", plane: "plane", angles: "angles" };
const DIGITS = 7;

/// What of the block a program must find in the scene: of each, and by family.
const EXPECTED = ["family", "filmWidth", "focalLength", "sceneUnit", "shift", "fStop", "blades", "bladesAngle"];
const FOCUS = { lensTurn: ["tilt", "swing", "focalPoint"], plane: ["planeNormal", "planeDistance"], points: ["points"] };

/// A number with few digits, for a length of this size: what is only rounding beside it is 0.
export function rounded(value, size = Math.abs(value)) {
    if (!(size > 0) || Math.abs(value) < 1e-9 * size)
        return 0;
    const places = Math.max(0, DIGITS - 1 - Math.floor(Math.log10(size)));
    return Number(value.toFixed(Math.min(places, 15)));
}

const vector = v => `<${v.map(text).join(", ")}>`;

function text(value) {
    const plain = String(value);
    return /e/.test(plain) ? value.toExponential().replace("e+", "e") : plain;
}

const roundedVector = (v, size = length(v)) => v.map(x => rounded(x, size));

/// Three points of the plane of sharp focus: those that were picked, or ones near what the picture shows.
function threePoints(model) {
    if (model.block.family === "points")
        return model.block.points;
    const { lens } = model, first = model.anchor(), normal = unit(lens.focus);
    const size = length(subtract(first, lens.location)) / 4;
    const across = along(lens.axisRight, -dot(lens.axisRight, normal), normal);
    const x = unit(length(across) > 0.1 ? across : along(lens.axisUp, -dot(lens.axisUp, normal), normal));
    const y = cross(normal, x);
    return [first, along(first, size, x), along(first, size, y)];
}

/// The block with rounded numbers, in a form.
function roundedBlock(model, form) {
    const { block, lens } = model, reach = length(lens.location) + 1 / Math.min(length(lens.focus), 1e9);
    const said = {
        ...block, filmWidth: rounded(block.filmWidth), sceneUnit: rounded(block.sceneUnit), fStop: rounded(block.fStop),
        focalLength: block.focalLength === null ? null : rounded(block.focalLength), shift: block.shift.map(x => rounded(x, block.filmWidth)),
        bladesAngle: rounded(block.bladesAngle), aperture: 0, scale: 1,
    };
    if (form === "points")
        return { ...said, family: "points", points: threePoints(model).map(p => roundedVector(p, Math.max(length(p), 0.01 * reach))) };
    const plane = planeOf(lens);
    if (form === "plane")
        return { ...said, family: "plane", planeNormal: roundedVector(plane.normal, 1), planeDistance: rounded(plane.distance, reach) };
    const { tilt, swing } = turnOf(lens), point = model.anchor();
    return { ...said, family: "lensTurn", tilt: rounded(tilt, 10), swing: rounded(swing, 10), focalPoint: roundedVector(point, Math.max(length(point), 0.01 * reach)) };
}

function focusItems(block) {
    if (block.family === "points")
        return [`focal_points ${block.points.map(vector).join(", ")}`];
    if (block.family === "plane")
        return [`focal_plane { ${vector(block.planeNormal)}, ${text(block.planeDistance)} }`];
    return [block.tilt && `tilt ${text(block.tilt)}`, block.swing && `swing ${text(block.swing)}`];
}

const expected = block => Object.fromEntries([...EXPECTED, ...FOCUS[block.family]].map(name => [name, block[name]]));

/// @returns { block: text, items: camera items (text, or null: must go), expect: what a program must find in the scene }
export function describe(model, form) {
    const said = roundedBlock(model, form), { camera } = model;
    const lines = [
        said.sceneUnit !== 1000 && `scene_unit ${text(said.sceneUnit)}`,
        said.filmWidth !== 36 && `film_width ${text(said.filmWidth)}`,
        said.focalLength !== null && `focal_length ${text(said.focalLength)}`,
        `f_stop ${text(said.fStop)}`,
        said.blades > 0 && `blades ${said.blades}${said.bladesAngle ? `, ${text(said.bladesAngle)}` : ""}`,
        (said.shift[0] || said.shift[1]) && `shift <${said.shift.map(text).join(", ")}>`,
        ...focusItems(said),
    ].filter(Boolean);
    const items = {};
    if (model.given.aperture)
        items.aperture = null;
    let { direction } = camera;
    if (said.focalLength !== null) {
        items.angle = null;
    } else {
        const angle = angleOfView({ ...model.lens, direction });
        if (Math.abs(angle - model.given.angle) > 1e-9) {
            items.angle = text(rounded(angle));
            const wanted = 0.5 * length(camera.right) / Math.tan(rounded(angle) * Math.PI / 360);
            direction = times(wanted / dot(model.lens.axis, direction), direction);
        }
    }
    if (said.family === "lensTurn")
        items.focal_point = vector(said.focalPoint);
    return {
        block: `tilt_lens {\n${lines.map(line => `  ${line}`).join("\n")}\n}`,
        items,
        expect: { block: expected(said), camera: { location: camera.location, direction, right: camera.right, up: camera.up } },
    };
}

/// The text to copy: camera items, then the block.
/// @param kept  further items of the block, as text
export function copyText({ items, block }, kept = []) {
    const lines = Object.entries(items).filter(([, value]) => value !== null).map(([name, value]) => `${name} ${value}`);
    return [...lines, block.replace(/}$/, [...kept.map(item => `  ${item}\n`), "}"].join(""))].join("\n");
}
