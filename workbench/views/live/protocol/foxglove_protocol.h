// SPDX-License-Identifier: MIT
// The messages of the Foxglove WebSocket protocol as values: text (JSON) and binary messages of a client are read,
// those of the server are written. Pure functions without sockets; their output for hostile input is bounded.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/parameters/parameter.h"
#include "robots/application.h"

namespace reorient::live {

/// The WebSocket subprotocols of the server, which have the same messages.
inline constexpr std::array<std::string_view, 2> kSubprotocols{"foxglove.websocket.v1", "foxglove.sdk.v1"};

/// The first known subprotocol of a header "Sec-WebSocket-Protocol"; empty: the client offers none of them.
std::string_view choose_subprotocol(std::string_view offered);

inline constexpr std::size_t kLargestClientMessage = std::size_t{1} << 20;  ///< bytes
inline constexpr int kDeepestClientJson = 16;                               ///< nested arrays and objects

/// A message of a client that is not one of the protocol: one line with what was expected and what was found.
struct BadClientMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Messages of a client.

struct Subscribe {
  struct One {
    std::uint32_t id = 0;       ///< chosen by the client
    std::uint32_t channel = 0;  ///< channel_of() of a topic
  };
  std::vector<One> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> ids;
};
struct GetParameters {
  std::vector<std::string> names;  ///< empty: all
  std::optional<std::string> id;   ///< of the request
};
/// A value that a client sets, as text for parse_parameter().
struct ParameterText {
  std::string name;
  std::optional<std::string> value;  ///< nothing: the message contains no value of a parameter's type
};
struct SetParameters {
  std::vector<ParameterText> parameters;
  std::optional<std::string> id;
};
/// Adds names to those whose changes are sent, or removes them. No name: all parameters.
struct WatchParameters {
  std::vector<std::string> names;
  bool begins = true;
};
struct CallService {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string encoding;
  std::string payload;
};
struct FetchAsset {
  std::uint32_t request = 0;
};
/// The time bar of a viewer controls a replay.
struct ControlPlayback {
  bool pauses = false;
  float speed = 1.0f;
  std::optional<std::uint64_t> seek;  ///< ns
  std::string request;
};
/// A message of the protocol that needs a capability that the server does not offer.
struct NotOffered {
  std::string_view operation;
};
using ClientMessage = std::variant<Subscribe, Unsubscribe, GetParameters, SetParameters, WatchParameters, CallService,
                                   FetchAsset, ControlPlayback, NotOffered>;

/// Both throw BadClientMessage.
ClientMessage read_client_text(std::string_view text);
ClientMessage read_client_binary(std::span<const std::byte> bytes);

/// The members "name" and "value" of each object of `json`'s member "parameters". Throws BadClientMessage.
std::vector<ParameterText> read_parameter_texts(std::string_view json);

// Text messages of the server.

struct ServerInfo {
  std::string name;
  std::vector<std::string> capabilities;
  std::string session;  ///< another one makes a client drop its state
  std::string version;  ///< of the program
  /// ns; of a replay
  std::optional<std::uint64_t> data_start{}, data_end{};
};
std::string server_info(const ServerInfo& info);

enum class StatusLevel { info, warning, error };
/// `id`: a later status with the same id replaces this one; may be empty.
std::string status(StatusLevel level, std::string_view message, std::string_view id = {});
std::string remove_status(std::string_view id);

/// All topics of viewer_topics.h, as channels with JSON messages. `application`: of the run.
std::string advertise_topics(const ApplicationInterface& application = {});
/// The channel of the topic with this index, and back. Channel 0 does not exist.
constexpr std::uint32_t channel_of(std::size_t topic) { return static_cast<std::uint32_t>(topic) + 1; }
std::optional<std::size_t> topic_of(std::uint32_t channel);

std::string parameter_values(std::span<const Parameter> parameters, const std::optional<std::string>& id);

struct ServiceInfo {
  std::uint32_t id = 0;
  std::string_view name;
  std::string_view request_schema;   ///< JSON Schema
  std::string_view response_schema;  ///< JSON Schema
};
std::string advertise_services(std::span<const ServiceInfo> services);
std::string service_failure(std::uint32_t service, std::uint32_t call, std::string_view message);

// Binary messages of the server.

/// The part of a message of data before its payload. `time`: ns.
inline constexpr std::size_t kDataHead = 13;
std::array<std::byte, kDataHead> message_data_head(std::uint32_t subscription, std::uint64_t time);
/// The time of the robot at the messages that follow. Without it, viewers use their own clock. `now`: ns.
std::vector<std::byte> server_time(std::uint64_t now);
std::vector<std::byte> service_response(std::uint32_t service, std::uint32_t call, std::string_view json);
std::vector<std::byte> asset_failure(std::uint32_t request, std::string_view message);

enum class PlaybackStatus : std::uint8_t { playing, paused, buffering, ended };
/// `now`: ns. `request`: of the ControlPlayback that it answers; empty: none.
std::vector<std::byte> playback_state(PlaybackStatus status, std::uint64_t now, float speed, bool did_seek,
                                      std::string_view request);

/// Seconds of the robot as ns. Invalid and negative times give 0.
std::uint64_t to_nanoseconds(double seconds);

}  // namespace reorient::live
