// Where the project's scripts and data files are.
#pragma once

#include <filesystem>

namespace reorient {

/// The folder that holds scripts/ and assets/: $REORIENT_HOME, else the first one above the running program that is the
/// project's or an installation's, which has them in share/reorient. Throws std::runtime_error where there is none.
std::filesystem::path find_home();

}  // namespace reorient
