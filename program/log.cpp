// SPDX-License-Identifier: MIT
#include "program/log.h"

#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>

#include <spdlog/fmt/fmt.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"
#include "program/program_output.h"

namespace reorient {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
std::atomic<double> robot_time{kUnknown};  // s; a write in the background may log, too

void append(const std::string& text, spdlog::memory_buf_t& out) { out.append(text.data(), text.data() + text.size()); }

/// "[12.34 s] ", as in the printed timeline.
class RobotTime : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& /*message*/, const std::tm& /*time*/,
              spdlog::memory_buf_t& out) override {
    if (const double time = robot_time; !std::isnan(time)) append(fmt::format("[{:.2f} s] ", time), out);
  }
  std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<RobotTime>(); }
};

class OneLine : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm& /*time*/, spdlog::memory_buf_t& out) override {
    append(as_line({message.payload.data(), message.payload.size()}), out);
  }
  std::unique_ptr<custom_flag_formatter> clone() const override { return std::make_unique<OneLine>(); }
};

std::unique_ptr<spdlog::formatter> line_formatter() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<RobotTime>('*').add_flag<OneLine>('?');
  formatter->set_pattern(isatty(STDERR_FILENO) == 1 ? "\r\033[K%*[%^%l%$] %?" : "%*[%^%l%$] %?");
  return formatter;
}

Color color_of(spdlog::level::level_enum level) {
  switch (level) {
    case spdlog::level::debug:
      return Color::cyan;
    case spdlog::level::info:
      return Color::green;
    case spdlog::level::warn:
      return Color::yellow;
    default:
      return Color::red;
  }
}

/// Passes on whole lines, with their colors.
class LineSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  LineSink(std::function<void(std::string_view)> write, bool is_colored)
      : write_(std::move(write)), is_colored_(is_colored) {
    set_formatter(line_formatter());
  }
  bool is_colored() const { return is_colored_; }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t formatted;
    formatter_->format(message, formatted);
    std::string line(formatted.data(), formatted.size());
    if (is_colored_ && message.color_range_end > message.color_range_start) {
      line.insert(message.color_range_end, kColorEnd);
      line.insert(message.color_range_start, sequence_of(color_of(message.level)));
    }
    write_(line);
  }
  void flush_() override {}

 private:
  std::function<void(std::string_view)> write_;
  bool is_colored_;
};

}  // namespace

void set_up_log(const std::string& level, const std::string& color) {
  const auto write = [](std::string_view line) { std::fwrite(line.data(), 1, line.size(), stderr); };
  auto logger = std::make_shared<spdlog::logger>(
      "reorient", std::make_shared<LineSink>(write, are_colors_printed(color, STDERR_FILENO)));
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
}

LogRedirection::LogRedirection(std::function<void(std::string_view line)> write)
    : before_(spdlog::default_logger()->sinks().back()) {
  const auto* const before = dynamic_cast<const LineSink*>(before_.get());
  spdlog::default_logger()->sinks().back() =
      std::make_shared<LineSink>(std::move(write), before != nullptr && before->is_colored());
}

LogRedirection::~LogRedirection() { spdlog::default_logger()->sinks().back() = before_; }

void set_log_time(std::optional<double> time) { robot_time = time.value_or(kUnknown); }

}  // namespace reorient
