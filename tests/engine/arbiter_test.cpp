#include "engine/world/arbiter.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

CommandRequest request(Command command, double priority, const std::string& issuer = "a") {
  return {command, issuer, "state", "reason", priority};
}

class ArbiterTest : public ::testing::Test {
 protected:
  std::vector<Verdict> verdicts(const std::vector<CommandRequest>& requests, const std::vector<Lease>& leases = {}) {
    last = arbiter.arbitrate(requests, leases, world);
    std::vector<Verdict> all;
    for (const CommandRecord& record : last.records) all.push_back(record.verdict);
    return all;
  }

  Arbiter arbiter;
  World world;
  Arbitration last;
};

using Verdicts = std::vector<Verdict>;

TEST_F(ArbiterTest, GrantsOneReorientationAFrameToTheGreatestPriority) {
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10), request(Command::purge_reflection, 50),
                      request(Command::reset_orientation, 20)}),
            (Verdicts{Verdict::outranked, Verdict::granted, Verdict::outranked}));
  EXPECT_EQ(last.reorientation, Command::purge_reflection);
}

TEST_F(ArbiterTest, AtATieTheFirstOneWins) {
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10), request(Command::purge_reflection, 10)}),
            (Verdicts{Verdict::granted, Verdict::outranked}));
}

TEST_F(ArbiterTest, RefusesTheSameCommandDuringItsCoolDown) {
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10)}), Verdicts{Verdict::granted});
  world.time = 2.9;
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10), request(Command::purge_reflection, 5)}),
            (Verdicts{Verdict::too_soon, Verdict::granted}));
  world.time = 3.0;
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10)}), Verdicts{Verdict::granted});
}

TEST_F(ArbiterTest, ARefusedCommandStartsNoCoolDown) {
  world.carried = true;
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10)}), Verdicts{Verdict::not_allowed});
  EXPECT_EQ(last.reorientation, std::nullopt);
  world.carried = false;
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10)}), Verdicts{Verdict::granted});
}

TEST_F(ArbiterTest, AFallenRobotMayOnlyResetItsOrientation) {
  world.fallen = true;
  EXPECT_EQ(verdicts({request(Command::flip_pose, 10), request(Command::purge_reflection, 10),
                      request(Command::reset_orientation, 1)}),
            (Verdicts{Verdict::not_allowed, Verdict::not_allowed, Verdict::granted}));
}

TEST_F(ArbiterTest, ALeasePausesUntilItIsGoneAndIsRecordedOnce) {
  const std::vector<Lease> leases{{Command::pause_training, "a", "s", "why", 1.0}};
  EXPECT_EQ(verdicts({}, leases), Verdicts{Verdict::granted});
  EXPECT_FALSE(last.train);
  EXPECT_TRUE(last.evaluate);
  EXPECT_EQ(last.records[0].request.reason, "why");
  EXPECT_TRUE(verdicts({}, leases).empty());
  EXPECT_FALSE(last.train);
  EXPECT_TRUE(verdicts({}).empty());
  EXPECT_TRUE(last.train);
  EXPECT_EQ(verdicts({}, leases), Verdicts{Verdict::granted});
}

TEST_F(ArbiterTest, APauseIsNoReorientation) {
  EXPECT_EQ(verdicts({request(Command::pause_training, 10)}), Verdicts{Verdict::not_allowed});
  EXPECT_EQ(last.reorientation, std::nullopt);
}

}  // namespace
}  // namespace reorient
