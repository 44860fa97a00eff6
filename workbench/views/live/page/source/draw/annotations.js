// SPDX-License-Identifier: MIT
// Draws foxglove.ImageAnnotations on an image.
import { css } from "./palette.js";

const POINTS = 1;
const LINE_LOOP = 2;
const LINE_LIST = 4;
const THINNEST = 1.2; // pixels of the screen

/// `scale`: pixels of the canvas in a pixel of the image. (0, 0) is the center of the top left pixel of the image.
export function drawAnnotations(context, { circles, points, texts }, scale) {
  const at = ({ x, y }) => [(x + 0.5) * scale, (y + 0.5) * scale];
  for (const { type, points: all, outline_color: outline, fill_color: fill, thickness } of points) {
    if (type === POINTS) {
      context.fillStyle = css(outline);
      for (const point of all) {
        context.beginPath();
        context.arc(...at(point), Math.max(1.5, (thickness * scale) / 2), 0, 2 * Math.PI);
        context.fill();
      }
      continue;
    }
    context.beginPath();
    all.forEach((point, i) => {
      if (i === 0 || (type === LINE_LIST && i % 2 === 0)) context.moveTo(...at(point));
      else context.lineTo(...at(point));
    });
    if (type === LINE_LOOP) context.closePath();
    if (fill.a > 0) {
      context.fillStyle = css(fill);
      context.fill();
    }
    context.lineWidth = Math.max(THINNEST, thickness * scale);
    context.strokeStyle = css(outline);
    context.stroke();
  }
  for (const { position, diameter, thickness, outline_color: outline } of circles) {
    context.beginPath();
    context.arc(...at(position), Math.max(3, (diameter * scale) / 2), 0, 2 * Math.PI);
    context.lineWidth = Math.max(THINNEST, thickness * scale);
    context.strokeStyle = css(outline);
    context.stroke();
  }
  context.textAlign = "left";
  context.textBaseline = "alphabetic";
  for (const { position, text, font_size: size, text_color: color } of texts) {
    const [u, v] = at(position);
    context.font = `600 ${Math.max(11, size * scale)}px system-ui, sans-serif`;
    context.lineWidth = 3;
    context.strokeStyle = "rgba(0, 0, 0, 0.65)";
    context.strokeText(text, u, v);
    context.fillStyle = css(color);
    context.fillText(text, u, v);
  }
}
