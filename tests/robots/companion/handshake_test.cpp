// SPDX-License-Identifier: MIT
#include "robots/companion/handshake.h"

#include <array>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "tests/robots/companion/raw_client.h"

namespace reorient {
namespace {

std::span<const std::byte> bytes_of(const reorient_hello& hello) { return std::as_bytes(std::span(&hello, 1)); }

/// The reason why a hello is refused; empty if it is accepted.
std::string complaint_about(const reorient_hello& hello) {
  try {
    static_cast<void>(read_handshake(bytes_of(hello), no_known_robots()));
    return {};
  } catch (const BadMessage& bad) {
    return bad.what();
  }
}

TEST(Handshake, DescribesTheRobot) {
  const Handshake handshake = read_handshake(bytes_of(small_hello(9)), no_known_robots());
  EXPECT_EQ(handshake.client, 9u);
  EXPECT_FALSE(handshake.own_localization);
  EXPECT_TRUE(handshake.carries_out_head);
  EXPECT_TRUE(handshake.carries_out_walk);
  EXPECT_FALSE(handshake.carries_out_get_up) << "it does not carry out this request, and cannot get up";
  EXPECT_EQ(handshake.body.name, "a test robot");
  EXPECT_EQ(handshake.body.neck.yaw, 2.0);
  EXPECT_EQ(handshake.body.standing_load, 5.0);
  EXPECT_FALSE(handshake.body.lower_camera);
  EXPECT_EQ(handshake.field.length, 9.0);
  EXPECT_NEAR(handshake.body.upper_camera.field_of_view_horizontal, 2.0 * std::atan(32.0 / 60.0), 1e-9);
}

TEST(Handshake, MayNameARobotAndAField) {
  reorient_hello hello = small_hello();
  hello.body = {};
  set_text(hello.body.name, "k9");
  hello.field = {};
  hello.cameras[0].position[2] = 0.07;
  KnownRobots known = no_known_robots();
  known.body = [](const std::string& name) {
    RobotBody body;
    body.field = "lawn";
    return name == "k9" ? std::optional(body) : std::nullopt;
  };
  known.field = [](const std::string& name) {
    FieldDimensions field;
    field.length = 12.0;
    return name == "lawn" ? std::optional(field) : std::nullopt;
  };
  const Handshake handshake = read_handshake(bytes_of(hello), known);
  EXPECT_EQ(handshake.field.length, 12.0);
  EXPECT_EQ(handshake.body.dimensions.upper.position.z(), 0.07) << "the calibration of the hello is used";
  EXPECT_FALSE(handshake.body.lower_camera) << "the cameras of the hello are used";
}

TEST(Handshake, MayHaveAnotherCalibrationOfTheSameRobot) {
  reorient_hello hello = small_hello(1);
  const Handshake one = read_handshake(bytes_of(hello), no_known_robots());
  hello.client = 2;
  hello.cameras[0].tilt += 0.003;
  hello.cameras[0].focal[0] += 0.7;
  hello.cameras[0].center[1] -= 1.5;
  hello.cameras[0].distortion[0] = 0.01;
  EXPECT_EQ(identity_of(one), identity_of(read_handshake(bytes_of(hello), no_known_robots())));
  hello.cameras[0].width *= 2;
  EXPECT_NE(identity_of(one), identity_of(read_handshake(bytes_of(hello), no_known_robots())));
  hello = small_hello(1);
  hello.way = REORIENT_OWN_LOCALIZATION;
  EXPECT_NE(identity_of(one), identity_of(read_handshake(bytes_of(hello), no_known_robots())));
  hello = small_hello(1);
  hello.body.yaw_limit = 1.0;
  EXPECT_NE(identity_of(one), identity_of(read_handshake(bytes_of(hello), no_known_robots())));
}

TEST(Handshake, WithAnErrorIsRefusedWithTheReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<std::function<void(reorient_hello&)>, const char*> mistakes[] = {
      {[](auto& hello) { hello.way = 0; }, "way is 0"},
      {[](auto& hello) { hello.client = 0; }, "client is 0 (expected a random number"},
      {[](auto& hello) { hello.delay = -1.0; }, "delay is -1"},
      {[&](auto& hello) { hello.delay = nan; }, "delay is"},
      {[](auto& hello) { hello.cameras[0].format = 0; }, "cameras[0] is missing"},
      {[](auto& hello) { hello.cameras[0].format = 6; }, "unknown image format 6 (expected 1 to 5)"},
      {[](auto& hello) { hello.cameras[0].width = 63; }, "images of 63x64 pixels"},
      {[](auto& hello) { hello.cameras[0].height = 65534; }, "images of 64x65534 pixels"},
      {[](auto& hello) {
         hello.cameras[0].width = hello.cameras[0].height = 4096;
         hello.cameras[0].format = REORIENT_RGB;
       },
       "images of 50331648 bytes (expected at most 16 MiB)"},
      {[](auto& hello) { hello.cameras[0].focal[1] = 0.0; }, "a focal length"},
      {[&](auto& hello) { hello.cameras[0].tilt = nan; }, "a camera's tilt"},
      {[](auto& hello) { hello.body.has = 0; }, "unknown robot 'a test robot'"},
      {[](auto& hello) { hello.body.torso_height = 1e300; }, "torso_height is"},
      {[](auto& hello) { hello.body.pitch_limit[0] = 0.6; }, "pitch_limit[0] is greater than pitch_limit[1]"},
      {[&](auto& hello) { hello.body.first_axis[0] = nan; }, "first_axis"},
      {[](auto& hello) { hello.field.length = 1e9; }, "field: 'length' must be a number from 2 to 120"},
      {[](auto& hello) { hello.field.length = 0.0; }, "unknown field 'spl'"},
      {[](auto& hello) { hello.wants = 8; },
       "hello: wants is 8, which contains unknown bits (expected a sum of bits of 7)"},
      {[](auto& hello) { hello.body.has |= 16; }, "hello: body.has is"},
      {[](auto& hello) { hello.body.pitch_first = 2; }, "hello: body.pitch_first is 2 (expected 0 to 1)"},
  };
  for (const auto& [make, why] : mistakes) {
    reorient_hello hello = small_hello();
    make(hello);
    EXPECT_NE(complaint_about(hello).find(why), std::string::npos) << why << "\n" << complaint_about(hello);
  }
}

std::vector<std::byte> with_lenses(const reorient_hello& hello, const std::array<reorient_lens, 2>& lenses) {
  const std::span<const std::byte> first = bytes_of(hello), second = std::as_bytes(std::span(lenses));
  std::vector<std::byte> bytes(first.begin(), first.end());
  bytes.insert(bytes.end(), second.begin(), second.end());
  return bytes;
}

TEST(Handshake, MayDescribeALensAfterTheHello) {
  std::array<reorient_lens, 2> lenses{};
  lenses[0] = {REORIENT_LENS_FISHEYE, 4, {0.02, -0.003, 0.001, -0.0002}};
  const Handshake handshake = read_handshake(with_lenses(small_hello(), lenses), no_known_robots());
  const CameraModel camera = camera_model(*handshake.cameras[0], handshake.lenses[0]);
  EXPECT_EQ(camera.projection, CameraProjection::fisheye);
  EXPECT_EQ(camera.k4, -0.0002);
  EXPECT_GT(handshake.body.upper_camera.field_of_view_horizontal,
            read_handshake(bytes_of(small_hello()), no_known_robots()).body.upper_camera.field_of_view_horizontal);
  lenses[0] = {REORIENT_LENS_PINHOLE, 5, {0.02, -0.003, 0.001, -0.0002, 0.001}};
  EXPECT_EQ(read_handshake(with_lenses(small_hello(), lenses), no_known_robots()).lenses[0].k3, 0.001);
}

TEST(Handshake, WithAnEmptyLensIsTheSameAsWithoutALens) {
  reorient_hello hello = small_hello();
  hello.cameras[0].distortion[0] = 0.05;
  const Handshake one = read_handshake(with_lenses(hello, {}), no_known_robots());
  EXPECT_EQ(one.lenses[0].k1, 0.05);
  EXPECT_EQ(identity_of(one), identity_of(read_handshake(bytes_of(hello), no_known_robots())));
}

TEST(Handshake, MayHaveAnotherLensOfTheSameRobot) {
  std::array<reorient_lens, 2> lenses{};
  lenses[0].model = REORIENT_LENS_FISHEYE;
  EXPECT_EQ(identity_of(read_handshake(with_lenses(small_hello(), lenses), no_known_robots())),
            identity_of(read_handshake(bytes_of(small_hello()), no_known_robots())));
}

TEST(Handshake, WithAnInvalidLensIsRefusedWithTheReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<reorient_lens, const char*> mistakes[] = {
      {{4, 0, {}}, "lens of camera 0: unknown model 4 (expected 0 to 3)"},
      {{REORIENT_LENS_PINHOLE, 9, {}}, "expected at most 8 coefficients, found 9"},
      {{REORIENT_LENS_PINHOLE, 3, {}}, "expected 0, 2, 4, 5 or 8 coefficients for a pinhole camera, found 3"},
      {{REORIENT_LENS_FISHEYE, 5, {}}, "expected 0 or 4 coefficients for a fisheye camera, found 5"},
      {{REORIENT_LENS_FISHEYE, 4, {nan}}, "a lens's coefficient is"},
      {{REORIENT_LENS_FISHEYE, 4, {-9.0}}, "the distortion folds back"},
      {{REORIENT_LENS_PINHOLE, 5, {-9.0}}, "the distortion folds back"},
  };
  for (const auto& [lens, why] : mistakes) {
    try {
      static_cast<void>(read_handshake(with_lenses(small_hello(), {lens}), no_known_robots()));
      ADD_FAILURE() << why;
    } catch (const BadMessage& bad) {
      EXPECT_NE(std::string(bad.what()).find(why), std::string::npos) << bad.what();
    }
  }
}

TEST(Handshake, WithAnotherSizeIsRefused) {
  const reorient_hello hello = small_hello();
  const auto bytes = bytes_of(hello);
  EXPECT_THROW(read_handshake(bytes.first(bytes.size() - 1), no_known_robots()), BadMessage);
  std::vector<std::byte> longer(bytes.begin(), bytes.end());
  longer.push_back({});
  EXPECT_THROW(read_handshake(longer, no_known_robots()), BadMessage);
}

TEST(Handshake, ImageOfAnUnknownFormatHasNoSize) {
  for (const std::uint32_t format : {0u, 6u, 4000000000u}) {
    reorient_camera camera{};
    camera.width = 64;
    camera.height = 64;
    camera.format = format;
    EXPECT_EQ(reorient_image_bytes(&camera), 0u);
  }
}

}  // namespace
}  // namespace reorient
