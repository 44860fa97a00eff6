// SPDX-License-Identifier: MIT
// The options of the live view, of `run` and `replay`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace reorient {

struct LiveViewOptions;

struct LiveOptions {
  bool is_on = false;
  std::string port;                   ///< empty: kLivePort
  std::string address = "127.0.0.1";  ///< at which the server listens
  std::vector<std::string> origins;   ///< pages of other servers that may change the run
  std::optional<double> memory;       ///< MB, of frames for what-if; nothing: the robot's default
  std::string images;                 ///< jpeg:Q or none; empty: the robot's default
};

inline constexpr int kLivePort = 8765;

/// `group`: of the help page.
void add_live_options(CLI::App& parser, LiveOptions& options, const char* group);
/// Call after the command line was read.
void find_live(const CLI::App& parser, LiveOptions& options);

/// The default load that a live view puts on the computer.
enum class LiveLoad {
  usual,
  light  ///< of a NAO: no images, half of the frames, no what-if
};

/// Throws std::runtime_error with one line.
LiveViewOptions live_view_options(const LiveOptions& options, LiveLoad load);

/// Most bytes of the frames that a run keeps for what-if.
std::size_t live_memory(const LiveOptions& options, LiveLoad load);

}  // namespace reorient
