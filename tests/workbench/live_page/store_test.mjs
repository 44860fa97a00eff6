// SPDX-License-Identifier: MIT
// The store of received frames: instants, memory, events, and messages that are damaged or out of order.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Store, eventOf, missingOf } from "../../../workbench/views/live/page/source/store.js";

const encode = (value) => new TextEncoder().encode(JSON.stringify(value));
const STEP = 33_333; // microseconds

function world(evidence, status = "usable") {
  return {
    pose: { x: 1, y: 2, rotation: 0, known: true },
    confidence: { evidence, current: 0.9, opposite: 0.1, status },
    robot: { head_yaw: 0 },
  };
}

function image(time, bytes = 300) {
  const microseconds = Math.round(time);
  const timestamp = { sec: Math.floor(microseconds / 1e6), nsec: (microseconds % 1e6) * 1000 };
  return { timestamp, frame_id: "camera_upper", data: Buffer.alloc(bytes, 7).toString("base64"), format: "jpeg" };
}

/// A store with `count` frames.
function filled(
  count,
  {
    budget,
    bytes,
    store = new Store(
      () => {},
      () => {},
      budget,
    ),
  } = {},
) {
  for (let i = 0; i < count; ++i) {
    store.receive("/world", i * STEP, encode(world(i)));
    store.receive("/camera/upper/image", i * STEP, encode(image(i * STEP, bytes)));
  }
  return store;
}

const images = (store) => store.frames.filter((frame) => frame.parts["/camera/upper/image"]);

test("messages of one time are one frame", () => {
  const store = filled(3);
  assert.equal(store.frames.length, 3);
  assert.deepEqual(Object.keys(store.frames[1].parts), ["/world", "/camera/upper/image"]);
  assert.equal(store.frames[1].evidence, 1);
  assert.equal(store.frames[1].parts["/camera/upper/image"].bytes.length, 300);
});

test("machines of the scenario are known by name until another run begins", () => {
  const store = filled(1);
  const machine = (name, scenario) => ({ name, state: "a", seconds: 1, stopped: false, errors: 0, scenario });
  store.receive("/machines", 0, encode({ machines: [machine("orientation", false), machine("patrol", true)] }));
  assert.deepEqual([...store.scenario], ["patrol"]);
  assert.equal(store.bands.get("patrol").at(-1).value, "a");
  store.clear();
  assert.equal(store.scenario.size, 0);
});

test("thresholds of the evidence are those that the robot sent, and missing if they are no numbers", () => {
  const store = filled(1);
  assert.equal(store.limits, null);
  store.receive("/decision", 0, encode({ confirmed: 9.4, unconfirmed: 5.5 }));
  assert.deepEqual(store.limits, { confirmed: 9.4, unconfirmed: 5.5 });
  for (const bad of [{}, null, 3, { confirmed: 9.4 }, { confirmed: "9", unconfirmed: 5 }]) {
    store.receive("/decision", 0, encode(bad));
    assert.equal(store.limits, null);
  }
});

test("the live view shows the last complete frame", () => {
  const store = filled(3);
  assert.equal(store.shown().evidence, 1);
});

test("a shown instant stays while frames arrive", () => {
  const store = filled(30);
  store.show(0.5);
  const time = store.shown().time;
  assert.ok(time <= 0.5 && time > 0.46);
  filled(60, { store });
  assert.equal(store.shown().time, time);
  store.step(1);
  assert.ok(store.shown().time > time);
  store.show(null);
  assert.ok(store.isLive);
});

test("a held view is the last complete frame, and does not change when messages follow", () => {
  const store = filled(3);
  store.receive("/camera/upper/image", 3 * STEP, encode(image(3 * STEP))); // the world of this frame follows
  store.toggleHold();
  const held = store.shown();
  assert.equal(held.evidence, 2);
  store.hold();
  store.receive("/world", 3 * STEP, encode(world(3)));
  assert.equal(store.read("/world").value.confidence.evidence, 2);
  assert.equal(store.shown(), held);
  store.toggleHold();
  assert.ok(store.isLive);
});

test("a view without frames cannot be held", () => {
  const store = new Store();
  store.toggleHold();
  assert.ok(store.isLive);
});

test("an instant outside of the stored time is the nearest stored frame", () => {
  const store = filled(30);
  store.show(-5);
  assert.equal(store.shown().time, 0);
  store.show(1e9);
  assert.equal(store.shown().time, store.newest);
  store.step(1000);
  assert.equal(store.shown().time, store.newest);
});

test("an instant of an empty store is live", () => {
  const store = new Store();
  store.show(3);
  store.step(-1);
  assert.ok(store.isLive);
  assert.equal(store.shown(), undefined);
  assert.equal(store.read("/world"), null);
});

test("late messages find their frame", () => {
  const store = filled(30);
  store.receive("/percepts", 3 * STEP, encode({ entities: [] }));
  store.receive("/percepts", 3 * STEP + 1, encode({ entities: [] }));
  assert.equal(store.frames.length, 31);
  assert.ok(store.frames[3].parts["/percepts"]);
  assert.deepEqual(
    store.frames.map((frame) => frame.time),
    store.frames.map((frame) => frame.time).sort((a, b) => a - b),
  );
});

test("frames older than 10 minutes are dropped", () => {
  const store = new Store();
  for (let second = 0; second <= 700; ++second) {
    store.receive("/world", second * 1e6, encode(world(0, second < 50 ? "unlearned" : "usable")));
    store.receive(
      "/events",
      second * 1e6,
      encode({ machine: "a", state: "b > c", command: "", verdict: "", reason: "" }),
    );
  }
  assert.equal(store.frames[0].time, 100);
  assert.equal(store.events[0].time, 100);
  assert.deepEqual(
    store.bands.get("status").map((entry) => entry.value),
    ["usable"],
  );
});

