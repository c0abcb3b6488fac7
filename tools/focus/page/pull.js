// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The lens between keys { time, stop, points: [A, B, C] }, as in tilt_lens_pull.inc.

import { along, cross, dot, length, subtract, times, unit } from "./vector.js";
import { areVectors, isSize } from "./address.js";

export const MOST_KEYS = 100;
const FARTHEST = 1e-9; // of a key's k; a smaller one is at infinity

export const areKeys = keys => Array.isArray(keys) && keys.length <= MOST_KEYS &&
    keys.every(key => Number.isFinite(key?.time) && isSize(key.stop) && areVectors(key.points, 3, 3)) &&
    keys.every((key, i) => i === 0 || key.time > keys[i - 1].time);

export const withKey = (keys, key) => [...keys.filter(other => other.time !== key.time), key].sort((a, b) => a.time - b.time);

function focusOf({ points: [a, b, c] }, location) {
    const normal = unit(cross(subtract(b, a), subtract(c, a)));
    return times(1 / dot(subtract(a, location), normal), normal);
}

export function pullAt(keys, time, location) {
    const next = Math.max(0, keys.findIndex((key, i) => i === keys.length - 1 || !(key.time < time)));
    const from = keys[Math.max(0, next - 1)], to = keys[next];
    const part = next === 0 ? 1 : Math.min(1, (time - from.time) / (to.time - from.time)), weight = part * part * (3 - 2 * part);
    const first = focusOf(from, location);
    let k = along(times(1 - weight, first), weight, focusOf(to, location));
    if (length(k) < FARTHEST * length(first))
        k = times(FARTHEST, first);
    return {
        family: "plane", planeNormal: unit(k), planeDistance: (1 + dot(location, k)) / length(k),
        fStop: Math.exp(Math.log(from.stop) * (1 - weight) + Math.log(to.stop) * weight),
    };
}
