#!/usr/bin/env python3
"""client.py SOCKET own|ours ROBOT [ARGUMENT...]: what client.c does, with nothing but Python's standard library (3.9 or
later), but a told pose is lost with its frame. "own": Reorient commands the robot's own localization, particle_filter.py."""
import fcntl
import mmap
import os
import select
import socket
import struct
import subprocess
import sys

from particle_filter import ParticleFilter

HELLO, MEMORY, FRAME, WELCOME, REFUSAL, ANSWER = 1, 2, 3, 101, 102, 103
HAS_TIME, HAS_BODY, HAS_FOOT_LOAD, HAS_TOLD_POSE = 1, 2 + 4 + 8 + 16, 32, 128  # body: head, attitude, rates, acceleration
ANSWER_POSE, ANSWER_HEAD, ANSWER_WALK, ANSWER_GET_UP = 1, 2, 4, 8
FLIP, PURGE, RESET, YUYV, OWN, OURS = 1, 2, 3, 1, 1, 2
SLOTS, SLOT_HEADER, VERSION, WANTS = 3, 64, 2, 1 + 2 + 4  # wants: head, walk, get up


class Companion:
    """The connection. It is made anew when it is gone; nothing here waits."""
    def __init__(self, path, way, body, width, height, camera):
        self.path, self.socket, self.broken = path, None, False
        self.number = self.told = self.sequence = self.slot = 0
        self.server, self.done = 0, (0, 0)  # the server, and the last command of which server
        self.image_bytes = 2 * width * height
        self.slot_size = (SLOT_HEADER + self.image_bytes + 63) // 64 * 64
        self.memory = os.memfd_create("reorient", os.MFD_ALLOW_SEALING)
        os.ftruncate(self.memory, SLOTS * self.slot_size)
        fcntl.fcntl(self.memory, 1033, 2)  # F_ADD_SEALS, F_SEAL_SHRINK
        self.images = mmap.mmap(self.memory, SLOTS * self.slot_size)
        self.hello = (os.urandom(8) + struct.pack("<IId", way, WANTS, 0.0) +
                      struct.pack("<HHI10d", width, height, YUYV, *camera) + bytes(88) +
                      struct.pack("<32s136x", body) + bytes(160))

    def connect(self):
        if self.socket and not self.broken:
            return True
        self.server, self.broken, self.rest_out, self.rest_in = 0, False, b"", b""
        try:
            self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
            self.socket.setblocking(False)
            self.socket.connect(self.path)
            self.socket.sendall(struct.pack("<IHH", len(self.hello), HELLO, VERSION) + self.hello)
            message = struct.pack("<IHHII", 8, MEMORY, VERSION, 0, self.slot_size)
            self.socket.sendmsg([message], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, struct.pack("i", self.memory))])
        except OSError:
            self.broken = True  # what has come is still to be read: a refusal, perhaps
        return not self.broken

    def image(self, pixels):
        self.slot = (self.slot + 1) % SLOTS
        at = self.slot * self.slot_size
        self.images[at:at + 8] = struct.pack("<Q", self.sequence + 1)  # odd: it is being written
        self.images[at + SLOT_HEADER:at + SLOT_HEADER + len(pixels)] = pixels
        self.sequence += 2
        self.images[at:at + 8] = struct.pack("<Q", self.sequence)

    def send(self, time, has, numbers, particles):
        """True: it is on its way. Else it is lost, since there is no server or it is slow."""
        self.number, self.told = self.number + 1, self.number + 1 if has & HAS_TOLD_POSE else self.told
        body = (struct.pack("<QdIIIIIIQ", self.number, time, has, 0, 0, len(particles), 0, self.done[1], self.done[0]) +
                struct.pack("<28dIIQd216x", *numbers, self.slot, 1, self.sequence, 0.0) +
                b"".join(struct.pack("<4f", *one) for one in particles))
        if self.connect() and self.flush():
            self.rest_out = struct.pack("<IHH", len(body), FRAME, VERSION) + body
            self.flush()
            return not self.broken

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
            self.socket = self.socket if piece else None  # it is gone
            while len(self.rest_in) >= 8:
                size, kind = struct.unpack_from("<IH", self.rest_in)
                if len(self.rest_in) < 8 + size:
                    break
                body, self.rest_in = self.rest_in[8:8 + size], self.rest_in[8 + size:]
                if kind == WELCOME:
                    self.server = struct.unpack_from("<Q", body)[0]
                yield kind, body

    def command(self, answered, number, kind):
        """That is to be carried out now, 0: none. Each is told once, and none that is older than a told pose."""
        if self.server and number and answered >= self.told and (self.done[0] != self.server or self.done[1] < number):
            self.done = (self.server, number)
            return kind


def main(path, way, *robot):
    process = subprocess.Popen(robot, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    name, width, height, *numbers = struct.unpack("<32sII12d", process.stdout.read(136))
    companion = Companion(path, OWN if way == "own" else OURS, name, width, height, numbers[:10])
    localization = ParticleFilter(*numbers[10:], seed=1)
    while True:
        felt = struct.unpack("<d14d3d4I8d", process.stdout.read(224))
        if felt[19]:
            return process.wait()  # it is over
        companion.image(process.stdout.read(companion.image_bytes))
        has = HAS_TIME | HAS_BODY | (felt[14] >= 0 and HAS_FOOT_LOAD)
        if felt[18]:
            localization.told(felt[15:18])
            has |= HAS_TOLD_POSE
        localization.move(felt[1:4])
        localization.see(list(zip(felt[22:22 + felt[20]], felt[26:])))
        body = felt[1:15] + (0.0,) * 9 + felt[15:18] + (0.1, 0.1)
        pose = head = walk = (0.0, 0.0, 0.0)
        answered = answer_has = 0
        sent = companion.send(felt[0], has, body, localization.particles if way == "own" else [])
        while companion.socket and answered < companion.number:  # a robot does not wait
            for kind, answer in companion.receive():
                if kind == REFUSAL:
                    print("refused:", answer.split(b"\0")[0].decode(), file=sys.stderr)
                if kind == ANSWER:
                    answered, answer_has, number, command = struct.unpack_from("<Q16xI4xII", answer)
                    values = struct.unpack_from("<18d", answer, 40)
                    pose, head, walk = values[3:6], values[12:15], values[15:18]
                    carry_out = {FLIP: localization.flip, PURGE: localization.purge, RESET: localization.reset}
                    carry_out.get(companion.command(answered, number, command), lambda: None)()
            if not sent or (companion.socket and answered < companion.number and
                            not select.select([companion.socket], [], [], 2.0)[0]):
                break
        if way == "own":
            pose, answer_has = localization.mean(), answer_has | (ANSWER_POSE if localization.particles else 0)
        wanted = (answer_has & bit for bit in (ANSWER_HEAD, ANSWER_WALK, ANSWER_GET_UP, ANSWER_POSE))
        process.stdin.write(struct.pack("<9d4I", *head, *walk, *pose, *wanted))
        process.stdin.flush()


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) > 3 else __doc__)
