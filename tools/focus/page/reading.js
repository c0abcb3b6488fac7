// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { dot, length } from "./vector.js";
import { blurDiameter, blurPerVergence, chiefRay } from "./lens.js";
import { pixels } from "./more.js";
import { SHARP } from "./points.js";

const ABOVE = 24; // screen pixels from the place to the loupe
const LIMIT = 1; // pixels of blur up to which a thing counts as sharp

/// { surface, blur (pixels), near, far } along the chief ray. Null without a surface; `near` null where nothing is sharp; `far` may be
/// Infinity.
export function readingAt(lens, x, y, inverseDepth, width) {
    const chief = chiefRay(lens, x, y), size = length(chief), inverse = inverseDepth * dot(lens.direction, lens.axis);
    const w = dot(lens.focus, chief), reach = LIMIT / blurPerVergence(lens, width);
    const seen = inverse > 0;
    return {
        surface: seen ? size / inverse : null, blur: seen ? blurDiameter(lens, chief, 1 / inverse, width) : null,
        near: w + reach > 0 ? size / (w + reach) : null, far: w - reach > 0 ? size / (w - reach) : Infinity,
    };
}

const distance = value => (Number.isFinite(value) ? String(Number(value.toPrecision(4))) : "infinity");

function inWords({ surface, blur, near, far }) {
    const blurred = Math.abs(blur) < SHARP ? "no blur" : `blur ${pixels(blur)} ${blur > 0 ? "before" : "behind"} the plane`;
    const thing = surface === null ? "Nothing here." : `${distance(surface)} from the lens: ${blurred}.`;
    const deep = Number.isFinite(far) ? `, ${distance(far - near)} deep` : "";
    return `${thing} ${near === null ? "No distance here is sharp." : `Sharp here from ${distance(near)} to ${distance(far)}${deep}.`}`;
}

export function buildReading(find, model, blur, at) {
    const picture = find("picture"), loupe = find("loupe"), scale = find("loupe-scale"), said = find("reading");
    let place = null;

    const drawLoupe = () => {
        loupe.hidden = !(find("show-loupe").checked && place && blur.values && blur.lens);
        if (loupe.hidden)
            return;
        const side = Math.round(loupe.clientWidth * devicePixelRatio), canvas = blur.canvas, context = loupe.getContext("2d");
        if (loupe.width !== side)
            loupe.width = loupe.height = side;
        const across = loupe.clientWidth / Number(scale.value), [sx, sy] = [canvas.width / blur.width, canvas.height / blur.height];
        const left = Math.round((place[0] + 0.5) * blur.width - across / 2), top = Math.round((0.5 - place[1]) * blur.height - across / 2);
        context.imageSmoothingEnabled = false;
        context.clearRect(0, 0, side, side);
        context.drawImage(canvas, left * sx, top * sy, across * sx, across * sy, 0, 0, side, side);
        // below the place near the upper edge
        const box = picture.getBoundingClientRect(), half = loupe.offsetWidth / 2, y = (0.5 - place[1]) * box.height;
        const x = Math.min(box.width - half, Math.max(half, (place[0] + 0.5) * box.width));
        loupe.style.left = `${x - half}px`;
        loupe.style.top = `${y > 2 * half + ABOVE ? y - 2 * half - ABOVE : Math.max(0, Math.min(box.height - 2 * half, y + ABOVE))}px`;
    };
    const show = () => {
        said.textContent = place && model.lens && blur.values ? inWords(readingAt(model.lens, ...place, at(...place), model.width)) : "";
        drawLoupe();
    };
    const moveTo = film => {
        place = film;
        show();
    };
    const follow = event => {
        const box = picture.getBoundingClientRect(), x = (event.clientX - box.left) / box.width - 0.5, y = 0.5 - (event.clientY - box.top) / box.height;
        moveTo(Math.abs(x) <= 0.5 && Math.abs(y) <= 0.5 ? [x, y] : null);
    };
    find("stage").addEventListener("pointermove", follow);
    find("stage").addEventListener("pointerdown", follow);
    find("stage").addEventListener("pointerleave", event => event.pointerType === "mouse" && moveTo(null));
    find("show-loupe").onchange = () => {
        place ??= [0, 0];
        show();
    };
    scale.onchange = show;

    return { show, moveTo, drawLoupe };
}
