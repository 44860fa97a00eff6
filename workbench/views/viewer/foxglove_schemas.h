// SPDX-License-Identifier: MIT
// JSON schemas of Foxglove's messages and of our own: the files in schemas/.
#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

namespace reorient::foxglove {

using Json = nlohmann::ordered_json;

/// Schema of "foxglove.PoseInFrame", "reorient.Event" and the like. Throws std::out_of_range if it has no file.
Json schema(std::string_view name);

}  // namespace reorient::foxglove
