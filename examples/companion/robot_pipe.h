// SPDX-License-Identifier: MIT
/* What stands in for a robot in this example: a program at the other end of two pipes. It writes what the robot sees
 * and feels, and reads what it shall do, as these structures say. A team has its own robot, and none of this. */
#ifndef ROBOT_PIPE_H
#define ROBOT_PIPE_H

#include <stdint.h>

struct pipe_robot { /* once */
  char name[32];
  uint32_t width, height; /* of its images, YUYV */
  double focal[2], center[2], distortion[2], position[3], tilt;
  double posts[2]; /* goal posts stand at +-x, +-y on the field */
};

struct pipe_frame { /* then the image */
  double time;
  double odometry[3], head[2], attitude[2], rates[3], acceleration[3], foot_load;
  double told_pose[3];
  uint32_t is_told; /* 1: the operator sets the initial pose, told_pose */
  uint32_t is_over; /* nothing follows, and there is no image */
  uint32_t posts;   /* goal posts in view: */
  uint32_t zero;
  double bearings[4];  /* rad to the left of where its trunk looks, with noise */
  double distances[4]; /* m, rough: a tenth off */
};

struct pipe_request {
  double head[3]; /* yaw, pitch, speed */
  double walk[3];
  double belief[3]; /* where the client believes that it is, for the judge */
  uint32_t has_head, has_walk, get_up, knows;
};

#endif
