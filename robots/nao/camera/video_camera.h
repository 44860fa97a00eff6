// SPDX-License-Identifier: MIT
// One of a NAO's cameras through V4L2: opens, configures and reads it, and restarts it after a failure. Slow calls run
// in another thread and do not block. The numbers and their order are from publications of RoboCup teams about this
// camera (OV5640 behind a USB bridge), mainly B-Human and HULKs.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <optional>
#include <span>
#include <string>

#include "robots/nao/camera/video_device.h"

namespace reorient::nao {

struct VideoSettings {
  std::string path = "/dev/video-top";
  int width = 640;  ///< pixels; the camera supports 320x240, 640x480 and 1280x960
  int height = 480;
  bool upside_down = true;  ///< the upper camera is mounted so
  double settling = 3.0;    ///< s for which white balance and exposure adapt before white balance is locked
  /// In the camera's units. In darkness the gain increases instead, because the head moves during an exposure.
  int longest_exposure = 1000;
};

/// The state of a camera.
enum class VideoState { closed, settling, running };

/// Runs a function, at once or in a thread of its own, and returns its result.
using RunErrand = std::function<std::future<bool>(std::function<bool()>)>;
std::future<bool> run_at_once(const std::function<bool()>& errand);
std::future<bool> run_apart(std::function<bool()> errand);

class VideoCamera {
 public:
  VideoCamera(VideoDevice& device, VideoSettings settings, RunErrand run = run_at_once);
  /// Waits for a running errand.
  ~VideoCamera();
  VideoCamera(const VideoCamera&) = delete;
  VideoCamera& operator=(const VideoCamera&) = delete;

  struct Image {
    double time = 0.0;                   ///< s on the monotonic clock, when the exposure began
    bool is_time_guessed = false;        ///< the driver gave no time; it is the arrival time minus one period
    std::span<const std::uint8_t> yuyv;  ///< valid until the next image or a restart of the camera
  };

  /// Once a frame, or whenever the descriptor is readable: continues the work that is due at `now` (s,
  /// monotonic). Returns the newest image since the last call; older images are skipped and counted as superseded.
  std::optional<Image> look(double now);

  VideoState state() const { return state_; }
  /// Descriptor to wait for, or -1.
  int descriptor() const { return is_the_devices_ ? -1 : device_.descriptor(); }

  struct Counts {
    std::uint64_t images = 0;
    std::uint64_t superseded = 0;        ///< images not used because a newer one had arrived
    std::uint64_t damaged = 0;           ///< images that are too short or that the driver marks as damaged
    std::uint64_t restarts = 0;          ///< of the stream or the device
    std::uint64_t refused_controls = 0;  ///< controls that could not be set
  };
  Counts counts() const {
    Counts all = counts_;
    all.refused_controls = refused_controls_;
    return all;
  }

 private:
  static constexpr std::size_t kBuffers = 3;
  struct Buffer {
    void* address = nullptr;
    std::size_t length = 0;
  };

  enum class Errand { begin, end, lock_colors };
  void run(Errand what, double now);
  bool is_busy(double now);
  void is_done(Errand what, bool succeeded, double now);

  // Errands and their steps.
  bool begin();
  bool set_format();
  bool map_buffers();
  void end();
  bool lock_colors();

  bool queue(std::uint32_t index);
  void set_controls();
  void set_control(std::uint32_t control, int value);
  std::optional<int> control(std::uint32_t control);
  void flip();
  void write_colors();
  void bound_exposure();
  void write_exposure();
  bool extension(std::uint8_t query, std::uint8_t selector, std::span<std::uint8_t> data);

  VideoDevice& device_;
  VideoSettings settings_;
  RunErrand run_;
  VideoState state_ = VideoState::closed;
  double begun_ = 0.0;         // s, start of the stream
  double last_image_ = 0.0;    // s
  double next_attempt_ = 0.0;  // s
  double next_step_ = 0.0;     // s
  bool has_settled_ = false;   // at least once
  Counts counts_;
  std::future<bool> errand_;  // the running one
  Errand what_ = Errand::begin;
  bool is_the_devices_ = false;  // the errand opens or closes the device: no other call may use it

  // Used only by the errand while it starts or ends the stream.
  std::array<Buffer, kBuffers> buffers_;
  bool streams_ = false;
  std::optional<std::uint32_t> held_;  // buffer of the last image

  // Used only by errands, which never run at the same time.
  struct Exposure {
    int exposure, gain;  // in the camera's units
  };
  std::array<std::optional<std::uint16_t>, 6> gains_;  // values of the sensor's registers
  std::size_t locked_ = 0;                             // number of registers that were read
  bool asked_ = false;                                 // the address of the next register was sent
  bool has_colors_ = false;                            // the gains are known, and whether the exposure is fixed
  std::optional<Exposure> fixed_;
  std::atomic<std::uint64_t> refused_controls_ = 0;
};

}  // namespace reorient::nao
