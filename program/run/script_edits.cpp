// SPDX-License-Identifier: MIT
#include "program/run/script_edits.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "program/monotonic_clock.h"

namespace reorient {
namespace {

constexpr std::chrono::milliseconds kLookEvery{10};  // between two looks
constexpr std::chrono::milliseconds kLastLook{500};  // of the destructor: a look at a local disk takes less

}  // namespace

/// Owned by both threads, because a look that hangs ends after the run, or never.
struct ScriptEdits::Shared {
  std::mutex mutex;
  std::condition_variable wake, over;
  std::vector<ScriptEdit> found;
  bool ends = false;
  bool is_over = false;
};

ScriptEdits::ScriptEdits(const std::filesystem::path& root) : ScriptEdits(std::make_shared<ScriptFiles>(root)) {}

ScriptEdits::ScriptEdits(const std::shared_ptr<ScriptFiles>& files)
    : ScriptEdits(files->texts(), [files] { return files->poll(monotonic_clock()); }) {}

ScriptEdits::ScriptEdits(ScriptTexts texts, Look look)
    : texts_(std::move(texts)),
      shared_(std::make_shared<Shared>()),
      thread_([shared = shared_, look = std::move(look)] { look_for_edits(*shared, look); }) {}

ScriptEdits::~ScriptEdits() {
  bool is_over = false;
  {
    std::unique_lock lock(shared_->mutex);
    shared_->ends = true;
    shared_->wake.notify_one();
    is_over = shared_->over.wait_for(lock, kLastLook, [this] { return shared_->is_over; });
  }
  if (is_over) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

void ScriptEdits::look_for_edits(Shared& shared, const Look& look) {
  std::unique_lock lock(shared.mutex);
  while (!shared.wake.wait_for(lock, kLookEvery, [&] { return shared.ends; })) {
    lock.unlock();
    std::vector<ScriptEdit> edits = look();
    lock.lock();
    for (ScriptEdit& edit : edits) shared.found.push_back(std::move(edit));
  }
  shared.is_over = true;
  shared.over.notify_one();
}

std::vector<ScriptEdit> ScriptEdits::found() {
  std::vector<ScriptEdit> edits;
  {
    const std::lock_guard lock(shared_->mutex);
    edits.swap(shared_->found);
  }
  for (const ScriptEdit& edit : edits) texts_.apply(edit);
  return edits;
}

const ScriptTexts& ScriptEdits::texts() {
  found();
  return texts_;
}

void ScriptEdits::add_missed(const ScriptTexts& known) { missed_ = edits_between(known, texts_); }

void ScriptEdits::add_to(FrameInputs& inputs) {
  for (ScriptEdit& edit : std::exchange(missed_, {})) inputs.script_edits.push_back(std::move(edit));
  for (ScriptEdit& edit : found()) inputs.script_edits.push_back(std::move(edit));
}

}  // namespace reorient
