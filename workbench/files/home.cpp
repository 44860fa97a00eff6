#include "workbench/files/home.h"

#include <cstdlib>
#include <stdexcept>

namespace reorient {
namespace {

bool is_home(const std::filesystem::path& folder) {
  return std::filesystem::is_directory(folder / "scripts" / "behaviors") &&
         std::filesystem::is_directory(folder / "assets");
}

}  // namespace

std::filesystem::path find_home() {
  if (const char* told = std::getenv("REORIENT_HOME")) {
    if (is_home(told)) return told;
    throw std::runtime_error("REORIENT_HOME is '" + std::string(told) +
                             "', where there is no scripts/behaviors and assets/; let it name the project's folder");
  }
  std::error_code no_link;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", no_link).parent_path();
  while (true) {
    for (const std::filesystem::path& home : {folder, folder / "share" / "reorient"}) {
      if (is_home(home)) return home;
    }
    if (folder == folder.parent_path()) {
      throw std::runtime_error(
          "no folder above this program has scripts/behaviors and assets/; name it with REORIENT_HOME=FOLDER");
    }
    folder = folder.parent_path();
  }
}

}  // namespace reorient
