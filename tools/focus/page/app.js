// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The page: joins the model, the live picture, the knobs and the program behind them.

import { dot, subtract, length } from "./vector.js";
import { pointAt, solve } from "./lens.js";
import { Model } from "./model.js";
import { openBlur } from "./blur.js";
import { buildKnobs } from "./knobs.js";
import { buildStage } from "./stage.js";
import { drawSide, surfaceSection } from "./side.js";
import { FORMS, copyText, describe } from "./block.js";
import { connect } from "./connection.js";
import { buildTruth } from "./truth.js";
import { buildProbe } from "./probe.js";

const REST = 150;          // milliseconds without a change, until the picture is refined
const ARRIVING = 150;      // between two pictures while the preview arrives: the processors have enough to do
const PREVIEW_REST = 600;  // and until the preview is made for a changed frame
const FAR = 0.02;          // of the frame: a smaller change of it needs no new preview

const find = id => document.getElementById(id);
const model = new Model();
let blur, knobs, scene, line, lastChange = 0, previewTimer = 0, form = "plane", waitsForPreview = false, drawing = false;
let complete = false, lastDrawing = 0;
let previewNumber = 0, askedFrame = null, startedFor = null, chosen = null, ownChange = false;

// ---- drawing ----

/// The frame that a preview was taken with: what was asked for, or the scene's own camera with its own lens.
function frameOf(asked) {
    if (asked)
        return { ...asked };
    const { ownView: view } = scene;
    if (!view.block)
        return view;
    const lens = solve(view, view.block);
    return { location: view.location, direction: lens.direction, right: lens.right, up: lens.up };
}

function draw() {
    if (drawing || !blur || !model.lens)
        return;
    drawing = true;
    const wait = complete ? 0 : lastDrawing + ARRIVING - performance.now();
    const begin = () => requestAnimationFrame(() => {
        drawing = false;
        const moving = !complete || performance.now() - lastChange < REST;
        blur.draw(moving);
        lastDrawing = performance.now();
        if (complete && (moving || blur.unfinished))
            draw();
    });
    if (wait > 0)
        setTimeout(begin, wait);
    else
        begin();
}

/// Whether the preview was taken from where the camera stands; after another camera was chosen it is not, for a while.
const fits = () => String(blur.frame?.location) === String(model.camera.location);

/// Called for each change of the model.
function changed() {
    if (!model.lens || !blur || !scene)
        return;
    lastChange = performance.now();
    blur.setBlades(model.block.blades, model.block.bladesAngle * Math.PI / 180);
    knobs();
    stage.show();
    say();
    showText();
    if (!blur.values || !fits())
        return;
    blur.setLens(model.lens, blur.frame);
    showSide();
    askForFrame();
    draw();
}
model.changed = changed;

const showSide = () => drawSide(find("side"), model.lens, surfaceSection(model.lens, (x, y) => blur.inverseDepthAt(x, y)));

/// A new preview once the frame has moved away from that of the present one.
function askForFrame() {
    clearTimeout(previewTimer);
    const now = model.lens, then = blur.frame;
    if (!then || waitsForPreview || !fits())
        return;
    const far = v => dot(v, now.axis), scaled = v => v.map(x => x / far(v));
    const moved = length(subtract(scaled(now.direction), scaled(then.direction))) * far(now.direction) / length(now.right);
    const zoomed = Math.abs(far(now.direction) / far(then.direction) * length(then.right) / length(now.right) - 1);
    if (moved < 1e-6 && zoomed < FAR)
        return;
    previewTimer = setTimeout(() => {
        const { location, direction, right, up } = model.lens;
        line.ask({ do: "preview", camera: { location, direction, right, up } });
    }, PREVIEW_REST);
}

/// Words beside the knobs.
function say() {
    const remarks = { ...model.remarks(), ...(model.error ? { [model.error.knob]: model.error.message } : {}) };
    for (const place of document.querySelectorAll("[data-said]"))
        place.textContent = remarks[place.dataset.said] ?? "";
    const known = [...document.querySelectorAll("[data-said]")].some(p => p.dataset.said === model.error?.knob);
    if (model.error && !known)
        document.querySelector("[data-said=points]").textContent = model.error.message;
    const radios = { mode: model.mode, form };
    for (const [name, value] of Object.entries(radios))
        document.querySelector(`input[name=${name}][value=${value}]`).checked = true;
    find("third-choice").hidden = model.mode !== "three";
    find("third").value = model.third;
    find("back").disabled = model.past.length < 2;
    find("hint").textContent = hint();
}

