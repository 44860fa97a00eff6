#include "perception/field/field_features.h"

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "geometry/head.h"
#include "tests/perception/field/flat_field.h"
#include "tests/perception/field/percept_in.h"

namespace reorient {
namespace {

/// A NAO that stands somewhere on the field, its camera, and where that really is.
struct Stand {
  CameraModel camera;
  Isometry3 robot_from_camera;
  Pose2 field_from_robot;

  Stand(int width, int height, const Pose2& pose, const HeadAngles& head, const TorsoAttitude& torso = {})
      : camera(CameraModel::from_fields_of_view(width, height, from_degrees(56.3), from_degrees(43.7))),
        robot_from_camera(reorient::robot_from_camera({}, head, torso, RobotDimensions{}.torso_height)),
        field_from_robot(pose) {}

  Image see(const FlatField& scene) const {
    return render(scene, camera, to_isometry(field_from_robot) * robot_from_camera);
  }
};

FieldPercept percept_of(const FlatField& scene, const Stand& stand) {
  FieldFeatures features({}, scene.field);
  const Image image = stand.see(scene);
  return percept_in(features, image.view(), stand.camera, stand.robot_from_camera);
}

/// What a field of these colors shows to a robot that has stood there for some images.
FieldPercept percept_after(const FlatField& scene, const Stand& stand, int images) {
  FieldFeatures features({}, scene.field);
  const Image image = stand.see(scene);
  FieldPercept percept;
  for (int i = 0; i < images; ++i) percept = percept_in(features, image.view(), stand.camera, stand.robot_from_camera);
  return percept;
}

bool is_empty(const FieldPercept& percept) {
  return percept.line_points.empty() && percept.goal_posts.empty() && percept.obstacles.empty();
}

/// Share of line points that lie on a true line, and of those whose normal is that line's.
void expect_line_points_on_lines(const FieldPercept& percept, const FlatField& scene, const Stand& stand) {
  int misplaced = 0;
  int twisted = 0;
  for (const LinePoint& point : percept.line_points) {
    const NearestLine line = nearest_line(scene.field, stand.field_from_robot * point.position);
    const double turned = normalize_angle(2.0 * (point.normal + stand.field_from_robot.rotation - line.normal)) / 2.0;
    misplaced += line.distance > 0.05 + 0.03 * point.position.norm() ? 1 : 0;
    twisted += std::abs(turned) > from_degrees(10.0) ? 1 : 0;
    EXPECT_GT(point.normal, -0.5 * kPi);
    EXPECT_LE(point.normal, 0.5 * kPi);
  }
  const double count = static_cast<double>(percept.line_points.size());
  EXPECT_LE(misplaced, 0.02 * count) << "of " << count;
  EXPECT_LE(twisted, 0.15 * count) << "of " << count;
}

class FieldFeaturesAtEveryResolution : public testing::TestWithParam<int> {
 protected:
  Stand stand(const Pose2& pose, const HeadAngles& head = {0.0, 0.25}) const {
    return {GetParam(), GetParam() * 3 / 4, pose, head};
  }
};

TEST_P(FieldFeaturesAtEveryResolution, PutLinePointsOnTheLinesAround) {
  const FlatField scene;
  const Pose2 poses[] = {
      {-2.0, 0.0, 0.0}, {2.0, 0.5, 0.3}, {-3.2, 3.5, -0.5 * kPi}, {0.0, -1.5, 2.0}, {3.0, 1.0, -2.5}};
  for (const Pose2& pose : poses) {
    SCOPED_TRACE(testing::Message() << pose.position.transpose() << " " << pose.rotation);
    const Stand here = stand(pose);
    const FieldPercept percept = percept_of(scene, here);
    EXPECT_GE(percept.line_points.size(), 10u);
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeNoLinePointsWhereThereAreNoLines) {
  FlatField scene = FlatField::with_goals();
  scene.lines = false;
  for (const Pose2& pose : {Pose2{-2.0, 0.0, 0.0}, Pose2{2.5, 0.5, 0.1}, Pose2{3.0, 0.0, -0.2}}) {
    EXPECT_TRUE(percept_of(scene, stand(pose)).line_points.empty());
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeBothPostsOfAGoalWhereTheyStand) {
  const FlatField scene = FlatField::with_goals();
  for (const double x : {1.0, 1.8, 2.4}) {
    const Stand here = stand({x, 0.0, 0.0}, {0.0, 0.1});
    const FieldPercept percept = percept_of(scene, here);
    ASSERT_EQ(percept.goal_posts.size(), 2u) << "from x = " << x;
    for (const GoalPost& post : percept.goal_posts) {
      const Eigen::Vector2d seen = here.field_from_robot * post.position;
      const Eigen::Vector2d real(4.5, std::copysign(0.8, seen.y()));
      EXPECT_TRUE(post.base_visible);
      EXPECT_LT((seen - real).norm(), 0.1 * (4.5 - x)) << seen.transpose();
    }
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeTheBorderOfTheCarpet) {
  const FlatField scene;
  const Stand here = stand({0.0, 0.0, 0.0}, {0.0, 0.0});
  const FieldPercept percept = percept_of(scene, here);
  ASSERT_EQ(percept.boundary.size(), static_cast<std::size_t>(CarpetMap::kColumns));
  const auto border = here.camera.project(here.robot_from_camera.inverse() * Eigen::Vector3d(5.2, 0.0, 0.0));
  ASSERT_TRUE(border);
  EXPECT_NEAR(percept.boundary[CarpetMap::kColumns / 2], border->y(), 2.0 + here.camera.height / 240.0);
}

TEST_P(FieldFeaturesAtEveryResolution, SeeARobotAsAnObstacleAndNotAsAPost) {
  FlatField scene;
  scene.boxes.push_back({{2.0, 0.2}, 0.25, 0.55, {200, 126, 130}});
  const FieldPercept percept = percept_of(scene, stand({0.0, 0.0, 0.0}));
  EXPECT_TRUE(percept.goal_posts.empty());
  ASSERT_EQ(percept.obstacles.size(), 1u);
  EXPECT_NEAR(percept.obstacles[0].position.x(), 1.875, 0.2);
  EXPECT_NEAR(percept.obstacles[0].position.y(), 0.2, 0.1);
  for (const LinePoint& point : percept.line_points) {
    EXPECT_FALSE(point.pixel.x() > percept.obstacles[0].left && point.pixel.x() < percept.obstacles[0].right &&
                 point.pixel.y() < percept.obstacles[0].bottom);
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeNothingWhenTheyLookUpAtTheRoom) {
  EXPECT_TRUE(is_empty(percept_of(FlatField::with_goals(), stand({4.0, 0.0, 0.0}, {0.0, -0.67}))));
}

TEST_P(FieldFeaturesAtEveryResolution, KeepTheLinesUnderDimAndTintedLight) {
  FlatField scene;
  for (const auto& [gain, tint] : {std::pair{0.45, 0.0}, {1.2, 0.0}, {0.9, 0.06}, {0.9, -0.06}}) {
    const auto lit = [&, g = gain, t = tint](const Ycbcr& c) {
      return Ycbcr{static_cast<std::uint8_t>(std::min(255.0, g * c.y)),
                   static_cast<std::uint8_t>(128 + g * (c.cb - 128) - t * g * c.y),
                   static_cast<std::uint8_t>(128 + g * (c.cr - 128) + t * g * c.y)};
    };
    scene.colors = {lit(Colors{}.carpet), lit(Colors{}.line), lit(Colors{}.wall), lit(Colors{}.post)};
    const Stand here = stand({-2.0, 0.0, 0.0});
    const FieldPercept percept = percept_of(scene, here);
    EXPECT_GE(percept.line_points.size(), 10u) << gain << " " << tint;
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST_P(FieldFeaturesAtEveryResolution, SeeTheYellowGoalsOf2013) {
  FlatField scene = FlatField::with_goals();
  scene.field.yellow_goals = true;
  for (Box& post : scene.boxes) post.color = {150, 70, 140};
  const Stand here = stand({1.8, 0.0, 0.0}, {0.0, 0.1});
  EXPECT_EQ(percept_of(scene, here).goal_posts.size(), 2u);
  scene.field.yellow_goals = false;
  EXPECT_TRUE(percept_of(scene, here).goal_posts.empty());
}

TEST_P(FieldFeaturesAtEveryResolution, GuessWhereAPostStandsWhoseFootIsBelowTheImage) {
  const FlatField scene = FlatField::with_goals();
  const Stand down = stand({3.0, 0.8, 0.0}, {0.0, 0.25});
  const Stand close = stand({3.6, 0.8, 0.0}, {0.0, -0.05});
  FieldFeatures features({}, scene.field);
  const Image carpet = down.see(scene);
  percept_in(features, carpet.view(), down.camera, down.robot_from_camera);
  const Image image = close.see(scene);
  const FieldPercept percept = percept_in(features, image.view(), close.camera, close.robot_from_camera);
  ASSERT_EQ(percept.goal_posts.size(), 1u);
  EXPECT_FALSE(percept.goal_posts[0].base_visible);
  EXPECT_NEAR(percept.goal_posts[0].position.x(), 0.9, 0.2);
  EXPECT_NEAR(percept.goal_posts[0].position.y(), 0.0, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Resolutions, FieldFeaturesAtEveryResolution, testing::Values(640, 320, 160));

TEST(FieldFeatures, SeePostsFarAwayWithACameraWhoseTiltIsNotAsTheyThink) {
  const FlatField scene = FlatField::with_goals();
  for (const double x : {-1.5, -3.0, -4.2}) {
    for (const double tilt : {-1.5, 0.0, 1.5}) {
      SCOPED_TRACE(testing::Message() << "from x = " << x << ", " << tilt << " degrees");
      const Stand here(640, 480, {x, 0.0, 0.0}, {0.0, 0.1});
      const Stand thought(640, 480, {x, 0.0, 0.0}, {0.0, 0.1 + from_degrees(tilt)});
      FieldFeatures features({}, scene.field);
      const Image image = here.see(scene);
      const FieldPercept percept = percept_in(features, image.view(), here.camera, thought.robot_from_camera);
      ASSERT_EQ(percept.goal_posts.size(), 2u);
      for (const GoalPost& post : percept.goal_posts) {
        const Eigen::Vector2d real =
            Eigen::Vector2d(4.5, std::copysign(0.8, post.position.y())) - Eigen::Vector2d(x, 0);
        EXPECT_NEAR(direction_of(post.position), direction_of(real), from_degrees(1.0));
        EXPECT_NEAR(post.position.norm(), real.norm(), 0.12 * real.norm());
      }
    }
  }
}

TEST(FieldFeatures, TakeNoPoleFarAwayForAPost) {
  FlatField scene;
  scene.boxes = {{{4.5, 0.8}, 0.1, 2.5, scene.colors.post}, {{4.5, -0.8}, 0.1, 1.3, scene.colors.post}};
  for (const double x : {-1.5, -3.0}) {
    const FieldPercept percept = percept_of(scene, Stand(640, 480, {x, 0.0, 0.0}, {0.0, 0.1}));
    EXPECT_TRUE(percept.goal_posts.empty()) << "from x = " << x;
  }
}

TEST(FieldFeatures, TakeNoLetterOnAGreenBannerForAPost) {
  const Stand here(640, 480, {3.6, 0.0, 0.0}, {0.0, 0.0});  // close to the border, and a floor of wood behind it
  const FlatField field;
  Image image = here.see(field);
  const auto fill = [&](double left, double right, double top, double bottom, const Ycbcr& color) {
    for (int v = 0; v < image.height(); ++v) {
      for (int u = 0; u + 1 < image.width(); u += 2) {
        if (u < left || u >= right || v < top || v >= bottom) continue;
        std::uint8_t* pair = image.row(v) + 2 * u;
        pair[0] = pair[2] = color.y;
        pair[1] = color.cb;
        pair[3] = color.cr;
      }
    }
  };
  // Letters as tall as a post at 6 m, with their feet where it would stand.
  const auto pixel = [&](double x, double y, double z) {
    return *here.camera.project(here.robot_from_camera.inverse() * Eigen::Vector3d(x, y, z));
  };
  const double foot = pixel(6.0, 0.0, 0.0).y(), top = pixel(6.0, 0.0, 0.8).y();
  const auto draw = [&](const Ycbcr& floor) {
    fill(0, 640, top - 20, foot + 40, field.colors.carpet);
    fill(0, 640, foot + 40, 480, floor);
    for (const double y : {0.5, -0.5})
      fill(pixel(6.0, y + 0.05, 0.0).x(), pixel(6.0, y - 0.05, 0.0).x(), top, foot, {200, 126, 130});
  };
  FieldFeatures features({}, field.field);
  const auto posts_on = [&](const Ycbcr& floor) {
    percept_in(features, here.see(field).view(), here.camera, here.robot_from_camera);  // the carpet
    draw(floor);
    return percept_in(features, image.view(), here.camera, here.robot_from_camera).goal_posts.size();
  };
  EXPECT_EQ(posts_on({110, 108, 150}), 0u);
  EXPECT_EQ(posts_on(field.colors.carpet), 2u) << "on carpet they are posts";
}

TEST(FieldFeatures, TakeNothingBeyondTheBorderForTheCarpetWhateverItsColor) {
  FlatField scene;
  const Stand here(640, 480, {0.0, 0.0, 0.0}, {0.0, 0.0});
  const FieldPercept bare = percept_of(scene, here);
  scene.boxes = {{{6.0, 2.2}, 1.2, 0.4, scene.colors.carpet}};  // a low banner
  const FieldPercept percept = percept_of(scene, here);
  ASSERT_EQ(percept.boundary.size(), bare.boundary.size());
  for (std::size_t i = 0; i < bare.boundary.size(); ++i) EXPECT_NEAR(percept.boundary[i], bare.boundary[i], 8.0) << i;
}

TEST(FieldFeatures, TellCarpetFromAGrayWallInTintedLight) {
  FlatField scene;
  scene.colors = {{60, 116, 106}, {200, 128, 88}, {60, 128, 116}, {200, 128, 88}};  // cyan: white is -40, gray -12
  const Stand here(640, 480, {0.0, 0.0, 0.0}, {0.0, 0.1});
  const FieldPercept percept = percept_after(scene, here, 5);
  const auto border = here.camera.project(here.robot_from_camera.inverse() * Eigen::Vector3d(5.2, 0.0, 0.0));
  ASSERT_TRUE(border);
  EXPECT_NEAR(percept.boundary[CarpetMap::kColumns / 2], border->y(), 4.0);
  EXPECT_GE(percept.line_points.size(), 30u);
}

TEST(FieldFeatures, SeeLinesWithATorsoThatSways) {
  const FlatField scene;
  for (const double roll : {-0.15, 0.1}) {
    const Stand here(640, 480, {-2.0, 0.3, 0.1}, {0.3, 0.2}, {roll, 0.05});
    const FieldPercept percept = percept_of(scene, here);
    EXPECT_GE(percept.line_points.size(), 10u);
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST(FieldFeatures, SeeNothingFromTheGround) {
  const Stand upright(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  const Image image = upright.see(FlatField::with_goals());
  FieldFeatures features({}, {});
  for (const TorsoAttitude& torso : {TorsoAttitude{0.5 * kPi, 0.0}, TorsoAttitude{-0.5 * kPi, 0.0},
                                     TorsoAttitude{0.0, 0.5 * kPi}, TorsoAttitude{0.0, -0.5 * kPi}}) {
    EXPECT_TRUE(is_empty(percept_in(features, image.view(), upright.camera, robot_from_camera({}, {}, torso, 0.1))));
  }
}

TEST(FieldFeatures, AreTheSameForTheSameImages) {
  const Stand here(320, 240, {-1.0, 1.0, 0.4}, {0.0, 0.2});
  const Image image = here.see(FlatField::with_goals());
  FieldFeatures one({}, {});
  FieldFeatures other({}, {});
  const FieldPercept a = percept_in(one, image.view(), here.camera, here.robot_from_camera);
  const FieldPercept b = percept_in(other, image.view(), here.camera, here.robot_from_camera);
  ASSERT_EQ(a.line_points.size(), b.line_points.size());
  ASSERT_FALSE(a.line_points.empty());
  for (std::size_t i = 0; i < a.line_points.size(); ++i)
    EXPECT_EQ(a.line_points[i].position, b.line_points[i].position);
}

TEST(FieldFeatures, KeepTheCarpetsColourWhenTheyLookAway) {
  const FlatField scene = FlatField::with_goals();
  const Stand down(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  const Stand up(320, 240, {-2.0, 0.0, 0.0}, {0.0, -0.6});
  FieldFeatures features({}, scene.field);
  const Image carpet = down.see(scene);
  const Image room = up.see(scene);
  percept_in(features, carpet.view(), down.camera, down.robot_from_camera);
  percept_in(features, room.view(), up.camera, up.robot_from_camera);
  EXPECT_EQ(features.carpet_color().surface(160, 200, {75, 105, 108}), Surface::carpet);
  EXPECT_EQ(features.carpet_color().surface(160, 200, {190, 126, 130}), Surface::other);
}

TEST(FieldFeatures, DoNotTakeAGreyHallForTheCarpet) {
  const FlatField scene = FlatField::with_goals();
  const Stand down(160, 120, {3.0, 0.8, 0.0}, {0.0, 0.25});
  const Stand close(160, 120, {3.6, 0.8, 0.0}, {0.0, -0.05});
  FieldFeatures features({}, scene.field);
  const Image carpet = down.see(scene);
  const Image hall = close.see(scene);
  percept_in(features, carpet.view(), down.camera, down.robot_from_camera);
  for (int i = 0; i < 20; ++i) percept_in(features, hall.view(), close.camera, close.robot_from_camera);
  EXPECT_NEAR(features.carpet_color().luma(), 75.0, 15.0);
  EXPECT_EQ(features.carpet_color().surface(80, 100, {95, 132, 134}), Surface::other);
}

TEST(FieldFeatures, SeeTheSameLinesOnACarpetOfAnyColor) {
  const Stand here(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  const std::size_t on_green = percept_after(scene, here, 5).line_points.size();
  ASSERT_GE(on_green, 20u);
  // Yellowish, cyan, blue, red, gray; then green whose lines are as red, as blue, or as green as it.
  for (const auto& [carpet, line] : {std::pair{Ycbcr{75, 100, 126}, Ycbcr{190, 126, 130}},
                                     {{75, 134, 108}, {190, 126, 130}},
                                     {{75, 150, 118}, {190, 126, 130}},
                                     {{75, 118, 160}, {190, 126, 130}},
                                     {{75, 128, 128}, {190, 128, 128}},
                                     {{75, 110, 116}, {190, 115, 165}},
                                     {{75, 110, 116}, {190, 165, 115}},
                                     {{75, 105, 108}, {190, 105, 108}}}) {
    scene.colors.carpet = carpet;
    scene.colors.line = line;
    const FieldPercept percept = percept_after(scene, here, CarpetColor::kPatience + 5);
    EXPECT_GE(percept.line_points.size(), on_green * 9 / 10)
        << int{carpet.cb} << " " << int{carpet.cr} << ", lines " << int{line.cb} << " " << int{line.cr};
    expect_line_points_on_lines(percept, scene, here);
  }
}

TEST(FieldFeatures, TakeNoBrightCarpetForALineOnceTheyKnowWhite) {
  const Stand here(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  FieldFeatures features({}, scene.field);
  const Image lines = here.see(scene);
  percept_in(features, lines.view(), here.camera, here.robot_from_camera);
  scene.colors.line = {150, 84, 90};  // sunlit carpet
  const Image sunlit = here.see(scene);
  EXPECT_TRUE(percept_in(features, sunlit.view(), here.camera, here.robot_from_camera).line_points.empty());
}

TEST(FieldFeatures, TakeNoFloorForACarpetThatWasNeverSeenUntilAWhileHasPassed) {
  const Stand here(160, 120, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  scene.colors.carpet = {110, 108, 150};  // wood
  EXPECT_TRUE(is_empty(percept_after(scene, here, CarpetColor::kPatience - 1)));
  EXPECT_FALSE(is_empty(percept_after(scene, here, CarpetColor::kPatience)));
}

TEST(FieldFeatures, GiveUpTheirCarpetForAnotherGreenAtOnceAndForAFloorAfterAWhile) {
  const Stand here(160, 120, {-2.0, 0.0, 0.0}, {0.0, 0.25});
  FlatField scene;
  FieldFeatures features({}, scene.field);
  const auto look = [&](const Ycbcr& carpet, int images) {
    scene.colors.carpet = carpet;
    const Image image = here.see(scene);
    for (int i = 0; i < images; ++i) percept_in(features, image.view(), here.camera, here.robot_from_camera);
    return features.carpet_color().surface(80, 100, carpet);
  };
  constexpr Ycbcr kGreen{75, 105, 108}, kDarkGreen{40, 118, 112}, kWood{110, 108, 150}, kOlive{70, 121, 126};
  look(kGreen, 1);
  EXPECT_EQ(look(kOlive, 20), Surface::other);
  EXPECT_EQ(look(kDarkGreen, 1), Surface::carpet);
  EXPECT_EQ(look(kWood, 250), Surface::other);
  EXPECT_EQ(look(kWood, 60), Surface::carpet);
  EXPECT_EQ(look(kGreen, 1), Surface::carpet);
}

TEST(FieldFeatures, ThatWereSavedGoOnTheSameWhereNoGroundIsInView) {
  const Stand here(320, 240, {-2.0, 0.0, 0.0}, {0.0, 0.25}), up(320, 240, {-2.0, 0.0, 0.0}, {0.0, -0.6});
  FlatField scene;
  scene.colors.carpet = {75, 110, 116};
  scene.colors.line = {190, 115, 165};  // white is learned behind the carpet
  FieldFeatures one({}, scene.field), other({}, scene.field);
  const Image lines = here.see(scene), room = up.see(scene);
  percept_in(one, lines.view(), here.camera, here.robot_from_camera);
  std::vector<std::byte> bytes;
  ByteWriter writer(bytes);
  one.archive(writer);
  ByteReader reader(bytes);
  other.archive(reader);
  for (FieldFeatures* each : {&one, &other}) percept_in(*each, room.view(), up.camera, up.robot_from_camera);
  for (int cb = 64; cb < 192; cb += 2) {
    for (int cr = 64; cr < 192; cr += 2) {
      const Ycbcr color{70, static_cast<std::uint8_t>(cb), static_cast<std::uint8_t>(cr)};
      ASSERT_EQ(one.carpet_color().surface(160, 200, color), other.carpet_color().surface(160, 200, color));
    }
  }
}

}  // namespace
}  // namespace reorient
