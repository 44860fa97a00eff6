// SPDX-License-Identifier: MIT
// Damaged and random messages: the result is BadFootage with one line, or a message that is not larger than its bytes.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "robots/footage/footage.h"
#include "robots/footage/messages/base64.h"
#include "robots/footage/messages/cdr.h"
#include "robots/footage/messages/foxglove_json.h"
#include "robots/footage/messages/foxglove_protobuf.h"
#include "robots/footage/messages/message_types.h"
#include "robots/footage/messages/ros.h"
#include "tests/robots/footage/golden_files.h"
#include "tests/robots/footage/ros_messages.h"

namespace reorient {
namespace {

using messages::Bytes;

/// Approximate number of bytes on the heap.
std::size_t size_of(const messages::Message& message) {
  return std::visit(
      [](const auto& content) -> std::size_t {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, messages::RawImage> ||
                      std::is_same_v<Content, messages::CompressedImage>) {
          return content.data.capacity();
        } else if constexpr (std::is_same_v<Content, messages::CameraInfo>) {
          return sizeof(double) * content.d.capacity();
        } else if constexpr (std::is_same_v<Content, messages::Transforms>) {
          return sizeof(messages::Transform) * content.transforms.capacity();
        } else {
          return 0;
        }
      },
      message);
}

/// Whether each decoder of the encoding returns a message of reasonable size, or throws BadFootage with one line.
bool survives(const Bytes& bytes, std::string_view encoding) {
  for (const messages::MessageType& type : messages::message_types()) {
    if (type.encoding != encoding) continue;
    try {
      // In Protocol Buffers a transform takes 2 bytes, and vectors grow by doubling.
      if (size_of(type.decode(bytes)) > 2 * sizeof(messages::Transform) * (1 + bytes.size())) return false;
    } catch (const BadFootage& bad) {
      const std::string line = bad.what();
      if (line.empty() || line.find('\n') != std::string::npos || line.size() > 1000) return false;
    }
  }
  return true;
}

struct GoldenFile {
  const char* name;
  std::string_view schema, encoding;
};
const std::vector<GoldenFile> kGolden{
    {"image.cdr", "sensor_msgs/msg/Image", "cdr"},
    {"compressed_image.cdr", "sensor_msgs/msg/CompressedImage", "cdr"},
    {"camera_info.cdr", "sensor_msgs/msg/CameraInfo", "cdr"},
    {"transforms.cdr", "tf2_msgs/msg/TFMessage", "cdr"},
    {"pose_stamped.cdr", "geometry_msgs/msg/PoseStamped", "cdr"},
    {"pose_with_covariance_stamped.cdr", "geometry_msgs/msg/PoseWithCovarianceStamped", "cdr"},
    {"odometry.cdr", "nav_msgs/msg/Odometry", "cdr"},
    {"imu.cdr", "sensor_msgs/msg/Imu", "cdr"},
    {"raw_image.pb", "foxglove.RawImage", "protobuf"},
    {"compressed_image.pb", "foxglove.CompressedImage", "protobuf"},
    {"camera_calibration.pb", "foxglove.CameraCalibration", "protobuf"},
    {"frame_transform.pb", "foxglove.FrameTransform", "protobuf"},
    {"frame_transforms.pb", "foxglove.FrameTransforms", "protobuf"},
    {"pose_in_frame.pb", "foxglove.PoseInFrame", "protobuf"},
    {"raw_image.json", "foxglove.RawImage", "json"},
    {"compressed_image.json", "foxglove.CompressedImage", "json"},
    {"camera_calibration.json", "foxglove.CameraCalibration", "json"},
    {"frame_transform.json", "foxglove.FrameTransform", "json"},
    {"frame_transforms.json", "foxglove.FrameTransforms", "json"},
    {"pose_in_frame.json", "foxglove.PoseInFrame", "json"},
};

TEST(HostileMessages, EachPrefixOfAMessageIsRefusedOrRead) {
  for (const GoldenFile& file : kGolden) {
    const Bytes whole = golden_message(file.name);
    const messages::MessageType* const type = messages::find_message_type(file.schema, file.encoding);
    ASSERT_NE(type, nullptr) << file.name;
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Bytes prefix(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      if (file.encoding == "protobuf") {  // a prefix may be a message
        EXPECT_TRUE(survives(prefix, file.encoding)) << file.name << ", " << size;
      } else {
        EXPECT_THROW(type->decode(prefix), BadFootage) << file.name << ", " << size;
      }
    }
    EXPECT_NO_THROW(type->decode(whole)) << file.name;
  }
}

RC_GTEST_PROP(HostileMessages, FlippedBitsAreRefusedOrRead, ()) {
  const GoldenFile& file = kGolden[*rc::gen::inRange<std::size_t>(0, kGolden.size())];
  Bytes bytes = golden_message(file.name);
  const auto places = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 8 * bytes.size()));
  for (const std::size_t place : places) bytes[place / 8] ^= static_cast<std::byte>(1u << place % 8);
  RC_ASSERT(survives(bytes, file.encoding));
}

