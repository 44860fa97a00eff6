// SPDX-License-Identifier: MIT
// A run for viewers in a browser, in Foxglove, Lichtblick or PlotJuggler. A frame never waits: it copies what viewers
// have subscribed to into a bounded mailbox, and one thread makes messages of the copies.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "workbench/run/observer.h"
#include "workbench/run/run_loop.h"
#include "workbench/views/live/frame_mailbox.h"
#include "workbench/views/live/frame_tasks.h"
#include "workbench/views/live/session.h"
#include "workbench/views/viewer/viewer_messages.h"
#include "workbench/views/viewer/wall_changes.h"

namespace reorient {

struct LiveViewOptions {
  std::string address = "127.0.0.1";           ///< at which the server listens, as a number
  int port = 8765;                             ///< 0: a free one
  std::vector<std::string> allowed_origins{};  ///< pages of other servers that may change things
  int jpeg_quality = 75;                       ///< of camera images, 1 to 100; 0: no images
  int every = 1;  ///< frames between two that viewers receive; events and log lines of all frames are sent
  std::size_t viewer_bytes = std::size_t{8} << 20;  ///< most that wait for a slow viewer
  std::string name = "reorient";
  std::string version{};  ///< of the program
  /// s of the robot, of a replay
  std::optional<double> data_start{}, data_end{};
};

class LiveView : public InputSource, public Observer {
 public:
  /// Listens at once. Throws std::runtime_error with one line.
  LiveView(LiveViewOptions options, live::LiveSubject subject);
  ~LiveView() override;

  /// "http://127.0.0.1:8765/?token=..."
  std::string link() const;

  bool has_viewers() const { return viewers_.any(); }

  void add_to(FrameInputs& inputs) override;
  void add_while_paused(FrameInputs& inputs, const FrameRecord& last, const SceneTruth& scene) override;
  void before(const FrameInputs& inputs, const FrameLoop& engine) override;
  Topics wanted() const override { return wanted_; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// Call instead of the above while there are no frames: refuses requests of viewers, because `reason`.
  void poll_without_frames(const std::string& reason);

  // Of a replay, which has LiveViewOptions::data_start:

  /// What a viewer did with its time bar; nothing: no more.
  std::optional<live::ControlPlayback> take_control() { return controls_.take(); }
  /// Tells all viewers where the replay is. `time`: s.
  void send_playback(live::PlaybackStatus status, double time, float speed, bool did_seek, const std::string& request);
  /// Lasting messages are sent again with the next frame, because the time has changed.
  void begin_again() { begins_ = true; }

  /// Ends all connections and threads, within a second. Viewers receive the reason, of at most 123 bytes.
  void stop(const std::string& reason = "the run has ended");

  struct Counts {
    std::uint64_t viewers = 0;           ///< that connected
    std::uint64_t dropped_frames = 0;    ///< because the processor was too slow
    std::uint64_t dropped_messages = 0;  ///< because a viewer did not read
    live::FrameCounts left_out;          ///< of viewers with slow connections
  };
  Counts counts() const;

 private:
  bool has_room_for_answers() const;
  void show_last_frame();
  void hand_over(std::vector<live::FrameAnswer>& answers);
  ViewerTopics due_topics(const FrameInputs& inputs);
  void make_messages();
  void publish(const live::FrameCopy& copy, ViewerTopics topics, bool begins);
  void publish_again();
  void send(live::FrameAnswer answer);
  void send_service_answer(live::FrameAnswer answer);

  const LiveViewOptions options_;
  const std::string token_;
  live::FrameTasks tasks_;

  // Of the thread of the frames.
  std::unique_ptr<live::FrameCopy> copy_;  // of the coming frame; nullptr: nothing is copied
  Topics wanted_;
  std::uint64_t frames_ = 0;
  double last_time_ = 0.0;             // s, of the last frame
  bool is_copied_ = false;             // the last frame, for viewers
  bool has_changes_ = false;           // of parameters or scripts since the last shown frame
  bool is_kept_ = false;               // the coming frame, for what-if
  bool begins_ = false;                // a viewer needs the lasting messages
  const FrameLoop* engine_ = nullptr;  // whose application the viewers know
  std::vector<live::FrameAnswer> answers_;

  live::Viewers viewers_;
  live::BoundedQueue<live::FrameRequest> requests_{256};
  live::BoundedQueue<live::ControlPlayback> controls_{64};
  const live::ScriptServices scripts_;
  live::WhatIfs what_ifs_;
  live::SessionParts session_parts_;

  mutable std::mutex mutex_;  // protects all members below
  std::condition_variable wake_;
  live::FrameMailbox frames_waiting_;
  std::deque<live::FrameAnswer> answers_waiting_;
  bool ends_ = false, shows_again_ = false;

  // Of the thread.
  ViewerMessages messages_;
  WallChanges wall_changes_;
  std::unique_ptr<live::FrameCopy> last_;  // the last frame
  ViewerTopics made_;                      // messages that were made of it
  std::thread thread_;
  std::optional<live::WebServer> server_;
};

}  // namespace reorient
