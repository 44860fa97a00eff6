// SPDX-License-Identifier: MIT
#include "workbench/views/live/protocol/foxglove_protocol.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <nlohmann/json.hpp>

#include "engine/parameters/utf8.h"
#include "workbench/views/live/protocol/little_endian.h"
#include "workbench/views/viewer/viewer_topics.h"

namespace reorient::live {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json time_json(std::uint64_t nanoseconds) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  return {{"sec", nanoseconds / kSecond}, {"nsec", nanoseconds % kSecond}};
}

Json channel_json(const ViewerTopicInfo& topic, const ApplicationInterface& application) {
  return {{"id", channel_of(static_cast<std::size_t>(topic.topic))},
          {"topic", topic.name},
          {"encoding", "json"},
          {"schemaName", topic.schema},
          {"schema", schema_text(topic.schema, application)},
          {"schemaEncoding", "jsonschema"}};
}

Json parameter_json(const Parameter& parameter) {
  Json json{{"name", parameter.name}};
  std::visit([&](const auto& value) { json["value"] = value; }, parameter.value);
  // So that 3 stays a number with a fraction.
  if (parameter.kind == ParameterKind::real) json["type"] = "float64";
  return json;
}

Json format_json(std::string_view service, std::string_view part, std::string_view schema) {
  return {{"encoding", "json"},
          {"schemaName", std::string(service).append(part)},
          {"schemaEncoding", "jsonschema"},
          {"schema", schema}};
}

ControlPlayback read_playback(BinaryReader& in) {
  ControlPlayback control;
  const std::uint8_t command = in.u8("the command");
  if (command > 1) throw BadClientMessage("playback: expected command 0 or 1, found " + std::to_string(command));
  control.pauses = command == 1;
  control.speed = in.f32("the speed");
  if (!std::isfinite(control.speed) || control.speed < 0.0f)
    throw BadClientMessage("playback: expected a non-negative speed, found " + std::to_string(control.speed));
  const bool seeks = in.u8("the mark of a seek") != 0;
  const std::uint64_t seek = in.u64("the time to seek");
  if (seeks) control.seek = seek;
  control.request = in.text(in.u32("the length of the request"), "the request");
  in.require_end("playback");
  return control;
}

}  // namespace

std::string_view choose_subprotocol(std::string_view offered) {
  while (!offered.empty()) {
    const std::size_t comma = std::min(offered.find(','), offered.size());
    std::string_view name = offered.substr(0, comma);
    while (!name.empty() && (name.front() == ' ' || name.front() == '\t')) name.remove_prefix(1);
    while (!name.empty() && (name.back() == ' ' || name.back() == '\t')) name.remove_suffix(1);
    for (const std::string_view known : kSubprotocols) {
      if (name == known) return known;
    }
    offered.remove_prefix(std::min(comma + 1, offered.size()));
  }
  return {};
}

ClientMessage read_client_binary(std::span<const std::byte> bytes) {
  BinaryReader in(bytes);
  constexpr std::uint8_t kData = 1, kService = 2, kPlayback = 3;
  const std::uint8_t opcode = in.u8("an opcode");
  if (opcode == kData) return NotOffered{"publishing messages"};
  if (opcode == kPlayback) return read_playback(in);
  if (opcode != kService)
    throw BadClientMessage("binary message: expected opcode 1, 2 or 3, found " + std::to_string(opcode));
  CallService call;
  call.service = in.u32("the service");
  call.call = in.u32("the call");
  call.encoding = in.text(in.u32("the length of the encoding"), "the encoding");
  call.payload = in.rest();
  return call;
}

std::string server_info(const ServerInfo& info) {
  Json json{{"op", "serverInfo"},
            {"name", as_utf8(info.name)},
            {"capabilities", info.capabilities},
            {"supportedEncodings", {"json"}},
            {"metadata", {{"reorient", info.version}}},
            {"sessionId", info.session}};
  if (info.data_start) json["dataStartTime"] = time_json(*info.data_start);
  if (info.data_end) json["dataEndTime"] = time_json(*info.data_end);
  return text_of(json);
}

std::string status(StatusLevel level, std::string_view message, std::string_view id) {
  Json json{{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}};
  if (!id.empty()) json["id"] = id;
  return text_of(json);
}

std::string remove_status(std::string_view id) {
  return text_of({{"op", "removeStatus"}, {"statusIds", Json::array({id})}});
}

std::string advertise_topics(const ApplicationInterface& application) {
  Json channels = Json::array();
  for (const ViewerTopicInfo& topic : kViewerTopics) channels.push_back(channel_json(topic, application));
  return text_of({{"op", "advertise"}, {"channels", std::move(channels)}});
}

std::optional<std::size_t> topic_of(std::uint32_t channel) {
  if (channel == 0 || channel > kViewerTopics.size()) return std::nullopt;
  return channel - 1;
}

std::string parameter_values(std::span<const Parameter> parameters, const std::optional<std::string>& id) {
  Json values = Json::array();
  for (const Parameter& parameter : parameters) values.push_back(parameter_json(parameter));
  Json json{{"op", "parameterValues"}, {"parameters", std::move(values)}};
  if (id) json["id"] = *id;
  return text_of(json);
}

std::string advertise_services(std::span<const ServiceInfo> services) {
  Json all = Json::array();
  for (const ServiceInfo& service : services) {
    all.push_back({{"id", service.id},
                   {"name", service.name},
                   {"type", std::string("reorient.").append(service.name)},
                   {"request", format_json(service.name, ".Request", service.request_schema)},
                   {"response", format_json(service.name, ".Response", service.response_schema)}});
  }
  return text_of({{"op", "advertiseServices"}, {"services", std::move(all)}});
}

std::string service_failure(std::uint32_t service, std::uint32_t call, std::string_view message) {
  return text_of({{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", message}});
}

std::array<std::byte, kDataHead> message_data_head(std::uint32_t subscription, std::uint64_t time) {
  std::array<std::byte, kDataHead> head{std::byte{1}};
  put_little_endian(subscription, head.data() + 1);
  put_little_endian(time, head.data() + 5);
  return head;
}

std::vector<std::byte> server_time(std::uint64_t now) {
  BinaryWriter out(2);
  out.number(now);
  return out.take();
}

std::vector<std::byte> service_response(std::uint32_t service, std::uint32_t call, std::string_view json) {
  BinaryWriter out(3);
  out.number(service);
  out.number(call);
  out.text("json");
  out.rest(json);
  return out.take();
}

std::vector<std::byte> asset_failure(std::uint32_t request, std::string_view message) {
  BinaryWriter out(4);
  out.number(request);
  out.number(std::uint8_t{1});
  out.text(message);
  return out.take();
}

std::vector<std::byte> playback_state(PlaybackStatus status, std::uint64_t now, float speed, bool did_seek,
                                      std::string_view request) {
  BinaryWriter out(5);
  out.number(static_cast<std::uint8_t>(status));
  out.number(now);
  out.number(std::bit_cast<std::uint32_t>(speed));
  out.number(static_cast<std::uint8_t>(did_seek ? 1 : 0));
  out.text(request);
  return out.take();
}

std::uint64_t to_nanoseconds(double seconds) {
  constexpr double kLast = 1.8e10;  // s, below 2^64 ns
  if (!(seconds > 0.0)) return 0;
  return static_cast<std::uint64_t>(std::llround(std::min(seconds, kLast) * 1e9));
}

}  // namespace reorient::live
