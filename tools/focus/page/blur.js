// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Draws the preview through a lens on the graphics processor: a change draws one pass at reduced size; at rest, passes at full size are
/// averaged.

import { along, cross, dot, length, times, unit } from "./vector.js";
import { axisFocusOf, blurPerVergence, frameMap, inFrame, planeOfBlur } from "./lens.js";
import { newProgram, newTarget, newTexture, setSize } from "./gl.js";
import { Reach, TILE } from "./reach.js";
import { DISPLAY, GATHER, LIST } from "./shaders.js";

const WANTED = 24;         // milliseconds for a picture during motion: 30 per second with the rest of the page
const SMALLEST = 0.125;    // of the full size, during motion
const SIZES = 16;          // steps of the size, because a change takes time
const MOVING_TAPS = 16, RESTING_TAPS = 32;
const PASSES = 24;         // until the picture is smooth
const STRIP = 20;          // milliseconds for a part of a pass at full size, for which a click waits
const LEAST_STRIPS = 16;
const PATIENCE = 15000;    // milliseconds of work after which the picture counts as smooth
const PEAKING = [1, 0.05, 0.35];
/// Near limit, plane of sharp focus, far limit: the colours of show_planes.
const TINTS = [[0.95, 0.50, 0.05], [1, 1, 1], [0.05, 0.30, 0.95]];

/// Diaphragm and the disc around it: Roberts's R2 sequence, mapped to the shape.
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

/// 1/distance; 0 without a surface, NaN outside the preview.
export function inverseDepthOf({ values, width, height, frame }, lens, x, y) {
    const [ox, oy, fx, fy] = frameMap(lens, frame);
    const column = Math.floor((ox + fx * x + 0.5) * width), row = Math.floor((0.5 - oy - fy * y) * height);
    const inside = column >= 0 && row >= 0 && column < width && row < height;
    return inside ? values[(row * width + column) * 4 + 3] : NaN;
}