test("memory: images are thinned first, then dropped, and numbers stay", () => {
  const budget = 3e6;
  const store = filled(900, { budget, bytes: 5000 });
  assert.ok(store.size <= budget, `${store.size}`);
  assert.equal(store.frames.length, 900);
  const kept = images(store);
  assert.ok(kept.length > 300 - 1, `${kept.length} images`); // the newest 10 s are complete
  assert.ok(store.frames[5].thinned);
  const large = filled(3000, { budget: 2 * budget, bytes: 5000 });
  assert.ok(large.size <= 2 * budget, `${large.size}`);
  assert.equal(large.frames.length, 3000);
  assert.ok(large.frames.every((frame) => frame.evidence !== undefined));
});

test("the text of a frame names what it lacks, and why", () => {
  const store = filled(900, { budget: 2.5e6, bytes: 5000 });
  assert.equal(missingOf(store.frames[5]), "no image, no detections of this frame (dropped to save memory)");
  assert.equal(missingOf(store.frames.at(-1)), "no detections of this frame (not received)");
  store.receive("/percepts", 899 * STEP, encode({ entities: [] }));
  assert.equal(missingOf(store.frames.at(-1)), "");
  assert.equal(missingOf(undefined), "");
});

test("memory: without images left to drop, the oldest frames go", () => {
  const store = new Store(
    () => {},
    () => {},
    100_000,
  );
  for (let i = 0; i < 1000; ++i) store.receive("/world", i * STEP, encode({ ...world(i), filling: "x".repeat(1000) }));
  assert.ok(store.size <= 100_000, `${store.size}`);
  assert.ok(store.frames.length > 40 && store.frames.length < 100, `${store.frames.length}`);
  assert.equal(store.frames.at(-1).evidence, 999);
});

test("memory: the counted size is that of the stored parts", () => {
  const store = filled(400, { budget: 1e6, bytes: 5000 });
  store.receive("/world", 399 * STEP, encode(world(1))); // replaces a part
  let size = 0;
  for (const frame of store.frames) {
    size += 400;
    for (const part of Object.values(frame.parts)) size += 200 + (part.bytes ?? part).byteLength;
  }
  assert.equal(store.size, size);
});

test("a message that cannot be read is counted and named, and the next one is read", () => {
  const store = filled(2);
  store.receive("/world", 9 * STEP, new Uint8Array([0xff, 0x7b]));
  store.receive("/log", 9 * STEP, encode(null).subarray(0, 2));
  store.receive("/camera/upper/image", 9 * STEP, encode({ data: "%%%" }));
  assert.equal(store.bad, 3);
  assert.match(store.badText, /^\/camera\/upper\/image: /);
  filled(12, { store });
  assert.equal(store.frames.at(-1).evidence, 11);
});

test("another run, whose time begins again, replaces the frames", () => {
  const store = new Store();
  store.receive("/world", 2000e6, encode(world(1)));
  store.receive("/world", 1e6, encode(world(2)));
  assert.deepEqual(
    store.frames.map((frame) => frame.time),
    [1],
  );
});

test("a replay that continues at an earlier time replaces the frames after it, and keeps those before", () => {
  const store = new Store();
  store.isReplay = true;
  const event = { machine: "a", state: "b > c", command: "", verdict: "", reason: "" };
  const play = (from, to) => {
    for (let time = from; time <= to; ++time) {
      store.receive("/world", time * 1e6, encode(world(0, time < 7 ? "unlearned" : "usable")));
      store.receive("/events", time * 1e6, encode(event));
      store.receive("/log", time * 1e6, encode({ level: 2, name: "n", message: "m" }));
    }
  };
  store.receive("/field", 0, encode({ entities: [] }));
  play(1, 9);
  store.show(8);
  play(5, 6);
  const times = (list) => list.map((it) => it.time);
  for (const list of [store.frames, store.events, store.log]) assert.deepEqual(times(list), [1, 2, 3, 4, 5, 6]);
  const states = () => store.bands.get("status").map((it) => it.value);
  assert.deepEqual(states(), ["unlearned"]);
  assert.equal(store.instant, 5);
  assert.ok(store.lasting.has("/field"));
  play(9, 9);
  assert.deepEqual(times(store.frames).at(-1), 9);
  assert.deepEqual(states(), ["unlearned", "", "usable"], "not known between 6 and 9 s");
  store.isReplay = false;
  play(8, 8);
  assert.equal(store.frames.length, 8, "a late message of a run");
});

test("events are transitions, commands, notes or of the game", () => {
  const of = (fields) => eventOf(1, { machine: "m", state: "", command: "", verdict: "", reason: "r", ...fields });
  assert.deepEqual(of({ state: "a/b > c" }), {
    time: 1,
    kind: "transition",
    machine: "m",
    from: "a/b",
    to: "c",
    reason: "r",
  });
  assert.equal(of({ state: "> c" }).from, "");
  assert.equal(of({ command: "flip_pose", verdict: "granted" }).granted, true);
  assert.equal(of({ command: "flip_pose", verdict: "refused: too soon" }).granted, false);
  assert.deepEqual(of({ state: "note: a > b" }).text, "a > b");
  assert.equal(of({ state: "half-time" }).kind, "game");
});

test("images and annotations are found at or before the shown frame only", () => {
  const store = filled(30);
  store.receive("/percepts", 20 * STEP, encode({ entities: [] }));
  store.show(10 * STEP * 1e-6);
  assert.equal(store.latest("/percepts"), null);
  store.show(25 * STEP * 1e-6);
  assert.equal(store.latest("/percepts").time, 20 * STEP * 1e-6);
  assert.equal(store.latest("/percepts", 0.05), null);
});
