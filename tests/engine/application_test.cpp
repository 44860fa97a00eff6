// SPDX-License-Identifier: MIT
// Values and actions that an application declares: what behaviors read, what the application receives, and what wrong
// applications cannot do.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/record/input_bytes.h"
#include "engine/record/record_bytes.h"
#include "engine/script/script_error.h"
#include "tests/declared_field.h"
#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

DeclaredValue value(const std::string& name, DeclaredField field) { return {name, "", {std::move(field)}}; }

/// Values: 0 ball.x, 1 ball.seen, 2 role, 3 target, 4 teammates. Actions: 0 kick, 1 say.
ApplicationInterface soccer() {
  ApplicationInterface declared;
  declared.name = "soccer";
  DeclaredField x = declared_field("", FieldType::number, {{0.5}, {}});
  x.minimum = -10.0;
  x.maximum = 10.0;
  x.unit = "m";
  declared.values.push_back(value("ball.x", x));
  declared.values.back().lasts = 1.0;
  declared.values.push_back(value("ball.seen", declared_field("", FieldType::boolean, {{0.0}, {}})));
  DeclaredField role = declared_field("", FieldType::text, {{}, {"striker"}});
  role.choices = {"striker", "keeper"};
  declared.values.push_back(value("role", role));
  declared.values.push_back(value("target", declared_field("", FieldType::pose, {{1.0, 2.0, 0.0}, {}})));
  declared.values.push_back(
      {"teammates",
       "",
       {declared_field("number", FieldType::integer, {{1.0}, {}}), declared_field("says", FieldType::text, {{}, {""}})},
       3});
  DeclaredField foot = role;
  foot.name = "foot";
  foot.choices = {"left", "right"};
  foot.initial = {};
  foot.is_required = true;
  DeclaredField direction = x;
  direction.name = "direction";
  direction.initial = {{0.0}, {}};
  declared.actions.push_back({"kick", "", {foot, direction}, 2.0, true});
  declared.actions.push_back({"say", "", {declared_field("text", FieldType::text, {{}, {"hello"}})}, 0.5, false});
  return declared;
}

class Application : public testing::Test {
 protected:
  /// `behavior`: its text.
  HandFedLoop& loop(const std::string& behavior) {
    FrameSetup setup;
    setup.application = soccer();
    loop_.emplace(behavior, std::move(setup));
    return *loop_;
  }
  /// A behavior that runs `update` in every frame.
  HandFedLoop& updating(const std::string& update) {
    return loop("behavior \"tested\" { update = function() " + update + " end }");
  }
  void set(std::uint16_t value, FieldData data, std::uint32_t records = 1) {
    loop_->inputs.external.values.push_back({value, records, std::move(data)});
  }
  /// The texts that the behavior logged in the next frame.
  std::vector<std::string> logged() {
    std::vector<std::string> texts;
    for (const LogRecord& log : loop_->step().logs) texts.push_back(log.text);
    for (const FaultRecord& fault : loop_->record().faults) texts.push_back("fault: " + fault.fault.message);
    return texts;
  }
  std::string fault_of(const std::string& update) {
    updating(update).step();
    return loop_->record().faults.empty() ? "no fault" : loop_->record().faults[0].fault.message;
  }

  std::optional<HandFedLoop> loop_;
};

using Texts = std::vector<std::string>;

TEST_F(Application, ValuesAreReadInTheFrameThatSetsThem) {
  updating("log.info(input.ball.x .. ' ' .. tostring(input.ball.seen) .. ' ' .. input.role .. ' ' .. input.target.y)");
  EXPECT_EQ(logged(), Texts{"0.5 false striker 2.0"});
  set(0, {{-3.25}, {}});
  set(1, {{1.0}, {}});
  set(2, {{}, {"keeper"}});
  set(3, {{4.0, 5.0, 0.1}, {}});
  EXPECT_EQ(logged(), Texts{"-3.25 true keeper 5.0"});
  EXPECT_EQ(logged(), Texts{"-3.25 true keeper 5.0"}) << "a value stays until it is set again";
}

