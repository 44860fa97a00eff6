// SPDX-License-Identifier: MIT
// pictures.mjs FOLDER: takes the pictures of docs/live-page.md in FOLDER: runs the default scenario with the program
// REORIENT, and uses the page in chromium (CHROMIUM). It takes about three minutes. The pictures show 43.37 s, one frame
// before the flip.
import { spawn } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { launch, linkOf, openPage } from "../../../../../tests/workbench/live_page/browser.mjs";

const SHOWN = "43.37 s";
const PATIENCE = 600_000; // ms, on a busy computer
const LAPTOP = { width: 1366, height: 768 };
const program = process.env.REORIENT ?? "reorient";
const out = resolve(process.argv[2] ?? ".");
mkdirSync(out, { recursive: true });

const copy = mkdtempSync(join(tmpdir(), "pictures-"));
const top = join(dirname(fileURLToPath(import.meta.url)), "../../../../..");
cpSync(join(top, "scripts"), join(copy, "scripts"), { recursive: true }); // one of them is edited
const options = ["--scripts", join(copy, "scripts"), "--seconds", "600", "--no-pictures", "--live-memory", "1024"];
const run = spawn(program, ["--log", "off", "run", "--live", "0", ...options], {
  cwd: copy,
  stdio: ["ignore", "ignore", "pipe"],
});
const link = await linkOf(run);
const browser = await launch();
const messages = [];
const page = await openPage(browser, { viewport: LAPTOP, colorScheme: "light" }, link, messages);
page.setDefaultTimeout(PATIENCE);

// Reduced rates on a busy computer are not the subject of the pictures.
await page.evaluate(() => {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(
    ".connection .badge { display: none !important; } .connection { min-width: 0 !important; flex: none !important; }",
  );
  document.adoptedStyleSheets = [sheet];
});

const panel = (name) => page.locator(`[data-panel=${name}]`);
const timeOf = async () => Number.parseFloat(await page.locator(".connection .value").first().innerText());
/// Two frames of the display, so that everything is drawn.
const drawn = () => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 400))));
async function take(name, of = page) {
  await drawn();
  await of.screenshot({ path: join(out, `live-${name}.png`) });
  console.log(`live-${name}.png`);
}
const key = (name) => page.keyboard.press(name);
const untilTime = (least) =>
  page.waitForFunction(
    (time) => Number.parseFloat(document.querySelector(".connection .value")?.textContent) >= time,
    least,
  );

/// Presses a key that moves the view to another instant, and waits until it is shown.
async function step(name) {
  const before = await timeOf();
  await key(name);
  await page.waitForFunction(
    (time) => Number.parseFloat(document.querySelector(".connection .value")?.textContent) !== time,
    before,
  );
}

/// Shows the instant of the pictures.
async function showInstant() {
  await key("Space");
  await page.locator(".connection", { hasText: "View paused" }).waitFor();
  while ((await timeOf()) > Number.parseFloat(SHOWN) + 1.1) await step("Shift+ArrowLeft");
  while ((await timeOf()) > Number.parseFloat(SHOWN) + 0.01) await step("ArrowLeft");
  const found = await page.locator(".connection .value").first().innerText();
  if (found !== SHOWN) throw new Error(`expected the frame at ${SHOWN}, found that at ${found}; the computer is too busy`);
}

async function takeInstant() {
  const speed = page.getByLabel("Speed of the run");
  for (const [factor, until] of [
    ["0.5", 42.5],
    ["0.1", 44], // so that a busy computer leaves out no frame near the instant
    ["1", 57],
  ]) {
    await speed.selectOption(factor);
    await untilTime(until);
  }
  await page.locator("body").press("Escape"); // leaves the list
  await showInstant();
  await takeWhatIf();
  await key("4");
  await panel("what_if").getByRole("tab", { name: "Field" }).click();
  await take("page");
  await key("t");
  await key("t");
  await take("page-dark");
  await page.setViewportSize({ width: 390, height: 844 });
  await take("phone");
  await page.setViewportSize(LAPTOP);
  await key("t");
  await key("t");
  await key("a");
  await take("audience");
  await page.getByText("Back to the page").click();
  await page.setViewportSize({ width: 1920, height: 1080 });
  await key("4");
  await panel("behaviors").getByRole("button", { name: "orientation" }).click();
  await take("behaviors", panel("behaviors"));
  await panel("behaviors").getByRole("button", { name: "Show all behaviors" }).click();
}

async function takeWhatIf() {
  await page.setViewportSize({ width: 1366, height: 940 });
  await key("5");
  await panel("parameters").locator("input[type=search]").fill("orientation.hold_time");
  await panel("parameters").getByRole("button", { name: "What if…" }).click();
  const box = page.locator('input[aria-label="orientation.hold_time"]');
  await box.fill("2");
  await box.press("Enter");
  await page.locator(".verdict").waitFor();
  await take("what-if");
  await panel("parameters").getByRole("button", { name: "End what-if" }).click();
  await key("Escape"); // leaves the box
  await page.setViewportSize(LAPTOP);
}

async function takeScripts() {
  await key("Escape");
  await key("0");
  await panel("scripts").getByText("behaviors/get_up.lua").first().click();
  await page.locator(".cm-content").waitFor();
  await page.locator(".cm-line", { hasText: "priority" }).first().click();
  await key("End");
  await page.keyboard.type(" )");
  await key("Control+s");
  await page.getByText("The run refused the edit").first().waitFor();
  await page.locator(".cm-lint-marker").first().waitFor();
  await page.locator(".cm-scroller").evaluate((it) => (it.scrollLeft = 0)); // the click has moved the text sideways
  await take("scripts", panel("scripts"));
}

async function takeParameters() {
  await panel("scripts").locator(".tabs [role=tab]").first().click();
  await key("5");
  await panel("parameters").locator("input[type=search]").fill("orientation.");
  const slider = page.locator('input[aria-label="orientation.lingering as a slider"]');
  await slider.focus();
  for (let i = 0; i < 20; ++i) await slider.press("ArrowRight");
  await panel("parameters").getByText("from this page").waitFor();
  await take("parameters", panel("parameters"));
}

try {
  await takeInstant();
  await key("l");
  await takeScripts();
  await takeParameters();
} finally {
  await browser.close();
  run.kill("SIGINT");
  rmSync(copy, { recursive: true, force: true });
}
if (messages.length) console.error(messages.join("\n"));
