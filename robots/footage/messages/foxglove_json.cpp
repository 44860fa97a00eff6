// SPDX-License-Identifier: MIT
#include "robots/footage/messages/foxglove_json.h"

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "robots/footage/messages/bad_message.h"
#include "robots/footage/messages/base64.h"

namespace reorient::messages::foxglove_json {
namespace {

using Json = nlohmann::json;

/// Size and depth are limited, because a parsed value takes many times the memory of its text.
Json parse(std::span<const std::byte> message) {
  constexpr std::size_t kLargest = 64u << 20;
  constexpr int kDeepest = 16;
  if (message.size() > kLargest)
    fail_at(0, "expected JSON of at most 64 MB, found " + std::to_string(message.size()) + " bytes");
  const auto check_depth = [](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepest) throw BadFootage("expected JSON with at most 16 levels, found more");
    return true;
  };
  const auto* const begin = reinterpret_cast<const char*>(message.data());
  try {
    Json json = Json::parse(begin, begin + message.size(), check_depth);
    if (!json.is_object()) fail_at(0, std::string("expected a JSON object, found ") + json.type_name());
    return json;
  } catch (const Json::parse_error& error) {
    fail_at(error.byte, "expected JSON, found invalid syntax");
  } catch (const Json::out_of_range&) {
    fail_at(0, "expected numbers of JSON that a double holds, found a larger one");
  }
}

[[noreturn]] void fail_in(const std::string& field, const char* expected, const Json* found) {
  throw BadFootage(field + ": expected " + expected + ", found " + (found != nullptr ? found->type_name() : "nothing"));
}

/// Null if the field is missing.
const Json* find(const Json& object, const char* name) {
  const auto it = object.find(name);
  return it == object.end() ? nullptr : &*it;
}

const Json& object_in(const Json& object, const char* name) {
  const Json* const found = find(object, name);
  if (found == nullptr || !found->is_object()) fail_in(name, "an object", found);
  return *found;
}

double number_in(const Json& object, const char* name) {
  const Json* const found = find(object, name);
  if (found == nullptr || !found->is_number()) fail_in(name, "a number", found);
  return found->get<double>();
}

std::uint32_t count_in(const Json& object, const char* name) {
  const Json* const found = find(object, name);
  if (found == nullptr || !found->is_number_unsigned() ||
      found->get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max())
    fail_in(name, "an integer from 0 to 4294967295", found);
  return found->get<std::uint32_t>();
}

std::string text_in(const Json& object, const char* name) {
  const Json* const found = find(object, name);
  if (found == nullptr) return {};
  if (!found->is_string()) fail_in(name, "a string", found);
  return found->get<std::string>();
}

Bytes data_in(const Json& object) {
  const Json* const found = find(object, "data");
  if (found == nullptr || !found->is_string()) fail_in("data", "a string in base64", found);
  try {
    return bytes_of_base64(found->get_ref<const std::string&>());
  } catch (const BadFootage& bad) {
    throw BadFootage(std::string("data: ") + bad.what());
  }
}

Time time_in(const Json& object) {
  if (find(object, "timestamp") == nullptr) return 0;
  const Json& time = object_in(object, "timestamp");
  const std::uint32_t nanoseconds = count_in(time, "nsec");
  if (nanoseconds >= kSecond)
    throw BadFootage("timestamp.nsec: expected at most 999999999, found " + std::to_string(nanoseconds));
  return Time{count_in(time, "sec")} * kSecond + nanoseconds;
}

Header header_in(const Json& object) { return {time_in(object), text_in(object, "frame_id")}; }

Eigen::Vector3d vector_in(const Json& object, const char* name) {
  const Json& vector = object_in(object, name);
  return {number_in(vector, "x"), number_in(vector, "y"), number_in(vector, "z")};
}

Quaternion quaternion_in(const Json& object, const char* name) {
  const Json& quaternion = object_in(object, name);
  return {number_in(quaternion, "x"), number_in(quaternion, "y"), number_in(quaternion, "z"),
          number_in(quaternion, "w")};
}

std::vector<double> numbers_in(const Json& object, const char* name) {
  const Json* const found = find(object, name);
  if (found == nullptr) return {};
  if (!found->is_array()) fail_in(name, "an array of numbers", found);
  std::vector<double> numbers;
  numbers.reserve(found->size());
  for (const Json& each : *found) {
    if (!each.is_number()) fail_in(name, "an array of numbers", &each);
    numbers.push_back(each.get<double>());
  }
  return numbers;
}

Transform transform_of(const Json& json) {
  Transform transform;
  transform.header = {time_in(json), text_in(json, "parent_frame_id")};
  transform.child = text_in(json, "child_frame_id");
  transform.parent_from_child.translation = vector_in(json, "translation");
  transform.parent_from_child.rotation = quaternion_in(json, "rotation");
  return transform;
}

}  // namespace

RawImage raw_image(std::span<const std::byte> message) {
  const Json json = parse(message);
  RawImage image;
  image.header = header_in(json);
  image.width = count_in(json, "width");
  image.height = count_in(json, "height");
  image.encoding = text_in(json, "encoding");
  image.step = count_in(json, "step");
  image.data = data_in(json);
  return image;
}

CompressedImage compressed_image(std::span<const std::byte> message) {
  const Json json = parse(message);
  return {header_in(json), text_in(json, "format"), data_in(json)};
}

CameraInfo camera_calibration(std::span<const std::byte> message) {
  const Json json = parse(message);
  CameraInfo info;
  info.header = header_in(json);
  info.width = count_in(json, "width");
  info.height = count_in(json, "height");
  info.distortion_model = text_in(json, "distortion_model");
  info.d = numbers_in(json, "D");
  info.k = matrix_of<9>(numbers_in(json, "K"), "K");
  info.p = matrix_of<12>(numbers_in(json, "P"), "P");
  return info;
}

Transforms frame_transform(std::span<const std::byte> message) {
  Transforms all;
  all.transforms.push_back(transform_of(parse(message)));
  return all;
}

Transforms frame_transforms(std::span<const std::byte> message) {
  const Json json = parse(message);
  const Json* const transforms = find(json, "transforms");
  if (transforms == nullptr || !transforms->is_array()) fail_in("transforms", "an array", transforms);
  Transforms all;
  for (const Json& each : *transforms) {
    if (!each.is_object()) fail_in("transforms", "an array of objects", &each);
    all.transforms.push_back(transform_of(each));
  }
  return all;
}

Pose pose_in_frame(std::span<const std::byte> message) {
  const Json json = parse(message);
  const Json& pose = object_in(json, "pose");
  Pose found;
  found.header = header_in(json);
  found.pose = {vector_in(pose, "position"), quaternion_in(pose, "orientation")};
  return found;
}

}  // namespace reorient::messages::foxglove_json
