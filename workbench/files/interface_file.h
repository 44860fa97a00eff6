// SPDX-License-Identifier: MIT
// The interface of an application from a TOML file; the keys are documented in assets/interfaces/README.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robots/application.h"

namespace reorient {

/// Throws std::runtime_error with one line that names the file, the line, the key and the fix.
ApplicationInterface load_interface(const std::filesystem::path& file);

/// The shipped interfaces, and those in interfaces/ of the scripts' root. Throws as load_interface().
std::vector<ApplicationInterface> known_interfaces(const std::filesystem::path& scripts_root);

/// The values and actions of all of them, as far as their names do not conflict: for tools that load scripts without
/// knowing with which interface they will run.
ApplicationInterface merged(const std::vector<ApplicationInterface>& interfaces);

/// The same from the file's text; `name` is for messages. Its last part without an extension names the interface.
ApplicationInterface parse_interface(std::string_view text, const std::string& name);

}  // namespace reorient
