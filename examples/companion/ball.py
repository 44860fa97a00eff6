#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""ball.py SOCKET INTERFACE: an application with a ball of its own. It declares the values and actions of the file INTERFACE
(assets/interfaces/ball.toml), shows a rolling ball to the behavior kick_ball, and carries out its kicks. It ends after three
kicks. The robot stands, and its images are gray. Start the server with:
reorient run --robot companion --socket SOCKET --behaviors kick_ball"""
import pathlib
import sys
import time

from reorient_companion import ACTION, HAS_BODY, HAS_TIME, OURS, REFUSAL, Companion

WIDTH, HEIGHT, RATE = 64, 64, 30
CAMERA = (58.0, 58.0, 31.5, 31.5, 0.0, 0.0, 0.05871, 0.0, 0.06364, 0.021)
STANDING = (0.0,) * 12 + (9.81,) + (0.0,) * 15  # odometry, head, attitude, rates, acceleration, ... of reorient_frame
KICK_TIME, KICKS = 0.5, 3  # s


class Ball:
    """Rolls toward the robot, until a kick sends it away."""

    def __init__(self):
        self.distance, self.side = 1.0, 0.05

    def roll(self):
        self.distance = max(0.15, self.distance - 0.5 / RATE)

    def kick(self):
        self.distance, self.side = 1.0, -self.side

    def values(self):
        return {"ball": {"seen": True, "position": {"x": self.distance, "y": self.side}, "distance": self.distance}}


def main(path, interface):
    declared = (pathlib.Path(interface).stem, pathlib.Path(interface).read_text())
    companion = Companion(path, OURS, b"nao-v6", WIDTH, HEIGHT, CAMERA, interface=declared)
    ball, kick, ends, kicks = Ball(), None, 0.0, 0
    for _ in range(60 * RATE):
        now = time.monotonic()
        ball.roll()
        companion.image(bytes([128]) * (2 * WIDTH * HEIGHT))
        companion.values(ball.values())
        companion.send(now, HAS_TIME | HAS_BODY, STANDING, [])
        if kick and now > ends:
            ball.kick()
            companion.report(kick.id, "done")
            kick, kicks = None, kicks + 1
            if kicks == KICKS:
                return 0
        for kind, body in companion.receive():
            if kind == REFUSAL:
                print("refused:", body.split(b"\0")[0].decode(), file=sys.stderr)
                return 1
            action = companion.new_action(body) if kind == ACTION else None
            if action and action.name == "kick":
                print(f"kick {kicks + 1} with the {action.arguments['foot']} foot", flush=True)
                kick, ends = action, now + KICK_TIME
                companion.report(action.id, "running")
            elif action:
                companion.report(action.id, "failed", "this robot does not do that")
        time.sleep(max(0.0, now + 1 / RATE - time.monotonic()))
    return 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 3 else __doc__)
