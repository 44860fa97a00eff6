// JSON schemas: of Foxglove's messages, and what those of our own are made of.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace reorient::foxglove {

using Json = nlohmann::ordered_json;

/// A JSON object in which all that is declared has to be there.
Json object_schema(const std::vector<std::pair<std::string, Json>>& properties);
Json array_schema(Json items);
Json number_schema();
Json integer_schema();
Json string_schema();
Json boolean_schema();

/// Of "foxglove.PoseInFrame" and those others that we send. Throws std::out_of_range for one that we do not.
Json schema(std::string_view name);

}  // namespace reorient::foxglove
