// SPDX-License-Identifier: MIT
// browser_test.mjs RECORDING PARAMETERS MACHINES: uses the page in chromium (CHROMIUM) while the stand-in for the robot replays
// a recording. Each test waits until something is seen, never for a fixed time.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

import { parseParameters, readRecording } from "../../../workbench/views/live/page/dev/recording.mjs";
import { Robot } from "../../../workbench/views/live/page/dev/robot.mjs";
import { PATIENCE, launch, openPage, untilListed } from "./browser.mjs";

const [file, parametersFile, machinesFile] = process.argv.slice(2);
const folder = join(dirname(fileURLToPath(import.meta.url)), "../../../workbench/views/live/page/built");
const SCRIPT = "behaviors/orientation.lua";

let browser, page, robot;
const messages = []; // of the console

before(async () => {
  const recording = await readRecording(file);
  const parameters = parseParameters(readFileSync(parametersFile, "utf8"));
  const scripts = new Map([
    [SCRIPT, 'behavior "orientation" {}\n'],
    ["lib/decision.lua", "return {}\n"],
  ]);
  const { machines } = JSON.parse(readFileSync(machinesFile, "utf8"));
  robot = new Robot({ recording, folder, parameters, from: 38, loop: false, scripts, machines });
  await robot.start();
  browser = await launch();
  page = await open({ viewport: { width: 1366, height: 768 } });
});
after(async () => {
  await browser?.close();
  await robot?.stop();
});

const open = (options, path = "") => openPage(browser, options, `http://127.0.0.1:${robot.port}/${path}`, messages);

/// Waits until a function is true in the page.
const until = (condition, argument) => page.waitForFunction(condition, argument, { timeout: PATIENCE });

/// Waits until a canvas has more colors than a number.
const untilDrawn = (selector, colors, of = page) =>
  of.waitForFunction(
    ([where, least]) => {
      const canvas = document.querySelector(where);
      if (!canvas?.width) return false;
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size > least;
    },
    [selector, colors],
    { timeout: PATIENCE },
  );

