// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The largest blur that may reach each tile of the preview; the shader searches only there.

import { dot } from "./vector.js";
import { blurPerVergence, frameMap } from "./lens.js";

export const TILE = 16; // pixels of the preview

export class Reach {
    /// @param values red, green, blue, 1/distance of each pixel
    constructor(width, height, values) {
        Object.assign(this, { width, height, values });
        this.columns = Math.ceil(width / TILE);
        this.rows = Math.ceil(height / TILE);
        this.ranges = new Float32Array(this.columns * this.rows * 2); // smallest and largest 1/distance of each tile
    }

    note(left, top, width, height) {
        for (let ty = Math.floor(top / TILE); ty * TILE < top + height; ty++)
            for (let tx = Math.floor(left / TILE); tx * TILE < left + width; tx++)
                this.ranges.set(this.rangeOf(tx, ty), (ty * this.columns + tx) * 2);
    }

    rangeOf(tx, ty) {
        let least = Infinity, most = -Infinity;
        for (let y = ty * TILE; y < Math.min(this.height, (ty + 1) * TILE); y++)
            for (let x = tx * TILE; x < Math.min(this.width, (tx + 1) * TILE); x++) {
                const value = this.values[(y * this.width + x) * 4 + 3];
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        return [least, most];
    }

    /// In vergence.
    of(lens, frame) {
        const { columns, rows } = this, own = new Float32Array(columns * rows), [ox, oy, fx, fy] = frameMap(lens, frame);
        const far = dot(lens.direction, lens.axis);
        for (let y = 0; y < rows; y++)
            for (let x = 0; x < columns; x++) {
                const at = y * columns + x;
                let largest = 0;
                for (const cx of [x, x + 1])
                    for (const cy of [y, y + 1]) {
                        const px = (cx * TILE / this.width - 0.5 - ox) / fx, py = (0.5 - cy * TILE / this.height - oy) / fy;
                        const w = lens.focusMiddle + px * lens.focusRight + py * lens.focusUp;
                        largest = Math.max(largest, Math.abs(far * this.ranges[at * 2] - w), Math.abs(far * this.ranges[at * 2 + 1] - w));
                    }
                own[at] = largest;
            }
        return this.dilated(own, 0.5 * blurPerVergence(lens, this.width) * fx / TILE);
    }

    /// A value of 1 reaches `tiles` tiles.
    dilated(own, tiles) {
        const { columns, rows } = this;
        let values = own;
        for (const [step, count, across] of [[1, columns, rows], [columns, rows, columns]]) {
            const next = values.slice();
            for (let line = 0; line < across; line++) {
                const start = line * (step === 1 ? columns : 1);
                for (let i = 0; i < count; i++) {
                    const value = values[start + i * step], reach = Math.min(count, Math.ceil(value * tiles * 1.1));
                    for (let j = Math.max(0, i - reach); j <= Math.min(count - 1, i + reach); j++)
                        if (next[start + j * step] < value)
                            next[start + j * step] = value;
                }
            }
            values = next;
        }
        return values;
    }
}
