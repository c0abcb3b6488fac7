// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Camera, block, points. Knobs and points change one block. An impossible change keeps the last lens and sets `error`.

import { along, dot, length, subtract, times } from "./vector.js";
import {
    LensError, angleOfView, axesOf, axisFocusOf, focusTurnOf, hingeDistanceOf, isSameLens, solve, turnOf, widestStop,
} from "./lens.js";
import { nearestPick, planePoints, sharpnessOf, visiblePoints } from "./points.js";
import { remarksOf } from "./remarks.js";

const START_STOP = 2.8;
/// Millimetres to the subject of a scene without a lens, taken for a model on a table.
const MODEL_DISTANCE = 1200;

/// Least and greatest number of points that a best plane serves; the program's own limits.
export const FEWEST = 3, MOST = 100;

export const PLAIN = {
    family: "lensTurn", filmWidth: 36, focalLength: null, sceneUnit: 1000, tilt: 0, swing: 0, focusTilt: 0, focusSwing: 0,
    planeNormal: [0, 0, 1], planeDistance: 0, points: [[0, 0, 0], [0, 0, 0], [0, 0, 0]], sharpPoints: [], sharpWithin: null,
    shift: [0, 0], fStop: null, blades: 0, bladesAngle: 0, focalPoint: [0, 0, 0], aperture: 0, scale: 1,
};

