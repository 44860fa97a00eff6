// SPDX-License-Identifier: MIT
#include "program/model/model_file.h"

#include <span>
#include <string>

#include "workbench/files/atomic_file.h"
#include "workbench/files/input_file.h"

namespace reorient {

SavedModel read_model_file(const std::filesystem::path& file) {
  const std::string bytes = read_input(file, "a model of a room", kLongestModel);
  return read_model(std::as_bytes(std::span(bytes)));
}

void write_model_file(const SavedModel& model, const std::filesystem::path& file) {
  std::vector<std::byte> bytes;
  write_model(model, bytes);
  write_whole_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace reorient
