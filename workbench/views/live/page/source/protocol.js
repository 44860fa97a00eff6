// SPDX-License-Identifier: MIT
// Reads and writes the messages of the Foxglove WebSocket protocol, version 1. Pure functions without a connection.

export const SUBPROTOCOL = "foxglove.websocket.v1";

const MESSAGE_DATA = 1;
const TIME = 2;
const SERVICE_RESPONSE = 3;
const SERVICE_REQUEST = 2; // sent by the client
const MICROSECOND = 1000n; // ns

const text = new TextDecoder();

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

/// Decodes the JSON of a payload. Throws an Error if it is not JSON.
export function readJson(payload) {
  return JSON.parse(text.decode(payload));
}
