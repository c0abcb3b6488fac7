// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The true picture: asks the program for it, shows it as it grows, over the live one.

import { describe } from "./block.js";
import { WORLD } from "./place.js";

const READING = "Reading the scene …";
const WIDTHS = [320, 640, 960, 1280, 1920, 2560, 3840];

const time = seconds => (seconds < 90 ? `${seconds.toFixed(seconds < 9.5 ? 1 : 0)} s` : `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`);

/// @param previewSize  () -> [width, height] of the preview, whose proportions the picture has
/// @param ask          sends a message to the program
export function buildTruth(find, stage, model, previewSize, ask) {
    const canvas = find("truth"), said = find("true-said");
    let number = 0, waiting = [];

    find("width").replaceChildren(...WIDTHS.map(width => {
        const option = document.createElement("option");
        option.value = option.textContent = width;
        option.selected = width === 960;
        return option;
    }));
    find("render").onclick = () => {
        const { block, items } = describe(model, "plane", WORLD), width = Number(find("width").value), size = previewSize();
        const { location, right, up, unshifted } = model.lens;
        said.textContent = READING;  // at once: what was said of the picture before holds no more
        ask({
            do: "render", size: [width, Math.max(2, Math.round(width * size[1] / size[0]))], quality: Number(find("quality").value),
            camera: { location, direction: unshifted, right, up }, block, items,
        });
    };
    find("stop").onclick = () => ask({ do: "stop" });
    find("hide").onclick = () => {
        stage.showTruth(false);
        find("hide").hidden = find("save").hidden = true;
        said.textContent = "";
    };

    return {
        take(message) {
            const running = message.state === "begun" || message.state === "growing";
            if (message.state === "begun" || number !== message.number) {
                number = message.number;
                [canvas.width, canvas.height] = message.size;
                waiting.forEach(tile => this.takeTile(tile));
                waiting = [];
                stage.showTruth(true);
            }
            find("stop").hidden = find("progress").hidden = !running;
            find("render").hidden = running;
            find("hide").hidden = running;
            find("save").hidden = message.state !== "done";
            find("progress").value = message.share;
            const words = {
                begun: () => READING,
                growing: () => `${Math.floor(100 * message.share)} % after ${time(message.seconds)}`,
                done: () => `Done in ${time(message.seconds)}. Left of the slider the live picture, right of it the true one.`,
                stopped: () => `Stopped at ${Math.floor(100 * message.share)} %.`,
                failed: () => `${message.file ? `${message.file}, line ${message.line}: ` : ""}${message.message}`,
            };
            said.textContent = words[message.state]();
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