const untilReceived = async (matches) => {
  const end = Date.now() + PATIENCE;
  while (Date.now() < end) {
    const found = robot.received.find(matches);
    if (found) return found;
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  return assert.fail(`expected a message, found ${JSON.stringify(robot.received.slice(-5))}`);
};

const shownTime = () => page.locator(".connection .value").first().innerText();

test("every panel shows data", async () => {
  await untilDrawn("[data-panel=field] canvas", 100);
  await untilDrawn("[data-panel=cameras] canvas", 1000);
  await untilDrawn("[data-panel=wall] .stage canvas", 30);
  await untilDrawn("[data-panel=timeline] .bands canvas", 20);
  await untilDrawn("[data-panel=timeline] .uplot canvas", 10);
  await untilListed(page);
  await page.keyboard.press("7");
  robot.log(3, "head_scan", "a line of the test");
  await page.getByText("a line of the test").waitFor();
  await until(() => document.querySelector(".connection").textContent.startsWith("Live"));
});

test("the flip of the recording is a transition with its reason, and its instant a sentence", async () => {
  await page.keyboard.press("4");
  await page.locator(".machine .name", { hasText: /^orientation$/ }).click();
  const flip = page.locator(".events li", { hasText: "flip_pose granted" }).first();
  assert.match(await flip.innerText(), /the mirrored pose won/);
  await flip.locator(".time").click();
  await page.getByText("The robot noticed that its believed pose was mirrored").waitFor();
});

const behaviorsPanel = () => page.locator("[data-panel=behaviors]");
const state = (path) => behaviorsPanel().locator(`.box[aria-label^="${path}"]`);

test("at the instant of the flip the graph marks the active state and the transition to it", async () => {
  await behaviorsPanel().locator(".box.active", { hasText: "correcting" }).waitFor();
  assert.equal(await behaviorsPanel().locator(".arrow.last").count(), 1);
  assert.match(await behaviorsPanel().locator(".arrow.last title").innerHTML(), /→ correcting: the mirrored pose won/);
  await behaviorsPanel().getByRole("heading", { name: "Transitions from correcting" }).waitFor();
});

test("open transitions show their dwell time and the values of the shown instant", async () => {
  // Conditions arrive five times a second, so those of the new state may be up to 0.2 s later than the flip.
  for (let i = 0; i < 6; ++i) await page.keyboard.press("ArrowRight");
  // A panel that is opened shows this instant at once, an open one may be drawn up to 0.2 s later.
  await page.keyboard.press("6");
  const evidence = await page.locator(".values tr", { hasText: "confidence.evidence" }).locator(".value").innerText();
  await page.keyboard.press("4");
  const rows = behaviorsPanel().locator(".transition");
  const wait = rows.filter({ hasText: "after min_time" });
  assert.match(await wait.locator(".dwell .value").innerText(), /^\d\.\d\d of 3\.00 s$/);
  const purge = rows.filter({ hasText: "the flip also mirrored correct particles" });
  const shown = await purge.locator(".reads > div", { hasText: "confidence.evidence" }).locator("dd").innerText();
  assert.equal(shown, evidence);
});

test("a click on a state lists its transitions, and Escape leads back step by step", async () => {
  await state("watching › confirmed").click();
  await behaviorsPanel().getByRole("heading", { name: "Transitions from watching › confirmed (not active)" }).waitFor();
  const rows = behaviorsPanel().locator(".transition");
  assert.deepEqual(await rows.locator(".target").allInnerTexts(), [
    "→ lifted",
    "→ fallen",
    "→ purging",
    "→ correcting",
    "→ watching › unconfirmed",
  ]);
  assert.match(await rows.nth(2).innerText(), /must hold for hold_time \(0\.2 s\)/);
  assert.equal(await behaviorsPanel().locator(".arrow.numbered").count(), 5);
  await page.keyboard.press("Escape");
  await behaviorsPanel().getByRole("heading", { name: "Transitions from correcting" }).waitFor();
  await page.keyboard.press("Escape");
  await behaviorsPanel().locator(".machine").nth(4).waitFor();
  await until(() => document.activeElement.textContent === "orientation");
  await page.keyboard.press("l");
});

test("behaviors, their states and their graph are used with the keyboard", async () => {
  await behaviorsPanel().locator(".machine .name", { hasText: "head scan" }).focus();
  await page.keyboard.press("Enter");
  await until(() => document.activeElement.textContent === "head scan");
  await state("walls to the left").focus();
  await page.keyboard.press(" ");
  await until(() => document.querySelector(".box[aria-pressed=true]") || document.querySelector(".box.active:focus"));
  await until(() => document.querySelector(".connection").textContent.startsWith("Live"));
  await behaviorsPanel().getByRole("button", { name: "graph" }).click();
  await behaviorsPanel().locator("svg").waitFor({ state: "detached" });
  await behaviorsPanel().getByRole("button", { name: "graph" }).click();
  await behaviorsPanel().locator("svg").waitFor();
});

test("the panel keeps its layout while frames arrive", async () => {
  await page.keyboard.press("Escape");
  if (await behaviorsPanel().locator(".machine").count() === 0) await page.keyboard.press("Escape");
  await behaviorsPanel().locator(".machine .name", { hasText: /^get up$/ }).click();
  await behaviorsPanel().locator("svg").waitFor();
  const positions = () =>
    behaviorsPanel().evaluate((panel) =>
      [...panel.querySelectorAll(".box, .transition, .reads dd, h3")].map((it) => {
        const { x, y, width, height } = it.getBoundingClientRect();
        return it.matches("dd") ? [y, height] : [x, y, width, height];
      }),
    );
  const before = await positions();
  assert.ok(before.length > 5);
  const shown = await shownTime();
  await until((was) => document.querySelector(".connection .value").textContent !== was, shown);
  assert.deepEqual(await positions(), before);
  await behaviorsPanel().getByRole("button", { name: "Show all behaviors" }).click();
});

test("a slider sends setParameters, and undo sets the value before", async () => {
  await page.keyboard.press("5");
  await page.locator("[data-panel=parameters] input[type=search]").fill("orientation.hold_time");
  const slider = page.locator('input[aria-label="orientation.hold_time as a slider"]');
  await slider.focus();
  await slider.press("End");
  const sent = await untilReceived((it) => it.op === "setParameters");
  assert.deepEqual(sent.parameters, [{ name: "orientation.hold_time", value: 10 }]);
  const box = page.locator('input[aria-label="orientation.hold_time"]');
  await until(() => document.querySelector(".facts").textContent.includes("from this page"));
  assert.equal(await box.inputValue(), "10");
  await page.getByRole("button", { name: "Undo" }).click();
  await untilReceived((it) => it.op === "setParameters" && it.parameters[0].value === 0.2);
  await slider.focus();
  for (let i = 0; i < 5; ++i) await slider.press("ArrowRight");
  await untilReceived((it) => it.op === "setParameters" && it.parameters[0].value === 0.25);
  for (let i = 0; i < 5; ++i) await page.getByRole("button", { name: "Undo" }).click();
  await until(() => document.querySelector('input[aria-label="orientation.hold_time"]').value === "0.2");
});

test("a list that is empty says why, with a way back to all parameters", async () => {
  const panel = page.locator("[data-panel=parameters]");
  await panel.locator("input[type=search]").fill("orientation.hold_time");
  await panel.getByRole("button", { name: /^changed/ }).click();
  await panel.getByText("No parameter differs from its default.").waitFor();
  await panel.getByRole("button", { name: "Show all parameters" }).click();
  await panel.locator(".parameter").nth(4).waitFor();
  assert.equal(await panel.locator("input[type=search]").inputValue(), "");
  await panel.locator("input[type=search]").fill("no such parameter");
  await panel.getByText(/^None of the \d+ parameters contains “no such parameter”/).waitFor();
  await panel.locator("input[type=search]").fill("orientation.hold_time");
});

test("a robot that cannot replay its frames says so at the button of the what-if", async () => {
  const button = page.locator("[data-panel=parameters]").getByRole("button", { name: "What if…" });
  assert.ok(await button.isDisabled());
  assert.match(await button.getAttribute("title"), /keeps no frames/);
});

test("a value that the robot refuses returns to the one in force, with a text", async () => {
  const box = page.locator('input[aria-label="orientation.hold_time"]');
  await box.fill("99");
  // The page is drawn again while the text is edited.
  const shown = await shownTime();
  await until((was) => document.querySelector(".connection .value").textContent !== was, shown);
  assert.equal(await box.inputValue(), "99");
  await box.press("Enter");
  await page.getByText("The robot uses 0.2 instead of 99.").waitFor();
  assert.equal(await box.inputValue(), "0.2");
  await page.keyboard.press("Escape");
});

test("Escape and texts that are no numbers leave a value unchanged", async () => {
  const box = page.locator('input[aria-label="orientation.hold_time"]');
  const sent = () => robot.received.filter((it) => it.op === "setParameters").length;
  const before = sent();
  await box.fill("7");
  await box.press("Escape");
  await until(() => document.querySelector('input[aria-label="orientation.hold_time"]').value === "0.2");
  for (const text of ["fast", "", "1e999"]) {
    await box.fill(text);
    await box.press("Enter");
    await until(() => document.querySelector('input[aria-label="orientation.hold_time"]').value === "0.2");
  }
  await page.keyboard.press("Escape");
  assert.equal(sent(), before);
});

test("a note reaches the robot and is a mark with its time", async () => {
  await page.keyboard.press("n");
  await page.locator("#note").waitFor();
  await until(() => document.activeElement?.id === "note");
  await page.keyboard.type("the lamp was switched on");
  await page.keyboard.press("Enter");
  const sent = await untilReceived((it) => it.op === "service" && it.name === "note");
  assert.equal(sent.request.text, "the lamp was switched on");
  await page.locator("[data-panel=notes] li", { hasText: "the lamp was switched on" }).waitFor();
  await page.keyboard.press("Escape");
});

test("a click on the timeline shows that instant in every panel while the robot continues", async () => {
  const box = await page.locator(".tracks").boundingBox();
  const [gutter, right] = [104, 10]; // pixels beside the time axis
  const end = Number.parseFloat(await shownTime());
  const from = Math.max(end - 60, Math.min(38, end - 10));
  const target = Math.min(44, end - 1); // a frame of the recording, which has images, also on a slow machine
  const x = gutter + ((target - from) / (end - from)) * (box.width - gutter - right);
  await page.mouse.click(box.x + x, box.y + 60);
  await page.getByText("View paused").waitFor();
  const time = await shownTime();
  await until((shown) => document.querySelector("figcaption").textContent.includes(shown), time);
  await page.keyboard.press("6");
  const clock = page.locator(".values tr", { hasText: "clock.time" }).locator(".value");
  assert.ok(Number.isFinite(Number(await clock.innerText())));
  const robotTime = () => page.locator(".connection .soft").innerText();
  const then = await robotTime();
  await until((text) => document.querySelector(".connection .soft").textContent !== text, then);
  assert.equal(await shownTime(), time);
});

test("keys step by frames and seconds, and return to live", async () => {
  const isEarlier = ([time, least, most]) => {
    const step = time - Number.parseFloat(document.querySelector(".connection .value").textContent);
    return step >= least && step <= most;
  };
  const time = Number.parseFloat(await shownTime());
  await page.keyboard.press("ArrowLeft");
  await until(isEarlier, [time, 0.02, 0.2]);
  await page.keyboard.press("Shift+ArrowLeft");
  await until(isEarlier, [time, 1, 1.4]);
  await page.keyboard.press("l");
  await until(() => document.querySelector(".connection").textContent.startsWith("Live"));
  await page.keyboard.press("?");
  await page.locator("dialog[open]").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("dialog").waitFor({ state: "detached" });
});

test("the key of a panel gives it the focus, so that Tab goes to its first control", async () => {
  await page.keyboard.press("7");
  await until(() => document.activeElement?.dataset.panel === "log");
  await page.keyboard.press("Tab");
  assert.ok(await page.evaluate(() => document.activeElement.closest("[data-panel=log]") !== null));
  await page.keyboard.press("Escape");
  await page.locator("summary", { hasText: "Panels" }).focus();
  await page.keyboard.press("Enter");
  await page.locator(".menu[open]").waitFor();
  await page.keyboard.press("Escape");
  await page.locator(".menu[open]").waitFor({ state: "detached" });
  await page.keyboard.press("1");
});

test("letters typed right after the key of the search are in its box, and replace the text in it", async () => {
  await page.keyboard.press("7");
  await page.locator("[data-panel=log] input[type=search]").waitFor();
  const box = page.locator("[data-panel=parameters] input[type=search]");
  await page.evaluate(() => {
    const press = (key) => document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    for (const key of "81/hold") press(key); // before anything is drawn; the panel of 8 has no search
  });
  await until(() => document.activeElement.value === "hold");
  await page.locator(".parameter", { hasText: "orientation.hold_time" }).waitFor();
  await page.keyboard.type("_t");
  assert.equal(await box.inputValue(), "hold_t");
  await page.keyboard.press("Escape");
  assert.equal(await box.inputValue(), "hold_t");
  await page.keyboard.type("/scan");
  assert.equal(await box.inputValue(), "scan");
  await page.keyboard.press("Escape");
});

test("a click on the field shows numbers", async () => {
  await page.locator("[data-panel=field] canvas").click({ position: { x: 200, y: 150 } });
  assert.match(await page.locator(".numbers").innerText(), /x −?\d+\.\d\d m, y −?\d+\.\d\d m/);
});

const scriptsPanel = (of = page) => of.locator("[data-panel=scripts]");
/// Waits until the robot has a text of the script.
const untilSaved = (text) => untilReceived(() => robot.scripts.get(SCRIPT) === text);

test("a click on a tile of the wall shows how well it matches the two poses", async () => {
  const canvas = page.locator("[data-panel=wall] .stage canvas");
  const { width, height } = await canvas.boundingBox();
  await canvas.click({ position: { x: 0.4 * width, y: 0.4 * height } });
  await page.locator("[data-panel=wall]").getByText(/^evidence .* of .* \((believed|mirrored|neither)\)/).waitFor();
  await page.locator("[data-panel=wall]").getByRole("button", { name: "Close the numbers" }).click();
  await page.locator(".tile-numbers").waitFor({ state: "detached" });
});

test("an edit of a script is checked while it is typed, saved with Ctrl-S, and refused at its line", async () => {
  await page.keyboard.press("0");
  await scriptsPanel().locator("input[type=search]").fill("orient");
  assert.equal(await scriptsPanel().locator(".files li").count(), 1);
  await scriptsPanel().getByRole("button", { name: SCRIPT }).click();
  await scriptsPanel().locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("-- tuned !!\n");
  await scriptsPanel().getByText("1:10 error: unexpected symbol").waitFor();
  await scriptsPanel().locator(".cm-lintRange-error").waitFor();
  assert.equal(await scriptsPanel().locator(".cm-editor").evaluate((it) => getComputedStyle(it).display), "flex");
  await page.keyboard.press("Control+s");
  await scriptsPanel().getByText("The run refused the edit and keeps the last good version").waitFor();
  assert.match(await scriptsPanel().locator(".fault b").innerText(), /^behaviors\/orientation\.lua:1$/);
  await scriptsPanel().locator(".cm-lintRange-error").waitFor();
  const { request } = await untilReceived((it) => it.name === "save_script");
  assert.equal(request.expected, 'behavior "orientation" {}\n');
});

test("the fix of a refused edit is running, also if another panel was shown before", async () => {
  await page.keyboard.press("Control+Home");
  await page.keyboard.press("Shift+End");
  await page.keyboard.type("-- tuned");
  await scriptsPanel().getByText("not saved").waitFor();
  await scriptsPanel().locator(".findings").waitFor({ state: "detached" });
  await page.getByRole("tab", { name: "Field" }).click();
  await page.getByRole("tab", { name: "Scripts" }).click();
  await scriptsPanel().getByRole("button", { name: "Save", exact: true }).click();
  await scriptsPanel().getByText("The edit is running since").waitFor();
  await untilSaved('-- tuned\nbehavior "orientation" {}\n');
});

test("an edit of another editor is noticed, and replaced only by choice", async () => {
  robot.scripts.set(SCRIPT, "-- theirs\n");
  await scriptsPanel().getByText("The editor shows the new text").waitFor();
  await scriptsPanel().locator(".cm-line", { hasText: "-- theirs" }).waitFor();
  await scriptsPanel().locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("-- mine\n");
  robot.scripts.set(SCRIPT, "-- theirs again\n");
  await page.keyboard.press("Control+s");
  await scriptsPanel().getByText("The file has changed on the disk").waitFor();
  assert.equal(robot.scripts.get(SCRIPT), "-- theirs again\n");
  await scriptsPanel().getByRole("button", { name: "Keep mine" }).click();
  await scriptsPanel().getByRole("button", { name: "Save", exact: true }).click();
  await untilSaved("-- mine\n-- theirs\n");
});

test("revert shows the text of the disk, and undo the edit", async () => {
  await scriptsPanel().locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("-- dropped\n");
  await scriptsPanel().getByRole("button", { name: "Revert" }).click();
  await scriptsPanel().locator(".cm-line", { hasText: "-- dropped" }).waitFor({ state: "detached" });
  await scriptsPanel().getByText("not saved").waitFor({ state: "detached" });
  await scriptsPanel().locator(".cm-content").click();
  await page.keyboard.press("Control+z");
  await scriptsPanel().locator(".cm-line", { hasText: "-- dropped" }).waitFor();
  await scriptsPanel().getByRole("button", { name: "Revert" }).click();
  await scriptsPanel().getByText("not saved").waitFor({ state: "detached" });
  await scriptsPanel().getByRole("button", { name: "‹ Scripts" }).click();
  await page.keyboard.press("1");
  await untilDrawn("[data-panel=field] canvas", 100);
});

test("an edit that is running changes the graph, and past instants keep the one of then", async () => {
  await page.keyboard.press("4");
  await behaviorsPanel().locator(".machine .name", { hasText: /^get up$/ }).click();
  await behaviorsPanel().locator("svg").waitFor();
  const shown = Number.parseFloat(await shownTime());
  const i = robot.machines.findIndex(({ name }) => name === "get_up");
  const edited = structuredClone(robot.machines[i]);
  edited.states.push({ ...edited.states.at(-1), path: "resting", name: "resting" });
  robot.machines[i] = edited;
  robot.log(2, "behaviors/get_up.lua", "the edit is running");
  await state("resting").waitFor();
  await page.evaluate(() => document.querySelector("#pause").click());
  for (let step = 0; step < 100 && (await state("resting").count()) > 0; ++step) await page.keyboard.press("Shift+ArrowLeft");
  assert.equal(await state("resting").count(), 0);
  assert.ok(Number.parseFloat(await shownTime()) < shown + 10);
  await page.keyboard.press("l");
  await state("resting").waitFor();
  await behaviorsPanel().getByRole("button", { name: "Show all behaviors" }).click();
});

test("a click on a fault opens the script at its line", async () => {
  const orientation = { name: "orientation", state: "lifted", seconds: 1, stopped: true, errors: 3 };
  robot.log(4, "note", `${SCRIPT}:1: attempt to index a nil value`, SCRIPT, 1);
  robot.broadcast("/machines", { machines: [orientation], published: [] });
  await page.keyboard.press("7");
  await page.locator(".log li", { hasText: "attempt to index a nil value" }).locator(".time").click();
  await page.keyboard.press("4");
  await behaviorsPanel().locator(".fault", { hasText: `${SCRIPT}:1` }).getByRole("button").click();
  await page.locator("[data-panel=scripts] .script-name", { hasText: SCRIPT }).waitFor();
  await page.locator("[data-panel=scripts] .cm-content").waitFor();
  await page.locator("[data-panel=scripts]").getByRole("button", { name: "‹ Scripts" }).click();
  await page.keyboard.press("1");
  await page.keyboard.press("l");
});

test("drops that the robot reports are shown", async () => {
  robot.report(1, "Send buffer limit reached");
  await page.getByText("1× messages dropped").waitFor();
  robot.report(2, "the recorder has stopped");
  await page.getByText("the recorder has stopped").waitFor();
});

test("reduced rates are shown with their cause until nothing is left out", async () => {
  robot.report(1, "busy computer: 6 of 30 frames, 1 of 30 images a second", "slow");
  await page.locator(".connection").getByText("busy computer: 6 of 30 frames").waitFor();
  robot.report(1, "slow connection or busy viewer: 9 of 30 frames, 0 of 30 images a second", "slow");
  await page.locator(".connection").getByText(/^(slow connection or busy computer|busy browser): 9 of 30 frames/).waitFor();
  assert.equal(await page.getByText("6 of 30 frames").count(), 0);
  robot.removeReport("slow");
  await page.getByText("9 of 30 frames").waitFor({ state: "detached" });
});

test("damaged messages of the robot are reported, and the page continues", async () => {
  for (const socket of robot.clients.keys()) {
    socket.send("{");
    socket.send(JSON.stringify({ op: "an operation of a later version" }));
    socket.send(Buffer.from([1, 2, 3]));
    socket.send(Buffer.alloc(0));
    socket.send(JSON.stringify({ op: "parameterValues", parameters: [{}, null] }));
    socket.send(JSON.stringify({ op: "unadvertiseServices", serviceIds: [3] }));
  }
  await page.getByText("3 messages could not be read or drawn").waitFor();
  await page.keyboard.press("8");
  await page.locator("#note").waitFor({ state: "detached" }); // the service was removed
  const time = await shownTime();
  await until((was) => document.querySelector(".connection .value").textContent !== was, time);
});

test("messages that do not fit their schema disturb only the panels that show them", async () => {
  await page.keyboard.press("4");
  for (const topic of ["/machines", "/percepts", "/wall", "/room", "/belief/particles", "/camera/upper/annotations", "/log"])
    for (const value of [{}, null, 3, { machines: [{}], entities: [{}], poses: [{}] }]) robot.broadcast(topic, value);
  robot.broadcast("/world", { pose: "nowhere", confidence: { evidence: "much", status: 7 }, robot: null });
  robot.broadcast("/world", null);
  await page.getByText("messages could not be read or drawn").waitFor();
  const time = await shownTime();
  await until((was) => document.querySelector(".connection .value").textContent !== was, time);
  await page.keyboard.press("6");
  await page.locator(".values tr").nth(20).waitFor();
  await page.keyboard.press("4");
  await page.locator(".machine").nth(4).waitFor();
});

test("damaged settings of the browser are replaced by the defaults", async () => {
  const damaged = {
    span: 0,
    machines: [1, null, "orientation"],
    layers: 3,
    theme: null,
    areas: { field: "nowhere" },
    x: 1,
  };
  await page.evaluate((value) => localStorage.setItem("reorient.live.1", JSON.stringify(value)), damaged);
  await page.reload();
  await untilDrawn("[data-panel=timeline] .bands canvas", 20);
  await page.locator("summary").click();
  await page.getByRole("button", { name: "Reset the layout" }).click();
  await untilDrawn("[data-panel=field] canvas", 100);
  await page.evaluate(() => localStorage.setItem("reorient.live.1", "{"));
  await page.reload();
  await untilDrawn("[data-panel=field] canvas", 100);
});

test("layers and layout survive that the page is loaded again", async () => {
  await page.getByRole("button", { name: "particles" }).click();
  await page.locator("[data-panel=wall] .move").selectOption("left");
  await page.locator("[data-area=left][data-panel=wall]").waitFor();
  await page.reload();
  await page.locator("[data-area=left][data-panel=wall]").waitFor();
  await page.keyboard.press("1");
  assert.equal(await page.getByRole("button", { name: "particles" }).getAttribute("aria-pressed"), "false");
  await page.locator("summary").click();
  await page.getByRole("button", { name: "Reset the layout" }).click();
  await page.locator("[data-area=below][data-panel=wall]").waitFor();
  await page.locator("summary").click();
});

test("no message of the console is a warning or an error", () => {
  const isOfTest = (text) => text.includes("willReadFrequently"); // untilDrawn reads canvases
  assert.deepEqual(messages.filter((text) => !isOfTest(text)), []);
});

test("the page says that the robot is gone, keeps its data, and connects again by itself", async () => {
  await until(() => document.querySelector(".connection").textContent.startsWith("Live"));
  robot.note("before the robot was gone");
  await page.keyboard.press("8");
  const note = page.locator("[data-panel=notes] li", { hasText: "before the robot was gone" });
  await note.waitFor();
  await robot.stop();
  await page.getByText("The robot is gone for").waitFor();
  await page.keyboard.press("4");
  await behaviorsPanel().locator(".machine .name", { hasText: "kidnap recovery" }).click(); // not shown before
  await behaviorsPanel().getByText("The robot is gone. The page connects again by itself.").waitFor();
  await behaviorsPanel().getByRole("button", { name: "Show all behaviors" }).click();
  await page.keyboard.press("8");
  await robot.start(robot.port);
  await until(() => document.querySelector(".connection").textContent.startsWith("Live"));
  const time = await shownTime();
  await until((was) => document.querySelector(".connection .value").textContent !== was, time);
  assert.equal(await note.count(), 1);
});

test("the data of another run replaces that of the one before", async () => {
  const note = page.locator("[data-panel=notes] li", { hasText: "before the robot was gone" });
  assert.equal(await note.count(), 1);
  ++robot.session;
  await robot.stop();
  robot.rewind();
  await robot.start(robot.port);
  await note.waitFor({ state: "detached" });
  await until(() => document.querySelector(".connection").textContent.startsWith("Live"));
});

test("the audience sees field, wall and one sentence, and can change nothing", async () => {
  for (const [path, links] of [["audience", 0], ["audience?token=1", 1], ["#audience", 1]]) {
    const audience = await open({ viewport: { width: 1280, height: 720 } }, path);
    await untilDrawn(".audience canvas", 100, audience);
    await audience.waitForFunction(() => document.querySelector(".thought").textContent.startsWith("The r"));
    assert.equal(await audience.locator(".audience button, .audience input, .audience select").count(), 0);
    const before = robot.received.length;
    for (const key of ["u", "p", ".", "n", "5", "?"]) await audience.keyboard.press(key);
    assert.equal(robot.received.length, before);
    assert.equal(await audience.locator("dialog").count(), 0);
    const back = audience.getByRole("link", { name: "Back to the page" });
    assert.equal(await back.count(), links, path);
    if (links) {
      await back.click();
      await audience.locator("[data-panel=timeline]").waitFor();
      assert.ok(path.startsWith("#") || audience.url().endsWith("/?token=1"));
    }
    await audience.close();
  }
});

test("a page that may change nothing says why, and offers nothing that changes something", async () => {
  robot.refusal = "to change something, open the link with the token";
  const watcher = await open({ viewport: { width: 1366, height: 768 } }, "?token=1");
  await untilDrawn("[data-panel=field] canvas", 100, watcher);
  await watcher.keyboard.press("8");
  await watcher.getByRole("region", { name: "Notes" }).getByText(robot.refusal).waitFor();
  assert.equal(await watcher.locator("#note").count(), 0);
  await watcher.keyboard.press("5");
  await watcher.locator(".parameter input[type=range]").first().waitFor();
  assert.ok(await watcher.locator(".parameter input[type=range]").first().isDisabled());
  assert.ok(await watcher.getByRole("button", { name: "Undo" }).isDisabled());
  await watcher.keyboard.press("0");
  await scriptsPanel(watcher).getByRole("button", { name: SCRIPT }).click();
  await scriptsPanel(watcher).getByText(`Read-only: ${robot.refusal}`).waitFor();
  await scriptsPanel(watcher).locator(".cm-content").click();
  await watcher.keyboard.type("typed");
  assert.equal(await scriptsPanel(watcher).getByRole("button", { name: "Save" }).count(), 0);
  assert.equal(await scriptsPanel(watcher).locator(".cm-line", { hasText: "typed" }).count(), 0);
  assert.equal(robot.paths.at(-1), "/?token=1");
  robot.refusal = "";
  await watcher.close();
});

test("a phone shows every area without a horizontal scroll bar", async () => {
  const phone = await open({ viewport: { width: 390, height: 844 }, hasTouch: true });
  await untilDrawn("[data-panel=field] canvas", 100, phone);
  assert.equal(await phone.locator(".area").count(), 5);
  assert.equal(await phone.evaluate(() => document.documentElement.scrollWidth), 390);
  await phone.close();
});

test("on a phone the badges of body parts, the state and its time stay in the row of their behavior", async () => {
  const phone = await open({ viewport: { width: 390, height: 844 }, hasTouch: true });
  const parts = ["head", "legs", "arms"].map((part) => ({ part, outranked_by: "approach_ball" }));
  const state = "returning to the own goal/walking";
  const machine = { name: "goalkeeper", state, seconds: 1, stopped: false, errors: 0, parts };
  const timer = setInterval(() => robot.broadcast("/machines", { machines: [machine], published: [] }), 20);
  const boxes = await phone.waitForFunction(() => {
    const row = document.querySelector(".machine:has(.part.lost) .row");
    return row && [...row.children].map((it) => it.getBoundingClientRect()).map(({ top, right, width }) => [top, right, width]);
  });
  clearInterval(timer);
  const found = await boxes.jsonValue();
  assert.equal(found.length, 4, "name, state, parts and time");
  assert.ok(found.every(([top, right, width]) => Math.abs(top - found[0][0]) < 8 && right <= 384 && width > 20), `${found}`);
  await phone.close();
});
