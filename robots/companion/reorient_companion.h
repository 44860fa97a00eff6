// SPDX-License-Identifier: MIT
/* Reorient's companion protocol, and a client for it in C99: the one file that a team copies. It needs Linux and
 * nothing else. docs/companion.md describes the protocol byte for byte.
 *
 * Structures only:            #include "reorient_companion.h"
 * The client, in one file:    #define _GNU_SOURCE  (the first line)
 *                             #define REORIENT_COMPANION_CLIENT
 *                             #include "reorient_companion.h"  (and link with -lm)
 *
 * Units: meters, radians, seconds, kilograms. x forward, y to the left, z up; in the field's frame x points to the
 * opponents' goal and the origin is the field center. Numbers are little-endian, structures have no padding.
 */
#ifndef REORIENT_COMPANION_H
#define REORIENT_COMPANION_H

#include <stddef.h>
#include <stdint.h>

#define REORIENT_VERSION_2 2

enum {
  REORIENT_LONGEST_BODY = 1 << 16, /* bytes of a message after its header */
  REORIENT_MOST_PARTICLES = 2000,
  REORIENT_MOST_MESSAGES = 8,
  REORIENT_SLOTS = 3,                 /* images of one camera in shared memory */
  REORIENT_SLOT_HEADER = 64,          /* bytes before the pixels of each slot */
  REORIENT_LARGEST_IMAGE = 1 << 24,   /* bytes */
  REORIENT_LONGEST_TEXT = 240,        /* bytes of a message between robots */
  REORIENT_LONGEST_DATAGRAM = 256,    /* bytes of a datagram of the GameController */
  REORIENT_LONGEST_INTERFACE = 32768, /* bytes of the declarations of an application */
  REORIENT_LONGEST_VALUES = 32768,    /* bytes of the values of an application in one message */
  REORIENT_MOST_PERCEPTS = 256        /* of your own detector, in one frame */
};

/* Precedes each message. */
struct reorient_header {
  uint32_t size;    /* bytes of the message after this header */
  uint16_t kind;    /* type of the message, REORIENT_HELLO ... REORIENT_ACTION */
  uint16_t version; /* REORIENT_VERSION_2: 2 */
};

enum {
  /* from the client */
  REORIENT_HELLO = 1,
  REORIENT_MEMORY = 2,
  REORIENT_FRAME = 3,
  REORIENT_SAMPLE = 4,
  REORIENT_GAME = 5,
  REORIENT_VALUES = 6,
  REORIENT_REPORT = 7,
  /* to the client */
  REORIENT_WELCOME = 101,
  REORIENT_REFUSAL = 102,
  REORIENT_ANSWER = 103,
  REORIENT_STATE = 104,
  REORIENT_NOTE = 105,
  REORIENT_ACTION = 106
};

/* ---- hello: once, first ---- */

enum {
  REORIENT_NO_IMAGE = 0,
  REORIENT_YUYV = 1,
  REORIENT_NV12 = 2,
  REORIENT_RGB = 3,
  REORIENT_BGR = 4,
  REORIENT_GRAY = 5
};
#define REORIENT_GREY REORIENT_GRAY /* the former name */

struct reorient_camera {
  uint16_t width, height; /* pixels, even */
  uint32_t format;        /* REORIENT_YUYV ...; REORIENT_NO_IMAGE: the robot does not have this camera */
  double focal[2];        /* focal length in pixels, horizontal and vertical */
  double center[2];       /* principal point, pixels from the middle of the first pixel */
  double distortion[2];   /* radial coefficients k1, k2; 0, 0 for rectified images */
  double position[3];     /* of the camera in the head's frame, m from the second neck axis */
  double tilt;            /* of the camera in the head, rad, positive downwards */
};

enum {                            /* reorient_body.has */
       REORIENT_BODY_NUMBERS = 1, /* use the numbers below; without this bit: the robot with this name */
       REORIENT_BODY_FEET = 2,    /* load sensors in the feet */
       REORIENT_BODY_WALK = 4,
       REORIENT_BODY_GET_UP = 8
};

struct reorient_body {
  char name[32];         /* name of the robot, zero-terminated */
  uint32_t has;          /* REORIENT_BODY_... */
  uint32_t pitch_first;  /* first joint of the neck: 0 yaw, 1 pitch */
  double torso_height;   /* height of the torso's origin above the ground while standing, m */
  double first_axis[3];  /* position of the first neck axis from the torso's origin, m */
  double second_axis[3]; /* position of the second neck axis from the first, m */
  double yaw_limit;      /* largest yaw to each side, rad */
  double pitch_limit[2]; /* largest pitch upwards (negative) and downwards, rad */
  double head_speed;     /* largest speed of the head, rad/s */
  double standing_load;  /* load on both feet while standing, kg */
  double walk_limit[3];  /* largest speed forward (m/s), to the left (m/s), turning (rad/s) */
  double cruise;         /* walking speed over long distances, m/s */
};

struct reorient_field {
  char name[32]; /* name of a known field; empty: use the numbers; empty and all numbers 0: the field of the body */
  double length, width;                 /* between the middles of the outer lines, m */
  double border;                        /* width of the carpet outside the outer lines, m */
  double line_width;                    /* m */
  double penalty_area[2], goal_area[2]; /* depth, width, m */
  double penalty_mark;                  /* distance from the field center, m */
  double mark_size;                     /* length of the penalty mark from end to end, m */
  double circle_radius;                 /* center circle, to the middle of the line, m */
  double corner_radius;                 /* corner arcs, m; 0: the field has none */
  double post_y;                        /* distance of the middle of each goal post from the x axis, m */
  double goal_height;                   /* to the upper edge of the crossbar, m */
  double goal_depth;                    /* depth of the net behind the goal line, m */
  double post_diameter;                 /* m */
};

