// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/reorientation_view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/angle.h"
#include "workbench/views/pictures/parts/field_drawing.h"
#include "workbench/views/pictures/parts/legend.h"
#include "workbench/views/scene/field_scene.h"

namespace reorient::pictures {
namespace {

constexpr int kSheetWidth = 1500;
constexpr std::size_t kMost = 10;
constexpr double kMargin = 36.0;
constexpr double kHeader = 112.0;
constexpr double kPanelGap = 28.0;
constexpr double kTitle = 82.0;
constexpr double kPanelWidth = (kSheetWidth - 2.0 * kMargin - kPanelGap) / 2.0;

double panel_height(const FieldDimensions& field) {
  const Eigen::Vector2d carpet = carpet_half_size(field);
  const double ratio = carpet.y() / carpet.x();
  return std::isfinite(ratio) ? std::clamp(kPanelWidth * ratio, 200.0, 900.0) : 480.0;
}

// Distance of the belief from the truth, if the truth is known.
std::string error_of(const std::optional<Pose2>& truth, const Pose2& belief) {
  if (!truth) return {};
  const double distance = (truth->position - belief.position).norm();
  const double turn = std::abs(to_degrees(angle_difference(truth->rotation, belief.rotation)));
  if (!std::isfinite(distance) || !std::isfinite(turn)) return {};
  char words[80];
  std::snprintf(words, sizeof words, "belief %.2f m and %.0f deg off", distance, turn);
  return words;
}

/// The particles around the believed pose, around the mirrored pose, and elsewhere, without invalid ones.
struct Sides {
  std::vector<Pose2> believed, mirrored, elsewhere;
};

/// Whether a pose is drawn; invalid ones are left out.
bool is_drawn(const Pose2& pose) {
  constexpr double kFarthest = 1000;  // m
  return std::isfinite(pose.rotation) && pose.position.norm() < kFarthest;
}

Sides sides_of(const std::vector<Pose2>& particles, const Pose2& belief) {
  constexpr double kNear = 1.0;  // m, where one radian counts as one meter, as in a purge
  const auto apart = [](const Pose2& a, const Pose2& b) {
    return std::hypot((a.position - b.position).norm(), angle_difference(a.rotation, b.rotation));
  };
  const Pose2 mirrored = reflect(belief);
  Sides sides;
  for (const Pose2& particle : particles) {
    if (!is_drawn(particle)) continue;
    if (apart(particle, belief) <= kNear) {
      sides.believed.push_back(particle);
    } else if (apart(particle, mirrored) <= kNear) {
      sides.mirrored.push_back(particle);
    } else {
      sides.elsewhere.push_back(particle);
    }
  }
  return sides;
}

std::string counts_of(const Sides& sides) {
  return "particles near the believed pose " + std::to_string(sides.believed.size()) + ", the mirrored pose " +
         std::to_string(sides.mirrored.size()) + ", elsewhere " + std::to_string(sides.elsewhere.size());
}

/// Poses with the particles in the colors of their sides.
std::vector<scene::PoseLayer> layers_of(const Sides& sides, const std::optional<Pose2>& truth,
                                        const std::optional<Pose2>& belief) {
  constexpr double kRadius = 2.6;  // pixels
  std::vector<scene::PoseLayer> layers;
  const auto add = [&](const char* meaning, const std::vector<Pose2>& particles, Color color) {
    if (!particles.empty()) layers.push_back({meaning, particles, color, kRadius, false});
  };
  add("particles elsewhere", sides.elsewhere, palette::pose_particle);
  add("particles near the mirrored pose", sides.mirrored, palette::opposite);
  add("particles near the believed pose", sides.believed, palette::belief);
  for (scene::PoseLayer& layer : scene::pose_layers({}, truth, belief)) layers.push_back(std::move(layer));
  return layers;
}

/// The entries of all that the first `rows` rows show.
std::vector<LegendEntry> legend_of(const std::vector<ReorientationSnapshot>& reorientations, std::size_t rows) {
  Sides any;
  std::optional<Pose2> truth, belief;
  const auto note = [&](const std::vector<Pose2>& particles, const Pose2& around) {
    const Sides sides = sides_of(particles, around);
    for (const auto part : {&Sides::believed, &Sides::mirrored, &Sides::elsewhere})
      if (!(sides.*part).empty()) (any.*part) = {Pose2()};
  };
  for (std::size_t row = 0; row < rows; ++row) {
    const ReorientationSnapshot& one = reorientations[row];
    note(one.particles_before, one.belief_before);
    note(one.particles_after, one.belief_after);
    if (is_drawn(one.belief_before) || is_drawn(one.belief_after)) belief = Pose2();
    if (one.truth && is_drawn(*one.truth)) truth = Pose2();
  }
  return pose_entries(layers_of(any, truth, belief));
}

void draw_panel(Canvas& canvas, const Box& box, const FieldDimensions& field, std::span<const scene::PoseLayer> poses) {
  const FieldView view = FieldView::fitted(field, box);
  canvas.within(box, [&] {
    canvas.fill_box(box, palette::carpet_border);
    draw_field(canvas, view, field);
    draw_poses(canvas, view, poses);
  });
}

void draw_row(Canvas& canvas, double top, const FieldDimensions& field, const ReorientationSnapshot& reorientation) {
  char time[48];
  std::snprintf(time, sizeof time, " at %.1f s", reorientation.time);
  const TextStyle title{.size = 24.0, .bold = true}, plain{.size = 17.0};
  const std::string name = short_name(reorientation.reorientation) + time + ": ";
  double left = kMargin;
  for (const bool before : {true, false}) {
    const Pose2& belief = before ? reorientation.belief_before : reorientation.belief_after;
    const std::vector<Pose2>& particles = before ? reorientation.particles_before : reorientation.particles_after;
    const Sides sides = sides_of(particles, belief);
    canvas.text({left, top + kTitle - 42.0}, name + (before ? "before" : "after"), title);
    canvas.text({left + kPanelWidth, top + kTitle - 42.0}, error_of(reorientation.truth, belief),
                {.size = 19.0, .color = palette::faint_ink, .align = Align::right});
    canvas.text({left, top + kTitle - 13.0}, shortened(counts_of(sides), kPanelWidth, plain), plain);
    draw_panel(canvas, {left, top + kTitle, kPanelWidth, panel_height(field)}, field,
               layers_of(sides, reorientation.truth, belief));
    left += kPanelWidth + kPanelGap;
  }
}

}  // namespace

Picture draw_reorientation_view(const FieldDimensions& field,
                                const std::vector<ReorientationSnapshot>& reorientations) {
  const std::size_t rows = std::min(reorientations.size(), kMost);
  const double row_height = kTitle + panel_height(field);
  const double height = kHeader + std::max(row_height * static_cast<double>(rows) + kMargin, 80.0);
  Canvas canvas(kSheetWidth, static_cast<int>(height));
  canvas.text({kMargin, 54.0}, "Spontaneous reorientation", {.size = 28.0, .bold = true});
  draw_legend_rows(canvas, {kMargin - 4.0, 72.0, kSheetWidth - 2.0 * kMargin, 32.0}, legend_of(reorientations, rows));

  const TextStyle plain{.size = 19.0, .color = palette::faint_ink};
  if (rows == 0) canvas.text({kMargin, kHeader + 40.0}, "No command rearranged the particles.", plain);
  for (std::size_t row = 0; row < rows; ++row)
    draw_row(canvas, kHeader + row_height * static_cast<double>(row), field, reorientations[row]);
  if (reorientations.size() > rows) {
    const std::string rest = "and " + std::to_string(reorientations.size() - rows) + " more";
    canvas.text({kSheetWidth - kMargin, height - 12.0}, rest,
                {.size = 17.0, .color = palette::faint_ink, .align = Align::right});
  }
  return canvas.finish();
}

}  // namespace reorient::pictures
