// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Lenses A and B of one camera: one is the model's, the other waits.

import { Model } from "./model.js";

const nameOfOther = { A: "B", B: "A" };

export class Pair {
    constructor(model) {
        this.model = model;
        this.beside = false;
        this.begin();
    }

    begin() {
        this.shown = "A";
        this.other = null; // { state, past }; null until the other lens is first shown
    }

    get waiting() {
        return nameOfOther[this.shown];
    }

    get present() {
        const { error, past, state } = this.model;
        return { state: error && past.length ? JSON.parse(past.at(-1)) : structuredClone(state), past };
    }

    copy() {
        this.other ??= structuredClone(this.present);
    }

    swap() {
        const { model } = this;
        this.copy();
        const next = this.other;
        this.other = this.present;
        this.shown = this.waiting;
        model.past = next.past;
        model.restore(next.state);
        model.remember();
    }

    setBeside(beside) {
        this.beside = beside;
        this.model.changed();
        this.model.remembered();
    }

    get twin() {
        const { model } = this;
        if (!this.beside || model.open || !model.lens)
            return null;
        this.copy();
        const { given, place, width } = model, { state } = this.other;
        if (this.made?.of !== state || this.made.width !== width)
            this.made = { of: state, width, twin: modelOf(state, { given, place, width }) };
        return Object.assign(this.made.twin, { given, place });
    }

    get kept() {
        return (this.other || this.beside) && { shown: this.shown, other: this.other?.state ?? null, beside: this.beside };
    }

    restore({ shown, other, beside }) {
        this.beside = beside === true;
        if (!other || modelOf(other, this.model).error)
            return;
        this.shown = shown === "B" ? "B" : "A";
        this.other = { state: other, past: [JSON.stringify(other)] };
    }
}

function modelOf(state, { given, place, width }) {
    const made = Object.assign(new Model(), { given, place, width });
    made.restore(state);
    return made;
}
