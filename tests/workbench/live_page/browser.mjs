// SPDX-License-Identifier: MIT
// The browser of the tests, and what several of them wait for.
import { createInterface } from "node:readline";

import { load } from "../../../workbench/views/live/page/packages.mjs";

const { chromium } = load("playwright-core");

export const PATIENCE = 120_000; // ms, on a slow machine

export const launch = () =>
  chromium.launch({ executablePath: process.env.CHROMIUM, args: ["--no-sandbox", "--disable-dev-shm-usage"] });

/// The link that a program with --live prints. Its standard error must be a pipe.
export const linkOf = (process) =>
  new Promise((resolve, reject) => {
    createInterface(process.stderr).on("line", (line) => {
      const found = line.match(/live view: (\S+)/);
      if (found) resolve(found[1]);
    });
    process.on("exit", (code) => reject(new Error(`expected a link, found the exit code ${code}`)));
  });

/// A page whose errors and warnings are added to `messages`, those of the Content-Security-Policy among them.
export async function openPage(browser, options, url, messages) {
  const context = await browser.newContext(options);
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) messages.push(message.text());
  });
  page.on("pageerror", (error) => messages.push(`${error.message}\n${error.stack}`));
  await page.goto(url);
  return page;
}

/// Waits until the panels with tables are filled.
export async function untilListed(page) {
  for (const [key, panel, row] of [
    ["4", "behaviors", ".machine"],
    ["5", "parameters", ".parameter"],
    ["6", "world", ".values tr"],
  ]) {
    await page.keyboard.press(key);
    await page.locator(`[data-panel=${panel}] ${row}`).nth(4).waitFor();
  }
}
