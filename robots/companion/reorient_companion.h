// SPDX-License-Identifier: MIT
/* Reorient's companion protocol, and a client for it in C99: the one file that a team copies. No dependency but a POSIX
 * system that is Linux. docs/companion.md says what is sent when, byte for byte.
 *
 * Structures only:            #include "reorient_companion.h"
 * The client, in one file:    #define _GNU_SOURCE  (the first line)
 *                             #define REORIENT_COMPANION_CLIENT
 *                             #include "reorient_companion.h"  (and link with -lm)
 *
 * Metres, radians, seconds, kilograms. x forward, y to the left, z up; in the field's frame x points towards the
 * opponents' goal and the origin is the centre. Numbers are little-endian and lie as the structures say: without gaps.
 */
#ifndef REORIENT_COMPANION_H
#define REORIENT_COMPANION_H

#include <stddef.h>
#include <stdint.h>

#define REORIENT_VERSION_2 2

enum {
  REORIENT_LONGEST_BODY = 1 << 16, /* bytes of a message behind its header */
  REORIENT_MOST_PARTICLES = 2000,
  REORIENT_MOST_MESSAGES = 8,
  REORIENT_SLOTS = 3,               /* images of one camera in shared memory */
  REORIENT_SLOT_HEADER = 64,        /* bytes before the pixels of each */
  REORIENT_LARGEST_IMAGE = 1 << 24, /* bytes */
  REORIENT_LONGEST_TEXT = 240,      /* bytes of a message between robots */
  REORIENT_LONGEST_DATAGRAM = 256   /* bytes of one of the GameController's */
};

/* Before each message. */
struct reorient_header {
  uint32_t size;    /* bytes of the message behind this header */
  uint16_t kind;    /* one of those below */
  uint16_t version; /* REORIENT_VERSION_2: 2 */
};

enum {
  /* from the client */
  REORIENT_HELLO = 1,
  REORIENT_MEMORY = 2,
  REORIENT_FRAME = 3,
  REORIENT_SAMPLE = 4,
  REORIENT_GAME = 5,
  /* to the client */
  REORIENT_WELCOME = 101,
  REORIENT_REFUSAL = 102,
  REORIENT_ANSWER = 103,
  REORIENT_STATE = 104,
  REORIENT_NOTE = 105
};

/* ---- hello: once, first ---- */

enum {
  REORIENT_NO_IMAGE = 0,
  REORIENT_YUYV = 1,
  REORIENT_NV12 = 2,
  REORIENT_RGB = 3,
  REORIENT_BGR = 4,
  REORIENT_GREY = 5
};

struct reorient_camera {
  uint16_t width, height; /* pixels, even */
  uint32_t format;        /* REORIENT_YUYV ...; REORIENT_NO_IMAGE: there is no such camera */
  double focal[2];        /* pixels, along the rows and the columns */
  double center[2];       /* pixels from the middle of the first one */
  double distortion[2];   /* radial: of the square and of the fourth power; 0, 0 where images are rectified */
  double position[3];     /* in the head, from the neck's second axis */
  double tilt;            /* rad, downwards */
};

enum {                            /* reorient_body.has */
       REORIENT_BODY_NUMBERS = 1, /* the numbers below count; else the name is that of a robot that Reorient knows */
       REORIENT_BODY_FEET = 2,    /* they feel their load */
       REORIENT_BODY_WALK = 4,
       REORIENT_BODY_GET_UP = 8
};

struct reorient_body {
  char name[32];         /* ends with a zero */
  uint32_t has;          /* REORIENT_BODY_... */
  uint32_t pitch_first;  /* 0: the neck's first joint is the yaw */
  double torso_height;   /* of the torso's origin, standing */
  double first_axis[3];  /* of the neck, from the torso's origin */
  double second_axis[3]; /* from the first one */
  double yaw_limit;      /* rad, to either side */
  double pitch_limit[2]; /* rad: upwards (negative), downwards */
  double head_speed;     /* rad/s */
  double standing_load;  /* kg, on both feet */
  double walk_limit[3];  /* m/s, m/s, rad/s: forward, left, turn */
  double cruise;         /* m/s, at which it goes far */
};

