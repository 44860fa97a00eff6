// SPDX-License-Identifier: MIT
// What an application adds to the world and to the actions of behaviors: values that it delivers, and actions that it
// carries out. Both are declared once, before the first frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/const_or.h"

namespace reorient {

/// The type of a field. A point is x and y (m), a pose is x, y and rotation (rad).
enum class FieldType { number, integer, boolean, text, point, pose };
constexpr int enum_count(FieldType) { return 6; }

/// "number": the name in files and docs.
std::string_view to_string(FieldType type);

/// The content of fields, in their order: a number, integer or boolean (0 or 1) is one of the numbers, a point two, a
/// pose three, a text one of the texts.
struct FieldData {
  std::vector<double> numbers;
  std::vector<std::string> texts;  ///< at most kLongestFieldText bytes each

  bool operator==(const FieldData&) const = default;
};
inline constexpr std::size_t kLongestFieldText = 1000;
template <typename Visit, ConstOr<FieldData> T>
void fields(Visit&& visit, T& data) {
  visit(data.numbers, data.texts);
}

struct DeclaredField {
  std::string name;  ///< "direction"
  FieldType type = FieldType::number;
  std::string unit;                                           ///< of a number or integer
  std::string description;                                    ///< one phrase
  double minimum = -std::numeric_limits<double>::infinity();  ///< of a number or integer
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  ///< of a text; empty: any text
  bool is_required = false;          ///< of an argument: it has no default
  FieldData initial;                 ///< the default
};
template <typename Visit, ConstOr<DeclaredField> T>
void fields(Visit&& visit, T& field) {
  visit(field.name, field.type, field.unit, field.description, field.minimum, field.maximum, field.choices,
        field.is_required, field.initial);
}

/// A value that behaviors read as `input.NAME`.
struct DeclaredValue {
  std::string name;                                        ///< "ball.x"
  std::string description;                                 ///< one phrase
  std::vector<DeclaredField> fields;                       ///< of a list: those of a record; else one
  std::uint32_t most = 0;                                  ///< records of a list; 0: it is not a list
  double lasts = std::numeric_limits<double>::infinity();  ///< s for which it is valid after it was set

  bool is_list() const { return most > 0; }
};
template <typename Visit, ConstOr<DeclaredValue> T>
void fields(Visit&& visit, T& value) {
  visit(value.name, value.description, value.fields, value.most, value.lasts);
}

/// An action that behaviors request as `action.NAME { argument = ... }`.
struct DeclaredAction {
  std::string name;  ///< "kick"
  std::string description;
  std::vector<DeclaredField> arguments;
  /// s. Without reports, the action is done after this time. With reports, it has failed if it does not end in this
  /// time; 0: it may take any time.
  double takes = 0.0;
  bool reports = false;              ///< the application reports whether the action runs, is done or has failed
  std::vector<std::string> parts{};  ///< of the body that it moves, for as long as it runs: "legs", or its own "tail"
};
template <typename Visit, ConstOr<DeclaredAction> T>
void fields(Visit&& visit, T& action) {
  visit(action.name, action.description, action.arguments, action.takes, action.reports, action.parts);
}

struct ApplicationInterface {
  std::string name;  ///< "soccer"; empty: nothing is declared
  std::vector<DeclaredValue> values;
  std::vector<DeclaredAction> actions;

  bool is_empty() const { return values.empty() && actions.empty(); }
};
template <typename Visit, ConstOr<ApplicationInterface> T>
void fields(Visit&& visit, T& declared) {
  visit(declared.name, declared.values, declared.actions);
}
inline constexpr std::size_t kMostValues = 256, kMostActions = 64, kMostFields = 32, kMostChoices = 64, kMostParts = 8,
                             kMostBodyParts = 64;
inline constexpr std::uint32_t kMostRecords = 64;

/// Names of the parts of the body: those that every robot may have, the head and the legs first, then those of the
/// actions.
std::vector<std::string> body_parts(const ApplicationInterface& declared);

/// One line about the first mistake in the declarations, or an empty text.
std::string mistake_in(const ApplicationInterface& declared);

/// The empty text if the data fit the fields `records` times; else what was expected and found: "x: expected a number
/// from -10 to 10, found nan".
std::string mistake_in(const FieldData& data, const std::vector<DeclaredField>& fields, std::uint32_t records = 1);

/// "left, 0.3": the content of one record as text, for people.
std::string to_text(const FieldData& data, const std::vector<DeclaredField>& fields, std::uint32_t record = 0);

/// "kick { foot = \"left\" }".
std::string to_text(const DeclaredAction& action, const FieldData& arguments);

// How much of FieldData a field takes.
std::size_t numbers_of(FieldType type);
std::size_t texts_of(FieldType type);

/// Names of the numbers of a point (the first two) and of a pose.
inline constexpr const char* kCoordinates[] = {"x", "y", "rotation"};

/// Appends the content of further fields.
void append(FieldData& data, const FieldData& more);

/// A new value of a declared one. Of several in a frame the last counts.
struct SetValue {
  std::uint16_t value = 0;    ///< index in ApplicationInterface::values
  std::uint32_t records = 1;  ///< of a list: 0 to DeclaredValue::most
  FieldData data;
};
template <typename Visit, ConstOr<SetValue> T>
void fields(Visit&& visit, T& set) {
  visit(set.value, set.records, set.data);
}
inline constexpr std::size_t kMostSetValues = 4 * kMostValues;  // per frame; more are ignored

/// An action that the application is to begin.
struct StartedAction {
  std::uint32_t id = 0;      ///< counts from 1; for reports
  std::uint16_t action = 0;  ///< index in ApplicationInterface::actions
  FieldData arguments;
};
template <typename Visit, ConstOr<StartedAction> T>
void fields(Visit&& visit, T& started) {
  visit(started.id, started.action, started.arguments);
}

/// The states of an action; the last two are its ends.
enum class ActionState {
  idle,       ///< never requested
  requested,  ///< the application has not reported that it began
  running,
  done,
  failed
};
constexpr int enum_count(ActionState) { return 5; }
constexpr bool is_under_way(ActionState state) {
  return state == ActionState::requested || state == ActionState::running;
}

/// "running": the name in scripts.
std::string_view to_string(ActionState state);

/// The state of a started action. Reports about earlier actions are ignored.
struct ActionReport {
  std::uint32_t id = 0;                      ///< StartedAction::id
  ActionState state = ActionState::running;  ///< running, done or failed
  std::string reason;                        ///< of a failure, at most kLongestFieldText bytes
};
template <typename Visit, ConstOr<ActionReport> T>
void fields(Visit&& visit, T& report) {
  visit(report.id, report.state, report.reason);
}
inline constexpr std::size_t kMostReports = 4 * kMostActions;  // per frame; more are ignored

}  // namespace reorient
