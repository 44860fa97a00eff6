# SPDX-License-Identifier: MIT
"""A small example of a team's localization, the same as particle_filter.c. It uses odometry, and bearings and rough
distances to goal posts, which all look the same."""
import math
import random


class ParticleFilter:
    COUNT = 150

    def __init__(self, post_x, post_y, seed):
        self.posts = [(x, y) for x in (-post_x, post_x) for y in (-post_y, post_y)]
        self.random = random.Random(seed)
        self.odometry = (0.0, 0.0, 0.0)
        self.particles = []  # [x, y, rotation, weight]

    def set_pose(self, pose):
        normal = self.random.gauss
        self.particles = [[pose[0] + normal(0, 0.1), pose[1] + normal(0, 0.1), pose[2] + normal(0, 0.08), 1.0]
                          for _ in range(self.COUNT)]

    def move(self, odometry):
        before, self.odometry = self.odometry, odometry
        dx, dy = odometry[0] - before[0], odometry[1] - before[1]
        turn = math.remainder(odometry[2] - before[2], 2 * math.pi)
        way = math.hypot(dx, dy)
        if way == 0 and turn == 0:
            return
        # The variance grows in proportion to the distance, so the result does not depend on the length of a step.
        spread = 0.06 * math.sqrt(way) + 0.02 * math.sqrt(abs(turn))
        twist = 0.05 * math.sqrt(abs(turn)) + 0.03 * math.sqrt(way)
        heading = math.atan2(dy, dx) - before[2]
        normal = self.random.gauss
        for one in self.particles:
            length = way + normal(0, spread)
            one[0] += length * math.cos(one[2] + heading)
            one[1] += length * math.sin(one[2] + heading)
            one[2] += turn + normal(0, twist)

    def see(self, posts):
        """Use the bearing and distance of each post in view."""
        if not posts or not self.particles:
            return
        for one in self.particles:
            expected = [(math.atan2(y - one[1], x - one[0]) - one[2], math.hypot(x - one[0], y - one[1]))
                        for x, y in self.posts]
            for bearing, distance in posts:
                error = min((math.remainder(angle - bearing, 2 * math.pi) / 0.09) ** 2 + ((far / distance - 1) / 0.25) ** 2
                            for angle, far in expected)
                # 0.02 limits the effect of one frame, because the errors of successive frames are not independent.
                one[3] *= 0.02 + math.exp(-0.5 * error)
        total = sum(one[3] for one in self.particles)
        for one in self.particles:
            one[3] /= total
        if 1 / sum(one[3] ** 2 for one in self.particles) > self.COUNT / 2:
            return
        normal = self.random.gauss
        self.particles = [[one[0] + normal(0, 0.02), one[1] + normal(0, 0.02), one[2] + normal(0, 0.01), 1 / self.COUNT]
                          for one in self.random.choices(self.particles, [one[3] for one in self.particles], k=self.COUNT)]

    def flip(self):
        self._reflect(self.particles)

    def purge(self):
        mean = self.mean()
        self._reflect([one for one in self.particles if math.cos(one[2] - mean[2]) < 0])

    def reset(self):
        self._reflect(self.particles[::2])

    def mean(self):
        """Mean of the particles with similar directions. A mean of all would be wrong if some particles are mirrored."""
        def near(middle):
            return [one for one in self.particles if math.cos(one[2] - middle[2]) > 0.5]
        if not self.particles:
            return 0.0, 0.0, 0.0
        most = max((near(one) for one in self.particles[::10]), key=lambda some: sum(one[3] for one in some))
        total = sum(one[3] for one in most)
        x, y = (sum(one[3] * one[i] for one in most) / total for i in (0, 1))
        return x, y, math.atan2(*(sum(one[3] * f(one[2]) for one in most) for f in (math.sin, math.cos)))

    @staticmethod
    def _reflect(particles):
        for one in particles:
            one[0], one[1], one[2] = -one[0], -one[1], math.remainder(one[2] + math.pi, 2 * math.pi)
