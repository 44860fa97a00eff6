// SPDX-License-Identifier: MIT
#include "workbench/run/application_values.h"

#include <cstddef>

namespace reorient {
namespace {

void add_content(const DeclaredValue& declared, const ValueState& state, std::vector<NamedScalar>& all) {
  const std::string name = "input." + declared.name;
  if (declared.is_list()) {
    std::string text;
    for (std::uint32_t i = 0; i < state.records; ++i)
      text.append(text.empty() ? "{ " : ", { ").append(to_text(state.data, declared.fields, i)).append(" }");
    all.push_back({name, std::move(text), "", declared.description});
    return;
  }
  const DeclaredField& field = declared.fields.front();
  switch (field.type) {
    case FieldType::boolean:
      all.push_back({name, state.data.numbers.at(0) != 0.0, "", declared.description});
      return;
    case FieldType::text:
      all.push_back({name, state.data.texts.at(0), "", declared.description});
      return;
    case FieldType::number:
    case FieldType::integer:
      all.push_back({name, state.data.numbers.at(0), field.unit, declared.description});
      return;
    case FieldType::point:
    case FieldType::pose:
      for (std::size_t i = 0; i < numbers_of(field.type); ++i)
        all.push_back({std::string(name).append(".").append(kCoordinates[i]), state.data.numbers.at(i),
                       i < 2 ? "m" : "rad", declared.description});
      return;
  }
}

}  // namespace

std::vector<NamedScalar> application_values(const ApplicationRecord& application, double time) {
  std::vector<NamedScalar> all;
  const ApplicationInterface& declared = *application.declared;
  for (std::size_t i = 0; i < declared.values.size(); ++i) {
    const DeclaredValue& value = declared.values[i];
    const ValueState& state = application.values[i];
    add_content(value, state, all);
    all.push_back({"input.age." + value.name, time - state.set_at, "s", "time since input." + value.name + " was set"});
    all.push_back({"input.valid." + value.name, is_valid(state, value, time), "",
                   "whether input." + value.name + " fits its declaration and is not too old"});
  }
  for (std::size_t i = 0; i < declared.actions.size(); ++i) {
    const std::string name = "action." + declared.actions[i].name;
    const ActionStatus& status = application.actions[i];
    all.push_back({name + ".state", std::string(to_string(status.state)), "", declared.actions[i].description});
    all.push_back({name + ".reason", status.reason, "", "why the latest start failed"});
    all.push_back({name + ".time_in_state", time - status.since, "s", "time since the state changed"});
  }
  return all;
}

std::vector<NamedScalar> application_values(const ApplicationInterface& declared) {
  ApplicationRecord record;
  record.take(ApplicationState(declared));
  return application_values(record, 0.0);
}

}  // namespace reorient