struct reorient_field {
  char name[32];        /* of a field that Reorient knows; empty: the numbers count; both empty: the body's field */
  double length, width; /* between the middles of lines */
  double border;        /* carpet beyond them */
  double line_width;
  double penalty_area[2], goal_area[2]; /* depth, width */
  double penalty_mark;                  /* its distance from the field's centre */
  double mark_size;                     /* from end to end */
  double circle_radius;                 /* of the centre circle, to the middle of the line */
  double corner_radius;                 /* of the arcs at the corners; 0: there are none */
  double post_y;                        /* the middles of goal posts stand at y = +-this */
  double goal_height;                   /* to the upper edge of the crossbar */
  double goal_depth;                    /* of the net, behind the goal line */
  double post_diameter;
};

enum { REORIENT_OWN_LOCALIZATION = 1, REORIENT_OUR_LOCALIZATION = 2 };

enum { REORIENT_WANT_HEAD = 1, REORIENT_WANT_WALK = 2, REORIENT_WANT_GET_UP = 4 };

struct reorient_hello {
  uint64_t client; /* drawn by lot when your process begins; another one: clock and odometry begin anew */
  uint32_t way;    /* whose localization counts: REORIENT_OWN_LOCALIZATION, REORIENT_OUR_LOCALIZATION */
  uint32_t wants;  /* which requests of behaviours the robot carries out: REORIENT_WANT_... */
  double delay;    /* s that an image is old when its frame arrives; counts where frames bring no time */
  struct reorient_camera cameras[2]; /* the one that sees the walls, and a lower one */
  struct reorient_body body;
  struct reorient_field field;
};

enum {
  REORIENT_LENS_OF_CAMERA = 0, /* a pinhole with reorient_camera's distortion, as without this block */
  REORIENT_LENS_PINHOLE = 1,
  REORIENT_LENS_FISHEYE = 2,
  REORIENT_LENS_EQUIRECTANGULAR = 3
};

/* Optional: one for each camera, directly behind the hello and in the same message. A server from before there was this
 * block refuses such a hello. */
struct reorient_lens {
  uint32_t model;         /* REORIENT_LENS_... */
  uint32_t count;         /* of coefficients: pinhole 0, 2, 4, 5 or 8; fisheye 0 or 4; equirectangular 0 */
  double coefficients[8]; /* in OpenCV's order: k1, k2, p1, p2, k3, k4, k5, k6; of a fisheye k1, k2, k3, k4 */
};

/* ---- memory: once for each camera, with a file descriptor of a memfd (SCM_RIGHTS) that has F_SEAL_SHRINK ---- */

/* Three slots one behind the other. Each begins with its sequence number (uint64_t, odd while the pixels are written)
 * and has its pixels from byte REORIENT_SLOT_HEADER on. */
struct reorient_memory {
  uint32_t camera;    /* 0 or 1 */
  uint32_t slot_size; /* bytes, REORIENT_SLOT_HEADER and the pixels; a multiple of 64 */
};

/* ---- frame ---- */

enum { /* reorient_frame.has */
       REORIENT_HAS_TIME = 1,
       REORIENT_HAS_HEAD = 2,
       REORIENT_HAS_ATTITUDE = 4,
       REORIENT_HAS_RATES = 8,
       REORIENT_HAS_ACCELERATION = 16,
       REORIENT_HAS_FOOT_LOAD = 32,
       REORIENT_HAS_BELIEF = 64, /* a pose of the team's localization; particles say so by their number */
       REORIENT_HAS_TOLD_POSE = 128,
       REORIENT_HAS_REFEREE = 256,
       /* all in it is in the axes of the other half; in each frame from half-time on. That it is there in one frame and
          not in the next, or the other way round, is half-time; how your process begins is of no account */
       REORIENT_OTHER_HALF = 512
};

enum { REORIENT_UNKNOWN = 0, REORIENT_UPRIGHT = 1, REORIENT_FALLING = 2, REORIENT_FALLEN = 3, REORIENT_GETTING_UP = 4 };

