#include "workbench/files/atomic_file.h"

#include <cerrno>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace reorient {
namespace {

std::string last_error() {
  const int code = errno;
  return code == 0 ? "the file system refused" : std::generic_category().message(code);
}

/// Whether a file of this name could be made now. Leaves none behind.
bool can_write(const std::filesystem::path& probe) {
  const bool writable = std::ofstream(probe).put('x').flush().good();
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
  return writable;
}

std::filesystem::path beside(const std::filesystem::path& file) {
  std::filesystem::path partial = file;
  partial += ".partial";
  return partial;
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
  const std::filesystem::path partial = beside(file);
  errno = 0;
  std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  std::string failure = stream ? "" : last_error();
  if (failure.empty()) {
    std::error_code error;
    std::filesystem::rename(partial, file, error);
    if (!error) return;
    failure = error.message();
  }
  std::error_code ignored;
  std::filesystem::remove(partial, ignored);
  throw std::runtime_error("cannot write '" + file.string() + "': " + failure);
}

std::optional<std::string> read_whole_file(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) return std::nullopt;
  return std::move(text).str();
}

void require_writable_file(const std::filesystem::path& file, std::string_view option) {
  std::error_code failed;
  if (!std::filesystem::is_directory(file, failed) && can_write(beside(file))) return;
  throw std::runtime_error("cannot write '" + file.string() + "'; name another file with " + std::string(option));
}

void require_writable_folder(const std::filesystem::path& folder, std::string_view option) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!failed && can_write(folder / ".reorient-probe")) return;
  throw std::runtime_error("cannot write into '" + folder.string() + "'; name another folder with " +
                           std::string(option));
}

}  // namespace reorient
