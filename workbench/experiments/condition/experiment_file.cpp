// SPDX-License-Identifier: MIT
#include "workbench/experiments/condition/experiment_file.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include <toml++/toml.h>

#include "engine/parameters/utf8.h"
#include "geometry/image.h"
#include "workbench/experiments/condition/reference_reader.h"
#include "workbench/files/parameter_file.h"
#include "workbench/files/table_reader.h"

namespace reorient {
namespace {

constexpr std::size_t kMostAxes = 8;
constexpr std::size_t kMostChoices = 1000;  // of one axis
constexpr int kMostTrials = 100'000;

class ExperimentReader {
 public:
  ExperimentReader(std::string file, const ConditionFiles& conditions)
      : file_(std::move(file)), conditions_(conditions) {}

  Experiment read(const toml::table& table) const {
    Experiment experiment;
    experiment.name = std::filesystem::path(file_).stem().string();
    const TableReader in(table, file_);
    in.read({
        {"title", [&](auto& key, auto& value) { experiment.title = in.text(key, value); }},
        {"description", [&](auto& key, auto& value) { experiment.description = in.text(key, value); }},
        {"trials",
         [&](auto& key, auto& value) { experiment.trials = static_cast<int>(in.whole(key, value, 1, kMostTrials)); }},
        {"times",
         [&](auto& key, auto& value) {
           const std::string of = in.text(key, value);
           if (of != "command" && of != "belief")
             in.refuse(value, "times: expected \"command\" or \"belief\", found \"" + of + "\"");
           experiment.times = of == "command" ? TimeOf::command : TimeOf::belief;
         }},
        {"condition", [&](auto& key, auto& value) { experiment.base = read_patch(in.table(key, value), {}); }},
        {"alternate",
         [&](auto& key, auto& value) {
           for (const toml::node& one : in.tables(key, value))
             experiment.alternates.push_back(read_patch(*one.as_table(), {}));
         }},
        {"measure", [&](auto& key, auto& value) { read_measures(in.table(key, value), experiment.measures); }},
        {"axis", [&](auto& key, auto& value) { read_axes(in, in.tables(key, value), experiment.axes); }},
        {"reference",
         [&](auto& key, auto& value) { experiment.references = read_references(in, in.tables(key, value), file_); }},
    });
    for (Reference& reference : experiment.references) {
      require_choices(in, table, reference, experiment.axes);
      sort_choices(reference, experiment.axes);
    }
    if (experiment.title.empty())
      in.refuse(table, "title: expected one sentence (the question of the experiment), found none");
    if (!names_scenario(experiment.base)) require_scenario(in, table, experiment.axes);
    return experiment;
  }

  /// A file that contains only a condition.
  ConditionPatch read_condition(const toml::table& table) const { return read_patch(table, {}); }

 private:
  static bool names_scenario(const ConditionPatch& patch) {
    return patch.scenario.has_value() || std::any_of(patch.first.begin(), patch.first.end(), names_scenario);
  }

  void require_scenario(const TableReader& in, const toml::table& table, const std::vector<Axis>& axes) const {
    const bool is_chosen = std::any_of(axes.begin(), axes.end(), [](const Axis& axis) {
      return std::all_of(axis.choices.begin(), axis.choices.end(),
                         [](const AxisChoice& choice) { return names_scenario(choice.patch); });
    });
    if (!is_chosen)
      in.refuse(table, "scenario: expected one, as in [condition] scenario = \"mirrored_placement\", found none");
  }

  static void require_choices(const TableReader& in, const toml::table& table, const Reference& reference,
                              const std::vector<Axis>& axes) {
    for (const std::pair<std::string, std::string>& wanted : reference.choices) {
      const auto has_it = [&wanted](const Axis& axis) {
        const auto is_it = [&wanted](const AxisChoice& choice) { return choice.name == wanted.second; };
        return axis.name == wanted.first && std::any_of(axis.choices.begin(), axis.choices.end(), is_it);
      };
      if (std::any_of(axes.begin(), axes.end(), has_it)) continue;
      std::string why = "the reference '" + reference.label;
      why.append("': unknown axis or choice '").append(wanted.first).append("' = '").append(wanted.second);
      in.refuse(table, why + "'");
    }
  }

  /// Restores the order of the axes, because a TOML table does not store the order of its keys.
  static void sort_choices(Reference& reference, const std::vector<Axis>& axes) {
    const auto place = [&axes](const std::string& name) {
      return std::find_if(axes.begin(), axes.end(), [&name](const Axis& axis) { return axis.name == name; });
    };
    std::sort(reference.choices.begin(), reference.choices.end(),
              [&place](const auto& a, const auto& b) { return place(a.first) < place(b.first); });
  }

