// SPDX-License-Identifier: MIT
#include "particle_filter.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

static double uniform(struct particle_filter* filter) { /* in [0, 1) */
  filter->random = filter->random * 6364136223846793005u + 1442695040888963407u;
  return (double)(filter->random >> 11) / 9007199254740992.0;
}

static double normal(struct particle_filter* filter) { /* approximately normal, deviation 1 */
  double sum = -6.0;
  int i;
  for (i = 0; i < 12; ++i) sum += uniform(filter);
  return sum;
}

static double turned(double angle) { return remainder(angle, 2.0 * PI); }

static void reflect(struct particle* particle) {
  particle->x = -particle->x;
  particle->y = -particle->y;
  particle->rotation = turned(particle->rotation + PI);
}

void filter_begin(struct particle_filter* filter, double post_x, double post_y, uint64_t seed) {
  memset(filter, 0, sizeof *filter);
  filter->post_x = post_x;
  filter->post_y = post_y;
  filter->random = seed * 2 + 1;
}

void filter_set_pose(struct particle_filter* filter, const double pose[3]) {
  int i;
  for (i = 0; i < PARTICLES; ++i) {
    struct particle* one = &filter->particles[i];
    one->x = pose[0] + 0.1 * normal(filter);
    one->y = pose[1] + 0.1 * normal(filter);
    one->rotation = turned(pose[2] + 0.08 * normal(filter));
    one->weight = 1.0 / PARTICLES;
  }
  filter->knows = 1;
}

void filter_move(struct particle_filter* filter, const double odometry[3]) {
  const double* before = filter->odometry;
  const double dx = odometry[0] - before[0], dy = odometry[1] - before[1];
  const double turn = turned(odometry[2] - before[2]);
  const double forward = cos(before[2]) * dx + sin(before[2]) * dy, left = -sin(before[2]) * dx + cos(before[2]) * dy;
  const double way = hypot(dx, dy);
  /* The variance grows in proportion to the distance, so the result does not depend on the length of a step. */
  const double spread = 0.06 * sqrt(way) + 0.02 * sqrt(fabs(turn)), twist = 0.05 * sqrt(fabs(turn)) + 0.03 * sqrt(way);
  int i;
  memcpy(filter->odometry, odometry, sizeof filter->odometry);
  if (way == 0.0 && turn == 0.0) return;
  for (i = 0; i < PARTICLES; ++i) {
    struct particle* one = &filter->particles[i];
    const double ahead = forward + spread * normal(filter), aside = left + spread * normal(filter);
    one->x += cos(one->rotation) * ahead - sin(one->rotation) * aside;
    one->y += sin(one->rotation) * ahead + cos(one->rotation) * aside;
    one->rotation = turned(one->rotation + turn + twist * normal(filter));
  }
}

/* Squared error of the observation of a post for the best of the four posts. The deviations are large, because the
 * errors of successive frames are not independent. */
static double mismatch(const struct particle_filter* filter, const struct particle* one, double bearing,
                       double distance) {
  double best = 100.0;
  int post;
  for (post = 0; post < 4; ++post) {
    const double x = post & 1 ? filter->post_x : -filter->post_x, y = post & 2 ? filter->post_y : -filter->post_y;
    const double aside = turned(atan2(y - one->y, x - one->x) - one->rotation - bearing) / 0.09;
    const double along = (hypot(x - one->x, y - one->y) / distance - 1.0) / 0.25;
    if (aside * aside + along * along < best) best = aside * aside + along * along;
  }
  return best;
}

void filter_see(struct particle_filter* filter, const double* bearings, const double* distances, unsigned count) {
  struct particle drawn[PARTICLES];
  double sum = 0.0, squares = 0.0, next;
  unsigned i, from = 0;
  if (count == 0) return;
  for (i = 0; i < PARTICLES; ++i) {
    struct particle* one = &filter->particles[i];
    unsigned seen;
    for (seen = 0; seen < count; ++seen) {
      one->weight *= 0.02 + exp(-0.5 * mismatch(filter, one, bearings[seen], distances[seen]));
    }
    sum += one->weight;
  }
  for (i = 0; i < PARTICLES; ++i) {
    filter->particles[i].weight /= sum;
    squares += filter->particles[i].weight * filter->particles[i].weight;
  }
  if (1.0 / squares > PARTICLES / 2) return;
  next = uniform(filter) / PARTICLES;
  sum = filter->particles[0].weight;
  for (i = 0; i < PARTICLES; ++i, next += 1.0 / PARTICLES) {
    while (sum < next && from + 1 < PARTICLES) sum += filter->particles[++from].weight;
    drawn[i] = filter->particles[from];
    drawn[i].x += 0.02 * normal(filter);
    drawn[i].y += 0.02 * normal(filter);
    drawn[i].rotation = turned(drawn[i].rotation + 0.01 * normal(filter));
    drawn[i].weight = 1.0 / PARTICLES;
  }
  memcpy(filter->particles, drawn, sizeof drawn);
}

void filter_flip(struct particle_filter* filter) {
  int i;
  for (i = 0; i < PARTICLES; ++i) reflect(&filter->particles[i]);
}

void filter_purge(struct particle_filter* filter) {
  double mean[3];
  int i;
  filter_mean(filter, mean);
  for (i = 0; i < PARTICLES; ++i) {
    struct particle* one = &filter->particles[i];
    if (cos(one->rotation - mean[2]) < 0.0) reflect(one);
  }
}

void filter_reset(struct particle_filter* filter) {
  int i;
  for (i = 0; i < PARTICLES; i += 2) reflect(&filter->particles[i]);
}

/* Mean of the particles with similar directions. A mean of all would be wrong if some particles are mirrored. */
void filter_mean(const struct particle_filter* filter, double pose[3]) {
  double cosine = 0.0, sine = 0.0, sum = 0.0, best = -1.0;
  const struct particle* middle = filter->particles;
  int i, k;
  for (i = 0; i < PARTICLES; i += 10) {
    double near = 0.0;
    for (k = 0; k < PARTICLES; ++k)
      if (cos(filter->particles[k].rotation - filter->particles[i].rotation) > 0.5) near += filter->particles[k].weight;
    if (near > best) best = near, middle = &filter->particles[i];
  }
  pose[0] = pose[1] = 0.0;
  for (i = 0; i < PARTICLES; ++i) {
    const struct particle* one = &filter->particles[i];
    if (cos(one->rotation - middle->rotation) <= 0.5) continue;
    pose[0] += one->weight * one->x;
    pose[1] += one->weight * one->y;
    cosine += one->weight * cos(one->rotation);
    sine += one->weight * sin(one->rotation);
    sum += one->weight;
  }
  pose[0] /= sum;
  pose[1] /= sum;
  pose[2] = atan2(sine, cosine);
}
