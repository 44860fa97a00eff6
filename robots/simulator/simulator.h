// SPDX-License-Identifier: MIT
// Simulates a humanoid on a field in a room, frame by frame. The same seed and the same requests give the same bytes.
#pragma once

#include <array>
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
#include "robots/simulator/ball/ball_application.h"
#include "robots/simulator/ball/ball_sensor.h"
#include "robots/simulator/ball/kick.h"
#include "robots/simulator/ball/rolling_ball.h"
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
  bool labels = false;  ///< whether labels() and depth() are available; not a parameter of the program
  /// Seed of light and spectators, which the robots of a game share; empty: that of the robot. Not a parameter.
  std::optional<std::uint64_t> surroundings_seed;
  BodyParameters body;
  SensorParameters sensor;
  HallLightParameters light;
  FurnitureParameters furniture;
  BallParameters ball_physics;
  BallSensorParameters ball_sensor;
  KickParameters kick;
};

template <typename Visit>
void describe(SimulatorParameters& p, Visit&& visit) {
  visit("cameras", p.cameras, {"upper", "both"}, "cameras that deliver images");
  visit("width", p.width, 80, 1280, "",
        "width of the images in pixels, rounded down to an even number; the aspect ratio of the robot's camera sets "
        "the height");
  visit("frame_rate", p.frame_rate, 1.0, 120.0, "Hz", "frames per second of simulated time");
  visit("body_samples", p.body_samples, 1, 20, "", "number of samples of joints and inertial unit in each frame");
  visit("field_of_view_horizontal", p.field_of_view_horizontal, 0.35, 6.2, "rad",
        "horizontal field of view of the cameras");
  visit("field_of_view_vertical", p.field_of_view_vertical, 0.25, 6.2, "rad", "vertical field of view of the cameras");
  visit("distortion_k1", p.distortion_k1, -100.0, 100.0, "", "radial distortion of the cameras, quadratic term");
  visit("distortion_k2", p.distortion_k2, -100.0, 100.0, "", "radial distortion of the cameras, term of fourth order");
  visit("tilt_error", p.tilt_error, 0.0, 0.1, "rad",
        "standard deviation of the constant tilt error of the robot's cameras, which its calibration does not contain");
  visit("tilt_offset", p.tilt_offset, -0.2, 0.2, "rad",
        "angle by which the cameras point lower than the robot assumes, added to the random tilt error");
  visit("dropped_frames", p.dropped_frames, 0.0, 0.95, "", "fraction of the images that are lost");
  visit("latency", p.latency, 0.0, 2.0, "s", "delay from an image until the body carries out the request for it");
  visit("worn_lines", p.worn_lines, 0.0, 1.0, "", "fraction of the field's lines that is missing, in patches");
  visit("other_robots", p.other_robots, 0, 11, "", "number of other robots that walk on the field");
  visit("spectators", p.spectators, 0, 300, "", "number of people around the field");
  visit("ball", p.ball, "whether there is a ball on the field");
}

/// The defaults, with the values that a body's file sets.
SimulatorParameters simulator_parameters_of(const RobotBody& body);

/// What the robots of a game share, as one of them meets it.
struct SharedWorld {
  std::vector<Player> others;
  RollingBall ball;
};

class Simulator : public Robot, public Operator, public GroundTruthSource {
 public:
  /// Throws std::runtime_error with one line if both cameras are requested and the robot has one, if the field's carpet
  /// is larger than the room, or if the camera's parameters are invalid (mistake_in()).
  Simulator(const SimulatorParameters& parameters, const RobotBody& body, const FieldDimensions& field,
            const Room& room, const Pose2& start, std::uint64_t seed);

  /// Advances the world by one frame and observes it; in a game it only observes. Never ends, never waits.
  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;
  /// The body as the robot assumes it, without calibration errors.
  const RobotBody& body() const { return robot_; }
  GroundTruth ground_truth() const { return body_.ground_truth(); }
  std::optional<GroundTruth> truth() const override { return ground_truth(); }
  std::optional<BallTruth> true_ball() const override;

  /// Makes the simulator the application of this interface (BallApplication).
  void play_application(const ApplicationInterface& declared) { application_.emplace(declared); }

