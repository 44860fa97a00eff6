// SPDX-License-Identifier: MIT
// replayed_by_ws_protocol.mjs LINK: plays, pauses and seeks a replay with Foxglove's own client, under both names of the
// protocol. The package (0.8.0) is older than playbackControl: it has no method that sends the request, and reports the
// answer as an unknown opcode. So these two messages are written and read on the client's own socket.
import protocol from "@foxglove/ws-protocol";
import WebSocket from "ws";

const { FoxgloveClient } = protocol;
const link = process.argv[2].replace(/^http/, "ws");
const CONTROL = 3; // opcode of the client
const STATE = 5; // opcode of the server
const [PLAYING, PAUSED, , ENDED] = [0, 1, 2, 3];
const NEAR = 0.1; // s, more than a frame
const require = (holds, what) => {
  if (holds) return;
  console.error(what);
  process.exit(1);
};
const seconds = ({ sec, nsec }) => sec + 1e-9 * nsec;
const isNear = (time, wanted) => Math.abs(time - wanted) < NEAR;

/// The request: `seek` in s, or null.
function control({ pauses, speed, seek = null }, id) {
  const text = new TextEncoder().encode(id);
  const bytes = new Uint8Array(19 + text.length);
  const view = new DataView(bytes.buffer);
  view.setUint8(0, CONTROL);
  view.setUint8(1, pauses ? 1 : 0);
  view.setFloat32(2, speed, true);
  view.setUint8(6, seek === null ? 0 : 1);
  view.setBigUint64(7, BigInt(Math.round(1e9 * (seek ?? 0))), true);
  view.setUint32(15, text.length, true);
  bytes.set(text, 19);
  return bytes;
}

/// The answer: {status, time, speed, didSeek, id}, or null for another message.
function stateOf(data) {
  if (!(data instanceof ArrayBuffer)) return null;
  const view = new DataView(data);
  if (view.getUint8(0) !== STATE) return null;
  return {
    status: view.getUint8(1),
    time: 1e-9 * Number(view.getBigUint64(2, true)),
    speed: view.getFloat32(10, true),
    didSeek: view.getUint8(14) === 1,
    id: new TextDecoder().decode(new Uint8Array(data, 19, view.getUint32(15, true))),
  };
}

async function replay(subprotocol) {
  const socket = new WebSocket(link, [subprotocol]);
  const client = new FoxgloveClient({ ws: socket });
  client.on("error", (error) => require(/opcode in binary message: 5$/.test(error.message), `${subprotocol}: ${error}`));
  client.on("status", ({ level, message }) => require(level === 0, `${subprotocol}: ${message}`));
  const next = (event) => new Promise((resolve) => client.on(event, resolve));
  const [info, channels] = await Promise.all([next("serverInfo"), next("advertise")]);
  require(info.capabilities.includes("playbackControl"), `capabilities: ${info.capabilities}`);
  const [begin, end] = [seconds(info.dataStartTime), seconds(info.dataEndTime)];
  require(begin >= 0 && end > begin + 6, `data from ${begin} s to ${end} s`);

  const received = []; // {time} of messages, {state}, in the order in which they arrived
  let wake = () => {};
  const take = (one) => {
    received.push(one);
    wake();
  };
  client.on("message", ({ timestamp }) => take({ time: 1e-9 * Number(timestamp) }));
  socket.addEventListener("message", ({ data }) => {
    const state = stateOf(data);
    if (state) take({ state });
  });
  client.subscribe(channels.find(({ topic }) => topic === "/world").id);
  /// Waits for something that arrives from `from` on.
  const await_ = async (matches, from = 0) => {
    for (let i = from; ; ++i) {
      while (i >= received.length) await new Promise((resolve) => (wake = resolve));
      if (matches(received[i])) return received[i];
    }
  };
  let requests = 0;
  /// Sends a request. Returns its answer, and where it was sent in `received`.
  const request = async (what) => {
    const id = `${subprotocol} ${++requests}`;
    const from = received.length;
    socket.send(control(what, id));
    const { state } = await await_((one) => one.state?.id === id, from);
    require(Math.abs(state.speed - what.speed) < 1e-6, `speed ${what.speed}: found ${state.speed}`);
    require(state.didSeek === (what.seek !== undefined), `${id}: did seek ${state.didSeek}`);
    return { state, from };
  };
  /// Seeks in a paused replay: the answer and a message have this time.
  const seek = async (time) => {
    const { state, from } = await request({ pauses: true, speed: 1, seek: time });
    require(state.status === PAUSED && isNear(state.time, time), `seek to ${time} s: status ${state.status}, ${state.time} s`);
    await await_((one) => one.time !== undefined && isNear(one.time, time), from);
  };

  const [early, late] = [begin + 2, end - 2];
  await seek(late); // the replay may have ended
  await seek(early);
  await seek(early + 1);
  const { state, from } = await request({ pauses: false, speed: 2, seek: early });
  require(state.status === PLAYING && isNear(state.time, early), `play: status ${state.status}, ${state.time} s`);
  await await_((one) => one.time > early + 1 + NEAR && one.time < late, from);
  require((await request({ pauses: false, speed: 0.5 })).state.status === PLAYING, "a change of the speed stops the replay");
  require((await request({ pauses: true, speed: 1 })).state.status === PAUSED, "the replay is not paused");
  const last = await request({ pauses: false, speed: 20, seek: late });
  await await_((one) => one.state?.status === ENDED && one.state.id === "", last.from);
  await await_((one) => one.time !== undefined && isNear(one.time, end), last.from);
  client.close();
}

await replay("foxglove.websocket.v1");
await replay("foxglove.sdk.v1");
process.exit(0);
