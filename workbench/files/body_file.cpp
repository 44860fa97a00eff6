// SPDX-License-Identifier: MIT
#include "workbench/files/body_file.h"

#include <algorithm>
#include <vector>

#include "workbench/files/table_reader.h"

namespace reorient {
namespace {

/// Wide limits of the values, for any biped that fits into a hall.
constexpr double kTallest = 2.5;         // m
constexpr double kFastest = 20.0;        // rad/s
constexpr double kLeastView = 20.0;      // degrees
constexpr double kMostView = 150.0;      // of a pinhole
constexpr double kMostWideView = 340.0;  // of the other lenses
constexpr double kMostCoefficient = 100.0;
constexpr std::int64_t kLeastPixels = 64, kMostPixels = 4096;

class BodyReader {
 public:
  explicit BodyReader(std::string file) : file_(std::move(file)) {}

  RobotBody read(const toml::table& table) const {
    RobotBody body;
    body.lower_camera.reset();
    body.standing_load.reset();
    body.gait.reset();
    body.get_up_time.reset();
    const TableReader in(table, file_);
    in.read_all(
        {
            {"name", [&](auto& key, auto& value) { body.name = short_text(in, key, value); }},
            {"field", [&](auto& key, auto& value) { body.field = short_text(in, key, value); }},
            {"torso", [&](auto& key, auto& value) { read_torso(in.table(key, value), body); }},
            {"neck", [&](auto& key, auto& value) { read_neck(in.table(key, value), body); }},
            {"upper_camera",
             [&](auto& key, auto& value) {
               body.upper_camera = read_camera(in.table(key, value), body.dimensions.upper);
             }},
        },
        {
            {"lower_camera",
             [&](auto& key, auto& value) {
               body.lower_camera = read_camera(in.table(key, value), body.dimensions.lower);
             }},
            {"feet", [&](auto& key, auto& value) { body.standing_load = read_feet(in.table(key, value)); }},
            {"walk", [&](auto& key, auto& value) { body.gait = read_gait(in.table(key, value)); }},
            {"get_up", [&](auto& key, auto& value) { body.get_up_time = read_get_up(in.table(key, value)); }},
        });
    return body;
  }

 private:
  static std::string short_text(const TableReader& in, const std::string& key, const toml::node& value) {
    constexpr std::size_t kLongest = 60;  // bytes
    std::string text = in.text(key, value);
    if (text.size() > kLongest)
      in.refuse(value, key + ": expected at most " + std::to_string(kLongest) + " letters, found " +
                           std::to_string(text.size()));
    return text;
  }

  static TableReader::Reader place_into(const TableReader& in, Eigen::Vector3d& place) {
    return [&in, &place](auto& key, auto& value) {
      const std::vector<double> meters = in.numbers(key, value, 3, -kTallest, kTallest);
      place = {meters[0], meters[1], meters[2]};
    };
  }

  void read_torso(const toml::table& table, RobotBody& body) const {
    const TableReader in(table, file_);
    in.read_all({{"height", in.into(body.dimensions.torso_height, 0.05, kTallest)},
                 {"lying_height", in.into(body.lying_height, 0.01, kTallest)}});
  }

  void read_neck(const toml::table& table, RobotBody& body) const {
    const TableReader in(table, file_);
    in.read_all({
        {"order",
         [&](auto& key, auto& value) {
           const std::string order = in.text(key, value);
           if (order != "yaw, pitch" && order != "pitch, yaw")
             in.refuse(value, R"(order: expected "yaw, pitch" or "pitch, yaw", from the torso to the head)" +
                                  found_text(value));
           body.dimensions.neck_order = order == "yaw, pitch" ? NeckOrder::yaw_then_pitch : NeckOrder::pitch_then_yaw;
         }},
        {"first_axis", place_into(in, body.dimensions.first_axis)},
        {"second_axis", place_into(in, body.dimensions.second_axis)},
        {"yaw", in.into(body.neck.yaw, 0.0, kPi)},
        {"pitch", [&](auto& key, auto& value) { body.neck.pitch = read_pitch(in, key, value); }},
        {"speed", in.into(body.head_speed, 0.1, kFastest)},
    });
  }

  static std::vector<PitchLimit> read_pitch(const TableReader& in, const std::string& key, const toml::node& node) {
    constexpr std::size_t kMost = 64;
    const toml::array* const rows = node.as_array();
    if (rows == nullptr || rows->empty() || rows->size() > kMost)
      in.refuse(node, key + ": expected 1 to " + std::to_string(kMost) + " rows [yaw, least, most]" + found_text(node));
    std::vector<PitchLimit> limits;
    for (const toml::node& row : *rows) {
      const std::vector<double> numbers = in.numbers("each row of " + key, row, 3, -kPi, kPi);
      const PitchLimit limit{numbers[0], numbers[1], numbers[2]};
      if (limit.min > limit.max) in.refuse(row, "expected the least pitch not above the most" + found_text(row));
      if (limit.yaw < 0.0 || (!limits.empty() && limit.yaw <= limits.back().yaw))
        in.refuse(row, "expected non-negative yaw that increases from row to row" + found_text(row));
      limits.push_back(limit);
    }
    return limits;
  }

  /// The keys of a lens, which are read together after all of them are found.
  struct LensKeys {
    std::string model = "pinhole";
    const toml::node* distortion = nullptr;
    const toml::node* field_of_view = nullptr;
    const toml::node* focal = nullptr;
    const toml::node* center = nullptr;
  };

