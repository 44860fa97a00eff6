#include "workbench/views/pictures/camera_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/pictures/canvas/palette.h"
#include "workbench/views/pictures/canvas/ycbcr.h"

namespace reorient::pictures {
namespace {

// Uniform, so that only what is drawn over it stands out.
Image plain_image(int width, int height, Ycbcr color) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width / 2; ++x) {
      std::uint8_t* pair = image.row(y) + 4 * static_cast<std::ptrdiff_t>(x);
      pair[0] = pair[2] = color.y;
      pair[1] = color.cb;
      pair[3] = color.cr;
    }
  }
  return image;
}

constexpr Ycbcr kSkin{150, 110, 150};

TEST(CameraView, shows_the_image_in_its_colours_at_any_resolution) {
  for (const int width : {160, 320, 640, 1280}) {
    const Image image = plain_image(width, width * 3 / 4, kSkin);
    CameraView camera;
    camera.image = image.view();
    const Picture picture = draw_camera_view(camera);
    EXPECT_EQ(picture.width, 1280);
    EXPECT_GE(picture.height, 960);
    EXPECT_EQ(count(picture, to_color(kSkin), 0, 0, 1280, 960), 1280 * 960);
  }
}

TEST(CameraView, draws_marks_at_their_pixels) {
  const Image image = plain_image(320, 240, kSkin);
  CameraView camera;
  camera.image = image.view();
  camera.view_particles = {{100.0, 50.0}};
  camera.line_points = {{{200.0, 150.0}, {0.0, 3.0}}};
  camera.goal_posts = {{{50.0, 200.0}, {50.0, 100.0}}};
  const Picture picture = draw_camera_view(camera);
  // Pixel (0, 0) of the image is the centre of a square of 4 x 4 here.
  EXPECT_TRUE(alike(picture.at(402, 202), palette::view_particle));
  EXPECT_TRUE(alike(picture.at(802, 602), palette::percept));
  EXPECT_TRUE(alike(picture.at(802, 611), palette::percept, 90));  // along the normal
  EXPECT_TRUE(alike(picture.at(811, 602), to_color(kSkin)));
  EXPECT_TRUE(alike(picture.at(202, 802), palette::goal_area));
  EXPECT_TRUE(alike(picture.at(202, 600), palette::goal_area));
  EXPECT_TRUE(alike(picture.at(202, 380), to_color(kSkin)));
}

TEST(CameraView, draws_cells_of_a_grid_by_their_share) {
  const Image image = plain_image(320, 240, kSkin);
  CameraView camera;
  camera.image = image.view();
  camera.view_cells = {{{100.0, 50.0}, 0.4}, {{200.0, 50.0}, 0.1}, {{150.0, 50.0}, 0.001}};
  const Picture picture = draw_camera_view(camera);
  const int greatest = count(picture, palette::view_particle, 380, 180, 424, 224);
  EXPECT_GT(greatest, 300);
  EXPECT_NEAR(count(picture, palette::view_particle, 780, 180, 824, 224), 0.25 * greatest, 0.125 * greatest);
  EXPECT_EQ(count(picture, palette::view_particle, 580, 180, 624, 224), 0);
}

TEST(CameraView, draws_a_chart_only_in_tiles_that_count) {
  const Image image = plain_image(640, 480, kSkin);
  CameraView camera;
  camera.image = image.view();
  ImageTile tile{{{100.0, 100.0}, {200.0, 100.0}, {200.0, 200.0}, {100.0, 200.0}}, {}, true};
  tile.perceived.share[9] = 0.6F;
  camera.tiles = {tile};
  EXPECT_GT(count(draw_camera_view(camera), bin_color(9), 200, 200, 400, 400), 50);
  camera.tiles[0].counted = false;
  const Picture uncounted = draw_camera_view(camera);
  EXPECT_EQ(count(uncounted, bin_color(9), 200, 200, 400, 400), 0);
  EXPECT_LT(count(uncounted, to_color(kSkin), 195, 195, 407, 207), 212 * 12 - 100);  // its outline
}

TEST(CameraView, never_draws_over_the_legend) {
  const Image image = plain_image(640, 480, kSkin);
  CameraView camera;
  camera.image = image.view();
  camera.projected_lines = {{{320.0, 100.0}, {321.0, 1e7}}, {{-1e9, 300.0}, {1e9, 300.0}}};
  camera.obstacles = {{100.0, 400.0, 500.0, 10000.0}};
  const Picture picture = draw_camera_view(camera);
  EXPECT_GT(count(picture, palette::page, 600, 961, 1280, picture.height), 680 * 70);
  EXPECT_GT(count(picture, palette::page, 640, 962, 660, picture.height), 20 * 70);
  EXPECT_LT(count(picture, to_color(kSkin), 0, 600, 1280, 602), 600);  // the endless line is there
}

TEST(CameraView, draws_without_an_image) {
  const Picture picture = draw_camera_view({});
  EXPECT_EQ(count(picture, palette::plate, 0, 0, 1280, 960), 1280 * 960);
}

TEST(CameraView, leaves_out_what_is_not_a_number) {
  const Image image = plain_image(320, 240, kSkin);
  CameraView camera;
  camera.image = image.view();
  const Eigen::Vector2d bad(kNaN, 10.0);
  camera.tiles = {{{bad, bad, bad}, {}, true}, {{}, {}, true}, {{bad, {1.0, 1.0}, {50.0, 60.0}}, {}, false}};
  camera.view_particles = {bad};
  camera.view_cells = {{bad, 1.0}, {{10.0, 10.0}, kNaN}};
  camera.line_points = {{bad, bad}};
  camera.goal_posts = {{bad, bad}};
  camera.obstacles = {{kNaN, kNaN, 3.0, kNaN}};
  camera.boundary = {bad, bad};
  camera.projected_lines = {{bad, bad}, {}};
  const Picture picture = draw_camera_view(camera);
  // All but the one side of the third tile that has two good ends.
  EXPECT_GT(count(picture, to_color(kSkin), 0, 0, 1280, 960), 1280 * 960 - 3000);
  EXPECT_EQ(count(picture, to_color(kSkin), 240, 0, 1280, 960), 1040 * 960);
}

}  // namespace
}  // namespace reorient::pictures
