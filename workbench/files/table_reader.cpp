// SPDX-License-Identifier: MIT
#include "workbench/files/table_reader.h"

#include <optional>
#include <stdexcept>

#include "engine/parameters/counted.h"
#include "engine/parameters/nearest_name.h"
#include "engine/parameters/parameter.h"
#include "engine/parameters/utf8.h"
#include "workbench/files/toml_text.h"

namespace reorient {
namespace {

std::string nearest(const std::string& name, const TableReader::Readers& readers) {
  std::vector<std::string> names;
  for (const auto& [known, reader] : readers) names.push_back(known);
  return did_you_mean(name, names);
}

std::string number_text(double number) { return to_text(ParameterValue(number)); }

std::string shown(const toml::node& node, bool with_lists) {
  constexpr std::size_t kLongestText = 40, kLongestList = 6;
  if (const auto* whole = node.as_integer()) return std::to_string(whole->get());
  if (const auto* real = node.as_floating_point()) return number_text(real->get());
  if (const auto* yes = node.as_boolean()) return yes->get() ? "true" : "false";
  if (const auto* text = node.as_string()) return "'" + text->get().substr(0, kLongestText) + "'";
  if (node.is_table()) return "a table";
  const toml::array* const array = node.as_array();
  if (array == nullptr) return "a date or time";
  if (!with_lists || array->size() > kLongestList) return "a list of " + counted(array->size(), "value");
  std::string list;
  for (const toml::node& one : *array) list += (list.empty() ? "" : ", ") + shown(one, false);
  return "[" + list + "]";
}

}  // namespace

std::string found_text(const toml::node& node) { return ", found " + shown(node, true); }

std::string read_data_file(const std::filesystem::path& file, const std::string& kind, const std::string& folder) {
  try {
    return read_toml_text(file, "a file (" + kind + ")");
  } catch (const std::runtime_error& reason) {
    throw std::runtime_error(as_line(file.string() + ": " + reason.what() + "; examples in " + folder));
  }
}

toml::table parse_table(std::string_view text, const std::string& name) {
  if (const std::optional<TomlExcess> excess = excess_in_toml(text))
    throw std::runtime_error(as_line(name + ":" + std::to_string(excess->line) + ": " + excess->why));
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(
        as_line(name + ":" + std::to_string(error.source().begin.line) + ": " + std::string(error.description())));
  }
}

void TableReader::refuse(const toml::node& node, const std::string& why) const {
  throw std::runtime_error(as_line(file_ + ":" + std::to_string(node.source().begin.line) + ": " + why));
}

void TableReader::read(const Readers& readers) const {
  for (const auto& [key, value] : table_) {
    const std::string name(key.str());
    const auto reader = readers.find(name);
    if (reader == readers.end()) refuse(value, "unknown key '" + name + "'" + nearest(name, readers));
    reader->second(name, value);
  }
}

void TableReader::read_all(const Readers& readers, const Readers& optional) const {
  Readers all = readers;
  all.insert(optional.begin(), optional.end());
  read(all);
  for (const auto& [key, reader] : readers) {
    if (!table_.contains(key)) refuse(table_, "expected the key '" + key + "', found none");
  }
}

TableReader::Reader TableReader::into(double& number, double least, double most) const {
  return [this, &number, least, most](const std::string& key, const toml::node& value) {
    number = this->number(key, value, least, most);
  };
}

std::string TableReader::text(const std::string& key, const toml::node& node) const {
  const auto value = node.value_exact<std::string>();
  if (!value || value->empty()) refuse(node, key + ": expected a text in quotes" + found_text(node));
  return *value;
}

bool TableReader::yes(const std::string& key, const toml::node& node) const {
  const auto value = node.value_exact<bool>();
  if (!value) refuse(node, key + ": expected true or false" + found_text(node));
  return *value;
}

double TableReader::number(const std::string& key, const toml::node& node, double least, double most) const {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !(*value >= least && *value <= most))
    refuse(node,
           key + ": expected a number from " + number_text(least) + " to " + number_text(most) + found_text(node));
  return *value;
}

std::int64_t TableReader::whole(const std::string& key, const toml::node& node, std::int64_t least,
                                std::int64_t most) const {
  const auto value = node.value_exact<std::int64_t>();
  if (!value || *value < least || *value > most)
    refuse(node, key + ": expected a whole number from " + std::to_string(least) + " to " + std::to_string(most) +
                     found_text(node));
  return *value;
}

std::vector<std::string> TableReader::texts(const std::string& key, const toml::node& node) const {
  const toml::array* const array = node.as_array();
  if (array == nullptr) refuse(node, key + R"(: expected a list of texts, as ["one", "two"])" + found_text(node));
  std::vector<std::string> all;
  for (const toml::node& one : *array) all.push_back(text(key, one));
  return all;
}

std::vector<double> TableReader::numbers(const std::string& key, const toml::node& node, std::size_t count,
                                         double least, double most) const {
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->size() != count)
    refuse(node, key + ": expected a list of " + std::to_string(count) + " numbers" + found_text(node));
  std::vector<double> all;
  for (const toml::node& one : *array) all.push_back(number("each of " + key, one, least, most));
  return all;
}

const toml::table& TableReader::table(const std::string& key, const toml::node& node) const {
  if (const toml::table* const table = node.as_table()) return *table;
  refuse(node, key + ": expected a table [" + key + "]" + found_text(node));
}

const toml::array& TableReader::tables(const std::string& key, const toml::node& node) const {
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous(toml::node_type::table))
    refuse(node, key + ": expected one or more tables [[" + key + "]]" + found_text(node));
  return *array;
}

}  // namespace reorient
