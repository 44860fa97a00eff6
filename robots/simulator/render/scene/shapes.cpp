#include "robots/simulator/render/scene/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robots/simulator/render/coverage.h"
#include "robots/simulator/render/wide.h"

namespace reorient {
namespace {

constexpr float kNearest = 0.02f;  // m in front of the camera

/// Pixels, all four sides included.
struct Box {
  int left, top, right, bottom;
};

/// The pixels that the convex hull of balls (camera frame) can touch.
class Bounds {
 public:
  explicit Bounds(const RayTable& rays) : rays_(rays), camera_(rays.camera) {}

  void add(const Eigen::Vector3f& center, float radius) {
    // Beyond one side of the pyramid that the camera sees? A ball reaches over a side by more than its radius.
    const auto beyond = [&](float off_axis, float steepest) {
      return off_axis - steepest * center.x() > radius * std::sqrt(1.0f + steepest * steepest);
    };
    beyond_left_ = beyond_left_ && beyond(center.y(), rays_.most_left);
    beyond_right_ = beyond_right_ && beyond(-center.y(), rays_.most_right);
    beyond_top_ = beyond_top_ && beyond(center.z(), rays_.most_up);
    beyond_bottom_ = beyond_bottom_ && beyond(-center.z(), rays_.most_down);
    balls_[static_cast<std::size_t>(count_++)] = {center, radius};
  }

  Box box() {
    if (beyond_left_ || beyond_right_ || beyond_top_ || beyond_bottom_) return {0, 0, -1, -1};
    for (int i = 0; i < count_; ++i) {
      const auto& [center, radius] = balls_[static_cast<std::size_t>(i)];
      const float nearest = std::max(center.x() - radius, kNearest);
      for (const float side : {-radius, radius}) {
        for (const float depth : {nearest, center.x() + radius}) {
          add_pixel({depth, center.y() + side, center.z() + side});
        }
      }
    }
    // A distorted straight line bends out of the box of its ends.
    const double bend = std::min(0.25, 0.5 * std::abs(camera_.k1) + 0.5 * std::abs(camera_.k2));
    const double margin = 1.0 + bend * (right_ - left_ + bottom_ - top_) + static_cast<double>(rays_.slack);
    const auto pixel = [](double value, int count) {
      return static_cast<int>(std::clamp(std::floor(value), -1.0, static_cast<double>(count)));
    };
    return {std::max(0, pixel(left_ - margin, camera_.width)), std::max(0, pixel(top_ - margin, camera_.height)),
            std::min(camera_.width - 1, pixel(right_ + margin + 1.0, camera_.width)),
            std::min(camera_.height - 1, pixel(bottom_ + margin + 1.0, camera_.height))};
  }

 private:
  void add_pixel(const Eigen::Vector3f& point) {
    const Eigen::Vector3d exact = point.cast<double>();
    const auto projected = camera_.project(exact);
    // Where the distortion folds back the point is far outside of the image; so is its undistorted pixel.
    const Eigen::Vector2d pixel = projected
                                      ? *projected
                                      : Eigen::Vector2d(camera_.center.x() - camera_.focal.x() * exact.y() / exact.x(),
                                                        camera_.center.y() - camera_.focal.y() * exact.z() / exact.x());
    left_ = std::min(left_, pixel.x());
    right_ = std::max(right_, pixel.x());
    top_ = std::min(top_, pixel.y());
    bottom_ = std::max(bottom_, pixel.y());
  }

  struct Ball {
    Eigen::Vector3f center;
    float radius;
  };
  static constexpr std::size_t kMost = 8;  // of a net: both ends of each side

