// SPDX-License-Identifier: MIT
#include "workbench/files/interface_file.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "workbench/files/home.h"
#include "workbench/files/table_reader.h"

namespace reorient {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kLargestNumber = std::numeric_limits<double>::max();

using Reader = TableReader::Reader;
using Readers = TableReader::Readers;

/// Where each key of a file's tables goes, for one file.
class InterfaceReader {
 public:
  explicit InterfaceReader(std::string file) : file_(std::move(file)) {}

  ApplicationInterface read(const toml::table& table) const {
    ApplicationInterface declared;
    declared.name = std::filesystem::path(file_).stem().string();
    const TableReader in(table, file_);
    in.read({{"values", [&](auto& key, auto& node) { read_values(in.table(key, node), "", declared.values); }},
             {"actions", [&](auto& key, auto& node) {
                for (const auto& [name, action] : in.table(key, node))
                  declared.actions.push_back(read_action(std::string(name.str()), in.table(key, action)));
              }}});
    if (const std::string mistake = mistake_in(declared); !mistake.empty()) in.refuse(table, mistake);
    return declared;
  }

 private:
  /// A table with a type is a value, another one the group of its values.
  void read_values(const toml::table& table, const std::string& group, std::vector<DeclaredValue>& values) const {
    const TableReader in(table, file_);
    for (const auto& [key, node] : table) {
      const std::string name = group + std::string(key.str());
      const toml::table& one = in.table("values." + name, node);
      if (one.contains("type")) {
        values.push_back(read_value(name, one));
      } else if (group.empty()) {
        read_values(one, name + ".", values);
      } else {
        in.refuse(node, "values." + name + ": expected the key 'type'");
      }
    }
  }

  DeclaredValue read_value(const std::string& name, const toml::table& table) const {
    DeclaredValue value;
    value.name = name;
    const TableReader in(table, file_);
    Readers readers{{"description", text_into(in, value.description)}};
    Readers optional{{"lasts", in.into(value.lasts, 0.0, kLargestNumber)}};
    if (table["type"].value_exact<std::string>() == "list") {
      readers["type"] = [](auto&, auto&) {};
      readers["most"] = [&](auto& key, auto& node) {
        value.most = static_cast<std::uint32_t>(in.whole(key, node, 1, kMostRecords));
      };
      readers["record"] = [&](auto& key, auto& node) { value.fields = read_fields(in.table(key, node), key, false); };
      in.read_all(readers, optional);
      return value;
    }
    DeclaredField field;
    add_field_keys(in, field, readers, optional);
    in.read_all(readers, optional);
    complete(in, table, field, false);
    field.description = value.description;
    value.fields.push_back(std::move(field));
    return value;
  }

  DeclaredAction read_action(const std::string& name, const toml::table& table) const {
    DeclaredAction action;
    action.name = name;
    const TableReader in(table, file_);
    in.read_all({{"description", text_into(in, action.description)}},
                {{"takes", in.into(action.takes, 0.0, 3600.0)},
                 {"reports", [&](auto& key, auto& node) { action.reports = in.yes(key, node); }},
                 {"parts", [&](auto& key, auto& node) { action.parts = in.texts(key, node); }},
                 {"arguments",
                  [&](auto& key, auto& node) { action.arguments = read_fields(in.table(key, node), key, true); }}});
    return action;
  }

  /// `are_arguments`: a field without a default is required.
  std::vector<DeclaredField> read_fields(const toml::table& table, const std::string& of, bool are_arguments) const {
    std::vector<DeclaredField> fields;
    const TableReader outer(table, file_);
    for (const auto& [key, node] : table) {
      DeclaredField& field = fields.emplace_back();
      field.name = std::string(key.str());
      const toml::table& one = outer.table(of + "." + field.name, node);
      const TableReader in(one, file_);
      Readers readers{{"description", text_into(in, field.description)}}, optional;
      add_field_keys(in, field, readers, optional);
      in.read_all(readers, optional);
      complete(in, one, field, are_arguments);
    }
    return fields;
  }

  static Reader text_into(const TableReader& in, std::string& text) {
    return [&in, &text](auto& key, auto& node) { text = in.text(key, node); };
  }

  static void add_field_keys(const TableReader& in, DeclaredField& field, Readers& readers, Readers& optional) {
    readers["type"] = [&](auto& key, auto& node) {
      const std::string name = in.text(key, node);
      for (int i = 0; i < enum_count(FieldType()); ++i) {
        field.type = static_cast<FieldType>(i);
        if (to_string(field.type) == name) return;
      }
      in.refuse(node, "type: expected number, integer, boolean, text, point, pose or list, found '" + name + "'");
    };
    optional["unit"] = text_into(in, field.unit);
    optional["range"] = [&](auto& key, auto& node) {
      const std::vector<double> range = in.numbers(key, node, 2, -kUnbounded, kUnbounded);
      field.minimum = range[0];
      field.maximum = range[1];
    };
    optional["choices"] = [&](auto& key, auto& node) { field.choices = in.texts(key, node); };
    optional["default"] = [](auto&, auto&) {};  // read last, because it depends on the type
  }

  /// The default is the written one, else the number of the range that is nearest to 0, false, or the first choice.
  static void complete(const TableReader& in, const toml::table& table, DeclaredField& field, bool is_argument) {
    const toml::node* const node = table.get("default");
    if (node == nullptr) {
      field.is_required = is_argument;
      field.initial.numbers.assign(numbers_of(field.type), std::min(std::max(0.0, field.minimum), field.maximum));
      if (field.type == FieldType::text) field.initial.texts = {field.choices.empty() ? "" : field.choices.front()};
      return;
    }
    switch (field.type) {
      case FieldType::boolean:
        field.initial.numbers = {in.yes("default", *node) ? 1.0 : 0.0};
        return;
      case FieldType::text: {
        const auto text = node->value_exact<std::string>();
        if (!text) in.refuse(*node, "default: expected a text in quotes" + found_text(*node));
        field.initial.texts = {*text};
        return;
      }
      case FieldType::number:
      case FieldType::integer:
        field.initial.numbers = {in.number("default", *node, -kLargestNumber, kLargestNumber)};
        return;
      case FieldType::point:
      case FieldType::pose:
        field.initial.numbers = in.numbers("default", *node, numbers_of(field.type), -kLargestNumber, kLargestNumber);
        return;
    }
  }

  std::string file_;
};

}  // namespace

ApplicationInterface load_interface(const std::filesystem::path& file) {
  return parse_interface(read_data_file(file, "interface of an application", "assets/interfaces"), file.string());
}

std::vector<ApplicationInterface> known_interfaces(const std::filesystem::path& scripts_root) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& folder : {find_home() / "assets/interfaces", scripts_root / "interfaces"}) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<ApplicationInterface> all;
  all.reserve(files.size());
  for (const std::filesystem::path& file : files) all.push_back(load_interface(file));
  return all;
}

ApplicationInterface merged(const std::vector<ApplicationInterface>& interfaces) {
  ApplicationInterface all;
  const auto add = [&all](auto& list, const auto& one) {
    list.push_back(one);
    if (!mistake_in(all).empty()) list.pop_back();
  };
  for (const ApplicationInterface& interface : interfaces) {
    for (const DeclaredValue& value : interface.values) add(all.values, value);
    for (const DeclaredAction& action : interface.actions) add(all.actions, action);
  }
  return all;
}

ApplicationInterface parse_interface(std::string_view text, const std::string& name) {
  return InterfaceReader(name).read(parse_table(text, name));
}

}  // namespace reorient
