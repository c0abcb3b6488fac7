// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

const CLOCK_STEPS = 100;

const nameOf = ({ line, own, file }) => `line ${line}${own ? "" : ` of ${file.split("/").at(-1)}`}`;

/// @param on { camera(index), clock(value), moved(value): the clock moves }
export function buildCameras(find, on) {
    const choice = find("camera"), clock = find("clock"), clocks = [clock, find("time")];
    let cameras = [];
    choice.onchange = () => on.camera(Number(choice.value));
    const time = () => Number(Number(clock.value).toPrecision(6));
    const setTime = value => {
        for (const slider of clocks) {
            slider.value = value;
            find(`${slider.id}-value`).textContent = time();
        }
    };
    for (const slider of clocks) {
        slider.oninput = () => {
            setTime(slider.value);
            on.moved(time());
        };
        slider.onchange = () => on.clock(time());
    }

    return {
        time,
        setTime,
        show({ name, cameras: all, animated, clock: now, clocks: [least, most] }, index) {
            this.animated = animated;
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
            for (const slider of clocks)
                Object.assign(slider, { min: least, max: most, step: (most - least) / CLOCK_STEPS || 1 });
            setTime(animated || now !== null ? now ?? least : clock.value);
        },
        kept: () => cameras[Number(choice.value)]?.kept ?? [],
    };
}