  const RayTable& rays_;
  const CameraModel& camera_;
  std::array<Ball, kMost> balls_;
  int count_ = 0;
  bool beyond_left_ = true;
  bool beyond_right_ = true;
  bool beyond_top_ = true;
  bool beyond_bottom_ = true;
  double left_ = 1e9;
  double right_ = -1e9;
  double top_ = 1e9;
  double bottom_ = -1e9;
};

inline void blend(Frame& frame, std::size_t pixel, float coverage, const LinearColor& color) {
  frame.red[pixel] += coverage * (color.x() - frame.red[pixel]);
  frame.green[pixel] += coverage * (color.y() - frame.green[pixel]);
  frame.blue[pixel] += coverage * (color.z() - frame.blue[pixel]);
}

void cover(Frame& frame, std::size_t pixel, float coverage, const LinearColor& color, float depth, Label label) {
  blend(frame, pixel, coverage, color);
  if (coverage <= 0.5f) return;
  frame.depth[pixel] = depth;
  if (!frame.labels.empty()) frame.labels[pixel] = label;
}

/// The twelve dark patches of a football lie where an icosahedron has its corners.
bool on_patch(const Eigen::Vector3f& normal) {
  constexpr float kShort = 0.525731f;
  constexpr float kLong = 0.850651f;
  constexpr float kReach = 0.93f;  // cosine of a patch's angular radius
  const Eigen::Vector3f n = normal.cwiseAbs();
  return kShort * n.x() + kLong * n.y() > kReach || kShort * n.y() + kLong * n.z() > kReach ||
         kShort * n.z() + kLong * n.x() > kReach;
}

/// The part of a line in front of the camera. False: there is none.
bool clip(Eigen::Vector3f& from, Eigen::Vector3f& to, float nearest) {
  if (from.x() < nearest && to.x() < nearest) return false;
  if (from.x() < nearest) from += (nearest - from.x()) / (to.x() - from.x()) * (to - from);
  if (to.x() < nearest) to += (nearest - to.x()) / (from.x() - to.x()) * (from - to);
  return true;
}

/// Calls touch(pixel, ray, length of ray) for every pixel in the box.
template <typename Touch>
void for_each(const Box& box, const RayTable& rays, const Frame& frame, Touch&& touch) {
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      const std::size_t pixel = frame.row(y) + static_cast<std::size_t>(x);
      touch(pixel, Eigen::Vector3f(1.0f, rays.left[pixel], rays.up[pixel]), rays.length[pixel]);
    }
  }
}

constexpr int kLanes = 8;  // pixels that are looked at together

/// A capsule in the camera frame.
struct CapsuleInView {
  CapsuleInView(const Capsule& what, const RayTable& table, const Eigen::Isometry3f& camera_from_field)
      : capsule(what),
        rays(table),
        field_from_camera(camera_from_field.linear().transpose()),
        up(camera_from_field.linear().col(2)),
        from(camera_from_field * what.from) {
    const Eigen::Vector3f line = camera_from_field * what.to - from;
    length = line.norm();
    axis = length > 1e-6f ? Eigen::Vector3f(line / length) : up;
    eye_along = -axis.dot(from);
    constexpr float kFar = 1e6f;
    least = what.flat_ends ? -kFar : 0.0f;
    most = what.flat_ends ? kFar : length;
  }

  /// Where a ray comes closest to the axis: metres along the ray and along the axis (anywhere on its line).
  struct Closest {
    float toward, cosine, sine2, anywhere, along, t;
  };

  [[gnu::always_inline]] Closest closest(const Eigen::Vector3f& direction) const {
    Closest c{};
    c.toward = -(direction.x() * from.x() + direction.y() * from.y() + direction.z() * from.z());
    c.cosine = direction.x() * axis.x() + direction.y() * axis.y() + direction.z() * axis.z();
    const float left = 1.0f - c.cosine * c.cosine;
    c.sine2 = left > 1e-6f ? left : 1e-6f;
    c.anywhere = (eye_along - c.cosine * c.toward) / c.sine2;
    const float from_least = c.anywhere > least ? c.anywhere : least;
    c.along = from_least < most ? from_least : most;
    c.t = c.along * c.cosine - c.toward;
    return c;
  }

