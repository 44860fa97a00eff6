#include "workbench/files/field_file.h"

#include <array>
#include <sstream>
#include <stdexcept>
#include <string>

#include <toml++/toml.h>

namespace reorient {
namespace {

struct Length {
  const char* key;
  double FieldDimensions::*member;
  double min;
  double max;
};

constexpr std::array<Length, 15> kLengths{{
    {"length", &FieldDimensions::length, 2.0, 120.0},
    {"width", &FieldDimensions::width, 1.0, 90.0},
    {"border", &FieldDimensions::border, 0.0, 10.0},
    {"line_width", &FieldDimensions::line_width, 0.01, 0.3},
    {"penalty_area_depth", &FieldDimensions::penalty_area_depth, 0.0, 20.0},
    {"penalty_area_width", &FieldDimensions::penalty_area_width, 0.0, 60.0},
    {"goal_area_depth", &FieldDimensions::goal_area_depth, 0.0, 20.0},
    {"goal_area_width", &FieldDimensions::goal_area_width, 0.0, 60.0},
    {"penalty_mark_x", &FieldDimensions::penalty_mark_x, 0.0, 60.0},
    {"penalty_mark_size", &FieldDimensions::penalty_mark_size, 0.0, 0.5},
    {"center_circle_radius", &FieldDimensions::center_circle_radius, 0.0, 10.0},
    {"goal_post_y", &FieldDimensions::goal_post_y, 0.2, 5.0},
    {"goal_height", &FieldDimensions::goal_height, 0.2, 5.0},
    {"goal_depth", &FieldDimensions::goal_depth, 0.0, 5.0},
    {"goal_post_diameter", &FieldDimensions::goal_post_diameter, 0.02, 0.5},
}};

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error("field file '" + file.string() + "': " + what);
}

void read_length(const toml::table& table, const Length& length, const std::filesystem::path& file,
                 FieldDimensions& field) {
  const toml::node* node = table.get(length.key);
  if (node == nullptr) fail(file, std::string("'") + length.key + "' is missing; add it, in metres");
  const std::optional<double> value = node->value<double>();
  // Written so that NaN fails as well.
  if (!value || !(*value >= length.min && *value <= length.max)) {
    std::ostringstream text;
    text << "'" << length.key << "' must be a number from " << length.min << " to " << length.max << " metres";
    fail(file, text.str());
  }
  field.*length.member = *value;
}

bool is_key(std::string_view key) {
  if (key == "yellow_goals") return true;
  for (const Length& length : kLengths) {
    if (key == length.key) return true;
  }
  return false;
}

}  // namespace

FieldDimensions load_field(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) fail(file, "there is no such file; assets/fields has examples");
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    std::ostringstream text;
    text << "line " << error.source().begin.line << ": " << error.description();
    fail(file, text.str());
  }
  for (const auto& [key, value] : table) {
    if (!is_key(key.str()))
      fail(file, "'" + std::string(key.str()) + "' is not a key of a field; see assets/fields/README.md");
  }
  FieldDimensions field;
  for (const Length& length : kLengths) read_length(table, length, file, field);
  const std::optional<bool> yellow = table["yellow_goals"].value_exact<bool>();
  if (!yellow) fail(file, "'yellow_goals' must be true or false");
  field.yellow_goals = *yellow;
  return field;
}

}  // namespace reorient
