// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { blurOfPoint, project } from "./lens.js";
import { openBlur } from "./blur.js";
import { pixels, stop } from "./more.js";

const degrees = value => `${Number(value.toFixed(2)) + 0}°`;

function figuresOf(model, points) {
    const { tilt, swing, fStop } = model.numbers(), blurs = points.map(point => blurOfPoint(model.lens, point, model.width));
    return [`tilt ${degrees(tilt)}, swing ${degrees(swing)}, ${stop(fStop)}`, blurs.map(pixels)];
}

function showFigures(place, name, shown, [numbers, blurs]) {
    const lens = document.createElement("b"), list = document.createElement("ol");
    lens.textContent = `Lens ${name}`;
    lens.className = shown ? "shown" : "";
    list.append(...blurs.map(blur => Object.assign(document.createElement("li"), { textContent: blur })));
    list.ariaLabel = `Blur of the points with lens ${name}`;
    place.replaceChildren(lens, ` ${numbers}`, list);
}

function showMarks(place, { lens }, points, blurs) {
    place.replaceChildren(...points.map((point, i) => {
        const { x, y, depth } = project(lens, point), mark = document.createElement("span");
        mark.textContent = i + 1;
        mark.dataset.blur = blurs[i];
        mark.hidden = !(depth > 0 && Math.abs(x) <= 0.5 && Math.abs(y) <= 0.5);
        mark.classList.toggle("low", y < -0.3);
        mark.style.left = `${100 * (x + 0.5)}%`;
        mark.style.top = `${100 * (0.5 - y)}%`;
        return mark;
    }));
}

/// @param pick (x, y) of the film in the other picture, whose lens is shown by then
export function buildBeside(find, pair, live, pick) {
    const { model } = pair, picture = find("other-picture"), box = find("beside"), radios = document.querySelectorAll("input[name=pair]");
    let blur = null;
    radios.forEach(radio => (radio.onchange = () => radio.value !== pair.shown && pair.swap()));
    box.onchange = () => pair.setBeside(box.checked);
    picture.onclick = event => {
        const { left, top, width, height } = picture.getBoundingClientRect();
        const film = [(event.clientX - left) / width - 0.5, 0.5 - (event.clientY - top) / height];
        pair.swap();
        pick(film);
    };

    return () => {
        const twin = pair.twin, { picks } = model;
        radios.forEach(radio => (radio.checked = radio.value === pair.shown));
        box.checked = pair.beside;
        find("other").hidden = find("figures").hidden = !twin;
        find("pictures").classList.toggle("beside", Boolean(twin));
        find("pictures").classList.toggle("b", pair.shown === "B");
        if (twin) {
            blur ??= openBlur(picture);
            const figures = figuresOf(twin, picks);
            showFigures(find("figures"), pair.shown, true, figuresOf(model, picks));
            showFigures(find("other-figures"), pair.waiting, false, figures);
            showMarks(find("other-points"), twin, picks, figures[1]);
            picture.ariaLabel = `The scene through lens ${pair.waiting}. A click chooses this lens, and what is to be sharp.`;
        }
        live.showBeside(twin && blur, twin);
    };
}
