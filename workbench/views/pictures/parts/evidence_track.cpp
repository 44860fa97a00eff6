// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/parts/evidence_track.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace reorient::pictures {
namespace {

constexpr double kDash = 8.0;  // pixels

/// The area between the axis and the evidence, where it has this sign.
void fill_evidence(Canvas& canvas, const TimeAxis& axis, const EvidenceTrack& track, double sign,
                   std::span<const ConfidencePoint> samples, Color color) {
  const auto corner = [&](const ConfidencePoint& sample) {
    return Pixel(axis.x(sample.time), track.y(sign * std::max(0.0, sign * sample.evidence)));
  };
  const auto is_drawn = [&](const ConfidencePoint& sample) {
    return sign * sample.evidence > 0.0 && std::isfinite(sample.time);
  };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_drawn(samples[i])) continue;
    std::vector<Pixel> outline{{axis.x(samples[i].time), track.y(0.0)}};
    for (; i < samples.size() && is_drawn(samples[i]); ++i) outline.push_back(corner(samples[i]));
    outline.emplace_back(axis.x(samples[i - 1].time), track.y(0.0));
    canvas.fill(outline, color.with_opacity(0.25));
  }
}

/// Dashed lines at the evidence that decides for the pose with this sign.
void draw_threshold(Canvas& canvas, const TimeAxis& axis, const EvidenceTrack& track, double sign,
                    std::span<const ConfidencePoint> samples, Color color) {
  for (std::size_t i = 0, next = 0; i < samples.size(); i = next) {
    while (next < samples.size() && samples[next].threshold == samples[i].threshold) ++next;
    if (next == i) ++next;  // not a number
    const double left = axis.x(samples[i].time), right = axis.x(samples[std::min(next, samples.size() - 1)].time);
    if (!(samples[i].threshold > 0.0) || !(right >= left)) continue;
    const double y = track.y(sign * samples[i].threshold);
    canvas.dashed_line({left, y}, {right, y}, color, 2.0, kDash);
  }
}

}  // namespace

void draw_curve(Canvas& canvas, const TimeAxis& axis, std::span<const ConfidencePoint> samples,
                double ConfidencePoint::*value, const std::function<double(double)>& y_of, Color color,
                double thickness) {
  std::vector<Pixel> points;
  points.reserve(samples.size());
  for (const ConfidencePoint& sample : samples) {
    const double y = sample.*value;  // clamping would hide a NaN
    points.emplace_back(axis.x(sample.time), std::isfinite(y) ? y_of(y) : y);
  }
  canvas.polyline(points, color, thickness);
}

double EvidenceTrack::y(double evidence) const {
  constexpr double kLinear = 3.0, kMost = 300.0;  // log-odds
  const double share = std::asinh(std::clamp(evidence, -kMost, kMost) / kLinear) / std::asinh(kMost / kLinear);
  return top + 0.5 * (1.0 - share) * height;
}

void draw_evidence_axis(Canvas& canvas, const TimeAxis& axis, const EvidenceTrack& track) {
  const TextStyle label{.size = 18.0, .color = palette::faint_ink, .align = Align::right};
  for (const int evidence : {-100, -10, 0, 10, 100}) {
    const double y = track.y(evidence);
    canvas.line({axis.left, y}, {axis.right, y}, evidence == 0 ? palette::faint_ink : palette::grid, 1.0);
    canvas.text({axis.left - 10.0, y + 6.0}, std::to_string(evidence), label);
  }
  canvas.text({axis.left - 60.0, track.y(0.0) + 6.0}, "evidence", {.size = 20.0, .align = Align::right});
}

void draw_evidence(Canvas& canvas, const TimeAxis& axis, const EvidenceTrack& track,
                   std::span<const ConfidencePoint> samples) {
  canvas.within({axis.left, track.top, axis.right - axis.left + 2.0, track.height}, [&] {
    fill_evidence(canvas, axis, track, 1.0, samples, palette::opposite);
    fill_evidence(canvas, axis, track, -1.0, samples, palette::belief);
    draw_threshold(canvas, axis, track, 1.0, samples, palette::opposite);
    draw_threshold(canvas, axis, track, -1.0, samples, palette::belief);
    const auto y_of = [&](double evidence) { return track.y(evidence); };
    draw_curve(canvas, axis, samples, &ConfidencePoint::evidence, y_of, palette::evidence, 3.0);
  });
}

bool has_threshold(std::span<const ConfidencePoint> samples) {
  return std::any_of(samples.begin(), samples.end(), [](const auto& sample) { return sample.threshold > 0.0; });
}

LegendEntry threshold_entry() {
  const auto symbol = [](Canvas& canvas, const Pixel& center) {
    const Pixel half(16.0, 0.0), below(0.0, 4.0);
    canvas.dashed_line(center - half - below, center + half - below, palette::opposite, 2.0, kDash);
    canvas.dashed_line(center - half + below, center + half + below, palette::belief, 2.0, kDash);
  };
  return {symbol, "threshold"};
}

}  // namespace reorient::pictures
