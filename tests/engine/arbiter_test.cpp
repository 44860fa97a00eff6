// SPDX-License-Identifier: MIT
#include "engine/world/arbiter.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

ReorientationRequest request(Reorientation reorientation, double priority) { return {reorientation, {}, priority}; }

class ArbiterTest : public ::testing::Test {
 protected:
  std::vector<Verdict> verdicts(const std::vector<ReorientationRequest>& requests,
                                const std::vector<Lease>& leases = {}) {
    last = arbiter.arbitrate(requests, leases, world);
    std::vector<Verdict> all;
    for (const CommandRecord& record : last.commands) all.push_back(record.verdict);
    return all;
  }

  Arbiter arbiter;
  World world;
  Arbitration last;
};

using Verdicts = std::vector<Verdict>;

TEST_F(ArbiterTest, GrantsOneReorientationPerFrameToTheGreatestPriority) {
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10), request(Reorientation::purge_reflection, 50),
                      request(Reorientation::reset_orientation, 20)}),
            (Verdicts{Verdict::outranked, Verdict::granted, Verdict::outranked}));
  ASSERT_TRUE(last.granted);
  EXPECT_EQ(last.granted->request.reorientation, Reorientation::purge_reflection);
}

TEST_F(ArbiterTest, GrantsTheFirstOfEqualPriorities) {
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10), request(Reorientation::purge_reflection, 10)}),
            (Verdicts{Verdict::granted, Verdict::outranked}));
}

TEST_F(ArbiterTest, RefusesTheSameCommandDuringItsCooldown) {
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10)}), Verdicts{Verdict::granted});
  world.time = 2.9;
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10), request(Reorientation::purge_reflection, 5)}),
            (Verdicts{Verdict::too_soon, Verdict::granted}));
  world.time = 3.0;
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10)}), Verdicts{Verdict::granted});
}

TEST_F(ArbiterTest, ARefusedCommandStartsNoCooldown) {
  world.posture = Posture::lifted;
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10)}), Verdicts{Verdict::not_allowed});
  EXPECT_FALSE(last.granted);
  world.posture = Posture::upright;
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10)}), Verdicts{Verdict::granted});
}

TEST_F(ArbiterTest, AllowsAFallenRobotOnlyToResetItsOrientation) {
  world.posture = Posture::lying;
  EXPECT_EQ(verdicts({request(Reorientation::flip_pose, 10), request(Reorientation::purge_reflection, 10),
                      request(Reorientation::reset_orientation, 1)}),
            (Verdicts{Verdict::not_allowed, Verdict::not_allowed, Verdict::granted}));
}

TEST_F(ArbiterTest, ALeasePausesUntilItEndsAndIsRecordedOnce) {
  const std::vector<Lease> leases{{Pause::training, {3, 4, 5}}};
  verdicts({}, leases);
  ASSERT_EQ(last.begun.size(), 1u);
  EXPECT_EQ(last.begun[0].issuer.reason, 5);
  EXPECT_FALSE(last.train);
  EXPECT_TRUE(last.evaluate);
  verdicts({}, leases);
  EXPECT_TRUE(last.begun.empty());
  EXPECT_FALSE(last.train);
  verdicts({});
  EXPECT_TRUE(last.train);
  verdicts({}, leases);
  EXPECT_EQ(last.begun.size(), 1u);
}

TEST_F(ArbiterTest, ALeaseIsTheSameAfterItsNamesWereRenumbered) {
  NameTable before, now;
  before.names.insert(before.names.end(), {"machine of old", "machine", "state", "reason"});
  now.names.insert(now.names.end(), {"machine", "state", "reason"});
  verdicts({}, {{Pause::training, {4, 5, 6}}});
  arbiter.rename(before, now);
  verdicts({}, {{Pause::training, {3, 4, 5}}});
  EXPECT_TRUE(last.begun.empty());
  arbiter.rename(now, now);
  verdicts({}, {{Pause::training, {3, 4, 5}}});
  EXPECT_TRUE(last.begun.empty());
}

TEST_F(ArbiterTest, RemembersTheVerdictOnEachMachinesLatestCommand) {
  constexpr NameId kFirst = 3, kSecond = 4;
  const auto request = [](NameId machine, Reorientation reorientation, double priority) {
    return ReorientationRequest{reorientation, {machine, 0, 0}, priority};
  };
  const std::vector<ReorientationRequest> both{request(kFirst, Reorientation::flip_pose, 1.0),
                                               request(kSecond, Reorientation::purge_reflection, 2.0)};
  world.time = 1.0;
  arbiter.arbitrate(both, {}, world);
  EXPECT_EQ(arbiter.last_verdict(kFirst, Reorientation::purge_reflection), nullptr);
  const LastVerdict* const first = arbiter.last_verdict(kFirst, Reorientation::flip_pose);
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->verdict, Verdict::outranked);
  EXPECT_EQ(first->outranked_by, kSecond);
  EXPECT_EQ(first->refusals, 1);
  EXPECT_DOUBLE_EQ(arbiter.wait(Reorientation::purge_reflection, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(arbiter.wait(Reorientation::flip_pose, 2.0), 0.0);
  const std::vector<ReorientationRequest> again{request(kSecond, Reorientation::purge_reflection, 2.0)};
  arbiter.arbitrate(again, {}, world);
  EXPECT_EQ(arbiter.last_verdict(kSecond, Reorientation::purge_reflection)->verdict, Verdict::too_soon);
  EXPECT_EQ(arbiter.last_verdict(kSecond, Reorientation::purge_reflection)->refusals, 1);
  world.time = 9.0;
  arbiter.arbitrate(again, {}, world);
  EXPECT_EQ(arbiter.last_verdict(kSecond, Reorientation::purge_reflection)->refusals, 0);
}

TEST_F(ArbiterTest, LeasesOfTwoStatesAreDifferent) {
  verdicts({}, {{Pause::training, {3, 4, 5}}});
  verdicts({}, {{Pause::training, {3, 6, 5}}});
  EXPECT_EQ(last.begun.size(), 1u);
  EXPECT_FALSE(last.train);
}

}  // namespace
}  // namespace reorient