TEST_F(Application, ValuesTellTheirAgeAndWhetherTheyAreValid) {
  updating("log.info(string.format('%.2f ', input.age.ball.x) .. tostring(input.valid.ball.x))");
  EXPECT_EQ(logged(), Texts{"inf false"});
  set(0, {{1.0}, {}});
  EXPECT_EQ(logged(), Texts{"0.00 true"});
  loop_->step(29);
  EXPECT_EQ(logged(), Texts{"1.00 true"});
  EXPECT_EQ(logged(), Texts{"1.03 false"}) << "it lasts for 1 s";
}

TEST_F(Application, ListsAreReadAsTheyWereSet) {
  updating(R"(
    local all = {}
    for i, mate in ipairs(input.teammates) do all[i] = mate.number .. "=" .. mate.says end
    log.info(#input.teammates .. ": " .. table.concat(all, ", ") .. " " .. tostring(input.teammates[4])))");
  EXPECT_EQ(logged(), Texts{"0:  nil"});
  set(4, {{2.0, 5.0}, {"hi", "there"}}, 2);
  EXPECT_EQ(logged(), Texts{"2: 2=hi, 5=there nil"});
  EXPECT_EQ(logged(), Texts{"2: 2=hi, 5=there nil"});
  set(4, {{}, {}}, 0);
  EXPECT_EQ(logged(), Texts{"0:  nil"});
}

TEST_F(Application, PairsGoesOverTheValuesOfAGroup) {
  updating(R"(
    local all = {}
    for name, content in pairs(input.ball) do all[#all + 1] = name .. "=" .. tostring(content) end
    log.info(table.concat(all, " ")))");
  EXPECT_EQ(logged(), Texts{"seen=false x=0.5"});
}

TEST_F(Application, ValuesThatDoNotFitLeaveTheLastOneAndAreReportedOnce) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  updating("if not input.valid.ball.x then log.info(tostring(input.ball.x)) end");
  set(0, {{2.0}, {}});
  EXPECT_EQ(logged(), Texts{});
  const struct {
    FieldData data;
    std::uint32_t records;
    const char* mistake;
  } wrong[] = {{{{kNan}, {}}, 1, "expected a number from -10 to 10 m, found nan"},
               {{{11.0}, {}}, 1, "expected a number from -10 to 10 m, found 11"},
               {{{1.0, 2.0}, {}}, 1, "expected 1 numbers and 0 texts, found 2 and 0"},
               {{{}, {"2"}}, 1, "expected 1 numbers and 0 texts, found 0 and 1"},
               {{{1.0, 1.0}, {}}, 2, "expected at most 1 records, found 2"},
               {{{}, {}}, 0, "expected at most 1 records, found 0"}};
  for (const auto& [data, records, mistake] : wrong) {
    set(0, data, records);
    EXPECT_EQ(logged(), (Texts{std::string("input.ball.x: ") + mistake, "2.0"}));
    set(0, data, records);
    EXPECT_EQ(logged(), Texts{"2.0"}) << "reported again";
    set(0, {{2.0}, {}});
    EXPECT_EQ(logged(), Texts{});
  }
}

TEST_F(Application, WrongListsTextsAndIntegersAreRefused) {
  updating("");
  set(4, {{1.0, 2.0, 3.0, 4.0}, {"", "", "", ""}}, 4);
  set(2, {{}, {"goalie"}});
  EXPECT_EQ(logged(), (Texts{"input.teammates: expected at most 3 records, found 4",
                             "input.role: expected striker or keeper, found 'goalie'"}));
  set(4, {{1.5}, {""}});
  EXPECT_EQ(logged(), Texts{}) << "still wrong";
  set(4, {{2.0}, {"ok"}});
  set(4, {{1.5}, {std::string(2000, 'x')}});
  EXPECT_EQ(logged(), Texts{"input.teammates: number: expected an integer, found 1.5"});
}

TEST_F(Application, NumbersThatAreNotFiniteAreRefusedInEveryType) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double number : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    updating("log.info(input.ball.x .. tostring(input.ball.seen) .. input.target.y .. #input.teammates)");
    set(0, {{number}, {}});
    set(1, {{number}, {}});
    set(3, {{1.0, number, 0.0}, {}});
    set(4, {{number}, {""}});
    const Texts texts = logged();
    ASSERT_EQ(texts.size(), 5u) << number;
    EXPECT_EQ(texts[0].find("input.ball.x: expected a number from -10 to 10 m, found "), 0u) << texts[0];
    EXPECT_EQ(texts[1].find("input.ball.seen: expected true or false, found "), 0u) << texts[1];
    EXPECT_EQ(texts[2].find("input.target: expected finite coordinates, found "), 0u) << texts[2];
    EXPECT_EQ(texts[3].find("input.teammates: number: expected an integer, found "), 0u) << texts[3];
    EXPECT_EQ(texts[4], "0.5false2.00");
  }
}

