// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { describe } from "./block.js";
import { WORLD } from "./place.js";

const READING = "Reading the scene …";
const WIDTHS = [320, 640, 960, 1280, 1920, 2560, 3840];

const time = seconds => (seconds < 90 ? `${seconds.toFixed(seconds < 9.5 ? 1 : 0)} s` : `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`);

const WORDS = {
    begun: () => READING,
    growing: ({ share, seconds }) => `${Math.floor(100 * share)} % after ${time(seconds)}`,
    done: ({ seconds }) => `Done in ${time(seconds)}. Left of the slider the live picture, right of it the true one.`,
    stopped: ({ share }) => `Stopped at ${Math.floor(100 * share)} %.`,
    failed: ({ file, line, message }) => `${file ? `${file}, line ${line}: ` : ""}${message}`,
};

export function buildTruth(find, stage, pair, previewSize, clockOf, ask) {
    const { model } = pair, canvas = find("truth"), said = find("true-said");
    let number = 0, waiting = [], last = null, other = "", shown = false;

    const wanted = (of = model) => {
        const { location, right, up, unshifted } = of.lens, { block, items } = describe(of, "plane", WORLD);
        return { camera: { location, direction: unshifted, right, up }, block, items };
    };
    const keyOf = ({ camera: { location, direction, right, up }, block }) => JSON.stringify([location, direction, right, up, block]);

    const difference = of => (keyOf(last.lens) !== keyOf(wanted(of)) ? "lens" : (last.lens.clock ?? 0) !== (clockOf() ?? last.lens.clock ?? 0) ? "time" : "");

    const show = () => {
        if (!last)
            return;
        const { twin } = pair;
        if (model.lens && !model.error)
            other = difference(model);
        const beside = other && twin && !difference(twin);
        if (shown)
            stage.showTruth(true, beside ? "other-points" : "cross");
        canvas.classList.toggle("other", other && !beside);
        const of = beside ? ` Of lens ${pair.waiting}: render again for lens ${pair.shown}.` : other && ` Of another ${other}: render again.`;
        said.textContent = WORDS[last.state](last) + (last.state === "failed" ? "" : of);
    };

    find("width").replaceChildren(...WIDTHS.map(width => {
        const option = document.createElement("option");
        option.value = option.textContent = width;
        option.selected = width === 960;
        return option;
    }));
    find("render").onclick = () => {
        const width = Number(find("width").value), size = previewSize();
        last = null;
        said.textContent = READING;  // messages about the previous picture no longer hold
        ask({
            do: "render", size: [width, Math.max(2, Math.round(width * size[1] / size[0]))], quality: Number(find("quality").value),
            ...wanted(),
        });
    };
    find("stop").onclick = () => ask({ do: "stop" });
    find("hide").onclick = () => {
        shown = false;
        stage.showTruth(false);
        find("hide").hidden = find("save").hidden = true;
        said.textContent = "";
        last = null;
    };

    return {
        show,
        take(message) {
            last = message;
            const running = message.state === "begun" || message.state === "growing";
            if (message.state === "begun" || number !== message.number) {
                number = message.number;
                [canvas.width, canvas.height] = message.size;
                waiting.forEach(tile => this.takeTile(tile));
                waiting = [];
                shown = true;
            }
            find("stop").hidden = find("progress").hidden = !running;
            find("render").hidden = running;
            find("hide").hidden = running;
            find("save").hidden = message.state !== "done";
            find("progress").value = message.share;
            show();
        },
        takeTile(tile) {
            if (tile.number !== number) {
                waiting.push(tile);
                return;
            }
            canvas.getContext("2d").putImageData(new ImageData(tile.values, tile.width, tile.height), tile.left, tile.top);
        },
    };
}
