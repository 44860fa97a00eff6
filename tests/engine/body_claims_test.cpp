// SPDX-License-Identifier: MIT
// Which behavior gets which part of the body: priorities of parts, actions that keep their parts, and what scripts and
// records tell about it.
#include "engine/world/body_claims.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/record/record_bytes.h"
#include "engine/script/script_error.h"
#include "tests/engine/frame_fixture.h"
#include "tests/engine/script/script_fixture.h"

namespace reorient {
namespace {

constexpr NameId kFirst = 3, kSecond = 4, kThird = 5;
constexpr BodyPart kArms = 2;

PartsRequest request(BodyParts parts, NameId machine, double priority) { return {parts, {machine, 0, 0}, priority}; }

std::vector<NameId> rivals(BodyClaims& claims, std::vector<PartsRequest> requests) {
  claims.decide(requests);
  std::vector<NameId> all;
  all.reserve(requests.size());
  for (const PartsRequest& one : requests) all.push_back(one.outranked_by);
  return all;
}

TEST(BodyClaims, GiveEachPartToTheGreatestPriorityAndAtATieToTheFirst) {
  BodyClaims claims;
  EXPECT_EQ(rivals(claims, {request(only(kHead), kFirst, 5.0), request(only(kLegs), kFirst, 5.0),
                            request(only(kHead), kSecond, 9.0), request(only(kLegs), kSecond, 5.0)}),
            (std::vector<NameId>{kSecond, kNoName, kNoName, kFirst}));
  EXPECT_EQ(claims.holder(kHead), kSecond);
  EXPECT_EQ(claims.holder(kLegs), kFirst);
  EXPECT_EQ(claims.holder(kArms), kNoName);
  EXPECT_EQ(claims.rival(kHead, kFirst), kSecond);
  EXPECT_EQ(claims.rival(kLegs, kFirst), kNoName);
}

TEST(BodyClaims, GiveSeveralPartsTogetherOrNone) {
  BodyClaims claims;
  EXPECT_EQ(rivals(claims, {request(only(kHead), kFirst, 9.0), request(only(kHead) | only(kLegs), kSecond, 7.0),
                            request(only(kLegs), kThird, 1.0)}),
            (std::vector<NameId>{kNoName, kFirst, kNoName}));
  EXPECT_EQ(claims.rival(kLegs, kSecond), kFirst) << "the machine that prevents the whole request";
  EXPECT_EQ(claims.holder(kLegs), kThird);
}

TEST(BodyClaims, OfOneBehaviorNeverRefuseEachOther) {
  BodyClaims claims;
  EXPECT_EQ(rivals(claims, {request(only(kLegs), kFirst, 9.0), request(only(kLegs) | only(kArms), kFirst, 5.0)}),
            (std::vector<NameId>{kNoName, kNoName}));
  EXPECT_EQ(claims.last().size(), 2u) << "one for each part and machine";
}

TEST(BodyClaims, KeepTheirMachinesWhenNamesAreRenumbered) {
  BodyClaims claims;
  const NameTable before{{"", "", "", "a", "b", "gone"}}, now{{"", "b", "", "c", "a"}};
  rivals(claims,
         {request(only(kHead), kFirst, 9.0), request(only(kHead), kSecond, 5.0), request(only(kLegs), kThird, 5.0)});
  claims.rename(before, now);
  EXPECT_EQ(now[claims.holder(kHead)], "a");
  EXPECT_EQ(now[claims.rival(kHead, 1)], "a");
  EXPECT_EQ(claims.holder(kLegs), kNoName) << "a behavior that no longer exists holds nothing";
  claims.rename(now, {{"", "b"}});
  EXPECT_EQ(claims.holder(kHead), kNoName) << "a refused claim is not granted when its rival no longer exists";
}

// ---- in the frame

/// Actions: 0 kick moves the legs for 1 s, 1 wave the arms, 2 dive the legs and the arms, 3 blink nothing.
ApplicationInterface player() {
  ApplicationInterface declared;
  declared.name = "player";
  declared.actions = {{"kick", "", {}, 1.0, false, {"legs"}},
                      {"wave", "", {}, 1.0, false, {"arms"}},
                      {"dive", "", {}, 1.0, false, {"legs", "arms"}},
                      {"blink", "", {}, 1.0, false, {}}};
  return declared;
}

HandFedLoop two_behaviors(const std::string& first, const std::string& second) {
  FrameSetup setup;
  setup.application = player();
  setup.scripts.apply({"behaviors/first.lua", ScriptText{first, ""}});
  setup.behaviors.emplace_back("first");
  return HandFedLoop(second, std::move(setup));
}

/// "head: first; legs: first not tested".
std::string claims_text(const FrameRecord& record) {
  const std::vector<std::string> parts = body_parts(*record.application.declared);
  std::string text;
  for (const PartClaim& claim : record.claims) {
    text += text.empty() ? "" : "; ";
    text += parts.at(claim.part) + ": " + record.name(claim.issuer.machine);
    if (claim.outranked_by != kNoName) text += " not, " + record.name(claim.outranked_by);
  }
  return text;
}

TEST(ClaimsOfBehaviors, HavePrioritiesForSinglePartsOfTheBody) {
  HandFedLoop loop = two_behaviors(
      R"(behavior "first" { priority = { 20, head = 1 }, update = function() head.look(0.1, 0) walk.velocity(0.1, 0, 0) end })",
      R"(behavior "tested" { priority = 10, update = function() head.look(0.2, 0) walk.velocity(0.2, 0, 0) end })");
  const FrameRecord& record = loop.step();
  ASSERT_TRUE(record.answer.request.head);
  EXPECT_EQ(record.answer.request.head->angles.yaw, 0.2);
  EXPECT_EQ(record.answer.request.walk.forward, 0.1);
  EXPECT_EQ(claims_text(record), "legs: first; head: tested; legs: tested not, first; head: first not, tested");
  std::vector<std::byte> bytes;
  write_record(record, bytes);
  EXPECT_EQ(claims_text(read_record(bytes)), claims_text(record));
}

/// Begins to walk after 0.1 s.
std::string walker(int priority) {
  return "behavior \"first\" { priority = " + std::to_string(priority) + R"(, initial = "waiting",
    state "waiting" { { "walking", after = 0.1, because = "now" } },
    state "walking" { update = function() walk.velocity(0.1, 0, 0) end } })";
}

