// SPDX-License-Identifier: MIT
// The reader of the protocol, with the messages of the specification and with damaged ones.
import assert from "node:assert/strict";
import { test } from "node:test";

import {
  playbackRequest,
  readBinary,
  readJson,
  readText,
  serviceRequest,
} from "../../../workbench/views/live/page/source/protocol.js";

/// Bytes of little-endian numbers: [bits, value].
function bytes(...fields) {
  const buffer = new ArrayBuffer(fields.reduce((sum, [bits]) => sum + bits / 8, 0));
  const view = new DataView(buffer);
  let at = 0;
  for (const [bits, value] of fields) {
    if (bits === 64) view.setBigUint64(at, value, true);
    else view[`setUint${bits}`](at, value, true);
    at += bits / 8;
  }
  return buffer;
}

test("message data has subscription, time in microseconds and payload", () => {
  const message = readBinary(bytes([8, 1], [32, 7], [64, 43_400_000_123n], [8, 123], [8, 125]));
  assert.equal(message.op, "messageData");
  assert.equal(message.subscription, 7);
  assert.equal(message.time, 43_400_000);
  assert.deepEqual(readJson(message.payload), {});
});

test("a time after 292 years does not overflow", () => {
  assert.equal(readBinary(bytes([8, 2], [64, 2n ** 63n])).time, Number(2n ** 63n / 1000n));
});

test("a service response has the call and its JSON", () => {
  const message = readBinary(bytes([8, 3], [32, 1], [32, 9], [32, 1], [8, 106], [8, 49]));
  assert.deepEqual([message.op, message.service, message.call, message.encoding], ["serviceResponse", 1, 9, "j"]);
  assert.equal(readJson(message.payload), 1);
});

test("a state of the playback has status, time, speed and whether it follows a seek", () => {
  const half = 0x3f000000; // 0.5 as a float
  const state = bytes([8, 5], [8, 1], [64, 43_400_000_000n], [32, half], [8, 1], [32, 0]);
  assert.deepEqual(readBinary(state), { op: "playbackState", status: 1, time: 43.4, speed: 0.5, didSeek: true });
  assert.throws(() => readBinary(state.slice(0, 18)), /expected a state of the playback of at least 19 bytes, found 18/);
});

test("a request of a replay is what the specification says", () => {
  const half = 0x3f000000;
  const of = (values) => playbackRequest(values).buffer;
  assert.deepEqual(of({ pauses: true, speed: 0.5 }), bytes([8, 3], [8, 1], [32, half], [8, 0], [64, 0n], [32, 0]));
  const seek = bytes([8, 3], [8, 0], [32, half], [8, 1], [64, 12_500_000_000n], [32, 0]);
  assert.deepEqual(of({ pauses: false, speed: 0.5, seek: 12.5 }), seek);
});

test("a service request is what the specification says", () => {
  const request = serviceRequest(3, 5, { text: "ä" });
  const view = new DataView(request.buffer);
  assert.deepEqual(
    [view.getUint8(0), view.getUint32(1, true), view.getUint32(5, true), view.getUint32(9, true)],
    [2, 3, 5, 4],
  );
  assert.equal(new TextDecoder().decode(request.subarray(13)), 'json{"text":"ä"}');
});

test("an unknown operation code is no error", () => {
  assert.deepEqual(readBinary(bytes([8, 200])), { op: "unknown", code: 200 });
});

test("truncated binary messages are errors that name what was expected", () => {
  assert.throws(() => readBinary(new ArrayBuffer(0)), /expected an operation code, found an empty message/);
  for (const code of [1, 3])
    assert.throws(() => readBinary(bytes([8, code], [64, 0n])), /of at least 13 bytes, found 9/);
  assert.throws(() => readBinary(bytes([8, 2], [32, 0])), /expected a time of 9 bytes, found 5/);
  assert.throws(
    () => readBinary(bytes([8, 3], [32, 0], [32, 0], [32, 4_000_000_000])),
    /encoding of 4000000000 bytes, found 0 bytes/,
  );
});

test("texts that are no messages are errors that name what was expected", () => {
  for (const text of ["", "{", "NaN", "\u0000"]) assert.throws(() => readText(text), /protocol: expected JSON, found/);
  for (const text of ["null", "3", "[]", "{}", '{"op":1}'])
    assert.throws(() => readText(text), /protocol: expected a field op, found/);
  assert.equal(readText('{"op":"status"}').op, "status");
});
