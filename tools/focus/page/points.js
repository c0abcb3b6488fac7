// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { along, cross, dot, length, subtract, unit } from "./vector.js";
import { axesOf, blurOfPoint, greatestBlur, pointAt, project, stopWithoutTilt } from "./lens.js";

/// Blur in pixels that counts as none.
export const SHARP = 0.005;
/// A smaller difference of blur is rounding.
const BINDS = 1 - 1e-6;

export function nearestPick({ lens, picks }, point) {
    const at = project(lens, point);
    const far = picks.map(p => {
        const there = project(lens, p);
        return Math.hypot(there.x - at.x, there.y - at.y);
    });
    return far.indexOf(Math.min(...far));
}

/// The third point may follow from `third`. Null without a plane.
export function planePoints({ mode, third, picks, wantedPicks, camera }) {
    if (mode !== "three" || wantedPicks === 1 || picks.length < 2)
        return null;
    if (picks.length === 3)
        return picks;
    const { axis, right } = axesOf(camera), sky = unit(camera.sky);
    const across = cross(sky, axis), level = length(across) > 1e-6 ? unit(across) : right;
    const size = Math.max(length(subtract(picks[1], picks[0])), length(subtract(picks[0], camera.location)) / 4);
    return [picks[0], picks[1], along(picks[0], size, third === "upright" ? sky : level)];
}

/// { blurs: signed, pixels; binds; greatest; without: f-number without tilt, or null }.
export function sharpnessOf({ lens, picks, width, block, camera }) {
    const blurs = picks.map(point => blurOfPoint(lens, point, width)), greatest = picks.length ? greatestBlur(lens, picks, width) : 0;
    const best = block.family === "sharp" && greatest > SHARP;
    return {
        blurs, greatest, binds: blurs.map(blur => best && Math.abs(blur) >= BINDS * greatest),
        without: best ? stopWithoutTilt(camera, block, lens, picks, width) : null,
    };
}

export function visiblePoints(lens) {
    const found = [];
    for (const [x, y] of [[0, 0], [-0.25, -0.25], [0.25, -0.25], [0, 0.3], [0, -0.45], [-0.3, 0.2], [0.3, 0.2]]) {
        const w = lens.focusMiddle + x * lens.focusRight + y * lens.focusUp;
        if (w > 0)
            found.push(pointAt(lens, x, y, dot(lens.direction, lens.axis) / w));
    }
    return found;
}
