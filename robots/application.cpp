// SPDX-License-Identifier: MIT
#include "robots/application.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <set>

namespace reorient {
namespace {

constexpr std::size_t kLongestName = 60;

bool is_word(std::string_view text) {
  constexpr std::array kReserved{"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                 "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                 "repeat",   "return", "then", "true", "until",  "while"};
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  if (text.empty() || text.size() > kLongestName || !is_letter(text.front())) return false;
  return std::all_of(text.begin(), text.end(), [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); }) &&
         std::find(kReserved.begin(), kReserved.end(), text) == kReserved.end();
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// "0.25", the shortest text that reads back as the same number.
std::string number_text(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::string range_text(const DeclaredField& field) {
  std::string what = field.type == FieldType::integer ? "an integer" : "a number";
  const std::string unit = field.unit.empty() ? "" : " " + field.unit;
  if (!std::isfinite(field.minimum) && !std::isfinite(field.maximum)) return what;
  if (!std::isfinite(field.maximum)) return what + " of at least " + number_text(field.minimum) + unit;
  if (!std::isfinite(field.minimum)) return what + " of at most " + number_text(field.maximum) + unit;
  return what + " from " + number_text(field.minimum) + " to " + number_text(field.maximum) + unit;
}

std::string mistake_in_number(double number, const DeclaredField& field) {
  const auto wrong = [&](const std::string& expected) {
    return "expected " + expected + ", found " + number_text(number);
  };
  switch (field.type) {
    case FieldType::boolean:
      return number == 0.0 || number == 1.0 ? "" : wrong("true or false");
    case FieldType::integer:
    case FieldType::number: {
      const bool fits = std::isfinite(number) && number >= field.minimum && number <= field.maximum;
      return fits && (field.type == FieldType::number || number == std::floor(number)) ? "" : wrong(range_text(field));
    }
    case FieldType::point:
    case FieldType::pose:
    case FieldType::text:
      break;
  }
  return std::isfinite(number) ? "" : wrong("finite coordinates");
}

std::string mistake_in_text(const std::string& text, const DeclaredField& field) {
  if (text.size() > kLongestFieldText)
    return "expected at most " + std::to_string(kLongestFieldText) + " bytes, found " + std::to_string(text.size());
  if (field.choices.empty() || std::find(field.choices.begin(), field.choices.end(), text) != field.choices.end())
    return "";
  std::string expected;
  for (const std::string& choice : field.choices) expected.append(expected.empty() ? "" : " or ").append(choice);
  return "expected " + expected + ", found " + quoted(text);
}

std::string mistake_in_field(const DeclaredField& field) {
  const bool has_range = std::isfinite(field.minimum) || std::isfinite(field.maximum);
  const bool is_number = field.type == FieldType::number || field.type == FieldType::integer;
  if (has_range && !is_number) return "only a number or an integer has a range";
  if (std::isnan(field.minimum) || std::isnan(field.maximum) || field.minimum > field.maximum)
    return "expected a range from low to high, found " + number_text(field.minimum) + " to " +
           number_text(field.maximum);
  if (!field.choices.empty() && field.type != FieldType::text) return "only a text has choices";
  if (field.choices.size() > kMostChoices)
    return "expected at most " + std::to_string(kMostChoices) + " choices, found " +
           std::to_string(field.choices.size());
  if (field.is_required) return "";
  const std::string mistake = mistake_in(field.initial, {field});
  return mistake.empty() ? "" : "default: " + mistake;
}

/// How much of FieldData a record takes.
struct RecordSize {
  std::size_t numbers = 0, texts = 0;
};
RecordSize record_size(const std::vector<DeclaredField>& fields) {
  RecordSize size;
  for (const DeclaredField& field : fields) {
    size.numbers += numbers_of(field.type);
    size.texts += texts_of(field.type);
  }
  return size;
}

/// Of the fields of a record, or of arguments.
std::string mistake_in_fields(const std::vector<DeclaredField>& fields) {
  if (fields.size() > kMostFields)
    return "expected at most " + std::to_string(kMostFields) + " fields, found " + std::to_string(fields.size());
  std::set<std::string> names;
  for (const DeclaredField& field : fields) {
    if (!is_word(field.name)) return quoted(field.name) + ": expected a name such as ball_x";
    if (!names.insert(field.name).second) return quoted(field.name) + " is declared twice";
    if (const std::string mistake = mistake_in_field(field); !mistake.empty()) return field.name + ": " + mistake;
  }
  return "";
}

/// "ball.x" or "ball"; the groups `age` and `valid` are the program's own.
std::string mistake_in_name(const std::string& name) {
  const std::size_t dot = name.find('.');
  const std::string_view group = std::string_view(name).substr(0, dot);
  const bool is_name = is_word(group) && (dot == std::string::npos || is_word(std::string_view(name).substr(dot + 1)));
  if (!is_name) return "expected a name such as ball.x or teammates";
  if (group == "age" || group == "valid") return std::string(group) + " is a name of the program (choose another one)";
  return "";
}

std::string mistake_in_value(const DeclaredValue& value) {
  if (std::string mistake = mistake_in_name(value.name); !mistake.empty()) return mistake;
  if (!(value.lasts > 0.0)) return "lasts: expected more than 0 s, found " + number_text(value.lasts);
  if (value.most > kMostRecords)
    return "expected at most " + std::to_string(kMostRecords) + " records, found " + std::to_string(value.most);
  if (!value.is_list()) return value.fields.size() == 1 ? mistake_in_field(value.fields.front()) : "expected one field";
  return value.fields.empty() ? "expected the fields of a record" : mistake_in_fields(value.fields);
}

std::string mistake_in_action(const DeclaredAction& action) {
  if (!is_word(action.name)) return "expected a name such as kick";
  if (!std::isfinite(action.takes) || action.takes < 0.0)
    return "takes: expected a time of at least 0 s, found " + number_text(action.takes);
  if (action.parts.size() > kMostParts)
    return "parts: expected at most " + std::to_string(kMostParts) + ", found " + std::to_string(action.parts.size());
  for (const std::string& part : action.parts) {
    if (!is_word(part)) return "parts: expected names such as legs, found " + quoted(part);
  }
  return mistake_in_fields(action.arguments);
}

}  // namespace

std::string_view to_string(FieldType type) {
  constexpr std::string_view kNames[] = {"number", "integer", "boolean", "text", "point", "pose"};
  static_assert(std::size(kNames) == enum_count(FieldType()));
  return kNames[static_cast<std::size_t>(type)];
}

std::string_view to_string(ActionState state) {
  constexpr std::string_view kNames[] = {"idle", "requested", "running", "done", "failed"};
  static_assert(std::size(kNames) == enum_count(ActionState()));
  return kNames[static_cast<std::size_t>(state)];
}

std::vector<std::string> body_parts(const ApplicationInterface& declared) {
  std::vector<std::string> all{"head", "legs", "arms", "voice", "leds"};
  for (const DeclaredAction& action : declared.actions) {
    for (const std::string& part : action.parts) {
      if (std::find(all.begin(), all.end(), part) == all.end()) all.push_back(part);
    }
  }
  return all;
}

std::size_t numbers_of(FieldType type) {
  return type == FieldType::text ? 0 : type == FieldType::point ? 2 : type == FieldType::pose ? 3 : 1;
}

std::size_t texts_of(FieldType type) { return type == FieldType::text ? 1 : 0; }

std::string mistake_in(const FieldData& data, const std::vector<DeclaredField>& fields, std::uint32_t records) {
  const RecordSize size = record_size(fields);
  if (data.numbers.size() != records * size.numbers || data.texts.size() != records * size.texts) {
    return "expected " + std::to_string(records * size.numbers) + " numbers and " +
           std::to_string(records * size.texts) + " texts, found " + std::to_string(data.numbers.size()) + " and " +
           std::to_string(data.texts.size());
  }
  std::size_t numbers = 0, texts = 0;
  for (std::uint32_t record = 0; record < records; ++record) {
    for (const DeclaredField& field : fields) {
      std::string mistake;
      for (std::size_t i = 0; i < numbers_of(field.type) && mistake.empty(); ++i)
        mistake = mistake_in_number(data.numbers[numbers + i], field);
      if (texts_of(field.type) > 0) mistake = mistake_in_text(data.texts[texts], field);
      if (!mistake.empty()) return field.name.empty() ? mistake : field.name + ": " + mistake;
      numbers += numbers_of(field.type);
      texts += texts_of(field.type);
    }
  }
  return "";
}

std::string to_text(const FieldData& data, const std::vector<DeclaredField>& fields, std::uint32_t record) {
  const RecordSize size = record_size(fields);
  std::size_t number = record * size.numbers, text = record * size.texts;
  std::string all;
  for (const DeclaredField& field : fields) {
    if (!all.empty()) all += ", ";
    if (fields.size() > 1 || !field.name.empty()) all.append(field.name).append(" = ");
    const bool is_group = numbers_of(field.type) > 1;
    if (is_group) all += '(';
    for (std::size_t i = 0; i < numbers_of(field.type); ++i, ++number) {
      if (i > 0) all += ", ";
      const double content = data.numbers.at(number);
      all += field.type == FieldType::boolean ? (content != 0.0 ? "true" : "false") : number_text(content);
    }
    if (is_group) all += ')';
    if (texts_of(field.type) > 0) all.append("\"").append(data.texts.at(text++)).append("\"");
  }
  return all;
}

std::string to_text(const DeclaredAction& action, const FieldData& arguments) {
  const std::string content = to_text(arguments, action.arguments);
  return content.empty() ? action.name : action.name + " { " + content + " }";
}

void append(FieldData& data, const FieldData& more) {
  data.numbers.insert(data.numbers.end(), more.numbers.begin(), more.numbers.end());
  data.texts.insert(data.texts.end(), more.texts.begin(), more.texts.end());
}

std::string mistake_in(const ApplicationInterface& declared) {
  if (declared.values.size() > kMostValues)
    return "expected at most " + std::to_string(kMostValues) + " values, found " +
           std::to_string(declared.values.size());
  if (declared.actions.size() > kMostActions)
    return "expected at most " + std::to_string(kMostActions) + " actions, found " +
           std::to_string(declared.actions.size());
  std::set<std::string> names, groups;
  for (const DeclaredValue& value : declared.values) {
    std::string mistake = mistake_in_value(value);
    if (mistake.empty() && !names.insert(value.name).second) mistake = "it is declared twice";
    if (!mistake.empty()) return "value " + quoted(value.name) + ": " + mistake;
    if (const std::size_t dot = value.name.find('.'); dot != std::string::npos)
      groups.insert(value.name.substr(0, dot));
  }
  for (const std::string& group : groups) {
    if (names.contains(group)) return "value " + quoted(group) + ": it is also the group of other values";
  }
  names.clear();
  for (const DeclaredAction& action : declared.actions) {
    std::string mistake = mistake_in_action(action);
    if (mistake.empty() && !names.insert(action.name).second) mistake = "it is declared twice";
    if (!mistake.empty()) return "action " + quoted(action.name) + ": " + mistake;
  }
  if (const std::size_t parts = body_parts(declared).size(); parts > kMostBodyParts) {
    return "expected at most " + std::to_string(kMostBodyParts) + " parts of the body, found " + std::to_string(parts);
  }
  return "";
}

}  // namespace reorient
