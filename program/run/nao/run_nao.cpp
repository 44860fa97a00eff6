// SPDX-License-Identifier: MIT
#include "program/run/nao/run_nao.h"

#include <cmath>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "program/former_names.h"
#include "program/interruption.h"
#include "program/output_mailbox.h"
#include "program/run/console/history_file.h"
#include "program/run/live/run_live_view.h"
#include "program/run/live_run.h"
#include "program/run/missing_interface.h"
#include "program/run/nao/nao_hardware.h"
#include "program/run/places.h"
#include "program/run/simulation.h"
#include "program/run/venue.h"
#include "program/safe_output.h"
#include "robots/nao/nao.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/calibration_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/places_file.h"

namespace reorient {
namespace {

using nao::Nao;

/// Sets the pose of the robot when it stands, and whenever the referee sends that all players are at their positions.
class StartPlace : public InputSource {
 public:
  StartPlace(std::optional<Pose2> now, std::optional<Pose2> initially, const Nao& robot, const FrameLoop& engine)
      : now_(std::move(now)), initially_(std::move(initially)), robot_(robot), engine_(engine) {}

  void add_to(FrameInputs& inputs) override {
    const bool is_initial = engine_.record().world.referee.state == GameState::initial;
    if (is_initial && !was_initial_ && initially_) now_ = initially_;
    was_initial_ = is_initial;
    if (!now_ || robot_.guard().state != nao::GuardState::standing) return;
    inputs.external.initial_pose = InitialPose{*std::exchange(now_, std::nullopt)};
  }

 private:
  std::optional<Pose2> now_, initially_;
  const Nao& robot_;
  const FrameLoop& engine_;
  bool was_initial_ = false;
};

}  // namespace

int run_nao(const RunOptions& options, std::ostream& out, std::ostream& err) {
  ScriptEdits edits(options.scripts);
  if (!options.model.empty()) require_writable_file(options.model, "--model");
  const std::optional<SavedModel> model = model_to_begin_with(options);
  std::optional<RecorderOptions> recording_options = recorder_options(options, "");
  const std::optional<Pose2> place = place_of(options.at);
  if (options.width != 320 && options.width != 640)
    throw std::runtime_error("--width: expected 320 or 640 pixels for a NAO, found " + std::to_string(options.width));

  const Places places = options.places.empty() ? Places() : load_places(options.places);
  if (!options.places.empty() && options.team == 0)
    throw std::runtime_error(
        "--places: expected --team, since the referee's messages are used only with the team's number, found none");
  if (!options.places.empty() && !places[static_cast<std::size_t>(options.player - 1)])
    throw std::runtime_error(fmt::format("--player {}: expected a player with a pose in {}, found none", options.player,
                                         options.places.string()));

  nao::NaoOptions robot_options;
  std::uint64_t mounting = 0;
  if (!options.calibration.empty()) {
    const Calibration calibration = load_calibration(options.calibration);
    if (calibration.recorded != RecordedAttitude())
      throw std::runtime_error(options.calibration.string() +
                               ": [footage]: expected a calibration of this robot's cameras, found one that ignores "
                               "values recorded in footage; use it with run --robot footage --camera-offset");
    robot_options.offsets = calibration.offsets;
    mounting = mounting_of(calibration);
  }
  robot_options.body = load_body(body_file(options.body));
  // LoLA provides neither, and this program contains neither.
  if (!options.walk) robot_options.body.gait.reset();
  robot_options.body.get_up_time.reset();
  robot_options.width = options.width;
  robot_options.team = options.team;
  robot_options.player = options.player;
  robot_options.stands_at_once = options.stand;

  const FieldDimensions field = load_field(field_file(options.field, robot_options.body));
  const double most_x = 0.5 * field.length + field.border, most_y = 0.5 * field.width + field.border;
  if (place && (std::abs(place->position.x()) > most_x || std::abs(place->position.y()) > most_y))
    throw std::runtime_error(
        fmt::format("--at {}: expected a position on the carpet (x from {:.1f} to {:.1f} m, y from "
                    "{:.1f} to {:.1f} m), found one beside it",
                    options.at, -most_x, most_x, -most_y, most_y));
  FrameSetup setup = engine_setup(options, edits.texts(), robot_options.body, field,
                                  {.head = true, .walk = options.walk, .get_up = false});
  setup.model = as_mounted(model, mounting);
  const std::size_t behaviors = setup.behaviors.size();
  FrameLoop engine(std::move(setup));
  warn_of_missing_values(options.scripts, engine.scripts(), files_of(engine), engine.application());
  // Before this point, nothing can be lost, so a signal ends the program at once, also while scripts load.
  const Interruption interruption;

  RunControls controls(false, false);
  controls.set_field(field);
  const OutputMailbox mailbox(out, err);
  const ConsoleSubject subject{.parameters = [&] { return engine.parameters(); },
                               .scripts = [&] { return edits.known(); },
                               .engine = [&] { return &engine; },
                               .controls = &controls};
  LiveConsole console(STDIN_FILENO, out, subject, history_path());
  const LiveViewPointer view = start_live_view(options.live, LiveLoad::light, subject, options.scripts, console, err);
  NaoHardware hardware({options.guard, options.cameras == "both", options.team > 0});
  LiveRun live(options, console, out, err);
  auto robot =
      std::make_unique<Nao>(robot_options, hardware.surroundings([&] { return is_ended_by_hand(console); },
                                                                 [&](const std::string& line) { live.tell(line); }));
  const Nao& itself = *robot;
  StartPlace start(place, places[static_cast<std::size_t>(options.player - 1)], itself, engine);
  err << fmt::format("reorient: {} on a NAO; {}\n", counted(behaviors, "behavior"),
                     options.stand ? "the robot stands up" : "press the chest button to make the robot stand up")
      << std::flush;
  RobotInstance instance{std::move(robot), robot_options.body, RobotInstance::Clock::real, nullptr, nullptr};
  live.run({.parts = {.robot = instance,
                      .engine = engine,
                      .sources = {&start},
                      .observers = {},
                      .stop = {},
                      .controls = &controls},
            .edits = &edits,
            .model = model,
            .mounting = mounting,
            .recording = std::move(recording_options),
            .live = view.get()});
  live.end_recording();
  end_live_view(view.get(), user_who_ended_run(console.wants_to_quit()), out);
  std::vector<std::string> failures;
  live.save_model(failures);
  for (const std::string& failure : failures) print_error(err, failure);
  const Nao::Counts counts = itself.counts();
  out << fmt::format(
      "{}; images: {} superseded by newer ones, {} without head angles, {} damaged; cameras restarted {}\n",
      counted(counts.frames, "frame"), counts.superseded, counts.unplaced, counts.damaged,
      counted(counts.restarts, "time"));
  return exit_code_of_runs(failures);
}

}  // namespace reorient
