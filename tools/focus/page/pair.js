// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Two lenses for one camera, A and B: one is the model's, the other waits.

export class Pair {
    constructor(model) {
        this.model = model;
        this.begin();
    }

    begin() {
        this.shown = "A";
        this.other = null; // { state, past } of the other lens; null until it is first shown
    }

    /// Shows the other lens, which begins as a copy.
    swap() {
        const { model } = this, present = { state: structuredClone(model.state), past: model.past };
        const next = this.other ?? structuredClone(present);
        this.other = present;
        this.shown = this.shown === "A" ? "B" : "A";
        model.past = next.past;
        model.restore(next.state);
        model.remember();
    }

    /// For the address.
    get kept() {
        return this.other && { shown: this.shown, other: this.other.state };
    }

    /// Takes the lenses that the address holds.
    restore({ shown, other }) {
        this.shown = shown === "B" ? "B" : "A";
        this.other = { state: other, past: [JSON.stringify(other)] };
    }
}

export function buildPair(pair) {
    const radios = document.querySelectorAll("input[name=pair]");
    radios.forEach(radio => (radio.onchange = () => radio.value !== pair.shown && pair.swap()));
    return () => radios.forEach(radio => (radio.checked = radio.value === pair.shown));
}
