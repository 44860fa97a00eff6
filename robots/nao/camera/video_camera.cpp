// SPDX-License-Identifier: MIT
#include "robots/nao/camera/video_camera.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

#include <linux/usb/video.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>

namespace reorient::nao {
namespace {

constexpr double kPeriod = 1.0 / 30.0;  // s
constexpr double kFirstImage = 1.0;     // s from the start to the first image, at most
constexpr double kNextImage = 0.5;      // s between two images, at most
constexpr double kPause = 1.0;          // s before the device is opened again
constexpr std::uint8_t kExtensionUnit = 3;

// The sensor's registers for white balance: gains of red, green and blue, 12 bits each in two bytes.
constexpr std::uint16_t kGains = 0x3400;
constexpr std::uint8_t kRegister = 0x0e;  // selector of the extension unit
constexpr double kRegisterPause = 0.1;    // s

/// First 0 to read or 1 to write, then the address and the value, each with the higher byte first.
std::array<std::uint8_t, 5> register_address(std::size_t gain) {
  return {0, static_cast<std::uint8_t>(kGains >> 8), static_cast<std::uint8_t>((kGains & 0xff) + gain), 0, 0};
}

}  // namespace

std::future<bool> run_at_once(const std::function<bool()>& errand) {
  std::promise<bool> result;
  result.set_value(errand());
  return result.get_future();
}

std::future<bool> run_apart(std::function<bool()> errand) { return std::async(std::launch::async, std::move(errand)); }

VideoCamera::VideoCamera(VideoDevice& device, VideoSettings settings, RunErrand run)
    : device_(device), settings_(std::move(settings)), run_(std::move(run)) {}

VideoCamera::~VideoCamera() {
  if (errand_.valid()) errand_.wait();
  end();
}

void VideoCamera::run(Errand what, double now) {
  what_ = what;
  is_the_devices_ = what != Errand::lock_colors;
  errand_ = run_([this, what] {
    switch (what) {
      case Errand::begin:
        if (begin()) return true;
        break;
      case Errand::lock_colors:
        return lock_colors();
      case Errand::end:
        break;
    }
    end();
    return false;
  });
  is_busy(now);  // the errand may be over
}

/// Whether an errand still runs.
bool VideoCamera::is_busy(double now) {
  if (!errand_.valid()) return false;
  if (errand_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return true;
  is_the_devices_ = false;
  is_done(what_, errand_.get(), now);
  return false;
}

void VideoCamera::is_done(Errand what, bool succeeded, double now) {
  switch (what) {
    case Errand::begin:
      next_attempt_ = now + kPause;
      if (!succeeded) return;
      begun_ = last_image_ = now;
      state_ = has_settled_ ? VideoState::running : VideoState::settling;
      return;
    case Errand::end:
      next_attempt_ = now + kPause;
      return;
    case Errand::lock_colors:
      next_step_ = now + kRegisterPause;
      if (!succeeded) return;
      has_settled_ = true;
      state_ = VideoState::running;
      return;
  }
}

std::optional<VideoCamera::Image> VideoCamera::look(double now) {
  const bool busy = is_busy(now);
  if (state_ == VideoState::closed) {
    if (busy || now < next_attempt_) return std::nullopt;
    run(Errand::begin, now);
    if (state_ == VideoState::closed) return std::nullopt;
  }
  std::optional<Image> newest;
  bool lost = false;  // unplugged, or the driver failed
  for (std::size_t taken = 0; taken < kBuffers; ++taken) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    const int error = device_.control(VIDIOC_DQBUF, &buffer);
    if (error == EAGAIN) break;
    if (error != 0 || buffer.index >= kBuffers) {
      lost = true;
      break;
    }
    const std::size_t wanted =
        2u * static_cast<std::size_t>(settings_.width) * static_cast<std::size_t>(settings_.height);
    if ((buffer.flags & V4L2_BUF_FLAG_ERROR) != 0 || buffer.bytesused < wanted ||
        buffers_[buffer.index].length < wanted) {
      ++counts_.damaged;
      if (queue(buffer.index)) continue;
      lost = true;
      break;
    }
    if (newest) ++counts_.superseded;
    if (held_ && !queue(*held_)) {
      lost = true;
      break;
    }
    held_ = buffer.index;
    ++counts_.images;
    Image image;
    image.time = static_cast<double>(buffer.timestamp.tv_sec) + 1e-6 * static_cast<double>(buffer.timestamp.tv_usec);
    // The first images have no time. A time long ago or in the future is invalid.
    constexpr double kOldest = 1.0;
    image.is_time_guessed = image.time <= 0.0 || image.time > now || image.time < now - kOldest;
    if (image.is_time_guessed) image.time = now - kPeriod;
    image.yuyv = {static_cast<const std::uint8_t*>(buffers_[buffer.index].address), wanted};
    newest = image;
    last_image_ = now;
  }

  const double patience = last_image_ <= begun_ ? kFirstImage : kNextImage;
  if (lost || now - last_image_ > patience) {
    if (busy) return std::nullopt;  // the device hangs in the errand; end it afterwards
    ++counts_.restarts;
    state_ = VideoState::closed;
    run(Errand::end, now);
    return std::nullopt;
  }
  const bool has_found = state_ == VideoState::settling && now - begun_ > settings_.settling;
  if (has_found && !busy && now >= next_step_) run(Errand::lock_colors, now);
  return newest;
}

bool VideoCamera::begin() {
  if (!device_.open(settings_.path) || !set_format() || !map_buffers()) return false;
  for (std::uint32_t i = 0; i < kBuffers; ++i) {
    if (!queue(i)) return false;
  }
  set_controls();
  flip();
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (device_.control(VIDIOC_STREAMON, &type) != 0) return false;
  streams_ = true;
  set_controls();  // some have an effect only while the camera streams
  held_.reset();
  asked_ = false;
  if (has_colors_) {
    write_colors();
    write_exposure();
  } else {
    gains_ = {};
    locked_ = 0;
  }
  return true;
}

bool VideoCamera::set_format() {
  v4l2_format format{};
  format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  format.fmt.pix.width = static_cast<std::uint32_t>(settings_.width);
  format.fmt.pix.height = static_cast<std::uint32_t>(settings_.height);
  format.fmt.pix.pixelformat = V4L2_PIX_FMT_YUYV;
  format.fmt.pix.field = V4L2_FIELD_NONE;
  format.fmt.pix.sizeimage = 2 * format.fmt.pix.width * format.fmt.pix.height;
  if (device_.control(VIDIOC_S_FMT, &format) != 0) return false;
  if (format.fmt.pix.width != static_cast<std::uint32_t>(settings_.width) ||
      format.fmt.pix.height != static_cast<std::uint32_t>(settings_.height) ||
      format.fmt.pix.pixelformat != V4L2_PIX_FMT_YUYV)
    return false;
  v4l2_streamparm rate{};
  rate.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (device_.control(VIDIOC_G_PARM, &rate) != 0) return false;
  rate.parm.capture.timeperframe = {1, 30};
  return device_.control(VIDIOC_S_PARM, &rate) == 0;
}

bool VideoCamera::map_buffers() {
  v4l2_requestbuffers request{};
  request.count = kBuffers;
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.memory = V4L2_MEMORY_MMAP;
  if (device_.control(VIDIOC_REQBUFS, &request) != 0 || request.count != kBuffers) return false;
  for (std::uint32_t i = 0; i < kBuffers; ++i) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.index = i;
    if (device_.control(VIDIOC_QUERYBUF, &buffer) != 0) return false;
    void* const address = device_.map(buffer.length, buffer.m.offset);
    if (address == nullptr) return false;
    buffers_[i] = {address, buffer.length};
  }
  return true;
}

