#include "workbench/views/pictures/camera_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "workbench/views/pictures/canvas/ycbcr.h"
#include "workbench/views/pictures/parts/legend.h"

namespace reorient::pictures {
namespace {

constexpr int kImageWidth = 1280;
constexpr double kLegend = 84.0;
constexpr double kCaption = 28.0;
constexpr double kFullBar = 0.6;  // of the pixels: such a bar is as high as its chart
constexpr Color kTile{255, 255, 255, 0.9};
constexpr Color kShadow{0, 0, 0, 0.35};
constexpr Color kProjected{255, 64, 64, 0.9};
constexpr Color kBoundary{255, 225, 40};
constexpr Color kHorizon{190, 120, 255};
constexpr Color kLandmark{90, 240, 255};

// From the image's pixels to the canvas.
struct ImageScale {
  double scale = 1.0;
  double marks = 1.0;  // how large marks are, compared with those in a picture of kImageWidth
  Pixel operator*(const Eigen::Vector2d& pixel) const { return (pixel + Pixel(0.5, 0.5)) * scale; }
  std::vector<Pixel> operator*(const std::vector<Eigen::Vector2d>& pixels) const {
    std::vector<Pixel> result;
    result.reserve(pixels.size());
    for (const Eigen::Vector2d& pixel : pixels) result.push_back(*this * pixel);
    return result;
  }
};

// A light line stays visible on a light ground.
void shadowed(Canvas& canvas, const std::vector<Pixel>& points, Color color, double thickness, double marks = 1.0,
              bool closed = false) {
  canvas.polyline(points, kShadow, marks * (thickness + 2.0), closed);
  canvas.polyline(points, color, marks * thickness, closed);
}

// A chart on a light plate in the middle of the part of the tile that is in view.
void draw_chart(Canvas& canvas, const std::vector<Pixel>& outline, const HistogramBars& bars, const Box& image) {
  if (outline.size() < 3) return;
  Pixel low = outline.front();
  Pixel high = outline.front();
  for (const Pixel& corner : outline) {
    if (!corner.allFinite()) return;
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  low = low.cwiseMax(Pixel(image.left, image.top));
  high = high.cwiseMin(Pixel(image.right(), image.bottom()));
  const Pixel size = high - low;
  if (size.x() < 34.0 || size.y() < 26.0) return;  // too small for a chart that can be read
  const double width = std::min(0.72 * size.x(), 130.0);
  const double height = std::min({0.6 * size.y(), 0.6 * width, 70.0});
  const Pixel middle = (low + high) / 2.0;
  const Box plate{middle.x() - width / 2.0, middle.y() - height / 2.0, width, height};
  canvas.fill_box(plate, palette::plate.with_opacity(0.82));
  draw_histogram(canvas, bars, {plate.left + 4.0, plate.top + 4.0, width - 8.0, height - 8.0}, 0.0, kFullBar);
}

void draw_tiles(Canvas& canvas, const ImageScale& scale, const CameraView& camera, const Box& image) {
  for (const ImageTile& tile : camera.tiles) {
    const std::vector<Pixel> outline = scale * tile.corners;
    if (tile.counted) {
      shadowed(canvas, outline, kTile, 1.5, scale.marks, true);
    } else {
      for (std::size_t i = 0; i < outline.size(); ++i)
        canvas.dashed_line(outline[i], outline[(i + 1) % outline.size()], kTile, scale.marks, 6.0 * scale.marks);
    }
  }
  for (const ImageTile& tile : camera.tiles)
    if (tile.counted) draw_chart(canvas, scale * tile.corners, tile.perceived, image);
}

void draw_features(Canvas& canvas, const ImageScale& scale, const CameraView& camera) {
  const double marks = scale.marks;
  for (const auto& line : camera.projected_lines) canvas.polyline(scale * line, kProjected, 1.5 * marks);
  for (const auto& edge : camera.edges) shadowed(canvas, scale * edge, palette::percept, 3.0, marks);
  for (const auto& line : camera.projected_verticals) canvas.polyline(scale * line, kProjected, 1.5 * marks);
  if (!camera.horizon.empty()) shadowed(canvas, scale * camera.horizon, kHorizon, 2.0, marks);
  if (!camera.boundary.empty()) shadowed(canvas, scale * camera.boundary, kBoundary, 2.0, marks);
  for (const ImageArea& area : camera.obstacles) {
    const Pixel low = scale * Pixel(area.left, area.top);
    const Pixel high = scale * Pixel(area.right, area.bottom);
    const Pixel corners[] = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    canvas.fill(corners, palette::obstacle.with_opacity(0.22));
    canvas.polyline(corners, palette::obstacle, 2.0 * marks, true);
  }
  for (const ImageGoalPost& post : camera.goal_posts) {
    shadowed(canvas, {scale * post.base, scale * post.top}, palette::goal_area, 5.0, marks);
    canvas.disc(scale * post.base, 8.0 * marks, Color{255, 255, 255});
    canvas.disc(scale * post.base, 6.0 * marks, palette::goal_area);
  }
  for (const ImageLinePoint& point : camera.line_points) {
    const Pixel center = scale * point.position;
    const Pixel half = 12.0 * marks * point.normal.normalized();
    canvas.line(center - half, center + half, palette::percept, 1.5 * marks);
    canvas.disc(center, 4.6 * marks, palette::ink.with_opacity(0.6));
    canvas.disc(center, 3.4 * marks, palette::percept);
  }
  for (const ImageLandmark& landmark : camera.landmarks) {
    const Pixel center = scale * landmark.position;
    const double radius = landmark.radius > 0.0 ? landmark.radius * scale.scale : 9.0 * marks;
    canvas.ring(center, radius, kShadow, 5.0 * marks);
    canvas.ring(center, radius, kLandmark, 3.0 * marks);
    TextStyle style;
    style.size = 22.0 * marks;
    style.color = kLandmark;
    style.bold = true;
    style.halo = palette::ink;
    canvas.text(center + Pixel(radius + 4.0 * marks, 0.3 * style.size), landmark.name, style);
  }
  for (const Eigen::Vector2d& particle : camera.view_particles) {
    canvas.disc(scale * particle, 5.2 * marks, Color{255, 255, 255, 0.75});
    canvas.disc(scale * particle, 4.0 * marks, palette::view_particle);
  }
  for (const ImageViewCell& cell : camera.view_cells) {
    constexpr double kWhole = 20.0;  // pixels, of all the belief in one cell; areas go with the shares
    constexpr double kLeast = 0.002;
    if (!(cell.share >= kLeast && cell.share <= 1.0)) continue;
    const double radius = marks * kWhole * std::sqrt(cell.share);
    canvas.disc(scale * cell.position, radius + 1.2 * marks, Color{255, 255, 255, 0.75});
    canvas.disc(scale * cell.position, radius, palette::view_particle);
  }
}

std::vector<LegendEntry> entries(const CameraView& camera) {
  std::vector<LegendEntry> list;
  if (!camera.tiles.empty()) {
    const auto tile = [](Canvas& canvas, const Pixel& center) {
      const Box plate{center.x() - 15.0, center.y() - 9.0, 30.0, 18.0};
      canvas.fill_box(plate, palette::faint_ink);
      canvas.fill_box({plate.left + 1.5, plate.top + 1.5, 27.0, 15.0}, palette::plate);
      HistogramBars sample;
      sample.share = {0.1F, 0.2F, 0.0F, 0.1F, 0.3F, 0.1F, 0.5F, 0.2F, 0.4F, 0.1F, 0.2F, 0.3F, 0.1F, 0.0F};
      draw_histogram(canvas, sample, {plate.left + 3.0, plate.top + 3.0, 24.0, 12.0}, 0.0, kFullBar);
    };
    list.push_back({tile, "wall tiles and their colours"});
  }
  if (!camera.view_particles.empty()) list.push_back(dot_entry(palette::view_particle, 5.0, "view particles"));
  if (!camera.view_cells.empty()) list.push_back(dot_entry(palette::view_particle, 7.0, "view cells"));
  if (!camera.line_points.empty()) {
    const auto point = [](Canvas& canvas, const Pixel& center) {
      canvas.line(center - Pixel(0.0, 10.0), center + Pixel(0.0, 10.0), palette::percept, 1.5);
      canvas.disc(center, 4.0, palette::percept);
    };
    list.push_back({point, "line points"});
  }
  if (!camera.landmarks.empty()) list.push_back(dot_entry(kLandmark, 6.0, "landmarks, ball"));
  if (!camera.projected_lines.empty()) list.push_back(line_entry(kProjected, 2.0, "lines as believed"));
  if (!camera.edges.empty()) list.push_back(line_entry(palette::percept, 3.0, "nearly vertical edges"));
  if (!camera.projected_verticals.empty()) list.push_back(line_entry(kProjected, 2.0, "verticals as expected"));
  if (!camera.goal_posts.empty()) list.push_back(line_entry(palette::goal_area, 5.0, "goal posts"));
  if (!camera.boundary.empty()) list.push_back(line_entry({225, 190, 0}, 3.0, "field boundary"));
  if (!camera.horizon.empty()) list.push_back(line_entry(kHorizon, 3.0, "horizon"));
  if (!camera.obstacles.empty()) list.push_back(patch_entry(palette::obstacle.with_opacity(0.5), "obstacles"));
  return list;
}

void draw_image(Canvas& canvas, const CameraView& camera, const ImageScale& scale, const Box& image) {
  canvas.within(image, [&] {
    canvas.fill_box(image, palette::plate);
    if (!camera.image.empty()) canvas.image(to_picture(camera.image), image);
    draw_tiles(canvas, scale, camera, image);
    draw_features(canvas, scale, camera);
  });
}

}  // namespace

Picture draw_camera_view(const CameraView& camera, const std::string& caption) {
  const bool seen = !camera.image.empty();
  const ImageScale scale{seen ? static_cast<double>(kImageWidth) / camera.image.width : 2.0};
  const double height = seen ? std::clamp(camera.image.height * scale.scale, 90.0, 4000.0) : 960.0;
  const double below = kLegend + (caption.empty() ? 0.0 : kCaption);
  Canvas canvas(kImageWidth, static_cast<int>(std::lround(height + below)));
  draw_image(canvas, camera, scale, {0.0, 0.0, kImageWidth, height});
  double beside = 24.0;
  if (caption.empty()) {
    char time[48];
    std::snprintf(time, sizeof time, "%.1f s", camera.time);
    canvas.text({kImageWidth - 16.0, height + 30.0}, time,
                {.size = 19.0, .color = palette::faint_ink, .align = Align::right});
    beside = 130.0;
  } else {
    const TextStyle style{.size = 19.0, .color = palette::faint_ink};
    canvas.text({16.0, height + kLegend + 12.0}, shortened(caption, kImageWidth - 32.0, style), style);
  }
  draw_legend_rows(canvas, {12.0, height + 9.0, kImageWidth - beside, kLegend - 12.0}, entries(camera));
  return canvas.finish();
}

Picture draw_camera_thumbnail(const CameraView& camera, int width) {
  constexpr double kLeastMarks = 0.35;
  const double scale = camera.image.empty() ? 1.0 : static_cast<double>(width) / camera.image.width;
  const double height = std::clamp(std::round(camera.image.height * scale), 8.0, 4.0 * width);
  Canvas canvas(width, static_cast<int>(height));
  const double marks = std::max(kLeastMarks, static_cast<double>(width) / kImageWidth);
  draw_image(canvas, camera, {scale, marks}, {0.0, 0.0, static_cast<double>(width), height});
  return canvas.finish();
}

}  // namespace reorient::pictures