  CameraOptics read_camera(const toml::table& table, CameraMount& mount) const {
    const TableReader in(table, file_);
    CameraOptics camera;
    LensKeys lens;
    const toml::node* model = nullptr;
    const auto pixels = [&](int& count) -> TableReader::Reader {
      return [&in, &count](auto& key, auto& value) {
        count = static_cast<int>(in.whole(key, value, kLeastPixels, kMostPixels));
      };
    };
    const auto later = [](const toml::node*& node) -> TableReader::Reader {
      return [&node](auto&, auto& value) { node = &value; };
    };
    in.read_all({{"position", place_into(in, mount.position)},
                 {"tilt", in.into(mount.tilt, -0.5 * kPi, 0.5 * kPi)},
                 {"width", pixels(camera.width)},
                 {"height", pixels(camera.height)},
                 {"rate", in.into(camera.rate, 1.0, 120.0)}},
                {{"model", later(model)},
                 {"distortion", later(lens.distortion)},
                 {"field_of_view_degrees", later(lens.field_of_view)},
                 {"focal", later(lens.focal)},
                 {"center", later(lens.center)}});
    if (model != nullptr) {
      const auto projection = projection_named(in.text("model", *model));
      if (!projection)
        in.refuse(*model, "expected model \"pinhole\", \"fisheye\" or \"equirectangular\", found \"" +
                              in.text("model", *model) + "\"");
      camera.projection = *projection;
    }
    read_lens(in, table, lens, camera);
    return camera;
  }

  static void read_lens(const TableReader& in, const toml::table& table, const LensKeys& keys, CameraOptics& camera) {
    read_distortion(in, table, keys, camera);
    if ((keys.field_of_view == nullptr) == (keys.focal == nullptr)) {
      if (keys.focal == nullptr) in.refuse(table, "expected the key 'field_of_view_degrees' or 'focal', found neither");
      in.refuse(*keys.focal, "expected either 'focal' or 'field_of_view_degrees', found both");
    }
    if (keys.field_of_view != nullptr) {
      const std::vector<double> degrees = in.numbers("field_of_view_degrees", *keys.field_of_view, 2, kLeastView,
                                                     camera.is_perspective() ? kMostView : kMostWideView);
      camera.field_of_view_horizontal = from_degrees(degrees[0]);
      camera.field_of_view_vertical = from_degrees(degrees[1]);
    } else {
      const std::vector<double> focal = in.numbers("focal", *keys.focal, 2, 1.0, 1e5);
      camera.field_of_view_horizontal = 2.0 * camera.angle_at_place(0.5 * camera.width / focal[0]);
      camera.field_of_view_vertical = 2.0 * camera.angle_at_place(0.5 * camera.height / focal[1]);
    }
    if (keys.center != nullptr) {
      const std::vector<double> center = in.numbers("center", *keys.center, 2, -1e5, 1e5);
      camera.center = {center[0], center[1]};
    }
    const toml::node& where = keys.distortion != nullptr ? *keys.distortion : static_cast<const toml::node&>(table);
    if (const std::string mistake = mistake_in(camera_model(camera, camera.width, camera.height)); !mistake.empty())
      in.refuse(where, mistake);
  }

  static void read_distortion(const TableReader& in, const toml::table& table, const LensKeys& keys,
                              CameraOptics& camera) {
    std::vector<double> coefficients;
    if (keys.distortion != nullptr) {
      const toml::array* const all = keys.distortion->as_array();
      if (all == nullptr)
        in.refuse(*keys.distortion, "distortion: expected a list of numbers" + found_text(*keys.distortion));
      coefficients = in.numbers("distortion", *keys.distortion, all->size(), -kMostCoefficient, kMostCoefficient);
    } else if (camera.projection == CameraProjection::pinhole) {
      in.refuse(table, "expected the key 'distortion', found none");
    }
    if (const std::string mistake = camera.set_coefficients(coefficients); !mistake.empty())
      in.refuse(*keys.distortion, "distortion: " + mistake);
  }

  double read_feet(const toml::table& table) const {
    const TableReader in(table, file_);
    double load = 0.0;
    in.read_all({{"standing_load", in.into(load, 0.1, 200.0)}});
    return load;
  }

  Gait read_gait(const toml::table& table) const {
    const TableReader in(table, file_);
    Gait gait;
    in.read_all({{"forward", in.into(gait.forward, 0.0, 1.0)},
                 {"left", in.into(gait.left, 0.0, 1.0)},
                 {"turn", in.into(gait.turn, 0.0, 3.0)},
                 {"cruise", in.into(gait.cruise, 0.0, 1.0)},
                 {"step_frequency", in.into(gait.step_frequency, 0.5, 5.0)},
                 {"sway_roll", in.into(gait.sway_roll, 0.0, 0.3)},
                 {"sway_pitch", in.into(gait.sway_pitch, 0.0, 0.3)},
                 {"sway_height", in.into(gait.sway_height, 0.0, 0.05)}});
    return gait;
  }

  double read_get_up(const toml::table& table) const {
    const TableReader in(table, file_);
    double time = 0.0;
    in.read_all({{"time", in.into(time, 0.5, 30.0)}});
    return time;
  }

  std::string file_;
};

}  // namespace

RobotBody load_body(const std::filesystem::path& file) {
  return parse_body(read_data_file(file, "robot", "assets/robots"), file.string());
}

RobotBody parse_body(std::string_view text, const std::string& name) {
  return BodyReader(name).read(parse_table(text, name));
}

}  // namespace reorient
