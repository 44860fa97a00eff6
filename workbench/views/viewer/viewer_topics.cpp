// SPDX-License-Identifier: MIT
#include "workbench/views/viewer/viewer_topics.h"

#include <string>
#include <utility>
#include <variant>

#include "engine/record/frame_record.h"
#include "engine/script/language/world_fields.h"
#include "workbench/run/application_values.h"
#include "workbench/views/viewer/foxglove.h"

namespace reorient {
namespace {

using foxglove::Json;

Json schema_of(const WorldField& field) {
  Json schema{{"type", field.type_name()}};
  schema["description"] =
      std::string(field.description) + (field.unit.empty() ? "" : " (" + std::string(field.unit) + ")");
  return schema;
}

/// "input.ball.x" as the property x of the property ball of the table input.
void add_application(const ApplicationInterface& application, Json& tables) {
  for (const NamedScalar& scalar : application_values(application)) {
    constexpr const char* kTypes[] = {"number", "boolean", "string"};  // of the alternatives of NamedScalar::value
    Json* properties = &tables;
    std::size_t begin = 0;
    for (std::size_t dot = scalar.name.find('.'); dot != std::string::npos; dot = scalar.name.find('.', begin)) {
      Json& object = (*properties)[scalar.name.substr(begin, dot - begin)];
      object["type"] = "object";
      properties = &object["properties"];
      begin = dot + 1;
    }
    (*properties)[scalar.name.substr(begin)] = {
        {"type", kTypes[scalar.value.index()]},
        {"description", scalar.description + (scalar.unit.empty() ? "" : " (" + scalar.unit + ")")}};
  }
}

/// Messages omit numbers that are not finite, such as "never", so no field is required.
Json world_schema(const ApplicationInterface& application) {
  Json tables = Json::object();
  for (const WorldField& field : world_fields()) {
    Json& table = tables[std::string(field.table)];
    table["type"] = "object";
    table["properties"][std::string(field.name)] = schema_of(field);
  }
  for (const WorldTable& table : world_tables()) {
    const auto found = tables.find(std::string(table.name));
    if (found != tables.end()) (*found)["description"] = table.description;
  }
  // Foxglove and Lichtblick drop a topic if an object of its schema has no properties.
  const auto table = [](const char* description) {
    return Json{{"type", "object"}, {"description", description}, {"properties", Json::object()}};
  };
  tables["input"] = table("values of the application; only if it declares some");
  tables["action"] = table("state of the application's actions");
  add_application(application, tables);
  return {{"type", "object"}, {"properties", std::move(tables)}, {"title", "reorient.World"}};
}

Json costs_schema() {
  Json schema = foxglove::schema("reorient.Costs");
  Json& stages = schema["properties"]["milliseconds"];
  for (int i = 0; i < kStageCount; ++i) {
    const std::string_view stage = to_string(static_cast<Stage>(i));
    stages["properties"][std::string(stage)]["type"] = "number";
    stages["required"].push_back(stage);
  }
  return schema;
}

}  // namespace

std::string schema_text(std::string_view schema, const ApplicationInterface& application) {
  // Descriptions of an application may contain any bytes.
  if (schema == "reorient.World") return world_schema(application).dump(-1, ' ', false, Json::error_handler_t::replace);
  if (schema == "reorient.Costs") return costs_schema().dump();
  return foxglove::schema(schema).dump();
}

std::string schema_text(std::string_view schema) { return schema_text(schema, {}); }

}  // namespace reorient