function hint() {
    if (model.mode === "one")
        return "Click what is to be sharp.";
    const wanted = model.third === "picked" ? 3 : model.third === "film" ? 1 : 2, missing = wanted - model.picks.length;
    if (missing > 0)
        return `Click ${missing === wanted ? wanted : missing + " more"} ${missing === 1 ? "place that is" : "places that are"} to be sharp.`;
    return "All of these are sharp. Drag a point, or click to move the nearest.";
}

// ---- text ----

function showText() {
    find("block").textContent = copyText(describe(model, form));
    find("write").disabled = find("copy").disabled = find("render").disabled = Boolean(model.error);
}

async function copy() {
    const text = find("block").textContent;
    try {
        await navigator.clipboard.writeText(text);
        find("file-said").textContent = "Copied. It belongs into the camera of your scene.";
    } catch {
        const range = document.createRange();
        range.selectNodeContents(find("block"));
        getSelection().removeAllRanges();
        getSelection().addRange(range);
        find("file-said").textContent = "The browser does not let this page copy. The text is marked: press Ctrl-C.";
    }
}

// ---- messages of the program ----

function takeScene(message) {
    const index = chosen !== null && chosen < message.cameras.length ? chosen : null;
    scene = { ...message, ownView: message.view, view: index === null ? message.view : message.cameras[index] };
    const { view } = scene;
    showLeftOut();
    find("name").textContent = message.name;
    document.title = `${message.name} – focus`;
    blur.gamma = message.gamma === null || message.gamma === "sRGB" ? 0 : message.gamma;
    knobs = buildKnobs(find("knobs"), model, message.lenses, () => model.remember());
    const cameras = find("camera");
    cameras.replaceChildren(...message.cameras.map((camera, i) => {
        const option = document.createElement("option");
        option.value = i;
        option.textContent = `line ${camera.line}${camera.own ? "" : ` of ${camera.file.split("/").at(-1)}`}`;
        option.disabled = !camera.perspective;
        return option;
    }));
    const same = camera => ["location", "direction", "right", "up"].every(key => String(camera[key]) === String(view[key]));
    cameras.value = index ?? message.cameras.findLastIndex(same);
    find("camera-choice").hidden = message.cameras.length < 2;
    find("clock-choice").hidden = !message.animated;
    // the same camera after a change elsewhere in the scene keeps the lens that is being chosen
    takeView(view);
    if (index !== null)
        askForCamera();
    if (!view.perspective)
        complain({ message: "This camera is not perspective. Only the perspective camera has a lens." });
}

/// Says what the scene's camera has that neither the live nor the true picture shows.
function showLeftOut() {
    const { bokeh, normal } = scene.view;
    const items = [bokeh && "bokeh picture", normal && "normal"].filter(Boolean).join(" and ");
    const text = `Neither this picture nor the true one shows the camera's ${items}; a render of your scene does.`;
    find("left-out").textContent = items && text;
}

/// Begins with a camera of the scene, unless the page shows it already, or has just written it.
function takeView(view) {
    const { file, line: place, offset, own, ...camera } = view, signature = JSON.stringify(camera);
    if (startedFor === signature)
        return;
    startedFor = signature;
    if (ownChange) {
        ownChange = false;
        model.note(view);
        return;
    }
    waitsForPreview = model.take(view);
    model.remember();
}

/// A preview of the camera that was chosen.
function askForCamera() {
    const { view } = scene, lens = view.block ? solve(view, view.block) : view;
    const { location } = view, { direction, right, up } = lens;
    line.ask({ do: "preview", camera: { location, direction, right, up }, chosen });
}

function takePreviewState(message) {
    complete = message.state === "done";
    if (message.state === "begun") {
        previewNumber = message.number;
        askedFrame = message.frame;
        blur.arriving = message.size;
        find("status").textContent = "Preview …";
        return;
    }
    find("status").textContent = "";
    draw();
    if (waitsForPreview && blur.values)
        supposeFocus();
    else if (model.lens && blur.lens)
        showSide();
}

/// Without a lens in the scene: focus on what the middle of the picture shows, or near it.
function supposeFocus() {
    waitsForPreview = false;
    for (const [x, y] of [[0, 0], [0, -0.15], [0, -0.3], [0.2, -0.2], [-0.2, -0.2], [0, -0.45], [0, 0.2]]) {
        const point = surfaceAt(x, y);
        if (point) {
            model.suppose(point);
            model.remember();
            return;
        }
    }
}

