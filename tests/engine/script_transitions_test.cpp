#include "tests/engine/script_fixture.h"

namespace reorient {
namespace {

class ScriptTransitions : public ScriptTest {};

TEST_F(ScriptTransitions, TheShippedOrientationFlipsWhenTheOppositePoseWins) {
  ScriptHost shipped(std::string(REORIENT_SOURCE_DIR) + "/scripts", parameters);
  shipped.load_behavior("orientation");
  world.confidence.coverage = 1.0;
  world.confidence.informative = 0.5;
  world.confidence.opposite = 0.9;
  int flips = 0;
  for (int i = 0; i < 60; ++i) {
    world.time += kStep;
    for (const CommandRequest& request : shipped.tick(world).commands) {
      ++flips;
      EXPECT_EQ(request.command, Command::flip_pose);
      EXPECT_EQ(request.issuer, "orientation");
      EXPECT_EQ(request.state, "correcting");
      EXPECT_EQ(request.reason, "the opposite pose won");
      EXPECT_EQ(request.priority, 50.0);
    }
  }
  EXPECT_EQ(flips, 1);
}

}  // namespace
}  // namespace reorient
