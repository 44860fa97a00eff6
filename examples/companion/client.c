// SPDX-License-Identifier: MIT
/* client SOCKET own|ours ROBOT [ARGUMENT...]: connects a robot with Reorient. "own": the robot has its own
 * localization, particle_filter.c, to which it applies Reorient's commands; "ours": Reorient localizes the robot. ROBOT
 * is a program that replaces a robot (robot_pipe.h). Ends with the exit code of ROBOT. */
#define _GNU_SOURCE
#define REORIENT_COMPANION_CLIENT
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/random.h>
#include <sys/wait.h>

#include "particle_filter.h"
#include "reorient_companion.h"
#include "robot_pipe.h"

static struct reorient_client client;
static struct particle_filter filter;

static int read_all(int from, void* to, size_t size) {
  char* at = to;
  while (size > 0) {
    const ssize_t got = read(from, at, size);
    if (got <= 0) return 0;
    at += got;
    size -= (size_t)got;
  }
  return 1;
}

static pid_t start_robot(char** arguments, int* from, int* to) {
  int out[2], in[2];
  pid_t child;
  if (pipe(out) != 0 || pipe(in) != 0) exit(2);
  child = fork();
  if (child == 0) {
    dup2(in[0], 0);
    dup2(out[1], 1);
    close(in[1]);
    close(out[0]);
    execv(arguments[0], arguments);
    _exit(127);
  }
  close(in[0]);
  close(out[1]);
  *from = out[0];
  *to = in[1];
  return child;
}

static void apply(int command) {
  if (command == REORIENT_FLIP) filter_flip(&filter);
  if (command == REORIENT_PURGE) filter_purge(&filter);
  if (command == REORIENT_RESET) filter_reset(&filter);
}

static void copy(double* to, const double* from, int count) { memcpy(to, from, (size_t)count * sizeof *to); }

/* Waits for the answer to this frame. 0: only reads the messages that have arrived; a robot always does that, because
 * it must not wait. */
static int await(uint64_t number, struct reorient_answer* answer) {
  int tries, kind;
  for (tries = 0; tries < 20; ++tries) {
    union reorient_event event;
    struct pollfd wait = {client.socket, POLLIN, 0};
    while ((kind = reorient_receive(&client, &event)) != 0) {
      if (kind == REORIENT_REFUSAL) fprintf(stderr, "refused: %s\n", event.refusal.why);
      if (kind != REORIENT_ANSWER) continue;
      *answer = event.answer;
      apply(reorient_take_command(&client, answer));
      if (answer->number >= number) return 1;
    }
    if (client.socket < 0 || number == 0) return 0;
    poll(&wait, 1, 100);
  }
  return 0;
}

int main(int count, char** words) {
  struct pipe_robot robot;
  struct pipe_frame felt;
  struct reorient_hello hello = {0};
  static struct reorient_particle cloud[PARTICLES];
  int from, to, own, status, i;
  pid_t child;
  if (count < 4) return fprintf(stderr, "client SOCKET own|ours ROBOT [ARGUMENT...]\n"), 2;
  own = strcmp(words[2], "own") == 0;
  child = start_robot(words + 3, &from, &to);
  if (!read_all(from, &robot, sizeof robot)) return 2;
  if (getrandom(&hello.client, sizeof hello.client, 0) < 0) return perror("client"), 2;
  hello.way = own ? REORIENT_OWN_LOCALIZATION : REORIENT_OUR_LOCALIZATION;
  hello.wants = REORIENT_WANT_HEAD | REORIENT_WANT_WALK | REORIENT_WANT_GET_UP;
  memcpy(hello.body.name, robot.name, sizeof robot.name);
  hello.cameras[0].width = (uint16_t)robot.width;
  hello.cameras[0].height = (uint16_t)robot.height;
  hello.cameras[0].format = REORIENT_YUYV;
  copy(hello.cameras[0].focal, robot.focal, 2);
  copy(hello.cameras[0].center, robot.center, 2);
  copy(hello.cameras[0].distortion, robot.distortion, 2);
  copy(hello.cameras[0].position, robot.position, 3);
  hello.cameras[0].tilt = robot.tilt;
  if (reorient_open(&client, words[1], &hello) != 0) return perror("client"), 2;
  filter_begin(&filter, robot.posts[0], robot.posts[1], 1);
  while (read_all(from, &felt, sizeof felt) && !felt.is_over) {
    struct reorient_frame frame = {0};
    struct reorient_answer answer = {0};
    struct pipe_request request = {0};
    if (!read_all(from, reorient_image_begin(&client, 0), 2 * (size_t)robot.width * robot.height)) break;
    reorient_image_written(&client, 0, &frame);
    frame.time = felt.time;
    frame.has = REORIENT_HAS_TIME | REORIENT_HAS_HEAD | REORIENT_HAS_ATTITUDE | REORIENT_HAS_RATES |
                REORIENT_HAS_ACCELERATION | (felt.foot_load >= 0.0 ? REORIENT_HAS_FOOT_LOAD : 0);
    copy(frame.odometry, felt.odometry, 3);
    copy(frame.head, felt.head, 2);
    copy(frame.attitude, felt.attitude, 2);
    copy(frame.rates, felt.rates, 3);
    copy(frame.acceleration, felt.acceleration, 3);
    frame.foot_load = felt.foot_load;
    if (own && felt.is_told) filter_set_pose(&filter, felt.told_pose);
    if (felt.is_told) {
      frame.has |= REORIENT_HAS_TOLD_POSE;
      copy(frame.told_pose, felt.told_pose, 3);
      frame.told_deviation[0] = frame.told_deviation[1] = 0.1;
    }
    if (own) {
      filter_move(&filter, felt.odometry);
      filter_see(&filter, felt.bearings, felt.distances, felt.posts);
      for (i = 0; i < PARTICLES; ++i) {
        const struct particle* one = &filter.particles[i];
        cloud[i].x = (float)one->x, cloud[i].y = (float)one->y;
        cloud[i].rotation = (float)one->rotation, cloud[i].weight = (float)one->weight;
      }
      frame.particles = filter.knows ? PARTICLES : 0;
    }
    if (await(reorient_send_frame(&client, &frame, cloud, NULL) ? frame.number : 0, &answer)) {
      request.has_head = (answer.has & REORIENT_ANSWER_HEAD) != 0;
      request.has_walk = (answer.has & REORIENT_ANSWER_WALK) != 0;
      request.get_up = (answer.has & REORIENT_ANSWER_GET_UP) != 0;
      copy(request.head, answer.head, 3);
      copy(request.walk, answer.walk, 3);
    }
    request.knows = own ? (uint32_t)filter.knows : (answer.has & REORIENT_ANSWER_POSE) != 0;
    copy(request.belief, answer.pose, 3);
    if (own) filter_mean(&filter, request.belief);
    if (write(to, &request, sizeof request) != (ssize_t)sizeof request) break;
  }
  close(to);
  reorient_close(&client);
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}
