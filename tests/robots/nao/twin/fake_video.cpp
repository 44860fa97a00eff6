// SPDX-License-Identifier: MIT
#include "tests/robots/nao/twin/fake_video.h"

#include <algorithm>
#include <cerrno>
#include <cmath>

#include <linux/usb/video.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>

namespace reorient::nao {

bool FakeVideo::open(const std::string& /*path*/) {
  close();
  if (!is_plugged) return false;
  is_open_ = true;
  ++opened_;
  controls_ = {{V4L2_CID_FOCUS_AUTO, 1},         {V4L2_CID_FOCUS_ABSOLUTE, 10}, {V4L2_CID_EXPOSURE_AUTO, 1},
               {V4L2_CID_AUTO_WHITE_BALANCE, 0}, {V4L2_CID_HUE_AUTO, 1},        {V4L2_CID_HUE, 5},
               {V4L2_CID_BRIGHTNESS, 7},         {V4L2_CID_CONTRAST, 1},        {V4L2_CID_SATURATION, 1},
               {V4L2_CID_SHARPNESS, 0},          {V4L2_CID_GAIN, 30},           {V4L2_CID_EXPOSURE_ABSOLUTE, 500}};
  return true;
}

void FakeVideo::close() {
  is_open_ = streams_ = false;
  queued_.clear();
  done_.clear();
  flips_[0] = flips_[1] = false;
}

int FakeVideo::value_of(std::uint32_t control) const {
  const auto found = controls_.find(control);
  return found == controls_.end() ? -1 : found->second;
}

bool FakeVideo::expose(std::span<const std::uint8_t> yuyv, double time, bool damaged) {
  if (!streams_ || !is_plugged || queued_.empty()) return false;
  const std::uint32_t index = queued_.front();
  queued_.pop_front();
  const std::size_t size = std::min(yuyv.size(), buffers_[index].size());
  std::copy_n(yuyv.begin(), size, buffers_[index].begin());
  ++shown_;
  done_.push_back({index, static_cast<std::uint32_t>(size), time, damaged});
  return true;
}

void* FakeVideo::map(std::size_t length, std::int64_t offset) {
  const auto index = static_cast<std::size_t>(offset);
  if (index >= buffers_.size() || length > buffers_[index].size()) return nullptr;
  ++mapped_;
  return buffers_[index].data();
}

void FakeVideo::unmap(void* /*address*/, std::size_t /*length*/) { --mapped_; }

int FakeVideo::extension(void* argument) {
  auto& query = *static_cast<uvc_xu_control_query*>(argument);
  if (query.unit != 3) return ENOENT;
  if ((query.selector == 0x0c || query.selector == 0x0d) && query.size == 2 && query.query == UVC_SET_CUR) {
    flips_[query.selector - 0x0c] = query.data[0] == 1;
    return 0;
  }
  if (query.selector != 0x0e || query.size != 5 || !has_registers) return ENOENT;
  if (query.query == UVC_GET_CUR) {
    if (asked_register_ < 0) return EIO;
    const int value = registers_[asked_register_];
    query.data[3] = static_cast<std::uint8_t>(value >> 8);
    query.data[4] = static_cast<std::uint8_t>(value & 0xff);
    return 0;
  }
  const int address = query.data[1] << 8 | query.data[2];
  if (query.data[0] == 1) registers_[address] = query.data[3] << 8 | query.data[4];
  asked_register_ = address;
  return 0;
}

int FakeVideo::control(unsigned long request, void* argument) {
  if (!is_open_) return EBADF;
  if (!is_plugged) return ENODEV;
  if (failing_request != 0 && static_cast<int>(_IOC_NR(request)) == failing_request && request != UVCIOC_CTRL_QUERY)
    return EIO;
  switch (request) {
    case VIDIOC_S_FMT: {
      auto& format = *static_cast<v4l2_format*>(argument);
      if (streams_) return EBUSY;
      if (other_width > 0) format.fmt.pix.width = static_cast<std::uint32_t>(other_width);
      width_ = static_cast<int>(format.fmt.pix.width);
      height_ = static_cast<int>(format.fmt.pix.height);
      return 0;
    }
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM:
      return 0;
    case VIDIOC_REQBUFS: {
      auto& wanted = *static_cast<v4l2_requestbuffers*>(argument);
      buffers_.assign(wanted.count, std::vector<std::uint8_t>(static_cast<std::size_t>(2 * width_ * height_)));
      return 0;
    }
    case VIDIOC_QUERYBUF: {
      auto& buffer = *static_cast<v4l2_buffer*>(argument);
      if (buffer.index >= buffers_.size()) return EINVAL;
      buffer.length = static_cast<std::uint32_t>(buffers_[buffer.index].size());
      buffer.m.offset = buffer.index;
      return 0;
    }
    case VIDIOC_QBUF: {
      const auto& buffer = *static_cast<v4l2_buffer*>(argument);
      if (buffer.index >= buffers_.size() || std::count(queued_.begin(), queued_.end(), buffer.index) > 0)
        return EINVAL;
      queued_.push_back(buffer.index);
      return 0;
    }
    case VIDIOC_DQBUF: {
      if (!streams_) return EINVAL;
      if (done_.empty()) return EAGAIN;
      auto& buffer = *static_cast<v4l2_buffer*>(argument);
      const Taken taken = done_.front();
      done_.pop_front();
      buffer.index = taken.index;
      buffer.bytesused = taken.bytes;
      buffer.flags = taken.damaged ? V4L2_BUF_FLAG_ERROR : 0;
      const double time = knows_time ? taken.time : 0.0;
      buffer.timestamp.tv_sec = static_cast<decltype(buffer.timestamp.tv_sec)>(std::floor(time));
      buffer.timestamp.tv_usec = static_cast<decltype(buffer.timestamp.tv_usec)>(1e6 * (time - std::floor(time)));
      return 0;
    }
    case VIDIOC_STREAMON:
      if (queued_.empty()) return EINVAL;
      streams_ = true;
      return 0;
    case VIDIOC_STREAMOFF:
      streams_ = false;
      queued_.clear();
      done_.clear();
      return 0;
    case VIDIOC_QUERYCTRL: {
      auto& range = *static_cast<v4l2_queryctrl*>(argument);
      if (controls_.count(range.id) == 0) return EINVAL;
      range.minimum = range.id == V4L2_CID_BRIGHTNESS ? -255 : 0;
      range.maximum = range.id == V4L2_CID_SHARPNESS ? 9 : 1048575;
      return 0;
    }
    case VIDIOC_G_CTRL: {
      auto& control = *static_cast<v4l2_control*>(argument);
      if (controls_.count(control.id) == 0) return EINVAL;
      control.value = controls_[control.id];
      return 0;
    }
    case VIDIOC_S_CTRL: {
      const auto& control = *static_cast<v4l2_control*>(argument);
      if (controls_.count(control.id) == 0) return EINVAL;
      if (control.id != stubborn) controls_[control.id] = control.value;
      return 0;
    }
    case UVCIOC_CTRL_QUERY:
      return extension(argument);
    default:
      return ENOTTY;
  }
}

}  // namespace reorient::nao