TEST_F(Application, NamesOfTheProgramCanBeDeclaredAndStaySeparate) {
  FrameSetup setup;
  setup.application = soccer();
  for (const char* const name : {"robot.posture", "pose", "game.state", "command.flip_pose", "action.kick"})
    setup.application.values.push_back(value(name, declared_field("", FieldType::number, {{7.0}, {}})));
  for (const char* const name : {"flip_pose", "velocity", "state"})
    setup.application.actions.push_back({name, "", {}, 0.5, false});
  loop_.emplace(R"(behavior "tested" { update = function()
      log.info(robot.posture .. input.robot.posture .. game.state .. input.game.state)
      log.info(type(pose.x) .. input.pose .. type(command.flip_pose) .. input.command.flip_pose .. input.action.kick)
      action.flip_pose() action.velocity() action.state()
      log.info(action.flip_pose.state)
    end })",
                std::move(setup));
  EXPECT_EQ(logged(), (Texts{"upright7.0unknown7.0", "number7.0function7.07.0", "idle"}));
  const FrameRecord& record = loop_->record();
  EXPECT_EQ(record.answer.actions.size(), 3u);
  EXPECT_TRUE(record.commands.empty());
  EXPECT_FALSE(record.reorientation) << "an action of the application corrects no pose";
  EXPECT_EQ(record.answer.request.walk.forward, 0.0);
}

TEST_F(Application, AFloodOfValuesIsCut) {
  updating("log.info(tostring(input.ball.x))");
  for (int i = 0; i < 100'000; ++i) set(static_cast<std::uint16_t>(i % 60'000), {{1.0}, {}});
  set(0, {{9.0}, {}});
  EXPECT_EQ(logged().back(), "1.0") << "beyond the limit of a frame";
}

TEST_F(Application, NamesThatAreNotDeclaredAreErrorsWithAHint) {
  const struct {
    const char* update;
    const char* message;
  } cases[] = {
      {"return input.ball.y", "input.ball has no value 'y'"},
      {"return input.bal", "input has no value 'bal' (did you mean 'ball'?)"},
      {"return input.age.role2", "input.age has no value 'role2' (did you mean 'role'?)"},
      {"return input[1]", "input has no value '1'"},
      {"input.ball.x = 2", "input is read-only"},
      {"input.teammates[1] = {}", "input.teammates is read-only"},
      {"input.target.x = 2", "input.target is read-only"},
      {"return action.kik", "action has no action 'kik' (did you mean 'kick'?)"},
      {"return action.kick.speed", "action.kick has no field 'speed' (expected state, reason or time_in_state)"},
      {"action.kick = 1", "action is read-only"},
      {"action.kick()", "action.kick: foot: expected a value, found nothing"},
      {"action.kick { foot = 'up' }", "action.kick: foot: expected left or right, found 'up'"},
      {"action.kick { foot = 1 }", "action.kick: foot: expected a text, found a number"},
      {"action.kick { foot = 'left', direction = 0/0 }", "action.kick: direction: expected a number from -10 to"},
      {"action.kick { foot = 'left', directon = 1 }", "unknown field 'directon' (did you mean 'direction'?)"},
      {"action.kick { 'left' }", "action.kick: expected names of fields, found a number as a key"},
      {"action.kick 'left'", "action.kick: expected a table with the names of the fields, found a string"},
      {"action.say({}, {})", "action.say: expected one table of arguments, found more values"}};
  for (const auto& [update, message] : cases)
    EXPECT_NE(fault_of(update).find(message), std::string::npos) << update << ": " << fault_of(update);
}

