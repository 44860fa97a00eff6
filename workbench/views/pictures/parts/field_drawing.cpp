#include "workbench/views/pictures/parts/field_drawing.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"

namespace reorient::pictures {
namespace {

class LinePainter {
 public:
  LinePainter(Canvas& canvas, const FieldView& view, double line_width)
      : canvas_(canvas), view_(view), thickness_(std::max(1.5, line_width * view.pixels_per_metre)) {}

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    canvas_.line(view_ * from, view_ * to, palette::field_line, thickness_);
  }

  void rectangle(double x1, double y1, double x2, double y2) {
    const Pixel corners[] = {view_ * Eigen::Vector2d(x1, y1), view_ * Eigen::Vector2d(x2, y1),
                             view_ * Eigen::Vector2d(x2, y2), view_ * Eigen::Vector2d(x1, y2)};
    canvas_.polyline(corners, palette::field_line, thickness_, true);
  }

  void circle(double radius) {
    canvas_.ring(view_.center, radius * view_.pixels_per_metre, palette::field_line, thickness_);
  }

  /// `turn`: rad at which it begins; it goes on for a quarter.
  void quarter(const Eigen::Vector2d& center, double radius, double turn) {
    const std::vector<Pixel> points = arc(view_ * center, radius * view_.pixels_per_metre, turn, turn + 0.5 * kPi);
    if (!points.empty()) canvas_.polyline(points, palette::field_line, thickness_);
  }

  void cross(double x, double size) {
    line({x - size / 2.0, 0.0}, {x + size / 2.0, 0.0});
    line({x, -size / 2.0}, {x, size / 2.0});
  }

 private:
  Canvas& canvas_;
  const FieldView& view_;
  double thickness_;
};

void draw_goal(Canvas& canvas, const FieldView& view, const FieldDimensions& field, double side) {
  const double front = side * field.length / 2.0;
  const double back = front + side * field.goal_depth;
  const Pixel net[] = {
      view * Eigen::Vector2d(front, field.goal_post_y), view * Eigen::Vector2d(back, field.goal_post_y),
      view * Eigen::Vector2d(back, -field.goal_post_y), view * Eigen::Vector2d(front, -field.goal_post_y)};
  const Color posts = field.yellow_goals ? Color{255, 214, 10} : Color{255, 255, 255};
  canvas.fill(net, posts.with_opacity(0.28));
  canvas.polyline(net, posts.with_opacity(0.8), 1.0);
  const double radius = std::max(2.5, field.goal_post_diameter / 2.0 * view.pixels_per_metre);
  for (const double y : {field.goal_post_y, -field.goal_post_y}) {
    const Pixel post = view * Eigen::Vector2d(front, y);
    canvas.disc(post, radius + 1.0, palette::ink);
    canvas.disc(post, radius, posts);
  }
}

void draw_robot_at(Canvas& canvas, const Pixel& center, double heading, double radius, double wedge, Color color) {
  if (wedge > 0.0) {
    std::vector<Pixel> sector = arc(center, wedge, heading - kPi / 6.0, heading + kPi / 6.0);
    if (sector.empty()) return;
    sector.push_back(center);
    canvas.fill(sector, color.with_opacity(0.38));
    canvas.polyline(sector, color.with_opacity(0.8), 1.0, true);
  }
  const Pixel forward(std::cos(heading), -std::sin(heading));
  const Pixel left(forward.y(), -forward.x());
  const auto draw_body = [&](double size, Color body) {
    const Pixel nose[] = {center + 1.85 * size * forward, center + 0.9 * size * left + 0.42 * size * forward,
                          center - 0.9 * size * left + 0.42 * size * forward};
    canvas.fill(nose, body);
    canvas.disc(center, size, body);
  };
  draw_body(radius + 2.0, Color{255, 255, 255});
  draw_body(radius, color);
  canvas.disc(center, 2.6, Color{255, 255, 255});
}

}  // namespace

FieldView FieldView::fitted(const FieldDimensions& field, const Box& box) {
  const double scale =
      std::min(box.width / (field.length + 2.0 * field.border), box.height / (field.width + 2.0 * field.border));
  return {box.center(), std::isfinite(scale) && scale > 0.0 ? scale : 1.0};
}

void draw_field(Canvas& canvas, const FieldView& view, const FieldDimensions& field) {
  const double x = field.length / 2.0;
  const double y = field.width / 2.0;
  const auto carpet = [&](double border, Color color) {
    const Pixel corner = view * Eigen::Vector2d(-x - border, y + border);
    const Pixel size = 2.0 * (view.center - corner);
    canvas.fill_box({corner.x(), corner.y(), size.x(), size.y()}, color);
  };
  carpet(field.border, palette::carpet_border);
  carpet(0.0, palette::carpet);

  LinePainter paint(canvas, view, field.line_width);
  paint.rectangle(-x, -y, x, y);
  paint.line({0.0, -y}, {0.0, y});
  paint.circle(field.center_circle_radius);
  paint.cross(0.0, field.penalty_mark_size);
  if (field.corner_arc_radius > 0.0) {
    paint.quarter({x, y}, field.corner_arc_radius, kPi);
    paint.quarter({-x, y}, field.corner_arc_radius, 1.5 * kPi);
    paint.quarter({-x, -y}, field.corner_arc_radius, 0.0);
    paint.quarter({x, -y}, field.corner_arc_radius, 0.5 * kPi);
  }
  for (const double side : {-1.0, 1.0}) {
    const auto area = [&](double depth, double width) {
      if (depth > 0.0) paint.rectangle(side * x, -width / 2.0, side * (x - depth), width / 2.0);
    };
    area(field.penalty_area_depth, field.penalty_area_width);
    area(field.goal_area_depth, field.goal_area_width);
    paint.cross(side * field.penalty_mark_x, field.penalty_mark_size);
    draw_goal(canvas, view, field, side);
  }
}

void draw_robot(Canvas& canvas, const FieldView& view, const Pose2& pose, Color color, double radius) {
  const Pixel center = view * pose.position;
  if (!center.allFinite()) return;
  draw_robot_at(canvas, center, pose.rotation, radius, std::clamp(1.1 * view.pixels_per_metre, 34.0, 80.0), color);
}

void draw_robot_symbol(Canvas& canvas, const Pixel& center, Color color) {
  draw_robot_at(canvas, center - Pixel(3.0, 0.0), 0.0, kBeliefRadius, 0.0, color);
}

void draw_pose_particles(Canvas& canvas, const FieldView& view, std::span<const Pose2> particles) {
  const Color color = palette::pose_particle.with_opacity(0.62);
  for (const Pose2& particle : particles) {
    const Pixel center = view * particle.position;
    const Pixel forward(std::cos(particle.rotation), -std::sin(particle.rotation));
    canvas.line(center, center + 10.0 * forward, color, 1.5);
    canvas.disc(center, 2.6, color);
  }
}

void draw_scale_bar(Canvas& canvas, const FieldView& view, const Pixel& center, Color color) {
  const Pixel half(view.pixels_per_metre, 0.0);
  const Pixel tick(0.0, 5.0);
  canvas.line(center - half, center + half, color, 1.5);
  for (const Pixel& end : {Pixel(center - half), Pixel(center + half)}) canvas.line(end - tick, end + tick, color, 1.5);
  canvas.text(center - Pixel(0.0, 8.0), "2 m",
              {.size = 17.0, .color = color, .align = Align::center, .halo = palette::page});
}

}  // namespace reorient::pictures
