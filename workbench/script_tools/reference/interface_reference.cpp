// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/interface_reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/parameters/nearest_name.h"

namespace reorient {
namespace {

std::string number_text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

bool has_range(const DeclaredField& field) {
  return (field.type == FieldType::number || field.type == FieldType::integer) &&
         (std::isfinite(field.minimum) || std::isfinite(field.maximum));
}

/// "0 to 20", "\"left\", \"right\"", or empty.
std::string permitted(const DeclaredField& field) {
  if (has_range(field))
    return (std::isfinite(field.minimum) ? number_text(field.minimum) : "any") + " to " +
           (std::isfinite(field.maximum) ? number_text(field.maximum) : "any");
  std::string list;
  for (const std::string& choice : field.choices) list.append(list.empty() ? "`" : ", `").append(choice).append(1, '`');
  return list;
}

std::string default_text(const DeclaredField& field) {
  if (field.is_required) return "required";
  if (field.type == FieldType::text && field.initial.texts.front().empty()) return "";
  DeclaredField unnamed = field;  // without "NAME = "
  unnamed.name.clear();
  return to_text(field.initial, {unnamed});
}

/// A cell of a table: no line ends, no bars.
std::string in_cell(std::string_view text) {
  std::string cell;
  for (const char letter : text) {
    if (letter == '|') cell += '\\';
    cell += letter == '\n' ? ' ' : letter;
  }
  return cell;
}

void write_field(std::ostream& out, const std::string& name, const DeclaredField& field, std::string_view description) {
  out << "| `" << name << "` | " << to_string(field.type) << " | " << in_cell(field.unit) << " | "
      << in_cell(permitted(field)) << " | " << in_cell(default_text(field)) << " | " << in_cell(description) << " |";
}

constexpr const char* kFieldColumns =
    "type | unit | range or choices | default | what it is |\n|---|---|---|---|---|---|\n";

std::string duration(double seconds) { return std::isfinite(seconds) ? number_text(seconds) + " s" : ""; }

void write_values(std::ostream& out, const ApplicationInterface& declared) {
  out << "## Values\nA behavior reads them by these names. `input.age.NAME` is the time since the value was set (s), "
         "and\n"
         "`input.valid.NAME` is true for the time in the last column after that.\n\n"
         "| value | type | unit | range or choices | default | what it is | valid for "
         "|\n|---|---|---|---|---|---|---|\n";
  for (const DeclaredValue& value : declared.values) {
    if (value.is_list()) {
      out << "| `input." << value.name << "` | list of at most " << value.most << " records | | | empty | "
          << in_cell(value.description) << " | " << duration(value.lasts) << " |\n";
    } else {
      write_field(out, "input." + value.name, value.fields.front(), value.description);
      out << " " << duration(value.lasts) << " |\n";
    }
  }
  out << "\n";
  for (const DeclaredValue& value : declared.values) {
    if (!value.is_list()) continue;
    out << "A record of `input." << value.name << "`:\n\n| field | " << kFieldColumns;
    for (const DeclaredField& field : value.fields) {
      write_field(out, field.name, field, field.description);
      out << "\n";
    }
    out << "\n";
  }
}

/// What its state becomes, and when.
std::string course_of(const DeclaredAction& action) {
  if (!action.reports) return "It is done after " + duration(action.takes) + ", without reports of the application.";
  if (action.takes == 0.0) return "The application reports when it is done or has failed.";
  return "The application reports when it is done or has failed.\nIt has failed if it does not end within " +
         duration(action.takes) + ".";
}

/// "action.kick { foot = \"left\", direction = 0 }"
std::string example_of(const DeclaredAction& action) {
  FieldData data;
  for (const DeclaredField& field : action.arguments) append(data, field.initial);
  return "action." + to_text(action, data);
}

void write_actions(std::ostream& out, const ApplicationInterface& declared) {
  out << "## Actions\nA behavior requests them in `enter`, `update` or `exit`.\n\n";
  for (const DeclaredAction& action : declared.actions) {
    out << "### `action." << action.name << "`\n```lua\n"
        << example_of(action) << "\n```\nThe application " << in_cell(action.description) << ".\n"
        << course_of(action) << "\n";
    if (!action.parts.empty()) out << "Meanwhile it has these parts of the body: " << list_of(action.parts) << ".\n";
    out << "\n";
    if (action.arguments.empty()) continue;
    out << "| argument | " << kFieldColumns;
    for (const DeclaredField& field : action.arguments) {
      write_field(out, field.name, field, field.description);
      out << "\n";
    }
    out << "\n";
  }
}

/// The type for the Lua language server.
std::string lua_type(const DeclaredField& field) {
  switch (field.type) {
    case FieldType::number:
      return "number";
    case FieldType::integer:
      return "integer";
    case FieldType::boolean:
      return "boolean";
    case FieldType::point:
      return "{ x: number, y: number }";
    case FieldType::pose:
      return "{ x: number, y: number, rotation: number }";
    case FieldType::text:
      break;
  }
  std::string choices;
  for (const std::string& choice : field.choices) choices.append(choices.empty() ? "\"" : "|\"").append(choice + "\"");
  return choices.empty() ? "string" : choices;
}

/// "m, from 0 to 20: distance of the ball"
std::string remark(const DeclaredField& field, const std::string& description) {
  std::string text = field.unit;
  if (has_range(field)) text.append(text.empty() ? "" : ", ").append(permitted(field));
  text.append(text.empty() ? "" : ": ").append(description);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void write_class(std::ostream& out, const std::string& name, const std::vector<DeclaredField>& fields) {
  out << "---@class " << name << "\n";
  for (const DeclaredField& field : fields) {
    const bool is_optional = name.starts_with("reorient.arguments.") && !field.is_required;
    out << "---@field " << field.name << (is_optional ? "? " : " ") << lua_type(field) << " "
        << remark(field, field.description) << "\n";
  }
  out << "\n";
}

/// Lines of `---@field` by the name of the class: a value "ball.x" is the field x of the class of its group.
class InputClasses {
 public:
  /// `root`: "Input", "InputAge" or "InputValid".
  explicit InputClasses(const std::string& root) : root_("reorient." + root) {}

  void add(const std::string& name, const std::string& type_and_description) {
    const std::size_t dot = name.find('.');
    if (dot == std::string::npos) return static_cast<void>(lines_[root_].push_back(name + " " + type_and_description));
    const std::string group = root_ + "." + name.substr(0, dot);
    if (!lines_.contains(group)) lines_[root_].push_back(name.substr(0, dot) + " " + group);
    lines_[group].push_back(name.substr(dot + 1) + " " + type_and_description);
  }
  void write(std::ostream& out) const {
    for (const auto& [name, lines] : lines_) {
      out << "---@class " << name << "\n";
      for (const std::string& line : lines) out << "---@field " << line << "\n";
      out << "\n";
    }
  }

 private:
  std::string root_;
  std::map<std::string, std::vector<std::string>> lines_;
};

}  // namespace

std::string interface_reference(const ApplicationInterface& declared) {
  std::ostringstream out;
  out << "# The interface `" << declared.name
      << "`\nValues and actions of an application. Generated by `reorient reference --interface " << declared.name
      << "`; do not\nedit. [Values and actions of your own](../../docs/applications.md) explains them.\n\n";
  if (!declared.values.empty()) write_values(out, declared);
  if (!declared.actions.empty()) write_actions(out, declared);
  std::string text = out.str();
  text.pop_back();  // the last blank line
  return text;
}

std::string interface_annotations(const ApplicationInterface& declared) {
  std::ostringstream out;
  out << "---@meta\n-- Values and actions of the interface " << declared.name
      << ", for the Lua language server. Generated by\n-- `reorient reference --interface " << declared.name
      << " --format annotations`; do not edit.\n\n";
  InputClasses content("Input"), age("InputAge"), valid("InputValid");
  for (const DeclaredValue& value : declared.values) {
    const std::string record = "reorient.record." + value.name;
    if (value.is_list()) write_class(out, record, value.fields);
    const DeclaredField& first = value.fields.front();
    content.add(value.name, value.is_list() ? record + "[] " + value.description
                                            : lua_type(first) + " " + remark(first, value.description));
    age.add(value.name, "number s");
    valid.add(value.name, "boolean");
  }
  for (const InputClasses* const classes : {&content, &age, &valid}) classes->write(out);
  for (const DeclaredAction& action : declared.actions) {
    write_class(out, "reorient.arguments." + action.name, action.arguments);
    out << "---@class reorient.Action." << action.name << ": reorient.Action\n---@operator call(reorient.arguments."
        << action.name << "): nil\n\n";
  }
  if (!declared.actions.empty()) {
    out << "---@class reorient.Actions\n";
    for (const DeclaredAction& action : declared.actions)
      out << "---@field " << action.name << " reorient.Action." << action.name << " " << action.description << "\n";
    out << "\n";
  }
  std::string text = out.str();
  text.pop_back();
  return text;
}

}  // namespace reorient
