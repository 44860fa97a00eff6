// SPDX-License-Identifier: MIT
// Labels of images of real fields, the images recolored, and the score of the field vision on them.
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "geometry/camera_attitude.h"
#include "geometry/head.h"
#include "tests/paths.h"
#include "tests/perception/field/filled_image.h"
#include "tests/perception/field/picture_file.h"
#include "tests/shared_data.h"
#include "workbench/field_images/field_labels.h"
#include "workbench/field_images/field_score.h"
#include "workbench/field_images/recoloring.h"
#include "workbench/field_images/still_image.h"

namespace reorient {
namespace {

const std::string kImage = R"([[images]]
name = "a.png"
digest = "0123456789abcdef"
width = 640
field_of_view = 60
pitch = 20
)";

std::string complaint_about(const std::string& text) {
  try {
    parse_field_labels(text, "l.toml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(FieldLabels, ThatAreShippedCanBeRead) {
  const auto all = load_field_labels(std::filesystem::path(kSourceFolder) / "assets/labels/field_images.toml");
  ASSERT_EQ(all.size(), 3u);
  for (const FieldLabels& one : all) {
    EXPECT_GE(one.lines.size(), 3u) << one.name;
    EXPECT_EQ(labels_of(all, one.digest), &one);
  }
  EXPECT_EQ(labels_of(all, "0000000000000000"), nullptr);
}

TEST(FieldLabels, AreReadAsTheyAreWritten) {
  const auto all = parse_field_labels(kImage + R"(
roll = -3
raw = [640, 480, 36]
lines = [[1, 2, 3, 4, 5, 6], [7, 8, 9, 10]]
posts = [[100, 200, 101, 50]]
balls = [[20, 30, 5.5]]
feet = [[0, 0, 1, 0, 1, 1]]
)",
                                      "l.toml");
  ASSERT_EQ(all.size(), 1u);
  const FieldLabels& one = all[0];
  EXPECT_EQ(one.digest, "0123456789abcdef");
  EXPECT_NEAR(one.roll, from_degrees(-3.0), 1e-12);
  ASSERT_TRUE(one.raw);
  EXPECT_EQ(one.raw->header, 36u);
  ASSERT_EQ(one.lines.size(), 2u);
  EXPECT_EQ(one.lines[0][2], Eigen::Vector2d(5, 6));
  EXPECT_EQ(one.posts[0].top, Eigen::Vector2d(101, 50));
  EXPECT_EQ(one.balls[0].radius, 5.5);
  EXPECT_EQ(one.feet[0].size(), 3u);
}

TEST(FieldLabels, ThatMakeNoSenseAreRefusedWithTheirLine) {
  EXPECT_EQ(complaint_about(kImage), "");
  EXPECT_NE(complaint_about("images = []").find("l.toml:1: images: expected one or more tables [[images]], found []"),
            std::string::npos);
  EXPECT_NE(complaint_about("").find("expected the key 'images', found none"), std::string::npos);
  for (const auto& [text, why] :
       {std::pair{"lines = [[1, 2, 3]]", "each of lines: expected a list of 2 or more points"},
        {"lines = [[1, 2]]", "each of lines: expected a list of 2 or more points: [u, v, ...], found [1, 2]"},
        {"lines = 5", "lines: expected a list of lists of numbers, found 5"},
        {"lines = [[1, 2, \"3\", 4]]", "each of lines: expected a number"},
        {"lines = [[1, 2, nan, 4]]", "expected a number from"},
        {"boards = [[1, 2, 3, 4]]", "each of boards: expected a list of 3 or more points"},
        {"balls = [[1, 2, 0]]", "each of balls: expected [u, v, radius], found [1, 2, 0]"},
        {"posts = [[1, 2]]", "each of posts: expected a list of 4 numbers, found [1, 2]"},
        {"raw = [0, 480, 36]", "raw: expected [width, height, bytes of the header], found [0, 480, 36]"},
        {"roll = 90", "roll: expected a number from -89 to 89, found 90"},
        {"line = []", "unknown key 'line' (did you mean 'lines'?)"}}) {
    const std::string found = complaint_about(kImage + text);
    EXPECT_NE(found.find("l.toml:7"), std::string::npos) << text << ": " << found;
    EXPECT_NE(found.find(why), std::string::npos) << text << ": " << found;
  }
  EXPECT_NE(complaint_about(kImage + kImage).find("expected different digests, found '"), std::string::npos);
}

TEST(Recoloring, WithoutAChangeLeavesEachByteUnchanged) {
  const Image image = filled(16, 8, {75, 105, 108});
  EXPECT_EQ(recolored(image.view(), {}).bytes(), image.bytes());
}

TEST(Recoloring, ChangesWhatItSays) {
  const Image gray = filled(64, 48, {100, 128, 128});
  const auto color_of = [&](const Recoloring& how) { return recolored(gray.view(), how).view().at(32, 24); };
  EXPECT_EQ(color_of({.cr = 16}), (Ycbcr{100, 128, 144}));
  EXPECT_EQ(color_of({.cb = -8}), (Ycbcr{100, 120, 128}));
  // Of gray 100: red 150, so luma 114.95, Cr 0.713 (150 - 114.95), Cb 0.564 (100 - 114.95).
  EXPECT_EQ(color_of({.red = 1.5}), (Ycbcr{115, 120, 153}));
  EXPECT_EQ(color_of({.gamma = 2.0}), (Ycbcr{39, 128, 128}));  // 255 (100 / 255)^2
  const Image colored = filled(64, 48, {100, 118, 108});
  EXPECT_EQ(recolored(colored.view(), {.saturation = 0.5}).view().at(0, 0), (Ycbcr{100, 123, 118}));
  const Image dark = recolored(gray.view(), {.vignetting = 0.6});
  EXPECT_EQ(dark.view().at(0, 0).y, 40);
  EXPECT_EQ(dark.view().at(32, 24).y, 100);
}

/// A robot before the center circle, and labels of the halfway line as it should appear.
class FieldScoring : public testing::Test {
 protected:
  FieldScoring() : camera_(camera_of(labels_, 640, 480)), here_(with_attitude(level(), labels_.pitch, 0.0)) {}

  static Isometry3 level() { return robot_from_camera({}, {}, {}, RobotDimensions{}.torso_height); }
  static FieldLabels labels() {
    FieldLabels labels;
    labels.width = 640;
    labels.field_of_view = from_degrees(56.3);
    labels.pitch = from_degrees(20.0);
    labels.lines = {{{0, 200}, {639, 200}}};
    return labels;
  }
  GroundProjection view() const { return *GroundProjection::look(camera_, here_); }
  FieldScore score(const FieldPercept& percept) const { return score_of(percept, labels_, view(), 4.5); }
  static FieldPercept points_at(std::initializer_list<Eigen::Vector2f> pixels) {
    FieldPercept percept;
    for (const Eigen::Vector2f& pixel : pixels) percept.line_points.push_back({Eigen::Vector2d::Zero(), 0.0, pixel});
    return percept;
  }

  FieldLabels labels_ = labels();
  CameraModel camera_;
  Isometry3 here_;
};

TEST_F(FieldScoring, FindsAllOfALineWhosePointsAreDenseAndNothingOfOneWithout) {
  const LineScore none = score({}).lines.at(0);
  EXPECT_GT(none.pieces, 15);
  EXPECT_EQ(none.found, 0);
  FieldPercept percept;
  for (int u = 0; u < 640; u += 8)
    percept.line_points.push_back({Eigen::Vector2d::Zero(), 0.0, {static_cast<float>(u), 202.0f}});
  const FieldScore all = score(percept);
  EXPECT_EQ(all.lines.at(0).found, none.pieces);
  EXPECT_EQ(all.on_lines, 80);
  percept.line_points.resize(40);
  const double half = score(percept).lines.at(0).recall();
  EXPECT_NEAR(half, 0.5, 0.05);
}

TEST_F(FieldScoring, CountsPointsByWhereTheyAre) {
  labels_.balls = {{{300, 300}, 20}};
  labels_.boards = {{{0, 0}, {640, 0}, {640, 100}, {0, 100}}};
  labels_.ignored = {{{500, 400}, {600, 400}, {600, 450}, {500, 450}}};
  labels_.posts = {{{50, 150}, {50, 60}}};
  const FieldScore seen =
      score(points_at({{320, 199}, {310, 305}, {20, 50}, {52, 120}, {400, 400}, {550, 420}, {320, 206}}));
  EXPECT_EQ(seen.line_points, 6) << "one is in an ignored area";
  EXPECT_EQ(seen.on_lines, 1);
  EXPECT_EQ(seen.in_masks, 3);
  EXPECT_EQ(seen.elsewhere(), 2);
}

TEST_F(FieldScoring, LeavesOutWhatIsTooFarAwayToBeLookedFor) {
  EXPECT_EQ(score_of({}, labels_, view(), 0.5).lines.at(0).pieces, 0);
  EXPECT_EQ(score_of({}, labels_, view(), 0.5).lines.at(0).recall(), 1.0);
}

TEST_F(FieldScoring, MatchesPostsByTheirFeet) {
  labels_.posts = {{{100, 150}, {100, 60}}, {{400, 150}, {400, 60}}};
  FieldPercept percept;
  const Eigen::Vector2d anywhere = Eigen::Vector2d::Zero();
  percept.goal_posts = {{anywhere, true, {104, 150}, {100, 60}}, {anywhere, true, {250, 150}, {250, 60}}};
  const FieldScore seen = score(percept);
  EXPECT_EQ(seen.posts, 2);
  EXPECT_EQ(seen.posts_found, 1);
  EXPECT_EQ(seen.false_posts, 1);
}

TEST_F(FieldScoring, ComparesTheBoundaryWithTheLowerEdgeOfTheBoards) {
  labels_.boards = {{{0, 0}, {319, 0}, {319, 100}, {0, 100}}, {{0, 0}, {100, 0}, {100, 50}, {0, 50}}};
  FieldPercept percept;
  percept.boundary = {107.0f, 93.0f, 300.0f, 0.0f};  // in the middle of a quarter each; none is labeled on the right
  FieldScore seen = score(percept);
  EXPECT_EQ(seen.border_columns, 2);
  EXPECT_EQ(seen.border_found, 2);
  percept.boundary[0] = 50.0f;
  EXPECT_EQ(score(percept).border_found, 1);
}

TEST_F(FieldScoring, MatchesObstaclesByTheFeetBelowThem) {
  labels_.feet = {{{100, 150}, {140, 150}, {120, 250}}, {{400, 150}, {440, 150}, {420, 250}}};
  FieldPercept percept;
  Obstacle on_feet, elsewhere;
  on_feet.left = 110, on_feet.right = 150;
  elsewhere.left = 300, elsewhere.right = 340;
  percept.obstacles = {on_feet, elsewhere};
  const FieldScore seen = score(percept);
  EXPECT_EQ(seen.robots, 2);
  EXPECT_EQ(seen.robots_found, 1);
  EXPECT_EQ(seen.false_obstacles, 1);
}

TEST_F(FieldScoring, ScalesLabelsToTheImage) {
  labels_.width = 1280;
  labels_.lines = {{{0, 400}, {1279, 400}}};
  EXPECT_EQ(score(points_at({{320, 199}})).on_lines, 1);
  EXPECT_EQ(score(points_at({{320, 209}})).on_lines, 0);
}

class RecoloredImages : public SharedDataTest {
 protected:
  RecoloredImages() : SharedDataTest("images") {}

  static FieldScore look(const Image& image, const FieldLabels& labels) {
    const CameraModel camera = camera_of(labels, image.width(), image.height());
    const Isometry3 here =
        with_attitude(robot_from_camera({}, {}, {}, RobotDimensions{}.torso_height), labels.pitch, labels.roll);
    const FieldPercept percept = percept_of_still_image(image.view(), camera, here, {}, {});
    return score_of(percept, labels, *GroundProjection::look(camera, here), FieldFeatureParameters().line_range);
  }
};

TEST_F(RecoloredImages, ShowTheSame) {
  const auto all = load_field_labels(std::filesystem::path(kSourceFolder) / "assets/labels/field_images.toml");
  for (const FieldLabels& labels : all) {
    const std::filesystem::path file = folder() / labels.name;
    const Image image =
        labels.raw ? read_yuyv(file, labels.raw->width, labels.raw->height, labels.raw->header) : read_png(file);
    const FieldScore plain = look(image, labels);
    FieldScore pooled;
    const std::optional<std::size_t> faint =
        labels.name == "nao-v4-top-640x480-a.png" ? std::optional(2u) : std::nullopt;
    int faint_found = 0;
    EXPECT_GE(plain.on_lines, 50) << labels.name;
    for (const Recoloring& recoloring : usual_recolorings()) {
      SCOPED_TRACE(labels.name + ", " + recoloring.name);
      const FieldScore seen = look(recolored(image.view(), recoloring), labels);
      EXPECT_GE(seen.on_lines, 0.7 * plain.on_lines);
      for (std::size_t i = 0; i < seen.lines.size(); ++i) {
        if (faint == i) {  // a touchline close to the boards
          faint_found += seen.lines[i].recall() >= 0.75 ? 1 : 0;
          continue;
        }
        EXPECT_GE(seen.lines[i].recall(), 0.75 * plain.lines[i].recall()) << "line " << i;
      }
      EXPECT_EQ(seen.in_masks, 0);
      EXPECT_EQ(seen.elsewhere(), 0);
      EXPECT_EQ(seen.false_posts, 0);
      EXPECT_EQ(seen.robots_found, seen.robots);
      EXPECT_EQ(seen.false_obstacles, 0);
      pooled = pooled + seen;
    }
    if (faint) {
      EXPECT_GE(faint_found, 20);
    }
    EXPECT_GE(pooled.border_found, 0.9 * pooled.border_columns) << labels.name;
    EXPECT_GE(pooled.posts_found, 0.85 * pooled.posts) << labels.name;
  }
}

}  // namespace
}  // namespace reorient
