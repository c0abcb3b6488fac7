// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The user's choices behind the address's #, for reload, Back, Forward and further tabs: JSON in base64url, never sent.

import { MOST, PLAIN } from "./model.js";

const FAMILIES = ["lensTurn", "focusTurn", "plane", "points", "sharp"];
const isNumber = value => Number.isFinite(value);
export const isSize = value => isNumber(value) && value > 0;
const isVector = (value, count = 3) => Array.isArray(value) && value.length === count && value.every(isNumber);
export const areVectors = (value, least, most) => Array.isArray(value) && value.length >= least && value.length <= most && value.every(v => isVector(v));

const MEMBERS = {
    family: value => FAMILIES.includes(value), points: value => areVectors(value, 3, 3), sharpPoints: value => areVectors(value, 0, MOST),
    shift: value => isVector(value, 2), focalLength: value => value === null || isSize(value), fStop: isSize,
    sharpWithin: value => value === null || isSize(value), sceneUnit: isSize, filmWidth: isSize,
};
const isBlock = block => Object.entries(PLAIN).every(([name, plain]) => (MEMBERS[name] ?? (Array.isArray(plain) ? isVector : isNumber))(block?.[name]));

export function isState(state) {
    return isBlock(state?.block) && ["location", "direction", "right", "up", "sky"].every(name => isVector(state.camera?.[name])) &&
        areVectors(state.picks, 0, MOST) && ["one", "three", "more"].includes(state.mode) &&
        ["picked", "level", "upright", "film"].includes(state.third) && typeof state.hold === "boolean" && typeof state.onFilm === "boolean" && isSize(state.within) &&
        (state.real === null || ["focalLength", "fStop", "tilt", "shift"].every(name => isNumber(state.real?.[name])));
}

/// FNV-1a of 32 bits.
export function markOf(text) {
    let mark = 0x811c9dc5;
    for (const byte of new TextEncoder().encode(text))
        mark = Math.imul(mark ^ byte, 0x01000193);
    return (mark >>> 0).toString(16);
}

export function writeAddress(kept) {
    const bytes = new TextEncoder().encode(JSON.stringify(kept));
    const text = btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(""));
    history.replaceState(null, "", `#${text.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`);
}

export function readAddress() {
    try {
        const text = atob(location.hash.slice(1).replaceAll("-", "+").replaceAll("_", "/"));
        return JSON.parse(new TextDecoder().decode(Uint8Array.from(text, letter => letter.charCodeAt(0))));
    } catch {
        return null;
    }
}
