// SPDX-License-Identifier: MIT
// The part of JSON Schema that Foxglove and Lichtblick support (their parseJsonSchema). They drop a topic or a service
// whose schema has anything else.
#pragma once

#include <algorithm>
#include <string>

#include <nlohmann/json.hpp>

namespace reorient {

/// The first position at which these viewers do not support `schema`; empty: they support all of it.
template <typename Json>
std::string unsupported(const Json& schema, const std::string& where, bool is_item = false) {
  if (schema.contains("oneOf")) {
    const auto& choices = schema["oneOf"];
    const bool supported = !is_item && std::all_of(choices.begin(), choices.end(), [](const Json& choice) {
      return choice.contains("title") && choice.contains("const") && choice["const"].is_number();
    });
    return supported ? "" : where + ": expected a choice of titled numbers, found " + schema.dump();
  }
  const std::string type = schema.value("type", "missing");
  if (schema.contains("contentEncoding") && (is_item || type != "string" || schema["contentEncoding"] != "base64"))
    return where + ": expected base64 of a string, found " + schema.dump();
  if (type == "boolean" || type == "string" || type == "number" || type == "integer") return "";
  if (type == "array" && !is_item) {
    if (!schema.contains("items")) return where + ": expected items, found " + schema.dump();
    return unsupported<Json>(schema["items"], where + "[]", true);
  }
  if (type != "object") return where + ": unsupported type in " + schema.dump();
  if (!schema.contains("properties")) return where + ": expected properties, found " + schema.dump();
  for (const auto& [name, property] : schema["properties"].items()) {
    std::string path = where;
    path.append(".").append(name);
    std::string inner = unsupported<Json>(property, path);
    if (!inner.empty()) return inner;
  }
  return "";
}

}  // namespace reorient