struct reorient_image {
  uint32_t slot;     /* 0 to 2 */
  uint32_t present;  /* 0: this camera has no new image; 1: it has, and the joints say where the camera was;
                        2: it has, and the pose below says so */
  uint64_t sequence; /* of the slot, even */
  double age;        /* s that it is older than the frame's time, 0 to 1 */
  double pose[12];   /* robot from camera, three rows of four; origin on the ground below the torso, x along the
                        optical axis, y to the left, z up */
};

struct reorient_frame {
  uint64_t number;    /* counts up */
  double time;        /* s, when the image was exposed, on any clock that goes on */
  uint32_t has;       /* REORIENT_HAS_... */
  uint32_t posture;   /* as the robot says it: REORIENT_UPRIGHT ... */
  uint32_t penalized; /* 0, 1 */
  uint32_t particles; /* how many follow behind this structure */
  uint32_t messages;  /* how many follow behind those */
  uint32_t done;      /* the number of the last command that was carried out, 0: none; of the server that is: */
  uint64_t done_server;
  double odometry[3];       /* x, y, turn: summed since the client began, so that a lost frame loses none */
  double head[2];           /* yaw to the left, pitch downwards */
  double attitude[2];       /* roll (left side up), pitch (downwards) of the torso */
  double rates[3];          /* rad/s of the torso */
  double acceleration[3];   /* m/s^2 against free fall: (0, 0, +9.81) while it stands */
  double foot_load;         /* kg on both feet */
  double belief[3];         /* x, y, rotation */
  double covariance[6];     /* of it: xx, xy, x rotation, yy, y rotation, rotation rotation */
  double told_pose[3];      /* where the team is sure to be */
  double told_deviation[2]; /* m, rad: above 0 */
  struct reorient_image images[2];
};

struct reorient_particle {
  float x, y, rotation; /* in the field's frame */
  float weight;         /* 0 or more; their sum is of no account */
};

struct reorient_message {
  int32_t sender;  /* the player's number */
  uint32_t length; /* bytes of the text, 0 to 240; it needs no zero at its end */
  char text[REORIENT_LONGEST_TEXT];
};

/* ---- sample: of the body, between frames, where it is felt more often than it sees ---- */

struct reorient_sample {
  double time;  /* on the frames' clock; counts only where frames bring a time */
  uint32_t has; /* REORIENT_HAS_HEAD ... REORIENT_HAS_FOOT_LOAD */
  uint32_t zero;
  double head[2], attitude[2], rates[3], acceleration[3], foot_load;
};

/* ---- game: what the league's GameController sent, as it came ---- */

struct reorient_game {
  uint32_t team;   /* yours, as the league numbers it */
  uint32_t player; /* this robot, 1 to 20 */
  uint32_t size;   /* bytes of the datagram */
  uint32_t zero;
  uint8_t datagram[REORIENT_LONGEST_DATAGRAM]; /* RGme, version 18, 19 or 20; others do nothing */
};

/* ---- to the client ---- */

struct reorient_welcome {
  uint64_t server;    /* drawn by lot when the server began */
  uint32_t goes_on;   /* 1: it knows what it knew before; 0: it begins anew */
  uint32_t behaviors; /* how many run */
};

/* And then the connection ends. */
struct reorient_refusal {
  char why[256]; /* ends with a zero */
};

enum { REORIENT_FLIP = 1, REORIENT_PURGE = 2, REORIENT_RESET = 3 };

enum { /* reorient_answer.has */
       REORIENT_ANSWER_POSE = 1,
       REORIENT_ANSWER_HEAD = 2,
       REORIENT_ANSWER_WALK = 4,
       REORIENT_ANSWER_GET_UP = 8,
       REORIENT_ANSWER_ROOM = 16, /* the room can tell the pose from its reflection now */
       REORIENT_ANSWER_TRAINING_PAUSED = 32,
       REORIENT_ANSWER_EVALUATION_PAUSED = 64
};

