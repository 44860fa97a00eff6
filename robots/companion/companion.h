// SPDX-License-Identifier: MIT
// A robot that another program controls: messages of that program's client become observations, and the engine's
// answers are sent back through the socket (docs/companion.md). Uses one thread. Only observe() waits for the client,
// and the client never waits for the server.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robots/companion/clock.h"
#include "robots/companion/commands.h"
#include "robots/companion/connection.h"
#include "robots/companion/frame_message.h"
#include "robots/companion/handshake.h"
#include "robots/companion/pending_actions.h"
#include "robots/companion/pending_external_inputs.h"
#include "robots/companion/shared_images.h"
#include "robots/game_controller.h"
#include "robots/robot.h"

namespace reorient {

struct CompanionOptions {
  std::filesystem::path socket;
  KnownRobots known;
  std::uint64_t server = 1;       ///< random number of this process
  std::function<double()> now;    ///< s, of a monotonic clock
  std::function<bool()> is_over;  ///< called every `patience` seconds while nothing arrives
  double patience = 0.1;          ///< s
  /// Called with one line for the operator, which may contain bytes of the client; may be empty.
  std::function<void(const std::string& line)> tell = {};
  bool stores_commands = false;  ///< each command waits for set_stored() before it is sent
};

/// Notes that the client gets besides answers.
enum class NoteKind { fault = REORIENT_NOTE_FAULT, log = REORIENT_NOTE_LOG };

class Companion : public Robot, private Receiver {
 public:
  /// Throws std::runtime_error with one line if the socket cannot be created.
  explicit Companion(CompanionOptions options);

  /// Waits for the hello of a client. Returns nullptr if the run is over.
  const Handshake* wait_for_handshake();
  /// Call after an engine was created for `handshake`. `continues`: it continues from the state of an earlier engine.
  void begin(const Handshake& handshake, bool continues, int behaviors);
  /// Refuses a client for which no engine can be created, and disconnects it.
  void refuse(const std::string& why) { connection_.refuse(why, *this); }

  /// Returns false if the run is over, or if a frame of another robot has arrived (has_other_robot()). That frame waits
  /// until an engine for this robot exists.
  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;
  bool has_other_robot() const { return has_other_robot_ && has_newest_; }

  /// With CompanionOptions::stores_commands: a command whose decision the caller must store before the client may see
  /// it.
  std::optional<std::uint32_t> unstored_command() const { return command_.unstored(); }
  void set_stored(std::uint32_t command) { command_.set_stored(command); }

  void tell_state(std::string_view behavior, std::string_view state);
  void tell_note(NoteKind kind, std::string_view text);

  /// Counts over all clients since the start.
  struct Counts {
    std::uint64_t frames = 0;      ///< that arrived
    std::uint64_t superseded = 0;  ///< frames not used because a newer one had arrived
    std::uint64_t unusable = 0;    ///< frames with invalid numbers, a time not after the last, or an overwritten image
    std::uint64_t unanswered = 0;  ///< answers that could not be sent
    std::uint64_t clients = 0;
    std::uint64_t percepts = 0;  ///< percepts with invalid numbers, which were dropped
  };
  const Counts& counts() const { return counts_; }

  /// The state that a new process continues from, without the engine.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.clock_, self.last_time_, self.pending_, self.game_);
    if constexpr (Archive::kReads) self.last_arrival_ = self.options_.now();
  }

 private:
  struct Arrived {
    FrameMessage message;
    double at = 0.0;  ///< s, on the server's clock
  };

  void connected() override;
  void receive(std::uint16_t kind, std::span<const std::byte> body, OwnedDescriptor& memory) override;
  void disconnected() override;
  void refused(const std::string& why) override;
  void tell(const std::string& line);

  void take_hello(std::span<const std::byte> body);
  void take_memory(std::span<const std::byte> body, OwnedDescriptor& memory);
  void take_frame(std::span<const std::byte> body);
  void take_game(std::span<const std::byte> body);
  void take_sample(std::span<const std::byte> body);
  void take_values(std::span<const std::byte> body);
  void take_report(std::span<const std::byte> body);
  bool use_newest(Observation& observation);
  BodySample with_load(BodySample sample, std::uint32_t has) const;
  void take_samples(double time, bool has_time);
  bool take_images(const FrameMessage& message, double time, Observation& observation);
  void welcome_client();
  void report_percepts();
  void drop_frame(std::uint64_t number, const std::string& why);
  void send_waiting();

  CompanionOptions options_;
  Connection connection_;
  Counts counts_;
  PendingCommand command_;
  ClientClock clock_;

  GameController game_;
  PendingExternalInputs pending_;
  PendingActions actions_;

  std::optional<Handshake> handshake_;   ///< of the connected client
  std::optional<Handshake> engine_for_;  ///< empty until an engine exists
  bool has_other_robot_ = false;         ///< the identities of these two differ
  bool continues_ = false;
  int behaviors_ = 0;
  bool welcomed_ = false;
  std::string reported_refusal_;  ///< since the last welcome
  std::array<std::optional<SharedImages>, 2> shared_;

  Arrived arrived_, newest_;
  bool has_newest_ = false;
  double last_arrival_ = 0.0;             ///< s, on the server's clock, of the last frame that was used or unusable
  std::vector<reorient_sample> samples_;  ///< waiting for a frame that was exposed after them
  double last_time_ = 0.0;                ///< s, engine's time of the previous frame
  double next_complaint_ = 0.0;           ///< s, on the server's clock
  bool reported_percepts_ = false;        ///< that this client's percepts are invalid

  // Storage of the observation, valid until the next one.
  std::array<Image, 2> images_;
  std::vector<BodySample> body_samples_;
  std::vector<ExternalBelief::Particle> particles_;
  std::vector<ExternalPercept> percepts_;
  std::uint64_t answered_ = 0;  ///< number of the frame
  double answered_time_ = 0.0;  ///< s, on the client's clock
  double answered_at_ = 0.0;    ///< s, on the server's clock, arrival time

  /// State of each behavior, and whether it was sent to the client.
  std::map<std::string, std::pair<std::string, bool>, std::less<>> states_;
  std::vector<reorient_note> notes_;  ///< to be sent
  /// Messages of behaviors to teammates, separate so that many notes do not displace them.
  std::vector<reorient_note> words_;
};

}  // namespace reorient
