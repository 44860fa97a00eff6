// SPDX-License-Identifier: MIT
// serve.mjs RECORDING [PORT] [FROM] [SPEED]: serves the built page and replays a recording of `reorient run --record`
// from FROM s on. REORIENT: the program that lists parameters and machines.
import { execFileSync } from "node:child_process";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { parseParameters, readRecording } from "./recording.mjs";
import { Robot, readScripts } from "./robot.mjs";

const [file, port = "8765", from = "0", speed = "1"] = process.argv.slice(2);
if (!file) {
  console.error("usage: serve.mjs RECORDING [PORT] [FROM] [SPEED]");
  process.exit(2);
}
const here = dirname(fileURLToPath(import.meta.url));
const folder = join(here, "../built");
const scripts = readScripts(join(here, "../../../../../scripts"));
const program = process.env.REORIENT;
const parameters = program ? parseParameters(execFileSync(program, ["params"], { encoding: "utf8" })) : [];
const behaviors = [...scripts.keys()].filter((file) => file.startsWith("behaviors/"));
const graph = program && execFileSync(program, ["graph", ...behaviors, "--format", "json"], { encoding: "utf8" });
const machines = graph ? JSON.parse(graph).machines : [];
const recording = await readRecording(file);
// A recording lacks the topics that had no message.
for (const [topic, schemaName] of [
  ["/log", "foxglove.Log"],
  ["/events", "reorient.Event"],
]) {
  if (recording.channels.some((it) => it.topic === topic)) continue;
  const id = 1 + Math.max(...recording.channels.map((it) => it.id));
  recording.channels.push({ id, topic, encoding: "json", schemaName, schemaEncoding: "jsonschema", schema: "{}" });
}
const robot = new Robot({ recording, folder, parameters, from: Number(from), speed: Number(speed), scripts, machines });
await robot.start(Number(port));
console.log(`http://localhost:${robot.port}/`);
