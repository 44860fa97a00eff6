// SPDX-License-Identifier: MIT
// The fraction of typical mistakes in scripts that the check finds. docs/evidence/script-check.md has the table for a
// thousand mistakes.
#include "tests/workbench/script_tools/seeded_mistakes.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include "engine/core_parameters.h"
#include "engine/script/language/behavior_language.h"
#include "engine/script/script_host.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/check/script_check.h"

namespace reorient {
namespace {

/// A type of mistake, its number in a thousand mistakes, and the smallest fraction of them that the check must find.
struct Requirement {
  Mistake mistake;
  int of_thousand;
  double fraction;
};
constexpr Requirement kRequirements[] = {
    {Mistake::letter_in_a_name, 200, 0.95},  {Mistake::letter_in_a_text, 150, 0.95},
    {Mistake::argument_dropped, 150, 0.7},   {Mistake::argument_added, 100, 0.9},
    {Mistake::type_swapped, 150, 0.85},      {Mistake::state_renamed, 50, 0.95},
    {Mistake::brackets_forgotten, 50, 0.95}, {Mistake::brackets_added, 50, 0.95},
    {Mistake::colon_for_dot, 50, 0.95},      {Mistake::other_table, 50, 0.95},
};

/// REORIENT_SEEDED_MISTAKES in the environment sets their number, and prints all mistakes that were not found.
int requested_mistakes() {
  const char* const requested = std::getenv("REORIENT_SEEDED_MISTAKES");
  return requested != nullptr ? std::atoi(requested) : 200;
}

/// A copy of the shipped behaviors, libraries and scenarios, without the tests.
class SeededMistakes : public ::testing::Test {
 protected:
  SeededMistakes() {
    const std::filesystem::path shipped = std::filesystem::path(kSourceFolder) / "scripts";
    for (const char* folder : {"behaviors", "lib", "scenarios"})
      std::filesystem::copy(shipped / folder, folder_.path() / folder, std::filesystem::copy_options::recursive);
    texts_ = read_scripts(folder_.path());
    collect_names();
  }

  /// Collects the names that texts in scripts may contain.
  void collect_names() {
    BehaviorLanguage language;
    ParameterRegistry parameters;
    ScriptHost host(texts_, language, parameters);
    for (const std::string& file : texts_.in_folder("behaviors")) host.load(file);
    for (const MachineDefinition* machine : host.definitions()) {
      names_.push_back(machine->name);
      for (const StateDefinition& state : machine->states) names_.push_back(state.name);
    }
    for (const Parameter& parameter : parameters.list())
      names_.push_back(parameter.name.substr(parameter.name.find('.') + 1));
    for (const auto& module : host.module_fields()) names_.push_back(module.first);
    for (const WorldField& field : language.world())
      names_.insert(names_.end(), field.names.begin(), field.names.end());
    std::erase(names_, "");
  }

  bool is_found(const std::string& file, const std::string& text) const {
    folder_.write(file, text);
    const bool found = !check_scripts(folder_.path(), {}).findings.empty();
    folder_.write(file, texts_.find(file)->text);
    return found;
  }

  TemporaryFolder folder_;
  ScriptTexts texts_;
  std::vector<std::string> names_;
};

TEST_F(SeededMistakes, AreMostlyFound) {
  ASSERT_TRUE(check_scripts(folder_.path(), {}).findings.empty());
  std::vector<std::string> files = texts_.in_folder("behaviors");
  for (const char* folder : {"lib", "scenarios"}) {
    for (const std::string& file : texts_.in_folder(folder)) files.push_back(file);
  }
  const int requested = requested_mistakes();
  const bool prints_all = std::getenv("REORIENT_SEEDED_MISTAKES") != nullptr;
  for (const Requirement& required : kRequirements) {
    Random random(1, static_cast<std::uint64_t>(required.mistake));
    const int count = std::max(2, required.of_thousand * requested / 1000);
    int found = 0;
    for (int made = 0; made < count;) {
      const std::string& file = files[random.below(files.size())];
      const std::string& text = texts_.find(file)->text;
      const std::optional<SeededMistake> mistake = seed_mistake(required.mistake, text, names_, random);
      if (!mistake || mistake->text == text) continue;
      ++made;
      if (is_found(file, mistake->text)) {
        ++found;
      } else if (prints_all) {
        std::cout << "  " << file << ":" << mistake->line << ": '" << mistake->before << "' > '" << mistake->after
                  << "'\n";
      }
    }
    if (prints_all) std::cout << to_string(required.mistake) << ": " << found << " of " << count << "\n";
    // With few mistakes, the number of types that are not found is random, and each new script changes the sample.
    const double deviation = std::sqrt(count * required.fraction * (1.0 - required.fraction));
    EXPECT_GE(found, required.fraction * count - deviation - 1.0)
        << to_string(required.mistake) << ": " << found << " of " << count;
  }
}

}  // namespace
}  // namespace reorient