TEST_F(Application, NothingIsReadOrRequestedWhileTheScriptIsLoadedOrInAConditionActs) {
  for (const char* text : {"local x = input.ball.x\n", "local x = action.kick.state\n", "action.say()\n"}) {
    EXPECT_THROW(loop(std::string(text) + R"(behavior "tested" {})"), ScriptError) << text;
  }
  EXPECT_NO_THROW(loop("local ball, kick = input.ball, action.kick\n" + std::string(kIdle)));
  loop(R"(behavior "tested" { initial = "a",
    state "a" { { "b", when = function() action.say() return true end } }, state "b" {} })");
  loop_->step(2);
  ASSERT_FALSE(loop_->record().faults.empty());
  EXPECT_NE(loop_->record().faults[0].fault.message.find("not allowed in a condition"), std::string::npos);
}

TEST_F(Application, WithoutAnInterfaceItSaysHowToDeclareOne) {
  HandFedLoop bare("behavior \"tested\" { update = function() return input.ball end }");
  ASSERT_FALSE(bare.step().faults.empty());
  EXPECT_NE(bare.record().faults[0].fault.message.find("--interface"), std::string::npos);
}

TEST_F(Application, ActionsStartInTheFrameOfTheirRequest) {
  loop(then("action.kick { foot = 'left', direction = 0.25 }"));
  loop_->step(15);
  EXPECT_TRUE(loop_->record().answer.actions.empty());
  while (loop_->step().transitions.empty()) {
  }
  ASSERT_EQ(loop_->record().answer.actions.size(), 1u);
  const StartedAction& started = loop_->record().answer.actions[0];
  EXPECT_EQ(started.id, 1u);
  EXPECT_EQ(started.action, 0);
  EXPECT_EQ(started.arguments, (FieldData{{0.25}, {"left"}}));
  ASSERT_EQ(loop_->record().application.requests.size(), 1u);
  EXPECT_EQ(loop_->record().name(loop_->record().application.requests[0].request.issuer.state), "acting");
  EXPECT_TRUE(loop_->step().answer.actions.empty());
}

TEST_F(Application, AnActionWithReportsFollowsThemAndIgnoresOthers) {
  updating(
      "if clock.frame == 1 then action.kick { foot = 'left' } end log.info(action.kick.state .. action.kick.reason)");
  const auto report = [&](std::uint32_t id, ActionState state, const char* reason = "") {
    loop_->inputs.external.reports.push_back({id, state, reason});
  };
  EXPECT_EQ(logged(), Texts{"idle"});
  EXPECT_EQ(logged(), Texts{"requested"});
  report(7, ActionState::done);
  report(0, ActionState::done);
  report(1, ActionState::idle);
  EXPECT_EQ(logged(), Texts{"requested"});
  report(1, ActionState::running);
  EXPECT_EQ(logged(), Texts{"running"});
  report(1, ActionState::failed, ": no ball");
  EXPECT_EQ(logged(), Texts{"failed: no ball"});
  report(1, ActionState::done);
  EXPECT_EQ(logged(), Texts{"failed: no ball"}) << "it has ended";
}

TEST_F(Application, AnActionWithoutReportsEndsAfterItsTimeAndOneWithoutAnEndFails) {
  updating(R"(
    if clock.frame == 1 then action.kick { foot = 'left' } action.say() end
    log.info(action.kick.state .. " " .. action.say.state .. " " .. action.kick.reason))");
  loop_->step(10);
  EXPECT_EQ(logged(), Texts{"requested running "});
  loop_->step(10);
  EXPECT_EQ(logged(), Texts{"requested done "});
  loop_->step(60);
  EXPECT_EQ(logged(), Texts{"failed done the application did not report an end in time"});
}

TEST_F(Application, ARepeatedRequestContinuesAndAnotherOneIsTooSoon) {
  updating("action.say { text = clock.frame < 5 and 'a' or 'b' }");
  loop_->step(1);
  EXPECT_EQ(loop_->record().answer.actions.size(), 1u);
  loop_->step(3);
  EXPECT_TRUE(loop_->record().application.requests.empty());
  loop_->step(3);
  ASSERT_EQ(loop_->record().application.requests.size(), 1u);
  EXPECT_EQ(loop_->record().application.requests[0].verdict, Verdict::too_soon);
  EXPECT_TRUE(loop_->record().answer.actions.empty());
}

