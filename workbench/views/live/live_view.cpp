// SPDX-License-Identifier: MIT
#include "workbench/views/live/live_view.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "engine/parameters/utf8.h"
#include "engine/record/record_bytes.h"
#include "workbench/files/parameter_file.h"
#include "workbench/run/batch_thread.h"
#include "workbench/views/live/page.h"
#include "workbench/views/live/services.h"

namespace reorient {
namespace {

using live::FrameAnswer;
using live::FrameCopy;

constexpr std::size_t kMostTasks = 16;    // of a frame
constexpr std::size_t kMostAnswers = 64;  // that wait for the thread of the live view

/// Whether viewers receive the frame with this number.
bool is_shown(std::uint64_t frame, int every) { return frame % static_cast<std::uint64_t>(std::max(every, 1)) == 0; }

constexpr std::size_t index_of(ViewerTopic topic) { return static_cast<std::size_t>(topic); }

live::ServerInfo server_info_of(const LiveViewOptions& options) {
  live::ServerInfo info{
      options.name, {"parameters", "parametersSubscribe", "services", "time"}, live::make_token(), options.version};
  if (options.data_start) info.capabilities.emplace_back("playbackControl");
  if (options.data_start) info.data_start = live::to_nanoseconds(*options.data_start);
  if (options.data_end) info.data_end = live::to_nanoseconds(*options.data_end);
  return info;
}

/// Changes that viewers have not asked for: at the prompt, in a script, by another viewer.
bool may_have_changed_parameters(const FrameRecord& frame, const SceneTruth& scene) {
  return !frame.parameter_changes.empty() || !frame.reloads.empty() || !scene.scenario.reloads.empty();
}

}  // namespace

LiveView::LiveView(LiveViewOptions options, live::LiveSubject subject)
    : options_(std::move(options)),
      token_(live::make_token()),
      tasks_(std::move(subject)),
      scripts_(tasks_.subject().scripts),
      what_ifs_(viewers_, tasks_.subject().what_if.get()),
      session_parts_{viewers_, requests_, scripts_, what_ifs_, server_info_of(options_)},
      messages_(std::clamp(options_.jpeg_quality, 1, 100)) {
  if (options_.data_start) {
    session_parts_.control_playback = [this](live::ViewerId viewer, const live::ControlPlayback& control) {
      if (!controls_.add(control))
        viewers_.send(viewer, live::status(live::StatusLevel::warning, "too many requests to the replay at once"));
    };
  }
  thread_ = std::thread([this] { make_messages(); });
  try {
    server_.emplace(live::WebServerOptions{.address = options_.address,
                                           .port = options_.port,
                                           .allowed_origins = options_.allowed_origins,
                                           .token = token_,
                                           .mailbox = {.data_bytes = options_.viewer_bytes}},
                    live::find_page, [this](const auto& mailbox, const live::Access& access) {
                      return std::make_unique<live::Session>(session_parts_, mailbox, access);
                    });
  } catch (...) {
    stop();
    throw;
  }
}

LiveView::~LiveView() { stop(); }

void LiveView::stop(const std::string& reason) {
  if (server_) server_->stop(reason);
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

std::string LiveView::link() const {
  const bool is_everywhere = options_.address == "0.0.0.0" || options_.address == "::";
  std::string host = is_everywhere ? "127.0.0.1" : options_.address;
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  return "http://" + host + ":" + std::to_string(server_->port()) + "/?token=" + token_;
}

bool LiveView::has_room_for_answers() const {
  const std::lock_guard lock(mutex_);
  return answers_waiting_.size() < kMostAnswers;
}

void LiveView::hand_over(std::vector<FrameAnswer>& answers) {
  if (answers.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    for (FrameAnswer& answer : answers) answers_waiting_.push_back(std::move(answer));
  }
  answers.clear();
  wake_.notify_one();
}

/// Between two frames of a run or a replay that is paused.
void LiveView::show_last_frame() {
  viewers_.set_still(live::to_nanoseconds(last_time_));
  if (!is_copied_ || !viewers_.take_late_subscriber()) return;
  {
    const std::lock_guard lock(mutex_);
    shows_again_ = true;
  }
  wake_.notify_one();
}

void LiveView::add_to(FrameInputs& inputs) {
  viewers_.set_still(live::Viewers::kMoving);
  if (!has_room_for_answers()) return;
  while (tasks_.pending() < kMostTasks) {
    std::optional<live::FrameRequest> request = requests_.take();
    if (!request) break;
    tasks_.begin(std::move(*request), inputs);
  }
}

void LiveView::add_while_paused(FrameInputs& inputs, const FrameRecord& last, const SceneTruth& scene) {
  show_last_frame();
  for (std::size_t i = 0; i < kMostTasks && has_room_for_answers(); ++i) {
    std::optional<live::FrameRequest> request = requests_.take();
    if (!request) break;
    tasks_.begin(std::move(*request), inputs);
  }
  tasks_.answer_while_paused(last, scene, answers_);
  hand_over(answers_);
}

/// The messages to make of the coming frame.
ViewerTopics LiveView::due_topics(const FrameInputs& inputs) {
  ViewerTopics topics = viewers_.subscribed();
  has_changes_ = has_changes_ || !inputs.parameter_changes.empty() || !inputs.script_edits.empty();
  begins_ = viewers_.take_new_subscriber() || begins_;
  const std::uint64_t frame = frames_++;
  if (!is_shown(frame, options_.every)) return topics & moment_topics();
  const auto keep_if = [&](bool is_due, std::initializer_list<ViewerTopic> some) {
    for (const ViewerTopic topic : some) {
      if (!is_due) topics.reset(index_of(topic));
    }
  };
  const std::uint64_t shown = frame / static_cast<std::uint64_t>(std::max(options_.every, 1));
  // Also from time to time, because a camera may send its first image late.
  begins_ = begins_ || shown % kParametersEvery == 0;
  keep_if(shown % kParticlesEvery == 0, {ViewerTopic::pose_particles});
  keep_if(begins_ || shown % kRoomEvery == 0, {ViewerTopic::room, ViewerTopic::view});
  keep_if(begins_ || shown % kWallEvery == 0, {ViewerTopic::wall});
  keep_if(begins_ || shown % kParametersEvery == 0, {ViewerTopic::parameters});
  keep_if(begins_ || has_changes_ || shown % kParametersEvery == 0, {ViewerTopic::decision});
  has_changes_ = false;
  keep_if(begins_, {ViewerTopic::field, ViewerTopic::upper_calibration, ViewerTopic::lower_calibration});
  const auto has_image = [&](const std::optional<CameraFrame>& camera) {
    return options_.jpeg_quality > 0 && camera && !camera->image.empty();
  };
  keep_if(has_image(inputs.observation.upper), {ViewerTopic::upper_image, ViewerTopic::upper_annotations});
  keep_if(has_image(inputs.observation.lower), {ViewerTopic::lower_image, ViewerTopic::lower_annotations});
  return topics;
}

void LiveView::before(const FrameInputs& inputs, const FrameLoop& engine) {
  if (std::exchange(engine_, &engine) != &engine || engine.record().world.frame == 0)
    viewers_.set_application(engine.application());
  is_kept_ = tasks_.subject().what_if && viewers_.any();
  if (is_kept_) tasks_.subject().what_if->memory().before(inputs, engine);
  wanted_ = tasks_.wanted();
  const ViewerTopics topics = due_topics(inputs);
  const RunControls* const controls = tasks_.subject().controls;
  // A viewer may connect after the frame, and before the next one.
  const bool may_stay = controls == nullptr ? options_.data_start.has_value() : controls->pace().is_paused();
  is_copied_ = topics.any() || may_stay;
  if (!is_copied_) return;
  if (!copy_) {
    const std::lock_guard lock(mutex_);
    copy_ = frames_waiting_.get_free();
  }
  copy_->topics = topics;
  copy_->begins = begins_ && is_shown(frames_ - 1, options_.every);
  const auto has = [&](ViewerTopic topic) { return topics.test(index_of(topic)); };
  if (has(ViewerTopic::costs)) wanted_ = wanted_ | Topics{Topic::costs};
  if (has(ViewerTopic::conditions)) wanted_ = wanted_ | Topics{Topic::conditions};
  if (has(ViewerTopic::pose_particles)) wanted_ = wanted_ | Topics{Topic::pose_particles};
  if (has(ViewerTopic::wall) || has(ViewerTopic::room) || has(ViewerTopic::view))
    wanted_ = wanted_ | Topics{Topic::room};
  if (has(ViewerTopic::percepts)) wanted_ = wanted_ | Topics{Topic::feature_fits};
  if (has(ViewerTopic::parameters) || has(ViewerTopic::decision)) wanted_ = wanted_ | Topics{Topic::parameters};
  if (may_stay) wanted_ = wanted_ | kViewedTopics;
  const auto copy_image = [&](std::size_t camera, const std::optional<CameraFrame>& seen, bool is_due) {
    copy_->has_image[camera] = is_due || (may_stay && options_.jpeg_quality > 0 && seen && !seen->image.empty());
    if (copy_->has_image[camera]) copy_pixels(seen->image, copy_->images[camera]);
  };
  copy_image(0, inputs.observation.upper, has(ViewerTopic::upper_image) || has(ViewerTopic::upper_annotations));
  copy_image(1, inputs.observation.lower, has(ViewerTopic::lower_image) || has(ViewerTopic::lower_annotations));
}

void LiveView::observe(const FrameRecord& frame, const SceneTruth& scene) {
  if (is_kept_) tasks_.subject().what_if->memory().observe(frame, scene);
  tasks_.answer(frame, scene, answers_);
  last_time_ = frame.world.time;
  if (viewers_.any_watches() && may_have_changed_parameters(frame, scene)) {
    FrameAnswer changed;
    changed.parameters = std::make_shared<const std::vector<Parameter>>(tasks_.subject().parameters());
    answers_.push_back(std::move(changed));
  }
  if (copy_) {
    copy_->time = frame.world.time;
    copy_->record.clear();
    write_record(frame, copy_->record, Topics::always() | (wanted_ & kViewedTopics));
    copy_->scene = scene;
    begins_ = begins_ && !copy_->begins;
  }
  hand_over(answers_);
  if (!copy_) return;
  {
    const std::lock_guard lock(mutex_);
    frames_waiting_.add(std::move(copy_));
  }
  wake_.notify_one();
}

void LiveView::poll_without_frames(const std::string& reason) {
  show_last_frame();
  for (std::size_t i = 0; i < kMostTasks; ++i) {
    {
      const std::lock_guard lock(mutex_);
      if (answers_waiting_.size() >= kMostAnswers) return;
    }
    const std::optional<live::FrameRequest> request = requests_.take();
    if (!request) return;
    FrameAnswer answer = tasks_.refuse(*request, reason);
    const std::lock_guard lock(mutex_);
    answers_waiting_.push_back(std::move(answer));
    wake_.notify_one();
  }
}

/// Runs in the thread.
void LiveView::make_messages() {
  become_batch_thread(kLiveNiceness);
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock,
               [this] { return ends_ || shows_again_ || !answers_waiting_.empty() || !frames_waiting_.is_empty(); });
    if (ends_) return;
    if (!answers_waiting_.empty()) {
      FrameAnswer answer = std::move(answers_waiting_.front());
      answers_waiting_.pop_front();
      lock.unlock();
      send(std::move(answer));
      lock.lock();
      continue;
    }
    std::unique_ptr<FrameCopy> copy = frames_waiting_.take();
    if (!copy) shows_again_ = false;
    lock.unlock();
    if (copy) {
      made_ = copy->topics;
      publish(*copy, copy->topics, copy->begins);
      std::swap(last_, copy);
    } else {
      publish_again();
    }
    lock.lock();
    if (copy) frames_waiting_.give_back(std::move(copy));
  }
}

