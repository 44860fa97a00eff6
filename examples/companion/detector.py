#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""detector.py SOCKET: a program with a detector of its own, for example a neural network. Reorient localizes the robot with
its percepts instead of looking for lines in the images. Here the "detector" computes the lines and the ball from the true
pose, the robot stands, and its images are gray. It prints the believed pose after five seconds. Start the server with:
reorient run --robot companion --socket SOCKET"""
import cmath
import struct
import sys
import time

from reorient_companion import (ANSWER, HAS_BODY, HAS_TIME, HAS_TOLD_POSE, ON_GROUND, OURS, PERCEPT_BALL, PERCEPT_LINE,
                                PERCEPTS_INSTEAD, REFUSAL, Companion, percept)

WIDTH, HEIGHT, RATE = 64, 64, 30
CAMERA = (58.0, 58.0, 31.5, 31.5, 0.0, 0.0, 0.05871, 0.0, 0.06364, 0.021)
TRUTH = (-2.0, 1.0, 0.3)  # x, y (m), rotation (rad)
TOLD = (-1.7, 0.8, 0.2)  # where the operator believes that the robot is
# Some lines of the field of a NAO: both ends, m.
LINES = [(-4.5, 3.0, 4.5, 3.0), (-4.5, -3.0, 4.5, -3.0), (-4.5, -3.0, -4.5, 3.0), (4.5, -3.0, 4.5, 3.0), (0.0, -3.0, 0.0, 3.0)]


def in_robot(x, y):
    place = (complex(x, y) - complex(*TRUTH[:2])) * cmath.rect(1.0, -TRUTH[2])
    return place.real, place.imag


def detect():
    """What a network would find in the image. In an image instead of on the ground: IN_UPPER_IMAGE, and pixels."""
    lines = [percept(PERCEPT_LINE, ON_GROUND, in_robot(*ends[:2]) + in_robot(*ends[2:]), 0.9) for ends in LINES]
    return lines + [percept(PERCEPT_BALL, ON_GROUND, (1.5, 0.2), 0.8, covariance=(0.01, 0.0, 0.01))]


def main(path):
    companion = Companion(path, OURS, b"nao-v6", WIDTH, HEIGHT, CAMERA, detector=PERCEPTS_INSTEAD)
    numbers = (0.0,) * 12 + (9.81,) + (0.0,) * 10 + TOLD + (0.5, 0.2)  # of reorient_frame, from odometry to told_deviation
    pose = None
    for i in range(5 * RATE):
        companion.image(bytes([128]) * (2 * WIDTH * HEIGHT))
        told = HAS_TOLD_POSE if i == 0 else 0
        companion.send(time.monotonic(), HAS_TIME | HAS_BODY | told, numbers, [], detect())
        for kind, body in companion.receive():
            if kind == REFUSAL:
                print("refused:", body.split(b"\0")[0].decode(), file=sys.stderr)
                return 1
            if kind == ANSWER:
                pose = struct.unpack_from("<3d", body, 64)
        time.sleep(1 / RATE)
    if pose is None:
        return 1
    print("pose: {:.1f} m, {:.1f} m, {:.1f} rad".format(*pose))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 2 else __doc__)