RC_GTEST_PROP(HostileMessages, RandomBytesAreRefusedOrRead, (const std::vector<std::uint8_t>& numbers)) {
  Bytes bytes;
  for (const std::uint8_t number : numbers) bytes.push_back(static_cast<std::byte>(number));
  for (const char* const encoding : {"cdr", "protobuf", "json"}) RC_ASSERT(survives(bytes, encoding));
  Bytes with_header{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
  with_header.insert(with_header.end(), bytes.begin(), bytes.end());
  RC_ASSERT(survives(with_header, "cdr"));
}

std::string error_of(const Bytes& bytes, messages::Message (*decode)(std::span<const std::byte>)) {
  try {
    decode(bytes);
  } catch (const BadFootage& bad) {
    return bad.what();
  }
  return {};
}

TEST(HostileMessages, ErrorsNameThePositionAndTheProblem) {
  messages::RawImage image{{5, "camera"}, 4, 2, "rgb8", 12, Bytes(24)};
  Bytes bytes = ros_image(image);
  bytes.pop_back();
  const auto decode = messages::find_message_type("sensor_msgs/msg/Image", "cdr")->decode;
  EXPECT_EQ(error_of(bytes, decode), "byte 48: data: expected at most 23 elements, found 24");
  bytes[1] = std::byte{7};
  EXPECT_EQ(error_of(bytes, decode), "byte 0: expected CDR of version 1 (0 or 1), found representation 7");
  EXPECT_EQ(error_of({}, decode), "byte 0: expected a CDR header of 4 bytes, found 0");
}

TEST(HostileMessages, AHugeLengthAllocatesNoMemory) {
  CdrWriter out(ByteOrder::little);
  out.number(std::uint32_t{0xFFFFFFFF});
  const auto decode = messages::find_message_type("tf2_msgs/msg/TFMessage", "cdr")->decode;
  EXPECT_EQ(error_of(out.take(), decode), "byte 4: transforms: expected at most 0 elements, found 4294967295");
}

TEST(HostileMessages, AMatrixOfAWrongSizeIsRefused) {
  const std::string text = R"({"width": 4, "height": 2, "K": [1, 2, 3]})";
  const auto characters = std::as_bytes(std::span(text));
  const auto decode = messages::find_message_type("foxglove.CameraCalibration", "json")->decode;
  EXPECT_EQ(error_of({characters.begin(), characters.end()}, decode), "K: expected 9 numbers, found 3");
}

TEST(Base64, DecodesTheOutputOfAnotherLibrary) {
  const auto text_of = [](std::string_view base64) {
    const Bytes bytes = messages::bytes_of_base64(base64);
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  // RFC 4648, section 10.
  EXPECT_EQ(text_of(""), "");
  EXPECT_EQ(text_of("Zg=="), "f");
  EXPECT_EQ(text_of("Zm8="), "fo");
  EXPECT_EQ(text_of("Zm8"), "fo");
  EXPECT_EQ(text_of("Zm9vYmFy"), "foobar");
  EXPECT_THROW(text_of("Zm9vY"), BadFootage);
  EXPECT_THROW(text_of("Zm9 YmFy"), BadFootage);
}

TEST(HostileMessages, WithANumberThatIsTooLargeAreRefused) {
  const std::string_view json = R"({"width": 12342e56789})";
  EXPECT_THROW(messages::foxglove_json::raw_image(std::as_bytes(std::span(json))), BadFootage);
}

}  // namespace
}  // namespace reorient