struct reorient_answer {
  uint64_t number; /* of the frame */
  double time;     /* of the frame, on the client's clock */
  double took;     /* s from its arrival to this answer */
  uint32_t has;    /* REORIENT_ANSWER_... */
  uint32_t zero;
  uint32_t command;         /* its number, 0: none; repeated until a frame says that it is done */
  uint32_t command_kind;    /* REORIENT_FLIP, _PURGE, _RESET: to be carried out on the team's belief, once */
  double current, opposite; /* confidences in the believed pose and in its reflection, 0 to 1 */
  double evidence;          /* log-odds of the reflection against the believed pose */
  double pose[3];           /* the believed pose: ours, or yours as it was understood */
  double covariance[6];
  double head[3];      /* wanted yaw, pitch, and speed in rad/s */
  double walk[3];      /* wanted m/s forward, m/s to the left, rad/s to the left; all 0: stand */
  uint64_t frames;     /* that arrived, of all clients since the server began */
  uint64_t superseded; /* of those were not looked at, since a newer one had come */
  uint64_t unusable;   /* of those: numbers that make no sense, a time before the last, an image written over */
};

/* Where a behaviour's state machine is: at first, and whenever it changes. */
struct reorient_state {
  char behavior[64]; /* its name */
  char state[192];   /* as in "watching/in doubt"; "stopped" after too many errors */
};

enum { REORIENT_NOTE_FAULT = 1, REORIENT_NOTE_LOG = 2, REORIENT_NOTE_MESSAGE = 3 /* to the other robots */ };

struct reorient_note {
  uint32_t kind;  /* REORIENT_NOTE_...: 1 fault, 2 line of the log, 3 message to the other robots */
  char text[252]; /* ends with a zero */
};

/* As C99 can say it: a compiler that puts gaps anywhere stops here. */
#define REORIENT_SIZE(type, size) typedef char reorient_size_of_##type[sizeof(struct type) == (size) ? 1 : -1]
REORIENT_SIZE(reorient_header, 8);
REORIENT_SIZE(reorient_camera, 88);
REORIENT_SIZE(reorient_body, 168);
REORIENT_SIZE(reorient_field, 160);
REORIENT_SIZE(reorient_hello, 528);
REORIENT_SIZE(reorient_lens, 72);
REORIENT_SIZE(reorient_memory, 8);
REORIENT_SIZE(reorient_image, 120);
REORIENT_SIZE(reorient_frame, 512);
REORIENT_SIZE(reorient_particle, 16);
REORIENT_SIZE(reorient_message, 248);
REORIENT_SIZE(reorient_sample, 104);
REORIENT_SIZE(reorient_game, 272);
REORIENT_SIZE(reorient_welcome, 16);
REORIENT_SIZE(reorient_refusal, 256);
REORIENT_SIZE(reorient_answer, 208);
REORIENT_SIZE(reorient_state, 256);
REORIENT_SIZE(reorient_note, 256);

/* Of an image, in its format; 0: there is no such format. */
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
    case REORIENT_GREY:
      return pixels;
    default:
      return 0;
  }
}

#ifdef REORIENT_COMPANION_CLIENT
/* ---- the client: no call waits for anything ---- */
/* NOLINTBEGIN(modernize-use-nullptr): C99 has none */

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
  struct reorient_lens lenses[2]; /* sent where one of them has a model: set them between open and the first frame */
  struct sockaddr_un address;
  int socket;    /* -1: not connected; to be waited for with poll() by whoever wants to wait */
  int broken;    /* nothing can be sent any more; what has come is still to be read, a refusal perhaps */
  int memory[2]; /* memfd of each camera, or -1 */
  unsigned char* slots[2];
  uint32_t slot_size[2];
  uint32_t slot[2];      /* that is written to */
  uint64_t sequence[2];  /* of the image that was written last */
  uint64_t number;       /* of the last frame */
  uint64_t lost;         /* frames that could not be sent */
  uint64_t server;       /* 0: no welcome yet */
  uint64_t first_number; /* of the first frame of this connection */
  uint64_t done_server;
  uint32_t done; /* the last command that was carried out */
  /* A told pose of which nobody can be sure yet that it was heard, and kept. It goes with the robot. */
  int keeps_told;
  int told_is_sent;     /* on this connection */
  int told_frames;      /* for so many frames more, since it was answered; 0: it was not */
  uint64_t told_server; /* that has answered it */
  uint64_t told_number; /* of the last frame that brought one */
  uint32_t told_half;   /* REORIENT_OTHER_HALF: its axes are those */
  double told_pose[3], told_deviation[2];
  double told_drift[2];    /* of the deviation: what has been added since it was told */
  double told_odometry[3]; /* where the robot was there */
  size_t out_size, out_sent, in_size;
  unsigned char out[sizeof(struct reorient_header) + REORIENT_LONGEST_BODY];
  unsigned char in[sizeof(struct reorient_header) + 512];
};

