// SPDX-License-Identifier: MIT
// The connection of the page: why it ended, with a stand-in for the WebSocket of a browser.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Connection } from "../../../workbench/views/live/page/source/connection.js";

const sockets = [];
globalThis.WebSocket = class {
  constructor() {
    sockets.push(this);
  }
  close() {}
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
