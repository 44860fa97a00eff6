// SPDX-License-Identifier: MIT
// build.mjs [FOLDER]: makes index.html, live.js, live.css and editor.js from source/ in FOLDER (default: built/ beside this
// file). The result depends only on the sources and on package-lock.json.
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { load, packages } from "./packages.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2] ?? join(here, "built"));
const esbuild = load("esbuild");

/// The packages whose code is in a file of the result, by name.
function packagesIn(output) {
  const names = Object.entries(output.inputs)
    .filter(([, { bytesInOutput }]) => bytesInOutput > 0)
    .map(([path]) => /.*node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1])
    .filter((name) => name !== undefined);
  return [...new Set(names)].sort();
}

/// Name, version and license text of a library whose code is in the result.
function notice(name) {
  const { version, homepage } = JSON.parse(readFileSync(join(packages, name, "package.json"), "utf8"));
  const license = readFileSync(join(packages, name, "LICENSE"), "utf8").trim();
  return `${name} ${version}${homepage ? `, ${homepage}` : ""}\n\n${license}`;
}

const banner = (names) => `/*! The page of Reorient's live view. SPDX-License-Identifier: MIT
Made by workbench/views/live/page/build.mjs; do not edit. It contains:

${names.map(notice).join("\n\n")}
*/
`;

mkdirSync(out, { recursive: true });

/// Builds files that begin with the licenses of what they contain.
async function build(options) {
  const { outputFiles, metafile } = await esbuild.build({
    absWorkingDir: here,
    outdir: out,
    bundle: true,
    minify: true,
    charset: "utf8",
    target: ["es2022"],
    jsx: "automatic",
    jsxImportSource: "preact",
    nodePaths: [packages],
    legalComments: "none",
    logLevel: "warning",
    write: false,
    metafile: true,
    ...options,
  });
  const all = new Map(Object.entries(metafile.outputs).map(([path, output]) => [basename(path), output]));
  for (const { path, text } of outputFiles)
    writeFileSync(path, banner(packagesIn(all.get(basename(path)))) + text);
}

// The editor of scripts is large, so the page loads it only when a script is opened.
await build({ entryPoints: { live: "source/main.jsx" }, format: "iife" });
// ASCII, because it names control characters of bidirectional text, which compilers refuse in a source.
await build({ entryPoints: { editor: "source/scripts/editor.js" }, format: "esm", charset: "ascii" });
copyFileSync(join(here, "source/index.html"), join(out, "index.html"));
