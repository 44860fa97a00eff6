// SPDX-License-Identifier: MIT
// Carries the true robot over the field with the pointer: it is lifted when the drag begins, and placed at its end.
import { mirrored } from "../draw/field.js";
import { palette } from "../draw/palette.js";
import { drawPoseMark } from "../draw/pose_marks.jsx";
import { degrees, meters, wrapped } from "../format.js";
import { act, canCarry, isRunPaused, place, placedPose, run } from "../operator.js";
import { store } from "../robot.js";
import { changedByUser } from "../ticker.js";

const NEAR = { mouse: 20, pen: 24, touch: 32 }; // px from the robot
const BEGIN = 5; // px that the pointer moves before the robot is lifted, so that a click does not lift it
const SNAP = 0.4; // m
const SNAP_TURN = Math.PI / 6;
const WHEEL = Math.PI / 36; // for each notch

const poseText = ({ x, y, rotation }) => `x ${meters(x)}, y ${meters(y)}, ${degrees(rotation)}`;
const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

/// The pose at which a robot that was lifted at `start` is placed: the mirrored pose if it is near, else `pose`.
/// `turned`: the user has turned it.
export function snapped(start, pose, turned) {
  const goal = mirrored(start);
  const fits = !turned || Math.abs(wrapped(pose.rotation - goal.rotation)) < SNAP_TURN;
  return distance(goal, pose) < SNAP && fits ? goal : pose;
}

export class Carry {
  constructor(plan) {
    this.plan = plan; // {current}: the transformation of the drawing
    this.drag = null; // {pointer, from, start, pose, turned, lifted, grip}
    this.ended = false; // the click that follows belongs to the drag
    this.onKey = (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.cancel();
    };
  }

  /// Handlers of the canvas.
  get handlers() {
    return {
      onPointerDown: (event) => this.down(event),
      onPointerMove: (event) => this.move(event),
      onPointerUp: (event) => this.up(event),
      onPointerCancel: (event) => event.pointerId === this.drag?.pointer && this.cancel(),
      onWheel: (event) => this.wheel(event),
      // Else the browser scrolls the page.
      onTouchStart: (event) => this.drag && event.preventDefault(),
    };
  }

  isNear(event) {
    const { plan } = this;
    const truth = canCarry() && plan.current && (placedPose() ?? store.shown()?.truth);
    if (!truth) return null;
    const [u, v] = plan.current.at(truth.x, truth.y);
    const near = NEAR[event.pointerType] ?? NEAR.mouse;
    return Math.hypot(u - event.offsetX, v - event.offsetY) < near ? truth : null;
  }

  pointOf(event) {
    const [x, y] = this.plan.current.meters(event.offsetX, event.offsetY);
    return { x, y };
  }

  down(event) {
    if (this.drag) {
      this.look(this.pointOf(event)); // a second finger
      return;
    }
    this.ended = false;
    const start = event.button === 0 && this.isNear(event);
    if (!start) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    const point = this.pointOf(event);
    this.drag = {
      pointer: event.pointerId,
      from: [event.offsetX, event.offsetY],
      start: { ...start },
      pose: { ...start },
      turned: false,
      lifted: false,
      grip: { x: start.x - point.x, y: start.y - point.y },
    };
    addEventListener("keydown", this.onKey, true);
  }

  move(event) {
    const { drag } = this;
    if (!drag) {
      event.currentTarget.style.cursor = this.isNear(event) ? "grab" : "";
      return;
    }
    const point = this.pointOf(event);
    if (event.pointerId !== drag.pointer) return this.look(point);
    if (!drag.lifted) {
      if (Math.hypot(drag.from[0] - event.offsetX, drag.from[1] - event.offsetY) < BEGIN) return;
      drag.lifted = true;
      act("pick_up");
      event.currentTarget.style.cursor = "grabbing";
    }
    if (event.shiftKey) return this.look(point);
    drag.pose = { ...drag.pose, x: point.x + drag.grip.x, y: point.y + drag.grip.y };
    changedByUser();
  }

  /// Turns the robot toward a point.
  look(point) {
    const { drag } = this;
    if (!drag.lifted || distance(point, drag.pose) * this.plan.current.scale < 4) return;
    drag.turned = true;
    drag.pose = { ...drag.pose, rotation: Math.atan2(point.y - drag.pose.y, point.x - drag.pose.x) };
    changedByUser();
  }

  wheel(event) {
    const { drag } = this;
    if (!drag?.lifted) return;
    event.preventDefault();
    drag.turned = true;
    drag.pose = { ...drag.pose, rotation: wrapped(drag.pose.rotation - Math.sign(event.deltaY) * WHEEL) };
    changedByUser();
  }

  up(event) {
    const { drag } = this;
    if (!drag || event.pointerId !== drag.pointer) return;
    if (drag.lifted) place(this.target());
    this.end(event.currentTarget);
  }

  cancel() {
    const { drag } = this;
    if (!drag) return;
    if (drag.lifted) place(drag.start);
    this.end();
  }

  end(canvas) {
    this.ended = this.drag.lifted;
    this.drag = null;
    if (canvas) canvas.style.cursor = "";
    removeEventListener("keydown", this.onKey, true);
    changedByUser();
  }

  target() {
    const { start, pose, turned } = this.drag;
    return snapped(start, pose, turned);
  }

  /// Draws the robot in the hand, and the ring of the mirrored pose; or where the next frame shows the placed robot.
  /// `size`: of the marks.
  draw(context, size) {
    const { at, scale } = this.plan.current;
    if (!this.drag?.lifted) {
      const placed = placedPose();
      if (placed) drawPoseMark(context, "truth", placed, this.plan.current, size, true);
      return;
    }
    const target = this.target();
    const goal = mirrored(this.drag.start);
    const isSnapped = distance(goal, target) === 0;
    context.save();
    context.beginPath();
    context.arc(...at(goal.x, goal.y), SNAP * scale, 0, 2 * Math.PI);
    context.setLineDash(isSnapped ? [] : [5, 4]);
    context.lineWidth = isSnapped ? 3.5 : 2;
    context.strokeStyle = palette.truth;
    context.stroke();
    context.restore();
    drawPoseMark(context, "truth", target, this.plan.current, size, true);
  }

  /// The lines of a note about the drag, or why the run refused it, or where a paused run places the robot; empty
  /// without one.
  lines() {
    if (!this.drag?.lifted) {
      if (this.ended && run.problem) return [run.problem];
      const placed = isRunPaused() && placedPose();
      return placed ? [`From the next frame on: ${poseText(placed)}`] : [];
    }
    const target = this.target();
    const isSnapped = distance(mirrored(this.drag.start), target) === 0;
    return [
      `${isSnapped ? "Mirrored pose" : "Place"}: ${poseText(target)}`,
      "Wheel, Shift or a second finger turns the robot. Escape cancels.",
    ];
  }
}
