// SPDX-License-Identifier: MIT
// A humanoid on a field in a room, simulated a frame at a time: the same seed and the same requests give the same
// bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/random.h"
#include "geometry/transform.h"
#include "robots/camera_pairing.h"
#include "robots/operator.h"
#include "robots/robot.h"
#include "robots/simulator/agents/players.h"
#include "robots/simulator/agents/spectators.h"
#include "robots/simulator/body/ball.h"
#include "robots/simulator/body/body.h"
#include "robots/simulator/render/light/hall_light.h"
#include "robots/simulator/render/renderer.h"
#include "robots/simulator/render/sensor.h"
#include "robots/simulator/room/furniture.h"
#include "robots/simulator/room/room.h"

namespace reorient {

enum class Cameras { upper, both };

struct SimulatorParameters {
  Cameras cameras = Cameras::upper;
  int width = 640;
  double frame_rate = 30.0;
  int body_samples = 3;
  double field_of_view_horizontal = from_degrees(56.3);
  double field_of_view_vertical = from_degrees(43.7);
  double distortion_k1 = 0.03;
  double distortion_k2 = 0.0;
  double tilt_error = 0.002;
  double tilt_offset = 0.0;
  double dropped_frames = 0.0;
  double latency = 0.0;
  double worn_lines = 0.0;
  int other_robots = 3;
  int spectators = 36;
  bool ball = true;
  bool labels = false;  ///< whether labels() and depth() are kept; not a parameter of the program
  BodyParameters body;
  SensorParameters sensor;
  HallLightParameters light;
  FurnitureParameters furniture;
};

template <typename Visit>
void describe(SimulatorParameters& p, Visit&& visit) {
  visit("cameras", p.cameras, {"upper", "both"}, "which cameras give images");
  visit("width", p.width, 80, 1280, "",
        "pixels of a row of the images, made even; there are as many rows as the robot's camera asks for");
  visit("frame_rate", p.frame_rate, 1.0, 120.0, "Hz", "frames per second of simulated time");
  visit("body_samples", p.body_samples, 1, 20, "", "how often joints and inertial unit are read in each frame");
  visit("field_of_view_horizontal", p.field_of_view_horizontal, 0.35, 6.2, "rad",
        "the cameras' field of view, left to right");
  visit("field_of_view_vertical", p.field_of_view_vertical, 0.25, 6.2, "rad",
        "the cameras' field of view, top to bottom");
  visit("distortion_k1", p.distortion_k1, -100.0, 100.0, "", "radial distortion of the camera, quadratic");
  visit("distortion_k2", p.distortion_k2, -100.0, 100.0, "", "radial distortion of the camera, to the fourth power");
  visit("tilt_error", p.tilt_error, 0.0, 0.1, "rad",
        "standard deviation of the robot's own camera tilt that its calibration missed");
  visit("tilt_offset", p.tilt_offset, -0.2, 0.2, "rad",
        "the same, not left to chance: how much lower the cameras look than the robot believes");
  visit("dropped_frames", p.dropped_frames, 0.0, 0.95, "", "share of the images that never arrive");
  visit("latency", p.latency, 0.0, 2.0, "s", "how long after its image an answer reaches the body");
  visit("worn_lines", p.worn_lines, 0.0, 1.0, "", "share of the field's lines that is worn away, in patches");
  visit("other_robots", p.other_robots, 0, 11, "", "how many other robots stroll about the field");
  visit("spectators", p.spectators, 0, 300, "", "how many people stand around the field");
  visit("ball", p.ball, "whether a ball lies on the field");
}

/// What a body's file says of them; the rest as it is.
SimulatorParameters simulator_parameters_of(const RobotBody& body);

class Simulator : public Robot, public Operator, public GroundTruthSource {
 public:
  /// Throws std::runtime_error with one line where both cameras are asked for and the robot has one, where the field's
  /// carpet is larger than the room, and where no camera can have these numbers (mistake_in()).
  Simulator(const SimulatorParameters& parameters, const RobotBody& body, const FieldDimensions& field,
            const Room& room, const Pose2& start, std::uint64_t seed);

  /// Moves the world on by one frame and looks at it. Never ends, never waits.
  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;
  /// What the robot knows of itself.
  const RobotBody& body() const { return robot_; }
  GroundTruth ground_truth() const { return body_.ground_truth(); }
  std::optional<GroundTruth> truth() const override { return ground_truth(); }

  void pick_up() override { body_.pick_up(); }
  void put_down(const Pose2& where) override { body_.put_down(where); }
  void push_over() override { body_.push_over(); }
  void penalize(bool penalized) override { body_.penalize(penalized); }
  void set_exposure_compensation(double stops) override;
  void change_light() override;
  void put_ball(const Eigen::Vector2d& where) { ball_ = {where, Eigen::Vector2d::Zero()}; }  ///< m

  /// What each pixel of the latest image shows, and how far away it is (m), row by row: along the optical axis, or
  /// along the pixel's ray where the lens is not a pinhole. Empty unless SimulatorParameters::labels.
  std::span<const Label> labels() const;
  std::span<const float> depth() const;

  /// The pose that the latest image was really taken from.
  const Isometry3& field_from_camera() const { return field_from_camera_; }
  const std::vector<Player>& other_robots() const { return players_.all(); }
  const RollingBall& ball() const { return ball_; }

 private:
  /// What takes the images of one camera.
  struct Eye {
    Eye(const CameraModel& camera, const FieldDimensions& field, const Room& room, bool labels,
        const SimulatorParameters& parameters, std::uint64_t seed)
        : renderer(camera, field, room, labels, parameters.worn_lines),
          sensor(parameters.sensor, renderer.rays(), seed),
          image(camera.width, camera.height) {}

    Renderer renderer;
    Sensor sensor;
    Image image;
    std::optional<Eigen::Matrix3d> field_from_camera;  // the rotation of the image before
  };

  /// A request on its way to the body.
  struct Waiting {
    std::uint64_t from;  ///< frame in which the body obeys
    Request request;
  };

  void move();
  void take_requests();
  bool is_dropped();
  void place_people(double time);
  void light_up();
  void look(Observation& observation);
  CameraFrame moment(HeadCamera camera, const BodySample& body) const;
  void expose(Eye& eye, CameraFrame& frame);

  SimulatorParameters parameters_;
  FieldDimensions field_;
  Room room_;
  Eigen::Vector2d bounds_;               // m, half sizes of where the robot can go
  std::vector<Barrier> fixed_barriers_;  // goals and furniture
  std::vector<Barrier> barriers_;        // the same and other robots

  RobotBody robot_;
  double size_;  // of it and the other robots, as share of a NAO's
  CameraModel camera_;
  Body body_;
  Players players_;
  RollingBall ball_;
  Spectators spectators_;
  HallLight light_;
  Request request_;
  std::vector<Waiting> waiting_;  // the oldest first
  Random link_;                   // between cameras and program

  Eye upper_;
  std::optional<Eye> lower_;
  CameraPairing pairing_;
  std::optional<CameraFrame> lower_frame_;  // as it is going to be exposed
  Isometry3 field_from_lower_ = Isometry3::Identity();
  Scene scene_;
  std::size_t standing_capsules_ = 0;  // of the goals, at the front of scene_
  std::size_t standing_shadows_ = 0;
  Isometry3 field_from_camera_ = Isometry3::Identity();
  std::vector<BodySample> body_samples_;  // since the frame before
  std::uint64_t frame_ = 0;
};

}  // namespace reorient
