// SPDX-License-Identifier: MIT
// replay_test.mjs PROGRAM FOLDER: uses the page in chromium (CHROMIUM) on the replay of a recording, which is made in
// FOLDER. Each test waits until something is seen, never for a fixed time.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { readRecording } from "../../../workbench/views/live/page/dev/recording.mjs";
import { launch, linkOf, openPage } from "./browser.mjs";

const [program, folder] = process.argv.slice(2);
const file = join(folder, "short.mcap");
const SECONDS = 14;
const FRAME = 1 / 30; // s

let browser, page, replay;
let received = 0; // s, a frame that the page has received
const messages = []; // of the console
const worlds = []; // [s, world] of the recording

before(async () => {
  const run = ["run", "--width", "160", "--seconds", String(SECONDS), "--no-pictures", "--record", file];
  try {
    execFileSync(program, ["--log", "off", ...run], { stdio: "ignore" });
  } catch (error) {
    assert.equal(error.status, 1); // the scenario does not end in this time
  }
  const { channels, messages: all } = await readRecording(file);
  const { id } = channels.find(({ topic }) => topic === "/world");
  for (const { channel, time, data } of all)
    if (channel === id) worlds.push([1e-9 * Number(time), JSON.parse(Buffer.from(data).toString())]);
  replay = spawn(program, ["--log", "off", "replay", file, "--live", "0"], { stdio: ["ignore", "ignore", "pipe"] });
  const link = await linkOf(replay);
  browser = await launch();
  page = await openPage(browser, { viewport: { width: 1366, height: 768 } }, link, messages);
});
after(async () => {
  await browser?.close();
  replay?.kill("SIGKILL");
});

const bar = () => page.getByLabel("Time of the recording");
const shownTime = async () => Number.parseFloat(await page.locator(".connection .value").first().innerText());
/// Waits until the shown time is in a range of s.
const untilShown = (least, most) =>
  page.waitForFunction(
    ([from, to]) => {
      const time = Number.parseFloat(document.querySelector(".connection .value")?.textContent);
      return time >= from && time <= to;
    },
    [least, most],
  );

/// Waits until header, timeline, wall, camera and table of the world show the same frame of the recording, whose time is
/// between `least` and `most` s. Returns its time in s.
async function untilFrameIsBetween(least, most) {
  const within = worlds.filter(([at]) => at >= least - 0.005 && at <= most + 0.005);
  const evidences = within.map(([at, world]) => [at.toFixed(2), world.confidence.evidence.toFixed(1)]);
  const shown = await page.waitForFunction((them) => {
    const textOf = (selector) => document.querySelector(selector)?.textContent.replaceAll("−", "-") ?? "";
    const row = [...document.querySelectorAll(".values tr")].find((it) => it.textContent.includes("clock.time"));
    const clock = Number(row?.querySelector(".value").textContent);
    return them.find(
      ([at, evidence]) =>
        textOf(".connection .value") === `${at} s` &&
        textOf("figcaption") === `Upper, ${at} s` &&
        textOf(".readout").includes(`evidence ${evidence.replace("-0.0", "0.0")}`) &&
        textOf(".evidence .value").startsWith(evidence.replace("-0.0", "0.0")) &&
        Math.abs(clock - Number(at)) < 0.006,
    );
  }, evidences);
  return Number((await shown.jsonValue())[0]);
}
const untilFrameIs = (time, tolerance = 1.5 * FRAME) => untilFrameIsBetween(time - tolerance, time + tolerance);

test("a replay shows its frames, and a bar over the whole recording", async () => {
  await page.locator(".connection", { hasText: "Replay" }).waitFor();
  await page.locator(".recording", { hasText: `of ${SECONDS}.00 s` }).waitFor();
  await page.keyboard.press("6"); // the table of the world
  await untilShown(1, SECONDS);
});

test("a paused replay shows one frame in every panel", async () => {
  await page.keyboard.press("p");
  await page.getByText("Replay paused").waitFor();
  received = await untilFrameIsBetween(0, SECONDS); // frames on their way are still shown after the pause
});

test("the bar moves a replay forwards and backwards, and every panel shows that frame", async () => {
  for (const time of [13, 9]) {
    await bar().fill(String(time));
    await untilFrameIs(time);
    await page.getByText("Replay paused").waitFor();
  }
});

test("received frames are shown without a seek, also frame by frame", async () => {
  await bar().fill(String(received));
  await page.getByText("View paused").waitFor();
  await untilFrameIs(received);
  const before = await shownTime();
  await page.locator("body").press("Escape"); // leaves the bar
  await page.keyboard.press("ArrowLeft");
  await untilShown(before - 1, before - 0.5 * FRAME); // a busy computer leaves out frames
  await page.keyboard.press("ArrowRight");
  await untilFrameIs(before, 0.5 * FRAME);
});

test("a replay plays from the shown instant, and pauses", async () => {
  await page.getByRole("button", { name: "Play from here" }).click();
  await page.locator(".connection", { hasText: "Replay" }).waitFor();
  await untilShown(received + 0.2, SECONDS - 1);
  await page.getByRole("button", { name: "Pause", exact: true }).click();
  await page.getByText("Replay paused").waitFor();
  const paused = await untilFrameIsBetween(0, SECONDS);
  assert.ok(paused < 8.9, `expected a time before that of the last seek, found ${paused}`);
});

test("a faster replay ends at the end of the recording, and plays again from the start", async () => {
  await page.getByLabel("Speed of the replay").selectOption("20");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await page.getByText("End of the recording").waitFor();
  assert.equal(await page.getByLabel("Speed of the replay").inputValue(), "20");
  await untilFrameIs(SECONDS);
  await page.getByLabel("Speed of the replay").selectOption("1");
  await page.getByRole("button", { name: "Play", exact: true }).click();
  await untilShown(0, 3);
});

test("the console has no message", () => {
  assert.deepEqual(messages, []);
});
