#include "workbench/files/field_file.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "engine/parameters/utf8.h"
#include "workbench/files/toml_text.h"

namespace reorient {
namespace {

[[noreturn]] void refuse_field(const std::string& name, const std::string& what) {
  throw std::runtime_error(as_line("field file '" + name + "': " + what));
}

toml::table parse(std::string_view text, const std::string& name) {
  if (const std::optional<TomlExcess> excess = excess_in_toml(text))
    refuse_field(name, "line " + std::to_string(excess->line) + ": " + excess->why);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    std::ostringstream what;
    what << "line " << error.source().begin.line << ": " << error.description();
    refuse_field(name, what.str());
  }
}

}  // namespace

FieldDimensions load_field(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    refuse_field(file.string(), "there is no such file; assets/fields has examples");
  const std::optional<std::string> text = read_toml_text(file);
  if (!text) refuse_field(file.string(), "it cannot be read; check its permissions");
  return parse_field(*text, file.string());
}

FieldDimensions parse_field(std::string_view text, const std::string& name) {
  const toml::table table = parse(text, name);
  FieldDimensions field;
  std::vector<std::string> keys{"yellow_goals"};
  describe(field,
           [&](const char* key, double& /*length*/, double /*least*/, double /*most*/) { keys.emplace_back(key); });
  for (const auto& [key, value] : table) {
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end())
      refuse_field(
          name, "'" + std::string(key.str().substr(0, 60)) + "' is not a key of a field; see assets/fields/README.md");
  }
  describe(field, [&](const char* key, double& length, double /*least*/, double /*most*/) {
    const toml::node* node = table.get(key);
    if (node == nullptr) refuse_field(name, std::string("'") + key + "' is missing; add it, in metres");
    length = node->value<double>().value_or(std::numeric_limits<double>::quiet_NaN());
  });
  if (const std::string mistake = mistake_in(field); !mistake.empty()) refuse_field(name, mistake);
  const std::optional<bool> yellow = table["yellow_goals"].value_exact<bool>();
  if (!yellow) refuse_field(name, "'yellow_goals' must be true or false");
  field.yellow_goals = *yellow;
  return field;
}

}  // namespace reorient