void VideoCamera::end() {
  int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (streams_) static_cast<void>(device_.control(VIDIOC_STREAMOFF, &type));
  streams_ = false;
  for (Buffer& buffer : buffers_) {
    if (buffer.address != nullptr) device_.unmap(buffer.address, buffer.length);
    buffer = {};
  }
  held_.reset();
  device_.close();
}

bool VideoCamera::queue(std::uint32_t index) {
  v4l2_buffer buffer{};
  buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  return device_.control(VIDIOC_QBUF, &buffer) == 0;
}

void VideoCamera::set_controls() {
  constexpr std::pair<std::uint32_t, int> kControls[] = {
      {V4L2_CID_FOCUS_AUTO, 0},         {V4L2_CID_FOCUS_ABSOLUTE, 0}, {V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_AUTO},
      {V4L2_CID_AUTO_WHITE_BALANCE, 1}, {V4L2_CID_HUE_AUTO, 0},       {V4L2_CID_HUE, 0},
      {V4L2_CID_BRIGHTNESS, 0},         {V4L2_CID_CONTRAST, 32},      {V4L2_CID_SATURATION, 64},
      {V4L2_CID_SHARPNESS, 4},
  };
  for (const auto& [control, value] : kControls) set_control(control, value);
}

/// Some controls accept only a value that differs from the previous one.
void VideoCamera::set_control(std::uint32_t control, int value) {
  v4l2_queryctrl range{};
  range.id = control;
  if (device_.control(VIDIOC_QUERYCTRL, &range) != 0) return;  // this camera does not have the control
  v4l2_control wanted{control, std::clamp(value, range.minimum, range.maximum)};
  if (this->control(control) == wanted.value) return;
  if (device_.control(VIDIOC_S_CTRL, &wanted) != 0 ||
      this->control(control) != std::clamp(value, range.minimum, range.maximum))
    ++refused_controls_;
}

