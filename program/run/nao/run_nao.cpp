#include "program/run/nao/run_nao.h"

#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <time.h>

#include "program/interruption.h"
#include "program/model/model_keeper.h"
#include "program/program.h"
#include "program/run/console/history_file.h"
#include "program/run/console/live_console.h"
#include "program/run/run_observers.h"
#include "program/run/script_edits.h"
#include "program/run/shipped_behaviors.h"
#include "program/run/simulation.h"
#include "program/run/timeline_printer.h"
#include "program/run/venue.h"
#include "program/script_names.h"
#include "robots/nao/nao.h"
#include "robots/nao/udp_referee.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/run/run_loop.h"

namespace reorient {
namespace {

using nao::MappedBody;
using nao::Nao;

/// The clock of LoLA's packets and of V4L2's images.
double monotonic_clock() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void wait_for(double seconds, std::span<const int> descriptors) {
  std::array<pollfd, 2> waits{};
  nfds_t count = 0;
  for (const int descriptor : descriptors) {
    if (descriptor >= 0 && count < waits.size()) waits[count++] = {descriptor, POLLIN, 0};
  }
  poll(waits.data(), count, static_cast<int>(1000.0 * seconds));
}

/// The memory that the guard has made, as soon as there is one; tried again once a second.
class GuardsMemory {
 public:
  explicit GuardsMemory(std::filesystem::path file) : file_(std::move(file)) {}

  nao::SharedBody* operator()(double now) {
    if (!body_ && now >= next_) {
      next_ = now + 1.0;
      body_ = std::make_unique<MappedBody>(file_, MappedBody::Side::engine);
      if (!*body_) body_.reset();
    }
    return body_ ? &**body_ : nullptr;
  }

 private:
  std::filesystem::path file_;
  std::unique_ptr<MappedBody> body_;
  double next_ = 0.0;
};

/// Tells where the robot stands, once it stands.
class StartPlace : public InputSource {
 public:
  StartPlace(std::optional<Pose2> place, const Nao& robot) : place_(std::move(place)), robot_(robot) {}

  void add_to(FrameInputs& inputs) override {
    if (!place_ || robot_.guard().state != nao::GuardState::standing) return;
    inputs.told.initial_pose = InitialPose{*std::exchange(place_, std::nullopt)};
  }

 private:
  std::optional<Pose2> place_;
  const Nao& robot_;
};

/// X,Y,DEGREES in the field's frame. Throws std::runtime_error with one line.
std::optional<Pose2> place_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  double x = 0.0, y = 0.0, degrees = 0.0;
  char rest = 0;
  constexpr double kFarthest = 30.0;  // m
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &x, &y, &degrees, &rest) != 3 || !(std::abs(x) <= kFarthest) ||
      !(std::abs(y) <= kFarthest) || !(std::abs(degrees) <= 360.0))
    throw std::runtime_error("--at " + text + ": a place is X,Y,DEGREES in m, m and degrees, as in --at -3.2,-3.5,90");
  return Pose2(x, y, from_degrees(degrees));
}

std::string told_of(const Nao& robot) {
  switch (robot.missing()) {
    case Nao::Missing::guard:
      return "no guard is there; start reorient-nao-guard";
    case Nao::Missing::measurements:
      return "the guard hears nothing of the body; is LoLA running?";
    case Nao::Missing::images:
      return "no image comes from /dev/video-top, or its colours are still settling";
    case Nao::Missing::nothing:
      break;
  }
  return "";
}

}  // namespace

