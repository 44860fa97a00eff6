// SPDX-License-Identifier: MIT
#include "program/model/model_file.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "geometry/bytes.h"
#include "workbench/files/atomic_file.h"

namespace reorient {

SavedModel read_model_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) throw std::runtime_error("expected a file, found none");
  if (!std::filesystem::exists(status)) throw std::runtime_error(error.message());
  if (std::filesystem::is_directory(status)) throw std::runtime_error("expected a file, found a folder");
  if (!std::filesystem::is_regular_file(status))
    throw std::runtime_error("expected a plain file, found another type of file");
  // Do not read a large file such as a video to find that it is not a model.
  if (std::filesystem::file_size(file, error) > kLongestModel)
    throw std::runtime_error("expected a model of a room, found a larger file");
  const std::optional<std::string> bytes = read_whole_file(file);
  if (!bytes) throw std::runtime_error("expected a readable file; check its permissions");
  return read_model(std::as_bytes(std::span(*bytes)));
}

void write_model_file(const SavedModel& model, const std::filesystem::path& file) {
  std::vector<std::byte> bytes;
  write_model(model, bytes);
  write_whole_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace reorient
