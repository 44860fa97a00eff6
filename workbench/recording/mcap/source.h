// SPDX-License-Identifier: MIT
// The source from which MCAP files are read, and the exception for a damaged file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace reorient::mcap {

/// A file is damaged at some position.
struct Damage : std::runtime_error {
  /// `place`: position of the record in bytes.
  Damage(std::uint64_t place, const std::string& what);
  std::uint64_t where;
};

/// Bytes that can be read at any position.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t size() const = 0;
  /// Fills all of `bytes`, which must be within the size. Throws std::runtime_error with one line.
  virtual void read(std::uint64_t from, std::span<std::byte> bytes) const = 0;
};

class FileSource : public Source {
 public:
  /// Throws std::runtime_error with one line.
  explicit FileSource(const std::filesystem::path& file);
  ~FileSource() override;
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  std::uint64_t size() const override { return size_; }
  void read(std::uint64_t from, std::span<std::byte> bytes) const override;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

/// The exception of a read that was stopped.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

/// A file whose reads throw Stopped once `stop` returns true, so that no reader of a long file needs to ask.
class StoppableSource : public FileSource {
 public:
  /// Throws std::runtime_error with one line.
  StoppableSource(const std::filesystem::path& file, std::function<bool()> stop)
      : FileSource(file), stop_(std::move(stop)) {}

  void read(std::uint64_t from, std::span<std::byte> bytes) const override {
    if (stop_ && stop_()) throw Stopped();
    FileSource::read(from, bytes);
  }

 private:
  std::function<bool()> stop_;
};

class MemorySource : public Source {
 public:
  explicit MemorySource(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_.size(); }
  void read(std::uint64_t from, std::span<std::byte> bytes) const override;

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace reorient::mcap