const std::string kKicker = R"(behavior "tested" { priority = 5, initial = "kicking",
  state "kicking" { enter = function() action.kick {} end } })";

TEST(ClaimsOfBehaviors, AnActionKeepsItsPartsUntilItEnds) {
  HandFedLoop loop = two_behaviors(walker(5), kKicker);
  EXPECT_EQ(loop.step().answer.actions.size(), 1u);
  loop.step(9);
  EXPECT_EQ(loop.record().answer.request.walk.forward, 0.0) << "the action has the legs";
  EXPECT_EQ(claims_text(loop.record()), "legs: tested; legs: first not, tested");
  loop.step(30);
  EXPECT_EQ(loop.record().answer.request.walk.forward, 0.1) << "the action has ended";
}

TEST(ClaimsOfBehaviors, AnActionThatRunsYieldsToAGreaterPriority) {
  HandFedLoop loop = two_behaviors(walker(9), kKicker);
  EXPECT_EQ(loop.step().answer.actions.size(), 1u);
  loop.step(9);
  EXPECT_EQ(loop.record().answer.request.walk.forward, 0.1);
  EXPECT_EQ(claims_text(loop.record()), "legs: first; legs: tested not, first");
}

TEST(ClaimsOfBehaviors, AnActionThatLacksOneOfItsPartsHasFailed) {
  HandFedLoop loop = two_behaviors(
      R"(behavior "first" { priority = 9, update = function() action.wave {} end })",
      R"(behavior "tested" { priority = 5, initial = "a", state "a" { enter = function() action.dive {} action.blink {} end,
        update = function() log.info(action.dive.state .. ": " .. action.dive.reason .. ", " .. action.blink.state) end } })");
  loop.step();
  ASSERT_EQ(loop.record().answer.actions.size(), 2u);
  EXPECT_EQ(loop.record().answer.actions[0].action, 1u);
  EXPECT_EQ(loop.record().answer.actions[1].action, 3u) << "what moves no part needs none";
  loop.step();
  ASSERT_EQ(loop.record().logs.size(), 1u);
  EXPECT_EQ(loop.record().logs[0].text, "failed: outranked by first, running");
}

