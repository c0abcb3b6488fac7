// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { solve } from "./lens.js";
import { unit } from "./vector.js";
import { Model } from "./model.js";
import { openBlur } from "./blur.js";
import { Live } from "./live.js";
import { buildKnobs } from "./knobs.js";
import { buildStage } from "./stage.js";
import { buildCameras } from "./cameras.js";
import { drawSide, surfaceSection } from "./side.js";
import { buildText } from "./text.js";
import { isState, markOf, readAddress, writeAddress } from "./address.js";
import { Pair } from "./pair.js";
import { buildBeside } from "./beside.js";
import { areKeys } from "./pull.js";
import { buildFilm } from "./film.js";
import { buildReading } from "./reading.js";
import { buildMore } from "./more.js";
import { connect } from "./connection.js";
import { buildTruth } from "./truth.js";
import { buildProbe } from "./probe.js";

const find = id => document.getElementById(id);
const model = new Model(), pair = new Pair(model);
const ask = message => line.ask(message);
let blur, live, line, knobs, scene, reading, beside;
let startedFor = null;   // signature of the camera that the model started with
let startedFrom = null;  // place and direction of that camera
let ownClock = false;    // the next scene is of a clock that this page has set
let chosen = null;       // index of the chosen camera; null: the scene's own
const ownStamps = new Set(); // stamps of the file after changes by a page, until the scene of each arrives
let changedFiles = "";   // files whose change led to this preview
let kept = readAddress(); // value in the address, until the first scene

model.remembered = () => {
    showBack();
    keep();
};

model.changed = () => {
    if (!model.lens || !blur || !scene)
        return;
    knobs();
    stage.show();
    more();
    say();
    text.show();
    film.show();
    truth.show();
    if (live.show())
        showSide();
    beside();
    reading.show();
};

const showSide = () => drawSide(find("side"), model.lens, surfaceSection(model.lens, (x, y) => blur.inverseDepthAt(x, y)));

function status(words) {
    find("status").textContent = changedFiles && words ? `${changedFiles} changed: ${words}` : words.charAt(0).toUpperCase() + words.slice(1);
}

const showBack = () => (find("back").disabled = model.past.length < 2);

function say() {
    const remarks = { ...model.remarks(), ...(model.error ? { [model.error.knob]: model.error.message } : {}) };
    for (const place of document.querySelectorAll("[data-said]"))
        place.textContent = remarks[place.dataset.said] ?? "";
    const known = [...document.querySelectorAll("[data-said]")].some(p => p.dataset.said === model.error?.knob);
    if (model.error && !known)
        document.querySelector("[data-said=points]").textContent = model.error.message;
    document.querySelector(`input[name=mode][value=${model.mode}]`).checked = true;
    find("third-choice").hidden = model.mode !== "three";
    find("third").value = model.third;
    showBack();
    find("hint").textContent = hint();
}

function hint() {
    const keys = stage.byKeys() ? " Arrow keys move the cross, with Shift in larger steps; Enter picks." : "";
    const other = pair.twin ? ` A click into the other picture goes to lens ${pair.waiting}.` : "";
    return advice() + other + keys;
}

function advice() {
    if (model.mode === "one")
        return "Click what is to be sharp.";
    const missing = model.wantedPicks - model.picks.length;
    if (missing > 0)
        return `Click ${model.picks.length ? `${missing} more` : missing} ${missing === 1 ? "place that is" : "places that are"} to be sharp.`;
    if (model.mode === "more")
        return "Each click adds a point. Drag a point to move it.";
    return "All of these are sharp. Drag a point, or click to move the nearest.";
}

