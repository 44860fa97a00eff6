// SPDX-License-Identifier: MIT
// A robot that another program drives, and that program's client beside it: what comes through the socket becomes
// observations, what the engine answers goes back (docs/companion.md). One thread: nothing here waits for the client
// but observe(), and nothing in the client ever waits for us.
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
#include "robots/companion/pending_external_inputs.h"
#include "robots/companion/shared_images.h"
#include "robots/game_controller.h"
#include "robots/robot.h"

namespace reorient {

struct CompanionOptions {
  std::filesystem::path socket;
  KnownRobots known;
  std::uint64_t server = 1;       ///< another number for each process: drawn by lot
  std::function<double()> now;    ///< s, of a clock that only goes on
  std::function<bool()> is_over;  ///< asked as often as patience says while nothing comes
  double patience = 0.1;          ///< s
};

/// What the client is told beside answers.
enum class NoteKind { fault = REORIENT_NOTE_FAULT, log = REORIENT_NOTE_LOG };

class Companion : public Robot, private Receiver {
 public:
  /// Throws std::runtime_error with one line where nobody can listen there.
  explicit Companion(CompanionOptions options);

  /// Waits until a client has said who it is. Nothing: it is over.
  const Handshake* wait_for_handshake();
  /// An engine that was made for `handshake` stands behind this from now on. `goes_on`: it knows what one before it
  /// knew.
  void begin(const Handshake& handshake, bool goes_on, int behaviors);
  /// There can be no engine for this client: it is told why, and gone.
  void refuse(const std::string& why) { connection_.refuse(why, *this); }

  /// False: it is over, or a frame has come of a client that is another robot (has_other_robot()): it waits for the
  /// engine that is made for that one.
  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;
  bool has_other_robot() const { return has_other_robot_ && has_newest_; }

  void tell_state(std::string_view behavior, std::string_view state);
  void tell_note(NoteKind kind, std::string_view text);

  /// Of all clients so far.
  struct Counts {
    std::uint64_t frames = 0;      ///< that arrived
    std::uint64_t superseded = 0;  ///< of those were not looked at, since a newer one had come
    std::uint64_t unusable = 0;  ///< of those: numbers that make no sense, a time before the last, images written over
    std::uint64_t unanswered = 0;  ///< answers that the client did not take
    std::uint64_t clients = 0;
  };
  const Counts& counts() const { return counts_; }

  /// What a process that takes this one's place has to know, but for the engine.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.clock_, self.last_time_, self.pending_, self.game_);
    if constexpr (Archive::kReads) self.last_arrival_ = self.options_.now();
  }

 private:
  struct Arrived {
    FrameMessage message;
    double at = 0.0;  ///< s, on our clock
  };

  void connected() override;
  void receive(std::uint16_t kind, std::span<const std::byte> body, OwnedDescriptor& memory) override;
  void disconnected() override;

  void take_hello(std::span<const std::byte> body);
  void take_memory(std::span<const std::byte> body, OwnedDescriptor& memory);
  void take_frame(std::span<const std::byte> body);
  void take_game(std::span<const std::byte> body);
  void take_sample(std::span<const std::byte> body);
  bool use_newest(Observation& observation);
  BodySample with_load(BodySample sample, std::uint32_t has) const;
  void take_samples(double time, bool has_time);
  bool take_images(const FrameMessage& message, double time, Observation& observation);
  void meet();
  void leave_out(std::uint64_t number, const std::string& why);
  void send_waiting();

  CompanionOptions options_;
  Connection connection_;
  Counts counts_;
  PendingCommand command_;
  ClientClock clock_;

  GameController game_;
  PendingExternalInputs pending_;

  std::optional<Handshake> handshake_;   ///< of the client that is connected
  std::optional<Handshake> engine_for_;  ///< nothing: there is no engine yet
  bool has_other_robot_ = false;         ///< they differ in their identity
  bool goes_on_ = false;
  int behaviors_ = 0;
  bool welcomed_ = false;
  std::array<std::optional<SharedImages>, 2> shared_;

  Arrived arrived_, newest_;
  bool has_newest_ = false;
  double last_arrival_ = 0.0;             ///< s, on our clock, of the frame that was looked at last, of use or not
  std::vector<reorient_sample> samples_;  ///< no frame has come yet that was exposed after them
  double last_time_ = 0.0;                ///< s, the engine's, of the frame before
  double next_complaint_ = 0.0;           ///< s, on our clock

  // What the observation looks at, until the next one.
  std::array<Image, 2> images_;
  std::vector<BodySample> body_samples_;
  std::vector<ExternalBelief::Particle> particles_;
  std::uint64_t answered_ = 0;  ///< number of the frame
  double answered_time_ = 0.0;  ///< s, on the client's clock
  double answered_at_ = 0.0;    ///< s, on ours, when it came

  /// Of each behaviour, and whether the client knows.
  std::map<std::string, std::pair<std::string, bool>, std::less<>> states_;
  std::vector<reorient_note> notes_;  ///< to be sent
  std::vector<reorient_note> words_;  ///< of behaviours to the team mates: no flood of notes takes their place
};

}  // namespace reorient
