// SPDX-License-Identifier: MIT
#include "program/calibrate/footage_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "program/calibrate/footage_images.h"
#include "program/program.h"
#include "program/run/venue.h"
#include "program/shell_word.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/calibration_file.h"
#include "workbench/files/field_file.h"
#include "workbench/views/pictures/camera_view.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/scene/camera_overlay.h"

namespace reorient {
namespace {

namespace fs = std::filesystem;

/// The result, and the angles before and after on the images that were not used for the fit.
struct FoundOffset {
  OffsetEstimate estimate;
  std::vector<WeightedResidual> before, after;
  const char* between = "";  ///< what the angles are between
  std::array<bool, kOffsetComponents> observable{};
  RecordedAttitude recorded{};
};

/// The line finder needs an approximate horizon: start from several tilts, then again from the best result.
FoundOffset find_by_lines(const std::vector<FootageFrame>& frames, const FieldDimensions& field) {
  constexpr int kMostRounds = 4;
  constexpr double kSettled = from_degrees(0.1);  // also of a height, as a fraction of the distance
  FoundOffset best{{}, {}, {}, "line points and field lines", {true, true, true, true}};
  const auto found_points = [](const OffsetEstimate& estimate, const std::vector<LineView>& views) {
    double points = 0.0;
    for (const LineView& view : views) points += static_cast<double>(view.line_points.size());
    return estimate.inliers * points;
  };
  double most = 0.0;
  for (const double degrees : {0.0, 7.0, -7.0}) {
    const std::vector<LineView> views = every_second(line_views(frames, {.tilt = from_degrees(degrees)}, field), 1);
    const OffsetEstimate estimate = offset_from_lines(views, field);
    if (found_points(estimate, views) <= most) continue;
    most = found_points(estimate, views);
    best.estimate = estimate;
  }
  if (!best.estimate.is_any_determined()) return best;
  for (int round = 0; round < kMostRounds; ++round) {
    const CameraOffset before = best.estimate.offset;
    const std::vector<LineView> views = line_views(frames, before, field);
    best.estimate = offset_from_lines(every_second(views, 1), field);
    if (!best.estimate.is_any_determined()) return best;
    const CameraOffset after = best.estimate.offset;
    const std::vector<LineView> others = every_second(views, 0);
    best.before = line_angles(others, {}, field);
    best.after = line_angles(others, after, field);
    const OffsetValues first = values_of(before), second = values_of(after);
    double change = 0.0;
    for (std::size_t c = 0; c < kOffsetComponents; ++c) change = std::max(change, std::abs(second[c] - first[c]));
    if (change < kSettled) break;
  }
  return best;
}

FoundOffset find_by_edges(const std::vector<EdgeView>& views) {
  const EdgeMounting mounting = mounting_from_edges(every_second(views, 1));
  FoundOffset found_offset{mounting.estimate, {}, {}, "edges and the projected vertical", {true, false, true, false},
                           mounting.recorded};
  const std::vector<EdgeView> others = every_second(views, 0);
  EdgeAngles angles = edge_angles(others, corrected(others, mounting.recorded, mounting.estimate.offset));
  found_offset.before = std::move(angles.before);
  found_offset.after = std::move(angles.after);
  return found_offset;
}

void print_offset(const FoundOffset& found_offset, std::ostream& out) {
  constexpr std::array<const char*, kOffsetComponents> kNames{"tilt", "pan", "roll", "height"};
  constexpr std::array<const char*, kOffsetComponents> kDirections{"downwards", "to the left", "left side up",
                                                                   "upwards"};
  for (const auto& [is_used, name] :
       {std::pair{found_offset.recorded.pitch, "pitch"}, {found_offset.recorded.roll, "roll"}}) {
    if (!is_used)
      out << fmt::format("the recorded {} of single images is left out: the edges agree better without it\n", name);
  }
  const OffsetValues values = values_of(found_offset.estimate.offset);
  for (std::size_t c = 0; c < kOffsetComponents; ++c) {
    const bool is_height = c == static_cast<std::size_t>(OffsetComponent::height);
    const double scale = is_height ? 100.0 : to_degrees(1.0);
    const char* const unit = is_height ? "cm" : "degrees";
    if (!found_offset.observable[c]) {
      out << fmt::format("{}: not observable from edges; stays as recorded\n", kNames[c]);
    } else if (const std::optional<double>& deviation = found_offset.estimate.deviation[c]) {
      out << fmt::format("{}: {:+.2f} {} {} (standard error {:.2g})\n", kNames[c], scale * values[c], unit,
                         kDirections[c], scale * *deviation);
    } else {
      out << fmt::format("{}: the images do not determine it; stays as recorded\n", kNames[c]);
    }
  }
}

void print_check(const FoundOffset& found_offset, std::size_t images, std::ostream& out) {
  const double before = weighted_median(found_offset.before), after = weighted_median(found_offset.after);
  // Angles to field lines are not measured beyond a limit.
  const bool is_at_limit =
      found_offset.observable[static_cast<std::size_t>(OffsetComponent::pan)] && before >= kMostLineAngle;
  out << fmt::format(
      "on the {} images that were not used for the fit, the median angle between {} is {:.2f} degrees instead of "
      "{}{:.2f} ({:+.0f} %)\n",
      images, found_offset.between, to_degrees(after), is_at_limit ? "at least " : "", to_degrees(before),
      before > 0.0 ? 100.0 * (after - before) / before : 0.0);
}

/// The recorded attitude of single images has errors of its own. `views`: corrected.
void print_limit(const std::vector<EdgeView>& views, double noise, std::ostream& out) {
  out << fmt::format(
      "with an own tilt and roll for each image (from half of its edges, on the other half) it would be {:.2f} "
      "degrees: the roll and pitch of single images have errors that no constant offset corrects\n",
      to_degrees(weighted_median(angles_with_own_offsets(every_second(views, 0), noise))));
}

/// Through the middle of an edge, as long as the edge.
std::vector<Eigen::Vector2d> vertical_through(const ImageEdge& edge, const CameraModel& camera,
                                              const Isometry3& robot_from_camera) {
  const Eigen::Vector3d up = robot_from_camera.linear().row(2).transpose();
  const Eigen::Vector3d ray = camera.ray(0.5 * (edge.upper + edge.lower));
  const double reach = 0.5 * (camera.ray(edge.upper) - camera.ray(edge.lower)).norm();
  std::vector<Eigen::Vector2d> line;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector2d along = up.tail<2>() - up.x() * ray.tail<2>();
    const Eigen::Vector2d end = ray.tail<2>() + side * reach * along.normalized();
    if (const auto pixel = camera.project({1.0, end.x(), end.y()})) line.push_back(*pixel);
  }
  return line;
}

/// `view`: as it is drawn. `before`, `after`: the same with both camera poses.
pictures::CameraView edge_picture(const FootageFrame& frame, const EdgeView& view, const EdgeView& before,
                                  const EdgeView& after) {
  std::vector<std::vector<Eigen::Vector2d>> edges, verticals;
  for (const ImageEdge& edge : view.edges) {
    const std::array alone{EdgeView{view.camera, before.robot_from_camera, {edge}},
                           EdgeView{view.camera, after.robot_from_camera, {edge}}};
    if (edge_angles(std::span(&alone[0], 1), std::span(&alone[1], 1)).before.empty()) continue;
    edges.push_back({edge.upper, edge.lower});
    verticals.push_back(vertical_through(edge, view.camera, view.robot_from_camera));
  }
  return {
      frame.image.view(),
      frame.time,
      {scene::polylines("nearly vertical edges", std::move(edges), scene::palette::percept, 3.0, view.camera),
       scene::polylines("verticals as expected", std::move(verticals), scene::palette::expected, 1.5, view.camera)}};
}

pictures::CameraView line_picture(const FootageFrame& frame, const LineView& view, const CameraOffset& offset,
                                  const FieldDimensions& field) {
  return {frame.image.view(),
          frame.time,
          {scene::expected_lines(field, view.camera, to_isometry(view.robot) * turned(view.robot_from_camera, offset)),
           scene::line_points(view.line_points, view.camera, view.found_from_camera)}};
}

/// The image with most line points, of those that were not used for the fit.
std::size_t pictured(const std::vector<LineView>& views) {
  std::size_t best = 0;
  for (std::size_t i = 2; i < views.size(); i += 2) {
    if (views[i].line_points.size() > views[best].line_points.size()) best = i;
  }
  return best;
}

/// The most typical image by its angles, of those that show many edges and were not used for the fit.
std::size_t pictured(const std::vector<EdgeView>& views, const std::vector<EdgeView>& corrected_views,
                     const FoundOffset& found_offset) {
  std::vector<std::size_t> counts;
  for (std::size_t i = 0; i < views.size(); i += 2) counts.push_back(views[i].edges.size());
  std::sort(counts.begin(), counts.end());
  const std::size_t many = std::max<std::size_t>(counts[counts.size() * 3 / 4], 1);
  const double before = weighted_median(found_offset.before), after = weighted_median(found_offset.after);
  std::size_t best = 0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < views.size(); i += 2) {
    if (views[i].edges.size() < many) continue;
    const EdgeAngles angles = edge_angles(std::span(&views[i], 1), std::span(&corrected_views[i], 1));
    const double difference =
        std::abs(weighted_median(angles.before) - before) + std::abs(weighted_median(angles.after) - after);
    if (difference >= least) continue;
    least = difference;
    best = i;
  }
  return best;
}

}  // namespace

