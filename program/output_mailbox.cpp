// SPDX-License-Identifier: MIT
#include "program/output_mailbox.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "engine/parameters/counted.h"
#include "program/log.h"
#include "program/program_output.h"

namespace reorient {

enum class OutputStream { out, err };

/// What is to be written, in order, for both streams.
class OutputQueue {
 public:
  OutputQueue(std::streambuf& out, std::streambuf& err) : out_{&out}, err_{&err}, thread_([this] { write_all(); }) {}
  ~OutputQueue() { end(); }
  OutputQueue(const OutputQueue&) = delete;
  OutputQueue& operator=(const OutputQueue&) = delete;

  void add(OutputStream stream, std::string_view text, bool is_control) {
    {
      const std::lock_guard lock(mutex_);
      if (bytes_ + text.size() > OutputMailbox::kMost) {
        dropped_ += text.size();
        return;
      }
      append(stream, text, is_control);
    }
    changed_.notify_one();
  }

  void end() {
    {
      const std::lock_guard lock(mutex_);
      has_ended_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  /// After end(): whether everything could be written.
  bool is_good(OutputStream stream) const { return (stream == OutputStream::out ? out_ : err_).is_good; }

 private:
  struct Entry {
    OutputStream stream = OutputStream::out;
    bool is_control = false;
    std::string text;
  };
  struct Target {
    std::streambuf* buffer = nullptr;
    bool is_good = true;
  };

  void append(OutputStream stream, std::string_view text, bool is_control) {
    bytes_ += text.size();
    if (!entries_.empty() && entries_.back().stream == stream && entries_.back().is_control == is_control)
      entries_.back().text += text;
    else
      entries_.push_back({stream, is_control, std::string(text)});
  }

  void write_all() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return has_ended_ || !entries_.empty(); });
      if (entries_.empty()) return;
      const Entry entry = std::move(entries_.front());
      entries_.pop_front();
      lock.unlock();
      write(entry);
      lock.lock();
      bytes_ -= entry.text.size();
      if (!entries_.empty() || dropped_ == 0) continue;
      append(OutputStream::err,
             "reorient: dropped " + counted(std::exchange(dropped_, 0), "byte") +
                 " of output that the terminal or the pipe did not accept in time\n",
             false);
    }
  }

  void write(const Entry& entry) {
    Target& target = entry.stream == OutputStream::out ? out_ : err_;
    auto* const output = dynamic_cast<ProgramOutput*>(target.buffer);
    if (entry.is_control && output != nullptr) return output->put_control(entry.text);
    const auto size = static_cast<std::streamsize>(entry.text.size());
    target.is_good &= target.buffer->sputn(entry.text.data(), size) == size && target.buffer->pubsync() == 0;
  }

  Target out_, err_;  // of the thread
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Entry> entries_;
  std::size_t bytes_ = 0;    // of the entries, and of the one that is being written
  std::size_t dropped_ = 0;  // bytes since the last line about them
  bool has_ended_ = false;
  std::thread thread_;
};

/// Replaces the buffer of a stream.
class QueuedOutput : public ProgramOutput {
 public:
  QueuedOutput(OutputQueue& queue, OutputStream name, std::ostream& stream)
      : queue_(queue), name_(name), stream_(stream), before_(stream.rdbuf(this)) {
    const auto* const output = dynamic_cast<const ProgramOutput*>(before_);
    is_colored = output != nullptr && output->is_colored;
  }

  /// After the end of the queue.
  void give_back() {
    stream_.rdbuf(before_);
    if (!queue_.is_good(name_)) stream_.setstate(std::ios::badbit);
  }

  void put_control(std::string_view sequence) override { queue_.add(name_, sequence, true); }

 protected:
  int_type overflow(int_type letter) override {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    const char one = traits_type::to_char_type(letter);
    queue_.add(name_, {&one, 1}, false);
    return letter;
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    queue_.add(name_, {text, static_cast<std::size_t>(size)}, false);
    return size;
  }

 private:
  OutputQueue& queue_;
  const OutputStream name_;
  std::ostream& stream_;
  std::streambuf* const before_;
};

struct OutputMailbox::Parts {
  Parts(std::ostream& to_out, std::ostream& to_err)
      : queue(*to_out.rdbuf(), *to_err.rdbuf()),
        out(queue, OutputStream::out, to_out),
        err(queue, OutputStream::err, to_err) {}

  OutputQueue queue;
  QueuedOutput out, err;
  // A line of the log is safe already, and contains colors.
  std::optional<LogRedirection> log{std::in_place,
                                    [this](std::string_view line) { queue.add(OutputStream::err, line, true); }};
};

OutputMailbox::OutputMailbox(std::ostream& out, std::ostream& err) : parts_(std::make_unique<Parts>(out, err)) {}

OutputMailbox::~OutputMailbox() {
  parts_->log.reset();
  parts_->queue.end();
  parts_->out.give_back();
  parts_->err.give_back();
}

}  // namespace reorient
