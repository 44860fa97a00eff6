# SPDX-License-Identifier: MIT
"""Replaces a robot in this example: a program at the other end of two pipes, with the structures of robot_pipe.h. A team
does not need this file, because it has a robot."""
import collections
import struct
import subprocess

# body: head, attitude, rates and acceleration, one after the other; told_pose: initial pose or None; posts: goal
# posts in view, as (bearing, distance).
Measurements = collections.namedtuple("Measurements", "time odometry body foot_load told_pose posts")


class RobotPipe:
    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.name, self.width, self.height, *numbers = struct.unpack("<32sII12d", self.process.stdout.read(136))
        self.camera, self.posts = numbers[:10], numbers[10:]  # focal, center, distortion, position, tilt; goal posts: x, y

    def frames(self):
        """Yield the measurements of each frame until the last one. Read image() after each of them."""
        while True:
            time, *felt = struct.unpack("<18d4I8d", self.process.stdout.read(224))
            is_told, is_over, posts = felt[17:20]
            if is_over:
                return
            yield Measurements(time, tuple(felt[:3]), tuple(felt[3:13]), felt[13], tuple(felt[14:17]) if is_told else None,
                               list(zip(felt[21:21 + posts], felt[25:])))

    def image(self):
        return self.process.stdout.read(2 * self.width * self.height)

    def ask(self, head, walk, belief, has_head, has_walk, get_up, knows):
        """Send the requests to the robot, and the pose that the client believes, for the evaluation."""
        self.process.stdin.write(struct.pack("<9d4I", *head, *walk, *belief, has_head, has_walk, get_up, knows))
        self.process.stdin.flush()

    def verdict(self):
        return self.process.wait()
