// SPDX-License-Identifier: MIT
// Finds the packages of npm: in the folder NODE_FOLDER, beside package.json (npm ci), or where tools/node-modules
// installs them.
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const page = dirname(fileURLToPath(import.meta.url));

function folderOfPackages() {
  if (process.env.NODE_FOLDER) return process.env.NODE_FOLDER;
  if (existsSync(join(page, "node_modules"))) return page;
  const tool = join(page, "../../../../tools/node-modules");
  return execFileSync(tool, ["workbench/views/live/page"], { encoding: "utf8" }).trim();
}

/// The folder node_modules.
export const packages = join(folderOfPackages(), "node_modules");

/// Loads a package, as require() does.
export const load = createRequire(join(packages, "packages.js"));
