// SPDX-License-Identifier: MIT
// The default room: a sports hall on a tournament day. Each of its four walls has its own theme (a stand full of
// people, windows, a stage, a wooden sports wall). The seed selects the order of themes, the colors and all details.
#include <array>
#include <cmath>
#include <utility>

#include "geometry/random.h"
#include "robots/simulator/room/room.h"
#include "robots/simulator/room/room_images.h"
#include "robots/simulator/room/texture_painter.h"

namespace reorient {
namespace {

constexpr double kWallTexelsPerMeter = 60.0;
constexpr double kCeilingTexelsPerMeter = 30.0;
constexpr double kFloorTexelsPerMeter = 40.0;

const LinearColor kNearBlack(0.012f, 0.012f, 0.014f);
const LinearColor kSteel(0.16f, 0.17f, 0.18f);
const LinearColor kWhitePaint(0.62f, 0.61f, 0.58f);
const LinearColor kSkin(0.36f, 0.20f, 0.13f);
const LinearColor kDaylight(2.2f, 2.5f, 3.0f);
const LinearColor kLamp(9.0f, 8.6f, 7.8f);

/// One wall, painted as seen from inside: x from its left end, y up from the floor, meters.
class Wall {
 public:
  Wall(TexturePainter& canvas, double begin, double end, double height)
      : canvas_(&canvas), end_(end), width_(end - begin), height_(height) {}

  double width() const { return width_; }
  double height() const { return height_; }
  Area all() const { return {0.0, 0.0, width_, height_}; }

  void rectangle(const Area& area, const LinearColor& color, double opacity = 1.0) {
    canvas_->rectangle(mirrored(area), color, opacity);
  }
  void ellipse(double x, double y, double radius_x, double radius_y, const LinearColor& color) {
    canvas_->ellipse(end_ - x, y, radius_x, radius_y, color);
  }
  void shade(const Area& area, double below, double above) { canvas_->shade(mirrored(area), below, above); }
  void mottle(const Area& area, double strength, double size, Random& random) {
    canvas_->mottle(mirrored(area), strength, size, random);
  }

 private:
  // The wall coordinate grows to the left.
  Area mirrored(const Area& area) const {
    const double left = std::clamp(area.left, 0.0, width_);
    const double right = std::clamp(area.right, left, width_);
    return {end_ - right, area.bottom, end_ - left, area.top};
  }

  TexturePainter* canvas_;
  double end_;
  double width_;
  double height_;
};

/// The colors of the decoration. The hues are far apart, so that no two walls have the same ones.
struct Palette {
  double hue;

