// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The line to the program that serves this page.

const HEAD = 24; // bytes before the values of a tile: what it belongs to, number, left, top, width, height

/// @param on  { message(object), preview(tile), picture(tile), open(), closed() }
export function connect(on) {
    const socket = new WebSocket(new URL("socket", location.href.replace(/^http/, "ws")));
    socket.binaryType = "arraybuffer";
    socket.onopen = () => on.open();
    socket.onclose = () => on.closed();
    socket.onmessage = ({ data }) => {
        if (typeof data === "string") {
            on.message(JSON.parse(data));
            return;
        }
        const [kind, number, left, top, width, height] = new Uint32Array(data, 0, HEAD / 4);
        const tile = { number, left, top, width, height };
        if (kind === 1)
            on.preview({ ...tile, values: new Float32Array(data, HEAD) });
        else
            on.picture({ ...tile, values: new Uint8ClampedArray(data, HEAD) });
    };
    return { ask: message => socket.readyState === WebSocket.OPEN && socket.send(JSON.stringify(message)) };
}
