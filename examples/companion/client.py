#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""client.py SOCKET own|ours ROBOT [ARGUMENT...]: does the same as client.c, with only Python's standard library (3.9 or
later). reorient_companion.py is the connection. "own": the robot has its own localization, particle_filter.py, to which it
applies Reorient's commands. ROBOT is a program that replaces a robot (robot_pipe.py)."""
import select
import struct
import sys

from particle_filter import ParticleFilter
from reorient_companion import (ANSWER, ANSWER_GET_UP, ANSWER_HEAD, ANSWER_POSE, ANSWER_WALK, FLIP, HAS_BODY, HAS_FOOT_LOAD,
                                HAS_TIME, HAS_TOLD_POSE, OURS, OWN, PURGE, REFUSAL, RESET, Companion)
from robot_pipe import RobotPipe


def main(path, way, *robot):
    robot = RobotPipe(robot)
    companion = Companion(path, OWN if way == "own" else OURS, robot.name, robot.width, robot.height, robot.camera)
    localization = ParticleFilter(*robot.posts, seed=1)
    for felt in robot.frames():
        companion.image(robot.image())
        has = HAS_TIME | HAS_BODY | (felt.foot_load >= 0 and HAS_FOOT_LOAD)
        if felt.told_pose:
            localization.set_pose(felt.told_pose)
            has |= HAS_TOLD_POSE
        localization.move(felt.odometry)
        localization.see(felt.posts)
        numbers = felt.odometry + felt.body + (felt.foot_load,) + (0.0,) * 9 + (felt.told_pose or (0.0,) * 3) + (0.1, 0.1)
        pose = head = walk = (0.0, 0.0, 0.0)
        answered = answer_has = 0
        sent = companion.send(felt.time, has, numbers, localization.particles if way == "own" else [])
        while companion.socket and answered < companion.number:  # only in this example: a robot must not wait
            for kind, answer in companion.receive():
                if kind == REFUSAL:
                    print("refused:", answer.split(b"\0")[0].decode(), file=sys.stderr)
                if kind == ANSWER:
                    answered, answer_has, number, command = struct.unpack_from("<Q16xI4xII", answer)
                    values = struct.unpack_from("<18d", answer, 40)
                    pose, head, walk = values[3:6], values[12:15], values[15:18]
                    actions = {FLIP: localization.flip, PURGE: localization.purge, RESET: localization.reset}
                    actions.get(companion.command(answered, number, command), lambda: None)()
            if not sent or (companion.socket and answered < companion.number and
                            not select.select([companion.socket], [], [], 2.0)[0]):
                break
        if way == "own":
            pose, answer_has = localization.mean(), answer_has | (ANSWER_POSE if localization.particles else 0)
        robot.ask(head, walk, pose, *(answer_has & bit for bit in (ANSWER_HEAD, ANSWER_WALK, ANSWER_GET_UP, ANSWER_POSE)))
    return robot.verdict()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) > 3 else __doc__)
