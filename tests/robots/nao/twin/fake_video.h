// SPDX-License-Identifier: MIT
// A simulated V4L2 camera: requires calls in the order of a real driver, and delivers the images of the test.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "robots/nao/camera/video_device.h"

namespace reorient::nao {

class FakeVideo : public VideoDevice {
 public:
  // Faults of the camera.
  bool is_plugged = true;
  bool knows_time = true;
  bool has_registers = true;
  int other_width = 0;         ///< width that it offers instead of the requested one
  int failing_request = 0;     ///< _IOC_NR of a call that fails
  std::uint32_t stubborn = 0;  ///< a control that refuses its value

  /// Exposes an image at `time` (s). Returns false if no buffer is free.
  bool expose(std::span<const std::uint8_t> yuyv, double time, bool damaged = false);

  bool streams() const { return streams_; }
  std::uint64_t shown() const { return shown_; }
  int opened() const { return opened_; }
  int mapped() const { return mapped_; }
  int value_of(std::uint32_t control) const;
  void drift(std::uint32_t control, int value) { controls_[control] = value; }  ///< like the camera's automatic control
  bool is_flipped() const { return flips_[0] && flips_[1]; }
  const std::map<int, int>& registers() const { return registers_; }
  void set_register(int address, int value) { registers_[address] = value; }

  bool open(const std::string& path) override;
  void close() override;
  bool is_open() const override { return is_open_; }
  int control(unsigned long request, void* argument) override;
  void* map(std::size_t length, std::int64_t offset) override;
  void unmap(void* address, std::size_t length) override;
  int descriptor() const override { return -1; }

 private:
  struct Taken {
    std::uint32_t index;
    std::uint32_t bytes;
    double time;
    bool damaged;
  };

  int extension(void* argument);

  bool is_open_ = false, streams_ = false;
  std::uint64_t shown_ = 0;  // images that were exposed
  int opened_ = 0, mapped_ = 0;
  int width_ = 0, height_ = 0;
  std::vector<std::vector<std::uint8_t>> buffers_;
  std::deque<std::uint32_t> queued_;
  std::deque<Taken> done_;
  std::map<std::uint32_t, int> controls_;
  bool flips_[2] = {false, false};
  std::map<int, int> registers_;
  int asked_register_ = -1;
};

}  // namespace reorient::nao
