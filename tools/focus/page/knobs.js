// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

const log = { to: Math.log, from: Math.exp };
const plain = { to: x => x, from: x => x };

/// name, words, unit, least, most, digits, scale of the slider, getter, setter; `said`: knob of the remarks
const GROUPS = [
    ["Lens", [
        { id: "tilt", words: "Tilt", unit: "°", least: -15, most: 15, digits: 2, said: "turn", title: "Leans the top of the lens toward the scene",
          show: m => m.numbers().tilt, turn: (m, v) => m.turn("lensTurn", "tilt", v) },
        { id: "swing", words: "Swing", unit: "°", least: -15, most: 15, digits: 2, title: "Turns the right-hand side of the lens toward the scene",
          show: m => m.numbers().swing, turn: (m, v) => m.turn("lensTurn", "swing", v) },
        { id: "fStop", words: "f-stop", unit: "f/", least: 0.5, most: 64, digits: 2, slide: log, said: "fStop", title: "Smaller: a wider lens, more blur",
          show: m => m.block.fStop, turn: (m, v) => m.setStop(v) },
        { id: "angle", words: "Angle of view", unit: "°", least: 3, most: 120, digits: 2, title: "How much the picture shows from left to right",
          show: m => m.numbers().angle, turn: (m, v) => m.setAngle(v) },
        { id: "focalLength", words: "Focal length", unit: "mm", least: 8, most: 400, digits: 1, slide: log, said: "focalLength", title: "The same in millimetres; holds the lens and lets the view breathe with the focus",
          show: m => m.numbers().focalLength, turn: (m, v) => m.setFocalLength(v) },
        { id: "real", words: "Real lens", choices: lists => [["", "any"], ...lists.lenses.map((l, i) => [String(i), l.name])],
          show: (m, lists) => (m.real ? String(lists.lenses.findIndex(l => l.name === m.real.name)) : ""),
          turn: (m, v, lists) => (v === "" ? (m.setReal(null), m.useAngle()) : m.setReal(lists.lenses[Number(v)])) },
    ]],
    ["Plane of sharp focus", [
        { id: "focusTilt", words: "Leans back", unit: "°", least: -89, most: 89, digits: 1, said: "focusTurn", title: "Leans the top of the plane away from the camera",
          show: m => m.numbers().focus.tilt, turn: (m, v) => m.turn("focusTurn", "tilt", v) },
        { id: "focusSwing", words: "Turns right", unit: "°", least: -89, most: 89, digits: 1, title: "Turns the right-hand side of the plane away from the camera",
          show: m => m.numbers().focus.swing, turn: (m, v) => m.turn("focusTurn", "swing", v) },
    ]],
    ["Film and scene", [
        { id: "sceneUnit", words: "Scene's unit", unit: "mm", least: 0.01, most: 100000, digits: 3, slide: log, title: "Millimetres in one unit of the scene. Smaller: the scene becomes a model, and its blur grows",
          show: m => m.block.sceneUnit, turn: (m, v) => m.set({ sceneUnit: v }) },
        { id: "film", words: "Film", choices: (lists, m) => [["", `${m ? Number(m.block.filmWidth.toFixed(2)) : ""} mm wide`], ...lists.films.map((f, i) => [String(i), f.name])],
          show: (m, lists) => String(lists.films.findIndex(f => Math.abs(m.filmWidth(f.size) - m.block.filmWidth) < 1e-6)).replace("-1", ""),
          turn: (m, v, lists) => v !== "" && m.set({ filmWidth: m.filmWidth(lists.films[Number(v)].size) }) },
        { id: "shiftRight", words: "Shift right", unit: "mm", least: -30, most: 30, digits: 2, said: "shift", title: "Moves the frame: shows more of what lies to the right",
          show: m => m.block.shift[0], turn: (m, v) => m.set({ shift: [v, m.block.shift[1]] }) },
        { id: "shiftUp", words: "Shift up", unit: "mm", least: -30, most: 30, digits: 2, title: "Moves the frame: shows more of what lies above. Upright lines stay upright",
          show: m => m.block.shift[1], turn: (m, v) => m.set({ shift: [m.block.shift[0], v] }) },
        { id: "blades", words: "Diaphragm", choices: () => [["0", "round"], ...[3, 4, 5, 6, 7, 8, 9, 11].map(n => [String(n), `${n} blades`])],
          show: m => String(m.block.blades), turn: (m, v) => m.set({ blades: Number(v) }) },
        { id: "bladesAngle", words: "Blades turned", unit: "°", least: 0, most: 120, digits: 1, title: "The first corner points to the right; this turns it upward",
          show: m => m.block.bladesAngle, turn: (m, v) => m.set({ bladesAngle: v }) },
    ]],
];

