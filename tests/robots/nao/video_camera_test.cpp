// SPDX-License-Identifier: MIT
#include "robots/nao/camera/video_camera.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <linux/uvcvideo.h>
#include <linux/videodev2.h>

#include "tests/robots/nao/twin/fake_video.h"
#include "tests/waiting.h"

namespace reorient::nao {
namespace {

constexpr double kPeriod = 1.0 / 30.0;

class VideoCameraTest : public testing::Test {
 protected:
  VideoCameraTest() {
    settings_.width = 32;
    settings_.height = 24;
  }
  void begin() { camera_.emplace(device_, settings_); }

  std::vector<std::uint8_t> picture(std::uint8_t brightness) const {
    return std::vector<std::uint8_t>(static_cast<std::size_t>(2 * settings_.width * settings_.height), brightness);
  }
  /// Advances by one period and delivers an image that was exposed 10 ms ago.
  std::optional<VideoCamera::Image> look(std::uint8_t brightness) {
    now_ += kPeriod;
    device_.expose(picture(brightness), now_ - 0.01);
    return camera_->look(now_);
  }
  int images_in(double seconds) {
    int images = 0;
    for (const double end = now_ + seconds; now_ < end;) images += look(50) ? 1 : 0;
    return images;
  }

  FakeVideo device_;
  VideoSettings settings_;
  std::optional<VideoCamera> camera_;
  double now_ = 100.0;
};

TEST_F(VideoCameraTest, ShowsEachImageWithTheTimeOfItsExposure) {
  begin();
  EXPECT_FALSE(camera_->look(now_));
  for (int i = 1; i <= 10; ++i) {
    const auto image = look(static_cast<std::uint8_t>(10 * i));
    ASSERT_TRUE(image);
    EXPECT_NEAR(image->time, now_ - 0.01, 1e-5);
    EXPECT_FALSE(image->is_time_guessed);
    EXPECT_EQ(image->yuyv.size(), 2u * 32u * 24u);
    EXPECT_EQ(image->yuyv[100], 10 * i);
  }
  EXPECT_EQ(camera_->counts().images, 10u);
  EXPECT_EQ(camera_->counts().superseded, 0u);
}

TEST_F(VideoCameraTest, SkipsImagesThatAreNotTheNewest) {
  begin();
  camera_->look(now_);
  ASSERT_TRUE(look(1));
  device_.expose(picture(2), now_ + 0.010);
  device_.expose(picture(3), now_ + 0.043);
  now_ += 0.05;
  const auto image = camera_->look(now_);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->yuyv[0], 3);
  EXPECT_EQ(camera_->counts().superseded, 1u);
  EXPECT_GT(images_in(0.5), 10) << "all buffers were returned";
}

TEST_F(VideoCameraTest, EstimatesATimeThatTheDriverDoesNotReport) {
  device_.knows_time = false;
  begin();
  camera_->look(now_);
  const auto image = look(9);
  ASSERT_TRUE(image);
  EXPECT_TRUE(image->is_time_guessed);
  EXPECT_NEAR(image->time, now_ - kPeriod, 1e-9);
}

TEST_F(VideoCameraTest, FlipsTheImageOfACameraMountedUpsideDown) {
  begin();
  camera_->look(now_);
  EXPECT_TRUE(device_.is_flipped());
  camera_.reset();
  settings_.upside_down = false;
  begin();
  camera_->look(now_);
  EXPECT_FALSE(device_.is_flipped());
}

TEST_F(VideoCameraTest, LocksTheColorsAfterSettling) {
  begin();
  camera_->look(now_);
  EXPECT_EQ(device_.value_of(V4L2_CID_AUTO_WHITE_BALANCE), 1);
  for (int i = 0; i < 6; ++i) device_.set_register(0x3400 + i, 100 + i);
  images_in(settings_.settling - 0.1);
  EXPECT_EQ(camera_->state(), VideoState::settling);
  EXPECT_EQ(device_.value_of(V4L2_CID_AUTO_WHITE_BALANCE), 1);
  images_in(1.2);
  EXPECT_EQ(camera_->state(), VideoState::running);
  EXPECT_EQ(device_.value_of(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  EXPECT_EQ(device_.value_of(V4L2_CID_HUE_AUTO), 0);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(device_.registers().at(0x3400 + i), 100 + i);
}

TEST_F(VideoCameraTest, LocksTheColorsAlsoWithoutRegisters) {
  device_.has_registers = false;
  begin();
  images_in(settings_.settling + 0.5);
  EXPECT_EQ(camera_->state(), VideoState::running);
  EXPECT_EQ(device_.value_of(V4L2_CID_AUTO_WHITE_BALANCE), 0);
}

TEST_F(VideoCameraTest, LimitsTheExposureForAMovingHead) {
  begin();
  camera_->look(now_);
  device_.drift(V4L2_CID_EXPOSURE_ABSOLUTE, 4000);
  device_.drift(V4L2_CID_GAIN, 20);
  images_in(settings_.settling + 1.2);
  EXPECT_EQ(device_.value_of(V4L2_CID_EXPOSURE_AUTO), static_cast<int>(V4L2_EXPOSURE_MANUAL));
  EXPECT_EQ(device_.value_of(V4L2_CID_EXPOSURE_ABSOLUTE), settings_.longest_exposure);
  EXPECT_EQ(device_.value_of(V4L2_CID_GAIN), 80);
}

TEST_F(VideoCameraTest, DoesNotChangeAnExposureThatIsShortEnough) {
  begin();
  images_in(settings_.settling + 1.2);
  EXPECT_EQ(device_.value_of(V4L2_CID_EXPOSURE_AUTO), static_cast<int>(V4L2_EXPOSURE_AUTO));
}

TEST_F(VideoCameraTest, KeepsAFixedExposureAfterARestart) {
  begin();
  camera_->look(now_);
  device_.drift(V4L2_CID_EXPOSURE_ABSOLUTE, 4000);
  device_.drift(V4L2_CID_GAIN, 20);
  images_in(settings_.settling + 1.2);
  device_.is_plugged = false;
  images_in(1.0);
  device_.is_plugged = true;
  images_in(1.5);
  ASSERT_EQ(camera_->state(), VideoState::running);
  EXPECT_EQ(device_.value_of(V4L2_CID_EXPOSURE_AUTO), static_cast<int>(V4L2_EXPOSURE_MANUAL));
  EXPECT_EQ(device_.value_of(V4L2_CID_EXPOSURE_ABSOLUTE), settings_.longest_exposure);
  EXPECT_EQ(device_.value_of(V4L2_CID_GAIN), 80);
}

constexpr std::chrono::milliseconds kOften{1};

/// One type of call hangs until the test releases it. Like a driver, it runs one call at a time.
class HangingVideo : public FakeVideo {
 public:
  std::atomic<unsigned long> hanging_request = 0;
  std::atomic<bool> hangs = false;  // a call hangs at present

  int control(unsigned long request, void* argument) override {
    if (request == hanging_request) {  // other calls do not change `hangs`
      hangs = true;
      await([&] { return request != hanging_request; }, kOften);
      hangs = false;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    return FakeVideo::control(request, argument);
  }

 private:
  std::mutex mutex_;
};

TEST_F(VideoCameraTest, DoesNotBlockIfACallHangs) {
  HangingVideo device;
  VideoCamera camera(device, settings_, run_apart);
  const auto look_until = [&](const auto& is_so) {
    const auto looks = [&] {
      if (is_so()) return true;
      camera.look(now_);
      return false;
    };
    return await(looks, kOften);
  };
  // The stream starts,
  device.hanging_request = VIDIOC_S_FMT;
  EXPECT_FALSE(camera.look(now_));
  ASSERT_TRUE(look_until([&] { return device.hangs.load(); }));
  EXPECT_FALSE(camera.look(now_));
  EXPECT_EQ(camera.descriptor(), -1);
  device.hanging_request = 0;
  ASSERT_TRUE(look_until([&] { return camera.state() == VideoState::settling; }));
  // its colors are locked,
  device.hanging_request = UVCIOC_CTRL_QUERY;
  now_ += 0.4;
  device.expose(picture(10), now_ - 0.01);
  camera.look(now_);
  for (int i = 0; i < 100; ++i) {
    now_ += kPeriod;
    device.expose(picture(20), now_ - 0.01);
    EXPECT_TRUE(camera.look(now_)) << "images continue";
  }
  ASSERT_TRUE(look_until([&] { return device.hangs.load(); }));
  device.hanging_request = 0;
  ASSERT_TRUE(look_until(
      [&] { return now_ += 0.01, device.expose(picture(30), now_), camera.state() == VideoState::running; }));
  // and the stream ends.
  while (camera.look(now_)) {
  }
  device.hanging_request = VIDIOC_STREAMOFF;
  now_ += 2.0;
  EXPECT_FALSE(camera.look(now_));
  EXPECT_EQ(camera.state(), VideoState::closed);
  ASSERT_TRUE(look_until([&] { return device.hangs.load(); }));
  now_ += 5.0;
  EXPECT_FALSE(camera.look(now_)) << "the device is not opened while it is being closed";
  device.hanging_request = 0;
  ASSERT_TRUE(look_until([&] { return now_ += 0.01, camera.state() == VideoState::running; }))
      << "its color gains are set again";
  EXPECT_EQ(device.opened(), 2);
}

TEST_F(VideoCameraTest, WaitsForACameraThatDoesNotExistYet) {
  device_.is_plugged = false;
  begin();
  EXPECT_EQ(images_in(5.0), 0);
  EXPECT_EQ(device_.opened(), 0);
  device_.is_plugged = true;
  EXPECT_GT(images_in(2.0), 25);
}

TEST_F(VideoCameraTest, RestartsAfterItWasUnplugged) {
  begin();
  EXPECT_GT(images_in(1.0), 25);
  device_.is_plugged = false;
  EXPECT_EQ(images_in(1.0), 0);
  EXPECT_EQ(camera_->state(), VideoState::closed);
  EXPECT_EQ(device_.mapped(), 0) << "all buffers are unmapped";
  device_.is_plugged = true;
  EXPECT_GT(images_in(3.0), 50);
  EXPECT_EQ(camera_->counts().restarts, 1u);
}

TEST_F(VideoCameraTest, KeepsItsColorGainsAfterARestart) {
  begin();
  images_in(0.1);
  for (int i = 0; i < 6; ++i) device_.set_register(0x3400 + i, 100 + i);
  images_in(settings_.settling + 1.0);
  ASSERT_EQ(camera_->state(), VideoState::running);
  device_.is_plugged = false;
  images_in(1.0);
  for (int i = 0; i < 6; ++i) device_.set_register(0x3400 + i, 999);
  device_.is_plugged = true;
  images_in(1.5);
  EXPECT_EQ(camera_->state(), VideoState::running);
  EXPECT_EQ(device_.value_of(V4L2_CID_AUTO_WHITE_BALANCE), 0);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(device_.registers().at(0x3400 + i), 100 + i);
}

TEST_F(VideoCameraTest, RestartsIfNoImageArrives) {
  begin();
  images_in(1.0);
  for (int i = 0; i < 20; ++i) camera_->look(now_ += kPeriod);
  EXPECT_EQ(camera_->counts().restarts, 1u);
  EXPECT_GT(images_in(3.0), 50);
}

TEST_F(VideoCameraTest, DropsDamagedImages) {
  begin();
  camera_->look(now_);
  for (int i = 0; i < 12; ++i) {
    now_ += kPeriod;
    if (i % 2 == 0) {
      device_.expose(picture(1), now_, true);
    } else {
      device_.expose(std::vector<std::uint8_t>(100, 1), now_);
    }
    EXPECT_FALSE(camera_->look(now_));
  }
  EXPECT_EQ(camera_->counts().damaged, 12u);
  EXPECT_TRUE(look(7));
}

TEST_F(VideoCameraTest, RefusesASizeThatItDidNotRequest) {
  device_.other_width = 640;
  begin();
  EXPECT_EQ(images_in(2.5), 0);
  EXPECT_GE(device_.opened(), 2);
  EXPECT_EQ(device_.mapped(), 0);
  device_.other_width = 0;
  EXPECT_GT(images_in(2.0), 20);
}

TEST_F(VideoCameraTest, SurvivesAFailureOfEachCall) {
  for (const unsigned long request : {VIDIOC_S_FMT, VIDIOC_G_PARM, VIDIOC_S_PARM, VIDIOC_REQBUFS, VIDIOC_QUERYBUF,
                                      VIDIOC_QBUF, VIDIOC_DQBUF, VIDIOC_STREAMON}) {
    FakeVideo device;
    VideoCamera camera(device, settings_);
    device.failing_request = static_cast<int>(_IOC_NR(request));
    double now = 10.0;
    const auto images = [&](double seconds) {
      int seen = 0;
      for (const double end = now + seconds; now < end;) {
        now += kPeriod;
        device.expose(picture(1), now);
        seen += camera.look(now) ? 1 : 0;
      }
      return seen;
    };
    EXPECT_EQ(images(3.0), 0) << _IOC_NR(request);
    device.failing_request = 0;
    EXPECT_GT(images(3.0), 30) << _IOC_NR(request);
  }
}

TEST_F(VideoCameraTest, CountsAControlThatRefusesItsValueAndContinues) {
  device_.stubborn = V4L2_CID_CONTRAST;
  begin();
  EXPECT_GT(images_in(5.0), 100);
  EXPECT_GT(camera_->counts().refused_controls, 0u);
  EXPECT_LT(camera_->counts().refused_controls, 5u);
}

}  // namespace
}  // namespace reorient::nao
