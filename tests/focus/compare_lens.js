// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Compares the page's lens with cases of the library (lens_cases.cpp). The test runs it in the browser.

/// @param lensModule  the page's lens.js
/// @returns the largest differences, of blur in pixels and of other numbers relative to their size, and their place
export function compareLenses(lensModule, cases) {
    const worst = { pixels: 0, relative: 0, where: "" };
    const note = (kind, value, where) => {
        if (!(value <= worst[kind])) {
            worst[kind] = value;
            worst.where += `${kind} ${value} ${where}; `;
        }
    };
    cases.forEach((given, number) => {
        const block = { ...given.block, points: [given.block.A, given.block.B, given.block.C] };
        const lens = lensModule.solve(given, block), turn = lensModule.turnOf(lens);
        const numbers = {
            tilt: [turn.tilt], swing: [turn.swing], focalLength: [lens.focalLength], filmDistance: [lens.filmDistance],
            diameter: [lens.diameter], hinge: [lensModule.hingeDistanceOf(lens)], lensX: lens.lensX, lensY: lens.lensY,
            axisFocus: [lensModule.axisFocusOf(lens)], near: lensModule.planeOfBlur(lens, 1, given.width),
        };
        for (const [name, values] of Object.entries(numbers)) {
            const wanted = [given[name]].flat(), size = Math.hypot(...wanted) || 1;
            values.forEach((value, i) => note("relative", Math.abs(value - wanted[i]) / size, `${name} of case ${number}`));
        }
        for (const [x, y, T, blur, depth] of given.blur) {
            const chief = lensModule.chiefRay(lens, x, y), point = lensModule.pointAt(lens, x, y, depth);
            note("pixels", Math.abs(lensModule.blurDiameter(lens, chief, T, given.width) - blur), `case ${number}`);
            note("pixels", Math.abs(lensModule.blurOfPoint(lens, point, given.width) - blur), `point of case ${number}`);
            const back = lensModule.project(lens, point);
            note("pixels", given.width * Math.hypot(back.x - x, back.y - y), `projection of case ${number}`);
        }
    });
    return worst;
}
