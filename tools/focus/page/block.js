// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The lens as text: the `tilt_lens` block by "points", "plane" or "angles", and its camera items.

import { along, cross, dot, length, subtract, times, unit } from "./vector.js";
import { planeOf, turnOf, widestStop } from "./lens.js";
import { pullAt } from "./pull.js";
import { WORLD, movedDirection, movedPoint, planeBefore } from "./place.js";

const DIGITS = 7;

/// Compared with the program's answer: always, and by family.
const EXPECTED = ["family", "filmWidth", "focalLength", "sceneUnit", "shift", "fStop", "blades", "bladesAngle"];
const FOCUS = { lensTurn: ["tilt", "swing", "focalPoint"], plane: ["planeNormal", "planeDistance"], points: ["points"], sharp: ["sharpPoints", "sharpWithin"] };

/// Few digits for a length of this size; rounding errors become 0.
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

/// The fewest digits within a fifth of a millionth.
const short = value => [1, 2, 3, 4, 5, 6].map(digits => Number(value.toPrecision(digits))).find(few => Math.abs(few - value) < 2e-7 * Math.abs(value)) ??
    rounded(value);

const roundedVector = (v, size = length(v)) => v.map(x => rounded(x, size));

export function threePoints(model) {
    if (model.block.family === "points")
        return model.block.points;
    const { lens } = model, first = model.anchor(), normal = unit(lens.focus);
    const size = length(subtract(first, lens.location)) / 4;
    const across = along(lens.axisRight, -dot(lens.axisRight, normal), normal);
    const x = unit(length(across) > 0.1 ? across : along(lens.axisUp, -dot(lens.axisUp, normal), normal));
    const y = cross(normal, x);
    return [first, along(first, size, x), along(first, size, y)];
}

const pointIn = ({ inverse }, lens) => world => {
    const local = movedPoint(inverse, world);
    return roundedVector(local, length(subtract(local, movedPoint(inverse, lens.location))));
};

/// Millimetres on the film.
function widestBlur({ within, onFilm, width }, { filmWidth }) {
    const blur = within * filmWidth / width;
    return onFilm ? rounded(blur) : blur;
}

function roundedBlock(model, form, place) {
    const { matrix, inverse, scale } = place, point = pointIn(place, model.lens);
    const { block, lens } = model, location = movedPoint(inverse, lens.location);
    const said = {
        ...block, filmWidth: rounded(block.filmWidth), sceneUnit: short(block.sceneUnit * scale), fStop: rounded(block.fStop),
        focalLength: block.focalLength === null ? null : rounded(block.focalLength), shift: block.shift.map(x => rounded(x, block.filmWidth)),
        bladesAngle: rounded(block.bladesAngle), aperture: 0, sharpWithin: null, scale,
    };
    if (form === "points" && block.family === "sharp")
        return { ...said, sharpPoints: block.sharpPoints.map(point), sharpWithin: model.holds ? widestBlur(model, said) : null };
    if (form === "points")
        return { ...said, family: "points", points: threePoints(model).map(point) };
    if (form === "plane") {
        const { normal, distance } = planeBefore(matrix, planeOf(lens)), reach = Math.abs(distance - dot(normal, location));
        return {
            ...said, family: "plane", planeNormal: roundedVector(normal, reach / (reach + length(location))),
            planeDistance: rounded(distance, reach),
        };
    }
    const { tilt, swing } = turnOf(lens);
    return { ...said, family: "lensTurn", tilt: rounded(tilt, 10), swing: rounded(swing, 10), focalPoint: point(model.anchor()) };
}

function focusItems(block, { within, onFilm }) {
    if (block.family === "sharp") {
        const points = block.sharpPoints.map(vector).join(block.sharpPoints.length > 3 ? ",\n    " : ", ");
        const limit = onFilm ? `circle_of_confusion ${text(block.sharpWithin)}` : `sharp_within ${text(within)}`;
        return [`sharp_points ${points}`, block.sharpWithin !== null && limit];
    }
    if (block.family === "points")
        return [`focal_points ${block.points.map(vector).join(", ")}`];
    if (block.family === "plane")
        return [`focal_plane { ${vector(block.planeNormal)}, ${text(block.planeDistance)} }`];
    return [block.tilt && `tilt ${text(block.tilt)}`, block.swing && `swing ${text(block.swing)}`];
}