enum { REORIENT_OWN_LOCALIZATION = 1, REORIENT_OUR_LOCALIZATION = 2 };

enum { REORIENT_WANT_HEAD = 1, REORIENT_WANT_WALK = 2, REORIENT_WANT_GET_UP = 4 };

struct reorient_hello {
  uint64_t client; /* random number, drawn when your process starts; a new number: clock and odometry restarted */
  uint32_t way;    /* whose localization is used: REORIENT_OWN_LOCALIZATION, REORIENT_OUR_LOCALIZATION */
  uint32_t wants;  /* which requests of behaviors the robot carries out, sum of REORIENT_WANT_... */
  double delay;    /* age of an image when its frame arrives, s; used for frames without REORIENT_HAS_TIME */
  struct reorient_camera cameras[2]; /* upper camera, which sees the walls, and lower camera */
  struct reorient_body body;         /* the robot's dimensions and abilities */
  struct reorient_field field;       /* the field's dimensions */
};

enum {
  REORIENT_LENS_OF_CAMERA = 0, /* pinhole with the distortion of reorient_camera, as without this block */
  REORIENT_LENS_PINHOLE = 1,
  REORIENT_LENS_FISHEYE = 2,
  REORIENT_LENS_EQUIRECTANGULAR = 3
};

/* Optional: one for each camera, directly after the hello, in the same message. A server older than this block refuses
 * such a hello. */
struct reorient_lens {
  uint32_t model;         /* REORIENT_LENS_... */
  uint32_t count;         /* number of coefficients: pinhole 0, 2, 4, 5 or 8; fisheye 0 or 4; equirectangular 0 */
  double coefficients[8]; /* in OpenCV's order: k1, k2, p1, p2, k3, k4, k5, k6; fisheye: k1, k2, k3, k4 */
};

/* Optional: directly after both lenses, in the same message: values and actions of your application that behaviors use.
 * The text of an interface file (docs/applications.md) follows, `size` bytes. A server older than this block refuses
 * such a hello. Without it, a server that was started with --interface uses that one. */
struct reorient_interface {
  char name[32]; /* zero-terminated */
  uint32_t size; /* bytes of the text, at most REORIENT_LONGEST_INTERFACE; 0, only if reorient_detector follows: none */
  uint32_t zero; /* unused, 0 */
};

enum { REORIENT_PERCEPTS_WITH = 1, REORIENT_PERCEPTS_INSTEAD = 2 };

/* Optional: directly after the text of the interface, in the same message: your frames may end with reorient_percepts.
 * A server older than this block refuses such a hello. */
struct reorient_detector {
  uint32_t use;  /* REORIENT_PERCEPTS_WITH: beside Reorient's own field vision; _INSTEAD: instead of it */
  uint32_t zero; /* unused, 0 */
};

/* ---- memory: once for each camera, with a file descriptor of a memfd (SCM_RIGHTS) that has F_SEAL_SHRINK ---- */

/* Three slots, one after the other. Each starts with its sequence number (uint64_t, odd while the pixels are written).
 * Its pixels start at byte REORIENT_SLOT_HEADER. */
struct reorient_memory {
  uint32_t camera;    /* 0 upper, 1 lower */
  uint32_t slot_size; /* bytes: at least REORIENT_SLOT_HEADER + pixels; a multiple of 64 */
};

/* ---- frame ---- */

enum { /* reorient_frame.has */
       REORIENT_HAS_TIME = 1,
       REORIENT_HAS_HEAD = 2,
       REORIENT_HAS_ATTITUDE = 4,
       REORIENT_HAS_RATES = 8,
       REORIENT_HAS_ACCELERATION = 16,
       REORIENT_HAS_FOOT_LOAD = 32,
       REORIENT_HAS_BELIEF = 64, /* a pose of the team's localization; not needed for particles */
       REORIENT_HAS_TOLD_POSE = 128,
       REORIENT_HAS_REFEREE = 256,
       /* poses are in the axes of the other half: set it in each frame after half-time. A change of this bit between
          two frames is half-time; its value in the first frame of a process has no effect */
       REORIENT_OTHER_HALF = 512
};

enum { REORIENT_UNKNOWN = 0, REORIENT_UPRIGHT = 1, REORIENT_FALLING = 2, REORIENT_FALLEN = 3, REORIENT_GETTING_UP = 4 };

struct reorient_image {
  uint32_t slot;     /* slot of the image, 0 to 2 */
  uint32_t present;  /* 0: no new image of this camera; 1: new image, camera pose from the joint angles;
                        2: new image, camera pose from `pose` */
  uint64_t sequence; /* sequence number of the slot, even */
  double age;        /* how much older the image is than the frame's time, s, 0 to 1 */
  double pose[12];   /* robot from camera, three rows of four; origin on the ground below the torso, x along the
                        optical axis, y to the left, z up */
};

