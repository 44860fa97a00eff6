#include "workbench/files/field_file.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace reorient {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error("field file '" + file.string() + "': " + what);
}

}  // namespace

FieldDimensions load_field(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) fail(file, "there is no such file; assets/fields has examples");
  toml::table table;
  try {
    table = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    std::ostringstream text;
    text << "line " << error.source().begin.line << ": " << error.description();
    fail(file, text.str());
  }
  FieldDimensions field;
  std::vector<std::string> keys{"yellow_goals"};
  describe(field,
           [&](const char* key, double& /*length*/, double /*least*/, double /*most*/) { keys.emplace_back(key); });
  for (const auto& [key, value] : table) {
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
      fail(file, "'" + std::string(key.str()) + "' is not a key of a field; see assets/fields/README.md");
  }
  describe(field, [&](const char* key, double& length, double /*least*/, double /*most*/) {
    const toml::node* node = table.get(key);
    if (node == nullptr) fail(file, std::string("'") + key + "' is missing; add it, in metres");
    length = node->value<double>().value_or(std::numeric_limits<double>::quiet_NaN());
  });
  if (const std::string mistake = mistake_in(field); !mistake.empty()) fail(file, mistake);
  const std::optional<bool> yellow = table["yellow_goals"].value_exact<bool>();
  if (!yellow) fail(file, "'yellow_goals' must be true or false");
  field.yellow_goals = *yellow;
  return field;
}

}  // namespace reorient
