// SPDX-License-Identifier: MIT
// The images of the cameras, each with the annotations of exactly that image.
import { useRef } from "preact/hooks";

import { drawAnnotations } from "../draw/annotations.js";
import { Canvas } from "../draw/canvas.jsx";
import { drawNote } from "../draw/field.js";
import { seconds } from "../format.js";
import { store } from "../robot.js";
import { set, settings } from "../settings.js";
import { changed, useChanges } from "../ticker.js";

const CAMERAS = [
  ["upper", "Upper"],
  ["lower", "Lower"],
];
const SAME = 1e-4; // s, between the timestamps of an image and of its annotations

/// Decodes the newest requested image, one at a time.
class Decoder {
  part = null; // of the bitmap
  bitmap = null;
  wanted = null;
  busy = false;

  request(found) {
    this.wanted = found;
    if (this.busy || found.part === this.part?.part) return;
    this.busy = true;
    createImageBitmap(new Blob([found.part.bytes], { type: `image/${found.part.format}` }))
      .then(
        (bitmap) => {
          this.bitmap?.close();
          this.bitmap = bitmap;
          this.part = found;
        },
        () => {
          this.part = found; // a damaged image: the one before stays
        },
      )
      .finally(() => {
        this.busy = false;
        if (this.wanted !== this.part) this.request(this.wanted);
        changed();
      });
  }
}

function annotationsOf(camera, shown) {
  const index = store.indexAt(shown.time);
  const part = store.frames[index]?.parts[`/camera/${camera}/annotations`];
  if (!part) return null;
  const message = store.parse(part);
  const time = message.timestamp.sec + 1e-9 * message.timestamp.nsec;
  return Math.abs(time - shown.part.time) < SAME ? message : null;
}

function Camera({ camera, name }) {
  const decoder = useRef(null);
  decoder.current ??= new Decoder();
  const caption = useRef(null);
  const draw = (context, width, height) => {
    const found = store.latest(`/camera/${camera}/image`, store.isLive ? 5 : 2.1);
    if (!found) {
      caption.current.textContent = name;
      return drawNote(context, store.isLive ? "No image yet." : "No image of this instant any more.", width, height);
    }
    decoder.current.request(found);
    const { bitmap, part } = decoder.current;
    if (!bitmap) return;
    const scale = Math.min(width / bitmap.width, height / bitmap.height);
    context.translate((width - scale * bitmap.width) / 2, (height - scale * bitmap.height) / 2);
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, scale * bitmap.width, scale * bitmap.height);
    context.beginPath();
    context.rect(0, 0, scale * bitmap.width, scale * bitmap.height);
    context.clip();
    const annotations = settings.annotations && annotationsOf(camera, part);
    if (annotations) drawAnnotations(context, annotations, scale);
    const shown = store.shown()?.time ?? part.time;
    const late = shown - part.time;
    const age = late > 0.1 ? ` (${seconds(late)} old)` : "";
    caption.current.textContent = `${name}, ${seconds(part.time)}${age}`;
  };
  return (
    <figure class="camera">
      <Canvas draw={draw} label={`Image of the ${camera} camera with detections`} />
      <figcaption ref={caption}>{name}</figcaption>
    </figure>
  );
}

function Cameras() {
  useChanges(500);
  const present = CAMERAS.filter(
    ([camera]) => store.lasting.has(`/camera/${camera}/calibration`) || store.latest(`/camera/${camera}/image`, 600),
  );
  const shown = present.length ? present : CAMERAS.slice(0, 1);
  return (
    <div class="fill cameras">
      {shown.map(([camera, name]) => (
        <Camera key={camera} camera={camera} name={name} />
      ))}
      <button
        class="chip over"
        aria-pressed={settings.annotations}
        title="Cyan: detected. Blue: expected at the believed pose."
        onClick={() => set({ annotations: !settings.annotations })}
      >
        overlay
      </button>
    </div>
  );
}

export default { id: "cameras", title: "Cameras", area: "middle", key: "3", Component: Cameras };
