// SPDX-License-Identifier: MIT
// build.mjs [FOLDER]: makes index.html, live.js and live.css from source/ in FOLDER (default: built/ beside this
// file). The result depends only on the sources and on package-lock.json.
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { load, packages } from "./packages.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2] ?? join(here, "built"));
const esbuild = load("esbuild");

/// Name, version and license text of a library whose code is in the result.
function notice(name) {
  const { version, homepage } = JSON.parse(readFileSync(join(packages, name, "package.json"), "utf8"));
  const license = readFileSync(join(packages, name, "LICENSE"), "utf8").trim();
  return `${name} ${version}${homepage ? `, ${homepage}` : ""}\n\n${license}`;
}

const banner = `/*! The page of Reorient's live view. SPDX-License-Identifier: MIT
Made by workbench/views/live/page/build.mjs; do not edit. It contains:

${["preact", "uplot"].map(notice).join("\n\n")}
*/`;

mkdirSync(out, { recursive: true });
await esbuild.build({
  absWorkingDir: here,
  entryPoints: { live: "source/main.jsx" },
  outdir: out,
  bundle: true,
  minify: true,
  charset: "utf8",
  format: "iife",
  target: ["es2022"],
  jsx: "automatic",
  jsxImportSource: "preact",
  nodePaths: [packages],
  legalComments: "none",
  banner: { js: banner, css: banner },
  logLevel: "warning",
});
copyFileSync(join(here, "source/index.html"), join(out, "index.html"));