int calibrate_by_footage(const FootageCalibrationOptions& options, std::ostream& out) {
  constexpr std::size_t kFewestImages = 8;
  const RobotBody body = load_body(body_file(options.body));
  const FieldDimensions field = load_field(field_file(options.field, body));
  const std::vector<FootageFrame> frames = images_for_calibration(*open_footage(options.source, options.footage, body));
  if (frames.size() < kFewestImages)
    throw BadFootage(fmt::format("{}: expected at least {} images, found {}", options.source.string(), kFewestImages,
                                 frames.size()));
  const bool has_poses =
      std::all_of(frames.begin(), frames.end(), [](const FootageFrame& one) { return one.pose.has_value(); });
  if (options.by == "lines" && !has_poses)
    throw BadFootage(options.source.string() +
                     ": --by lines: expected a pose for each image, found images without one");

  FoundOffset found_offset;
  bool by_lines = false;
  if (options.by != "edges" && has_poses) {
    found_offset = find_by_lines(frames, field);
    by_lines = found_offset.estimate.is_any_determined();
  }
  if (options.by == "lines" && !by_lines) {
    out << "too few field lines are seen where the recorded poses expect them; check --field, or use --by edges\n";
    return kWrong;
  }
  std::vector<EdgeView> edges;
  if (!by_lines) {
    edges = edge_views(frames);
    found_offset = find_by_edges(edges);
  }
  out << fmt::format("by {}, from {} of {} images:\n", by_lines ? "field lines" : "vertical edges", frames.size() / 2,
                     frames.size());
  print_offset(found_offset, out);
  if (!found_offset.estimate.is_any_determined()) {
    out << "the images determine no part of the offset: nothing is written\n";
    return kWrong;
  }
  const CameraOffset& found = found_offset.estimate.offset;
  const std::vector<EdgeView> corrected_edges = corrected(edges, found_offset.recorded, found);
  print_check(found_offset, (frames.size() + 1) / 2, out);
  if (!by_lines) print_limit(corrected_edges, found_offset.estimate.noise, out);

  fs::create_directories(options.pictures);
  const std::vector<LineView> lines = by_lines ? line_views(frames, found, field) : std::vector<LineView>();
  const std::size_t which = by_lines ? pictured(lines) : pictured(edges, corrected_edges, found_offset);
  for (const bool is_after : {false, true}) {
    const fs::path file = options.pictures / fmt::format("calibration_footage_{}.png", is_after ? "after" : "before");
    const pictures::CameraView picture =
        by_lines ? line_picture(frames[which], lines[which], is_after ? found : CameraOffset(), field)
                 : edge_picture(frames[which], (is_after ? corrected_edges : edges)[which], edges[which],
                                corrected_edges[which]);
    pictures::write_png(file, pictures::draw_camera_view(picture));
    out << "picture: " << as_line(file.string()) << "\n";
  }
  write_whole_file(options.out, to_toml({{found, CameraOffset()}, found_offset.recorded}));
  FootageArguments corrected_footage = options.footage;
  corrected_footage.camera_offset = options.out;
  out << fmt::format("written: {}; reorient run --robot footage {}{}{}\n", as_line(options.out.string()),
                     shell_word(options.source.string()), words_of(corrected_footage),
                     options.body.empty() ? "" : " --body " + shell_word(options.body.string()));
  return kSuccess;
}

}  // namespace reorient