/// 1, 2, 5 times a power of ten.
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
        this.begin();
        this.width = 960;       // of the preview, pixels, in which blur counts
        this.changed = () => {};
        this.remembered = () => {};
        this.open = false;      // the focus waits for the preview, because neither scene nor user states it
    }

    begin() {
        Object.assign(this, {
            mode: "one",       // or "three", "more"
            third: "picked",   // or "level", "upright", "film"
            picks: [],
            hold: false,       // whether the f-stop is the widest that keeps the picks of "more" within a blur
            within: 1,         // that blur, pixels
            onFilm: false,     // whether the text states it in millimetres on the film
            real: null,        // a lens of tilt_lens.inc
            refused: {},       // knob -> reason why its last number was refused
            past: [],          // states, the present one last
        });
    }

    get state() {
        const { block, camera, picks, mode, third, hold, within, onFilm, real } = this;
        return { block, camera, picks, mode, third, hold, within, onFilm, real };
    }

    note({ aperture, direction, right, bokeh, matrix, inverse, scale }) {
        this.given = { aperture: aperture > 0, direction, right, bokeh };
        this.place = { matrix, inverse, scale };
    }

    take(view) {
        const { location, direction, right, up, sky } = view;
        this.camera = { location, direction, right, up, sky };
        this.note(view);
        this.begin();
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
        if (block.family === "sharp") {
            this.mode = "more";
            this.picks = block.sharpPoints.slice();
            this.hold = block.sharpWithin !== null;
            this.onFilm = view.words.includes("circle_of_confusion");
            this.within = this.hold ? Number((block.sharpWithin * this.width / block.filmWidth).toPrecision(6)) : 1;
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

    /// On the surface at its centre, as a model on a table.
    suppose(point) {
        this.close(point);
        this.block.focalPoint = point;
        this.picks = [point];
        this.resolve();
    }

    /// An unchosen scale becomes the model's.
    close(point) {
        if (this.open && this.block.sceneUnit === PLAIN.sceneUnit)
            this.block.sceneUnit = roundly(MODEL_DISTANCE / length(subtract(point, this.camera.location)));
        this.open = false;
    }

    /// Keeps the last lens on failure.
    resolve() {
        try {
            if (this.holds)
                this.block.fStop = widestStop(this.camera, this.block, this.within, this.width);
            this.lens = solve(this.camera, this.block);
            this.error = null;
        } catch (error) {
            if (!(error instanceof LensError))
                throw error;
            this.error = { knob: error.knob, message: error.message };
        }
        this.changed();
    }

    refuse(knob, words) {
        this.refused = { [knob]: words };
        this.changed();
    }

    /// An impossible state is shown as an error, and discarded at the next change.
    change(what) {
        this.refused = {};
        what(this.block);
        this.resolve();
    }

    remember() {
        if (this.error)
            return;
        const state = JSON.stringify(this.state);
        if (this.past.at(-1) !== state)
            this.past.push(state);
        this.past.splice(0, this.past.length - 100);
        this.remembered();
    }

    restore(state) {
        Object.assign(this, structuredClone(state), { refused: {}, open: false });
        this.resolve();
    }

    hasLensOf({ camera, block }) {
        const sameBlades = ["blades", "bladesAngle"].every(name => block[name] === this.block[name]);
        try {
            return sameBlades && this.lens !== null && isSameLens(this.lens, solve(camera, block));
        } catch (error) {
            if (error instanceof LensError)
                return false;
            throw error;
        }
    }

    /// @returns true if there was one
    back() {
        const now = this.past.length > 1 ? (this.past.pop(), this.past.at(-1)) : null;
        if (!now)
            return false;
        this.restore(JSON.parse(now));
        this.remembered();
        return true;
    }

    /// A point of the plane of sharp focus about which it turns.
    anchor() {
        if (this.picks.length && this.lens && Math.abs(this.offPlane(this.picks[0])) < 1e-6)
            return this.picks[0];
        const distance = this.lens ? axisFocusOf(this.lens) : 0;
        if (distance > 0 && Number.isFinite(distance))
            return along(this.camera.location, distance, this.lens.axis);
        return visiblePoints(this.lens)[0] ?? this.block.focalPoint;
    }

    /// 1 - k.X: 0 on the plane.
    offPlane(point) {
        return 1 - dot(this.lens.focus, subtract(point, this.camera.location));
    }

    /// With three points, a fourth click moves the nearest in the picture.
    pick(point) {
        if (this.mode === "more" && this.picks.length === MOST) {
            this.refuse("points", `${MOST} points are the most. Remove one, or drag it.`);
            return;
        }
        if (this.mode === "one")
            this.picks = [point];
        else if (this.mode === "more" || this.picks.length < this.wantedPicks)
            this.picks.push(point);
        else
            this.picks[nearestPick(this, point)] = point;
        this.usePicks();
        this.remember();
    }

    get wantedPicks() {
        if (this.mode === "more")
            return FEWEST;
        return this.mode === "one" || this.third === "film" ? 1 : this.third === "picked" ? 3 : 2;
    }

    move(index, point) {
        this.picks[index] = point;
        this.usePicks();
    }

    remove(index) {
        this.picks.splice(index, 1);
        this.usePicks();
        if (!this.picks.length)
            this.resolve();
        this.remember();
    }

    usePicks() {
        const points = planePoints(this);
        if (!this.picks.length)
            return;
        this.close(this.picks[0]);
        this.change(block => {
            if (points) {
                block.family = "points";
                block.points = points;
                return;
            }
            if (this.mode === "more" && this.picks.length >= FEWEST) {
                block.family = "sharp";
                block.sharpPoints = this.picks.slice();
                return;
            }
            if (this.mode === "three" && this.third === "film")
                Object.assign(block, { family: "lensTurn", tilt: 0, swing: 0 });
            else if (["points", "plane", "sharp"].includes(block.family))
                Object.assign(block, { family: "lensTurn" }, this.lens ? turnOf(this.lens) : {});
            block.focalPoint = this.picks[0];
        });
    }

    setMode(mode) {
        const several = this.mode !== "one" && mode !== "one";
        this.mode = mode;
        this.picks = mode === "one" ? this.picks.slice(0, 1) : several ? this.picks.slice(0, mode === "more" ? MOST : this.wantedPicks) : [];
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

    /// True if the f-stop follows from the points. Three of them are sharp at any.
    get holds() {
        return this.hold && this.block.family === "sharp" && this.picks.length > FEWEST;
    }

    setHold(hold, within = this.within) {
        Object.assign(this, { hold, within });
        this.change(() => {});
        this.remember();
    }

    sharpness() {
        return sharpnessOf(this);
    }

    pull(items) {
        Object.assign(this, { mode: "one", picks: [], hold: false });
        this.change(block => Object.assign(block, items));
    }

    /// About a point of the plane of sharp focus.
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

    setStop(fStop) {
        this.hold = false;
        this.set({ fStop });
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

    /// mm; the angle of view follows.
    setFocalLength(mm) {
        this.set({ focalLength: mm });
    }

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

    /// The part that the picture's proportions use.
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

    remarks() {
        return remarksOf(this);
    }

    numbers() {
        const { lens, block } = this, perMm = 1 / lens.millimetre;
        return {
            ...turnOf(lens), focus: focusTurnOf(lens), focalLength: lens.focalLength * perMm, film: lens.filmDistance * perMm,
            angle: angleOfView(lens), hinge: hingeDistanceOf(lens), axisFocus: axisFocusOf(lens), fStop: block.fStop,
        };
    }
}
