// SPDX-License-Identifier: MIT
// The doors to a video device of Linux, so that a test can stand behind them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace reorient::nao {

/// Each call does what the system's of the same name does. Images are taken and given back at once; all else asks the
/// camera over its USB, which takes seconds where that hangs.
class VideoDevice {
 public:
  virtual ~VideoDevice() = default;

  /// False: there is no such device now.
  virtual bool open(const std::string& path) = 0;
  virtual void close() = 0;
  virtual bool is_open() const = 0;

  /// 0, or the error's number: EAGAIN where nothing has come yet.
  virtual int control(unsigned long request, void* argument) = 0;
  /// nullptr: it cannot be mapped.
  virtual void* map(std::size_t length, std::int64_t offset) = 0;
  virtual void unmap(void* address, std::size_t length) = 0;

  /// What poll() takes; -1: there is nothing to wait for.
  virtual int descriptor() const = 0;
};

/// The system's own.
class SystemVideoDevice : public VideoDevice {
 public:
  ~SystemVideoDevice() override;
  bool open(const std::string& path) override;
  void close() override;
  bool is_open() const override { return descriptor_ >= 0; }
  int control(unsigned long request, void* argument) override;
  void* map(std::size_t length, std::int64_t offset) override;
  void unmap(void* address, std::size_t length) override;
  int descriptor() const override { return descriptor_; }

 private:
  int descriptor_ = -1;
};

}  // namespace reorient::nao
