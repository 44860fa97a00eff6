// SPDX-License-Identifier: MIT
// Arbitrary bytes as a parameter file: refused with one line that names the file, or read into changes that a registry
// accepts or refuses. Saving and reading the parameters returns the same values.
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/parameters/parameter_registry.h"
#include "tests/fuzz/promises.h"
#include "workbench/files/parameter_file.h"

namespace reorient {
namespace {

enum class Animal { ant, bee };

/// One parameter of each type.
struct Tuned {
  double lead = 0.3;
  double tiny = 0.0;
  int particles = 50;
  bool ball = true;
  Animal animal = Animal::ant;
};

template <typename Visit>
void describe(Tuned& tuned, Visit&& visit) {
  visit("lead", tuned.lead, 0.0, 1.0, "m", "how far");
  visit("tiny", tuned.tiny, -1e300, 1e300, "", "any number");
  visit("particles", tuned.particles, 10, 10000, "", "how many");
  visit("ball", tuned.ball, "whether");
  visit("animal", tuned.animal, {"ant", "bee"}, "which");
}

std::map<std::string, std::string> values_of(const ParameterRegistry& registry) {
  std::map<std::string, std::string> values;
  for (const Parameter& parameter : registry.list()) values[parameter.name] = to_text(parameter.value);
  return values;
}

/// Throws std::runtime_error if a change is refused.
void take(const std::vector<ParameterChange>& changes, ParameterRegistry& registry) {
  for (const ParameterChange& change : changes) {
    require(change.source.starts_with("team.toml:"), "a change contains the place where it is written");
    require(change.origin == ParameterOrigin::file, "the origin of a change is the file");
    registry.set_early(change);
  }
}

void try_file(std::string_view text) {
  const Haste haste(2.0);
  ParameterRegistry registry;
  Tuned tuned;
  registry.bind("tuned", tuned);
  try {
    take(parse_parameters(text, "team.toml"), registry);
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("team.toml:"), "a refusal names the file");
    return;
  }
  ParameterRegistry again;
  Tuned tuned_again;
  again.bind("tuned", tuned_again);
  take(parse_parameters(parameter_text(registry.list(), {}), "team.toml"), again);
  require(values_of(registry) == values_of(again), "saved values are read back");
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_file({reinterpret_cast<const char*>(data), size});
  return 0;
}