TEST(ClaimsOfBehaviors, ScriptsClaimAPartAndReadWhoHasIt) {
  HandFedLoop loop = two_behaviors(R"(behavior "first" { priority = 9, update = function() body.claim("legs") end })",
                                   R"(behavior "tested" { priority = 5, update = function()
        walk.velocity(0.1, 0, 0)
        log.info(body.holder("legs") .. "," .. body.rival("legs") .. "," .. body.holder("head") .. "," .. body.rival("head"))
      end })");
  loop.step();
  ASSERT_EQ(loop.record().logs.size(), 1u);
  EXPECT_EQ(loop.record().logs[0].text, ",,,") << "before the first frame no behavior has a part";
  loop.step();
  EXPECT_EQ(loop.record().logs[0].text, "first,first,,");
  EXPECT_EQ(loop.record().answer.request.walk.forward, 0.0);
  std::vector<std::byte> state;
  loop.engine->save(state);
  FrameLoop continued(state);
  EXPECT_EQ(continued.step(loop.inputs).logs[0].text, "first,first,,") << "a saved run continues with the same claims";
}

TEST(ClaimsOfBehaviors, AnUnknownPartIsAnErrorWithTheNearestName) {
  HandFedLoop loop(R"(behavior "tested" { update = function() body.claim("leg") end })");
  ASSERT_EQ(loop.step().faults.size(), 1u);
  EXPECT_EQ(loop.record().faults[0].fault.message, "unknown part of the body 'leg' (did you mean 'legs'?)");
}

TEST(ClaimsOfBehaviors, ManyRequestsOfABehaviorCountOnce) {
  HandFedLoop loop(R"(behavior "tested" { update = function()
    for i = 1, 2000 do head.look(0.001 * i, 0) body.claim("arms") end end })");
  loop.step();
  EXPECT_EQ(loop.record().claims.size(), 2u);
  ASSERT_TRUE(loop.record().answer.request.head);
  EXPECT_EQ(loop.record().answer.request.head->angles.yaw, 0.001) << "the first one";
}

TEST(ClaimsOfBehaviors, TwoActionsOfABehaviorAreDecidedEach) {
  HandFedLoop loop =
      two_behaviors(R"(behavior "first" { priority = { 9, arms = 1 }, update = function() body.claim("legs") end })",
                    R"(behavior "tested" { priority = 5, initial = "a", state "a" {
        enter = function() action.kick {} action.dive {} action.wave {} end } })");
  loop.step();
  ASSERT_EQ(loop.record().answer.actions.size(), 1u);
  EXPECT_EQ(loop.record().answer.actions[0].action, 1u) << "the legs are not free for the others";
}

class PrioritiesOfParts : public ScriptTest {};

TEST_F(PrioritiesOfParts, CountForTheBehaviorsThatItRuns) {
  folder.write("behaviors/looker.lua", R"(behavior "looker" { priority = 90, update = function()
    head.look(0.3, 0) walk.velocity(0.3, 0, 0) end })");
  load("caller", R"(behavior "caller" { priority = { 10, head = 30 }, initial = "a", state "a" { run "looker" {} } })");
  load("other",
       R"(behavior "other" { priority = 20, update = function() head.look(0.5, 0) walk.velocity(0.5, 0, 0) end })");
  const SeenTick seen = tick();
  ASSERT_TRUE(seen.request.head);
  EXPECT_EQ(seen.request.head->angles.yaw, 0.3);
  EXPECT_EQ(seen.request.walk.forward, 0.5);
}

TEST_F(PrioritiesOfParts, RefuseWrongOnesWithTheNearestName) {
  EXPECT_EQ(refusal(R"(behavior "b" { priority = { 5, haed = 3 } })").message,
            "priority: unknown part of the body 'haed' (did you mean 'head'?)");
  EXPECT_EQ(refusal(R"(behavior "b" { priority = { 5, head = "x" } })").message,
            "priority: head: expected a finite number");
  EXPECT_EQ(refusal(R"(behavior "b" { priority = { head = 5 } })").message,
            "priority: expected a finite number, or a table such as { 35, head = 50 }");
  EXPECT_EQ(refusal(R"(behavior "b" { priority = { 5, 6 } })").message,
            "priority: expected a finite number, or a table such as { 35, head = 50 }");
}

}  // namespace
}  // namespace reorient
