// SPDX-License-Identifier: MIT
#include "program/run/missing_interface.h"

#include <stdexcept>
#include <vector>

#include <spdlog/spdlog.h>

#include "engine/parameters/utf8.h"
#include "program/script_names.h"
#include "workbench/files/interface_file.h"
#include "workbench/script_tools/check/missing_values.h"

namespace reorient {

void warn_of_missing_values(const std::filesystem::path& scripts_root, const ScriptTexts& scripts,
                            const std::set<std::string>& files, const ApplicationInterface& declared) try {
  const std::vector<ApplicationInterface> known = known_interfaces(scripts_root);
  for (const std::string& file : with_required(scripts, files)) {
    const ScriptText* const script = scripts.find(file);
    if (script == nullptr) continue;
    const std::vector<MissingValue> missing = missing_values(script->text, declared, known);
    if (missing.empty()) continue;
    spdlog::warn("{}:{}: {}: --interface {}", as_line(file), missing.front().position.line, to_text(missing),
                 missing.front().interfaces.front());
  }
} catch (const std::runtime_error& error) {  // of an interface that this run does not use
  spdlog::warn("{}", as_line(error.what()));
}

}  // namespace reorient