struct reorient_frame {
  uint64_t number;          /* increases with each frame */
  double time;              /* when the image was exposed, s, on any monotonic clock */
  uint32_t has;             /* REORIENT_HAS_... */
  uint32_t posture;         /* result of the robot's fall detection, REORIENT_UNKNOWN ... REORIENT_GETTING_UP */
  uint32_t penalized;       /* by the referee: 0 no, 1 yes */
  uint32_t particles;       /* number of particles after this structure */
  uint32_t messages;        /* number of messages after the particles */
  uint32_t done;            /* number of the last command that was carried out, 0: none */
  uint64_t done_server;     /* the server that sent this command, as in its welcome */
  double odometry[3];       /* x, y, rotation: summed since the client started, so that a lost frame loses no motion */
  double head[2];           /* yaw (positive to the left), pitch (positive downwards), rad */
  double attitude[2];       /* of the torso: roll (left side up), pitch (downwards), rad */
  double rates[3];          /* angular velocity of the torso, rad/s */
  double acceleration[3];   /* m/s^2 against free fall: (0, 0, +9.81) while the robot stands */
  double foot_load;         /* load on both feet, kg */
  double belief[3];         /* pose of the team's localization: x, y, rotation */
  double covariance[6];     /* of the belief: xx, xy, x rotation, yy, y rotation, rotation rotation */
  double told_pose[3];      /* initial pose: x, y, rotation */
  double told_deviation[2]; /* standard deviations of the initial pose, m, rad: above 0 */
  struct reorient_image images[2]; /* upper and lower camera */
};

struct reorient_particle {
  float x, y, rotation; /* pose in the field frame */
  float weight;         /* non-negative; the sum need not be 1 */
};

struct reorient_message {
  int32_t sender;  /* player number of the sender */
  uint32_t length; /* bytes of the text, 0 to 240; a terminating zero is not necessary */
  char text[REORIENT_LONGEST_TEXT];
};

/* What your own detector, for example a neural network, found in the images of the frame. */
enum { /* reorient_percept.what, and the numbers in `at` on the ground; in an image they are pixels */
       REORIENT_PERCEPT_LINE = 0,       /* x and y of one end, x and y of the other end */
       REORIENT_PERCEPT_LINE_POINT = 1, /* x, y of a point on a line; `direction` along the line is necessary */
       REORIENT_PERCEPT_GOAL_POST = 2,  /* x, y of the foot; in an image, x and y of the foot, x and y of the top */
       REORIENT_PERCEPT_L = 3,          /* x, y of an intersection of two lines */
       REORIENT_PERCEPT_T = 4,
       REORIENT_PERCEPT_X = 5,
       REORIENT_PERCEPT_PENALTY_MARK = 6,  /* x, y */
       REORIENT_PERCEPT_CENTER_CIRCLE = 7, /* x, y of the center; `direction` along the halfway line */
       REORIENT_PERCEPT_BALL = 8,          /* x, y below the ball; in an image, x and y of its center, its radius */
       REORIENT_PERCEPT_ROBOT = 9,  /* x, y, width, height (m; 0: unknown); in an image, left, top, right, bottom */
       REORIENT_PERCEPT_PERSON = 10 /* the same */
};

enum { REORIENT_ON_GROUND = 0, REORIENT_IN_UPPER_IMAGE = 1, REORIENT_IN_LOWER_IMAGE = 2 };

enum { /* reorient_percept.has */
       REORIENT_PERCEPT_DIRECTION = 1,
       REORIENT_PERCEPT_COVARIANCE = 2,
       REORIENT_PERCEPT_BASE_HIDDEN = 4 /* of a goal post: its foot is not in view, so its distance is rough */
};

struct reorient_percept {
  uint32_t what;    /* REORIENT_PERCEPT_LINE ... */
  uint32_t space;   /* REORIENT_ON_GROUND: robot coordinates at the frame's time, m; _IN_UPPER_IMAGE, _IN_LOWER_IMAGE:
                       pixels of the frame's image of this camera, from the middle of its first pixel, y downwards */
  uint32_t has;     /* REORIENT_PERCEPT_DIRECTION ... */
  float confidence; /* 0 to 1 */
  float at[4];      /* see REORIENT_PERCEPT_LINE ... */
  float direction;  /* rad to the left of x; in an image from right (0) to down (pi / 2). Of a T: along the line that
                       ends, away from the other one; of an L: between its arms; of an X: along any arm */
  float covariance[3]; /* of the point: xx, xy, yy, m^2 or pixels^2 */
};

/* After the messages of a frame, if the hello contains reorient_detector and the detector has looked at the images of
 * this frame. `count` percepts follow. */
struct reorient_percepts {
  uint32_t count; /* 0 to REORIENT_MOST_PERCEPTS */
  uint32_t zero;  /* unused, 0 */
};

/* ---- sample: sensor values of the body between two frames ---- */

struct reorient_sample {
  double time;   /* s, on the clock of the frames; used only if frames have REORIENT_HAS_TIME */
  uint32_t has;  /* REORIENT_HAS_HEAD ... REORIENT_HAS_FOOT_LOAD */
  uint32_t zero; /* unused, 0 */
  double head[2], attitude[2], rates[3], acceleration[3], foot_load;
};

/* ---- game: what the league's GameController sent, unchanged ---- */

struct reorient_game {
  uint32_t team;                               /* number of your team in the league */
  uint32_t player;                             /* player number of this robot, 1 to 20 */
  uint32_t size;                               /* bytes of the datagram */
  uint32_t zero;                               /* unused, 0 */
  uint8_t datagram[REORIENT_LONGEST_DATAGRAM]; /* RGme, version 18, 19 or 20; others are ignored */
};

/* ---- values: a JSON object, whole message, as {"ball": {"x": 1.0, "seen": true}}; used with the next frame ---- */

/* ---- report: the state of an action of the application ---- */

enum { REORIENT_ACTION_RUNNING = 1, REORIENT_ACTION_DONE = 2, REORIENT_ACTION_FAILED = 3 };

