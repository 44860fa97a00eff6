// SPDX-License-Identifier: MIT
// Evaluates the estimate of the posture: lifts and falls that were missed, confused, or detected without an event, for
// a robot with foot sensors and for a robot with only an inertial unit. Prints a table; docs/evidence/posture.md has
// the figures.
//
//   posture_events [EVENTS [SEED]]
#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/world/posture.h"
#include "geometry/random.h"
#include "robots/simulator/body/body.h"

namespace reorient {
namespace {

constexpr double kStep = 0.01;  // s, the rate at which a NAO sends the state of its body
const Eigen::Vector2d kBounds(4.5, 3.0);

struct Tally {
  int events = 0;
  int missed = 0;
  int mistaken = 0;      ///< during an event of the other type
  int from_nothing = 0;  ///< while the robot walked or stood
  double delay = 0.0;    ///< s, sum over the detected events
};

struct Result {
  Tally lifts;
  Tally falls;
  double upright_again = 0.0;  ///< s from the feet on the ground to `upright`, sum over the lifts
  double hours = 0.0;
};

/// A robot walks, turns and stands; the operator lifts it or pushes it over from time to time.
class Life {
 public:
  Life(bool foot_sensors, std::uint64_t seed) : random_(seed, 0x9057), body_(with(foot_sensors), {}, {}, seed) {
    if (!foot_sensors) standing_load_.reset();
  }

  Result live(int events) {
    run(3.0);
    for (int event = 0; event < events; ++event) {
      walk_about();
      if (event % 2 == 0) {
        lift();
      } else {
        fall();
      }
    }
    result_.hours = time_ / 3600.0;
    return result_;
  }

 private:
  static BodyParameters with(bool foot_sensors) {
    BodyParameters parameters;
    parameters.foot_sensors = foot_sensors;
    return parameters;
  }

  void step() {
    body_.advance(kStep, request_, {}, kBounds);
    time_ += kStep;
    const Posture before = posture_.posture();
    posture_.update(body_.sample(time_), standing_load_, {ReportedPosture::unknown, request_.get_up}, parameters_);
    const Posture now = posture_.posture();
    if (now == before) return;
    const bool is_undisturbed = !may_be_lifted_ && !may_be_down_;
    const auto imagine = [&](Tally& tally) { ++(is_undisturbed ? tally.from_nothing : tally.mistaken); };
    if (now == Posture::lifted && !may_be_lifted_) imagine(result_.lifts);
    if ((now == Posture::falling || now == Posture::lying) && !is_down(before) && !may_be_down_) imagine(result_.falls);
  }

  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += kStep) step();
  }

  void walk_about() {
    may_be_lifted_ = may_be_down_ = false;
    for (double left = random_.uniform(8.0, 20.0); left > 0.0;) {
      const double stretch = random_.uniform(0.5, 4.0);
      request_ = {};
      if (random_.uniform() < 0.75)
        request_.walk = {random_.uniform(-0.25, 0.3), random_.uniform(-0.2, 0.2), random_.uniform(-1.0, 1.0)};
      run(stretch);
      left -= stretch;
    }
  }

  void lift() {
    may_be_lifted_ = true;
    const double begin = time_;
    double noticed = -1.0;
    body_.pick_up();
    const auto watch = [&] {
      step();
      if (noticed < 0.0 && posture_.posture() == Posture::lifted) noticed = time_;
    };
    for (const double end = time_ + random_.uniform(1.0, 6.0); time_ < end;) watch();
    body_.put_down(body_.pose());
    while (body_.posture() == Body::Posture::carried) watch();
    const double down = time_;
    request_ = {};
    while (posture_.posture() != Posture::upright && time_ < down + 10.0) step();
    note(result_.lifts, begin, noticed);
    if (noticed >= 0.0) result_.upright_again += time_ - down;
  }

  void fall() {
    may_be_down_ = true;
    const double begin = time_;
    double noticed = -1.0;
    body_.push_over();
    for (const double end = time_ + 3.0; time_ < end;) {
      step();
      if (noticed < 0.0 && is_down(posture_.posture())) noticed = time_;
    }
    request_ = {};
    request_.get_up = true;
    while (body_.posture() != Body::Posture::upright) step();
    request_.get_up = false;
    run(2.0);
    note(result_.falls, begin, noticed);
  }

  static void note(Tally& tally, double begin, double noticed) {
    ++tally.events;
    if (noticed < 0.0) {
      ++tally.missed;
    } else {
      tally.delay += noticed - begin;
    }
  }

  Random random_;
  Body body_;
  std::optional<double> standing_load_ = RobotBody().standing_load;
  PostureParameters parameters_;
  PostureEstimator posture_;
  Request request_;
  double time_ = 0.0;
  bool may_be_lifted_ = false;
  bool may_be_down_ = false;
  Result result_;
};

void print(const char* robot, const char* what, const Tally& tally) {
  const int noticed = tally.events - tally.missed;
  std::printf("%-24s %-6s %6d %7d %9d %13d %9.2f s\n", robot, what, tally.events, tally.missed, tally.mistaken,
              tally.from_nothing, noticed > 0 ? tally.delay / noticed : 0.0);
}

}  // namespace
}  // namespace reorient

int main(int count, char** arguments) {
  using namespace reorient;
  const int events = count > 1 ? std::atoi(arguments[1]) : 500;
  const auto seed = static_cast<std::uint64_t>(count > 2 ? std::atoll(arguments[2]) : 1);
  std::printf("%-24s %-6s %6s %7s %9s %13s %11s\n", "robot", "what", "events", "missed", "mistaken", "from nothing",
              "noticed after");
  for (const bool foot_sensors : {true, false}) {
    const char* const robot = foot_sensors ? "with foot sensors" : "inertial unit alone";
    const Result result = Life(foot_sensors, seed).live(events);
    print(robot, "lift", result.lifts);
    print(robot, "fall", result.falls);
    const int noticed = result.lifts.events - result.lifts.missed;
    std::printf("%-24s upright again %.2f s after its feet touched the ground; %.1f h in all\n", robot,
                noticed > 0 ? result.upright_again / noticed : 0.0, result.hours);
  }
  return 0;
}