/// @throws Error without WebGL2 and float textures
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
        this.patience = PATIENCE;
        this.programs = {};
        this.preview = newTexture(gl);
        this.reachTexture = newTexture(gl);
        this.lensPoints = newTexture(gl);
        this.small = newTarget(gl);                  // during motion
        this.means = [newTarget(gl), newTarget(gl)]; // and the next
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

    restart() {
        this.pass = this.row = this.spent = 0;
        this.undisplayed = false; // a pass is complete but not yet shown
    }

    begin(width, height, values = null) {
        this.width = width;
        this.height = height;
        this.canvas.style.aspectRatio = `${width} / ${height}`;
        this.rows = Math.ceil(height / LEAST_STRIPS);
        this.values = values ?? new Float32Array(width * height * 4);
        this.reach = new Reach(width, height, this.values);
        if (values)
            this.reach.note(0, 0, width, height);
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.preview);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, this.values);
    }

    take(left, top, width, height, values) {
        for (let row = 0; row < height; row++)
            this.values.set(values.subarray(row * width * 4, (row + 1) * width * 4), ((top + row) * this.width + left) * 4);
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.preview);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, left, top, width, height, gl.RGBA, gl.FLOAT, values);
        this.reach.note(left, top, width, height);
        this.reachOf = null;
        this.restart();
    }

    inverseDepthAt(x, y) {
        return inverseDepthOf(this, this.lens, x, y);
    }

    updateReach() {
        const gl = this.gl, { columns, rows } = this.reach;
        gl.bindTexture(gl.TEXTURE_2D, this.reachTexture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32F, columns, rows, 0, gl.RED, gl.FLOAT, this.reach.of(this.lens, this.frame));
    }

    setLens(lens, frame) {
        this.lens = lens;
        this.frame = frame;
        this.reachOf = null;
        this.restart();
    }

    get blurs() {
        return this.show.blur && this.lens.diameter > 0;
    }

    get unfinished() {
        if (!this.values || !this.lens)
            return false;
        return this.undisplayed || this.pass === 0 || (this.blurs && this.pass < PASSES && this.spent < this.patience);
    }

    draw(moving) {
        if (!this.values || !this.lens || !this.frame)
            return;
        const begun = performance.now();
        if (this.reachOf !== this.lens) {
            this.updateReach();
            this.reachOf = this.lens;
        }
        const part = !moving && this.blurs && !this.undisplayed;
        if (part)
            this.drawStrip();
        else
            this.drawWhole(moving);
        this.wait(part);
        this.adapt(moving, part, performance.now() - begun);
        this.drawings++;
    }

    drawWhole(moving) {
        if (!this.blurs)
            this.pass = 1;
        else if (moving)
            this.drawSmall();
        this.display();
        this.undisplayed = false;
    }

    adapt(moving, part, time) {
        const usual = this.wasMoving || time > 2 * WANTED;
        this.work = time;
        this.wasMoving = moving;
        const change = Math.min(1.5, Math.max(0.5, (moving ? WANTED : STRIP) / time));
        if (this.blurs && moving && usual)
            this.scale = Math.min(1, Math.max(SMALLEST, this.scale * Math.sqrt(change)));
        else if (part)
            this.rows = Math.ceil(Math.min(this.height, Math.max(this.height / LEAST_STRIPS, this.rows * change)));
        this.spent += part ? time : 0;
    }

    wait(inside) {
        const gl = this.gl;
        gl.readPixels(0, 0, 1, 1, gl.RGBA, inside ? gl.FLOAT : gl.UNSIGNED_BYTE, inside ? new Float32Array(4) : new Uint8Array(4));
    }

    drawSmall() {
        this.restart();
        const scale = Math.ceil(this.scale * SIZES) / SIZES, size = [this.width, this.height].map(n => Math.ceil(n * scale));
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
            this.undisplayed = true;
        }
    }

    /// Rows count from below; `before`: mean of earlier passes.
    gather(target, before, size, taps, from, to) {
        const gl = this.gl;
        setSize(gl, target, size);
        gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
        gl.viewport(0, 0, ...size);
        gl.enable(gl.SCISSOR_TEST);
        gl.scissor(0, from, size[0], to - from);
        const bladed = this.blades[0] >= 3;
        const set = this.use(GATHER, bladed ? ["BLADES"] : [], size);
        set({ reach: [1, this.reachTexture], mean: [2, before.texture], lensPoints: [3, this.lensPoints] });
        gl.uniform1f(set.at("tile"), TILE);
        gl.uniform1f(set.at("pixelsPerVergence"), 0.5 * blurPerVergence(this.lens, size[0]));
        gl.uniform1i(set.at("taps"), taps);
        gl.uniform1i(set.at("pass"), this.pass);
        if (bladed) {
            gl.uniform1f(set.at("corners"), this.blades[0]);
            gl.uniform1f(set.at("turn"), this.blades[1]);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.disable(gl.SCISSOR_TEST);
    }

    /// 0 corners: round. `turn`: direction of the first, radians.
    setBlades(corners, turn) {
        if (this.blades?.[0] === corners && this.blades[1] === turn)
            return;
        this.blades = [corners, turn];
        const gl = this.gl;
        gl.bindTexture(gl.TEXTURE_2D, this.lensPoints);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, LIST, 1, 0, gl.RGBA, gl.FLOAT, lensPointList(corners, turn));
    }

    display() {
        const gl = this.gl, { lens, show, canvas } = this, size = this.blurs ? this.shown.size : [this.width, this.height];
        if (canvas.width !== size[0] || canvas.height !== size[1])
            [canvas.width, canvas.height] = size;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, ...size);
        const planes = show.planes && lens.diameter > 0;
        const parts = { BLURRED: this.blurs, GAMMA: this.gamma !== 0, MAP: show.map, PEAKING: show.peaking, PLANES: planes };
        const set = this.use(DISPLAY, Object.keys(parts).filter(name => parts[name]), size);
        set({ mean: [2, this.shown.texture] });
        gl.uniform1f(set.at("gamma"), this.gamma);
        gl.uniform1f(set.at("pixelsOfBlur"), blurPerVergence(lens, this.width));
        gl.uniform3fv(set.at("peakingColour"), PEAKING);
        gl.uniform3fv(set.at("empty"), this.empty);
        if (planes) {
            const form = v => [dot(v, lens.direction), dot(v, lens.right), dot(v, lens.up)];
            gl.uniform3fv(set.at("tints"), TINTS.flat().map(shown => this.sceneValue(shown)));
            gl.uniform3fv(set.at("limits"), [1, 0, -1].flatMap(blur => form(planeOfBlur(lens, blur, this.width))));
            const { x, y } = this.grid();
            gl.uniform3fv(set.at("gridX"), [...form(x), 0, 0, 0, 0, 0, 0]);
            gl.uniform3fv(set.at("gridY"), [...form(y), 0, 0, 0, 0, 0, 0]);
        }
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    sceneValue(shown) {
        if (this.gamma === 0)
            return shown;
        const light = shown <= 0.04045 ? shown / 12.92 : ((shown + 0.055) / 1.055) ** 2.4;
        return light ** (1 / this.gamma);
    }

    /// Inverse in length to a grid cell: 1, 2 or 5 times a power of ten.
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

    use(shader, parts, size) {
        const gl = this.gl, name = [shader === GATHER ? "gather" : "display", ...parts].join(" "), { lens } = this;
        const { program, places } = (this.programs[name] ??= newProgram(gl, shader, parts));
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
