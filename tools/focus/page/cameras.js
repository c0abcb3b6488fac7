// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The page's head: the scene's name, the shown camera, and the clock.

const CLOCK_STEPS = 100;

const nameOf = ({ line, own, file }) => `line ${line}${own ? "" : ` of ${file.split("/").at(-1)}`}`;

/// @param on  { camera(index): another camera was chosen, clock(value) }
export function buildCameras(find, on) {
    const choice = find("camera"), clock = find("clock"), clockValue = find("clock-value");
    let cameras = [];
    choice.onchange = () => on.camera(Number(choice.value));
    const showClock = () => (clockValue.textContent = Number(Number(clock.value).toPrecision(6)));
    clock.oninput = showClock;
    clock.onchange = () => on.clock(Number(clock.value));

    return {
        /// Shows a scene. @param index  of the shown camera, or null
        show({ name, cameras: all, animated, clock: now, clocks: [least, most] }, index) {
            cameras = all;
            find("name").textContent = name;
            document.title = `${name} – focus`;
            choice.replaceChildren(...cameras.map((camera, i) => {
                const option = document.createElement("option");
                option.value = i;
                option.textContent = nameOf(camera);
                option.disabled = !camera.perspective;
                return option;
            }));
            choice.value = index ?? "";
            find("camera-choice").hidden = cameras.length < 2;
            find("clock-choice").hidden = !animated || least === most;
            Object.assign(clock, { min: least, max: most, step: (most - least) / CLOCK_STEPS || 1, value: now ?? least });
            showClock();
        },
        /// Items of the shown camera's block that the page does not write, as text.
        kept: () => cameras[Number(choice.value)]?.kept ?? [],
    };
}
