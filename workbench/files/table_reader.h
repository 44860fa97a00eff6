// SPDX-License-Identifier: MIT
// A TOML table whose keys are all known. What is wrong with it is thrown as std::runtime_error with one line: file,
// line, why.
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

/// The text of a data file. `kind`: what it is; `folder`: with examples. Throws std::runtime_error with one
/// line.
std::string read_data_file(const std::filesystem::path& file, const std::string& kind, const std::string& folder);
/// `name`: for messages. Throws std::runtime_error with one line.
toml::table parse_table(std::string_view text, const std::string& name);

class TableReader {
 public:
  /// `file`: for messages.
  TableReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[noreturn]] void refuse(const toml::node& node, const std::string& why) const;

  /// Each key with what reads it. Whatever else stands in the table is a mistake.
  using Reader = std::function<void(const std::string& key, const toml::node& value)>;
  using Readers = std::map<std::string, Reader>;
  void read(const Readers& readers) const;
  /// The same, and each of the keys has to be there; those of `optional` may be.
  void read_all(const Readers& readers, const Readers& optional = {}) const;
  /// Reads a number into `number`.
  Reader into(double& number, double least, double most) const;

  // A value of a kind, or a mistake.
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
