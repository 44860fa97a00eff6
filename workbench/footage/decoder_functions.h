// SPDX-License-Identifier: MIT
/* The interface of the library that decodes images and videos by OpenCV. Plain C: the program that loads it
 * (decoder_library.h) needs nothing of OpenCV, and no program that only might need it loads FFmpeg and its kin. */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Rows from top to bottom without gaps, three bytes a pixel: blue, green, red. Valid until the next call of the
 * thread. */
struct reorient_pixels {
  int width;
  int height;
  const unsigned char* bgr;
};

/** What a library of another version does not have. */
#define REORIENT_DECODER_VERSION 2
int reorient_decoder_version(void);

/** JPEG, PNG, WebP, TIFF and others. The pixels are as stored, so the caller applies the orientation of EXIF. 0: it is
 * done; else the bytes are no image, or a damaged one. */
int reorient_decode_image(const void* bytes, size_t size, struct reorient_pixels* pixels);

/** What FFmpeg reads. NULL: it is no video. */
void* reorient_open_video(const char* file);
/** 0: success; 1: no frame is left. */
int reorient_next_frame(void* video, struct reorient_pixels* pixels);
/** From the file; 0: the file does not contain it. */
double reorient_frames_per_second(void* video);
void reorient_close_video(void* video);

#ifdef __cplusplus
}
#endif
