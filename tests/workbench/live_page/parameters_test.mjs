// SPDX-License-Identifier: MIT
// The parameters of the page: answers of the robot, undo and differences.
import assert from "node:assert/strict";
import { test } from "node:test";

import { filtersOf, listed, whyEmpty } from "../../../workbench/views/live/page/source/parameter_list.js";
import { Parameters } from "../../../workbench/views/live/page/source/parameters.js";
import { thought } from "../../../workbench/views/live/page/source/sentence.js";
import { Store } from "../../../workbench/views/live/page/source/store.js";

const HOLD = { name: "orientation.hold_time", value: 0.2, default: 0.2, min: 0, max: 10, unit: "s" };

function one() {
  const parameters = new Parameters();
  parameters.take([HOLD]);
  return parameters;
}
const value = (parameters) => parameters.all.get(HOLD.name).value;

test("a change is shown at once and sent with its id", () => {
  const parameters = one();
  const message = parameters.change(HOLD.name, 2, "set-1");
  assert.deepEqual(message, { op: "setParameters", parameters: [{ name: HOLD.name, value: 2 }], id: "set-1" });
  assert.equal(value(parameters), 2);
});

test("a refused value returns to the one in force, with a text", () => {
  const parameters = one();
  parameters.change(HOLD.name, 99, "set-1");
  parameters.take([{ name: HOLD.name, value: 0.2 }], "set-1");
  assert.equal(value(parameters), 0.2);
  assert.match(parameters.refusals.get(HOLD.name), /uses 0\.2 instead of 99/);
  parameters.change(HOLD.name, 1, "set-2");
  parameters.take([{ name: HOLD.name, value: 1 }], "set-2");
  assert.equal(parameters.refusals.size, 0);
});

test("an answer to an older message does not move a slider back", () => {
  const parameters = one();
  parameters.change(HOLD.name, 1, "set-1");
  parameters.change(HOLD.name, 2, "set-2");
  parameters.take([{ name: HOLD.name, value: 1 }], "set-1");
  assert.equal(value(parameters), 2);
  parameters.take([{ name: HOLD.name, value: 2 }], "set-2");
  assert.equal(parameters.refusals.size, 0);
});

test("what a closed connection left without an answer does not hide the value in force", () => {
  const parameters = one();
  parameters.change(HOLD.name, 2, "set-1");
  assert.ok(parameters.pending.has(HOLD.name));
  parameters.forgetSent();
  parameters.take([{ name: HOLD.name, value: 0.2 }], "all");
  assert.equal(value(parameters), 0.2);
});

test("a float of the robot is the same value", () => {
  const parameters = one();
  parameters.change(HOLD.name, 0.3, "set-1");
  parameters.take([{ name: HOLD.name, value: Math.fround(0.3) }], "set-1");
  assert.equal(parameters.refusals.size, 0);
});

test("undo returns to the value before a slider was moved", () => {
  const parameters = one();
  for (const step of [1, 2, 3]) parameters.change(HOLD.name, step, `set-${step}`);
  parameters.settle();
  parameters.change(HOLD.name, 4, "set-4");
  assert.deepEqual(parameters.takeUndo().value, 3);
  assert.deepEqual(parameters.takeUndo().value, 0.2);
  assert.equal(parameters.takeUndo(), undefined);
});

test("undo in a paused run returns to the value before, although no change is answered yet", () => {
  const parameters = one();
  parameters.change(HOLD.name, 1, "set-1");
  parameters.settle();
  parameters.change(HOLD.name, 2, "set-2");
  parameters.settle();
  for (const [before, id] of [[1, "set-3"], [0.2, "set-4"]]) {
    parameters.take([HOLD]); // the list of the robot, which has no change yet
    const undo = parameters.takeUndo();
    assert.deepEqual(parameters.change(undo.name, undo.value, id, false).parameters, [{ name: HOLD.name, value: before }]);
    assert.equal(value(parameters), before);
  }
  for (const id of ["set-1", "set-2", "set-3", "set-4"]) parameters.take([HOLD], id);
  assert.equal(value(parameters), 0.2);
  assert.equal(parameters.takeUndo(), undefined);
});

test("differences are to the default and to the start of the run", () => {
  const parameters = new Parameters();
  parameters.begin("run 1");
  parameters.take([{ ...HOLD, value: 1 }]);
  assert.equal(parameters.differing("default").length, 1);
  assert.equal(parameters.differing("start").length, 0);
  parameters.change(HOLD.name, 0.2, "set-1");
  assert.equal(parameters.differing("default").length, 0);
  assert.equal(parameters.differing("start").length, 1);
  assert.equal(parameters.differing("file").length, 0, "no file is compared");
  parameters.begin("run 2");
  assert.equal(parameters.all.size, 0);
});

