// SPDX-License-Identifier: MIT
#include "robots/companion/handshake.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/bytes.h"

namespace reorient {
namespace {

double checked(double value, double least, double most, const char* what) {
  if (value >= least && value <= most) return value;  // written so that NaN fails as well
  throw BadMessage(std::string("hello: ") + what + " is " + std::to_string(value) + " (expected " +
                   std::to_string(least) + " to " + std::to_string(most) + ")");
}

template <std::size_t Size>
void check(const double (&values)[Size], double least, double most, const char* what) {
  for (const double value : values) checked(value, least, most, what);
}

constexpr double kTallest = 2.5;  // m

void check(const reorient_camera& camera) {
  constexpr int kLeast = 64, kMost = 4096;
  const auto is_valid = [](int pixels) { return pixels >= kLeast && pixels <= kMost && pixels % 2 == 0; };
  if (!is_valid(camera.width) || !is_valid(camera.height))
    throw BadMessage("hello: images of " + std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                     " pixels (expected even numbers from 64 to 4096)");
  const std::size_t bytes = reorient_image_bytes(&camera);
  if (bytes == 0)
    throw BadMessage("hello: unknown image format " + std::to_string(camera.format) + " (expected 1 to 5)");
  if (bytes > REORIENT_LARGEST_IMAGE)
    throw BadMessage("hello: images of " + std::to_string(bytes) + " bytes (expected at most 16 MiB)");
  check(camera.focal, 10.0, 1e5, "a focal length in pixels");
  check(camera.center, -1e4, 1e4, "an image's center in pixels");
  check(camera.distortion, -2.0, 2.0, "a distortion");
  check(camera.position, -kTallest, kTallest, "a camera's position");
  checked(camera.tilt, -0.5 * kPi, 0.5 * kPi, "a camera's tilt");
}

/// The lens of a camera, described by an optional block after the hello. Without the block it is a pinhole lens, whose
/// distortion is not checked at the image's edge, because clients of earlier versions were never refused for that.
Lens lens_of(const reorient_camera& camera, const std::optional<reorient_lens>& sent, int number) {
  const std::string where = "hello: lens of camera " + std::to_string(number) + ": ";
  Lens lens;
  if (!sent || sent->model == REORIENT_LENS_OF_CAMERA) {
    lens.k1 = camera.distortion[0];
    lens.k2 = camera.distortion[1];
    return lens;
  }
  if (sent->model > REORIENT_LENS_EQUIRECTANGULAR)
    throw BadMessage(where + "unknown model " + std::to_string(sent->model) + " (expected 0 to 3)");
  constexpr CameraProjection kProjections[] = {CameraProjection::pinhole, CameraProjection::fisheye,
                                               CameraProjection::equirectangular};
  lens.projection = kProjections[sent->model - REORIENT_LENS_PINHOLE];
  if (sent->count > std::size(sent->coefficients))
    throw BadMessage(where + "expected at most 8 coefficients, found " + std::to_string(sent->count));
  check(sent->coefficients, -100.0, 100.0, "a lens's coefficient");
  if (const std::string mistake = lens.set_coefficients(std::span(sent->coefficients).first(sent->count));
      !mistake.empty())
    throw BadMessage(where + mistake);
  if (const std::string mistake = mistake_in(camera_model(camera, lens)); !mistake.empty())
    throw BadMessage(where + mistake);
  return lens;
}

CameraOptics optics_of(const reorient_camera& camera, const Lens& lens) {
  CameraOptics optics;
  static_cast<Lens&>(optics) = lens;
  optics.width = camera.width;
  optics.height = camera.height;
  optics.field_of_view_horizontal = 2.0 * lens.angle_at_place(0.5 * camera.width / camera.focal[0]);
  optics.field_of_view_vertical = 2.0 * lens.angle_at_place(0.5 * camera.height / camera.focal[1]);
  return optics;
}

Eigen::Vector3d vector_of(const double (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }

RobotBody body_of(const reorient_body& sent, const KnownRobots& known) {
  const std::string name = text_of(sent.name);
  if ((sent.has & REORIENT_BODY_NUMBERS) == 0) {
    if (std::optional<RobotBody> body = known.body(name)) return *std::move(body);
    throw BadMessage("hello: unknown robot '" + name + "'; send its numbers (REORIENT_BODY_NUMBERS)");
  }
  RobotBody body;
  body.name = name.empty() ? "a robot" : name;
  RobotDimensions& dimensions = body.dimensions;
  dimensions.torso_height = checked(sent.torso_height, 0.05, kTallest, "torso_height");
  dimensions.neck_order = sent.pitch_first != 0 ? NeckOrder::pitch_then_yaw : NeckOrder::yaw_then_pitch;
  check(sent.first_axis, -kTallest, kTallest, "first_axis");
  check(sent.second_axis, -kTallest, kTallest, "second_axis");
  dimensions.first_axis = vector_of(sent.first_axis);
  dimensions.second_axis = vector_of(sent.second_axis);
  check(sent.pitch_limit, -kPi, kPi, "pitch_limit");
  if (sent.pitch_limit[0] > sent.pitch_limit[1])
    throw BadMessage("hello: pitch_limit[0] is greater than pitch_limit[1]");
  body.neck = {checked(sent.yaw_limit, 0.0, kPi, "yaw_limit"), {{0.0, sent.pitch_limit[0], sent.pitch_limit[1]}}};
  body.head_speed = checked(sent.head_speed, 0.1, 20.0, "head_speed");
  body.standing_load.reset();
  body.gait.reset();
  body.get_up_time.reset();
  if ((sent.has & REORIENT_BODY_FEET) != 0)
    body.standing_load = checked(sent.standing_load, 0.1, 200.0, "standing_load");
  if ((sent.has & REORIENT_BODY_WALK) != 0) {
    check(sent.walk_limit, 0.0, 5.0, "walk_limit");
    Gait& gait = body.gait.emplace();
    gait.forward = sent.walk_limit[0];
    gait.left = sent.walk_limit[1];
    gait.turn = sent.walk_limit[2];
    gait.cruise = checked(sent.cruise, 0.0, 2.0, "cruise");
  }
  if ((sent.has & REORIENT_BODY_GET_UP) != 0) body.get_up_time.emplace(6.0);
  return body;
}

FieldDimensions field_of(const reorient_field& sent, const RobotBody& body, const KnownRobots& known) {
  const std::string name = text_of(sent.name);
  const bool has_numbers = sent.length != 0.0;
  if (!name.empty() || !has_numbers) {
    const std::string wanted = name.empty() ? body.field : name;
    if (const std::optional<FieldDimensions> field = known.field(wanted)) return *field;
    throw BadMessage("hello: unknown field '" + wanted + "'; send its numbers and an empty name");
  }
  FieldDimensions field;
  field.length = sent.length;
  field.width = sent.width;
  field.border = sent.border;
  field.line_width = sent.line_width;
  field.penalty_area_depth = sent.penalty_area[0];
  field.penalty_area_width = sent.penalty_area[1];
  field.goal_area_depth = sent.goal_area[0];
  field.goal_area_width = sent.goal_area[1];
  field.penalty_mark_x = sent.penalty_mark;
  field.penalty_mark_size = sent.mark_size;
  field.center_circle_radius = sent.circle_radius;
  field.corner_arc_radius = sent.corner_radius;
  field.goal_post_y = sent.post_y;
  field.goal_height = sent.goal_height;
  field.goal_depth = sent.goal_depth;
  field.goal_post_diameter = sent.post_diameter;
  if (const std::string mistake = mistake_in(field); !mistake.empty()) throw BadMessage("hello: field: " + mistake);
  return field;
}

/// Removes the block after the lenses and its text from the front.
ApplicationInterface interface_of(std::span<const std::byte>& bytes, const KnownRobots& known) {
  const auto sent = take_message<reorient_interface>(bytes, "hello: interface");
  const bool has_more = bytes.size() == sent.size + sizeof(reorient_detector);
  if (sent.size == 0 && has_more) return known.default_interface;
  if (sent.size == 0 || sent.size > REORIENT_LONGEST_INTERFACE)
    throw BadMessage("hello: interface: expected a text of 1 to 32768 bytes, found " + std::to_string(sent.size));
  if (bytes.size() != sent.size && !has_more)
    throw BadMessage("hello: interface: expected " + std::to_string(sent.size) + " bytes of text, found " +
                     std::to_string(bytes.size()));
  if (!known.interface) throw BadMessage("hello: interface: not supported here");
  std::string text(sent.size, '\0');
  std::memcpy(text.data(), bytes.data(), text.size());
  bytes = bytes.subspan(sent.size);
  const std::string name = text_of(sent.name);
  try {
    return known.interface(text, name.empty() ? "interface" : name);
  } catch (const std::runtime_error& mistake) {
    throw BadMessage("hello: interface: " + std::string(mistake.what()));
  }
}

void take_detector(std::span<const std::byte> bytes, Handshake& handshake) {
  if (bytes.empty()) return;
  const auto sent = take_message<reorient_detector>(bytes, "hello: detector");
  if (sent.use != REORIENT_PERCEPTS_WITH && sent.use != REORIENT_PERCEPTS_INSTEAD)
    throw BadMessage("hello: detector: use is " + std::to_string(sent.use) +
                     " (expected 1, with Reorient's field vision, or 2, instead of it)");
  handshake.has_detector = true;
  handshake.detector_replaces_vision = sent.use == REORIENT_PERCEPTS_INSTEAD;
}

}  // namespace

Handshake read_handshake(std::span<const std::byte> bytes, const KnownRobots& known) {
  const auto hello = take_message<reorient_hello>(bytes, "hello");
  std::array<std::optional<reorient_lens>, 2> lenses;
  if (!bytes.empty()) {
    for (std::optional<reorient_lens>& lens : lenses) lens = take_message<reorient_lens>(bytes, "hello: lens");
  }
  Handshake handshake;
  handshake.application = bytes.empty() ? known.default_interface : interface_of(bytes, known);
  take_detector(bytes, handshake);
  if (hello.way != REORIENT_OWN_LOCALIZATION && hello.way != REORIENT_OUR_LOCALIZATION)
    throw BadMessage("hello: way is " + std::to_string(hello.way) +
                     " (expected 1, your localization, or 2, Reorient's)");
  check_bits(hello.wants, REORIENT_WANT_HEAD | REORIENT_WANT_WALK | REORIENT_WANT_GET_UP, "hello: wants");
  check_bits(hello.body.has, REORIENT_BODY_NUMBERS | REORIENT_BODY_FEET | REORIENT_BODY_WALK | REORIENT_BODY_GET_UP,
             "hello: body.has");
  check_choice(hello.body.pitch_first, 1, "hello: body.pitch_first");
  if (hello.client == 0)
    throw BadMessage("hello: client is 0 (expected a random number, drawn when your process starts)");
  handshake.client = hello.client;
  handshake.own_localization = hello.way == REORIENT_OWN_LOCALIZATION;
  handshake.delay = checked(hello.delay, 0.0, 2.0, "delay");
  handshake.body = body_of(hello.body, known);
  handshake.field = field_of(hello.field, handshake.body, known);
  for (std::size_t i = 0; i < handshake.cameras.size(); ++i) {
    if (hello.cameras[i].format == REORIENT_NO_IMAGE) continue;
    check(hello.cameras[i]);
    handshake.cameras[i] = hello.cameras[i];
    handshake.lenses[i] = lens_of(hello.cameras[i], lenses[i], static_cast<int>(i));
  }
  if (!handshake.cameras[0]) throw BadMessage("hello: cameras[0] is missing (expected at least this camera)");
  RobotBody& body = handshake.body;
  const auto mount_of = [](const reorient_camera& camera) {
    return CameraMount{vector_of(camera.position), camera.tilt};
  };
  body.upper_camera = optics_of(*handshake.cameras[0], handshake.lenses[0]);
  body.dimensions.upper = mount_of(*handshake.cameras[0]);
  body.lower_camera.reset();
  if (handshake.cameras[1]) {
    body.lower_camera = optics_of(*handshake.cameras[1], handshake.lenses[1]);
    body.dimensions.lower = mount_of(*handshake.cameras[1]);
  }
  handshake.carries_out_head = (hello.wants & REORIENT_WANT_HEAD) != 0;
  handshake.carries_out_walk = (hello.wants & REORIENT_WANT_WALK) != 0 && body.gait.has_value();
  handshake.carries_out_get_up = (hello.wants & REORIENT_WANT_GET_UP) != 0 && body.get_up_time.has_value();
  return handshake;
}

CameraModel camera_model(const reorient_camera& camera, const Lens& lens) {
  CameraModel model;
  static_cast<Lens&>(model) = lens;
  model.width = camera.width;
  model.height = camera.height;
  model.focal = {camera.focal[0], camera.focal[1]};
  model.center = {camera.center[0], camera.center[1]};
  return model;
}

std::vector<std::byte> identity_of(const Handshake& handshake) {
  RobotBody body = handshake.body;
  // Leave out what a calibration changes: each frame uses the cameras of the client's hello, not those of the engine's
  // start.
  for (CameraMount* const mount : {&body.dimensions.upper, &body.dimensions.lower}) mount->tilt = 0.0;
  const auto leave_out = [](CameraOptics& optics) {
    optics.field_of_view_horizontal = optics.field_of_view_vertical = 1.0;
    static_cast<Lens&>(optics) = Lens();
  };
  leave_out(body.upper_camera);
  if (body.lower_camera) leave_out(*body.lower_camera);
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  out(handshake.own_localization, handshake.carries_out_head, handshake.carries_out_walk, handshake.carries_out_get_up,
      body, handshake.field, handshake.application);
  return bytes;
}

}  // namespace reorient
