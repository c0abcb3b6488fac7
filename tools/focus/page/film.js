// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { copyText, describePull, threePoints } from "./block.js";
import { MOST_KEYS, pullAt, withKey } from "./pull.js";
import { WORDS, copy } from "./text.js";

const SECONDS = 4; // from the first key to the last

const short = value => String(Number(value.toPrecision(4)));

export function buildFilm(find, model, clock, kept, ask, done) {
    const list = find("keys"), said = find("pull-said"), text = find("pull-text");
    let keys = [], before = null, copied = ""; // `before`: restored at the film's end

    const at = time => model.pull(pullAt(keys, time, model.camera.location));
    const change = next => {
        keys = next;
        said.textContent = "";
        showKeys();
        done();
    };

    const button = (words, label, onclick) => Object.assign(document.createElement("button"), { type: "button", textContent: words, ariaLabel: label, onclick });
    const newRow = key => {
        const row = document.createElement("li"), words = `clock ${short(key.time)}: f/${short(key.stop)}`;
        const go = () => {
            clock.setTime(key.time);
            at(key.time);
            model.remember();
        };
        row.append(button(words, `Show the lens of ${words}`, go), button("×", `Remove ${words}`, () => change(keys.filter(other => other !== key))));
        return row;
    };
    const showKeys = () => {
        list.replaceChildren(...keys.map(newRow));
        find("pull-part").hidden = keys.length < 2;
        show();
    };
    const show = () => {
        find("mark").textContent = `Mark this lens at clock ${short(clock.time())}`;
        find("mark").disabled = Boolean(model.error || before);
        find("play").textContent = before ? "Stop" : "Play";
        find("pull-copy").disabled = find("pull-write").disabled = Boolean(model.error);
        if (keys.length < 2 || before || !model.lens || !find("pull").open)
            return;
        const { head, ...parts } = describePull(model, keys);
        text.textContent = `// before the camera\n${head}\n// in the camera\n${copyText(parts, kept())}`;
    };

    find("mark").onclick = () => {
        if (keys.length === MOST_KEYS && !keys.some(key => key.time === clock.time()))
            said.textContent = `${MOST_KEYS} marks are the most. Remove one.`;
        else
            change(withKey(keys, { time: clock.time(), stop: model.block.fStop, points: threePoints(model).map(point => [...point]) }));
    };
    find("pull").ontoggle = show;

    const stop = () => {
        const { state, time } = before;
        before = null;
        clock.setTime(time);
        model.restore(state);
    };
    const step = begun => {
        if (!before)
            return;
        const part = Math.min(1, (performance.now() - begun) / (1000 * SECONDS)), [first, last] = [keys[0].time, keys.at(-1).time];
        clock.setTime(first + part * (last - first));
        at(clock.time());
        // the last frame is shown, however slow the machine
        requestAnimationFrame(() => (part < 1 ? step(begun) : before && stop()));
    };
    find("play").onclick = () => {
        if (before) {
            stop();
            return;
        }
        before = { state: structuredClone(model.state), time: clock.time() };
        step(performance.now());
    };

    const request = write => {
        const { head, block, items, checks } = describePull(model, keys);
        return { do: "pull", write, head, block, items, checks };
    };
    find("pull-copy").onclick = async () => {
        copied = await copy(text);
        said.textContent = `${copied} Trying it in the scene …`;
        ask(request(false));
    };
    find("pull-write").onclick = () => {
        copied = "";
        said.textContent = "Trying it in the scene …";
        ask(request(true));
    };

    return {
        show,
        moved(time) {
            if (keys.length >= 2 && !before)
                at(time);
            else
                show();
        },
        take(message) {
            said.textContent = `${copied} ${WORDS[message.state](message)}`.trim();
        },
        get keys() {
            return keys;
        },
        set keys(next) {
            keys = next;
            find("pull").open ||= keys.length > 0;
            showKeys();
        },
    };
}
