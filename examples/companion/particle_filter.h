// SPDX-License-Identifier: MIT
/* A small example of a team's localization. It uses odometry, and bearings and rough distances to goal posts. All posts
 * look the same, so a pose and its mirrored pose always fit equally well. Reorient's commands resolve this. */
#ifndef PARTICLE_FILTER_H
#define PARTICLE_FILTER_H

#include <stdint.h>

enum { PARTICLES = 300 };

struct particle {
  double x, y, rotation, weight;
};

struct particle_filter {
  struct particle particles[PARTICLES];
  double post_x, post_y; /* posts stand at +-x, +-y */
  double odometry[3];    /* of the previous frame */
  uint64_t random;
  int knows;
};

void filter_begin(struct particle_filter* filter, double post_x, double post_y, uint64_t seed);
void filter_set_pose(struct particle_filter* filter, const double pose[3]);
void filter_move(struct particle_filter* filter, const double odometry[3]);
void filter_see(struct particle_filter* filter, const double* bearings, const double* distances, unsigned count);
void filter_flip(struct particle_filter* filter);  /* mirrors all particles */
void filter_purge(struct particle_filter* filter); /* removes particles near the mirrored mean */
void filter_reset(struct particle_filter* filter); /* mirrors half of the particles */
void filter_mean(const struct particle_filter* filter, double pose[3]);

#endif