  /// In the order of the types, and of the lists: a TOML table does not store the order of its keys.
  void read_measures(const toml::table& table, std::vector<Measure>& measures) const {
    const TableReader in(table, file_);
    TableReader::Readers readers;
    std::map<MeasureType, std::vector<Measure>> by_type;
    for (int i = 0; i < enum_count(MeasureType()); ++i) {
      const auto type = static_cast<MeasureType>(i);
      readers[std::string(to_string(type))] = [&, type](auto& key, auto& value) {
        const std::vector<std::string> names = in.texts(key, value);
        for (std::size_t at = 0; at < names.size(); ++at) {
          const toml::node& node = (*value.as_array())[at];
          const Measure measure{type, names[at], place_of(node)};
          if (const std::string mistake = mistake_in(measure); !mistake.empty())
            in.refuse(node, std::string("measure.").append(key).append(": ").append(mistake));
          std::vector<Measure>& list = by_type[type];
          const auto is_same = [&](const Measure& other) { return other.name == measure.name; };
          if (std::none_of(list.begin(), list.end(), is_same)) list.push_back(measure);
        }
      };
    }
    in.read(readers);
    for (const auto& [type, list] : by_type) measures.insert(measures.end(), list.begin(), list.end());
    if (measures.size() > kMostMeasures)
      in.refuse(table, "measure: expected at most " + std::to_string(kMostMeasures) + " names, found " +
                           std::to_string(measures.size()));
  }

  void read_axes(const TableReader& in, const toml::array& tables, std::vector<Axis>& axes) const {
    if (tables.size() > kMostAxes)
      in.refuse(tables,
                "expected at most " + std::to_string(kMostAxes) + " axes, found " + std::to_string(tables.size()));
    for (const toml::node& one : tables) {
      Axis axis;
      const TableReader table(*one.as_table(), file_);
      table.read({
          {"name", [&](auto& key, auto& value) { axis.name = table.text(key, value); }},
          {"description", [&](auto& key, auto& value) { axis.description = table.text(key, value); }},
          {"choice", [&](auto& key, auto& value) { read_choices(table, table.tables(key, value), axis.choices); }},
          {"usual", [&](auto& key, auto& value) { axis.usual = table.texts(key, value); }},
      });
      if (axis.name.empty()) table.refuse(one, "axis: expected a name, found none");
      if (axis.choices.empty())
        table.refuse(one, "axis " + axis.name + ": expected one or more [[axis.choice]], found none");
      for (const std::string& usual : axis.usual) {
        const auto is_it = [&](const AxisChoice& choice) { return choice.name == usual; };
        if (std::none_of(axis.choices.begin(), axis.choices.end(), is_it))
          table.refuse(one, "usual: unknown choice '" + usual + "' of the axis " + axis.name);
      }
      for (const Axis& other : axes) {
        if (other.name == axis.name)
          table.refuse(one, "axis: expected different names, found '" + axis.name + "' twice");
      }
      axes.push_back(std::move(axis));
    }
  }

  void read_choices(const TableReader& in, const toml::array& tables, std::vector<AxisChoice>& choices) const {
    if (tables.size() > kMostChoices)
      in.refuse(tables, "expected at most " + std::to_string(kMostChoices) + " choices, found " +
                            std::to_string(tables.size()));
    for (const toml::node& one : tables) {
      AxisChoice choice;
      choice.patch = read_patch(*one.as_table(), [&](const TableReader& table, auto& key, auto& value) {
        (key == "name" ? choice.name : choice.description) = table.text(key, value);
      });
      if (choice.name.empty()) in.refuse(one, "axis.choice: expected a name, found none");
      for (const AxisChoice& other : choices) {
        if (other.name == choice.name)
          in.refuse(one, "axis.choice: expected different names, found '" + choice.name + "' twice");
      }
      choices.push_back(std::move(choice));
    }
  }

  using NameReader = std::function<void(const TableReader&, const std::string& key, const toml::node& value)>;