test("texts of the topic do not replace values of the service", () => {
  const parameters = one();
  parameters.takeTexts([
    { name: HOLD.name, value: "7", unit: "s" },
    { name: "a.flag", value: "true", unit: "" },
  ]);
  assert.equal(value(parameters), 0.2);
  assert.equal(parameters.all.get("a.flag").value, true);
});

test("entries that are no parameters are ignored", () => {
  const parameters = one();
  parameters.take([null, 3, {}, { name: 4 }]);
  assert.equal(parameters.all.size, 1);
});

test("the sentence names the mirrored pose, a flip, and the end of doubt", () => {
  const store = new Store();
  const say = (time, evidence, more = {}) => {
    const world = {
      pose: { known: true },
      confidence: { evidence, status: "usable", ...more },
      robot: { posture: more.posture ?? "upright" },
    };
    store.receive("/world", time * 1e6, new TextEncoder().encode(JSON.stringify(world)));
    return thought(store, { unconfirmed: 5.5 });
  };
  assert.match(thought(store, null).text, /not sent anything/);
  assert.equal(say(1, 0).tone, "doubt");
  store.show(1);
  assert.equal(thought(store, null).tone, "doubt");
  store.show(null);
  say(2, 9);
  assert.match(say(2.1, 9).text, /probably wrong/);
  const flip = { machine: "orientation", state: "correcting", command: "flip_pose", verdict: "granted", reason: "r" };
  store.receive("/events", 2.2e6, new TextEncoder().encode(JSON.stringify(flip)));
  say(2.2, -9);
  assert.match(say(2.3, -9).text, /was mirrored, and corrected it/);
  say(20, -9);
  assert.equal(say(20.1, -9).tone, "good");
  say(21, -9, { posture: "lifted" });
  assert.match(say(21.1, -9, { posture: "lifted" }).text, /lifted/);
  say(22, undefined, { status: "a status of a later version" });
  assert.equal(say(22.1, undefined, { status: "a status of a later version" }).tone, "doubt");
});

test("values are compared with those of a file, whose other values are the defaults", () => {
  const parameters = new Parameters();
  parameters.take([
    { name: "a.number", value: 0.5, default: 1 },
    { name: "a.switch", value: true, default: false },
    { name: "a.choice", value: "one", default: "two" },
    { name: "a.untouched", value: 3, default: 3 },
  ]);
  parameters.takeFile({ file: "tuned.toml", parameters: [
    { name: "a.number", value: "0.5" },
    { name: "a.switch", value: "true" },
    { name: "other.thing", value: "7" },
  ] });
  assert.deepEqual(parameters.differing("file").map((it) => it.name), ["a.choice"]);
  parameters.change("a.number", 0.25, "1");
  assert.deepEqual(parameters.differing("file").map((it) => it.name), ["a.number", "a.choice"]);
  assert.equal(parameters.inFile(parameters.all.get("a.number")), 0.5);
});

test("a search finds names first, then descriptions, and all its words", () => {
  const parameters = new Parameters();
  parameters.take([
    { name: "a.other", value: 1, default: 1, description: "the hold of the arm" },
    { name: "z.hold", value: 1, default: 2, description: "" },
    { name: "b.none", value: 1, default: 1 },
  ]);
  assert.deepEqual(listed(parameters, "all", " Hold ").map((it) => it.name), ["z.hold", "a.other"]);
  assert.deepEqual(listed(parameters, "all", "hold arm").map((it) => it.name), ["a.other"]);
  assert.deepEqual(listed(parameters, "default", "").map((it) => it.name), ["z.hold"]);
  assert.deepEqual(filtersOf(parameters).map(({ id, count }) => [id, count]), [["all", 3], ["default", 1], ["start", 0]]);
});

test("an empty list says why: nothing received, nothing differs, or nothing is found", () => {
  const parameters = new Parameters();
  assert.match(whyEmpty(parameters, "all", "x"), /has not sent its parameters/);
  parameters.take([HOLD]);
  assert.equal(whyEmpty(parameters, "all", " x "), "None of the 1 parameters contains “x”.");
  assert.match(whyEmpty(parameters, "default", "hold"), /^No parameter differs from its default/);
  assert.match(whyEmpty(parameters, "start", ""), /^No parameter differs from its value at the start/);
  parameters.takeFile({ file: "tuned.toml", parameters: [{ name: HOLD.name, value: "0.2" }] });
  assert.deepEqual(listed(parameters, "file", ""), []);
  assert.match(whyEmpty(parameters, "file", "hold"), /^No parameter differs from tuned\.toml/);
  parameters.change(HOLD.name, 1, "set-1");
  assert.match(whyEmpty(parameters, "file", "x"), /another value than in tuned\.toml \(1\) contains “x”/);
});