function element(name, properties, ...children) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
}

export function buildKnobs(place, model, lists, done) {
    place.replaceChildren();
    const shows = [];
    for (const [title, knobs] of GROUPS) {
        const group = element("fieldset", {}, element("legend", { textContent: title }));
        for (const knob of knobs)
            shows.push(knob.choices ? choice(group, knob, model, lists, done) : slider(group, knob, model, lists, done));
        place.append(group);
    }
    return () => shows.forEach(show => show());
}

function row(group, knob, ...children) {
    const label = element("label", { htmlFor: knob.id, textContent: knob.words, title: knob.title ?? "" });
    const made = element("div", { className: "knob", title: knob.title ?? "" }, label, ...children);
    const said = element("p", { className: "said" });
    said.dataset.said = knob.said ?? knob.id;
    said.setAttribute("role", "status");
    made.append(said);
    group.append(made);
}

function choice(group, knob, model, lists, done) {
    const select = element("select", { id: knob.id });
    const fill = () => {
        const choices = knob.choices(lists, model.block ? model : null);
        if (select.dataset.choices !== JSON.stringify(choices)) {
            select.dataset.choices = JSON.stringify(choices);
            select.replaceChildren(...choices.map(([value, words]) => element("option", { value, textContent: words })));
        }
    };
    select.onchange = () => {
        knob.turn(model, select.value, lists);
        done();
    };
    row(group, knob, select);
    return () => {
        fill();
        select.value = knob.show(model, lists);
    };
}

/// Accepts point and comma; NaN for other texts.
export function numberIn(written) {
    const plain = written.trim().replace(",", ".");
    return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
}

function wantedOf(knob) {
    if (knob.id === "angle")
        return { allows: value => value > 0 && value < 180, words: "an angle of more than 0 and less than 180 is needed" };
    if (knob.slide)
        return { allows: value => value > 0 && value < Infinity, words: "a number above 0 is needed" };
    return { allows: Number.isFinite, words: "a number is needed" };
}

function slider(group, knob, model, lists, done) {
    const scale = knob.slide ?? plain, least = scale.to(knob.least), most = scale.to(knob.most);
    const step = knob.slide ? (most - least) / 400 : knob.digits > 1 ? 0.1 : 0.5;
    const range = element("input", { type: "range", min: least, max: most, step, ariaLabel: `${knob.words}, slider` });
    // a number field yields nothing for a comma
    const number = element("input", { type: "text", inputMode: "decimal", autocomplete: "off", id: knob.id });
    range.oninput = () => knob.turn(model, Number(scale.from(Number(range.value)).toPrecision(4)), lists);
    range.onchange = done;
    const take = written => {
        const value = numberIn(written), wanted = wantedOf(knob);
        if (wanted.allows(value)) {
            knob.turn(model, value, lists);
        } else {
            model.refuse(knob.said ?? knob.id, `${written.trim() || "Nothing"} is refused: ${wanted.words}.`);
            number.value = shown(knob, model);
        }
        done();
    };
    number.onchange = () => take(number.value);
    number.onkeydown = event => {
        const value = numberIn(number.value) + { ArrowUp: 1, ArrowDown: -1 }[event.key];
        if (!Number.isFinite(value))
            return;
        event.preventDefault();
        take(String(value));
    };
    row(group, knob, range, number, element("span", { textContent: knob.unit }));
    return () => {
        const value = knob.show(model, lists);
        if (document.activeElement !== range)
            range.value = scale.to(Math.min(knob.most, Math.max(knob.least, value)));
        if (document.activeElement !== number || !model.error)
            number.value = shown(knob, model, lists);
    };
}

const shown = (knob, model, lists) => String(Number(knob.show(model, lists).toFixed(knob.digits)));
