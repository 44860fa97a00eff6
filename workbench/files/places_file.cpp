// SPDX-License-Identifier: MIT
#include "workbench/files/places_file.h"

#include <vector>

#include "geometry/settable_pose.h"
#include "workbench/files/table_reader.h"

namespace reorient {

Places parse_places(std::string_view text, const std::string& name) {
  constexpr double kMostTurned = 360.0;  // degrees
  const toml::table table = parse_table(text, name);
  const TableReader in(table, name);
  Places places;
  TableReader::Readers readers;
  for (std::size_t i = 0; i < places.size(); ++i) {
    readers["player_" + std::to_string(i + 1)] = [&in, &place = places[i]](auto& key, auto& value) {
      const std::vector<double> numbers = in.numbers(key, value, 3, -kMostTurned, kMostTurned);
      if (const std::string mistake = mistake_in_pose(numbers[0], numbers[1], 0.0); !mistake.empty())
        in.refuse(value, std::string(key).append(": ").append(mistake));
      place = Pose2(numbers[0], numbers[1], from_degrees(numbers[2]));
    };
  }
  in.read(readers);
  return places;
}

Places load_places(const std::filesystem::path& file) {
  return parse_places(read_data_file(file, "places of the players", "docs/on-a-robot.md"), file.string());
}

}  // namespace reorient
