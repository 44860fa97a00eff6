// SPDX-License-Identifier: MIT
// program_test.mjs PROGRAM FOLDER: uses the page in chromium (CHROMIUM) on a run of the program itself, with a copy of
// the scripts in FOLDER. Each test waits until something is seen, never for a fixed time.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { appendFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";

import { launch, openPage, untilListed } from "./browser.mjs";

const [program, folder] = process.argv.slice(2);
const scripts = join(folder, "scripts");

let run, browser, page;
const messages = []; // of the console

before(async () => {
  run = spawn(program, ["--log", "off", "run", "patrol", "--live", "0", "--width", "160", "--seconds", "600",
    "--no-pictures", "--scripts", scripts], { cwd: folder, stdio: ["ignore", "ignore", "pipe"] });
  const link = await new Promise((resolve, reject) => {
    createInterface(run.stderr).on("line", (line) => {
      const found = line.match(/live view: (\S+)/);
      if (found) resolve(found[1]);
    });
    run.on("exit", (code) => reject(new Error(`expected a link, found the exit code ${code}`)));
  });
  browser = await launch();
  page = await openPage(browser, { viewport: { width: 1366, height: 768 } }, link, messages);
});
after(async () => {
  await browser?.close();
  run?.removeAllListeners("exit");
  run?.kill("SIGKILL");
});

test("the page shows the frames of the run", async () => {
  await page.waitForFunction(() => document.querySelector(".connection")?.textContent.startsWith("Live"));
  await untilListed(page);
});

test("a slider changes the parameter of the robot", async () => {
  await page.keyboard.press("5");
  await page.locator("[data-panel=parameters] input[type=search]").fill("orientation.hold_time");
  const slider = page.locator('input[aria-label="orientation.hold_time as a slider"]');
  await slider.focus();
  await slider.press("End");
  // A refused value is answered with the value in force.
  const box = page.locator('input[aria-label="orientation.hold_time"]');
  await box.fill("99");
  await box.press("Enter");
  await page.getByText("The robot uses 10 instead of 99.").waitFor();
});

test("what differs from the defaults is saved, with a copy of the file before, and compared", async () => {
  const panel = page.locator("[data-panel=parameters]");
  const save = panel.getByRole("button", { name: "Save" });
  await panel.getByText("Save or compare with a file").click();
  await save.click();
  await panel.getByText("Saved in tuned.toml.").waitFor();
  const slider = page.locator('input[aria-label="orientation.hold_time as a slider"]');
  await slider.focus();
  await slider.press("Home");
  await panel.getByRole("button", { name: "Compare" }).click();
  await panel.getByText("in tuned.toml 10").waitFor();
  await slider.focus();
  await slider.press("PageUp");
  await save.click();
  await panel.getByText("The file before is tuned.toml.bak.").waitFor();
  assert.match(readFileSync(join(folder, "tuned.toml.bak"), "utf8"), /hold_time = 10/);
  await panel.getByRole("button", { name: "all" }).click();
  await panel.getByText("Save or compare with a file").click();
});

test("a what-if on a slider shows both futures, and the robot keeps its value", async () => {
  const panel = page.locator("[data-panel=parameters]");
  await page.keyboard.press("Escape"); // leaves the box
  await panel.locator("input[type=search]").fill("head_scan.timeout");
  await panel.getByRole("button", { name: "What if" }).click();
  const slider = page.locator('input[aria-label="head_scan.timeout as a slider"]');
  await slider.focus();
  await slider.press("Home");
  await page.getByText("The first decision that differs").waitFor();
  const verdict = await page.locator(".verdict").textContent();
  assert.match(verdict, /the robot would have done this then: head_scan: /);
  assert.match(verdict, /\d+ frames from .* replayed in/);
  await panel.getByText("what if 0.5; the robot has 4").waitFor();
  await page.getByRole("button", { name: "Drop all" }).click();
  await panel.getByRole("button", { name: "What if" }).click();
  await panel.getByText("default 4").waitFor();
  assert.equal(await page.locator('input[aria-label="head_scan.timeout"]').inputValue(), "4");
});

test("a note is answered by the run", async () => {
  await page.keyboard.press("Escape"); // leaves the box
  await page.keyboard.press("n");
  await page.locator("#note:focus").waitFor();
  await page.keyboard.type("a note of the test");
  await page.keyboard.press("Enter");
  await page.locator("[data-panel=notes]").getByText("a note of the test").first().waitFor();
});

const panel = (name) => page.locator(`[data-panel=${name}]`);

test("the open transitions of orientation show the values of the frame", async () => {
  await page.keyboard.press("Escape"); // leaves the box
  await page.keyboard.press("4");
  await panel("behaviors").locator(".machine .name", { hasText: /^orientation$/ }).click();
  await panel("behaviors").locator("svg .box.active").first().waitFor();
  await page.keyboard.press(" ");
  await page.getByText("View paused").waitFor();
  const rows = panel("behaviors").locator(".transition");
  assert.match(await rows.first().innerText(), /→ lifted\s+no/);
  const shown = await panel("behaviors").locator(".reads > div").evaluateAll((all) =>
    all.map((it) => [it.querySelector("dt").textContent, it.querySelector("dd").textContent]),
  );
  assert.ok(shown.some(([name]) => name === "confidence.evidence"), "also of functions of libraries");
  await page.keyboard.press("6");
  await panel("world").locator(".values tr").nth(20).waitFor();
  const world = new Map(
    await panel("world").locator(".values tr").evaluateAll((all) =>
      all.map((it) => [it.querySelector("code").textContent, it.querySelector(".value").textContent]),
    ),
  );
  assert.deepEqual(shown, shown.map(([name]) => [name, world.get(name)]));
  await page.keyboard.press("l");
});

test("the lines of the open transitions follow an edit", async () => {
  await page.keyboard.press("4");
  const line = panel("behaviors").locator(".transition .place").first();
  const before = Number((await line.innerText()).replace("line ", ""));
  const file = join(scripts, "behaviors/orientation.lua");
  writeFileSync(file, `-- one more line\n${readFileSync(file, "utf8")}`);
  await panel("behaviors").getByText(`line ${before + 1}`, { exact: true }).first().waitFor();
  await panel("behaviors").locator(".arrow.numbered").first().waitFor();
  await line.click();
  await page.locator("[data-panel=scripts] .cm-activeLine", { hasText: '"lifted"' }).waitFor();
  await page.keyboard.press("1");
  await page.keyboard.press("4");
  await page.getByRole("button", { name: "Show all behaviors" }).click();
});

test("a broken edit and its fix are shown while the run continues", async () => {
  const file = join(scripts, "behaviors/head_scan.lua");
  const good = readFileSync(file, "utf8");
  await page.getByRole("tab", { name: "Log" }).click();
  appendFileSync(file, "\nlocal x = = 1\n");
  await page.getByText("unexpected symbol near '='").first().waitFor();
  writeFileSync(file, good + "\n-- as before\n");
  await page.getByText("the edit is running").first().waitFor();
});

test("the page says that the robot is gone when the run ends", async () => {
  run.removeAllListeners("exit");
  run.kill("SIGINT");
  await page.getByText("The robot is gone").first().waitFor();
});

test("the console has no message", () => {
  const isOfTheEnd = (text) => text.includes("WebSocket connection") || text.includes("ERR_CONNECTION_REFUSED");
  assert.deepEqual(messages.filter((text) => !isOfTheEnd(text)), []);
});
