// SPDX-License-Identifier: MIT
// A canvas that fills its box, at the resolution of the display, and is drawn again after changes.
import { useEffect, useRef } from "preact/hooks";

import { onChange } from "../ticker.js";

/// `draw(context, width, height)` in CSS pixels; `interval`: ms; `handlers`: of more events.
export function Canvas({ draw, interval = 33, label, onPoint, handlers = {}, className = "" }) {
  const canvas = useRef(null);
  const drawn = useRef(draw);
  drawn.current = draw;

  useEffect(() => {
    const element = canvas.current;
    const paint = () => {
      const { clientWidth: width, clientHeight: height } = element;
      if (!width || !height) return;
      const ratio = window.devicePixelRatio || 1;
      if (element.width !== Math.round(width * ratio) || element.height !== Math.round(height * ratio)) {
        element.width = Math.round(width * ratio);
        element.height = Math.round(height * ratio);
      }
      const context = element.getContext("2d");
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, width, height);
      drawn.current(context, width, height);
    };
    const observer = new ResizeObserver(paint);
    observer.observe(element);
    const end = onChange(interval, paint);
    return () => {
      observer.disconnect();
      end();
    };
  }, [interval]);

  const point = (event) => {
    const box = canvas.current.getBoundingClientRect();
    onPoint?.(event.clientX - box.left, event.clientY - box.top, box.width, box.height);
  };
  return (
    <canvas ref={canvas} class={`canvas ${className}`} role="img" aria-label={label} onClick={point} {...handlers} />
  );
}
