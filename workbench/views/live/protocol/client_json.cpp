// SPDX-License-Identifier: MIT
#include "workbench/views/live/protocol/client_json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/parameters/utf8.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {
namespace {

/// The depth of nested arrays and objects, without reading the values.
int depth_of(std::string_view json) {
  int depth = 0, deepest = 0;
  bool is_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char letter = json[i];
    if (is_text && letter == '\\') {
      ++i;
    } else if (letter == '"') {
      is_text = !is_text;
    } else if (!is_text && (letter == '[' || letter == '{')) {
      deepest = std::max(deepest, ++depth);
    } else if (!is_text && (letter == ']' || letter == '}')) {
      --depth;
    }
  }
  return deepest;
}

/// The beginning of foreign text, as one line.
std::string excerpt(std::string_view text) {
  constexpr std::size_t kMost = 60;
  return as_line(text.substr(0, kMost)) + (text.size() > kMost ? "..." : "");
}

std::vector<ParameterText> parameter_texts(const ClientObject& message) {
  std::vector<ParameterText> all;
  for (const ClientObject& one : message.objects("parameters")) {
    ParameterText& parameter = all.emplace_back(ParameterText{one.text("name"), std::nullopt});
    const auto value = one.json().find("value");
    if (value == one.json().end()) continue;
    if (value->is_string()) parameter.value = value->get<std::string>();
    if (value->is_number() || value->is_boolean()) parameter.value = value->dump();
  }
  return all;
}

std::vector<Subscribe::One> subscriptions_of(const ClientObject& message) {
  std::vector<Subscribe::One> all;
  for (const ClientObject& one : message.objects("subscriptions"))
    all.push_back({one.number("id"), one.number("channelId")});
  return all;
}

}  // namespace

ClientObject::ClientObject(std::string what, std::string_view text) : what_(std::move(what)) {
  if (text.size() > kLargestClientMessage)
    throw BadClientMessage(what_ + ": expected at most " + std::to_string(kLargestClientMessage) + " bytes, found " +
                           std::to_string(text.size()));
  if (const int depth = depth_of(text); depth > kDeepestClientJson)
    throw BadClientMessage(what_ + ": expected at most " + std::to_string(kDeepestClientJson) +
                           " nested values, found " + std::to_string(depth));
  json_ = nlohmann::json::parse(text, nullptr, false);
  if (!json_.is_object()) throw BadClientMessage(what_ + ": expected a JSON object, found '" + excerpt(text) + "'");
}

void ClientObject::refuse(const std::string& where, const char* expected, const nlohmann::json& found) const {
  throw BadClientMessage(what_ + ": " + as_line(where) + ": expected " + expected + ", found " +
                         excerpt(found.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace)));
}

const nlohmann::json& ClientObject::member(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end()) throw BadClientMessage(what_ + ": expected the member '" + name + "', found none");
  return *found;
}

const nlohmann::json& ClientObject::array(const char* name) const {
  const nlohmann::json& value = member(name);
  if (!value.is_array()) refuse(name, "an array", value);
  return value;
}

std::string ClientObject::text(const char* name) const {
  const nlohmann::json& value = member(name);
  if (!value.is_string()) refuse(name, "a text", value);
  return value.get<std::string>();
}

std::optional<std::string> ClientObject::optional_text(const char* name) const {
  if (!json_.contains(name)) return std::nullopt;
  return text(name);
}

std::string ClientObject::text_or_empty(const char* name) const { return optional_text(name).value_or(""); }

std::vector<std::string> ClientObject::texts(const char* name) const {
  std::vector<std::string> all;
  for (const nlohmann::json& value : array(name)) {
    if (!value.is_string()) refuse(name, "texts", value);
    all.push_back(value.get<std::string>());
  }
  return all;
}

std::uint32_t ClientObject::number_of(const std::string& where, const nlohmann::json& value) const {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > kMost)
    refuse(where, "a whole number from 0 to 4294967295", value);
  return value.get<std::uint32_t>();
}

std::uint32_t ClientObject::number(const char* name) const { return number_of(name, member(name)); }

std::optional<double> ClientObject::optional_real(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end()) return std::nullopt;
  if (!found->is_number() || !std::isfinite(found->get<double>())) refuse(name, "a number", *found);
  return found->get<double>();
}

std::optional<bool> ClientObject::optional_boolean(const char* name) const {
  const auto found = json_.find(name);
  if (found == json_.end()) return std::nullopt;
  if (!found->is_boolean()) refuse(name, "true or false", *found);
  return found->get<bool>();
}

std::vector<std::uint32_t> ClientObject::numbers(const char* name) const {
  std::vector<std::uint32_t> all;
  for (const nlohmann::json& value : array(name)) all.push_back(number_of(name, value));
  return all;
}

std::vector<ClientObject> ClientObject::objects(const char* name) const {
  std::vector<ClientObject> all;
  for (const nlohmann::json& value : array(name)) {
    if (!value.is_object()) refuse(name, "objects", value);
    all.push_back(ClientObject(Parsed(), what_ + ": " + name, value));
  }
  return all;
}

std::vector<ParameterText> read_parameter_texts(std::string_view json) {
  return parameter_texts(ClientObject("parameters", json));
}

ClientMessage read_client_text(std::string_view text) {
  const ClientObject unnamed("message", text);
  const std::string operation = unnamed.text("op");
  if (operation == "subscribe") return Subscribe{subscriptions_of(unnamed)};
  if (operation == "unsubscribe") return Unsubscribe{unnamed.numbers("subscriptionIds")};
  if (operation == "getParameters") return GetParameters{unnamed.texts("parameterNames"), unnamed.optional_text("id")};
  if (operation == "setParameters") return SetParameters{parameter_texts(unnamed), unnamed.optional_text("id")};
  if (operation == "subscribeParameterUpdates") return WatchParameters{unnamed.texts("parameterNames"), true};
  if (operation == "unsubscribeParameterUpdates") return WatchParameters{unnamed.texts("parameterNames"), false};
  if (operation == "fetchAsset") return FetchAsset{unnamed.number("requestId")};
  if (operation == "advertise" || operation == "unadvertise") return NotOffered{"publishing messages"};
  if (operation == "subscribeConnectionGraph" || operation == "unsubscribeConnectionGraph")
    return NotOffered{"the connection graph"};
  throw BadClientMessage("message: op: expected an operation of the Foxglove protocol, found '" + excerpt(operation) +
                         "'");
}

}  // namespace reorient::live