function takeScene(message) {
    if (isOfAnotherTime(message))
        return;
    const other = Number.isInteger(kept?.chosen) ? message.cameras[kept.chosen] : null;
    if (other && markOf(signatureOf(other)) === kept.of)
        ({ chosen } = kept);
    const index = chosen !== null && chosen < message.cameras.length ? chosen : null;
    scene = { ...message, view: index === null ? message.view : message.cameras[index] };
    const { view } = scene;
    [model.width] = message.size;
    live.ownView = message.view;
    showLeftOut();
    cameras.show(message, index ?? message.used);
    blur.gamma = message.gamma === null || message.gamma === "sRGB" ? 0 : message.gamma;
    knobs ??= buildKnobs(find("knobs"), model, message.lenses, () => model.remember());
    // the same camera, changed elsewhere: the lens stays
    takeView(view, ownStamps.delete(message.stamp));
    if (index !== null)
        askForCamera();
    if (!view.perspective)
        complain({ message: "This camera is not perspective. Only the perspective camera has a lens." });
}

function isOfAnotherTime({ animated, clock: now, clocks: [least, most] }) {
    const { clock } = kept ?? {};
    if (!animated || !Number.isFinite(clock) || clock === now || clock < least || clock > most)
        return false;
    kept.clock = null;
    ask({ do: "preview", clock });
    return true;
}

/// Shown by neither the live nor the true picture.
function showLeftOut() {
    const { bokeh, normal } = scene.view;
    const items = [bokeh && "bokeh picture", normal && "normal"].filter(Boolean).join(" and ");
    const words = `Neither this picture nor the true one shows the camera's ${items}; a render of your scene does.`;
    find("left-out").textContent = items && words;
}

/// Without its place in the scene.
function signatureOf(view) {
    const { file, line: place, offset, own, kept: items, ...camera } = view;
    return JSON.stringify(camera);
}

/// Unless the page shows it or has written it.
function takeView(view, written = false) {
    const signature = signatureOf(view);
    const { location, direction, right, up } = view, from = JSON.stringify([location, unit(direction), right, up]);
    const seen = startedFor === signature;
    // between the marks of a focus pull, names the shown lens
    const pulled = ownClock && film.keys.length > 1 && startedFrom === from;
    startedFor = signature;
    startedFrom = from;
    ownClock = false;
    if (seen || written || pulled) {
        kept = null;
        model.note(view);
        model.changed();
        keep();
        return;
    }
    pair.begin();
    model.take(view);
    takeKept();
    model.remember();
}

/// Unless the focus waits for the preview.
function keep() {
    if (!model.open && !model.error)
        writeAddress({ of: markOf(startedFor), chosen, clock: cameras.animated ? scene.clock : null, state: model.state, pair: pair.kept, keys: film.keys });
}

/// If they are of the shown camera or its lens.
function takeKept() {
    const found = kept;
    kept = null;
    if (!found)
        return;
    if (isState(found.state) && (found.of === markOf(startedFor) || model.hasLensOf(found.state))) {
        if (areKeys(found.keys))
            film.keys = found.keys;
        if (isState(found.pair?.other))
            pair.restore(found.pair);
        model.restore(found.state);
    } else
        model.refuse("points", "The address holds a lens of another camera or scene. This is the scene's own.");
}

function askForCamera() {
    const { view } = scene, lens = view.block ? solve(view, view.block) : view;
    const { location } = view, { direction, right, up } = lens;
    ask({ do: "preview", camera: { location, direction, right, up }, chosen });
}

function takePreviewState(message) {
    if (message.state === "begun") {
        live.expect(message);
        status("preview …");
        return;
    }
    status(changedFiles && "this is the new preview.");
    changedFiles = "";
    live.end();
    if (model.open && blur.values)
        supposeFocus();
    else if (model.lens && blur.lens)
        showSide();
}

function takeFileState(message) {
    if (message.pull)
        film.take(message);
    if (!text.take(message) || message.again)
        return;
    ownStamps.add(message.stamp);
    chosen = message.chosen;
}

/// Without a lens: the surface at the picture's centre, or near it.
function supposeFocus() {
    for (const [x, y] of [[0, 0], [0, -0.15], [0, -0.3], [0.2, -0.2], [-0.2, -0.2], [0, -0.45], [0, 0.2]]) {
        const point = live.surfaceAt(x, y);
        if (point) {
            model.suppose(point);
            model.past.pop(); // the state before, without a focus, is no step to go back to
            model.remember();
            return;
        }
    }
    model.open = false;
}

