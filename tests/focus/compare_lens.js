// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Compares the page's lens with cases of lens_cases.cpp.

function compareSharpPoints(lensModule, given, block, lens, number, note) {
    const { width } = given, points = block.sharpPoints, off = (found, wanted) => Math.abs(found - wanted) / wanted;
    points.forEach((point, i) => note("pixels", Math.abs(lensModule.blurOfPoint(lens, point, width) - given.sharpBlurs[i]), `sharp point of case ${number}`));
    const greatest = lensModule.greatestBlur(lens, points, width);
    if (!(greatest > 1e-3))
        return;
    note("relative", off(lensModule.widestStop(given, block, 1, width), given.stopWithinPixel), `widest stop of case ${number}`);
    const without = lensModule.stopWithoutTilt(given, block, lens, points, width), stop = lens.focalLength / lens.diameter;
    if ((without === null) !== (given.blurWithoutTilt === null))
        note("relative", 1, `lens without tilt of case ${number}`);
    else if (without !== null)
        note("relative", off(without * greatest / stop, given.blurWithoutTilt), `blur without tilt of case ${number}`);
}

/// @returns the largest differences (blur: pixels; others: relative), and their place
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
            near: lensModule.planeOfBlur(lens, 1, given.width),
        };
        if (block.family === "sharp")
            compareSharpPoints(lensModule, given, block, lens, number, note);
        for (const [name, values] of Object.entries(numbers)) {
            const wanted = [given[name]].flat(), size = Math.hypot(...wanted) || 1;
            values.forEach((value, i) => note("relative", Math.abs(value - wanted[i]) / size, `${name} of case ${number}`));
        }
        // a plane may nearly miss the axis
        const axisOff = 1 / lensModule.axisFocusOf(lens) - (given.axisFocus === null ? 0 : 1 / given.axisFocus);
        note("relative", Math.abs(axisOff) / Math.hypot(...lens.focus), `axisFocus of case ${number}`);
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