  /// `name`: reads the keys "name" and "description"; empty: the keys are unknown.
  ConditionPatch read_patch(const toml::table& table, const NameReader& name) const {
    constexpr double kDay = 86'400.0;  // s
    ConditionPatch patch;
    const TableReader in(table, file_);
    const auto noted_text = [&](const std::string& key, const toml::node& value) {
      patch.said_at[key] = place_of(value);
      return in.text(key, value);
    };
    const auto noted_texts = [&](const std::string& key, const toml::node& value) {
      std::vector<std::string> texts = in.texts(key, value);
      for (std::size_t i = 0; i < texts.size(); ++i)
        patch.said_at[key + " " + texts[i]] = place_of((*value.as_array())[i]);
      return texts;
    };
    TableReader::Readers readers{
        {"scenario", [&](auto& key, auto& value) { patch.scenario = noted_text(key, value); }},
        {"with", [&](auto& key, auto& value) { patch.with = noted_texts(key, value); }},
        {"without", [&](auto& key, auto& value) { patch.without = noted_texts(key, value); }},
        {"params", [&](auto& key, auto& value) { patch.parameter_files = in.texts(key, value); }},
        {"parameters", [&](auto& key, auto& value) { patch.parameters = read_values(in, in.table(key, value)); }},
        {"room", [&](auto& key, auto& value) { patch.room = in.text(key, value); }},
        {"hall_seed", [&](auto& key, auto& value) { patch.hall_seed = in.whole(key, value, 0, kMostSeeds); }},
        {"field", [&](auto& key, auto& value) { patch.field = in.text(key, value); }},
        {"interface", [&](auto& key, auto& value) { patch.interface = in.text(key, value); }},
        {"body", [&](auto& key, auto& value) { patch.body = in.text(key, value); }},
        {"cameras",
         [&](auto& key, auto& value) {
           patch.cameras = in.text(key, value);
           if (*patch.cameras != "upper" && *patch.cameras != "both")
             in.refuse(value, "cameras: expected \"upper\" or \"both\", found \"" + *patch.cameras + "\"");
         }},
        {"width",
         [&](auto& key, auto& value) {
           patch.width = static_cast<int>(in.whole(key, value, 160, 640));
           if (std::find(kImageWidths.begin(), kImageWidths.end(), *patch.width) == kImageWidths.end())
             in.refuse(value, "width: expected 160, 320, 544 or 640 pixels" + found_text(value));
         }},
        {"room_awareness", [&](auto& key, auto& value) { patch.room_awareness = in.yes(key, value); }},
        {"seconds", [&](auto& key, auto& value) { patch.seconds = in.number(key, value, 1.0, kDay); }},
        {"learned_before", [&](auto& key, auto& value) { patch.learned_before = in.number(key, value, 0.0, kDay); }},
        {"compasses", [&](auto& key, auto& value) { patch.compasses = in.yes(key, value); }},
        {"pose_errors", [&](auto& key, auto& value) { patch.pose_errors = in.yes(key, value); }},
        {"measured_from", [&](auto& key, auto& value) { patch.measured_from = noted_text(key, value); }},
        {"limit", [&](auto& key, auto& value) { patch.limit = in.number(key, value, 0.0, kDay); }},
        {"hold", [&](auto& key, auto& value) { patch.hold = in.number(key, value, 0.0, kDay); }},
        {"to_the_end", [&](auto& key, auto& value) { patch.to_the_end = in.yes(key, value); }},
        {"symmetric_room", [&](auto& key, auto& value) { patch.symmetric_room = in.yes(key, value); }},
    };
    if (conditions_) {
      readers["conditions"] = [&](auto& key, auto& value) {
        for (const std::string& named : in.texts(key, value)) {
          try {
            patch.first.push_back(conditions_(named));
          } catch (const std::runtime_error& error) {
            in.refuse(value, error.what());
          }
        }
      };
    }
    if (name) {
      for (const char* const key : {"name", "description"})
        readers[key] = [&](auto& found, auto& value) { name(in, found, value); };
    }
    in.read(readers);
    return patch;
  }

  /// "orientation.lingering" = 0.3, or a table of tables as in a parameter file.
  std::vector<ParameterChange> read_values(const TableReader& in, const toml::table& table) const {
    std::vector<ParameterChange> changes;
    for (const auto& [module, values] : table) {
      const toml::table* const inner = values.as_table();
      if (inner == nullptr)
        in.refuse(values, "expected a parameter in the table of its module, as orientation.lingering = 0.3" +
                              found_text(values));
      for (const auto& [key, value] : *inner) {
        const std::string name = std::string(module.str()) + "." + std::string(key.str());
        const std::optional<std::string> text = value_text(value);
        if (!text) in.refuse(value, name + ": expected a number, true, false or a name in quotes" + found_text(value));
        changes.push_back({name, *text, ParameterOrigin::file, place_of(value)});
      }
    }
    return changes;
  }

  std::string place_of(const toml::node& node) const { return file_ + ":" + std::to_string(node.source().begin.line); }

  static std::optional<std::string> value_text(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return *text;
    if (const auto yes = node.value_exact<bool>()) return *yes ? "true" : "false";
    if (const auto whole = node.value_exact<std::int64_t>()) return std::to_string(*whole);
    if (const auto real = node.value_exact<double>(); real && std::isfinite(*real))
      return to_text(ParameterValue(*real));
    return std::nullopt;
  }

  static constexpr std::int64_t kMostSeeds = 1'000'000'000;

  std::string file_;
  const ConditionFiles& conditions_;
};

}  // namespace

Experiment parse_experiment(std::string_view text, const std::string& name, const ConditionFiles& conditions) {
  return ExperimentReader(name, conditions).read(parse_table(text, name));
}

Experiment read_experiment(const std::filesystem::path& file, const ConditionFiles& conditions) {
  return parse_experiment(read_data_file(file, "experiment", "assets/experiments"), file.string(), conditions);
}

ConditionPatch parse_condition(std::string_view text, const std::string& name) {
  const ConditionFiles none;
  return ExperimentReader(name, none).read_condition(parse_table(text, name));
}

ConditionPatch read_condition(const std::filesystem::path& file) {
  return parse_condition(read_data_file(file, "condition", "assets/conditions"), file.string());
}

}  // namespace reorient
