// SPDX-License-Identifier: MIT
// Access to a Linux video device, replaced by tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace reorient::nao {

/// Each function calls the system function of the same name. Taking and returning images is fast. Other calls
/// communicate with the camera over USB, which takes seconds if the camera hangs.
class VideoDevice {
 public:
  virtual ~VideoDevice() = default;

  /// Returns false if the device does not exist.
  virtual bool open(const std::string& path) = 0;
  virtual void close() = 0;
  virtual bool is_open() const = 0;

  /// Returns 0 or an error number; EAGAIN if no image has arrived yet.
  virtual int control(unsigned long request, void* argument) = 0;
  /// Returns nullptr if the memory cannot be mapped.
  virtual void* map(std::size_t length, std::int64_t offset) = 0;
  virtual void unmap(void* address, std::size_t length) = 0;

  /// Descriptor for poll(), or -1 if the device is closed.
  virtual int descriptor() const = 0;
};

/// The device of the system.
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