TEST_F(Application, TheGreaterPriorityWins) {
  FrameSetup setup;
  setup.application = soccer();
  setup.scripts.apply({"behaviors/other.lua", ScriptText{R"(behavior "other" { priority = 5,
    update = function() action.say { text = "other" } end })",
                                                         ""}});
  setup.behaviors.emplace_back("other");
  HandFedLoop loop(R"(behavior "tested" { priority = 9, update = function() action.say { text = "tested" } end })",
                   std::move(setup));
  const FrameRecord& record = loop.step();
  ASSERT_EQ(record.answer.actions.size(), 1u);
  EXPECT_EQ(record.answer.actions[0].arguments.texts[0], "tested");
  ASSERT_EQ(record.application.requests.size(), 2u);
  EXPECT_EQ(record.application.requests[0].verdict, Verdict::outranked);
}

TEST_F(Application, AnOutrankedBehaviorSeesItsOwnActionFail) {
  FrameSetup setup;
  setup.application = soccer();
  setup.scripts.apply({"behaviors/other.lua", ScriptText{R"(behavior "other" { priority = 5, initial = "a",
    state "a" { enter = function() action.say { text = "other" } end,
      update = function() log.info("other " .. action.say.state .. " " .. action.say.reason) end } })",
                                                         ""}});
  setup.behaviors.emplace_back("other");
  HandFedLoop loop(R"(behavior "tested" { priority = 9, initial = "a",
    state "a" { enter = function() action.say { text = "tested" } end,
      update = function() log.info("tested " .. action.say.state) end } })",
                   std::move(setup));
  loop.step();
  const FrameRecord& record = loop.step();
  ASSERT_EQ(record.logs.size(), 2u);
  EXPECT_EQ(record.logs[0].text, "other failed outranked by tested");
  EXPECT_EQ(record.logs[1].text, "tested running");
}

TEST_F(Application, TenThousandRequestsInAFrameAreContained) {
  FrameSetup setup;
  setup.application = soccer();
  setup.scripts.apply({"behaviors/flood.lua", ScriptText{R"(behavior "flood" { priority = 5,
    update = function() for i = 1, 10000 do action.say { text = "x" .. i } end end })",
                                                         ""}});
  setup.behaviors.emplace_back("flood");
  HandFedLoop loop(R"(behavior "tested" { update = function() action.kick { foot = "left" } end })", std::move(setup));
  const FrameRecord& record = loop.step();
  ASSERT_FALSE(record.faults.empty());
  EXPECT_NE(record.faults[0].fault.message.find("too many actions in one frame"), std::string::npos);
  EXPECT_LE(record.application.requests.size(), 101u);
  EXPECT_EQ(record.answer.actions.size(), 2u) << "one of each action";
}

TEST_F(Application, ASavedLoopContinuesWithTheSameValuesAndActions) {
  updating(
      "log.info(action.kick.state .. input.ball.x .. input.role) if clock.frame == 3 then action.kick { foot = 'left' "
      "} end");
  set(0, {{4.0}, {}});
  set(2, {{}, {"keeper"}});
  loop_->step(5);
  std::vector<std::byte> state;
  loop_->engine->save(state);
  FrameLoop copy(state);
  EXPECT_EQ(copy.application().values.size(), 5u);
  for (int i = 0; i < 70; ++i) {
    std::vector<std::byte> one, other;
    loop_->inputs.external.reports = {{1, ActionState::running, ""}};
    const FrameInputs inputs = loop_->inputs;
    write_record(loop_->engine->step(inputs), one);
    write_record(copy.step(inputs), other);
    ASSERT_EQ(one, other) << i;
    loop_->inputs.observation.time += HandFedLoop::kStep;
  }
  EXPECT_EQ(copy.record().application.actions[0].state, ActionState::failed) << "its time is over in both";
}

