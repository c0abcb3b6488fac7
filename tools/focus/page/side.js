// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// A section through the lens along the axis and across the hinge line; vertical for a lens that is not turned.

import { along, dot, length, unit } from "./vector.js";
import { axisFocusOf, planeOfBlur } from "./lens.js";

const MARGIN = 4; // beside a label
const NAME = "http://www.w3.org/2000/svg";

function shape(name, attributes, text) {
    const made = document.createElementNS(NAME, name);
    for (const [key, value] of Object.entries(attributes))
        made.setAttribute(key, value);
    if (text !== undefined)
        made.textContent = text;
    return made;
}

/// The lean of the plane of sharp focus; up without one.
function leaning(lens) {
    const across = along(lens.focus, -dot(lens.focus, lens.axis), lens.axis);
    if (length(across) < 1e-9 * length(lens.focus))
        return lens.axisUp;
    const up = unit(across);
    return dot(up, lens.axisUp) < -1e-9 ? [-up[0], -up[1], -up[2]] : up;
}

function windowOf(lens, up, meeting, hinge, surfaces) {
    const focus = axisFocusOf(lens), reach = focus > 0 && Number.isFinite(focus) ? focus : 1 / length(lens.focus);
    const far = Math.max(1.5 * reach, ...surfaces.map(p => Math.min(p[0], 3 * reach)));
    const box = { left: -0.12 * reach - 2 * lens.filmDistance, right: far, low: -0.35 * reach, high: 0.25 * reach };
    for (const y of [meeting?.[1], hinge])
        if (Number.isFinite(y) && Math.abs(y) < 1.6 * reach) {
            box.low = Math.min(box.low, y * 1.1);
            box.high = Math.max(box.high, y * 1.1);
        }
    return box;
}

export function drawSide(svg, lens, surfaces) {
    const up = leaning(lens), k = [dot(lens.focus, lens.axis), dot(lens.focus, up)];
    const t = [dot(lens.normal, lens.axis), dot(lens.normal, up)], s = lens.filmDistance;
    const turned = Math.abs(t[1]) > 1e-6;
    const meeting = turned ? [-s, s * t[0] / t[1]] : null, hinge = Math.abs(k[1]) > 0 ? 1 / k[1] : Infinity;
    const box = windowOf(lens, up, meeting, hinge, surfaces);
    const width = svg.clientWidth || 600, height = svg.clientHeight || 240;
    const scale = Math.min((width - 20) / (box.right - box.left), (height - 20) / (box.high - box.low));
    const midX = (box.left + box.right) / 2, midY = (box.low + box.high) / 2;
    const at = ([x, y]) => [width / 2 + (x - midX) * scale, height / 2 - (y - midY) * scale];
    const size = 2 * Math.max(box.right - box.left, box.high - box.low, width / scale);
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    svg.replaceChildren();

    const line = (kind, a, b) => {
        const [[x1, y1], [x2, y2]] = [at(a), at(b)];
        svg.append(shape("line", { class: kind, x1, y1, x2, y2 }));
    };
    // a x + b y = c before the film
    const endless = (kind, [a, b], c) => {
        const n = Math.hypot(a, b), p = [a * c / (n * n), b * c / (n * n)], d = [-b / n, a / n];
        line(kind, [p[0] - size * d[0], p[1] - size * d[1]], [p[0] + size * d[0], p[1] + size * d[1]]);
    };
    const label = (text, point, anchor = "start", dx = 6, dy = -6) => {
        const [x, y] = at(point), tx = x + dx, ty = Math.min(height - 6, Math.max(14, y + dy));
        const made = shape("text", { x: tx, y: ty, "text-anchor": anchor }, text);
        svg.append(made);
        const extent = made.getBBox(), left = Math.min(tx, tx + width - MARGIN - extent.x - extent.width);
        made.setAttribute("x", Math.max(left, tx + MARGIN - extent.x));
    };
    svg.append(shape("path", { class: "surface", d: surfaces.map(p => `M${at(p).map(x => x.toFixed(1))}h0`).join("") }));
    line("axis", [-s, 0], [box.right + size, 0]);
    if (turned) {
        endless("line", [1, 0], -s);
        endless("line", t, 0);
    }
    if (lens.diameter > 0)
        for (const [kind, blur] of [["near", 1], ["far", -1]]) {
            const limit = planeOfBlur(lens, blur, 960);
            endless(kind, [dot(limit, lens.axis), dot(limit, up)], 1);
        }
    endless("plane", k, 1);
    const film = Math.max(0.5 * s * length(lens.up) / dot(lens.direction, lens.axis), 9 / scale), glass = Math.max(lens.diameter / 2, 14 / scale);
    line("film", [-s, -film], [-s, film]);
    line("lens", [glass * t[1], -glass * t[0]], [-glass * t[1], glass * t[0]]);
    label("film", [-s, -film], "end", -4, 14);
    label("lens", [-glass * t[1], glass * t[0]], "start", 6, 0);
    const inside = y => Math.abs(height / 2 - at([0, y])[1]) < height / 2 - 4;
    if (meeting && inside(meeting[1])) {
        const [cx, cy] = at(meeting);
        svg.append(shape("circle", { class: "meet", cx, cy, r: 4 }));
        label("film, lens and plane meet", meeting, "start", 9, 4);
    }
    if (Number.isFinite(hinge) && inside(hinge) && (!meeting || Math.abs(hinge - meeting[1]) * scale > 16)) {
        const [cx, cy] = at([0, hinge]);
        svg.append(shape("circle", { class: "lens", cx, cy, r: 3, fill: "none" }));
        label("hinge line", [0, hinge], "start", 9, 4);
    }
    const crossing = k[0] > 0 ? 1 / k[0] : NaN;
    if (crossing < box.right)
        label("plane of sharp focus", [crossing, 0], crossing > 0.7 * box.right ? "end" : "start", crossing > 0.7 * box.right ? -8 : 8, 16);
}

/// [distance along the axis, across].
/// @param depthAt (x, y) of the film -> 1/distance, or NaN
export function surfaceSection(lens, depthAt) {
    const up = leaning(lens), found = [], far = dot(lens.direction, lens.axis);
    // chief rays without a component across the section
    const aside = unit([lens.axis[1] * up[2] - lens.axis[2] * up[1], lens.axis[2] * up[0] - lens.axis[0] * up[2], lens.axis[0] * up[1] - lens.axis[1] * up[0]]);
    const r = dot(lens.right, aside), u = dot(lens.up, aside), d = dot(lens.direction, aside);
    for (let i = 0; i < 400; i++) {
        const along_ = i / 400 - 0.5;
        const [x, y] = Math.abs(r) >= Math.abs(u) ? [(-d - along_ * u) / r, along_] : [along_, (-d - along_ * r) / u];
        if (Math.abs(x) > 0.5 || Math.abs(y) > 0.5)
            continue;
        const inverse = depthAt(x, y);
        if (!(inverse > 0))
            continue;
        const chief = along(along(lens.direction, x, lens.right), y, lens.up);
        found.push([1 / inverse, dot(chief, up) / far / inverse]);
    }
    return found;
}
