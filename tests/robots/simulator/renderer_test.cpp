// SPDX-License-Identifier: MIT
#include "robots/simulator/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/head.h"

namespace reorient {
namespace {

CameraModel camera() {
  CameraModel model = CameraModel::from_fields_of_view(320, 240, from_degrees(56.3), from_degrees(43.7));
  model.k1 = 0.05;
  return model;
}

Isometry3 standing(const Pose2& pose, const HeadAngles& head) {
  return to_isometry(pose) * robot_from_camera(RobotDimensions{}, head, TorsoAttitude{}, 0.25);
}

/// A gray box with one bright stripe on its walls, 0.1 m wide, around a wall coordinate.
Room room_with_stripe(double wall_coordinate) {
  Room room;
  const double perimeter = wall_perimeter(room.shape);
  LinearImage walls(4096, 64, LinearColor::Constant(0.05f));
  for (int i = 0; i < walls.width; ++i) {
    if (std::abs((i + 0.5) * perimeter / walls.width - wall_coordinate) > 0.05) continue;
    for (int j = 0; j < walls.height; ++j) walls.at(i, j) = LinearColor::Constant(2.0f);
  }
  const LinearImage plain(64, 64, LinearColor::Constant(0.05f));
  room.walls = {walls, {}, {perimeter, room.shape.height}, Texture::Edge::wrap};
  room.floor = {plain, {}, floor_extent(room.shape), Texture::Edge::clamp};
  room.ceiling = room.floor;
  return room;
}

const Room& plain_room() {
  static const Room room = room_with_stripe(3.0);
  return room;
}

Scene goals() {
  Scene scene;
  add_goals(scene, FieldDimensions{}, LinearColor::Ones());
  return scene;
}

/// The view of a standing robot.
class View {
 public:
  View(Renderer& renderer, const Pose2& pose, const HeadAngles& head, const Scene& scene)
      : field_from_camera_(standing(pose, head)), frame_(renderer.render(field_from_camera_, scene)) {}

  Eigen::Vector2d pixel_of(const Eigen::Vector3d& point) const {
    const auto pixel = camera().project(field_from_camera_.inverse() * point);
    return pixel ? *pixel : Eigen::Vector2d(-1e9, -1e9);
  }
  bool sees(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d pixel = pixel_of(point);
    return pixel.x() > 3 && pixel.y() > 3 && pixel.x() < 316 && pixel.y() < 236;
  }
  Label label_at(const Eigen::Vector3d& point) const { return frame_.labels[index_at(point)]; }
  double depth_at(const Eigen::Vector3d& point) const { return frame_.depth[index_at(point)]; }
  double depth_of(const Eigen::Vector3d& point) const { return (field_from_camera_.inverse() * point).x(); }
  const Frame& frame() const { return frame_; }

 private:
  std::size_t index_at(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d pixel = pixel_of(point);
    return frame_.row(static_cast<int>(std::lround(pixel.y()))) + static_cast<std::size_t>(std::lround(pixel.x()));
  }

