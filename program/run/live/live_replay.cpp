// SPDX-License-Identifier: MIT
#include "program/run/live/live_replay.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <ostream>
#include <string>
#include <thread>
#include <utility>

#include "program/interruption.h"
#include "program/recording/damages.h"
#include "program/run/console/command_table.h"
#include "program/run/live/live_what_if.h"
#include "program/run/live/run_live_view.h"
#include "program/run/live_run.h"
#include "workbench/files/script_files.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/replay.h"
#include "workbench/run/run_pace.h"
#include "workbench/views/live/live_view.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;
using live::PlaybackStatus;

/// Shows frames to viewers, except those on the way to the time that a viewer seeks.
class ShownFrames : public InputSource, public Observer {
 public:
  ShownFrames(LiveView& view, CommandTable& commands) : view_(view), commands_(commands) {}

  bool is_shown = true;
  const Playback* playback = nullptr;  ///< its frames have the recorded scenario

  void add_to(FrameInputs& inputs) override {
    if (is_shown) view_.add_to(inputs);
  }
  void before(const FrameInputs& inputs, const FrameLoop& engine) override {
    if (is_shown) view_.before(inputs, engine);
  }
  Topics wanted() const override { return is_shown ? view_.wanted() : Topics(); }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override {
    if (!is_shown) return;
    SceneTruth recorded = scene;
    recorded.scenario = playback->frame().entry.scene.scenario;
    view_.observe(frame, recorded);
    commands_.observe(frame, recorded);
  }

 private:
  LiveView& view_;
  CommandTable& commands_;
};

LiveViewOptions view_options(const LiveReplayOptions& options, const Recording& recording) {
  LiveViewOptions view = live_view_options(options.live, LiveLoad::usual);
  view.data_start = std::max(recording.begin_time(), options.times.from);
  view.data_end = std::max(*view.data_start, std::min(recording.end_time(), options.times.to));
  return view;
}

class LiveReplay {
 public:
  LiveReplay(const LiveReplayOptions& options, std::ostream& err)
      : options_(options),
        recording_(options.file, is_interrupted),
        commands_({.parameters = [this] { return parameters(); },
                   .scripts = [this] { return &(on_disk_ = read_scripts(options_.scripts)); },
                   .engine = [this] { return engine_; }}) {
    require_recorded(recording_, options_.times, err);
    const LiveViewOptions view = view_options(options_, recording_);
    begin_ = *view.data_start;
    end_ = *view.data_end;
    view_.emplace(view, live::LiveSubject{nullptr,
                                          [this] { return parameters(); },
                                          {},
                                          options_.scripts,
                                          [this](const Words& words) {
                                            FrameInputs unchanged;
                                            return commands_.obey(words, unchanged);
                                          },
                                          nullptr,
                                          [this] { return engine_; },
                                          make_what_if(options_.live, LiveLoad::usual)});
    shown_.emplace(*view_, commands_);
  }

  LiveView& view() { return *view_; }
  const Recording& recording() const { return recording_; }

  /// The first frame. Throws std::runtime_error with one line.
  void begin() {
    seek(begin_);
    if (engine_ == nullptr)
      throw std::runtime_error(options_.file.string() +
                               ": expected frames that can be replayed from there, found none; see 'reorient recording "
                               "info'");
  }
  void run() {
    while (!is_interrupted()) {
      take_controls();
      report_sometimes();
      if (status_ == PlaybackStatus::playing && Clock::now() >= pace_.due(next_time())) {
        step();
      } else {
        rest();
      }
    }
  }

 private:
  static bool is_interrupted() { return Interruption::signal() != 0; }

  std::vector<Parameter> parameters() const {
    return engine_ != nullptr ? engine_->parameters() : std::vector<Parameter>();
  }
  /// Of the frame after this one; the recording knows it only when the frame is read.
  double next_time() const { return time_ + frame_seconds_; }

  /// Continues with the frame at this time: replays from the last recorded state before it.
  void seek(double time) {
    loop_.reset();
    engine_ = nullptr;
    replay_.emplace(recording_, time, options_.times.to);
    shown_->playback = &replay_->playback();
    if (!begin_stretch()) return end_playback();
    shown_->is_shown = false;
    while (next_time() < time && !is_interrupted()) {
      if (!step_frame()) return end_playback();
    }
    shown_->is_shown = true;
    view_->begin_again();
    pace_.begin(next_time());
    if (!step_frame()) end_playback();
  }

