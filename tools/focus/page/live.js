// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The live picture: schedules drawing, and requests a preview when the frame has moved.

import { frameAround, frameMap, pointAt, solve } from "./lens.js";
import { inverseDepthOf } from "./blur.js";

const REST = 150;          // milliseconds without a change before the picture is refined
const ARRIVING = 150;      // milliseconds between pictures while the preview arrives and the processors are busy
const PREVIEW_REST = 600;  // milliseconds without a change before a new preview
const FAR = 0.02;          // of the frame; a smaller change needs no new preview

export class Live {
    /// @param begun the first part of a preview has arrived
    constructor(blur, model, ask, begun) {
        Object.assign(this, { blur, model, ask, begun });
        this.second = null;        // { blur, lens, changed }: the picture of the other lens, if both are shown
        this.drawn = () => {};
        this.complete = false;     // the preview has a value for each pixel
        this.refined = false;      // no more tiles are to come
        this.former = null;        // the previous preview of the same scene, while the current one arrives
        this.readAnew = false;     // the scene was parsed again for the arriving preview
        this.ownView = null;
        this.number = 0;
        this.lastChange = this.lastDrawing = this.timer = 0;
        this.scheduled = false;
    }

    expect({ number, frame, size }) {
        this.complete = this.refined = false;
        this.readAnew ||= !frame;
        this.number = number;
        this.askedFrame = frame;
        this.arriving = size;
    }

    take({ number, left, top, width, height, values }) {
        if (!this.ownView || number !== this.number)
            return;
        if (this.arriving) {
            this.keepFormer();
            this.blur.begin(...this.arriving);
            this.second?.blur.begin(...this.arriving, this.blur.values);
            this.arriving = null;
            this.blur.frame = this.frameOf(this.askedFrame);
            if (this.model.lens)
                this.begun();
        }
        this.blur.take(left, top, width, height, values);
        this.second?.blur.take(left, top, width, height, values);
        this.draw();
    }

    end() {
        this.complete = true;
        this.former = null;
        this.draw();
    }

    endRefining({ number }) {
        this.refined ||= number === this.number;
    }

    /// For clicks while the next arrives, unless incomplete or outdated.
    keepFormer() {
        const { values, width, height, frame } = this.blur;
        this.former = this.readAnew ? null : this.former ?? { values, width, height, frame };
        this.readAnew = false;
    }

    frameOf(asked) {
        if (asked)
            return { ...asked };
        const { ownView: view } = this;
        if (!view.block)
            return view;
        const lens = solve(view, view.block);
        return { location: view.location, direction: lens.direction, right: lens.right, up: lens.up };
    }

    /// False for a while after another camera was chosen.
    get fits() {
        return this.isFromHere(this.blur);
    }

    isFromHere(preview) {
        return Boolean(preview?.values) && String(preview.frame?.location) === String(this.model.camera.location);
    }

    /// 1/distance along the axis; 0 without a surface.
    inverseDepthAt(x, y) {
        for (const preview of [this.blur, this.former]) {
            const inverse = this.isFromHere(preview) ? inverseDepthOf(preview, this.model.lens, x, y) : 0;
            if (inverse > 0)
                return inverse;
        }
        return 0;
    }

    surfaceAt(x, y) {
        const inverse = this.inverseDepthAt(x, y);
        return inverse > 0 ? pointAt(this.model.lens, x, y, 1 / inverse) : null;
    }

    show() {
        const { blur, model } = this;
        this.lastChange = performance.now();
        blur.setBlades(model.block.blades, model.block.bladesAngle * Math.PI / 180);
        if (!this.fits)
            return false;
        blur.setLens(model.lens, blur.frame);
        this.askForFrame();
        this.draw();
        return true;
    }

    showBeside(blur, twin) {
        if (!blur || !this.fits) {
            this.second = null;
            return;
        }
        if (this.second?.blur !== blur || blur.values !== this.blur.values)
            blur.begin(this.blur.width, this.blur.height, this.blur.values);
        const { gamma, empty, show, frame } = this.blur, { lens, block } = twin, known = this.second?.lens === lens && blur.frame === frame;
        Object.assign(blur, { gamma, empty, show });
        this.second = { blur, lens, changed: known ? this.second.changed : performance.now() };
        if (known)
            return;
        blur.setBlades(block.blades, block.bladesAngle * Math.PI / 180);
        blur.setLens(lens, frame);
        this.askForFrame();
        this.draw();
    }

    askForFrame() {
        clearTimeout(this.timer);
        const then = this.blur.frame;
        if (!then || this.model.open || !this.fits)
            return;
        const [x, y, across, upward] = frameMap(this.wantedFrame, then);
        if (Math.hypot(x, y) < 1e-6 && Math.abs(across - 1) < FAR && Math.abs(upward - 1) < FAR)
            return;
        this.timer = setTimeout(() => {
            const { location, direction, right, up } = this.wantedFrame;
            this.ask({ do: "preview", camera: { location, direction, right, up } });
        }, PREVIEW_REST);
    }

    get wantedFrame() {
        return frameAround([this.model.lens, ...(this.second ? [this.second.lens] : [])]);
    }

    get blurs() {
        return [this.blur, ...(this.second ? [this.second.blur] : [])];
    }

    display() {
        if (this.blur.values && this.blur.lens)
            this.blurs.forEach(blur => blur.display());
        this.draw();
    }

    draw() {
        if (this.scheduled || !this.model.lens)
            return;
        this.scheduled = true;
        const wait = this.complete ? 0 : this.lastDrawing + ARRIVING - performance.now();
        const begin = () => requestAnimationFrame(() => this.drawNow());
        if (wait > 0)
            setTimeout(begin, wait);
        else
            begin();
    }

    drawNow() {
        this.scheduled = false;
        const now = performance.now(), { second } = this, isMoving = changed => !this.complete || now - changed < REST;
        const moving = isMoving(this.lastChange), other = second !== null && isMoving(second.changed);
        this.blur.draw(moving);
        if (other || (!moving && second?.blur.unfinished))
            second.blur.draw(other);
        this.lastDrawing = performance.now();
        this.drawn();
        if (this.complete && (moving || other || this.blur.unfinished || second?.blur.unfinished))
            this.draw();
    }
}
