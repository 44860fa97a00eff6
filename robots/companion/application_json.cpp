// SPDX-License-Identifier: MIT
#include "robots/companion/application_json.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <nlohmann/json.hpp>

#include "robots/companion/message.h"

namespace reorient {
namespace {

using Json = nlohmann::json;

/// Deeper texts are refused before they are parsed.
constexpr int kDeepest = 8;

bool is_too_deep(std::string_view json) {
  int depth = 0;
  bool is_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (is_text && json[i] == '\\') {
      ++i;
    } else if (json[i] == '"') {
      is_text = !is_text;
    } else if (!is_text && (json[i] == '{' || json[i] == '[')) {
      if (++depth > kDeepest) return true;
    } else if (!is_text && (json[i] == '}' || json[i] == ']')) {
      --depth;
    }
  }
  return false;
}

/// NaN fits no declaration.
double number_in(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

void append_field(const Json& json, const DeclaredField& field, FieldData& data) {
  switch (field.type) {
    case FieldType::boolean:
      data.numbers.push_back(json.is_boolean() ? (json.get<bool>() ? 1.0 : 0.0) : number_in(Json()));
      return;
    case FieldType::text:
      // Too long, so that it does not fit.
      data.texts.push_back(json.is_string() ? json.get<std::string>() : std::string(kLongestFieldText + 1, '?'));
      return;
    case FieldType::number:
    case FieldType::integer:
      data.numbers.push_back(number_in(json));
      return;
    case FieldType::point:
    case FieldType::pose:
      for (std::size_t i = 0; i < numbers_of(field.type); ++i)
        data.numbers.push_back(json.is_object() && json.contains(kCoordinates[i]) ? number_in(json[kCoordinates[i]])
                                                                                  : number_in(Json()));
      return;
  }
}

/// An integer where a double represents it exactly.
Json whole_number(double number) {
  constexpr double kExact = 9007199254740992.0;  // 2^53
  return std::abs(number) <= kExact ? Json(static_cast<std::int64_t>(number)) : Json(number);
}

void append_record(const Json& json, const DeclaredValue& value, FieldData& data) {
  if (json.is_object()) {
    for (const auto& [key, content] : json.items()) {
      bool is_known = false;
      for (const DeclaredField& field : value.fields) is_known |= field.name == key;
      if (!is_known) throw BadMessage("values: " + value.name + " has no field '" + key + "'");
    }
  }
  for (const DeclaredField& field : value.fields) {
    if (json.is_object() && !json.contains(field.name)) {
      append(data, field.initial);
    } else {
      append_field(json.is_object() ? json[field.name] : Json(), field, data);
    }
  }
}

SetValue set_value(const Json& json, std::uint16_t index, const DeclaredValue& value) {
  SetValue set{index, 1, {}};
  if (!value.is_list()) {
    append_field(json, value.fields.front(), set.data);
    return set;
  }
  if (!json.is_array()) return set;  // one record without content, which does not fit
  const bool is_too_long = json.size() > value.most;
  set.records = is_too_long ? value.most + 1 : static_cast<std::uint32_t>(json.size());
  for (std::size_t i = 0; !is_too_long && i < json.size(); ++i) append_record(json[i], value, set.data);
  return set;
}

}  // namespace

std::vector<SetValue> read_values(std::string_view text, const ApplicationInterface& declared) {
  const Json json = is_too_deep(text) ? Json(Json::value_t::discarded) : Json::parse(text, nullptr, false);
  if (!json.is_object()) throw BadMessage("values: expected a JSON object, at most 8 levels deep");
  std::vector<SetValue> all;
  const auto add = [&](const std::string& name, const Json& content) {
    for (std::size_t i = 0; i < declared.values.size(); ++i) {
      if (declared.values[i].name != name) continue;
      all.push_back(set_value(content, static_cast<std::uint16_t>(i), declared.values[i]));
      return true;
    }
    return false;
  };
  for (const auto& [key, content] : json.items()) {
    if (add(key, content)) continue;
    if (!content.is_object()) throw BadMessage("values: unknown value '" + key + "'");
    for (const auto& [member, inner] : content.items()) {
      const std::string name = std::string(key).append(".").append(member);
      if (!add(name, inner)) throw BadMessage("values: unknown value '" + name + "'");
    }
  }
  return all;
}

std::string arguments_json(const StartedAction& started, const DeclaredAction& declared) {
  Json json = Json::object();
  std::size_t number = 0, text = 0;
  for (const DeclaredField& field : declared.arguments) {
    Json& content = json[field.name];
    switch (field.type) {
      case FieldType::boolean:
        content = started.arguments.numbers.at(number++) != 0.0;
        break;
      case FieldType::text:
        content = started.arguments.texts.at(text++);
        break;
      case FieldType::number:
        content = started.arguments.numbers.at(number++);
        break;
      case FieldType::integer:
        content = whole_number(started.arguments.numbers.at(number++));
        break;
      case FieldType::point:
      case FieldType::pose:
        for (std::size_t i = 0; i < numbers_of(field.type); ++i)
          content[kCoordinates[i]] = started.arguments.numbers.at(number++);
        break;
    }
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace reorient