  /// Which of kLanes pixels from `first` on may be touched. False: none of them. Written for SIMD.
  [[gnu::always_inline]] bool find(std::size_t first, std::array<bool, kLanes>& near) const {
    float clear[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t pixel = first + static_cast<std::size_t>(lane);
      const float scale = 1.0f / rays.length[pixel];
      const Eigen::Vector3f direction(scale, rays.left[pixel] * scale, rays.up[pixel] * scale);
      const Closest c = closest(direction);
      const float x = c.t * direction.x() - from.x() - c.along * axis.x();
      const float y = c.t * direction.y() - from.y() - c.along * axis.y();
      const float z = c.t * direction.z() - from.z() - c.along * axis.z();
      const float reach = capsule.radius + 0.5f * c.t * rays.pixel_angle;
      clear[lane] = c.t < kNearest ? 1.0f : x * x + y * y + z * z - reach * reach;
    }
    bool any = false;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      near[lane] = clear[lane] < 0.0f;
      any = any || near[lane];
    }
    return any;
  }

  /// What kLanes pixels from `first` on show of it. Written for SIMD.
  struct Look {
    float coverage[kLanes];      // in [0, 1]
    float between_ends[kLanes];  // share of a cylinder, in [0, 1]
    float depth[kLanes];         // m
    float shade[kLanes];         // factor on the colour
    float normal_x[kLanes], normal_y[kLanes], normal_z[kLanes];
  };

  [[gnu::always_inline]] void look(std::size_t first, Look& seen) const {
    const float radius = capsule.radius;
#pragma GCC ivdep
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t pixel = first + static_cast<std::size_t>(lane);
      const float ray = rays.length[pixel];
      const Eigen::Vector3f direction(1.0f / ray, rays.left[pixel] / ray, rays.up[pixel] / ray);
      const Closest c = closest(direction);
      const float apart_x = c.t * direction.x() - from.x() - c.along * axis.x();
      const float apart_y = c.t * direction.y() - from.y() - c.along * axis.y();
      const float apart_z = c.t * direction.z() - from.z() - c.along * axis.z();
      const float half_pixel = 0.5f * c.t * rays.pixel_angle;
      const float distance = std::sqrt(apart_x * apart_x + (apart_y * apart_y + apart_z * apart_z));
      const float free = radius * radius - distance * distance;
      const float sagitta = std::sqrt(free > 0.0f ? free : 0.0f);
      const float slanted = sagitta / std::sqrt(c.sine2);
      const float from_side = c.anywhere >= 0.0f ? slanted : sagitta;
      const float to_surface = c.t - (c.anywhere <= length ? from_side : sagitta);
      const float surface = to_surface > kNearest ? to_surface : kNearest;
      seen.coverage[lane] = covered_share(distance, half_pixel, -radius, radius);
      seen.between_ends[lane] = covered_share(eye_along + c.cosine * surface, half_pixel, 0.0f, length);
      seen.depth[lane] = surface / ray;
      const float from_start = c.along > 0.0f ? c.along : 0.0f;
      const float along = from_start < length ? from_start : length;
      const float x = (surface * direction.x() - (from.x() + along * axis.x())) / radius;
      const float y = (surface * direction.y() - (from.y() + along * axis.y())) / radius;
      const float z = (surface * direction.z() - (from.z() + along * axis.z())) / radius;
      // Lamps above, a little more light from one side, and what the ground sends back.
      const float shade = 0.66f + 0.34f * (x * up.x() + (y * up.y() + z * up.z())) - 0.12f * y;
      const float bright = shade > 0.2f ? shade : 0.2f;
      seen.shade[lane] = bright < 1.2f ? bright : 1.2f;
      seen.normal_x[lane] = x;
      seen.normal_y[lane] = y;
      seen.normal_z[lane] = z;
    }
  }

  void paint(std::size_t pixel, const Look& seen, int lane, Frame& frame) const {
    const float coverage = capsule.flat_ends ? seen.coverage[lane] * seen.between_ends[lane] : seen.coverage[lane];
    if (coverage <= 0.0f || seen.depth[lane] > frame.depth[pixel]) return;
    const Eigen::Vector3f normal(seen.normal_x[lane], seen.normal_y[lane], seen.normal_z[lane]);
    const bool dark = capsule.football && on_patch(field_from_camera * normal);
    const float shade = dark ? 0.06f * seen.shade[lane] : seen.shade[lane];
    cover(frame, pixel, coverage, capsule.color * shade, seen.depth[lane], capsule.label);
  }

  const Capsule& capsule;
  const RayTable& rays;
  Eigen::Matrix3f field_from_camera;  // directions only
  Eigen::Vector3f up;
  Eigen::Vector3f from;
  Eigen::Vector3f axis;
  float length = 0.0f;
  float least = 0.0f, most = 0.0f;  // where on the axis the closest point may be; the ends of a cylinder are cut later
  float eye_along = 0.0f;           // where the camera is along the axis, m from `from`
};

REORIENT_WIDE void draw_in(const Box& box, const CapsuleInView& view, Frame& frame) {
  std::array<bool, kLanes> near{};
  CapsuleInView::Look seen;
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; x += kLanes) {
      const int start = std::min(x, frame.width - kLanes);  // some pixels twice rather than the next row's
      const std::size_t first = frame.row(y) + static_cast<std::size_t>(start);
      if (!view.find(first, near)) continue;
      view.look(first, seen);
      for (int lane = x - start; lane < kLanes; ++lane) {
        if (near[static_cast<std::size_t>(lane)]) view.paint(first + static_cast<std::size_t>(lane), seen, lane, frame);
      }
    }
  }
}

}  // namespace

Frustum::Frustum(const RayTable& rays, const Eigen::Isometry3f& camera_from_field)
    : camera_from_field_(camera_from_field) {
  const auto side = [](float across, float up, float steepest) {
    const float length = std::sqrt(1.0f + steepest * steepest);
    return Side{across / length, up / length, -steepest / length};
  };
  sides_ = {side(1.0f, 0.0f, rays.most_left), side(-1.0f, 0.0f, rays.most_right), side(0.0f, 1.0f, rays.most_up),
            side(0.0f, -1.0f, rays.most_down)};
}