struct reorient_report {
  uint32_t id;      /* of the action */
  uint32_t state;   /* REORIENT_ACTION_... */
  char reason[120]; /* of a failure, zero-terminated */
};

/* ---- to the client ---- */

struct reorient_welcome {
  uint64_t server;    /* random number, drawn when the server starts */
  uint32_t continues; /* 1: the server continues from its state; 0: it starts without knowledge */
  uint32_t behaviors; /* number of behaviors that run */
};

/* The server closes the connection after it. */
struct reorient_refusal {
  char why[256]; /* reason, zero-terminated */
};

enum { REORIENT_FLIP = 1, REORIENT_PURGE = 2, REORIENT_RESET = 3 };

enum { /* reorient_answer.has */
       REORIENT_ANSWER_POSE = 1,
       REORIENT_ANSWER_HEAD = 2,
       REORIENT_ANSWER_WALK = 4,
       REORIENT_ANSWER_GET_UP = 8,
       REORIENT_ANSWER_ROOM = 16, /* the room can distinguish the pose from the mirrored pose now */
       REORIENT_ANSWER_TRAINING_PAUSED = 32,
       REORIENT_ANSWER_EVALUATION_PAUSED = 64
};

struct reorient_answer {
  uint64_t number;       /* number of the frame */
  double time;           /* time of the frame, s, on the client's clock */
  double took;           /* s from the frame's arrival to this answer */
  uint32_t has;          /* REORIENT_ANSWER_... */
  uint32_t zero;         /* unused, 0 */
  uint32_t command;      /* number of the command, 0: none; repeated until a frame acknowledges it */
  uint32_t command_kind; /* REORIENT_FLIP, _PURGE or _RESET: carry it out once on the team's belief */
  double current;        /* confidence in the believed pose, 0 to 1 */
  double opposite;       /* confidence in the mirrored pose, 0 to 1 */
  double evidence;       /* log-odds of the mirrored pose against the believed pose */
  double pose[3];        /* believed pose: Reorient's, or the one computed from your belief */
  double covariance[6];
  double head[3];      /* requested yaw (rad), pitch (rad) and speed (rad/s) */
  double walk[3];      /* requested m/s forward, m/s to the left, rad/s to the left; all 0: stand */
  uint64_t frames;     /* frames that arrived from all clients since the server started */
  uint64_t superseded; /* frames that were not used because a newer one had arrived */
  uint64_t unusable;   /* frames that were dropped: invalid numbers, a time not after the last, an overwritten image */
};

/* State of a behavior's state machine: after each connection and after each change. */
struct reorient_state {
  char behavior[64]; /* name of the behavior */
  char state[192];   /* for example "watching/unconfirmed"; "stopped" after too many errors */
};

enum { REORIENT_NOTE_FAULT = 1, REORIENT_NOTE_LOG = 2, REORIENT_NOTE_MESSAGE = 3 /* to the other robots */ };

struct reorient_note {
  uint32_t kind;  /* REORIENT_NOTE_...: 1 fault, 2 log line, 3 message to the other robots */
  char text[252]; /* zero-terminated */
};

/* An action of the application to begin. It is sent again after each connection until a report about it arrives, so
 * ignore an id that is not greater than the last one; reorient_is_new_action() does. */
struct reorient_action {
  uint32_t id;          /* counts from 1; starts again if `continues` of the welcome is 0 */
  uint32_t zero;        /* unused, 0 */
  char name[64];        /* of the action, zero-terminated */
  char arguments[1976]; /* JSON object, zero-terminated */
};

/* Static assertion for C99: fails to compile if the compiler adds padding. */
#define REORIENT_SIZE(type, size) typedef char reorient_size_of_##type[sizeof(struct type) == (size) ? 1 : -1]
REORIENT_SIZE(reorient_header, 8);
REORIENT_SIZE(reorient_camera, 88);
REORIENT_SIZE(reorient_body, 168);
REORIENT_SIZE(reorient_field, 160);
REORIENT_SIZE(reorient_hello, 528);
REORIENT_SIZE(reorient_lens, 72);
REORIENT_SIZE(reorient_interface, 40);
REORIENT_SIZE(reorient_detector, 8);
REORIENT_SIZE(reorient_memory, 8);
REORIENT_SIZE(reorient_image, 120);
REORIENT_SIZE(reorient_frame, 512);
REORIENT_SIZE(reorient_particle, 16);
REORIENT_SIZE(reorient_message, 248);
REORIENT_SIZE(reorient_percept, 48);
REORIENT_SIZE(reorient_percepts, 8);
REORIENT_SIZE(reorient_sample, 104);
REORIENT_SIZE(reorient_game, 272);
REORIENT_SIZE(reorient_report, 128);
REORIENT_SIZE(reorient_welcome, 16);
REORIENT_SIZE(reorient_refusal, 256);
REORIENT_SIZE(reorient_answer, 208);
REORIENT_SIZE(reorient_state, 256);
REORIENT_SIZE(reorient_note, 256);
REORIENT_SIZE(reorient_action, 2048);

/* Bytes of an image of this camera; 0: unknown format. */
static inline size_t reorient_image_bytes(const struct reorient_camera* camera) {
  const size_t pixels = (size_t)camera->width * camera->height;
  switch (camera->format) {
    case REORIENT_YUYV:
      return 2 * pixels;
    case REORIENT_NV12:
      return pixels + pixels / 2;
    case REORIENT_RGB:
    case REORIENT_BGR:
      return 3 * pixels;
    case REORIENT_GRAY:
      return pixels;
    default:
      return 0;
  }
}