union reorient_event {
  struct reorient_welcome welcome;
  struct reorient_refusal refusal;
  struct reorient_answer answer;
  struct reorient_state state;
  struct reorient_note note;
};

static inline void reorient_disconnect(struct reorient_client* client) {
  if (client->socket >= 0) close(client->socket);
  client->socket = -1;
  client->out_size = client->out_sent = client->in_size = 0;
  client->broken = client->told_is_sent = 0;
  client->server = 0;
}

/* 0; or -1, and errno says why. `hello` is copied. */
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

/* Sends what is left of the last message. 1: there is nothing left. */
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

/* With the file descriptor of a camera's images. */
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

/* Where the socket lies in a folder that is everybody's, as /tmp, anybody may listen there. */
static inline int reorient_is_trusted(int server) {
  struct ucred peer;
  socklen_t size = sizeof peer;
  return getsockopt(server, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && (peer.uid == geteuid() || peer.uid == 0);
}

/* 1: there is a connection, new or old. One that broke is left when it breaks for the second time: between the two
 * reorient_receive() has had its chance. */
static inline int reorient_connect(struct reorient_client* client) {
  size_t lenses; /* bytes */
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
  lenses = client->lenses[0].model != 0 || client->lenses[1].model != 0 ? sizeof client->lenses : 0;
  reorient_begin(client, REORIENT_HELLO, sizeof client->hello + lenses);
  reorient_append(client, &client->hello, sizeof client->hello);
  reorient_append(client, client->lenses, lenses);
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

/* A told pose waits until it was heard, and for some frames more: a server that is killed within these has not kept it,
 * and the next one is told again. Meanwhile it goes with the robot and into the axes of the other half; odometry
 * is taken to be wrong by a tenth, and what nobody can be sure of any more is forgotten. */
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

/* 1: it is on its way. 0: it is lost, and counted, since there is no server or it is slow. A told pose goes with the
 * next frame then, and with the first one of another connection where no answer has come. `frame->particles` and
 * `frame->messages` say how many there are of both. The number of the frame, and of the last command that was carried
 * out, are filled in; the rest stays as it is. */
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
    reorient_begin(client, REORIENT_FRAME, sizeof sent + clouds + words);
    reorient_append(client, &sent, sizeof sent);
    reorient_append(client, particles, clouds);
    reorient_append(client, messages, words);
    reorient_flush(client);
    if (!client->broken) {
      client->told_is_sent = 1;
      return 1;
    }
  }
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
    default:
      return 0;
  }
}

/* The next message, if one has come: its kind. 0: none. Texts end with a zero, whatever came. */
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
  reorient_disconnect(client); /* it has ended, or is no server of ours; the next frame connects again */
  return 0;
}

/* The kind of the command to be carried out now, 0: none. Each is told once, however often it is repeated; none of an
 * answer from before this connection, and none where the team was told another pose meanwhile, since it was meant for
 * the belief before. */
static inline int reorient_take_command(struct reorient_client* client, const struct reorient_answer* answer) {
  const int again = client->done_server == client->server && answer->command <= client->done;
  if (client->server == 0 || answer->command == 0 || again) return 0;
  if (answer->number < client->first_number || answer->number < client->told_number) return 0;
  client->done_server = client->server;
  client->done = answer->command;
  client->keeps_told = 0; /* the belief is another one now */
  return (int)answer->command_kind;
}

/* NOLINTEND(modernize-use-nullptr) */
#endif /* REORIENT_COMPANION_CLIENT */

#endif /* REORIENT_COMPANION_H */
