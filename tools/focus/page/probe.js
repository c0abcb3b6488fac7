// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { describe } from "./block.js";

/// For tests; the page does not use it.
export function buildProbe(model, live) {
    const { blur } = live;
    const read = (canvas, [width, height]) => {
        const context = new OffscreenCanvas(width, height).getContext("2d");
        context.drawImage(canvas, 0, 0, width, height);
        return context.getImageData(0, 0, width, height).data;
    };
    const size = () => [blur.width, blur.height];
    return {
        model,
        describe: form => describe(model, form),

        get live() {
            const { frame, pass, work } = blur, { complete, refined, scheduled } = live;
            const smooth = !scheduled && live.blurs.every(each => !each.unfinished);
            return blur.values && frame ? { size: size(), location: frame.location, complete, refined, passes: pass, smooth, work } : null;
        },

        /// Milliseconds of work after which a picture counts as smooth. 0: after one pass; Infinity: after all, on a busy machine, too.
        set patience(time) {
            for (const each of live.blurs)
                each.patience = time;
            if (live.blurs.some(each => each.unfinished))
                live.draw();
        },

        get drawings() {
            return blur.drawings;
        },

        previewSum: () => blur.values.reduce((a, b) => a + b),

        /// Red, green, blue, alpha, upper row first; `show` overrides the settings.
        livePixels(show = {}) {
            const shown = blur.show;
            blur.show = { ...shown, ...show };
            blur.display();
            const pixels = read(blur.canvas, size());
            blur.show = shown;
            blur.display();
            return pixels;
        },

        otherPixels: () => read(document.getElementById("other-picture"), size()),

        truePixels: () => read(document.getElementById("truth"), size()),

        nextDrawing() {
            const before = blur.drawings;
            return new Promise(done => {
                const look = () => (blur.drawings > before ? done() : requestAnimationFrame(look));
                requestAnimationFrame(look);
            });
        },
    };
}