#ifdef REORIENT_COMPANION_CLIENT
/* ---- the client: no call blocks ---- */
/* NOLINTBEGIN(modernize-use-nullptr): C99 has no nullptr */

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

enum { REORIENT_TOLD_FRAMES = 60 };

struct reorient_client {
  struct reorient_hello hello;
  struct reorient_lens lenses[2]; /* sent if one has a model: set them between open and the first frame */
  const char* interface_text; /* sent if not NULL: the text of an interface file; set it and the name as the lenses */
  const char* interface_name;
  uint32_t detector; /* sent if not 0: REORIENT_PERCEPTS_WITH or REORIENT_PERCEPTS_INSTEAD; set it as the lenses */
  const struct reorient_percept* percepts; /* of the next frame, see reorient_set_percepts() */
  struct reorient_percepts percepts_header;
  int has_percepts;
  uint32_t last_action; /* id of the last action that reorient_is_new_action() accepted */
  struct sockaddr_un address;
  int socket;    /* -1: not connected; use poll() to wait for messages */
  int broken;    /* sending failed; received messages, perhaps a refusal, can still be read */
  int memory[2]; /* memfd of each camera, or -1 */
  unsigned char* slots[2];
  uint32_t slot_size[2];
  uint32_t slot[2];      /* slot that is written to */
  uint64_t sequence[2];  /* sequence number of the image that was written last */
  uint64_t number;       /* number of the last frame */
  uint64_t lost;         /* frames that could not be sent */
  uint64_t server;       /* 0: no welcome yet */
  uint64_t first_number; /* number of the first frame of this connection */
  uint64_t done_server;
  uint32_t done; /* the last command that was carried out */
  /* An initial pose that the server may not have saved yet. It moves with the robot. */
  int keeps_told;
  int told_is_sent;     /* it was sent on this connection */
  int told_frames;      /* frames for which it is still stored after an answer; 0: no answer yet */
  uint64_t told_server; /* the server that answered it */
  uint64_t told_number; /* number of the last frame that contained it */
  uint32_t told_half;   /* REORIENT_OTHER_HALF if it is in the axes of the other half */
  double told_pose[3], told_deviation[2];
  double told_drift[2];    /* growth of the deviation since it was set */
  double told_odometry[3]; /* odometry of the last frame */
  size_t out_size, out_sent, in_size;
  unsigned char out[sizeof(struct reorient_header) + REORIENT_LONGEST_BODY];
  unsigned char in[sizeof(struct reorient_header) + sizeof(struct reorient_action)];
};

union reorient_event {
  struct reorient_welcome welcome;
  struct reorient_refusal refusal;
  struct reorient_answer answer;
  struct reorient_state state;
  struct reorient_note note;
  struct reorient_action action;
};

static inline void reorient_disconnect(struct reorient_client* client) {
  if (client->socket >= 0) close(client->socket);
  client->socket = -1;
  client->out_size = client->out_sent = client->in_size = 0;
  client->broken = client->told_is_sent = 0;
  client->server = 0;
}

/* Returns 0, or -1 and sets errno. `hello` is copied. */
static inline int reorient_open(struct reorient_client* client, const char* path, const struct reorient_hello* hello) {
  int camera;
  memset(client, 0, sizeof *client);
  client->hello = *hello;
  client->socket = client->memory[0] = client->memory[1] = -1;
  client->address.sun_family = AF_UNIX;
  if (strlen(path) >= sizeof client->address.sun_path) {
    errno = ENAMETOOLONG;
    return -1;
  }
  memcpy(client->address.sun_path, path, strlen(path) + 1);
  for (camera = 0; camera < 2; ++camera) {
    const size_t bytes = reorient_image_bytes(&hello->cameras[camera]);
    const size_t slot = (REORIENT_SLOT_HEADER + bytes + 63) / 64 * 64;
    void* base;
    if (bytes == 0) continue;
    if (bytes > REORIENT_LARGEST_IMAGE) {
      errno = EFBIG;
      return -1;
    }
    client->memory[camera] = memfd_create("reorient", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (client->memory[camera] < 0 || ftruncate(client->memory[camera], (off_t)(REORIENT_SLOTS * slot)) != 0 ||
        fcntl(client->memory[camera], F_ADD_SEALS, F_SEAL_SHRINK) != 0)
      return -1;
    base = mmap(NULL, REORIENT_SLOTS * slot, PROT_READ | PROT_WRITE, MAP_SHARED, client->memory[camera], 0);
    if (base == MAP_FAILED) return -1;
    client->slots[camera] = (unsigned char*)base;
    client->slot_size[camera] = (uint32_t)slot;
  }
  return 0;
}

static inline void reorient_close(struct reorient_client* client) {
  int camera;
  reorient_disconnect(client);
  for (camera = 0; camera < 2; ++camera) {
    if (client->slots[camera] != NULL)
      munmap(client->slots[camera], REORIENT_SLOTS * (size_t)client->slot_size[camera]);
    if (client->memory[camera] >= 0) close(client->memory[camera]);
    client->slots[camera] = NULL;
    client->memory[camera] = -1;
  }
}

static inline void reorient_break(struct reorient_client* client) {
  client->broken = 1;
  client->out_size = client->out_sent = 0;
}

/* Sends the rest of the last message. Returns 1 if nothing is left. */
static inline int reorient_flush(struct reorient_client* client) {
  while (client->out_sent < client->out_size) {
    const ssize_t sent = send(client->socket, client->out + client->out_sent, client->out_size - client->out_sent,
                              MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) {
      client->out_sent += (size_t)sent;
    } else {
      if (sent < 0 && errno == EINTR) continue;
      if (!(sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))) reorient_break(client);
      return 0;
    }
  }
  client->out_size = client->out_sent = 0;
  return 1;
}

