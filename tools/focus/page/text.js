// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { change, copyText, describe } from "./block.js";

const sentence = words => words.replace(/\.?$/, ".");

export const WORDS = {
    written: ({ kept }) => `Written. The scene as it was is kept as ${kept}.`,
    undone: () => "The scene is as it was before.",
    tried: () => "It belongs into the camera of your scene; tried there, it makes this lens.",
    untried: ({ reason }) => `It could not be tried in the scene: ${sentence(reason)}`,
    refused: ({ reason }) => `Not written: ${sentence(reason)} Copy the text and put it in by hand.`,
};

/// Marks the text where the browser does not allow copying.
/// @returns words for the user
export async function copy(element) {
    try {
        await navigator.clipboard.writeText(element.textContent);
        return "Copied.";
    } catch {
        const range = document.createRange();
        range.selectNodeContents(element);
        getSelection().removeAllRanges();
        getSelection().addRange(range);
        return "The browser does not let this page copy. The text is marked: press Ctrl-C.";
    }
}

export function buildText(find, model, kept, ask) {
    const block = find("block"), said = find("file-said");
    let chosen = null, copied = "";

    const form = () => chosen ?? (model.block.family === "sharp" ? "points" : "plane");
    const show = () => {
        block.textContent = copyText(describe(model, form()), kept());
        document.querySelector(`input[name=form][value=${form()}]`).checked = true;
        find("write").disabled = find("copy").disabled = find("render").disabled = Boolean(model.error);
    };
    for (const radio of document.querySelectorAll("input[name=form]"))
        radio.onchange = () => {
            chosen = radio.value;
            show();
        };
    find("copy").onclick = async () => {
        copied = await copy(block);
        said.textContent = `${copied} Trying it in the scene …`;
        ask({ do: "try", ...change(model, form()) });
    };
    find("write").onclick = () => ask({ do: "write", ...change(model, form()) });
    find("undo").onclick = () => ask({ do: "undo" });

    return {
        show,
        /// @returns true if this page changed the file
        take(message) {
            const changed = message.state === "written" || message.state === "undone";
            if (changed)
                find("undo").hidden = message.state !== "written";
            if (message.pull)
                return changed;
            said.textContent = (message.state.endsWith("tried") ? `${copied} ` : "") + WORDS[message.state](message);
            return changed;
        },
    };
}
