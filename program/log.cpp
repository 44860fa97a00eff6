// SPDX-License-Identifier: MIT
#include "program/log.h"

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <utility>

#include <spdlog/fmt/fmt.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"

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

/// NO_COLOR: https://no-color.org
spdlog::color_mode color_mode(const std::string& asked) {
  if (asked == "always") return spdlog::color_mode::always;
  const char* const no_color = std::getenv("NO_COLOR");
  const bool is_unwanted = asked == "never" || (no_color != nullptr && *no_color != '\0');
  return is_unwanted ? spdlog::color_mode::never : spdlog::color_mode::automatic;
}

}  // namespace

void set_up_log(const std::string& level, const std::string& color) {
  auto logger = std::make_shared<spdlog::logger>(
      "reorient", std::make_shared<spdlog::sinks::stderr_color_sink_mt>(color_mode(color)));
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<RobotTime>('*').add_flag<OneLine>('?');
  formatter->set_pattern(isatty(STDERR_FILENO) == 1 ? "\r\033[K%*[%^%l%$] %?" : "%*[%^%l%$] %?");
  logger->set_formatter(std::move(formatter));
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
}

void set_log_time(std::optional<double> time) { robot_time = time.value_or(kUnknown); }

}  // namespace reorient
