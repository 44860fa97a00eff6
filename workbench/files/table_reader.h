// SPDX-License-Identifier: MIT
// A TOML table whose keys are all known. Mistakes are thrown as std::runtime_error with one line: file, line, what was
// expected, what was found.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

namespace reorient {

/// The text of a data file. `kind`: type of its contents, for messages; `folder`: contains examples. Throws
/// std::runtime_error with one line.
std::string read_data_file(const std::filesystem::path& file, const std::string& kind, const std::string& folder);
/// `name`: for messages. Throws std::runtime_error with one line.
toml::table parse_table(std::string_view text, const std::string& name);

/// What a message shows of a value: ", found 7", ", found 'head'", ", found [1, 2]", ", found a table".
std::string found_text(const toml::node& node);

class TableReader {
 public:
  /// `file`: for messages.
  TableReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[noreturn]] void refuse(const toml::node& node, const std::string& why) const;

  /// The function that reads each key. A key without one is a mistake.
  using Reader = std::function<void(const std::string& key, const toml::node& value)>;
  using Readers = std::map<std::string, Reader>;
  void read(const Readers& readers) const;
  /// The same; the table must contain all keys of `readers`, and may contain those of `optional`.
  void read_all(const Readers& readers, const Readers& optional = {}) const;
  /// Reads a number into `number`.
  Reader into(double& number, double least, double most) const;

  // The value, if it has this type; otherwise they refuse it.
  std::string text(const std::string& key, const toml::node& node) const;  ///< not empty
  bool yes(const std::string& key, const toml::node& node) const;
  double number(const std::string& key, const toml::node& node, double least, double most) const;
  std::int64_t whole(const std::string& key, const toml::node& node, std::int64_t least, std::int64_t most) const;
  std::vector<std::string> texts(const std::string& key, const toml::node& node) const;
  std::vector<double> numbers(const std::string& key, const toml::node& node, std::size_t count, double least,
                              double most) const;
  const toml::table& table(const std::string& key, const toml::node& node) const;
  const toml::array& tables(const std::string& key, const toml::node& node) const;  ///< one or more

 private:
  const toml::table& table_;
  std::string file_;
};

}  // namespace reorient
