// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The user's choices: camera, block, points. Knobs and points change the same block, so that they always agree. A change that no lens
/// fulfils keeps the last lens and sets `error`.

import { along, cross, dot, length, subtract, times, unit } from "./vector.js";
import {
    LensError, angleOfView, axesOf, axisFocusOf, focusTurnOf, hingeDistanceOf, pointAt,
    project, solve, turnOf, wholeTurnOf,
} from "./lens.js";

const START_STOP = 2.8;
/// Millimetres from the lens to the subject of a scene without a lens, as if it were a model on a table.
const MODEL_DISTANCE = 1200;

const PLAIN = {
    family: "lensTurn", filmWidth: 36, focalLength: null, sceneUnit: 1000, tilt: 0, swing: 0, focusTilt: 0, focusSwing: 0,
    planeNormal: [0, 0, 1], planeDistance: 0, points: [[0, 0, 0], [0, 0, 0], [0, 0, 0]], shift: [0, 0], fStop: null,
    blades: 0, bladesAngle: 0, focalPoint: [0, 0, 0], aperture: 0, scale: 1,
};

/// The nearest of 1, 2, 5 times a power of ten.
function roundly(value) {
    const power = 10 ** Math.floor(Math.log10(value)), part = value / power;
    return power * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

export class Model {
    constructor() {
        this.camera = null;
        this.block = null;
        this.lens = null;
        this.error = null;
        this.refused = {};      // knob -> reason why its last number was refused
        this.mode = "one";      // or "three"
        this.third = "picked";  // or "level", "upright", "film"
        this.picks = [];
        this.real = null;       // a lens of tilt_lens.inc
        this.changed = () => {};
        this.past = [];
        this.open = false;      // the focus waits for the preview, because neither scene nor user states it
    }

    /// Stores properties of the scene's camera.
    note({ aperture, direction, right, bokeh, matrix, inverse, scale }) {
        this.given = { aperture: aperture > 0, direction, right, bokeh };
        this.place = { matrix, inverse, scale };
    }

    /// Takes a camera from the program.
    take(view) {
        const { location, direction, right, up, sky } = view;
        this.camera = { location, direction, right, up, sky };
        this.note(view);
        this.refused = {};
        this.picks = [];
        this.mode = "one";
        this.third = "picked";
        this.real = null;
        this.past = [];
        const block = { ...PLAIN, ...(view.block ?? {}) };
        block.sceneUnit /= block.scale;
        block.aperture *= block.scale;
        block.scale = 1;
        this.block = block;
        this.open = view.block === null;
        if (this.open) {
            const { axis } = axesOf(this.camera), distance = view.focusDistance > 0 ? view.focusDistance : length(direction);
            block.focalPoint = along(location, distance, axis);
            block.aperture = view.aperture;
            this.open = !(view.aperture > 0);
        }
        if (block.family === "points") {
            this.mode = "three";
            this.picks = block.points.slice();
        }
        block.fStop ??= this.stopOfAperture() ?? START_STOP;
        this.lens = null;
        this.resolve();
    }

    /// The f-number of the camera's `aperture`, or null.
    stopOfAperture() {
        if (!(this.block.aperture > 0))
            return null;
        try {
            const lens = solve(this.camera, this.block);
            return lens.focalLength / lens.diameter;
        } catch {
            return null;
        }
    }

    /// Initial focus and scale of a scene without a lens: on the surface at its centre, as if it were a model on a table.
    suppose(point) {
        this.close(point);
        this.block.focalPoint = point;
        this.picks = [point];
        this.resolve();
    }

    /// The focus no longer waits; a scale that nobody has chosen becomes that of such a model.
    close(point) {
        if (this.open && this.block.sceneUnit === PLAIN.sceneUnit)
            this.block.sceneUnit = roundly(MODEL_DISTANCE / length(subtract(point, this.camera.location)));
        this.open = false;
    }

    /// Solves the block; keeps the last lens on failure.
    resolve() {
        try {
            this.lens = solve(this.camera, this.block);
            this.error = null;
        } catch (error) {
            if (!(error instanceof LensError))
                throw error;
            this.error = { knob: error.knob, message: error.message };
        }
        this.changed();
    }

    /// Shows beside a knob why its number was refused.
    refuse(knob, words) {
        this.refused = { [knob]: words };
        this.changed();
    }

    /// Applies a change; an impossible state is shown as an error and discarded at the next change.
    change(what) {
        this.refused = {};
        if (!this.error)
            this.good = { block: structuredClone(this.block), camera: structuredClone(this.camera) };
        what(this.block);
        this.resolve();
    }

    /// Pushes the state for back().
    remember() {
        if (this.error)
            return;
        const state = JSON.stringify({ block: this.block, camera: this.camera, picks: this.picks, mode: this.mode, third: this.third, real: this.real });
        if (this.past.at(-1) !== state)
            this.past.push(state);
        this.past.splice(0, this.past.length - 100);
    }

    /// Goes back one step. @returns true if there was one
    back() {
        const now = this.past.length > 1 ? (this.past.pop(), this.past.at(-1)) : null;
        if (!now)
            return false;
        Object.assign(this, JSON.parse(now), { refused: {} });
        this.resolve();
        return true;
    }

    // ---- points ----

    /// A point of the plane of sharp focus about which it turns.
    anchor() {
        if (this.picks.length && this.lens && Math.abs(this.offPlane(this.picks[0])) < 1e-6)
            return this.picks[0];
        const distance = this.lens ? axisFocusOf(this.lens) : 0;
        if (distance > 0 && Number.isFinite(distance))
            return along(this.camera.location, distance, this.lens.axis);
        return this.visiblePoints()[0] ?? this.block.focalPoint;
    }

    /// 1 - k.X: 0 on the plane of sharp focus.
    offPlane(point) {
        return 1 - dot(this.lens.focus, subtract(point, this.camera.location));
    }

    /// A click into the scene. With three points, a fourth click moves the point nearest in the picture.
    pick(point) {
        if (this.mode === "one") {
            this.picks = [point];
        } else {
            if (this.picks.length < this.wantedPicks)
                this.picks.push(point);
            else
                this.picks[this.nearestPick(point)] = point;
        }
        this.usePicks();
        this.remember();
    }

    /// Number of points that determine the plane.
    get wantedPicks() {
        return this.mode === "one" || this.third === "film" ? 1 : this.third === "picked" ? 3 : 2;
    }

    nearestPick(point) {
        const at = project(this.lens, point);
        const far = this.picks.map(p => {
            const there = project(this.lens, p);
            return Math.hypot(there.x - at.x, there.y - at.y);
        });
        return far.indexOf(Math.min(...far));
    }

    move(index, point) {
        this.picks[index] = point;
        this.usePicks();
    }

    /// The points of the plane: picked, and derived from the choice for the third.
    planePoints() {
        const { picks } = this;
        if (this.wantedPicks === 1 || picks.length < 2)
            return null;
        if (picks.length === 3)
            return picks;
        const { axis, right } = axesOf(this.camera), sky = unit(this.camera.sky);
        const across = cross(sky, axis), level = length(across) > 1e-6 ? unit(across) : right;
        const size = Math.max(length(subtract(picks[1], picks[0])), length(subtract(picks[0], this.camera.location)) / 4);
        return [picks[0], picks[1], along(picks[0], size, this.third === "upright" ? sky : level)];
    }

    usePicks() {
        const points = this.planePoints();
        if (!this.picks.length)
            return;
        this.close(this.picks[0]);
        this.change(block => {
            if (points) {
                block.family = "points";
                block.points = points;
                return;
            }
            if (this.mode === "three" && this.third === "film")
                Object.assign(block, { family: "lensTurn", tilt: 0, swing: 0 });
            else if (block.family === "points" || block.family === "plane")
                Object.assign(block, { family: "lensTurn" }, this.lens ? turnOf(this.lens) : {});
            block.focalPoint = this.picks[0];
        });
    }

    setMode(mode) {
        this.mode = mode;
        this.picks = mode === "one" ? this.picks.slice(0, 1) : [];
        this.usePicks();
        if (!this.picks.length)
            this.resolve();
        this.remember();
    }

    setThird(third) {
        this.third = third;
        this.picks = this.picks.slice(0, this.wantedPicks);
        this.usePicks();
        if (!this.picks.length)
            this.resolve();
        this.remember();
    }

    // ---- knobs ----

    /// Turns the lens, or the plane of sharp focus, about a point of that plane.
    turn(family, part, value) {
        const anchor = this.anchor();
        this.close(anchor);
        const now = family === "lensTurn" ? turnOf(this.lens) : focusTurnOf(this.lens);
        const said = this.block.family === family && this.error;
        this.mode = "one";
        this.picks = this.picks.slice(0, 1);
        this.change(block => {
            const names = family === "lensTurn" ? { tilt: "tilt", swing: "swing" } : { tilt: "focusTilt", swing: "focusSwing" };
            if (!said)
                for (const [key, name] of Object.entries(names))
                    block[name] = Math.abs(now[key]) < 1e-9 ? 0 : now[key];
            block.family = family;
            block.focalPoint = anchor;
            block[names[part]] = value;
        });
    }

    /// Sets items of the block that do not concern the focus.
    set(items) {
        this.change(block => Object.assign(block, items));
    }

    /// Sets the angle of view, degrees; the focal length follows.
    setAngle(degrees) {
        const { axis } = axesOf(this.camera), wanted = 0.5 * length(this.camera.right) / Math.tan(degrees * Math.PI / 360);
        this.real = null;
        this.change(block => {
            this.camera.direction = times(wanted / dot(axis, this.camera.direction), this.camera.direction);
            block.focalLength = null;
        });
    }

    /// Sets the focal length, mm; the angle of view follows.
    setFocalLength(mm) {
        this.set({ focalLength: mm });
    }

    /// Replaces the focal length by its current angle of view.
    useAngle() {
        if (this.block.focalLength === null)
            return;
        this.change(block => {
            const { axis } = axesOf(this.camera), film = this.lens.filmDistance / this.lens.millimetre;
            const wanted = film * length(this.camera.right) / block.filmWidth;
            this.camera.direction = along(this.camera.direction, wanted - dot(axis, this.camera.direction), axis);
            block.focalLength = null;
        });
    }

    /// Film width for a format: the part that the picture's proportions use.
    filmWidth([longer, shorter]) {
        const aspect = length(this.camera.right) / length(this.camera.up);
        return aspect >= 1 ? Math.min(longer, shorter * aspect) : Math.min(shorter, longer * aspect);
    }

    /// A real lens on full frame, or null.
    setReal(real) {
        this.real = real;
        if (real)
            this.set({ focalLength: real.focalLength, fStop: Math.max(this.block.fStop, real.fStop), filmWidth: this.filmWidth([36, 24]) });
        else
            this.resolve();
        this.remember();
    }

    // ---- what is shown ----

    /// Limits of the chosen real lens, and unusual values: knob -> words.
    remarks() {
        const { real, block, lens } = this, said = { ...this.refused };
        if (!lens)
            return said;
        const turn = wholeTurnOf(lens), shift = Math.hypot(...block.shift);
        if (real && turn > real.tilt + 1e-6)
            said.turn ??= `This needs ${turn.toFixed(1)}°. The real lens tilts up to ${real.tilt}°.`;
        else if (turn > 15)
            said.turn ??= `${turn.toFixed(1)}° is much; real lenses stop at about 10°.`;
        if (real && shift > real.shift + 1e-6)
            said.shift ??= `${shift.toFixed(1)} mm. The real lens shifts up to ${real.shift} mm.`;
        if (real && block.fStop < real.fStop - 1e-6)
            said.fStop ??= `The real lens opens to f/${real.fStop} only.`;
        return said;
    }

    /// Numbers for a photographer.
    numbers() {
        const { lens, block } = this, perMm = 1 / lens.millimetre;
        return {
            ...turnOf(lens), focus: focusTurnOf(lens), focalLength: lens.focalLength * perMm, film: lens.filmDistance * perMm,
            angle: angleOfView(lens), hinge: hingeDistanceOf(lens), axisFocus: axisFocusOf(lens), fStop: block.fStop,
        };
    }

    /// Visible points of the plane of sharp focus, spread over the picture, nearest to its centre first.
    visiblePoints() {
        const found = [];
        for (const [x, y] of [[0, 0], [-0.25, -0.25], [0.25, -0.25], [0, 0.3], [0, -0.45], [-0.3, 0.2], [0.3, 0.2]]) {
            const w = this.lens.focusMiddle + x * this.lens.focusRight + y * this.lens.focusUp;
            if (w > 0)
                found.push(pointAt(this.lens, x, y, dot(this.lens.direction, this.lens.axis) / w));
        }
        return found;
    }
}
