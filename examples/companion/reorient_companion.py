# SPDX-License-Identifier: MIT
"""A client of Reorient's companion with only Python's standard library (3.9 or later), for robots with one camera. It
corresponds to reorient_companion.h in C. Copy this file; docs/companion.md explains the numbers."""
import cmath
import collections
import fcntl
import json
import math
import mmap
import os
import socket
import struct

HELLO, MEMORY, FRAME, VALUES, REPORT, WELCOME, REFUSAL, ANSWER, ACTION = 1, 2, 3, 6, 7, 101, 102, 103, 106
HAS_TIME, HAS_BODY, HAS_FOOT_LOAD, HAS_TOLD_POSE, OTHER_HALF = 1, 30, 32, 128, 512  # body: head, attitude, rates, acceleration
ANSWER_POSE, ANSWER_HEAD, ANSWER_WALK, ANSWER_GET_UP = 1, 2, 4, 8
FLIP, PURGE, RESET, YUYV, OWN, OURS = 1, 2, 3, 1, 1, 2
SLOTS, SLOT_HEADER, VERSION, WANTS = 3, 64, 2, 1 + 2 + 4  # wants: head, walk, get up
TOLD_FRAMES = 60
REPORTS = {"running": 1, "done": 2, "failed": 3}
Action = collections.namedtuple("Action", "id name arguments")  # arguments: by name
PERCEPT_LINE, PERCEPT_LINE_POINT, PERCEPT_GOAL_POST, PERCEPT_L, PERCEPT_T, PERCEPT_X = range(6)
PERCEPT_PENALTY_MARK, PERCEPT_CENTER_CIRCLE, PERCEPT_BALL, PERCEPT_ROBOT, PERCEPT_PERSON = range(6, 11)
ON_GROUND, IN_UPPER_IMAGE, IN_LOWER_IMAGE = range(3)
PERCEPTS_WITH, PERCEPTS_INSTEAD, MOST_PERCEPTS = 1, 2, 256
LENS_OF_CAMERA, LENS_PINHOLE, LENS_FISHEYE, LENS_EQUIRECTANGULAR = 0, 1, 2, 3


def lens(model, coefficients):
    """Bytes for `lenses` of Companion, for a camera that is not a pinhole with two radial coefficients. The coefficients are
    those of OpenCV."""
    padded = tuple(coefficients) + (0.0,) * (8 - len(coefficients))
    return struct.pack("<II8d", model, len(coefficients), *padded) + bytes(72)  # no second camera


def percept(what, space, at, confidence=1.0, direction=None, covariance=None, base_hidden=False):
    """Bytes of one percept for `percepts` of Companion.send(). `at`: up to four numbers, as REORIENT_PERCEPT_... in
    reorient_companion.h explains; `covariance`: xx, xy, yy."""
    has = (direction is not None) + 2 * (covariance is not None) + 4 * base_hidden
    padded = tuple(at) + (0.0,) * (4 - len(at))
    return struct.pack("<III9f", what, space, has, confidence, *padded, direction or 0.0, *(covariance or (0.0,) * 3))