TEST_F(Application, RecordsAndInputsSurviveTheirBytes) {
  updating("action.say { text = input.role }");
  set(4, {{2.0}, {"hi"}}, 1);
  loop_->inputs.observation.external.reports = {{3, ActionState::failed, "why"}};
  std::vector<std::byte> bytes;
  write_inputs(loop_->inputs, bytes);
  const StoredInputs stored(bytes);
  EXPECT_EQ(stored.inputs().external.values.at(0).data, (FieldData{{2.0}, {"hi"}}));
  EXPECT_EQ(stored.inputs().observation.external.reports.at(0).reason, "why");
  bytes.clear();
  write_record(loop_->step(), bytes);
  const FrameRecord record = read_record(bytes);
  EXPECT_EQ(record.application.declared->name, "soccer");
  EXPECT_EQ(record.application.values.at(4).records, 1u);
  EXPECT_EQ(record.application.requests.at(0).request.arguments.texts.at(0), "striker");
}

TEST_F(Application, ChangesTheDigestOfARunOnlyIfItDeclaresSomething) {
  const auto digest_of = [](FrameSetup setup) {
    HandFedLoop loop(kIdle, std::move(setup));
    RecordDigest digest;
    for (int i = 0; i < 3; ++i) digest.add(loop.step());
    return digest.digest().value();
  };
  FrameSetup with;
  with.application = soccer();
  EXPECT_NE(digest_of({}), digest_of(std::move(with)));
  FrameSetup named;
  named.application.name = "empty";
  EXPECT_EQ(digest_of({}), digest_of(std::move(named)));
}

TEST(ApplicationInterface, MistakesAreNamed) {
  const auto mistake = [](auto change) {
    ApplicationInterface declared = soccer();
    change(declared);
    return mistake_in(declared);
  };
  EXPECT_EQ(mistake([](auto&) {}), "");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].name = "Ball"; }),
            "value 'Ball': expected a name such as ball.x or teammates");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].name = "ball.x.y"; }),
            "value 'ball.x.y': expected a name such as ball.x or teammates");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].name = "end"; }),
            "value 'end': expected a name such as ball.x or teammates");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].name = "age.x"; }),
            "value 'age.x': age is a name of the program (choose another one)");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].name = "role"; }), "value 'role': it is declared twice");
  EXPECT_EQ(mistake([](auto& d) { d.values[2].name = "ball"; }), "value 'ball': it is also the group of other values");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].fields[0].minimum = 20.0; }),
            "value 'ball.x': expected a range from low to high, found 20 to 10");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].fields[0].initial.numbers = {99.0}; }),
            "value 'ball.x': default: expected a number from -10 to 10 m, found 99");
  EXPECT_EQ(mistake([](auto& d) { d.values[0].lasts = 0.0; }),
            "value 'ball.x': lasts: expected more than 0 s, found 0");
  EXPECT_EQ(mistake([](auto& d) { d.values[4].most = 1000; }),
            "value 'teammates': expected at most 64 records, found 1000");
  EXPECT_EQ(mistake([](auto& d) { d.values.assign(300, d.values[0]); }), "expected at most 256 values, found 300");
  EXPECT_EQ(mistake([](auto& d) { d.actions[1].name = "kick"; }), "action 'kick': it is declared twice");
  EXPECT_EQ(mistake([](auto& d) { d.actions[0].arguments[1].name = "foot"; }),
            "action 'kick': 'foot' is declared twice");
  EXPECT_EQ(mistake([](auto& d) { d.actions[0].takes = -1.0; }),
            "action 'kick': takes: expected a time of at least 0 s, found -1");
  EXPECT_EQ(mistake([](auto& d) {
              d.actions[0].parts = {"legs", "left leg"};
            }),
            "action 'kick': parts: expected names such as legs, found 'left leg'");
  EXPECT_EQ(mistake([](auto& d) { d.actions[0].parts.assign(9, "legs"); }),
            "action 'kick': parts: expected at most 8, found 9");
  EXPECT_EQ(mistake([](auto& d) {
              for (int i = 0; i < 60; ++i)
                d.actions.push_back({"a" + std::to_string(i), "", {}, 1.0, false, {"part" + std::to_string(i)}});
            }),
            "expected at most 64 parts of the body, found 65");
  FrameSetup setup;
  setup.application = soccer();
  setup.application.values[0].name = "x y";
  EXPECT_THROW(FrameLoop{setup}, std::runtime_error);
}

}  // namespace
}  // namespace reorient
