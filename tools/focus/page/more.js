// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { numberIn } from "./knobs.js";
import { FEWEST } from "./model.js";
import { SHARP } from "./points.js";

export function pixels(blur) {
    const size = Math.abs(blur);
    return size < SHARP ? "sharp" : `${size < 9.995 ? size.toFixed(2) : size.toFixed(size < 99.95 ? 1 : 0)} px`;
}

export const stop = value => `f/${Number(value.toPrecision(3))}`;

const described = (blur, binds) => pixels(blur) + (Math.abs(blur) < SHARP ? "" : blur > 0 ? " before" : " behind") + (binds ? ", binds" : "");

function summary(model, { greatest, without }) {
    const { fStop } = model.block, held = model.holds, reached = greatest > model.within * (1 - 1e-6);
    const now = held ? `${stop(fStop)} is the widest that ${reached ? `keeps all within ${model.within} px` : "is taken; it keeps all within less"}.`
        : greatest < SHARP ? `All are sharp at ${stop(fStop)}.` : `The best plane leaves ${pixels(greatest)} or less at ${stop(fStop)}.`;
    const other = without === null || greatest < SHARP ? "" : ` A lens without tilt needs ${stop(without)} for the same.`;
    return `${now}${other} Pixels are those of a picture ${model.width} wide.`;
}

export function buildMore(find, model) {
    const list = find("sharp-points"), within = find("within");
    find("hold").onchange = event => model.setHold(event.target.checked);
    within.onchange = () => {
        const value = numberIn(within.value);
        if (value > 0 && value < Infinity)
            model.setHold(model.hold, value);
        else
            model.refuse("within", `${within.value.trim() || "Nothing"} is refused: a number above 0 is needed.`);
    };

    const newRow = index => {
        const row = document.createElement("li"), number = document.createElement("b"), remove = document.createElement("button");
        number.textContent = index + 1;
        Object.assign(remove, { type: "button", textContent: "×", ariaLabel: `Remove point ${index + 1}` });
        remove.onclick = () => model.remove(index);
        row.append(number, document.createElement("span"), remove);
        return row;
    };
    const showRow = ({ blurs, binds }, i) => {
        const row = list.children[i], words = described(blurs[i], binds[i]);
        row.className = binds[i] ? "binds" : "";
        row.title = binds[i] ? "This point decides where the plane lies, and how far the lens may be opened." : "";
        if (row.children[1].textContent !== words)
            row.children[1].textContent = words;
    };

    return () => {
        const more = model.mode === "more";
        find("more").hidden = !more;
        if (!more)
            return;
        while (list.children.length > model.picks.length)
            list.lastChild.remove();
        while (list.children.length < model.picks.length)
            list.append(newRow(list.children.length));
        const sharpness = model.sharpness();
        model.picks.forEach((_, i) => showRow(sharpness, i));
        find("hold").checked = model.hold;
        if (document.activeElement !== within || !model.refused.within)
            within.value = model.within;
        find("sharp-said").textContent = model.block.family === "sharp" && model.picks.length >= FEWEST && !model.error ? summary(model, sharpness) : "";
    };
}
