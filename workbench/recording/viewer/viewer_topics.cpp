#include "workbench/recording/viewer/viewer_topics.h"

#include <map>

#include "engine/record/frame_record.h"
#include "engine/script/language/world_fields.h"
#include "workbench/recording/viewer/foxglove.h"

namespace reorient {
namespace {

using foxglove::Json;

Json described(Json schema, std::string_view description) {
  schema["description"] = description;
  return schema;
}

Json schema_of(const WorldField& field) {
  Json schema{{"type", field.type_name()}};
  schema["description"] =
      std::string(field.description) + (field.unit.empty() ? "" : " (" + std::string(field.unit) + ")");
  return schema;
}

/// Numbers that are none, as "never", are left out of a message: so nothing of it is required.
Json world_schema() {
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
  return {{"type", "object"}, {"properties", std::move(tables)}};
}

Json machines_schema() {
  return foxglove::object_schema({
      {"machines", foxglove::array_schema(foxglove::object_schema({
                       {"name", foxglove::string_schema()},
                       {"state", described(foxglove::string_schema(), "path, as watching/in doubt")},
                       {"seconds", described(foxglove::number_schema(), "for which it has been in it")},
                       {"stopped", described(foxglove::boolean_schema(), "after too many errors")},
                       {"errors", foxglove::integer_schema()},
                   }))},
      {"published", foxglove::array_schema(foxglove::string_schema())},
  });
}

Json event_schema() {
  return foxglove::object_schema({
      {"machine", foxglove::string_schema()},
      {"state", described(foxglove::string_schema(), "of a change: from > to")},
      {"command", described(foxglove::string_schema(), "empty: a change of state")},
      {"verdict", foxglove::string_schema()},
      {"reason", foxglove::string_schema()},
  });
}

Json request_schema() {
  const auto numbers = [](std::initializer_list<const char*> names) {
    Json properties = Json::object();
    for (const char* const name : names) properties[name] = foxglove::number_schema();
    return Json{{"type", "object"}, {"properties", std::move(properties)}};
  };
  return foxglove::object_schema({
      {"walk", described(numbers({"forward", "left", "turn"}), "m/s, m/s, rad/s")},
      {"head", described(numbers({"yaw", "pitch", "speed"}), "rad, rad, rad/s; empty: it stays")},
      {"get_up", foxglove::boolean_schema()},
      {"command", described(foxglove::string_schema(), "to whoever holds the belief; empty: none")},
  });
}

Json costs_schema() {
  std::vector<std::pair<std::string, Json>> stages;
  stages.reserve(kStageCount);
  for (int i = 0; i < kStageCount; ++i)
    stages.emplace_back(to_string(static_cast<Stage>(i)), foxglove::number_schema());
  return foxglove::object_schema({
      {"milliseconds", described(foxglove::object_schema(stages), "of each stage")},
      {"frame_milliseconds", foxglove::number_schema()},
      {"machines", foxglove::array_schema(foxglove::object_schema({
                       {"name", foxglove::string_schema()},
                       {"microseconds", foxglove::number_schema()},
                       {"instructions", foxglove::integer_schema()},
                       {"memory", described(foxglove::integer_schema(), "bytes")},
                   }))},
  });
}

Json parameters_schema() {
  return foxglove::object_schema({{"parameters", foxglove::array_schema(foxglove::object_schema({
                                                     {"name", foxglove::string_schema()},
                                                     {"value", described(foxglove::string_schema(), "as one types it")},
                                                     {"unit", foxglove::string_schema()},
                                                 }))}});
}

}  // namespace

std::string schema_text(std::string_view schema) {
  static const std::map<std::string_view, Json (*)()> kOwn{
      {"reorient.World", world_schema}, {"reorient.Machines", machines_schema},
      {"reorient.Event", event_schema}, {"reorient.Request", request_schema},
      {"reorient.Costs", costs_schema}, {"reorient.Parameters", parameters_schema},
  };
  const auto own = kOwn.find(schema);
  if (own == kOwn.end()) return foxglove::schema(schema).dump();
  Json json = own->second();
  json["title"] = schema;
  return json.dump();
}

}  // namespace reorient
