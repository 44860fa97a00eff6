// SPDX-License-Identifier: MIT
// The edited scripts of the page: checks, saving, texts of other editors, and results of reloads.
import assert from "node:assert/strict";
import { test } from "node:test";

import { EditedScript } from "../../../workbench/views/live/page/source/scripts/edited_script.js";
import { rangeOf } from "../../../workbench/views/live/page/source/scripts/position.js";
import { findingOf, reloadResult } from "../../../workbench/views/live/page/source/scripts/reload_result.js";

const FILE = "behaviors/walk.lua";

/// A script that is opened, and a disk that saves it as a robot does.
function opened(text = "one") {
  const disk = { text, calls: [], failure: null };
  const call = async (service, request) => {
    disk.calls.push([service, request]);
    if (disk.failure) throw new Error(disk.failure);
    if (service === "script") return { file: FILE, text: disk.text };
    if (service === "check_script") return { findings: [{ line: 1, column: 1, message: request.text }] };
    const saved = request.expected === disk.text;
    if (saved) disk.text = request.text;
    return { file: FILE, saved, text: disk.text };
  };
  const editor = { text };
  const replace = (other) => {
    editor.text = other;
  };
  const script = new EditedScript(FILE, text, { call, onChange: () => {}, replace });
  script.checkIn = () => {}; // no timers
  return { script, disk, editor };
}

test("a saved text becomes the one with which the next save begins", async () => {
  const { script, disk } = opened();
  script.typed("two");
  assert.ok(script.isChanged);
  assert.equal(await script.save(), true);
  assert.equal(disk.text, "two");
  assert.ok(!script.isChanged);
  script.typed("three");
  assert.equal(await script.save(), true);
  assert.equal(disk.text, "three");
});

test("a text of another editor is not overwritten without a choice", async () => {
  const { script, disk, editor } = opened();
  script.typed("mine");
  disk.text = "theirs";
  assert.equal(await script.save(), false);
  assert.equal(disk.text, "theirs");
  assert.equal(script.disk, "theirs");
  script.keepMine();
  assert.equal(await script.save(), true);
  assert.equal(disk.text, "mine");
  script.typed("mine again");
  disk.text = "theirs again";
  await script.look();
  script.take(script.disk);
  assert.equal(editor.text, "theirs again");
  assert.ok(!script.isChanged);
});

test("a text of the disk is shown at once if there are no edits", async () => {
  const { script, disk, editor } = opened();
  disk.text = "theirs";
  await script.look();
  assert.equal(editor.text, "theirs");
  assert.match(script.notice, /has changed on the disk/);
  assert.equal(script.disk, null);
});

test("the same edit of another editor is no conflict, and neither is a disk that returns", async () => {
  const { script, disk } = opened();
  script.typed("two");
  disk.text = "two";
  await script.look();
  assert.ok(!script.isChanged);
  script.typed("three");
  disk.text = "four";
  await script.look();
  assert.equal(script.disk, "four");
  disk.text = "two";
  await script.look();
  assert.equal(script.disk, null);
});

test("revert shows the text of the disk", async () => {
  const { script, disk, editor } = opened();
  script.typed("two");
  disk.text = "theirs";
  await script.revert();
  assert.equal(editor.text, "theirs");
  assert.ok(!script.isChanged);
});

test("a failed call keeps the edits and says why", async () => {
  const { script, disk } = opened();
  script.typed("two");
  disk.failure = "the connection was closed";
  assert.equal(await script.save(), false);
  assert.match(script.failure, /not saved: the connection was closed/);
  await script.look();
  await script.revert();
  assert.equal(script.text, "two");
  await script.check();
  assert.equal(script.checkFailure, "the connection was closed");
});

test("findings belong to the text that is shown", async () => {
  const { script } = opened();
  const checked = script.check();
  script.typed("two");
  await script.check(); // waits for the first one
  await checked;
  assert.deepEqual(script.findings, []);
  await script.check();
  assert.equal(script.findings[0].message, "two");
});

test("a column of bytes is the word at that place", () => {
  assert.deepEqual(rangeOf("local walk = 1", 7), { from: 6, to: 10 });
  assert.deepEqual(rangeOf("-- ä€😀 walk", 14), { from: 8, to: 12 });
  assert.deepEqual(rangeOf("walk", 0), { from: 0, to: 4 });
  assert.deepEqual(rangeOf("walk", 99), { from: 4, to: 4 });
  assert.deepEqual(rangeOf("", 1), { from: 0, to: 0 });
});

test("the log has the result of a reload", () => {
  const rejected = `edit rejected; keeping the previous version: ${FILE}:3:5: unexpected symbol`;
  const log = [
    { time: 1, level: 2, name: FILE, message: "the edit is running", file: "", line: 0 },
    { time: 2, level: 4, name: FILE, message: rejected, file: FILE, line: 3 },
    { time: 3, level: 2, name: "behaviors/other.lua", message: "the edit is running", file: "", line: 0 },
    { time: 3, level: 2, name: FILE, message: null, file: "", line: 0 },
  ];
  assert.deepEqual(reloadResult(log, FILE, 1.5), {
    time: 2,
    accepted: false,
    finding: { file: FILE, line: 3, column: 5, severity: "error", message: "unexpected symbol" },
  });
  assert.equal(reloadResult(log.slice(0, 1), FILE, 0).accepted, true);
  assert.equal(reloadResult(log, FILE, 2.5), null);
  assert.equal(reloadResult(log, "lib/steps.lua", 2.5).accepted, true);
  const fault = { time: 4, level: 4, name: "", message: `${FILE}:7: x; the previous version runs again`, file: FILE };
  assert.equal(reloadResult([...log, fault], FILE, 2.5).finding.line, 7);
});

test("a fault without a place is a finding of its file", () => {
  assert.deepEqual(findingOf("not enough memory", FILE, 2), {
    file: FILE,
    line: 2,
    column: 0,
    severity: "error",
    message: "not enough memory",
  });
});
