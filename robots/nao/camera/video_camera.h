// One of a NAO's cameras through V4L2: opened, set up, read and, where it fails, begun anew, without ever waiting for
// it. Numbers and their order: what RoboCup teams published of this camera (OV5640 behind a USB bridge), B-Human and
// HULKs above all.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "robots/nao/camera/video_device.h"

namespace reorient::nao {

struct VideoSettings {
  std::string path = "/dev/video-top";
  int width = 640;  ///< pixels: 320x240, 640x480 and 1280x960 are there
  int height = 480;
  bool upside_down = true;  ///< as the upper one is mounted
  double settling = 3.0;    ///< s for which white balance and exposure find their values before the first is locked
  int longest_exposure =
      1000;  ///< in the camera's units; in the dark the gain rises instead: a head turns while it looks
};

/// What it is about.
enum class VideoState { closed, settling, running };

class VideoCamera {
 public:
  VideoCamera(VideoDevice& device, VideoSettings settings);
  ~VideoCamera();
  VideoCamera(const VideoCamera&) = delete;
  VideoCamera& operator=(const VideoCamera&) = delete;

  struct Image {
    double time = 0.0;                   ///< s on the monotonic clock, when the exposure began
    bool is_time_guessed = false;        ///< the driver did not say; it is when the image came, less one period
    std::span<const std::uint8_t> yuyv;  ///< valid until a newer one comes, or the camera is begun anew
  };

  /// Once a frame, or whenever the descriptor is readable: goes on with what there is to be done at `now` (s,
  /// monotonic). The newest image since the last call; older ones are passed over, and counted.
  std::optional<Image> look(double now);

  VideoState state() const { return state_; }
  int descriptor() const { return device_.descriptor(); }

  struct Counts {
    std::uint64_t images = 0;
    std::uint64_t passed_over = 0;       ///< a newer one had come
    std::uint64_t damaged = 0;           ///< too short, or said to be by the driver
    std::uint64_t begun_anew = 0;        ///< the stream, or the device
    std::uint64_t refused_controls = 0;  ///< that did not take their value
  };
  const Counts& counts() const { return counts_; }

 private:
  static constexpr std::size_t kBuffers = 3;
  struct Buffer {
    void* address = nullptr;
    std::size_t length = 0;
  };

  bool begin(double now);
  bool set_format();
  bool map_buffers();
  void end();
  bool queue(std::uint32_t index);
  void set_controls();
  void set_control(std::uint32_t control, int value);
  std::optional<int> control(std::uint32_t control);
  void flip();
  void lock_colors(double now);
  void write_colors();
  void bound_exposure();
  bool extension(std::uint8_t query, std::uint8_t selector, std::span<std::uint8_t> data);

  VideoDevice& device_;
  VideoSettings settings_;
  std::array<Buffer, kBuffers> buffers_;
  VideoState state_ = VideoState::closed;
  bool streams_ = false;
  std::optional<std::uint32_t> held_;                  // the buffer of the last image
  double begun_ = 0.0;                                 // s, the stream
  double last_image_ = 0.0;                            // s
  double next_attempt_ = 0.0;                          // s
  std::array<std::optional<std::uint16_t>, 6> gains_;  // of the sensor's registers, while they are read
  std::size_t locked_ = 0;                             // how many were read
  bool has_settled_ = false;                           // once
  bool asked_ = false;                                 // for the next one
  double next_step_ = 0.0;                             // s
  Counts counts_;
};

}  // namespace reorient::nao
