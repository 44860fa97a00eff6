// SPDX-License-Identifier: MIT
// Reads and writes the messages of the Foxglove WebSocket protocol, version 1. Pure functions without a connection.

export const SUBPROTOCOL = "foxglove.websocket.v1";

const MESSAGE_DATA = 1;
const TIME = 2;
const SERVICE_RESPONSE = 3;
const PLAYBACK_STATE = 5;
const SERVICE_REQUEST = 2; // sent by the client
const PLAYBACK_REQUEST = 3; // sent by the client
const MICROSECOND = 1000n; // ns

const text = new TextDecoder();

/// A time of a message in s.
export const seconds = ({ sec, nsec }) => sec + 1e-9 * nsec;

class BadMessage extends Error {}

function expect(holds, expected, found) {
  if (!holds) throw new BadMessage(`protocol: expected ${expected}, found ${found}`);
}

/// Parses a text message of the server. Throws an Error that names what was expected and what was found.
export function readText(data) {
  let message;
  try {
    message = JSON.parse(data);
  } catch {
    throw new BadMessage(`protocol: expected JSON, found "${String(data).slice(0, 40)}"`);
  }
  expect(
    message !== null && typeof message === "object" && typeof message.op === "string",
    "a field op",
    JSON.stringify(message).slice(0, 60),
  );
  return message;
}

/// Parses a binary message of the server. Times are microseconds. The payload is a view of `buffer`.
export function readBinary(buffer) {
  expect(buffer.byteLength > 0, "an operation code", "an empty message");
  const view = new DataView(buffer);
  const code = view.getUint8(0);
  if (code === MESSAGE_DATA) {
    expect(buffer.byteLength >= 13, "message data of at least 13 bytes", buffer.byteLength);
    return {
      op: "messageData",
      subscription: view.getUint32(1, true),
      time: Number(view.getBigUint64(5, true) / MICROSECOND),
      payload: new Uint8Array(buffer, 13),
    };
  }
  if (code === TIME) {
    expect(buffer.byteLength >= 9, "a time of 9 bytes", buffer.byteLength);
    return { op: "time", time: Number(view.getBigUint64(1, true) / MICROSECOND) };
  }
  if (code === SERVICE_RESPONSE) {
    expect(buffer.byteLength >= 13, "a service response of at least 13 bytes", buffer.byteLength);
    const length = view.getUint32(9, true);
    expect(13 + length <= buffer.byteLength, `an encoding of ${length} bytes`, `${buffer.byteLength - 13} bytes`);
    return {
      op: "serviceResponse",
      service: view.getUint32(1, true),
      call: view.getUint32(5, true),
      encoding: text.decode(new Uint8Array(buffer, 13, length)),
      payload: new Uint8Array(buffer, 13 + length),
    };
  }
  if (code === PLAYBACK_STATE) {
    expect(buffer.byteLength >= 19, "a state of the playback of at least 19 bytes", buffer.byteLength);
    return {
      op: "playbackState",
      status: view.getUint8(1),
      time: Number(view.getBigUint64(2, true) / MICROSECOND) * 1e-6,
      speed: view.getFloat32(10, true),
      didSeek: view.getUint8(14) !== 0,
    };
  }
  return { op: "unknown", code };
}

/// A service request with a JSON value.
export function serviceRequest(service, call, value) {
  const encoding = new TextEncoder().encode("json");
  const payload = new TextEncoder().encode(JSON.stringify(value));
  const bytes = new Uint8Array(13 + encoding.length + payload.length);
  const view = new DataView(bytes.buffer);
  view.setUint8(0, SERVICE_REQUEST);
  view.setUint32(1, service, true);
  view.setUint32(5, call, true);
  view.setUint32(9, encoding.length, true);
  bytes.set(encoding, 13);
  bytes.set(payload, 13 + encoding.length);
  return bytes;
}

/// A request of a replay. pauses: true, or false to play; speed: times real time; seek: s, or undefined.
export function playbackRequest({ pauses, speed, seek }) {
  const bytes = new Uint8Array(19);
  const view = new DataView(bytes.buffer);
  view.setUint8(0, PLAYBACK_REQUEST);
  view.setUint8(1, pauses ? 1 : 0);
  view.setFloat32(2, speed, true);
  view.setUint8(6, seek === undefined ? 0 : 1);
  view.setBigUint64(7, BigInt(Math.round(Math.max(0, seek ?? 0) * 1e9)), true);
  view.setUint32(15, 0, true); // an empty id
  return bytes;
}

/// Decodes the JSON of a payload. Throws an Error if it is not JSON.
export function readJson(payload) {
  return JSON.parse(text.decode(payload));
}
