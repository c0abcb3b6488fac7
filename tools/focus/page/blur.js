// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The picture with live blur: keeps the preview on the graphics processor and draws it through a lens.
///
/// A change draws one pass at once, at a size that the machine manages in time; while nothing changes, further passes
/// at full size are averaged, until the picture is smooth.

import { along, cross, dot, length, subtract, times, unit } from "./vector.js";
import { axisFocusOf, blurPerVergence, planeOfBlur } from "./lens.js";
import { DISPLAY, EVERYWHERE, GATHER, LIST } from "./shaders.js";

const TILE = 16;           // side of a tile of the preview, pixels
const WANTED = 33;         // milliseconds that a picture may take while something moves
const SMALLEST = 0.125;    // of the full size, while something moves
const MOVING_TAPS = 16, RESTING_TAPS = 32;
const PASSES = 24;         // until the picture is smooth
const STRIP = 30;          // milliseconds for a part of a pass at full size, so that the page stays awake
const LEAST_STRIPS = 16;   // a pass has at most so many parts
const PATIENCE = 15000;    // milliseconds of work after which a picture is smooth enough, whatever the passes
const PEAKING = [1, 0.05, 0.35];

/// Coordinates of a vector across the axis in the frame's right and up.
function inFrame(lens, v) {
    const rr = dot(lens.right, lens.right), ru = dot(lens.right, lens.up), uu = dot(lens.up, lens.up);
    const r = dot(v, lens.right), u = dot(v, lens.up), det = rr * uu - ru * ru;
    return [(r * uu - u * ru) / det, (u * rr - r * ru) / det];
}

/// From the film of one frame to that of another of the same camera: [offset x, y, factor x, y].
export function frameMap(lens, frame) {
    const far = v => dot(v, lens.axis), ratio = far(frame.direction) / far(lens.direction);
    const offset = inFrame({ right: frame.right, up: frame.up }, subtract(times(ratio, lens.direction), frame.direction));
    return [...offset, ratio * length(lens.right) / length(frame.right), ratio * length(lens.up) / length(frame.up)];
}

/// Points of the diaphragm, then of the disc around it: two uniform numbers of a sequence that fills the square evenly
/// (Roberts's R2), taken to the shape.
function lensPointList(corners, turn) {
    const list = new Float32Array(4 * LIST), corner = k => turn + 2 * Math.PI * k / corners;
    for (let i = 0; i < LIST; i++) {
        const u = Math.sqrt((0.5 + i * 0.7548776662466927) % 1), v = (0.5 + i * 0.5698402909980532) % 1;
        const disc = [u * Math.cos(2 * Math.PI * v), u * Math.sin(2 * Math.PI * v)];
        let shape = disc;
        if (corners >= 3) {
            const first = Math.floor(v * corners), part = v * corners - first;
            shape = [Math.cos, Math.sin].map(f => u * ((1 - part) * f(corner(first)) + part * f(corner(first + 1))));
        }
        list.set([...shape, ...disc], 4 * i);
    }
    return list;
}

/// Opens the canvas. @throws Error where there is no WebGL2 with pictures of floating point numbers
export function openBlur(canvas) {
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl || !gl.getExtension("EXT_color_buffer_float"))
        throw new Error("This browser has no WebGL2 with floating point pictures, which the live blur needs. " +
            "Try a recent Firefox or Chromium.");
    return new Blur(gl, canvas);
}

class Blur {
    constructor(gl, canvas) {
        this.gl = gl;
        this.canvas = canvas;
        this.programs = { gather: this.program(GATHER), display: this.program(DISPLAY) };
        this.preview = this.texture();
        this.reach = this.texture();
        this.lensPoints = this.texture();
        this.small = this.target();                  // while something moves
        this.means = [this.target(), this.target()]; // the mean of the passes so far, and the next
        this.shown = this.small;
        this.scale = 0.25;
        this.restart();
        this.rows = 1;
        this.lens = null;
        this.frame = null;
        this.show = { blur: true, peaking: false, map: false, planes: false };
        this.empty = [0.5, 0.5, 0.5];
        this.gamma = 1;
        this.values = null;
        this.drawings = 0;
        gl.bindVertexArray(gl.createVertexArray());
        this.setBlades(0, 0);
    }

