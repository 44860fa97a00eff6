// SPDX-License-Identifier: MIT
// paused_test.mjs PROGRAM FOLDER: uses the page in chromium (CHROMIUM) on a run that is paused before the page is
// opened, and after the end of the run. Each test waits until something is seen, never for a fixed time.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { launch, linkOf, openPage } from "./browser.mjs";

const [program, folder] = process.argv.slice(2);
const messages = []; // of the console
let run, browser, link, page;

const open = () => openPage(browser, { viewport: { width: 1366, height: 768 } }, link, messages);
const timeOf = (of) => of.locator(".connection .value").first().innerText();

before(async () => {
  const options = ["--width", "160", "--no-pictures", "--scripts", join(folder, "scripts"), "--seconds", "36000"];
  run = spawn(program, ["--log", "off", "run", "patrol", ...options, "--live", "0"], {
    cwd: folder,
    stdio: ["ignore", "ignore", "pipe"],
  });
  link = await linkOf(run);
  browser = await launch();
  page = await open();
});
after(async () => {
  await browser?.close();
  run?.kill("SIGKILL");
});

test("the scenario is listed with its mark, with its graph, and in the timeline", async () => {
  await page.keyboard.press("4");
  const panel = page.locator("[data-panel=behaviors]");
  const machine = panel.locator(".machine", { has: page.locator(".badge", { hasText: "scenario" }) });
  await machine.getByRole("button", { name: "patrol" }).click();
  await panel.locator(".graph .box.active").first().waitFor();
  await panel.locator(".transitions li").first().waitFor();
  await page.locator(".readout", { hasText: "patrol" }).waitFor();
  await panel.getByRole("button", { name: "show in the timeline" }).click();
  await page.locator(".readout", { hasNotText: "patrol" }).waitFor();
});

test("a page that is opened during a pause shows the last frame", async () => {
  await page.locator(".pace").waitFor(); // the page knows that the run can be paused
  await page.keyboard.press("p");
  const paused = page.locator(".connection", { hasText: "Run paused" });
  await paused.waitFor().catch(async ({ message }) => {
    throw new Error(`${message}\nThe page shows:\n${await page.locator("body").innerText()}`);
  });
  await page.close(); // so that the run has no viewer
  const late = await open();
  await late.locator(".connection", { hasText: "Run paused" }).waitFor();
  await late.locator("figcaption", { hasText: /Upper, \d/ }).waitFor();
  await late.locator(".readout", { hasText: /evidence/ }).waitFor();
  await late.keyboard.press("6");
  await late.locator(".values tr").nth(4).waitFor();
  const time = await timeOf(late);
  const other = await open();
  await other.locator("figcaption", { hasText: `Upper, ${time}` }).waitFor();
  assert.equal(await timeOf(other), time);
  await other.close();
  page = late;
});

test("the page says that the run has ended, also after its retries", async () => {
  const tries = [];
  page.on("websocket", (socket) => tries.push(socket));
  run.kill("SIGINT");
  await page.locator(".connection", { hasText: "The run has ended" }).waitFor();
  while (tries.length < 3) await page.waitForEvent("websocket");
  assert.match(await page.locator(".connection").innerText(), /The run has ended/);
});

test("nothing failed in the page", () => {
  assert.deepEqual(messages.filter((text) => !/WebSocket connection to .* failed/.test(text)), []);
});
