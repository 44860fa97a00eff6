// SPDX-License-Identifier: MIT
#include "workbench/files/field_file.h"

#include <algorithm>
#include <string>

#include "workbench/files/table_reader.h"

namespace reorient {
namespace {

/// Rule books measure to the outside of lines, and to the inside of goals; the program to the middle of both.
void to_centers(FieldDimensions& field) {
  const double line = field.line_width;
  const auto shrink = [](double& length, double by) { length = std::max(0.0, length - by); };
  shrink(field.length, line);
  shrink(field.width, line);
  field.border += 0.5 * line;
  shrink(field.penalty_area_depth, line);
  shrink(field.penalty_area_width, line);
  shrink(field.goal_area_depth, line);
  shrink(field.goal_area_width, line);
  shrink(field.center_circle_radius, 0.5 * line);
  shrink(field.corner_arc_radius, 0.5 * line);
}

}  // namespace

FieldDimensions load_field(const std::filesystem::path& file) {
  return parse_field(read_data_file(file, "field", "assets/fields"), file.string());
}

FieldDimensions parse_field(std::string_view text, const std::string& name) {
  const toml::table table = parse_table(text, name);
  const TableReader in(table, name);
  FieldDimensions field;
  bool outside = false;
  TableReader::Readers readers{
      {"measured_to",
       [&](auto& key, auto& value) {
         const std::string what = in.text(key, value);
         outside = what == "outside of lines";
         if (!outside && what != "middle of lines")
           in.refuse(value, R"(measured_to: expected "middle of lines" or "outside of lines")" + found_text(value));
       }},
      {"yellow_goals", [&](auto& key, auto& value) { field.yellow_goals = in.yes(key, value); }}};
  TableReader::Readers optional;  // missing in files of former versions
  describe(field, [&](const char* length, double& meters, double least, double most) {
    (&meters == &field.ball_diameter ? optional : readers)[length] = in.into(meters, least, most);
  });
  in.read_all(readers, optional);
  if (outside) to_centers(field);
  if (const std::string mistake = mistake_in(field); !mistake.empty())
    in.refuse(table, mistake + " between the middles of lines");
  return field;
}

}  // namespace reorient