class Companion:
    """The connection. It reconnects after a failure, and no call blocks. `camera`: focal length, center, distortion, position
    and tilt of the camera, 10 numbers; `body`: name of a shipped robot body, as bytes; `lenses`: result of lens() if the
    camera is not a pinhole with two radial coefficients; `interface`: name and text of an interface file, if your program has
    values and actions of its own; `detector`: PERCEPTS_WITH or PERCEPTS_INSTEAD if your frames contain percepts."""

    def __init__(self, path, way, body, width, height, camera, lenses=b"", interface=None, detector=0):
        self.path, self.socket, self.broken = path, None, False
        self.number = self.told = self.sequence = self.slot = 0
        self.server, self.done = 0, (0, 0)  # id of the server; server and number of the last command
        # An initial pose that the server may not have saved yet: pose, deviations, odometry and half at that time; number of
        # frames for which it is stored after an answer; the server that answered.
        self.kept, self.kept_frames, self.kept_server, self.told_sent = None, 0, 0, False
        self.image_bytes = 2 * width * height
        self.slot_size = (SLOT_HEADER + self.image_bytes + 63) // 64 * 64
        self.memory = os.memfd_create("reorient", os.MFD_ALLOW_SEALING)
        os.ftruncate(self.memory, SLOTS * self.slot_size)
        fcntl.fcntl(self.memory, 1033, 2)  # F_ADD_SEALS, F_SEAL_SHRINK
        self.images = mmap.mmap(self.memory, SLOTS * self.slot_size)
        self.hello = (os.urandom(8) + struct.pack("<IId", way, WANTS, 0.0) +
                      struct.pack("<HHI10d", width, height, YUYV, *camera) + bytes(88) +
                      struct.pack("<32s136x", body) + bytes(160) + lenses)
        self.last_action = 0
        self.has_detector = bool(detector)
        if interface or detector:
            name, text = (part.encode() for part in interface or ("", ""))
            self.hello += b"" if lenses else bytes(144)
            self.hello += struct.pack("<32sII", name, len(text), 0) + text
        if detector:
            self.hello += struct.pack("<II", detector, 0)

    def connect(self):
        if self.socket and not self.broken:
            return True
        self.server, self.broken, self.told_sent, self.rest_out, self.rest_in = 0, False, False, b"", b""
        try:
            self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            self.socket.setblocking(False)
            self.socket.connect(self.path)
            peer = struct.unpack("3i", self.socket.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, 12))[1]
            if peer not in (0, os.geteuid()):
                raise PermissionError  # in a folder that all users can write, any user can listen
            self.socket.sendall(struct.pack("<IHH", len(self.hello), HELLO, VERSION) + self.hello)
            message = struct.pack("<IHHII", 8, MEMORY, VERSION, 0, self.slot_size)
            self.socket.sendmsg([message], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, struct.pack("i", self.memory))])
        except OSError:
            self.broken = True  # messages that have arrived must still be read, for example a refusal
        return not self.broken

    def image(self, pixels):
        self.slot = (self.slot + 1) % SLOTS
        at = self.slot * self.slot_size
        self.images[at:at + 8] = struct.pack("<Q", self.sequence + 1)  # odd: the image is being written
        self.images[at + SLOT_HEADER:at + SLOT_HEADER + len(pixels)] = pixels
        self.sequence += 2
        self.images[at:at + 8] = struct.pack("<Q", self.sequence)

    def send(self, time, has, numbers, particles, percepts=None):
        """Return True if the frame was sent. Otherwise it is lost, because no server runs or the server is slow. `numbers`: the
        28 numbers of reorient_frame from odometry on. The next frame then contains the initial pose. If the server that
        answered it ends within two seconds, the next server gets it again. `percepts`: results of percept(), with a `detector`
        only; None: your detector has not looked at this image."""
        self.number += 1
        if has & HAS_TOLD_POSE:
            self.kept = (numbers[23:26], numbers[26:], numbers[:3], has & OTHER_HALF)
            self.kept_frames, self.kept_server, self.told_sent = 0, 0, False
        ready = self.connect() and self.flush()
        if self.kept:
            self.move_kept(numbers, has)
        if self.kept and not self.kept_server and not self.told_sent:
            numbers, has, self.told = numbers[:23] + self.kept[0] + self.kept[1], has | HAS_TOLD_POSE, self.number
        body = (struct.pack("<QdIIIIIIQ", self.number, time, has, 0, 0, len(particles), 0, self.done[1], self.done[0]) +
                struct.pack("<28dIIQd216x", *numbers, self.slot, 1, self.sequence, 0.0) +
                b"".join(struct.pack("<4f", *one) for one in particles))
        if percepts is not None and self.has_detector:
            body += struct.pack("<II", len(percepts[:MOST_PERCEPTS]), 0) + b"".join(percepts[:MOST_PERCEPTS])
        if ready:
            self.rest_out = struct.pack("<IHH", len(body), FRAME, VERSION) + body
            self.flush()
            self.told_sent = not self.broken
        return ready and not self.broken

    def move_kept(self, numbers, has):
        """Move the stored initial pose with the odometry, whose error is 10 %, and into the axes of the other half."""
        (x, y, rotation), deviations, (from_x, from_y, before), half = self.kept
        way = complex(numbers[0] - from_x, numbers[1] - from_y)
        turned, turn = way * cmath.rect(1, rotation - before), numbers[2] - before
        pose = (x + turned.real, y + turned.imag, rotation + turn)
        if has & OTHER_HALF != half:
            pose = (-pose[0], -pose[1], pose[2] + math.pi)
        deviations = (deviations[0] + 0.1 * abs(way), deviations[1] + 0.1 * abs(math.remainder(turn, 2 * math.pi)))
        self.kept = (pose, deviations, numbers[:3], has & OTHER_HALF)
        self.kept_frames -= self.kept_frames > 0
        if self.kept_frames == 0 and self.kept_server:
            self.kept, self.kept_server = None, 0

    def post(self, kind, body):
        """Return True if the message was sent."""
        ready = self.connect() and self.flush()
        if ready:
            self.rest_out = struct.pack("<IHH", len(body), kind, VERSION) + body
            self.flush()
        return ready and not self.broken

    def values(self, values):
        """Send values of the application before the frame that they belong to. A server that starts without knowledge needs all
        of them again."""
        return self.post(VALUES, json.dumps(values).encode())

    def report(self, action, state, reason=""):
        """Report that an action (its id) is "running", "done" or "failed"."""
        return self.post(REPORT, struct.pack("<II120s", action, REPORTS[state], reason.encode()[:119]))

    def new_action(self, body):
        """Return the action of a message ACTION to begin now, or None: each one is returned once."""
        number, name, arguments = struct.unpack("<I4x64s1976s", body)
        if number <= self.last_action:
            return None
        self.last_action = number
        return Action(number, name.split(b"\0")[0].decode(), json.loads(arguments.split(b"\0")[0]))

    def flush(self):
        try:
            while self.rest_out:
                self.rest_out = self.rest_out[self.socket.send(self.rest_out, socket.MSG_NOSIGNAL):]
        except BlockingIOError:
            pass
        except OSError:
            self.broken = True
        return not self.broken and not self.rest_out

    def receive(self):
        while self.socket:
            try:
                piece = self.socket.recv(65536)
            except BlockingIOError:
                return
            except OSError:
                piece = b""
            self.rest_in += piece
            self.socket = self.socket if piece else None  # None: the server has closed the connection
            while len(self.rest_in) >= 8:
                size, kind = struct.unpack_from("<IH", self.rest_in)
                if len(self.rest_in) < 8 + size:
                    break
                body, self.rest_in = self.rest_in[8:8 + size], self.rest_in[8 + size:]
                first = struct.unpack_from("<Q", body)[0] if len(body) >= 8 else 0
                if kind == WELCOME:
                    self.server = first
                    if not struct.unpack_from("<I", body, 8)[0]:
                        self.last_action = 0  # the server starts without knowledge, and counts from 1
                    if self.kept_server and self.kept_server != self.server:
                        # The new server may not know the initial pose that the previous server got.
                        self.kept_frames, self.kept_server, self.told_sent = 0, 0, False
                if kind == ANSWER and self.kept and not self.kept_server and first >= self.told:
                    self.kept_frames, self.kept_server = TOLD_FRAMES, self.server
                yield kind, body

    def command(self, answered, number, kind):
        """Return the command to apply now, or None. Each command is returned once, and no command that is older than an initial
        pose."""
        if self.server and number and answered >= self.told and (self.done[0] != self.server or self.done[1] < number):
            self.done, self.kept = (self.server, number), None  # the belief has changed
            return kind