static inline void reorient_append(struct reorient_client* client, const void* bytes, size_t size) {
  if (bytes != NULL && size > 0) memcpy(client->out + client->out_size, bytes, size);
  client->out_size += size;
}

static inline void reorient_begin(struct reorient_client* client, uint16_t kind, size_t size) {
  struct reorient_header header;
  header.size = (uint32_t)size;
  header.kind = kind;
  header.version = REORIENT_VERSION_2;
  reorient_append(client, &header, sizeof header);
}

/* Sends the description and the file descriptor of a camera's images. */
static inline int reorient_send_memory(struct reorient_client* client, int camera) {
  union {
    struct cmsghdr header;
    char bytes[CMSG_SPACE(sizeof(int))];
  } control;
  struct {
    struct reorient_header header;
    struct reorient_memory memory;
  } message;
  struct iovec part;
  struct msghdr all;
  if (client->memory[camera] < 0) return 1;
  memset(&all, 0, sizeof all);
  memset(&control, 0, sizeof control);
  message.header.size = sizeof message.memory;
  message.header.kind = REORIENT_MEMORY;
  message.header.version = REORIENT_VERSION_2;
  message.memory.camera = (uint32_t)camera;
  message.memory.slot_size = client->slot_size[camera];
  part.iov_base = &message;
  part.iov_len = sizeof message;
  all.msg_iov = &part;
  all.msg_iovlen = 1;
  all.msg_control = control.bytes;
  all.msg_controllen = sizeof control.bytes;
  CMSG_FIRSTHDR(&all)->cmsg_level = SOL_SOCKET;
  CMSG_FIRSTHDR(&all)->cmsg_type = SCM_RIGHTS;
  CMSG_FIRSTHDR(&all)->cmsg_len = CMSG_LEN(sizeof(int));
  memcpy(CMSG_DATA(CMSG_FIRSTHDR(&all)), &client->memory[camera], sizeof(int));
  return sendmsg(client->socket, &all, MSG_DONTWAIT | MSG_NOSIGNAL) == (ssize_t)sizeof message;
}