function complain(error) {
    const place = find("message");
    place.hidden = !error?.message;
    if (place.hidden)
        return;
    live?.end(); // no more tiles
    changedFiles = "";
    status("");
    place.replaceChildren();
    const where = error.file ? `${error.file}${error.line ? `, line ${error.line}` : ""}: ` : "";
    place.append(where + error.message);
    if (error.text) {
        const code = document.createElement("pre");
        code.textContent = error.text;
        place.append(code);
    }
}

const takes = {
    scene: takeScene,
    preview: takePreviewState,
    refined: message => live.endRefining(message),
    error: complain,
    file: takeFileState,
    picture: message => truth.take(message),
    progress: message => message.share < 1 && status(`preview ${Math.floor(100 * message.share)} %`),
    changed: message => (changedFiles = message.files.join(", ")),
};

const stage = buildStage(model, {
    pointAt: (x, y) => live.surfaceAt(x, y),
    done: () => model.remember(),
    cross: (x, y) => reading.moveTo([x, y]),
    entered: () => (find("hint").textContent = hint()),
    nothing: () => (find("hint").textContent = live.complete
        ? "There is nothing at this place to focus on. Click a thing."
        : "The preview has not come this far yet. Wait a moment, then click again."),
});
const cameras = buildCameras(find, {
    camera: index => {
        chosen = index;
        scene = { ...scene, view: scene.cameras[chosen] };
        showLeftOut();
        takeView(scene.view);
        askForCamera();
    },
    clock: clock => {
        model.remember();
        if (cameras.animated) {
            ownClock = true;
            ask({ do: "preview", clock });
        }
    },
    moved: time => film.moved(time),
});
const more = buildMore(find, model);
const text = buildText(find, model, cameras.kept, ask);
const film = buildFilm(find, model, cameras, cameras.kept, ask, keep);
const truth = buildTruth(find, stage, pair, () => [blur.width, blur.height], () => (cameras.animated ? scene.clock ?? cameras.time() : null), ask);

function listen() {
    for (const name of ["blur", "peaking", "map", "planes"])
        find(`show-${name}`).onchange = event => {
            blur.show[name] = event.target.checked;
            find("legend").hidden = !blur.show.map;
            live.display();
        };
    document.querySelectorAll("input[name=mode]").forEach(radio => (radio.onchange = () => model.setMode(radio.value)));
    find("third").onchange = event => model.setThird(event.target.value);
    find("back").onclick = () => model.back();
    document.onkeydown = event => {
        const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !["text", "select-one"].includes(event.target.type);
        if (plain && event.key.toLowerCase() === "x" && model.lens)
            pair.swap();
        if (plain && event.key.toLowerCase() === "s")
            find("beside").click();
        if (plain && event.key.toLowerCase() === "l")
            find("show-loupe").click();
        if ((event.ctrlKey || event.metaKey) && event.key === "z" && event.target.type !== "text") {
            event.preventDefault();
            model.back();
        }
    };
    onhashchange = () => location.reload();
    const dark = matchMedia("(prefers-color-scheme: dark)");
    const paint = () => {
        for (const each of live.blurs)
            each.empty = dark.matches ? [0.055, 0.06, 0.067] : [0.914, 0.914, 0.894];
        live.draw();
    };
    dark.onchange = paint;
    paint();
    new ResizeObserver(() => model.lens && blur.values && blur.lens && showSide()).observe(find("side"));
}

try {
    blur = openBlur(find("picture"));
    live = new Live(blur, model, ask, model.changed);
    reading = buildReading(find, model, blur, (x, y) => live.inverseDepthAt(x, y));
    beside = buildBeside(find, pair, live, film => stage.pick(film));
    live.drawn = () => reading.drawLoupe();
    listen();
    line = connect({
        message: message => takes[message.type]?.(message),
        preview: tile => live.take(tile),
        picture: tile => truth.takeTile(tile),
        open: () => {
            kept ??= readAddress();
            status("preview …");
        },
        closed: () => complain({ message: "The program has ended. Start ./focus again and open its new address." }),
    });
} catch (error) {
    complain({ message: error.message });
}

window.focusPage = live && buildProbe(model, live);