    /// Forgets the passes so far.
    restart() {
        this.pass = this.row = this.spent = 0;
    }

    // ---- what is drawn ----

    /// A new, empty preview of that size, taken with this frame (a solved lens, or direction, right and up).
    begin(width, height) {
        this.width = width;
        this.height = height;
        this.canvas.width = width;
        this.canvas.height = height;
        this.rows = Math.ceil(height / LEAST_STRIPS);
        this.values = new Float32Array(width * height * 4);
        this.ranges = new Float32Array(Math.ceil(width / TILE) * Math.ceil(height / TILE) * 2);
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.preview);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, this.values);
    }

    /// A rectangle of the preview: red, green, blue, 1/distance.
    take(left, top, width, height, values) {
        for (let row = 0; row < height; row++)
            this.values.set(values.subarray(row * width * 4, (row + 1) * width * 4), ((top + row) * this.width + left) * 4);
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.preview);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, left, top, width, height, gl.RGBA, gl.FLOAT, values);
        this.noteRanges(left, top, width, height);
        this.reachOf = null;
        this.restart();
    }

    /// 1/distance of the surface at x, y of this picture's film; NaN outside the preview.
    inverseDepthAt(x, y) {
        const [ox, oy, fx, fy] = frameMap(this.lens, this.frame);
        const column = Math.floor((ox + fx * x + 0.5) * this.width), row = Math.floor((0.5 - oy - fy * y) * this.height);
        const inside = column >= 0 && row >= 0 && column < this.width && row < this.height;
        return inside ? this.values[(row * this.width + column) * 4 + 3] : NaN;
    }

    /// Smallest and largest 1/distance of each tile that a rectangle touches.
    noteRanges(left, top, width, height) {
        const columns = Math.ceil(this.width / TILE);
        for (let ty = Math.floor(top / TILE); ty * TILE < top + height; ty++)
            for (let tx = Math.floor(left / TILE); tx * TILE < left + width; tx++) {
                let least = Infinity, most = -Infinity;
                for (let y = ty * TILE; y < Math.min(this.height, (ty + 1) * TILE); y++)
                    for (let x = tx * TILE; x < Math.min(this.width, (tx + 1) * TILE); x++) {
                        const value = this.values[(y * this.width + x) * 4 + 3];
                        least = Math.min(least, value);
                        most = Math.max(most, value);
                    }
                this.ranges.set([least, most], (ty * columns + tx) * 2);
            }
    }

    /// The largest vergence difference whose blur may reach each tile.
    updateReach() {
        const columns = Math.ceil(this.width / TILE), rows = Math.ceil(this.height / TILE), { lens } = this;
        const far = dot(lens.direction, lens.axis), own = new Float32Array(columns * rows);
        const [ox, oy, fx, fy] = frameMap(lens, this.frame);
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
        const reach = this.dilated(own, columns, rows, 0.5 * blurPerVergence(lens, this.width) * fx / TILE);
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.reach);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, columns, rows, 0, gl.RED, gl.FLOAT, reach);
    }

    /// Each tile gets the largest of those values that reach it; `tiles` is the reach of a value of 1.
    dilated(own, columns, rows, tiles) {
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

    /// The lens to draw with, and the frame that the preview was taken with.
    setLens(lens, frame) {
        this.lens = lens;
        this.frame = frame;
        this.reachOf = null;
        this.restart();
    }

    // ---- drawing ----

    /// Whether the picture shows blur.
    get blurs() {
        return this.show.blur && this.lens.diameter > 0;
    }

    /// Whether another call would change the picture.
    get unfinished() {
        if (!this.values || !this.lens)
            return false;
        return this.blurs ? this.pass === 0 || (this.pass < PASSES && this.spent < PATIENCE) : this.pass === 0;
    }

    /// Draws: all at once and small while something moves, else a part of one more pass at full size.
    draw(moving) {
        if (!this.values || !this.lens || !this.frame)
            return;
        const begun = performance.now();
        if (this.reachOf !== this.lens) {
            this.updateReach();
            this.reachOf = this.lens;
        }
        if (!this.blurs)
            this.pass = 1;
        else if (moving)
            this.drawSmall();
        else
            this.drawStrip();
        if (!this.blurs || moving || this.row === 0)
            this.display();
        this.wait(this.blurs && !moving && this.row > 0);
        const time = performance.now() - begun, change = Math.min(1.5, Math.max(0.5, (moving ? WANTED : STRIP) / time));
        if (this.blurs && moving)
            this.scale = Math.min(1, Math.max(SMALLEST, this.scale * Math.sqrt(change)));
        else if (this.blurs)
            this.rows = Math.ceil(Math.min(this.height, Math.max(this.height / LEAST_STRIPS, this.rows * change)));
        this.spent += moving ? 0 : time;
        this.drawings++;
    }

    /// Returns when the graphics processor is done: with a part of a pass (`inside`), or with the picture.
    wait(inside) {
        const gl = this.gl;
        gl.readPixels(0, 0, 1, 1, gl.RGBA, inside ? gl.FLOAT : gl.UNSIGNED_BYTE, inside ? new Float32Array(4) : new Uint8Array(4));
    }

    drawSmall() {
        this.restart();
        const size = [this.width, this.height].map(n => Math.ceil(n * this.scale));
        this.gather(this.small, this.means[0], size, MOVING_TAPS, 0, size[1]);
        this.shown = this.small;
    }

    drawStrip() {
        const size = [this.width, this.height], end = Math.min(this.height, this.row + this.rows);
        this.gather(this.means[1], this.means[0], size, RESTING_TAPS, this.row, end);
        this.row = end;
        if (end === this.height) {
            this.row = 0;
            this.pass++;
            this.means.reverse();
            this.shown = this.means[0];
        }
    }

    /// Some rows, from below, of a pass; `before` is the mean of the passes before.
    gather(target, before, size, taps, from, to) {
        const gl = this.gl;
        if (target.size[0] !== size[0] || target.size[1] !== size[1]) {
            gl.bindTexture(gl.TEXTURE_2D, target.texture);
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ...size, 0, gl.RGBA, gl.FLOAT, null);
            target.size = size;
        }
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
        gl.viewport(0, 0, ...size);
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(0, from, size[0], to - from);
        const set = this.use("gather", size);
        set({ reach: [1, this.reach], mean: [2, before.texture], lensPoints: [3, this.lensPoints] });
        gl.uniform1f(set.at("tile"), TILE);
        gl.uniform1f(set.at("pixelsPerVergence"), 0.5 * blurPerVergence(this.lens, size[0]));
        gl.uniform1i(set.at("taps"), taps);
        gl.uniform1i(set.at("pass"), this.pass);
        gl.uniform1f(set.at("corners"), this.blades[0]);
        gl.uniform1f(set.at("turn"), this.blades[1]);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.disable(gl.SCISSOR_TEST);
    }

    /// The diaphragm: number of corners, 0 for a round one, and the direction of the first, radians.
    setBlades(corners, turn) {
        if (this.blades?.[0] === corners && this.blades[1] === turn)
            return;
        this.blades = [corners, turn];
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.lensPoints);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, LIST, 1, 0, gl.RGBA, gl.FLOAT, lensPointList(corners, turn));
    }

    display() {
        const gl = this.gl, { lens, show } = this, size = [this.width, this.height];
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, ...size);
        const set = this.use("display", size);
        set({ mean: [2, this.shown.texture] });
        gl.uniform1i(set.at("blurred"), this.blurs ? 1 : 0);
        gl.uniform1f(set.at("gamma"), this.gamma);
        gl.uniform1f(set.at("pixelsOfBlur"), blurPerVergence(lens, size[0]));
        for (const name of ["peaking", "map", "planes"])
            gl.uniform1i(set.at(name), show[name] ? 1 : 0);
        gl.uniform3fv(set.at("peakingColour"), PEAKING);
        gl.uniform3fv(set.at("empty"), this.empty);
        if (show.planes && lens.diameter > 0) {
            const form = v => [dot(v, lens.direction), dot(v, lens.right), dot(v, lens.up)];
            gl.uniform3fv(set.at("limits"), [1, 0, -1].flatMap(blur => form(planeOfBlur(lens, blur, size[0]))));
            const { x, y } = this.grid();
            gl.uniform3fv(set.at("gridX"), [...form(x), 0, 0, 0, 0, 0, 0]);
            gl.uniform3fv(set.at("gridY"), [...form(y), 0, 0, 0, 0, 0, 0]);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    /// Directions in the plane of sharp focus, of the length of one cell's inverse: 1, 2 or 5 times a power of ten.
    grid() {
        const { lens } = this, normal = unit(lens.focus);
        const level = along(lens.axisRight, -dot(lens.axisRight, normal), normal);
        const x = unit(length(level) > 0.1 ? level : along(lens.axisUp, -dot(lens.axisUp, normal), normal));
        const axis = axisFocusOf(lens), distance = axis > 0 && Number.isFinite(axis) ? axis : 1 / length(lens.focus);
        const wanted = 0.15 * distance * length(lens.right) / dot(lens.direction, lens.axis);
        const power = 10 ** Math.floor(Math.log10(wanted));
        this.gridSpacing = power * (wanted >= 5 * power ? 5 : wanted >= 2 * power ? 2 : 1);
        return { x: times(1 / this.gridSpacing, x), y: times(1 / this.gridSpacing, cross(normal, x)) };
    }

    // ---- WebGL ----

    program(fragment) {
        const gl = this.gl, program = gl.createProgram();
        for (const [kind, text] of [[gl.VERTEX_SHADER, EVERYWHERE], [gl.FRAGMENT_SHADER, fragment]]) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
                throw new Error(gl.getShaderInfoLog(shader));
            gl.attachShader(program, shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS))
            throw new Error(gl.getProgramInfoLog(program));
        return { program, places: {} };
    }

    texture() {
        const gl = this.gl, texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (const [name, value] of [["MIN_FILTER", "NEAREST"], ["MAG_FILTER", "NEAREST"], ["WRAP_S", "CLAMP_TO_EDGE"], ["WRAP_T", "CLAMP_TO_EDGE"]])
            gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
        return texture;
    }

    target() {
        const gl = this.gl, texture = this.texture(), framebuffer = gl.createFramebuffer();
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 1, 1, 0, gl.RGBA, gl.FLOAT, null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        return { texture, framebuffer, size: [1, 1] };
    }

    /// Takes a program, with all that both know set; returns what sets textures and finds uniforms.
    use(name, size) {
        const gl = this.gl, { program, places } = this.programs[name], { lens } = this;
        gl.useProgram(program);
        const at = uniform => (places[uniform] ??= gl.getUniformLocation(program, uniform));
        const set = textures => {
            for (const [uniform, [unit_, texture]] of Object.entries(textures)) {
                gl.activeTexture(gl.TEXTURE0 + unit_);
                gl.bindTexture(gl.TEXTURE_2D, texture);
                gl.uniform1i(at(uniform), unit_);
            }
            gl.activeTexture(gl.TEXTURE0);
        };
        set.at = at;
        set({ preview: [0, this.preview] });
        const far = dot(lens.direction, lens.axis);
        gl.uniform2f(at("size"), ...size);
        gl.uniform4f(at("toPreview"), ...frameMap(lens, this.frame));
        gl.uniform1f(at("axisLength"), far);
        gl.uniform3f(at("focus"), lens.focusMiddle, lens.focusRight, lens.focusUp);
        const lean = [lens.lensX, lens.lensY].map(l => dot(l, lens.axis) / far);
        const span = [lens.lensX, lens.lensY].flatMap((l, i) => inFrame(lens, along(l, -lean[i], lens.direction)));
        gl.uniform4f(at("lensSpan"), ...span);
        gl.uniform2f(at("lensLean"), ...lean);
        return set;
    }
}