/* In a folder such as /tmp, any user could listen at the socket's path. */
static inline int reorient_is_trusted(int server) {
  struct ucred peer;
  socklen_t size = sizeof peer;
  return getsockopt(server, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && (peer.uid == geteuid() || peer.uid == 0);
}

/* Returns 1 if a connection exists or was made. A broken connection is closed at the second failure, so that
 * reorient_receive() can read the remaining messages before. */
static inline int reorient_connect(struct reorient_client* client) {
  struct reorient_interface interface;
  struct reorient_detector detector;
  size_t lenses, text, blocks; /* bytes */
  if (client->socket >= 0 && !client->broken) return 1;
  reorient_disconnect(client);
  client->socket = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (client->socket < 0) return 0;
  if (connect(client->socket, (const struct sockaddr*)&client->address, sizeof client->address) != 0 ||
      !reorient_is_trusted(client->socket)) {
    reorient_disconnect(client);
    return 0;
  }
  client->first_number = client->number;
  text = client->interface_text != NULL ? strlen(client->interface_text) : 0;
  if (text > REORIENT_LONGEST_INTERFACE) text = REORIENT_LONGEST_INTERFACE;
  detector.use = client->detector;
  detector.zero = 0;
  blocks = (text > 0 || detector.use != 0 ? sizeof interface + text : 0) + (detector.use != 0 ? sizeof detector : 0);
  lenses = blocks > 0 || client->lenses[0].model != 0 || client->lenses[1].model != 0 ? sizeof client->lenses : 0;
  reorient_begin(client, REORIENT_HELLO, sizeof client->hello + lenses + blocks);
  reorient_append(client, &client->hello, sizeof client->hello);
  reorient_append(client, client->lenses, lenses);
  if (blocks > 0) {
    memset(&interface, 0, sizeof interface);
    if (text > 0 && client->interface_name != NULL)
      strncpy(interface.name, client->interface_name, sizeof interface.name - 1);
    interface.size = (uint32_t)text;
    reorient_append(client, &interface, sizeof interface);
    reorient_append(client, client->interface_text, text);
    if (detector.use != 0) reorient_append(client, &detector, sizeof detector);
  }
  if (reorient_flush(client) && reorient_send_memory(client, 0) && reorient_send_memory(client, 1)) return 1;
  reorient_break(client);
  return 0;
}

/* Where to write the next image of a camera; then call reorient_image_written(). */
static inline unsigned char* reorient_image_begin(struct reorient_client* client, int camera) {
  unsigned char* slot;
  client->slot[camera] = (client->slot[camera] + 1) % REORIENT_SLOTS;
  slot = client->slots[camera] + client->slot[camera] * (size_t)client->slot_size[camera];
  __atomic_store_n((uint64_t*)(void*)slot, client->sequence[camera] + 1, __ATOMIC_RELAXED);
  __atomic_thread_fence(__ATOMIC_RELEASE);
  return slot + REORIENT_SLOT_HEADER;
}

static inline void reorient_image_written(struct reorient_client* client, int camera, struct reorient_frame* frame) {
  unsigned char* slot = client->slots[camera] + client->slot[camera] * (size_t)client->slot_size[camera];
  client->sequence[camera] += 2;
  __atomic_store_n((uint64_t*)(void*)slot, client->sequence[camera], __ATOMIC_RELEASE);
  frame->images[camera].slot = client->slot[camera];
  frame->images[camera].sequence = client->sequence[camera];
  if (frame->images[camera].present == 0) frame->images[camera].present = 1;
}

/* Stores an initial pose until an answer confirms it, and for some frames more: a server that is killed within these
 * has not saved it, and the next server gets it again. Meanwhile the pose moves with the odometry and changes the axes
 * at half-time. Odometry counts with an error of 10%, and a pose that became too uncertain is dropped. */
static inline void reorient_keep_told(struct reorient_client* client, const struct reorient_frame* frame) {
  const double pi = 3.14159265358979323846, drift = 0.1, unsure[2] = {2.0, 1.0}; /* m, rad */
  const double* now = frame->odometry;
  double added[2];
  double *pose = client->told_pose, *before = client->told_odometry, *deviation = client->told_deviation;
  if (frame->has & REORIENT_HAS_TOLD_POSE) {
    memcpy(pose, frame->told_pose, sizeof client->told_pose);
    memcpy(deviation, frame->told_deviation, sizeof client->told_deviation);
    client->keeps_told = 1;
    client->told_is_sent = client->told_frames = 0;
    client->told_drift[0] = client->told_drift[1] = 0.0;
  } else if (client->keeps_told) {
    const double x = now[0] - before[0], y = now[1] - before[1], turn = pose[2] - before[2];
    pose[0] += cos(turn) * x - sin(turn) * y;
    pose[1] += sin(turn) * x + cos(turn) * y;
    pose[2] += now[2] - before[2];
    added[0] = drift * sqrt(x * x + y * y);
    added[1] = drift * fabs(remainder(now[2] - before[2], 2.0 * pi));
    deviation[0] += added[0];
    deviation[1] += added[1];
    client->told_drift[0] += added[0];
    client->told_drift[1] += added[1];
    if ((frame->has & REORIENT_OTHER_HALF) != client->told_half) {
      pose[0] = -pose[0];
      pose[1] = -pose[1];
      pose[2] = remainder(pose[2] + pi, 2.0 * pi);
    }
    if (!(client->told_drift[0] < unsure[0] && client->told_drift[1] < unsure[1])) client->keeps_told = 0;
    if (client->told_frames > 0 && --client->told_frames == 0) client->keeps_told = 0;
  }
  memcpy(before, now, sizeof client->told_odometry);
  client->told_half = frame->has & REORIENT_OTHER_HALF;
}

/* Percepts of the next frame, from your own detector. The next reorient_send_frame() reads the array and forgets it.
 * Call it with `count` 0 if the detector found nothing; do not call it if the detector has not looked at this frame. */
static inline void reorient_set_percepts(struct reorient_client* client, const struct reorient_percept* percepts,
                                         uint32_t count) {
  client->percepts = percepts;
  client->percepts_header.count = count < REORIENT_MOST_PERCEPTS ? count : (uint32_t)REORIENT_MOST_PERCEPTS;
  client->percepts_header.zero = 0;
  client->has_percepts = client->detector != 0;
}

/* Returns 1 if the frame is sent. Returns 0 and counts it as lost if no server listens or the server is slow. Then an
 * initial pose is sent with the next frame, and without an answer again with the first frame of the next connection.
 * `frame->particles` and `frame->messages` are the lengths of the arrays. The call sets the number of the frame and of
 * the last command that was carried out, and changes nothing else. */
static inline int reorient_send_frame(struct reorient_client* client, struct reorient_frame* frame,
                                      const struct reorient_particle* particles,
                                      const struct reorient_message* messages) {
  struct reorient_frame sent;
  int ready;
  frame->number = ++client->number;
  frame->done = client->done;
  frame->done_server = client->done_server;
  reorient_keep_told(client, frame);
  ready = frame->particles <= REORIENT_MOST_PARTICLES && frame->messages <= REORIENT_MOST_MESSAGES &&
          reorient_connect(client) && reorient_flush(client);
  sent = *frame;
  if (client->keeps_told && !client->told_is_sent && client->told_frames == 0) {
    memcpy(sent.told_pose, client->told_pose, sizeof sent.told_pose);
    memcpy(sent.told_deviation, client->told_deviation, sizeof sent.told_deviation);
    sent.has |= REORIENT_HAS_TOLD_POSE;
    client->told_number = sent.number;
  }
  if (ready) {
    const size_t clouds = sent.particles * sizeof *particles, words = sent.messages * sizeof *messages;
    const size_t head = client->has_percepts ? sizeof client->percepts_header : 0;
    const size_t found = client->has_percepts ? client->percepts_header.count * sizeof *client->percepts : 0;
    reorient_begin(client, REORIENT_FRAME, sizeof sent + clouds + words + head + found);
    reorient_append(client, &sent, sizeof sent);
    reorient_append(client, particles, clouds);
    reorient_append(client, messages, words);
    reorient_append(client, &client->percepts_header, head);
    reorient_append(client, client->percepts, found);
    client->has_percepts = 0;
    reorient_flush(client);
    if (!client->broken) {
      client->told_is_sent = 1;
      return 1;
    }
  }
  client->has_percepts = 0;
  ++client->lost;
  return 0;
}

static inline int reorient_send_sample(struct reorient_client* client, const struct reorient_sample* sample) {
  if (client->socket < 0 || client->broken || !reorient_flush(client)) return 0;
  reorient_begin(client, REORIENT_SAMPLE, sizeof *sample);
  reorient_append(client, sample, sizeof *sample);
  reorient_flush(client);
  return !client->broken;
}

static inline int reorient_send_game(struct reorient_client* client, const struct reorient_game* game) {
  if (client->socket < 0 || client->broken || !reorient_flush(client)) return 0;
  reorient_begin(client, REORIENT_GAME, sizeof *game);
  reorient_append(client, game, sizeof *game);
  reorient_flush(client);
  return !client->broken;
}

/* Values of the application, a JSON object. Send them before the frame that they belong to. Returns 1 if they are sent.
 * A server that starts without knowledge (`continues` of the welcome is 0) needs all of them again. */
static inline int reorient_send_values(struct reorient_client* client, const char* json) {
  const size_t size = strlen(json);
  if (size > REORIENT_LONGEST_VALUES || !reorient_connect(client) || !reorient_flush(client)) return 0;
  reorient_begin(client, REORIENT_VALUES, size);
  reorient_append(client, json, size);
  reorient_flush(client);
  return !client->broken;
}

/* `state`: REORIENT_ACTION_... `reason` may be NULL. */
static inline int reorient_send_report(struct reorient_client* client, uint32_t id, uint32_t state,
                                       const char* reason) {
  struct reorient_report report;
  if (client->socket < 0 || client->broken || !reorient_flush(client)) return 0;
  memset(&report, 0, sizeof report);
  report.id = id;
  report.state = state;
  if (reason != NULL) strncpy(report.reason, reason, sizeof report.reason - 1);
  reorient_begin(client, REORIENT_REPORT, sizeof report);
  reorient_append(client, &report, sizeof report);
  reorient_flush(client);
  return !client->broken;
}

/* Returns 1 once for each action. */
static inline int reorient_is_new_action(struct reorient_client* client, const struct reorient_action* action) {
  if (action->id <= client->last_action) return 0;
  client->last_action = action->id;
  return 1;
}

static inline size_t reorient_size_of(uint16_t kind) {
  switch (kind) {
    case REORIENT_WELCOME:
      return sizeof(struct reorient_welcome);
    case REORIENT_REFUSAL:
      return sizeof(struct reorient_refusal);
    case REORIENT_ANSWER:
      return sizeof(struct reorient_answer);
    case REORIENT_STATE:
      return sizeof(struct reorient_state);
    case REORIENT_NOTE:
      return sizeof(struct reorient_note);
    case REORIENT_ACTION:
      return sizeof(struct reorient_action);
    default:
      return 0;
  }
}

/* Returns the type of the next message, or 0 if none has arrived. All texts are zero-terminated. */
static inline int reorient_receive(struct reorient_client* client, union reorient_event* event) {
  struct reorient_header header;
  size_t wanted = sizeof header;
  if (client->socket < 0) return 0;
  for (;;) {
    if (client->in_size >= sizeof header) {
      memcpy(&header, client->in, sizeof header);
      if (header.version != REORIENT_VERSION_2 || header.size == 0 || header.size != reorient_size_of(header.kind))
        break;
      wanted = sizeof header + header.size;
    }
    if (client->in_size == wanted && wanted > sizeof header) {
      memcpy(event, client->in + sizeof header, header.size);
      client->in_size = 0;
      if (header.kind == REORIENT_WELCOME) {
        client->server = event->welcome.server;
        if (event->welcome.continues == 0) client->last_action = 0;
        if (client->told_frames > 0 && client->told_server != client->server)
          client->told_frames = client->told_is_sent = 0;
      }
      if (header.kind == REORIENT_ANSWER && client->keeps_told && client->told_frames == 0 && client->told_is_sent &&
          event->answer.number >= client->told_number) {
        client->told_frames = REORIENT_TOLD_FRAMES;
        client->told_server = client->server;
      }
      if (header.kind == REORIENT_REFUSAL) {
        event->refusal.why[sizeof event->refusal.why - 1] = 0;
        reorient_disconnect(client);
      }
      if (header.kind == REORIENT_STATE) {
        event->state.behavior[sizeof event->state.behavior - 1] = 0;
        event->state.state[sizeof event->state.state - 1] = 0;
      }
      if (header.kind == REORIENT_ACTION) {
        event->action.name[sizeof event->action.name - 1] = 0;
        event->action.arguments[sizeof event->action.arguments - 1] = 0;
      }
      if (header.kind == REORIENT_NOTE) event->note.text[sizeof event->note.text - 1] = 0;
      return header.kind;
    }
    {
      const ssize_t got = recv(client->socket, client->in + client->in_size, wanted - client->in_size, MSG_DONTWAIT);
      if (got > 0) {
        client->in_size += (size_t)got;
      } else {
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return 0;
        break;
      }
    }
  }
  reorient_disconnect(client); /* the server ended or sent an invalid message; the next frame connects again */
  return 0;
}

/* Returns the command to carry out now, or 0. Returns each command once, although answers repeat it. Ignores commands
 * of answers to frames before this connection or before the last initial pose: they refer to an earlier belief. */
static inline int reorient_take_command(struct reorient_client* client, const struct reorient_answer* answer) {
  const int again = client->done_server == client->server && answer->command <= client->done;
  if (client->server == 0 || answer->command == 0 || again) return 0;
  if (answer->number < client->first_number || answer->number < client->told_number) return 0;
  client->done_server = client->server;
  client->done = answer->command;
  client->keeps_told = 0; /* the command changes the belief */
  return (int)answer->command_kind;
}

/* NOLINTEND(modernize-use-nullptr) */
#endif /* REORIENT_COMPANION_CLIENT */

#endif /* REORIENT_COMPANION_H */
