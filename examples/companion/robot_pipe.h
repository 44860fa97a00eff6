// SPDX-License-Identifier: MIT
/* Replaces a robot in this example: a program at the other end of two pipes. It writes images and measurements and
 * reads requests in these structures. A team does not need this file, because it has a robot. */
#ifndef ROBOT_PIPE_H
#define ROBOT_PIPE_H

#include <stdint.h>

struct pipe_robot { /* sent once */
  char name[32];
  uint32_t width, height; /* of the images, YUYV */
  double focal[2], center[2], distortion[2], position[3], tilt;
  double posts[2]; /* x and y, m: the goal posts are at +-x, +-y on the field */
};

struct pipe_frame { /* the image follows */
  double time;
  double odometry[3], head[2], attitude[2], rates[3], acceleration[3], foot_load;
  double told_pose[3];
  uint32_t is_told; /* 1: the operator sets the initial pose, told_pose */
  uint32_t is_over; /* 1: the last frame, without an image */
  uint32_t posts;   /* number of goal posts in view, with the following bearings and distances */
  uint32_t zero;
  double bearings[4];  /* rad, positive to the left of straight ahead of the trunk, with noise */
  double distances[4]; /* m, with an error of about 10 % */
};

struct pipe_request {
  double head[3]; /* yaw, pitch, speed */
  double walk[3];
  double belief[3]; /* pose that the client believes, for the evaluation */
  uint32_t has_head, has_walk, get_up, knows;
};

#endif
