// SPDX-License-Identifier: MIT
// A NAO v6 without a team's program: its cameras, its body through the guard, the referee. It moves the head, stands up
// and sits down. It does not get up and needs a separate program to walk (docs/on-a-robot.md).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/camera_offset.h"
#include "robots/camera_pairing.h"
#include "robots/game_controller.h"
#include "robots/nao/body_history.h"
#include "robots/nao/camera/video_camera.h"
#include "robots/nao/chest_button.h"
#include "robots/nao/guard/shared_body.h"
#include "robots/robot.h"
#include "robots/robot_body.h"

namespace reorient::nao {

/// Input that is missing.
enum class Missing { nothing, guard, measurements, images };

/// Receives the datagrams of the referee and answers them.
class RefereePort {
 public:
  virtual ~RefereePort() = default;
  /// Returns the next datagram, valid until the next call, or an empty span. Never blocks.
  virtual std::span<const std::byte> receive() = 0;
  /// Accepts only the sender of the last datagram for a while, because it was about our game.
  virtual void accept_sender() = 0;
  /// Sends a datagram to the sender of the last one.
  virtual void answer(std::span<const std::byte> datagram) = 0;
};

struct NaoOptions {
  RobotBody body;                       ///< assets/robots/nao-v6.toml
  int width = 640;                      ///< of the images, pixels; the body's cameras determine the height
  std::array<CameraOffset, 2> offsets;  ///< of the upper and the lower camera
  double image_delay = 0.0;             ///< s from the driver's time of an image to the middle of its exposure
  int team = 0, player = 0;             ///< 0: datagrams of the referee are ignored
  bool stands_at_once = false;          ///< stand up at the start, without a press of the chest button
};

/// Access to the system, replaced by tests.
struct NaoSurroundings {
  std::function<double()> now;  ///< s, monotonic
  /// Waits until one of the descriptors is readable, at most `seconds`.
  std::function<void(double seconds, std::span<const int> descriptors)> wait;
  std::function<bool()> is_over;
  /// Returns the memory that is shared with the guard, or nullptr if no guard runs.
  std::function<SharedBody*()> body;
  /// Called once for each input that is missing for 2 s, until all inputs arrive again; may be empty.
  std::function<void(Missing what)> tell_missing;
  std::function<void(const std::string& line)> tell;  ///< called with one line for the operator; may be empty
  RunErrand run_errand = run_at_once;                 ///< runs calls of a camera that may take seconds
  VideoDevice* upper = nullptr;
  VideoDevice* lower = nullptr;    ///< nullptr: only the upper camera is used
  RefereePort* referee = nullptr;  ///< nullptr: no datagrams are received
};

class Nao : public Robot {
 public:
  Nao(NaoOptions options, NaoSurroundings surroundings);
  /// Requests the guard to sit down.
  ~Nao() override;
  Nao(const Nao&) = delete;
  Nao& operator=(const Nao&) = delete;

  /// Returns false if the run is over or the chest button was pressed for 3 s.
  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;

  /// The input that is missing at present, and for how long (s).
  Missing missing() const { return missing_; }
  double missing_for() const { return missing_for_; }
  /// The last report of the guard: its state and warnings.
  const GuardReport& guard() const { return guard_; }
  bool is_paused() const { return paused_; }

  struct Counts {
    std::uint64_t frames = 0;
    std::uint64_t superseded = 0;  ///< images not used because a newer one had arrived
    std::uint64_t unplaced = 0;    ///< images without known head angles
    std::uint64_t damaged = 0;     ///< images
    std::uint64_t restarts = 0;    ///< cameras
  };
  Counts counts() const;

 private:
  struct Eye {
    Eye(VideoDevice& device, const CameraModel& optics, HeadCamera which, const RunErrand& run_errand);
    CameraModel model;
    VideoCamera camera;
  };

  bool read_body(double now);
  void press_button(const Measurement& measurement);
  void read_referee(double now);
  void read_image(HeadCamera which, double now);
  void send_request(double now);
  void note_missing(Missing what, double now);
  double engine_time(double monotonic) const { return monotonic - start_; }

  NaoOptions options_;
  NaoSurroundings around_;
  double start_;  // s, monotonic: when the engine's clock began
  std::optional<Eye> upper_, lower_;
  CameraPairing pairing_;
  BodyHistory history_;
  std::uint64_t seen_ = 0;  // measurements
  std::vector<Measurement> news_;
  std::vector<BodySample> body_samples_, given_;  // those for later frames, and those of the present frame
  ChestButton chest_;
  GuardReport guard_;
  GameController game_;
  double next_return_ = 0.0;  // s
  ExternalInputs external_;

  WantedPosture posture_ = WantedPosture::sit;
  bool stands_when_possible_;  // as the option requests; until the guard has read a request to sit
  bool paused_ = false;
  bool ends_ = false;
  Answer answer_;
  std::optional<double> answered_;  // s, monotonic: when the engine processed the last frame
  Missing missing_ = Missing::nothing;
  Missing reported_missing_ = Missing::nothing;     // the last one that was reported
  double missing_since_ = 0.0, missing_for_ = 0.0;  // s
  Counts counts_;
};

}  // namespace reorient::nao
