// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// After a break the connection is opened again, and the program sends everything.

const HEAD = 24; // kind, number, left, top, width, height
const FOR_GOOD = [1000, 1001, 1008]; // codes with which the program closes a connection for good
const AGAIN = 300; // milliseconds

export function connect(on) {
    let socket;
    const open = () => {
        let opened = false;
        socket = new WebSocket(new URL("socket", location.href.replace(/^http/, "ws")));
        socket.binaryType = "arraybuffer";
        socket.onopen = () => {
            opened = true;
            on.open();
        };
        socket.onclose = ({ code }) => (opened && !FOR_GOOD.includes(code) ? setTimeout(open, AGAIN) : on.closed());
        socket.onmessage = take;
    };
    const take = ({ data }) => {
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
    open();
    return { ask: message => socket.readyState === WebSocket.OPEN && socket.send(JSON.stringify(message)) };
}