function expected(block, { matrix, inverse, scale }, camera, { width }) {
    const plane = planeBefore(inverse, { normal: unit(block.planeNormal), distance: block.planeDistance });
    const world = {
        ...block, sceneUnit: block.sceneUnit / scale, points: block.points.map(point => movedPoint(matrix, point)),
        planeNormal: plane.normal, planeDistance: plane.distance, focalPoint: movedPoint(matrix, block.focalPoint),
        sharpPoints: block.sharpPoints.map(point => movedPoint(matrix, point)), scale: 1,
    };
    if (world.sharpWithin !== null)
        world.fStop = widestStop(camera, world, world.sharpWithin * width / world.filmWidth, width); // of the rounded points
    return Object.fromEntries([...EXPECTED, ...FOCUS[block.family]].map(name => [name, world[name]]));
}

const angleOf = ({ direction, right }, { inverse }) =>
    2 * Math.atan(0.5 * length(movedDirection(inverse, right)) / length(movedDirection(inverse, direction))) * 180 / Math.PI;

/// @param place coordinates of the text, or WORLD
/// @returns { block: text, items: camera items (text, or null to remove), expect: the block that the program must find }
export function describe(model, form, place = model.place) {
    const said = roundedBlock(model, form, place), { camera } = model;
    const lines = [
        said.sceneUnit !== 1000 && `scene_unit ${text(said.sceneUnit)}`,
        said.filmWidth !== 36 && `film_width ${text(said.filmWidth)}`,
        said.focalLength !== null && `focal_length ${text(said.focalLength)}`,
        said.sharpWithin === null && `f_stop ${text(said.fStop)}`,
        said.blades > 0 && `blades ${said.blades}${said.bladesAngle ? `, ${text(said.bladesAngle)}` : ""}`,
        (said.shift[0] || said.shift[1]) && `shift <${said.shift.map(text).join(", ")}>`,
        ...focusItems(said, model),
    ].filter(Boolean);
    const items = {};
    if (model.given.aperture)
        items.aperture = null;
    let { direction } = camera;
    if (said.focalLength !== null) {
        items.angle = null;
    } else {
        const angle = angleOf(camera, place);
        if (Math.abs(angle - angleOf(model.given, place)) > 1e-9) {
            items.angle = text(rounded(angle));
            direction = times(Math.tan(angle * Math.PI / 360) / Math.tan(rounded(angle) * Math.PI / 360), direction);
        }
    }
    if (said.family === "lensTurn")
        items.focal_point = vector(said.focalPoint);
    const { location, right, up } = camera, seen = { location, direction, right, up };
    return {
        block: `tilt_lens {\n${lines.map(line => `  ${line}`).join("\n")}\n}`,
        items,
        expect: { block: expected(said, place, seen, model), camera: seen },
    };
}

export function change(model, form) {
    const { block, expect } = describe(model, form === "angles" ? "plane" : form, { ...WORLD, scale: model.place.scale });
    return { ...describe(model, form), behind: { block, expect } };
}

function timesToTry(keys) {
    const times = (keys.length <= 4 ? keys : [keys[0], keys[1], keys.at(-1)]).map(key => key.time);
    return [...times, keys[0].time + (keys[1].time - keys[0].time) / 4];
}

/// @returns as describe(), and { head: text, checks: [{ time, expect }] }
export function describePull(model, keys) {
    const { place, lens } = model, plain = describe(model, "plane"), point = pointIn(place, lens);
    const location = movedPoint(place.inverse, lens.location), reach = length(subtract(movedPoint(place.inverse, keys[0].points[0]), location));
    const seenFrom = location.map(x => (Math.abs(x) < 1e-12 * reach ? 0 : Number(x.toPrecision(12))));
    const said = keys.map(({ time, stop, points }) => ({ time, stop: rounded(stop), points: points.map(point) }));
    const lines = said.map(({ time, stop, points }) => `Tilt_Lens_Key_Points(${[text(time), text(stop), ...points.map(vector)].join(", ")})\n`);
    const items = plain.block.split("\n").filter(line => !/^ *(f_stop|focal_plane|[{}])/.test(line)).slice(1);
    const world = said.map(key => ({ ...key, points: key.points.map(p => movedPoint(place.matrix, p)) }));
    return {
        ...plain, head: `#include "tilt_lens.inc"\n#declare Tilt_Lens_Keys = 0;\n${lines.join("")}`,
        block: `tilt_lens {\n${items.map(line => `${line}\n`).join("")}  Tilt_Lens_Pull(clock, ${vector(seenFrom)})\n}`,
        checks: timesToTry(keys).map(time => {
            const at = pullAt(world, time, lens.location), { block, camera } = plain.expect;
            return { time, expect: { camera, block: { ...block, ...at } } };
        }),
    };
}

export function copyText({ items, block }, kept = []) {
    const lines = Object.entries(items).filter(([, value]) => value !== null).map(([name, value]) => `${name} ${value}`);
    return [...lines, block.replace(/}$/, [...kept.map(item => `  ${item}\n`), "}"].join(""))].join("\n");
}