  Isometry3 field_from_camera_;
  const Frame& frame_;
};

View view_in_plain_room(const Pose2& pose, const HeadAngles& head = {}) {
  static Renderer renderer(camera(), FieldDimensions{}, plain_room(), true);
  return {renderer, pose, head, goals()};
}

TEST(Renderer, ShowsThePenaltyMarkWhereTheCameraModelProjectsIt) {
  const View view = view_in_plain_room(Pose2(1.8, 0.2, 0.0), {0.0, 0.1});
  ASSERT_TRUE(view.sees({3.2, 0.0, 0.0}));
  EXPECT_EQ(view.label_at({3.2, 0.0, 0.0}), Label::line);
  EXPECT_EQ(view.label_at({3.2, 0.2, 0.0}), Label::carpet);
  EXPECT_NEAR(view.depth_at({3.2, 0.0, 0.0}), view.depth_of({3.2, 0.0, 0.0}), 0.02);
}

TEST(Renderer, ShowsGoalPostsWhereTheCameraModelProjectsThem) {
  const View view = view_in_plain_room(Pose2(1.5, 0.3, 0.1), {});
  for (const double side : {0.8, -0.8}) {
    for (const double height : {0.03, 0.4, 0.77}) {
      const Eigen::Vector3d post(4.5, side, height);
      ASSERT_TRUE(view.sees(post));
      EXPECT_EQ(view.label_at(post), Label::goal);
      EXPECT_NEAR(view.depth_at(post), view.depth_of(post) - 0.05, 0.03);
    }
    EXPECT_NE(view.label_at({4.5, side * 1.15, 0.4}), Label::goal) << "beside the post";
    EXPECT_NE(view.label_at({4.5, side, 0.95}), Label::goal) << "above the post";
  }
  EXPECT_EQ(view.label_at({4.5, 0.3, 0.8}), Label::goal) << "crossbar";
}

CameraModel camera_with(CameraProjection projection, const std::vector<double>& coefficients, double width_degrees,
                        double height_degrees) {
  Lens lens;
  lens.projection = projection;
  EXPECT_EQ(lens.set_coefficients(coefficients), "");
  return CameraModel::from_fields_of_view(320, 240, from_degrees(width_degrees), from_degrees(height_degrees), lens);
}

/// Goals, a robot, the ball and a shadow, in all directions.
Scene crowded() {
  Scene scene = goals();
  for (const double direction : {0.0, 1.3, 2.9, -1.8})
    add_robot(scene, Pose2(1.6 * std::cos(direction), 1.6 * std::sin(direction), direction), 0.3, 1.0,
              LinearColor(0.5f, 0.1f, 0.1f), LinearColor::Ones());
  add_ball(scene, {0.7, -0.4}, 0.1, LinearColor::Ones());
  return scene;
}

/// Fraction of the pixels that show another thing than a pinhole does in the same direction.
double differing_fraction(const CameraModel& model, const HeadAngles& head) {
  CameraModel pinhole = CameraModel::from_fields_of_view(640, 480, from_degrees(100.0), from_degrees(85.0));
  const Scene scene = crowded();
  const Isometry3 pose = standing({0.1, 0.2, 0.3}, head);
  Renderer expected(pinhole, FieldDimensions{}, plain_room(), true);
  Renderer renderer(model, FieldDimensions{}, plain_room(), true);
  const Frame& reference = expected.render(pose, scene);
  const Frame& frame = renderer.render(pose, scene);
  int seen = 0, differ = 0;
  for (int y = 0; y < model.height; ++y) {
    for (int x = 0; x < model.width; ++x) {
      const Eigen::Vector3d ray = model.ray({x, y});
      const auto there = pinhole.project(ray);
      if (!there || !pinhole.contains(*there)) continue;
      const std::size_t index = frame.row(y) + static_cast<std::size_t>(x);
      const std::size_t other =
          reference.row(static_cast<int>(std::lround(there->y()))) + static_cast<std::size_t>(std::lround(there->x()));
      const double depth = frame.depth[index] * ray.x();  // along the optical axis
      const bool same = frame.labels[index] == reference.labels[other] &&
                        std::abs(depth - reference.depth[other]) < 0.05 * depth + 0.02;
      ++seen;
      differ += same ? 0 : 1;
    }
  }
  EXPECT_GT(seen, 10000);
  return static_cast<double>(differ) / seen;
}

TEST(Renderer, ShowsThroughAnyLensWhatAPinholeShowsInTheSameDirection) {
  for (const HeadAngles& head : {HeadAngles{0.0, 0.2}, HeadAngles{-0.7, 0.4}, HeadAngles{1.5, -0.2}}) {
    const double usual = differing_fraction(camera_with(CameraProjection::pinhole, {0.05, 0.0}, 90.0, 75.0), head);
    EXPECT_LT(usual, 0.05) << "along the edges of things";
    EXPECT_LT(
        differing_fraction(camera_with(CameraProjection::pinhole, {-0.2, 0.05, 0.002, -0.001, 0.01}, 90.0, 75.0), head),
        usual + 0.01);
    EXPECT_LT(
        differing_fraction(camera_with(CameraProjection::fisheye, {0.02, -0.004, 0.001, -0.0002}, 160.0, 130.0), head),
        usual + 0.04);
    EXPECT_LT(differing_fraction(camera_with(CameraProjection::fisheye, {}, 220.0, 180.0), head), usual + 0.05);
    EXPECT_LT(differing_fraction(camera_with(CameraProjection::equirectangular, {}, 180.0, 120.0), head), usual + 0.04);
  }
}

TEST(Renderer, ShowsAGoalPostBesideAndBehindAFisheye) {
  const CameraModel model = camera_with(CameraProjection::fisheye, {}, 220.0, 180.0);
  Renderer renderer(model, FieldDimensions{}, plain_room(), true);
  const Isometry3 pose = standing({4.6, -0.3, 0.0}, {});
  const Frame& frame = renderer.render(pose, goals());
  for (const double height : {0.2, 0.5}) {
    const Eigen::Vector3d seen = pose.inverse() * Eigen::Vector3d(4.5, -0.8, height);
    EXPECT_LT(seen.x(), 0.0);
    const auto pixel = model.project(seen);
    ASSERT_TRUE(pixel && model.contains(*pixel)) << seen.transpose();
    EXPECT_EQ(frame.labels[frame.row(static_cast<int>(std::lround(pixel->y()))) +
                           static_cast<std::size_t>(std::lround(pixel->x()))],
              Label::goal);
  }
}

TEST(Renderer, TurnsTheRaysOfAnyLensDuringReadoutLikeThoseOfAPinhole) {
  const Eigen::Vector3d turning(0.3, -1.0, 2.0);
  for (const CameraModel& model : {camera_with(CameraProjection::fisheye, {}, 160.0, 130.0),
                                   camera_with(CameraProjection::pinhole, {0.0, 0.0, 1e-9, 0.0}, 90.0, 75.0)}) {
    const RayTable at_rest(model);
    RayTable turned = at_rest;
    turned.turn_while_read(at_rest, turning, 0.03);
    for (const int row : {0, 60, 239}) {
      const double time = 0.03 * ((row + 0.5) / 240 - 0.5);
      for (const int column : {5, 160, 310}) {
        const std::size_t pixel = static_cast<std::size_t>(row) * 320 + static_cast<std::size_t>(column);
        const Eigen::Vector3d ray = at_rest.direction(pixel).cast<double>();
        const Eigen::Vector3d expected = ray + (time * turning).cross(ray);
        EXPECT_LT((turned.direction(pixel).cast<double>().normalized() - expected.normalized()).norm(), 1e-5);
        EXPECT_NEAR(turned.length[pixel], turned.direction(pixel).norm(), 1e-5);
      }
    }
  }
}

RC_GTEST_PROP(Renderer, MeasuresTheDepthOfTheCarpetItShows, ()) {
  const Pose2 pose(*rc::gen::inRange(-4000, 2000) * 1e-3, *rc::gen::inRange(-3000, 3000) * 1e-3,
                   *rc::gen::inRange(-3000, 3000) * 1e-3);
  const HeadAngles head = NeckReach().clamp({*rc::gen::inRange(-1500, 1500) * 1e-3, *rc::gen::inRange(0, 400) * 1e-3});
  const View view = view_in_plain_room(pose, head);
  const Pose2 gaze(pose.position, pose.rotation + head.yaw);
  const Eigen::Vector2d ground = gaze * Eigen::Vector2d(1.5, *rc::gen::inRange(-300, 300) * 1e-3);
  const Eigen::Vector3d point(ground.x(), ground.y(), 0.0);
  RC_PRE(view.sees(point) && std::abs(point.x()) < 5.1 && std::abs(point.y()) < 3.6);
  const Label label = view.label_at(point);
  RC_PRE(label != Label::goal);
  RC_ASSERT(label == Label::carpet || label == Label::line);
  RC_ASSERT(std::abs(view.depth_at(point) - view.depth_of(point)) < 0.03);
}

TEST(Renderer, DistinguishesCarpetFloorWallAndCeiling) {
  const View level = view_in_plain_room(Pose2(0.0, 0.0, 0.0), {0.0, 0.0});
  EXPECT_EQ(level.label_at({2.0, 0.3, 0.0}), Label::carpet);
  EXPECT_EQ(level.label_at({7.5, 2.0, 0.0}), Label::floor);
  EXPECT_EQ(level.label_at({8.4, 2.0, 1.5}), Label::wall);
  const View up = view_in_plain_room(Pose2(-7.0, 0.0, 0.0), {0.0, -0.6});
  EXPECT_EQ(up.label_at({3.0, 0.5, 7.0}), Label::ceiling);
}

TEST(Renderer, ShiftsANearWallMoreThanAFarOne) {
  // The stripe is on the wall behind the goal at +x, at y = 1.4 (wall coordinate 7.8). The room is finite, so a robot
  // that walks toward the wall sees the stripe move outwards, exactly to the projection of the point on the wall.
  Renderer renderer(camera(), FieldDimensions{}, room_with_stripe(7.8), false);
  for (const double x : {-6.0, -2.0, 2.0, 4.0}) {
    const View view(renderer, Pose2(x, 0.0, 0.0), {}, Scene{});
    const Eigen::Vector3d stripe(8.4, 1.4, 1.3);
    ASSERT_TRUE(view.sees(stripe));
    const Eigen::Vector2d expected = view.pixel_of(stripe);
    const std::size_t first = view.frame().row(static_cast<int>(std::lround(expected.y())));
    double weight = 0.0;
    double sum = 0.0;
    for (int u = 0; u < 320; ++u) {
      const double light = std::max(0.0f, view.frame().red[first + static_cast<std::size_t>(u)] - 0.06f);
      weight += light;
      sum += light * u;
    }
    ASSERT_GT(weight, 0.0);
    EXPECT_NEAR(sum / weight, expected.x(), 0.5) << "from x = " << x;
  }
}

TEST(Renderer, ShowsARoundWallAtItsDistance) {
  Room room = plain_room();
  room.shape.form = RoomForm::cylinder;
  room.shape.length = 16.0;
  Renderer renderer(camera(), FieldDimensions{}, room, true);
  const View view(renderer, Pose2(-3.0, 2.0, 0.0), {}, Scene{});
  for (const double azimuth : {0.0, 0.2, 0.35}) {
    const Eigen::Vector3d point(8.0 * std::cos(azimuth), 8.0 * std::sin(azimuth), 2.0);
    ASSERT_TRUE(view.sees(point));
    EXPECT_EQ(view.label_at(point), Label::wall);
    EXPECT_NEAR(view.depth_at(point), view.depth_of(point), 0.05);
  }
}

int pixels_of(Label label, const Frame& frame) {
  return static_cast<int>(std::count(frame.labels.begin(), frame.labels.end(), label));
}

TEST(Renderer, HidesThingsBehindARobot) {
  Renderer renderer(camera(), FieldDimensions{}, plain_room(), true);
  const Isometry3 eye = standing(Pose2(0.0, 0.0, 0.0), {0.0, 0.1});
  Scene scene;
  add_ball(scene, {2.0, -0.05}, 0.1, LinearColor::Ones());
  const int free = pixels_of(Label::ball, renderer.render(eye, scene));
  EXPECT_GT(free, 100);
  add_robot(scene, Pose2(1.2, 0.0, kPi), 0.0, 1.0, LinearColor::Ones(), LinearColor::Ones());
  const Frame& frame = renderer.render(eye, scene);
  EXPECT_GT(pixels_of(Label::robot, frame), 1000);
  EXPECT_LT(pixels_of(Label::ball, frame), free / 4);
}

TEST(Renderer, GivesFiniteLightAtEachCameraPose) {
  Renderer renderer(camera(), FieldDimensions{}, plain_room(), false);
  Scene scene;
  add_goals(scene, FieldDimensions{}, LinearColor::Ones());
  add_robot(scene, Pose2(0.1, 0.0, 0.0), 0.0, 1.0, LinearColor::Ones(), LinearColor::Ones());
  for (const double pitch : {-kPi / 2, -0.5, 0.0, kPi / 2}) {
    for (const Eigen::Vector3d& where :
         {Eigen::Vector3d(0.1, 0.0, 0.3), Eigen::Vector3d(50.0, -50.0, -3.0), Eigen::Vector3d(4.5, 0.8, 0.4)}) {
      Isometry3 pose = Isometry3::Identity();
      pose.translation() = where;
      pose.linear() = Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()).toRotationMatrix();
      const Frame& frame = renderer.render(pose, scene);
      for (const float light : frame.green) {
        ASSERT_TRUE(light >= 0.0f && light < 20.0f) << light << " at " << where.transpose() << ", pitch " << pitch;
      }
    }
  }
}

}  // namespace
}  // namespace reorient