int run_nao(const RunOptions& options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  ScriptEdits edits(options.scripts);
  if (!options.model.empty()) require_writable_file(options.model, "--model");
  const std::optional<SavedModel> model = model_to_begin_with(options);
  const std::optional<Pose2> place = place_of(options.at);
  if (options.width != 320 && options.width != 640)
    throw std::runtime_error("--width " + std::to_string(options.width) + ": a NAO's cameras give 320 or 640 pixels");

  nao::NaoOptions robot_options;
  robot_options.body = load_body(body_file(options.body));
  // LoLA has neither, and we do not bring them.
  robot_options.body.gait.reset();
  robot_options.body.get_up_time.reset();
  robot_options.width = options.width;
  robot_options.height = options.width * 3 / 4;
  robot_options.team = options.team;
  robot_options.player = options.player;
  robot_options.stands_at_once = options.stand;

  FrameSetup setup;
  setup.body = robot_options.body;
  setup.field = load_field(field_file(options.field.empty() ? setup.body.field : options.field.string()));
  setup.seed = options.seed;
  setup.room_awareness = options.room_awareness;
  setup.scripts = edits.texts();
  setup.parameters = overrides_of(options.parameters);
  setup.model = model;
  const std::vector<std::string> wanted =
      options.behaviors.empty() ? behaviors_for({true, false, false}) : options.behaviors;
  for (const std::string& name : wanted) setup.behaviors.push_back(behavior_file(options.scripts, setup.scripts, name));
  FrameLoop engine(std::move(setup));

  LiveConsole console(STDIN_FILENO, out,
                      {.scenario = nullptr,
                       .parameters = [&] { return engine.parameters(); },
                       .kept_parameters = [] { return std::vector<ParameterChange>(); },
                       .scripts = options.scripts},
                      history_path());
  const auto is_over = [&] { return Interruption::signal() != 0 || console.wants_to_quit(); };
  GuardsMemory memory(options.guard.empty() ? nao::default_body_file() : options.guard);
  nao::SystemVideoDevice upper, lower;
  std::unique_ptr<nao::UdpReferee> referee;
  if (options.team > 0)
    referee = std::make_unique<nao::UdpReferee>(kGameControllerPort, kGameControllerReturnPort, monotonic_clock);
  nao::NaoSurroundings around;
  around.now = monotonic_clock;
  around.wait = wait_for;
  around.body = [&memory] { return memory(monotonic_clock()); };
  around.upper = &upper;
  around.lower = options.cameras == "both" ? &lower : nullptr;
  around.referee = referee.get();
  // What is missing is told when it has been missing for a while, and once.
  const Nao* robot_now = nullptr;
  Nao::Missing told = Nao::Missing::nothing;
  around.is_over = [&] {
    constexpr double kWhile = 2.0;  // s
    if (robot_now != nullptr && robot_now->missing() != told && robot_now->missing_for() > kWhile) {
      told = robot_now->missing();
      console.make_room();
      err << "reorient: " << told_of(*robot_now) << '\n' << std::flush;
    }
    return is_over();
  };

  auto robot = std::make_unique<Nao>(robot_options, around);
  robot_now = robot.get();
  StartPlace start(place, *robot);
  err << fmt::format("reorient: {} behaviours on a NAO; {}\n", wanted.size(),
                     options.stand ? "it stands up" : "press its chest's button, and it stands up")
      << std::flush;
  RunLog log;
  const RoomForLog room_for_log([&] { console.make_room(); });
  Progress progress(err, [&] { return console.is_open(); });
  TimelinePrinter timeline(out, options.every_transition, [&] {
    progress.make_room();
    console.begin_line();
  });
  std::optional<ModelKeeper> model_keeper;
  if (!options.model.empty()) model_keeper.emplace(options.model, model, options.sides_changed);
  RobotInstance instance{std::move(robot), robot_options.body, RobotInstance::Clock::real, nullptr, nullptr};
  RunParts parts{instance, engine, nullptr, nullptr, {&edits, &console, &start}, {&log, &timeline}, {}, 0.0, false};
  if (model_keeper) parts.observers.push_back(&*model_keeper);
  parts.observers.push_back(&progress);
  parts.observers.push_back(&console);
  parts.stop = is_over;
  RunLoop(std::move(parts)).run();
  progress.end();
  if (model_keeper) model_keeper->save();
  const Nao::Counts counts = robot_now->counts();
  out << fmt::format(
      "{} frames; {} images not looked at since a newer one had come, {} of which nobody knows where the head was, {} "
      "damaged; cameras begun anew {} times\n",
      counts.frames, counts.passed_over, counts.unplaced, counts.damaged, counts.begun_anew);
  return Interruption::signal() != 0 ? exit_code_of(Interruption::signal()) : kSuccess;
}

}  // namespace reorient
