// SPDX-License-Identifier: MIT
// Finds the packages of npm: in the folder NODE_FOLDER, or beside package.json.
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const page = resolve(dirname(fileURLToPath(import.meta.url)), "..");

export const load = createRequire(join(process.env.NODE_FOLDER ?? page, "packages.js"));