bool Frustum::may_show(const Capsule& capsule) const {
  constexpr float kRounding = 1e-3f;  // m
  const Eigen::Vector3f center = camera_from_field_ * Eigen::Vector3f(0.5f * (capsule.from + capsule.to));
  const float radius = capsule.radius + 0.5f * (capsule.to - capsule.from).norm() + kRounding;
  if (center.x() + radius < kNearest) return false;
  return std::none_of(sides_.begin(), sides_.end(), [&](const Side& side) {
    return side.across * center.y() + side.up * center.z() + side.ahead * center.x() > radius;
  });
}

void draw(const Capsule& capsule, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  const CapsuleInView view(capsule, rays, camera_from_field);
  Eigen::Vector3f from = view.from;
  Eigen::Vector3f to = view.from + view.length * view.axis;
  if (!clip(from, to, kNearest - capsule.radius)) return;
  Bounds bounds(rays);
  bounds.add(from, capsule.radius);
  bounds.add(to, capsule.radius);
  draw_in(bounds.box(), view, frame);
}

void draw(const Net& net, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  constexpr float kMesh = 0.08f;     // m between strings
  constexpr float kString = 0.006f;  // m
  const Eigen::Vector3f corner = camera_from_field * net.corner;
  const Eigen::Vector3f along = camera_from_field.linear() * net.along;
  const Eigen::Vector3f up = camera_from_field.linear() * net.up;
  const std::array<Eigen::Vector3f, 4> corners{corner, corner + along, corner + along + up, corner + up};
  Bounds bounds(rays);
  bool seen = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Eigen::Vector3f from = corners[i];
    Eigen::Vector3f to = corners[(i + 1) % corners.size()];
    if (!clip(from, to, kNearest)) continue;
    seen = true;
    bounds.add(from, 0.0f);
    bounds.add(to, 0.0f);
  }
  if (!seen) return;

  const Eigen::Vector3f normal = along.cross(up).normalized();
  const float width = along.norm();
  const float height = up.norm();
  const float offset = corner.dot(normal);
  const auto strings = [](float at, float half, float size) {
    if (at < -0.5f * kString || at > size + 0.5f * kString) return 0.0f;
    if (half > 0.5f * kMesh) return kString / kMesh;
    return covered_share(at - kMesh * std::round(at / kMesh), half, -0.5f * kString, 0.5f * kString);
  };
  for_each(bounds.box(), rays, frame, [&](std::size_t pixel, const Eigen::Vector3f& ray, float ray_length) {
    const float depth = offset / ray.dot(normal);
    if (!(depth > kNearest) || depth > frame.depth[pixel]) return;
    const Eigen::Vector3f inside = depth * ray - corner;
    const float u = inside.dot(along) / width;
    const float v = inside.dot(up) / height;
    if (u < 0.0f || u > width || v < 0.0f || v > height) return;
    const float half = 0.5f * depth * ray_length * rays.pixel_angle;
    const float open = (1.0f - strings(u, half, width)) * (1.0f - strings(v, half, height));
    blend(frame, pixel, 1.0f - open, net.color);  // one looks through a net: its depth and label are what is behind
  });
}

void draw(const Shadow& shadow, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame) {
  const Eigen::Vector3f center = camera_from_field * Eigen::Vector3f(shadow.center.x(), shadow.center.y(), 0.0f);
  const Eigen::Vector3f forward = camera_from_field.linear().col(0);
  const Eigen::Vector3f left = camera_from_field.linear().col(1);
  const Eigen::Vector3f up = camera_from_field.linear().col(2);
  if (center.x() + shadow.radius < kNearest) return;
  Bounds bounds(rays);
  if (center.x() - shadow.radius < kNearest) {
    bounds.add(center, shadow.radius);
  } else {
    for (const float x : {-shadow.radius, shadow.radius}) {
      for (const float y : {-shadow.radius, shadow.radius}) bounds.add(center + x * forward + y * left, 0.0f);
    }
  }
  const float offset = center.dot(up);
  for_each(bounds.box(), rays, frame, [&](std::size_t pixel, const Eigen::Vector3f& ray, float) {
    const float depth = offset / ray.dot(up);
    if (!(depth > kNearest) || depth > frame.depth[pixel] * 1.001f) return;
    const float radius2 = (depth * ray - center).squaredNorm() / (shadow.radius * shadow.radius);
    if (radius2 >= 1.0f) return;
    const float light = 1.0f - shadow.darkness * (1.0f - radius2) * (1.0f - radius2);
    frame.red[pixel] *= light;
    frame.green[pixel] *= light;
    frame.blue[pixel] *= light;
  });
}

}  // namespace reorient
