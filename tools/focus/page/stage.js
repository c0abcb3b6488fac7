// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Points picked and dragged by mouse, finger or keys, and the wipe.

import { project } from "./lens.js";
import { pixels } from "./more.js";

const LABEL = 40; // pixels below a point that its blur needs; where there are fewer, it stands above
const STEP = 1 / 200, LARGE_STEP = 1 / 25; // of the picture, for the arrow keys

const clamp = x => Math.min(0.5, Math.max(-0.5, x));

/// @param on { pointAt(x, y) -> world point or null, done(), nothing(): no surface, entered(): keyboard focus, cross(x, y) }
export function buildStage(model, on) {
    const picture = document.getElementById("picture"), points = document.getElementById("points");
    const cross = document.getElementById("cross"), truth = document.getElementById("truth"), wipe = document.getElementById("wipe");
    const wipeLine = document.getElementById("wipe-line");
    const at = [0, 0];

    const filmOf = event => {
        const box = picture.getBoundingClientRect();
        return [clamp((event.clientX - box.left) / box.width - 0.5), clamp(0.5 - (event.clientY - box.top) / box.height)];
    };
    const place = (element, [x, y]) => {
        element.style.left = `${100 * (x + 0.5)}%`;
        element.style.top = `${100 * (0.5 - y)}%`;
    };
    const pick = ([x, y]) => {
        const point = on.pointAt(x, y);
        if (point)
            model.pick(point);
        else
            on.nothing();
    };

    picture.onclick = event => {
        cross.hidden = true;
        pick(filmOf(event));
    };
    picture.onkeydown = event => {
        const step = event.shiftKey ? LARGE_STEP : STEP;
        const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
        const move = moves[event.key];
        if (event.key === "Enter" || event.key === " ") {
            cross.hidden = false;
            pick(at);
        }
        else if (event.key === "Escape")
            cross.hidden = true;
        else if (!move)
            return;
        event.preventDefault();
        if (move) {
            at[0] = clamp(at[0] + move[0]);
            at[1] = clamp(at[1] + move[1]);
            cross.hidden = false;
            place(cross, at);
            on.cross(...at);
        }
    };
    picture.onfocus = () => {
        cross.hidden = !picture.matches(":focus-visible");
        on.entered();
    };
    picture.onblur = () => {
        cross.hidden = true;
        on.entered();
    };
    place(cross, at);

    const moveTo = (index, film) => {
        const point = on.pointAt(...film);
        if (point)
            model.move(index, point);
    };
    const button = index => {
        const made = document.createElement("button");
        made.type = "button";
        made.textContent = index + 1;
        made.onpointerdown = event => {
            made.setPointerCapture(event.pointerId);
            made.onpointermove = move => moveTo(index, filmOf(move));
        };
        made.onpointerup = made.onpointercancel = () => {
            made.onpointermove = null;
            on.done();
        };
        made.onkeydown = event => {
            if (event.key === "Delete" || event.key === "Backspace") {
                event.preventDefault();
                model.remove(index);
                picture.focus();
                return;
            }
            const step = event.shiftKey ? LARGE_STEP : STEP / 2;
            const move = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[event.key];
            if (!move)
                return;
            event.preventDefault();
            const now = project(model.lens, model.picks[index]);
            moveTo(index, [clamp(now.x + move[0]), clamp(now.y + move[1])]);
            on.done();
        };
        return made;
    };

    const showWipe = () => {
        truth.style.clipPath = `inset(0 0 0 ${wipe.value}%)`;
        wipeLine.style.left = `${wipe.value}%`;
    };
    wipe.oninput = showWipe;

    return {
        byKeys: () => !cross.hidden,

        pick,

        show() {
            while (points.children.length > model.picks.length)
                points.lastChild.remove();
            while (points.children.length < model.picks.length)
                points.append(button(points.children.length));
            const { blurs, binds } = model.mode === "more" ? model.sharpness() : { blurs: [], binds: [] };
            model.picks.forEach((point, i) => {
                const { x, y, depth } = project(model.lens, point), made = points.children[i];
                made.hidden = !(depth > 0 && Math.abs(x) <= 0.5 && Math.abs(y) <= 0.5);
                made.className = model.error ? "bad" : binds[i] ? "binds" : "";
                made.classList.toggle("low", (y + 0.5) * picture.clientHeight < LABEL);
                made.toggleAttribute("data-blur", i in blurs);
                if (i in blurs)
                    made.dataset.blur = pixels(blurs[i]);
                made.setAttribute("aria-label", `Point ${i + 1}; arrow keys move it, Delete removes it`);
                place(made, [x, y]);
            });
        },
        showTruth(shown, over = "cross") {
            document.getElementById(over).before(truth, wipeLine);
            truth.parentElement.after(wipe);
            truth.hidden = wipe.hidden = wipeLine.hidden = !shown;
            showWipe();
        },
    };
}
