// SPDX-License-Identifier: MIT
// Why rates are reduced: what the page knows about its own browser, and what the robot reports.
import assert from "node:assert/strict";
import { test } from "node:test";

import { Lateness, rateText } from "../../../workbench/views/live/page/source/lateness.js";

function after(...waits) {
  const browser = new Lateness();
  let time = 1000;
  browser.tick(time);
  for (const wait of waits) browser.tick((time += wait));
  return browser;
}

test("a browser is busy while its timers fire much later than planned", () => {
  assert.equal(after(200, 205, 210, 200).isBusy, false);
  assert.equal(after(200, 1200, 200).isBusy, true, "blocked for a second");
  assert.equal(after(300, 300, 300, 300, 300, 300, 300).isBusy, true);
  assert.equal(after(1200, ...Array(25).fill(200)).isBusy, false, "long ago");
});

test("a page that was hidden is not a busy browser", () => {
  const browser = after(200, 5000);
  browser.reset();
  browser.tick(90000);
  browser.tick(90200);
  assert.equal(browser.isBusy, false);
});

test("the page completes the cause that the robot cannot know", () => {
  const rates = "6 of 30 frames, 1 of 30 images a second";
  const unknown = `slow connection or busy viewer: ${rates}`;
  assert.equal(rateText(unknown, false).text, `slow connection or busy computer: ${rates}`);
  assert.equal(rateText(unknown, true).text, `busy browser: ${rates}`);
  for (const isBusy of [false, true]) {
    const { text, title } = rateText(`busy computer: ${rates}`, isBusy);
    assert.equal(text, `busy computer: ${rates}`);
    assert.match(title, /^The computer of the run is busy\. The robot sends fewer/);
  }
  assert.equal(rateText("", true).text, "");
});