  /// The next part of the recording that can be replayed.
  bool begin_stretch() {
    loop_.reset();
    engine_ = replay_->next_stretch();
    if (engine_ == nullptr) return false;
    changed_.emplace(options_.changes ? options_.changes(*engine_) : WhatIfChanges());
    loop_.emplace(replay_->parts({&*changed_, &*shown_}, {&*shown_}));
    time_ = replay_->playback().frame().entry.time - frame_seconds_;
    return true;
  }

  /// False: the recording is over.
  bool step_frame() {
    while (loop_->step()) {  // this part is over
      if (!begin_stretch()) return false;
      pace_.begin(next_time());
    }
    const double before = std::exchange(time_, engine_->record().world.time);
    if (time_ > before && time_ - before < 0.5) frame_seconds_ = time_ - before;
    return time_ <= options_.times.to;
  }

  void step() {
    if (!step_frame()) end_playback();
  }

  void end_playback() {
    status_ = PlaybackStatus::ended;
    report(false, "");
  }

  void rest() {
    if (status_ != PlaybackStatus::playing) view_->poll_without_frames("the replay is paused; play it first");
    constexpr std::chrono::milliseconds kShortRest{10};
    const Clock::time_point latest = Clock::now() + kShortRest;
    std::this_thread::sleep_until(status_ == PlaybackStatus::playing ? std::min(latest, pace_.due(next_time()))
                                                                     : latest);
  }

  void take_controls() {
    while (const std::optional<live::ControlPlayback> control = view_->take_control()) {
      if (control->speed > 0.0f) pace_.set_speed(static_cast<double>(control->speed));
      const bool was_over = status_ == PlaybackStatus::ended;
      std::optional<double> target;
      if (control->seek) target = std::clamp(1e-9 * static_cast<double>(*control->seek), begin_, end_);
      if (!target && was_over && !control->pauses) target = begin_;
      if (target) {
        status_ = PlaybackStatus::buffering;
        report(false, "");
        seek(*target);
      }
      if (status_ != PlaybackStatus::ended || !was_over)
        status_ = status_ == PlaybackStatus::ended && target ? status_
                  : control->pauses                          ? PlaybackStatus::paused
                                                             : PlaybackStatus::playing;
      pace_.begin(next_time());
      report(target.has_value(), control->request);
    }
  }

  void report(bool did_seek, const std::string& request) {
    view_->send_playback(status_, std::clamp(time_, begin_, end_), static_cast<float>(pace_.speed()), did_seek,
                         request);
    reported_ = Clock::now();
  }
  /// For viewers that have just connected.
  void report_sometimes() {
    constexpr std::chrono::seconds kEvery{1};
    if (Clock::now() - reported_ >= kEvery) report(false, "");
  }

  const LiveReplayOptions& options_;
  ScriptTexts on_disk_;
  Recording recording_;
  FrameLoop* engine_ = nullptr;  // before the commands, which ask for it
  CommandTable commands_;
  std::optional<LiveView> view_;
  std::optional<ShownFrames> shown_;
  std::optional<WhatIfSource> changed_;
  std::optional<Replay> replay_;
  std::optional<RunLoop> loop_;
  RunPace pace_;
  PlaybackStatus status_ = PlaybackStatus::playing;
  double time_ = 0.0, begin_ = 0.0, end_ = 0.0;  // s of the robot
  double frame_seconds_ = 1.0 / 30.0;            // between the last two frames
  Clock::time_point reported_{};
};

}  // namespace

int replay_live(const LiveReplayOptions& options, std::ostream& out, std::ostream& err) {
  LiveReplay replay(options, err);
  replay.begin();
  print_link(replay.view(), err);
  err << "reorient: the replay stays at its end for viewers; Ctrl-C ends it\n" << std::flush;
  replay.run();
  end_live_view(&replay.view(), user_who_ended_run(false), out);
  tell_damages(replay.recording(), err);
  return exit_code_of_runs({});
}

}  // namespace reorient