  // For a game of several robots, each in its own simulator. In each frame the game calls advance() of all robots, then
  // share() with the new world, then observe(). No image is dropped then.

  /// Replaces the other robots and the ball, which the game moves from the first call.
  void share(const SharedWorld& world);
  /// Moves this robot by one frame.
  void advance();
  /// The velocity (m/s) of the ball that this robot kicked in the latest advance().
  const std::optional<Eigen::Vector2d>& kicked() const { return kicked_; }

  void pick_up() override { body_.pick_up(); }
  void put_down(const Pose2& where) override { body_.put_down(where); }
  void push_over() override { body_.push_over(); }
  void penalize(bool penalized) override { body_.penalize(penalized); }
  void set_exposure_compensation(double stops) override;
  void change_light() override;
  void put_ball(const Eigen::Vector2d& where) override;

  /// Label and depth (m) of each pixel of the latest image, row by row. Depth is along the optical axis, for a lens
  /// other than a pinhole along the pixel's ray. Empty unless SimulatorParameters::labels.
  std::span<const Label> labels() const;
  std::span<const float> depth() const;

  /// True pose of the camera for the latest image.
  const Isometry3& field_from_camera() const { return field_from_camera_; }
  const std::vector<Player>& other_robots() const { return players_.all(); }
  const RollingBall& ball() const { return ball_; }
  const Body& robot() const { return body_; }
  double size() const { return size_; }  ///< of the robots, relative to a NAO
  const std::vector<Barrier>& fixed_barriers() const { return fixed_barriers_; }
  double time_step() const { return 1.0 / parameters_.frame_rate; }  ///< s

 private:
  /// Renderer and sensor of one camera.
  struct Eye {
    Eye(const CameraModel& camera, const FieldDimensions& field, const Room& room, bool labels,
        const SimulatorParameters& parameters, std::uint64_t seed)
        : renderer(camera, field, room, labels, parameters.worn_lines),
          sensor(parameters.sensor, renderer.rays(), seed),
          image(camera.width, camera.height) {}

    Renderer renderer;
    Sensor sensor;
    Image image;
    std::optional<Eigen::Matrix3d> field_from_camera;  // rotation at the previous image
  };

  /// A request that latency delays.
  struct Waiting {
    std::uint64_t from;  ///< first frame in which the body carries it out
    Request request;
  };

  void move_world();
  void move_body();
  void kick();
  void roll_ball();
  void count_goals();
  void report_ball(ExternalInputs& external);
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
  Eigen::Vector2d bounds_;               // m, half sizes of the area that the robot can reach
  std::vector<Barrier> fixed_barriers_;  // goals and furniture
  std::vector<Barrier> barriers_;        // fixed_barriers_ and the other robots

  RobotBody robot_;
  double size_;  // of this robot and the others, relative to a NAO
  CameraModel camera_;
  Body body_;
  Players players_;
  RollingBall ball_;
  BallSensor ball_sensor_;
  Kick kick_;
  std::optional<BallApplication> application_;
  std::optional<Eigen::Vector2d> kicked_;  // m/s
  std::array<int, 2> goals_{};             // in the goals at positive and at negative x
  bool is_in_goal_ = false;                // the ball, and the goal was counted
  bool is_in_game_ = false;                // a game moves the other robots and the ball
  std::vector<Occluder> occluders_;        // memory of report_ball()
  Spectators spectators_;
  HallLight light_;
  Request request_;
  std::vector<Waiting> waiting_;  // oldest first
  Random link_;                   // of dropped frames

  Eye upper_;
  std::optional<Eye> lower_;
  CameraPairing pairing_;
  std::optional<CameraFrame> lower_frame_;  // not yet exposed
  Isometry3 field_from_lower_ = Isometry3::Identity();
  Scene scene_;
  std::size_t standing_capsules_ = 0;  // number of capsules that do not move: the first ones of scene_
  std::size_t standing_shadows_ = 0;
  Isometry3 field_from_camera_ = Isometry3::Identity();
  std::vector<BodySample> body_samples_;  // since the previous frame
  std::uint64_t frame_ = 0;
};

}  // namespace reorient
