// SPDX-License-Identifier: MIT
// program_test.mjs PROGRAM FOLDER: uses the page in chromium (CHROMIUM) on a run of the program itself, with a copy of
// the scripts in FOLDER. Each test waits until something is seen, never for a fixed time.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { appendFileSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";

import { PATIENCE, launch, linkOf, openPage, untilListed } from "./browser.mjs";

const [program, folder] = process.argv.slice(2);
const scripts = join(folder, "scripts");

let run, browser, page;
const messages = []; // of the console
const printed = []; // lines of the run's timeline

const options = ["--log", "off", "run", "patrol", "--width", "160", "--no-pictures", "--scripts", scripts, "--model",
  join(folder, "room.model"), "--seconds"];

before(async () => {
  try {
    execFileSync(program, [...options, "30"], { stdio: "ignore" }); // the robot learns the room, as fast as possible
  } catch (error) {
    assert.equal(error.status, 1); // the scenario does not end in this time
  }
  run = spawn(program, [...options, "36000", "--live", "0"], { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
  createInterface(run.stdout).on("line", (line) => printed.push(line));
  const link = await linkOf(run);
  browser = await launch();
  page = await openPage(browser, { viewport: { width: 1366, height: 768 } }, link, messages);
});
after(async () => {
  await browser?.close();
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
  await panel.getByRole("button", { name: "Undo" }).click();
  await panel.getByText("No parameter differs from tuned.toml").waitFor();
  await panel.getByRole("button", { name: "Show all parameters" }).click();
  await panel.locator("input[type=search]").fill("orientation.hold_time");
  await slider.focus();
  await slider.press("PageDown");
  await save.click();
  await panel.getByText("The file before is tuned.toml.bak.").waitFor();
  assert.match(readFileSync(join(folder, "tuned.toml.bak"), "utf8"), /hold_time = 10/);
  await panel.getByText("Save or compare with a file").click();
});

test("a what-if on a slider shows both futures, and the robot keeps its value", async () => {
  const panel = page.locator("[data-panel=parameters]");
  await page.keyboard.press("Escape"); // leaves the box
  await panel.locator("input[type=search]").fill("head_scan.timeout");
  await panel.getByRole("button", { name: "What if…" }).click();
  await panel.getByText("The robot keeps its own.").waitFor();
  const slider = page.locator('input[aria-label="head_scan.timeout as a slider"]');
  await slider.focus();
  await slider.press("Home");
  await panel.getByText("What if: the first decision that differs is at").waitFor();
  const verdict = await page.locator(".verdict").textContent();
  assert.match(verdict, /only the what-if does this: head_scan: /);
  assert.match(verdict, /\d+ frames from .* replayed in/);
  await panel.getByText("what if 0.5; the robot has 4").waitFor();
  await panel.getByRole("button", { name: "End what-if" }).click();
  await panel.getByText("what if 0.5; the robot has 4").waitFor({ state: "detached" });
  await page.locator("[data-panel=what_if]").getByRole("button", { name: "Try parameters" }).click();
  await panel.getByText("The robot keeps its own.").waitFor();
  await panel.getByRole("button", { name: "End what-if" }).click();
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
  // A link once the new definition is known.
  await panel("behaviors").getByRole("button", { name: `line ${before + 1}`, exact: true }).first().click();
  const text = readFileSync(file, "utf8").split("\n")[before]; // of whichever state is active
  await page.locator("[data-panel=scripts] .cm-editor.cm-focused").waitFor(); // focused when the cursor is at the line
  assert.equal(await page.locator("[data-panel=scripts] .cm-activeLine").innerText(), text);
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

test("a run pauses, takes single frames and resumes", async () => {
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Pause run" }).click();
  await page.getByText("Run paused").waitFor();
  await page.keyboard.press("8");
  const notes = page.locator("[data-panel=notes] li");
  // A note of a pause has the time of the next frame.
  const times = [];
  for (const text of ["before a frame", "before another frame"]) {
    await page.locator("#note").fill(text);
    await page.locator("#note").press("Enter");
    await notes.filter({ hasText: text }).getByText("from the next frame on").waitFor();
    await page.getByRole("button", { name: "One frame" }).click();
    const note = notes.filter({ hasText: text, hasNotText: "from the next frame on" });
    times.push(parseFloat(await note.locator(".time").first().innerText()));
  }
  assert.ok(Math.abs(times[1] - times[0] - 1 / 30) < 0.011, `expected the times of two frames, found ${times}`);
  await page.getByText("Run paused").waitFor();
  await page.keyboard.press("Escape");
  await page.keyboard.press("p");
  await page.waitForFunction(() => document.querySelector(".connection")?.textContent.startsWith("Live"));
});

test("on a phone the header of a paused run is one row of text and one of buttons", async () => {
  await page.keyboard.press("p");
  await page.getByText("Run paused").waitFor();
  const { width, height } = page.viewportSize();
  await page.setViewportSize({ width: 390, height: 844 });
  const buttons = await page.locator("header nav .button:visible").evaluateAll((all) =>
    all.map((it) => it.getBoundingClientRect()).map(({ top, right }) => ({ top, right })),
  );
  assert.ok(buttons.length > 6);
  assert.deepEqual([...new Set(buttons.map(({ top }) => top))], [buttons[0].top]);
  assert.ok(Math.max(...buttons.map(({ right }) => right)) <= 390);
  await page.setViewportSize({ width, height });
  await page.keyboard.press("p");
  await page.waitForFunction(() => document.querySelector(".connection")?.textContent.startsWith("Live"));
});

test("a slider changes a parameter of a paused run, and the robot obeys within two frames", async () => {
  await page.keyboard.press("p");
  await page.getByText("Run paused").waitFor();
  await page.keyboard.press("5");
  await panel("parameters").locator("input[type=search]").fill("orientation.hold_time");
  const slider = page.locator('input[aria-label="orientation.hold_time as a slider"]');
  await slider.focus();
  await slider.press("End");
  await panel("parameters").getByText("from the next frame on").waitFor();
  await page.keyboard.press("Escape");
  await page.keyboard.press("4");
  await panel("behaviors").locator(".machine .name", { hasText: /^orientation$/ }).click();
  const held = panel("behaviors").locator(".dwell .value", { hasText: "of 10.0 s" });
  await panel("behaviors").locator(".dwell .value").first().waitFor();
  assert.equal(await held.count(), 0, "the shown frame is that before the change");
  const time = async () => Number.parseFloat(await page.locator(".connection .value").first().innerText());
  const before = await time();
  await page.keyboard.press(".");
  await page.keyboard.press(".");
  await held.first().waitFor();
  const after = await time();
  assert.ok(after - before < 2.5 / 30, `expected at most two frames, found ${before} and ${after} s`);
  await page.keyboard.press("5");
  await panel("parameters").locator("input[type=search]").fill("orientation.hold_time");
  await page.keyboard.press("Escape");
  assert.equal(await page.locator('input[aria-label="orientation.hold_time"]').inputValue(), "10");
  await panel("parameters").getByText("from the next frame on").waitFor({ state: "detached" });
  await page.keyboard.press("u");
  await panel("parameters").getByText("from the next frame on").waitFor();
  await page.keyboard.press(".");
  await panel("parameters").getByText("from the next frame on").waitFor({ state: "detached" });
  await page.keyboard.press("4");
  await page.getByRole("button", { name: "Show all behaviors" }).click();
  await page.keyboard.press("p");
  await page.waitForFunction(() => document.querySelector(".connection")?.textContent.startsWith("Live"));
});

const field = () => page.locator("[data-panel=field] canvas");
const operator = () => page.locator("[data-panel=operator]");

/// Moves the pointer to the true robot in the panel of the field. Returns where it is, and its mirrored position.
async function pointToRobot() {
  const { width, height, x, y } = await field().boundingBox();
  const at = (u, v) => [x + 0.5 * width + u, y + 0.5 * height + v];
  // A click shows the position of a point.
  const across = 0.25 * width;
  await page.mouse.click(...at(across, 0.45 * height));
  const point = /Point: x ([\d.]+) m/.exec(await page.locator(".numbers").innerText());
  assert.ok(point, "expected the numbers of a point");
  await page.getByLabel("Close the numbers").click();
  const scale = across / Number(point[1]);
  await page.keyboard.press("o");
  await operator().getByText("use the true pose").click();
  const [u, v] = await Promise.all(
    ["x in m", "y in m"].map(async (name) => scale * Number(await operator().getByLabel(name).inputValue())),
  );
  await page.mouse.move(...at(u, -v));
  await page.waitForFunction(() => document.querySelector("[data-panel=field] canvas").style.cursor === "grab");
  return { here: at(u, -v), mirrored: at(-u, v) };
}

const setSpeed = (speed) => page.getByLabel("Speed of the run").selectOption(String(speed));

test("a drag that is canceled returns the robot", async () => {
  await setSpeed(0.05); // so that the robot does not walk away from the pointer
  await page.keyboard.press("1");
  await page.getByRole("tab", { name: "Notes" }).click();
  const { here } = await pointToRobot();
  await page.mouse.down();
  await page.mouse.move(here[0] + 40, here[1], { steps: 4 });
  await page.mouse.wheel(0, 100);
  await page.getByText("Escape cancels").waitFor();
  await page.keyboard.press("Escape");
  await page.getByText("Escape cancels").waitFor({ state: "detached" });
  await page.mouse.up();
  await page.locator("[data-panel=notes]").getByText("put_down").first().waitFor();
});

test("a robot that is placed in a paused run is shown there until the next frame", async () => {
  await page.keyboard.press("p");
  await page.getByText("Run paused").waitFor();
  const { here } = await pointToRobot();
  await page.mouse.down();
  await page.mouse.move(here[0] + 30, here[1] - 30, { steps: 4 }); // toward the field
  await page.mouse.up();
  const pending = page.locator("[data-panel=field]").getByText("From the next frame on: x");
  await pending.waitFor();
  const [, x, y] = /x (\S+) m, y (\S+) m/.exec(await pending.innerText()).map((it) => it.replace("−", "-"));
  await page.keyboard.press(".");
  await pending.waitFor({ state: "detached" });
  await operator().getByText("use the true pose").click();
  for (const [name, expected] of [["x in m", x], ["y in m", y]]) {
    const found = await operator().getByLabel(name).inputValue();
    assert.ok(Math.abs(found - expected) < 0.05, `${name}: expected ${expected}, found ${found}`);
  }
  await page.keyboard.press("p");
  await page.waitForFunction(() => document.querySelector(".connection")?.textContent.startsWith("Live"));
});

test("a robot that is dragged to its mirrored pose notices it", async () => {
  const flips = () => printed.filter((line) => line.includes("flip_pose granted (the mirrored pose won)")).length;
  // The tests before have placed it elsewhere. Only a robot that knows most of its room and is sure of its pose flips it.
  await setSpeed(20);
  await page.waitForFunction(() => Number.parseFloat(document.querySelector(".connection .value")?.textContent) > 90);
  await page.getByText("The robot is sure of its pose").waitFor();
  await setSpeed(0.05); // so that the robot does not walk away from the pointer
  const before = flips();
  const { mirrored } = await pointToRobot();
  await setSpeed(1); // so that the robot notices that it is carried
  await page.mouse.down();
  await page.mouse.move(...mirrored, { steps: 10 });
  await page.getByText("Mirrored pose: x").waitFor();
  await page.mouse.up();
  await setSpeed(20); // frames may be too many for the page, so that it misses the event
  const end = Date.now() + PATIENCE;
  while (flips() === before) {
    assert.ok(Date.now() < end, `expected a flip, found\n${printed.slice(-20).join("\n")}`);
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  await setSpeed(1); // a fast run leaves a busy computer no time to draw
  await page.getByText("The robot is sure of its pose").waitFor();
});

test("the panel of the operator places, pushes and penalizes the robot, and refuses wrong numbers", async () => {
  await page.keyboard.press("o");
  const panel = operator();
  await page.getByRole("tab", { name: "Notes" }).click();
  const untilNoted = (text) => page.locator("[data-panel=notes]").getByText(text).first().waitFor();
  await panel.getByRole("button", { name: "Penalize" }).click();
  await untilNoted("penalize on");
  await panel.getByRole("button", { name: "End the penalty" }).click();
  await untilNoted("penalize off");
  await panel.getByRole("button", { name: "Push over" }).click();
  await untilNoted("push_over");
  await panel.getByLabel("x in m").fill("1.5");
  await panel.getByLabel("degrees").fill("90");
  await panel.getByLabel("y in m").fill("far");
  assert.equal(await panel.getByRole("button", { name: "Put down" }).isDisabled(), true);
  await panel.getByLabel("y in m").fill("1e9");
  await panel.getByLabel("y in m").press("Enter");
  await panel.getByText("expected a pose within 100 m").waitFor();
  await panel.getByLabel("y in m").fill("-1");
  await panel.getByLabel("y in m").press("Enter");
  await untilNoted("put_down at x 1.50 m, y -1.00 m, 90.0 degrees");
});

test("the page says that the run has ended", async () => {
  run.kill("SIGINT");
  await page.locator(".connection.busy", { hasText: "The run has ended, by its user with Ctrl-C." }).waitFor();
});

test("the console has no message", () => {
  const isOfTheEnd = (text) => text.includes("WebSocket connection") || text.includes("ERR_CONNECTION_REFUSED");
  assert.deepEqual(messages.filter((text) => !isOfTheEnd(text)), []);
});