function takeTile(tile) {
    if (!scene || tile.number !== previewNumber)
        return;
    if (blur.arriving) {
        blur.begin(...blur.arriving);
        blur.arriving = null;
        blur.frame = frameOf(askedFrame);
        if (model.lens)
            changed();
    }
    blur.take(tile.left, tile.top, tile.width, tile.height, tile.values);
    draw();
}

function complain(error) {
    const place = find("message");
    place.hidden = !error?.message;
    if (place.hidden)
        return;
    complete = true; // nothing more comes
    find("status").textContent = "";
    place.replaceChildren();
    const where = error.file ? `${error.file}${error.line ? `, line ${error.line}` : ""}: ` : "";
    place.append(where + error.message);
    if (error.text) {
        const code = document.createElement("pre");
        code.textContent = error.text;
        place.append(code);
    }
}

function takeFile(message) {
    const words = {
        written: () => `Written. The scene as it was is kept as ${message.kept}.`,
        undone: () => "The scene is as it was before.",
        refused: () => `Not written: ${message.reason}. Copy the text and put it in by hand.`,
    };
    find("file-said").textContent = words[message.state]();
    if (message.state !== "refused") {
        ownChange = !message.again;
        find("undo").hidden = message.state !== "written";
    }
}

const takes = {
    scene: takeScene,
    preview: takePreviewState,
    error: complain,
    file: takeFile,
    picture: message => truth.take(message),
    progress: message => (find("status").textContent = message.share < 1 ? `Preview ${Math.floor(100 * message.share)} %` : ""),
    changed: message => (find("status").textContent = `${message.files.join(", ")} changed: new preview …`),
};

// ---- start ----

function surfaceAt(x, y) {
    const inverse = blur?.values && fits() ? blur.inverseDepthAt(x, y) : 0;
    return inverse > 0 ? pointAt(model.lens, x, y, 1 / inverse) : null;
}

const stage = buildStage(model, {
    pointAt: surfaceAt,
    moved: () => {},
    done: () => model.remember(),
    nothing: () => (find("hint").textContent = "There is nothing at this place to focus on. Click a thing."),
});
const truth = buildTruth(find, stage, () => ({ ...describe(model, "plane"), lens: model.lens, size: [blur.width, blur.height] }), message => line.ask(message));

function listen() {
    for (const name of ["blur", "peaking", "map", "planes"])
        find(`show-${name}`).onchange = event => {
            blur.show[name] = event.target.checked;
            find("legend").hidden = !blur.show.map;
            if (blur.values && blur.lens)
                blur.display();
            draw();
        };
    document.querySelectorAll("input[name=mode]").forEach(radio => (radio.onchange = () => model.setMode(radio.value)));
    document.querySelectorAll("input[name=form]").forEach(radio => (radio.onchange = () => {
        form = radio.value in FORMS ? radio.value : form;
        showText();
    }));
    find("third").onchange = event => model.setThird(event.target.value);
    find("back").onclick = () => model.back();
    find("copy").onclick = copy;
    find("write").onclick = () => line.ask({ do: "write", ...describe(model, form) });
    find("undo").onclick = () => line.ask({ do: "undo" });
    find("camera").onchange = event => {
        chosen = Number(event.target.value);
        scene = { ...scene, view: scene.cameras[chosen] };
        showLeftOut();
        takeView(scene.view);
        askForCamera();
    };
    find("clock").oninput = event => (find("clock-value").textContent = event.target.value);
    find("clock").onchange = event => line.ask({ do: "preview", clock: Number(event.target.value) });
    const dark = matchMedia("(prefers-color-scheme: dark)");
    const paint = () => {
        blur.empty = dark.matches ? [0.055, 0.06, 0.067] : [0.914, 0.914, 0.894];
        draw();
    };
    dark.onchange = paint;
    paint();
    new ResizeObserver(() => model.lens && blur.values && blur.lens && showSide()).observe(find("side"));
}

try {
    blur = openBlur(find("picture"));
    listen();
    line = connect({
        message: message => takes[message.type]?.(message),
        preview: takeTile,
        picture: tile => truth.takeTile(tile),
        open: () => (find("status").textContent = "Preview …"),
        closed: () => complain({ message: "The program has ended. Start ./focus again and open its new address." }),
    });
} catch (error) {
    complain({ message: error.message });
}

window.focusPage = blur && buildProbe(model, blur, () => complete);