void LiveView::publish(const FrameCopy& copy, ViewerTopics topics, bool begins) {
  if (topics.none()) return;
  const FrameRecord frame = read_record(copy.record);
  const auto wall = index_of(ViewerTopic::wall);
  if (topics.test(wall) && frame.filled.has(Topic::room)) topics.set(wall, wall_changes_.take(frame.room, begins));
  ViewedFrame viewed{frame, frame, copy.scene, {}, begins, topics};
  for (std::size_t camera = 0; camera < copy.images.size(); ++camera)
    if (copy.has_image[camera]) viewed.images[camera] = copy.images[camera].view();
  const std::uint64_t time = live::to_nanoseconds(copy.time);
  messages_.add(viewed, [&](ViewerTopic topic, std::string_view message) {
    viewers_.publish(topic, time, std::string(message));
  });
  viewers_.end_frame(time);
}

/// The messages of the last frame that late subscribers lack.
void LiveView::publish_again() {
  if (!last_) return;
  const ViewerTopics missing = viewers_.subscribed() & ~moment_topics() & ~made_;
  made_ |= missing;
  publish(*last_, missing, true);
}

void LiveView::send(FrameAnswer answer) {
  if (answer.is_delayed) {
    const std::string text = "the run is paused; changes take effect with the next frame";
    return viewers_.send(answer.to.viewer, live::status(live::StatusLevel::info, text));
  }
  if (answer.parameters) viewers_.send_changes(*answer.parameters);
  if (answer.to.viewer == 0) return;
  if (answer.to.service != 0) return send_service_answer(std::move(answer));
  std::vector<Parameter> chosen;
  for (const Parameter& parameter : *answer.parameters) {
    const std::vector<std::string>& names = answer.to.names;
    if (names.empty() || std::find(names.begin(), names.end(), parameter.name) != names.end())
      chosen.push_back(parameter);
  }
  viewers_.send(answer.to.viewer, live::parameter_values(chosen, answer.to.request));
  const auto warn = [&](const std::string& text) {
    viewers_.send(answer.to.viewer, live::status(live::StatusLevel::warning, as_line(text)));
  };
  if (!answer.failure.empty()) warn(answer.failure);
  for (const ParameterOutcome& outcome : answer.outcomes) {
    if (!outcome.refusal.empty()) warn(outcome.refusal);
  }
}

void LiveView::send_service_answer(FrameAnswer answer) {
  const live::AnswerAddress& to = answer.to;
  std::string failure = answer.failure;
  std::string json;
  if (failure.empty()) {
    try {
      if (!to.file.empty()) answer.backup = save_parameters(*answer.parameters, answer.kept, to.file).string();
      json = live::service_answer(live::kServices[to.row], answer);
    } catch (const std::exception& error) {
      failure = as_line(error.what());
    }
  }
  if (failure.empty()) {
    viewers_.send(to.viewer, live::service_response(to.service, to.call, json));
  } else {
    viewers_.send(to.viewer, live::service_failure(to.service, to.call, failure));
  }
}

void LiveView::send_playback(live::PlaybackStatus status, double time, float speed, bool did_seek,
                             const std::string& request) {
  viewers_.send_all(live::playback_state(status, live::to_nanoseconds(time), speed, did_seek, request));
}

LiveView::Counts LiveView::counts() const {
  const live::Viewers::Counts counts = viewers_.counts();
  const std::lock_guard lock(mutex_);
  return {counts.viewers, frames_waiting_.dropped(), counts.dropped, counts.left_out};
}

}  // namespace reorient
