// SPDX-License-Identifier: MIT
// Arbitrary bytes as an interface file: refused with one line that names the file, or read as declarations that a
// state of the engine can be made of.
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "engine/world/application_state.h"
#include "tests/fuzz/promises.h"
#include "workbench/files/interface_file.h"
#include "workbench/run/application_values.h"

namespace reorient {
namespace {

void try_file(std::string_view text) {
  const Haste haste(5.0);
  ApplicationInterface declared;
  try {
    declared = parse_interface(text, "interface.toml");
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("interface.toml:"), "a refusal names the file");
    return;
  }
  require(mistake_in(declared).empty(), "declarations that are read are valid");
  const ApplicationState state(declared);
  require(application_values(declared).size() >= declared.values.size(), "each value has a name");
  require(merged({declared, declared}).values.size() == declared.values.size(), "the same declarations merge");
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_file({reinterpret_cast<const char*>(data), size});
  return 0;
}
