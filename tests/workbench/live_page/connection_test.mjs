// SPDX-License-Identifier: MIT
// The connection of the page: why it ended, and calls without an answer; with a stand-in for the WebSocket of a browser.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Connection } from "../../../workbench/views/live/page/source/connection.js";

const sockets = [];
globalThis.WebSocket = class {
  constructor() {
    sockets.push(this);
  }
  close() {}
  send() {}
};

/// A connection whose retries are made by the test.
function connected(t) {
  t.mock.timers.enable({ apis: ["setTimeout", "setInterval"] });
  const connection = new Connection("ws://robot/", [], () => {});
  t.after(() => connection.close());
  const answer = () => sockets.at(-1).onmessage({ data: JSON.stringify({ op: "serverInfo", name: "robot" }) });
  const end = (reason) => sockets.at(-1).onclose({ reason });
  const retry = () => t.mock.timers.tick(3000);
  return { connection, answer, end, retry };
}

test("the reason of the end stays while no robot answers", (t) => {
  const { connection, answer, end, retry } = connected(t);
  answer();
  end("the run has ended");
  for (let i = 0; i < 3; ++i) {
    retry();
    end("");
    assert.equal(connection.reason, "the run has ended");
  }
  end("too many viewers");
  assert.equal(connection.reason, "too many viewers");
});

test("a robot that answers ends the reason", (t) => {
  const { connection, answer, end, retry } = connected(t);
  answer();
  end("the run has ended");
  retry();
  answer();
  assert.equal(connection.reason, "");
  end("");
  assert.equal(connection.reason, "", "a robot that vanishes gives no reason");
});

/// A call of a service, and what became of it: "waits", "answered" or the text of the error.
function calling(t, name, isPaused) {
  const { connection, answer } = connected(t);
  answer();
  connection.isPaused = isPaused;
  const receive = (message) => sockets.at(-1).onmessage({ data: JSON.stringify(message) });
  receive({ op: "advertiseServices", services: [{ id: 1, name }] });
  const outcome = { text: "waits" };
  connection.call(name, {}).then(
    () => (outcome.text = "answered"),
    (error) => (outcome.text = error.message),
  );
  const [[id]] = connection.calls;
  const pass = async (ms) => {
    t.mock.timers.tick(ms);
    await Promise.resolve();
    await Promise.resolve();
  };
  return { connection, outcome, id, pass };
}

test("a call that needs a frame waits while the run is paused, and is answered by its next frame", async (t) => {
  const { connection, outcome, id, pass } = calling(t, "note", true);
  for (let i = 0; i < 4; ++i) await pass(5000);
  assert.equal(outcome.text, "waits");
  connection.finishCall(id, {}, null);
  await pass(0);
  assert.equal(outcome.text, "answered");
});

test("a call that is late in a run that is not paused says so", async (t) => {
  const { outcome, pass } = calling(t, "note", false);
  await pass(4900);
  assert.equal(outcome.text, "waits");
  await pass(200);
  assert.match(outcome.text, /^No answer to note within 5 s\. The run is not paused: /);
});

test("a call has its full time after a pause", async (t) => {
  const { connection, outcome, pass } = calling(t, "note", true);
  await pass(5100);
  connection.isPaused = false;
  await pass(4800);
  assert.equal(outcome.text, "waits");
  await pass(200);
  assert.match(outcome.text, /The run is not paused/);
});

test("a call that needs no frame does not wait for one", async (t) => {
  const { outcome, pass } = calling(t, "save", true);
  await pass(5000);
  assert.match(outcome.text, /^No answer to save within 5 s\. The run is paused, but this needs no frame: /);
});
