// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

import { wholeTurnOf } from "./lens.js";

const USUAL_TURN = 15; // degrees; real lenses stop at about 10

/// Limits of the real lens and unusual values: knob -> words.
export function remarksOf({ real, block, lens, refused }) {
    const said = { ...refused };
    if (!lens)
        return said;
    const turn = wholeTurnOf(lens), shift = Math.hypot(...block.shift);
    if (real && turn > real.tilt + 1e-6)
        said.turn ??= `This needs ${turn.toFixed(1)}°. The real lens tilts up to ${real.tilt}°.`;
    else if (turn > USUAL_TURN)
        said.turn ??= `${turn.toFixed(1)}° is much; real lenses stop at about 10°.`;
    if (real && shift > real.shift + 1e-6)
        said.shift ??= `${shift.toFixed(1)} mm. The real lens shifts up to ${real.shift} mm.`;
    if (real && block.fStop < real.fStop - 1e-6)
        said.fStop ??= `The real lens opens to f/${real.fStop} only.`;
    return said;
}
