// SPDX-License-Identifier: MIT
#include "program/run/live/live_options.h"

#include <charconv>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "program/options.h"
#include "program/run/run_recording.h"
#include "workbench/views/live/live_view.h"
#include "workbench/views/live/server/access.h"

namespace reorient {
namespace {

constexpr double kMostMegabytes = 16384.0;

std::string check_port(const std::string& text) {
  if (text.empty()) return {};
  int port = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error == std::errc() && end == text.data() + text.size() && port >= 0 && port <= 65535) return {};
  return "expected a port from 0 to 65535, or nothing, found '" + text +
         "'; write the name of a scenario or a file before --live";
}

std::string check_address(const std::string& text) {
  // Debian builds civetweb without IPv6.
  if (live::is_numeric_address(text) && text.find(':') == std::string::npos) return {};
  return "expected an IPv4 address such as 192.168.1.20, or 0.0.0.0 for all addresses of this computer, found '" +
         text + "'";
}

std::string check_origin(const std::string& text) {
  const std::size_t scheme = text.find("://");
  const bool is_sound = (text.starts_with("http://") || text.starts_with("https://")) && text.size() > scheme + 3 &&
                        text.find_first_of("/ ", scheme + 3) == std::string::npos;
  return is_sound ? std::string()
                  : "expected an origin such as https://app.foxglove.dev, without a path, found '" + text + "'";
}

}  // namespace

void add_live_options(CLI::App& parser, LiveOptions& options, const char* group) {
  CLI::Option* const live =
      parser
          .add_option("--live", options.port,
                      fmt::format("show it to viewers in real time (default port: {}; 0: a free one)", kLivePort))
          ->type_name("[PORT]")
          ->group(group)
          ->expected(0, 1)
          ->check(check_port);
  parser.add_option("--live-address", options.address, "address to listen at; others let the network connect")
      ->type_name("ADDRESS")
      ->group(group)
      ->check(check_address)
      ->needs(live)
      ->capture_default_str();
  parser
      .add_option("--live-allow-origin", options.origins,
                  "other web page that may change things, with the token; repeatable")
      ->type_name("URL")
      ->group(group)
      ->check(check_origin)
      ->needs(live)
      ->allow_extra_args(false);
  parser.add_option("--live-memory", options.memory, "memory for what-if; 0: none (default: 256, nao: 0)")
      ->type_name("MB")
      ->group(group)
      ->check(CLI::Range(0.0, kMostMegabytes))
      ->needs(live);
}

void find_live(const CLI::App& parser, LiveOptions& options) {
  options.is_on = parser.get_option("--live")->count() > 0;
}

LiveViewOptions live_view_options(const LiveOptions& options, LiveLoad load) {
  LiveViewOptions view;
  view.address = options.address;
  view.port = options.port.empty() ? kLivePort : std::stoi(options.port);
  view.allowed_origins = options.origins;
  view.version = REORIENT_VERSION;
  const bool is_light = load == LiveLoad::light;
  view.jpeg_quality = is_light ? 0 : view.jpeg_quality;
  if (!options.images.empty()) view.jpeg_quality = viewer_image_quality(options.images, "--view-images");
  view.every = is_light ? 2 : 1;
  return view;
}

std::size_t live_memory(const LiveOptions& options, LiveLoad load) {
  constexpr double kUsual = 256.0;
  const double megabytes = options.memory.value_or(load == LiveLoad::light ? 0.0 : kUsual);
  return static_cast<std::size_t>(megabytes * 1e6);
}

}  // namespace reorient