  LinearColor strong(int i, double value = 0.75) const { return paint_of(hue + 0.21 * i, 0.85, value); }
  LinearColor pale(int i, double value = 0.7) const { return paint_of(hue + 0.21 * i, 0.25, value); }
};

LinearColor any_cloth(Random& random) { return any_paint(Range{}, {0.1, 0.9}, {0.15, 0.8}, random); }

/// Blocks that look like writing from a distance: letters of one height.
void write(Wall& wall, const Area& area, const LinearColor& color, Random& random) {
  const double letter = 0.62 * area.height();
  for (double x = area.left; x + 0.8 * letter < area.right; x += letter) {
    if (random.uniform() < 0.14) continue;  // between words
    const double stem = 0.22 * letter;
    if (random.uniform() < 0.8) wall.rectangle({x, area.bottom, x + stem, area.top}, color);
    if (random.uniform() < 0.6) wall.rectangle({x, area.top - stem, x + 0.8 * letter, area.top}, color);
    if (random.uniform() < 0.6) wall.rectangle({x + 0.58 * letter, area.bottom, x + 0.8 * letter, area.top}, color);
    if (random.uniform() < 0.5) wall.rectangle({x, area.bottom, x + 0.8 * letter, area.bottom + stem}, color);
  }
}

void banner(Wall& wall, const Area& area, const LinearColor& ground, const LinearColor& sign, Random& random) {
  wall.rectangle({area.left + 0.03, area.bottom - 0.04, area.right + 0.03, area.top}, kNearBlack, 0.4);  // its shadow
  wall.rectangle(area, ground);
  const double size = std::min(area.width(), area.height());
  if (area.width() > 1.6 * area.height()) {
    wall.ellipse(area.left + 0.5 * size, area.bottom + 0.5 * size, 0.34 * size, 0.34 * size, sign);
    write(wall, {area.left + size, area.bottom + 0.3 * size, area.right - 0.2 * size, area.top - 0.3 * size}, sign,
          random);
  } else {
    wall.ellipse(area.left + 0.5 * area.width(), area.top - 0.6 * size, 0.36 * size, 0.36 * size, sign);
    wall.ellipse(area.left + 0.5 * area.width(), area.top - 0.6 * size, 0.2 * size, 0.2 * size, ground);
    for (double y = area.bottom + 0.15; y + 0.12 < area.top - 1.1 * size; y += 0.3) {
      write(wall, {area.left + 0.1 * size, y, area.right - 0.1 * size, y + 0.14}, sign, random);
    }
  }
  wall.mottle(area, 0.05, 0.4, random);
}

void person(Wall& wall, double x, double seat, const LinearColor& cloth, Random& random) {
  const double lean = random.uniform(-0.05, 0.05);
  const LinearColor skin = kSkin * static_cast<float>(random.uniform(0.35, 1.5));
  const LinearColor hair = any_paint(0.08, {0.2, 0.7}, {0.08, 0.6}, random);
  wall.ellipse(x, seat + 0.26, 0.23, 0.36, cloth);
  wall.ellipse(x + lean, seat + 0.70, 0.10, 0.135, hair);
  wall.ellipse(x + lean, seat + 0.67, 0.085, 0.11, skin);
}

void door(Wall& wall, double x, const LinearColor& leaf, Random& random) {
  wall.rectangle({x - 0.1, 0.0, x + 2.1, 2.2}, kSteel);
  wall.rectangle({x, 0.0, x + 0.97, 2.1}, leaf);
  wall.rectangle({x + 1.03, 0.0, x + 2.0, 2.1}, leaf);
  if (random.uniform() < 0.6) {
    wall.rectangle({x + 0.3, 1.2, x + 0.67, 1.8}, LinearColor(0.5f, 0.6f, 0.65f));
    wall.rectangle({x + 1.33, 1.2, x + 1.7, 1.8}, LinearColor(0.5f, 0.6f, 0.65f));
  }
  wall.rectangle({x + 0.6, 2.32, x + 1.4, 2.6}, LinearColor(0.05f, 0.75f, 0.28f));  // exit sign, lit
  wall.rectangle({x + 0.7, 2.4, x + 1.0, 2.52}, LinearColor(1.0f, 1.2f, 1.1f));
  wall.rectangle({x + 2.35, 0.9, x + 2.6, 1.5}, LinearColor(0.5f, 0.02f, 0.02f));  // fire extinguisher
}

void boards(Wall& wall, double left, double right, double height, const Palette& palette, Random& random) {
  int i = static_cast<int>(random.below(4));
  for (double x = left; x < right - 0.5; ++i) {
    const double next = std::min(right, x + random.uniform(1.6, 3.2));
    const bool light = random.uniform() < 0.5;
    const LinearColor ground = light ? LinearColor(kWhitePaint) : palette.strong(i, 0.6);
    wall.rectangle({x, 0.0, next, height}, ground);
    write(wall, {x + 0.2, 0.3 * height, next - 0.2, 0.72 * height},
          light ? palette.strong(i, 0.55) : LinearColor(kWhitePaint), random);
    wall.rectangle({next - 0.04, 0.0, next, height}, kNearBlack);
    x = next;
  }
}

void stand(Wall& wall, const Palette& palette, Random& random) {
  wall.rectangle(wall.all(), palette.pale(0, 0.5));
  wall.mottle(wall.all(), 0.06, 1.2, random);
  const double left = random.uniform(0.4, 0.18 * wall.width());
  const double right = wall.width() - random.uniform(0.3, 0.1 * wall.width());
  constexpr int kRows = 5;
  constexpr double kRise = 0.52;
  const LinearColor seat = palette.strong(1, 0.6);
  for (int row = kRows - 1; row >= 0; --row) {  // back row first
    const double step = 0.75 + kRise * row;
    wall.rectangle({left, 0.0, right, step}, LinearColor(kSteel * 0.55f));
    wall.rectangle({left, step - 0.06, right, step}, kSteel);
    const double busy = random.uniform(0.45, 0.85);
    for (double x = left + 0.35; x < right - 0.3; x += 0.55) {
      const double from_aisle = std::abs(std::fmod(x - left, 5.5) - 5.1);
      if (from_aisle < 0.45) {
        wall.rectangle({x - 0.25, step - kRise, x + 0.3, step}, LinearColor(0.4f, 0.38f, 0.3f));
        continue;
      }
      wall.rectangle({x - 0.22, step, x + 0.22, step + 0.42}, seat);
      if (random.uniform() < busy) {
        const LinearColor cloth = random.uniform() < 0.35 ? palette.strong(2, 0.7) : any_cloth(random);
        person(wall, x + random.uniform(-0.06, 0.06), step + 0.1, cloth, random);
      }
    }
  }
  boards(wall, left, right, 0.75, palette, random);
  const double above = 0.75 + kRise * kRows + 0.9;
  for (double x = left + 0.4; x + 2.6 < right; x += random.uniform(3.2, 4.4)) {
    const int i = static_cast<int>(random.below(4));
    banner(wall, {x, above, x + random.uniform(2.0, 2.8), above + random.uniform(0.7, 1.0)}, palette.strong(i),
           kWhitePaint, random);
  }
}

void windows(Wall& wall, const Palette& palette, Random& random) {
  wall.rectangle(wall.all(), LinearColor(0.46f, 0.44f, 0.38f));
  wall.rectangle({0.0, 0.0, wall.width(), 1.3}, palette.strong(0, 0.5));
  wall.rectangle({0.0, 1.3, wall.width(), 1.38}, kWhitePaint);
  wall.mottle(wall.all(), 0.05, 0.9, random);
  constexpr double kBay = 2.4;
  int bay = 0;
  for (double x = 0.35; x + kBay - 0.3 < wall.width(); x += kBay, ++bay) {
    const bool blind = random.uniform() < 0.25;
    const Area pane{x, 1.9, x + kBay - 0.45, 4.6};
    wall.rectangle(pane, kSteel);
    for (int part = 0; part < 2; ++part) {
      const double half = 0.5 * (pane.width() - 0.18);
      const double left = pane.left + 0.06 + part * (half + 0.06);
      const Area glass{left, pane.bottom + 0.06, left + half, pane.top - 0.06};
      wall.rectangle(glass, blind ? LinearColor(0.5f, 0.42f, 0.25f) : LinearColor(kDaylight * 0.5f));
      if (blind) continue;
      wall.shade(glass, 0.45, 1.6);
      // Trees and houses outside.
      for (int i = 0; i < 4; ++i) {
        const double wide = random.uniform(0.15, 0.4);
        const LinearColor leaves = paint_of(random.uniform(0.2, 0.4), 0.6, 0.45);
        const double high = random.uniform(0.15, 0.3);
        const double middle =
            std::clamp(random.uniform(glass.left, glass.right), glass.left + wide, glass.right - wide);
        wall.ellipse(middle, glass.bottom + 0.3, wide, high, leaves);
      }
      wall.rectangle({glass.left, glass.top - 0.9, glass.right, glass.top - 0.85}, kSteel);
    }
    wall.rectangle({x + kBay - 0.4, 0.0, x + kBay - 0.05, wall.height()}, LinearColor(0.3f, 0.29f, 0.27f));  // pillar
    if (random.uniform() < 0.4) {                                                                            // radiator
      wall.rectangle({x + 0.2, 0.2, x + 1.6, 0.9}, kWhitePaint);
      for (double rib = x + 0.3; rib < x + 1.55; rib += 0.16) wall.rectangle({rib, 0.24, rib + 0.04, 0.86}, kSteel);
    }
  }
  const double long_banner = random.uniform(0.25, 0.55) * wall.width();
  banner(wall, {long_banner, 4.8, long_banner + 3.6, 5.8}, palette.strong(2), palette.pale(0, 0.9), random);
}

void stage(Wall& wall, const Palette& palette, Random& random) {
  wall.rectangle(wall.all(), LinearColor(0.05f, 0.05f, 0.055f));
  const LinearColor curtain = palette.strong(0, 0.42);
  for (double x = 0.0; x < wall.width(); x += 0.34) {  // folds
    const double bright = random.uniform(0.5, 1.2);
    wall.rectangle({x, 0.2, x + 0.2, 4.6}, curtain * static_cast<float>(bright));
    wall.rectangle({x + 0.2, 0.2, x + 0.34, 4.6}, curtain * static_cast<float>(0.4 * bright));
  }
  wall.shade({0.0, 0.0, wall.width(), 4.6}, 0.75, 1.15);
  const double center = random.uniform(0.38, 0.62) * wall.width();
  const Area screen{center - 1.9, 1.2, center + 1.9, 3.4};
  wall.rectangle(screen.inset(-0.12), kNearBlack);
  wall.rectangle(screen, LinearColor(0.75f, 0.85f, 1.0f));
  wall.rectangle({screen.left, screen.top - 0.5, screen.right, screen.top}, LinearColor(palette.strong(1) * 1.6f));
  write(wall, {screen.left + 0.2, screen.top - 0.38, screen.right - 0.6, screen.top - 0.12},
        LinearColor(1.3f, 1.3f, 1.3f), random);
  for (int i = 0; i < 5; ++i) {
    const double x = screen.left + 0.3 + 0.68 * i;
    wall.rectangle({x, screen.bottom + 0.2, x + 0.4, screen.bottom + random.uniform(0.4, 1.4)}, palette.strong(i));
  }
  wall.rectangle({0.0, 4.6, wall.width(), 4.9}, kSteel);  // truss
  for (double x = 0.2; x < wall.width(); x += 0.3) {
    wall.rectangle({x, 4.66, x + 0.14, 4.84}, kNearBlack);
    if (random.uniform() < 0.25) wall.ellipse(x, 4.45, 0.12, 0.14, paint_of(random.uniform(), 0.6, 2.2));
  }
  for (const double x : {center - 3.1, center + 2.5}) {  // loudspeakers
    wall.rectangle({x, 0.0, x + 0.6, 1.9}, kNearBlack);
    wall.ellipse(x + 0.3, 1.4, 0.2, 0.2, LinearColor(kSteel * 0.6f));
    wall.ellipse(x + 0.3, 0.7, 0.24, 0.24, LinearColor(kSteel * 0.6f));
  }
  door(wall, random.uniform() < 0.5 ? 0.7 : wall.width() - 3.5, LinearColor(0.3f, 0.31f, 0.33f), random);
}

void sports_wall(Wall& wall, const Palette& palette, Random& random) {
  wall.rectangle(wall.all(), LinearColor(0.5f, 0.48f, 0.43f));
  const LinearColor wood(0.34f, 0.18f, 0.075f);
  for (double x = 0.0; x < wall.width(); x += 0.6) {
    wall.rectangle({x, 0.0, x + 0.6, 2.7}, wood * static_cast<float>(random.uniform(0.75, 1.25)));
    wall.rectangle({x + 0.58, 0.0, x + 0.6, 2.7}, LinearColor(wood * 0.3f));
  }
  wall.rectangle({0.0, 2.7, wall.width(), 3.0}, palette.strong(0, 0.65));
  wall.mottle(wall.all(), 0.07, 0.5, random);
  const double bars = random.uniform(0.05, 0.2) * wall.width();  // wall bars
  for (double y = 0.25; y < 2.6; y += 0.17)
    wall.rectangle({bars, y, bars + 3.0, y + 0.06}, LinearColor(0.62f, 0.42f, 0.2f));
  for (int i = 0; i <= 3; ++i) {
    wall.rectangle({bars + i, 0.1, bars + i + 0.06, 2.65}, LinearColor(0.2f, 0.1f, 0.04f));
  }
  door(wall, random.uniform(0.5, 0.6) * wall.width(), palette.strong(1, 0.5), random);
  const double hoop = 0.82 * wall.width();
  wall.rectangle({hoop - 0.9, 2.9, hoop + 0.9, 3.95}, kWhitePaint);
  wall.rectangle({hoop - 0.3, 3.05, hoop + 0.3, 3.5}, LinearColor(0.6f, 0.06f, 0.03f));
  wall.rectangle({hoop - 0.25, 3.1, hoop + 0.25, 3.45}, kWhitePaint);
  wall.rectangle({hoop - 0.23, 2.98, hoop + 0.23, 3.04}, LinearColor(0.75f, 0.2f, 0.03f));
  const double score = random.uniform(0.3, 0.42) * wall.width();
  wall.rectangle({score, 3.5, score + 2.6, 4.7}, kNearBlack);
  for (int i = 0; i < 4; ++i) {
    write(wall, {score + 0.25 + 0.6 * i, 3.75, score + 0.75 + 0.6 * i, 4.3}, LinearColor(1.6f, 0.25f, 0.03f), random);
  }
  const double mats = random.uniform(0.24, 0.3) * wall.width();  // gymnastic mats, leaning at the wall
  for (int i = 0; i < 3; ++i) {
    wall.rectangle({mats + 0.35 * i, 0.0, mats + 0.35 * i + 0.3, 1.9}, paint_of(0.6, 0.8, 0.35 + 0.1 * i));
  }
  int i = 0;
  for (double x = 0.6; x < 0.28 * wall.width(); x += 1.15, ++i) {
    banner(wall, {x, 3.2, x + 0.8, 5.2}, palette.strong(i + 2), palette.pale(i, 0.9), random);
  }
}

TexturePainter paint_walls(const RoomShape& shape, const Palette& palette, Random& random) {
  TexturePainter canvas(wall_perimeter(shape), shape.height, kWallTexelsPerMeter, kSteel);
  using Theme = void (*)(Wall&, const Palette&, Random&);
  std::array<Theme, 4> themes{stand, windows, stage, sports_wall};
  for (std::size_t i = themes.size() - 1; i > 0; --i) std::swap(themes[i], themes[random.below(i + 1)]);
  for (int side = 0; side < 4; ++side) {
    Wall wall(canvas, wall_begin(shape, side), wall_begin(shape, side + 1), shape.height);
    themes[static_cast<std::size_t>(side)](wall, {palette.hue + 0.13 * side}, random);
    wall.rectangle({0.0, 5.9, wall.width(), shape.height}, LinearColor(0.2f, 0.2f, 0.2f), 0.85);
    wall.shade({0.0, 0.0, 0.5, shape.height}, 0.8, 0.75);  // corners are darker
    wall.shade({wall.width() - 0.5, 0.0, wall.width(), shape.height}, 0.8, 0.75);
    wall.shade({0.0, 0.0, wall.width(), 0.25}, 0.55, 1.0);
    wall.shade(wall.all(), 0.8, 1.1);
  }
  return canvas;
}

/// Paints a banner with a width of `shape.mark` meters on the middle of the wall along the touchline at -y, at a height
/// that the robot sees. In a symmetric room only the banner differs after a rotation by 180 degrees.
LinearImage with_mark(LinearImage walls, const RoomShape& shape, const Palette& palette, Random& random) {
  constexpr int kSide = 3;
  constexpr double kBottom = 1.0, kTop = 2.5;  // m
  TexturePainter canvas(wall_perimeter(shape), shape.height, std::move(walls));
  Wall wall(canvas, wall_begin(shape, kSide), wall_begin(shape, kSide + 1), shape.height);
  const double half = 0.5 * std::min(shape.mark, wall.width());
  const double middle = 0.5 * wall.width();
  banner(wall, {middle - half, kBottom, middle + half, kTop}, palette.strong(0), kWhitePaint, random);
  return canvas.image();
}

TexturePainter paint_ceiling(const RoomShape& shape, Random& random) {
  const Eigen::Vector2d extent = floor_extent(shape);
  TexturePainter canvas(extent.x(), extent.y(), kCeilingTexelsPerMeter, LinearColor(0.2f, 0.19f, 0.17f));
  const Area all{0.0, 0.0, extent.x(), extent.y()};
  canvas.mottle(all, 0.06, 0.8, random);
  for (double y = 0.15; y < extent.y(); y += 0.5)
    canvas.rectangle({0.0, y, extent.x(), y + 0.04}, LinearColor(0.12f, 0.11f, 0.1f));
  for (double x = 1.2; x < extent.x(); x += 2.8) {  // beams
    canvas.rectangle({x, 0.0, x + 0.35, extent.y()}, LinearColor(0.09f, 0.1f, 0.12f));
    canvas.rectangle({x + 0.12, 0.0, x + 0.2, extent.y()}, LinearColor(0.22f, 0.23f, 0.25f));
  }
  const double duct = random.uniform(0.15, 0.35) * extent.y();  // ventilation, on one side only
  canvas.rectangle({0.0, duct, extent.x(), duct + 0.7}, LinearColor(0.42f, 0.43f, 0.45f));
  for (double x = 0.5; x < extent.x(); x += 1.1) canvas.rectangle({x, duct, x + 0.05, duct + 0.7}, kSteel);
  for (double x = 2.4; x < extent.x() - 1.0; x += 2.8) {
    for (double y = 1.6; y < extent.y() - 0.8; y += 2.4) {
      if (random.uniform() < 0.12) continue;  // broken lamps
      canvas.rectangle({x, y, x + 1.3, y + 0.32}, kSteel);
      canvas.rectangle({x + 0.05, y + 0.04, x + 1.25, y + 0.28}, kLamp);
    }
  }
  return canvas;
}

TexturePainter paint_floor(const RoomShape& shape, const Palette& palette, Random& random) {
  const Eigen::Vector2d extent = floor_extent(shape);
  TexturePainter canvas(extent.x(), extent.y(), kFloorTexelsPerMeter, LinearColor(0.23f, 0.145f, 0.08f));
  for (double y = 0.0; y < extent.y(); y += 0.12) {  // planks
    for (double x = -random.uniform(0.0, 1.5); x < extent.x(); x += 1.5) {
      canvas.rectangle({x, y, x + 1.49, y + 0.115},
                       LinearColor(0.26f, 0.165f, 0.09f) * static_cast<float>(random.uniform(0.8, 1.15)));
    }
  }
  const LinearColor court = palette.strong(3, 0.7);
  canvas.rectangle({0.8, 0.8, extent.x() - 0.8, 0.85}, court);
  canvas.rectangle({0.8, extent.y() - 0.85, extent.x() - 0.8, extent.y() - 0.8}, court);
  canvas.rectangle({0.8, 0.8, 0.85, extent.y() - 0.8}, LinearColor(kWhitePaint));
  canvas.rectangle({extent.x() - 0.85, 0.8, extent.x() - 0.8, extent.y() - 0.8}, LinearColor(kWhitePaint));
  canvas.mottle({0.0, 0.0, extent.x(), extent.y()}, 0.08, 0.7, random);
  return canvas;
}

}  // namespace

Room procedural_hall(std::uint64_t seed, const RoomShape& shape) {
  check(shape);
  enum Stream : std::uint64_t { kColors = 0x4a11, kWalls, kCeiling, kFloor, kMark };
  const Palette palette{Random(seed, kColors).uniform()};
  Random wall_random(seed, kWalls);
  Random ceiling_random(seed, kCeiling);
  Random floor_random(seed, kFloor);
  RoomImages images{paint_walls(shape, palette, wall_random).image(), paint_ceiling(shape, ceiling_random).image(),
                    paint_floor(shape, palette, floor_random).image()};
  make_symmetric(images, shape);
  if (shape.mark > 0.0) {
    Random mark_random(seed, kMark);
    images.walls = with_mark(std::move(images.walls), shape, palette, mark_random);
  }
  return room_of(std::move(images), "hall", shape, LinearColor(0.56f, 0.55f, 0.52f));
}

}  // namespace reorient