std::optional<int> VideoCamera::control(std::uint32_t control) {
  v4l2_control asked{control, 0};
  if (device_.control(VIDIOC_G_CTRL, &asked) != 0) return std::nullopt;
  return asked.value;
}

bool VideoCamera::extension(std::uint8_t query, std::uint8_t selector, std::span<std::uint8_t> data) {
  uvc_xu_control_query request{};
  request.unit = kExtensionUnit;
  request.selector = selector;
  request.query = query;
  request.size = static_cast<std::uint16_t>(data.size());
  request.data = data.data();
  return device_.control(UVCIOC_CTRL_QUERY, &request) == 0;
}

/// Flips both axes, which rotates the image by 180 degrees.
void VideoCamera::flip() {
  constexpr std::uint8_t kHorizontal = 0x0c, kVertical = 0x0d;
  for (const std::uint8_t selector : {kHorizontal, kVertical}) {
    std::array<std::uint8_t, 2> data{static_cast<std::uint8_t>(settings_.upside_down ? 1 : 0), 0};
    if (!extension(UVC_SET_CUR, selector, data)) ++refused_controls_;
  }
}

/// Locks the white balance, because the room's colors are learned as histograms. For each register of the sensor, first
/// send the address; the value is available some time later. Returns true when done.
bool VideoCamera::lock_colors() {
  if (asked_) {
    std::array<std::uint8_t, 5> data{};
    if (extension(UVC_GET_CUR, kRegister, data)) gains_[locked_] = static_cast<std::uint16_t>(data[3] << 8 | data[4]);
    asked_ = false;
    ++locked_;
  }
  if (locked_ < gains_.size()) {
    std::array<std::uint8_t, 5> data = register_address(locked_);
    asked_ = extension(UVC_SET_CUR, kRegister, data);
    if (asked_) return false;
    locked_ = gains_.size();  // another camera, without these registers
  }
  write_colors();
  bound_exposure();
  has_colors_ = true;
  return true;
}

/// Sets the color gains that were read, also after a restart of the camera, because the room was learned with them.
void VideoCamera::write_colors() {
  set_control(V4L2_CID_AUTO_WHITE_BALANCE, 0);
  for (std::size_t i = 0; i < gains_.size(); ++i) {
    if (!gains_[i]) continue;
    std::array<std::uint8_t, 5> data = register_address(i);
    data[0] = 1;
    data[3] = static_cast<std::uint8_t>(*gains_[i] >> 8);
    data[4] = static_cast<std::uint8_t>(*gains_[i] & 0xff);
    if (!extension(UVC_SET_CUR, kRegister, data)) ++refused_controls_;
  }
}

/// If the light requires a longer exposure than a moving head allows, fixes the exposure and increases the gain.
/// Otherwise both continue to adapt to the light, and so does the comparison with the room's colors.
void VideoCamera::bound_exposure() {
  const std::optional<int> exposure = control(V4L2_CID_EXPOSURE_ABSOLUTE), gain = control(V4L2_CID_GAIN);
  if (!exposure || !gain || *exposure <= settings_.longest_exposure) return;
  constexpr int kMostGain = 1023;
  const double wanted = static_cast<double>(std::max(*gain, 1)) * *exposure / settings_.longest_exposure;
  fixed_ = Exposure{settings_.longest_exposure, static_cast<int>(std::min<double>(wanted, kMostGain))};
  write_exposure();
}

/// Sets the fixed exposure again, also after a restart of the camera.
void VideoCamera::write_exposure() {
  if (!fixed_) return;
  set_control(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL);
  set_control(V4L2_CID_EXPOSURE_ABSOLUTE, fixed_->exposure);
  set_control(V4L2_CID_GAIN, fixed_->gain);
}

}  // namespace reorient::nao
