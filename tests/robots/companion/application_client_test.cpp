// SPDX-License-Identifier: MIT
// Values and actions of a client's application: what the engine receives, what the client receives, and what is
// refused.
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "robots/companion/application_json.h"
#include "robots/companion/companion.h"
#include "robots/companion/pending_actions.h"
#include "tests/declared_field.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

/// Values: 0 ball.x, 1 ball.seen, 2 goal, 3 mates. Actions: 0 kick (with reports, 2 s), 1 say (without).
ApplicationInterface team() {
  ApplicationInterface declared;
  declared.name = "team";
  declared.values = {
      {"ball.x", "", {declared_field("", FieldType::number, {{0.0}, {}})}},
      {"ball.seen", "", {declared_field("", FieldType::boolean, {{0.0}, {}})}},
      {"goal", "", {declared_field("", FieldType::pose, {{0.0, 0.0, 0.0}, {}})}},
      {"mates",
       "",
       {declared_field("number", FieldType::integer, {{7.0}, {}}), declared_field("says", FieldType::text, {{}, {""}})},
       2}};
  declared.actions = {{"kick",
                       "",
                       {declared_field("foot", FieldType::text, {{}, {"left"}}),
                        declared_field("hard", FieldType::boolean, {{1.0}, {}})},
                       2.0,
                       true},
                      {"say",
                       "",
                       {declared_field("where", FieldType::point, {{1.0, 2.0}, {}}),
                        declared_field("count", FieldType::integer, {{3.0}, {}})},
                       1.0}};
  return declared;
}

TEST(ValuesAsJson, AreReadByNameAndGroup) {
  const std::vector<SetValue> values = read_values(
      R"({"ball": {"x": 1.5, "seen": true}, "goal": {"x": 1, "y": 2, "rotation": 0.5},
          "mates": [{"number": 2, "says": "hé"}, {}]})",
      team());
  ASSERT_EQ(values.size(), 4u);
  EXPECT_EQ(values[0].data, (FieldData{{1.0}, {}})) << "ball.seen";
  EXPECT_EQ(values[1].data, (FieldData{{1.5}, {}})) << "ball.x";
  EXPECT_EQ(values[2].data, (FieldData{{1.0, 2.0, 0.5}, {}}));
  EXPECT_EQ(values[3].data, (FieldData{{2.0, 7.0}, {"hé", ""}})) << "left-out fields have their defaults";
  EXPECT_EQ(values[3].records, 2u);
}

TEST(ValuesAsJson, OfAWrongTypeDoNotFit) {
  const ApplicationInterface declared = team();
  for (const char* json :
       {R"({"ball": {"x": "1"}})", R"({"ball": {"x": null}})", R"({"ball": {"x": [1]}})", R"({"ball": {"x": 1e999}})",
        R"({"ball": {"seen": 1}})", R"({"goal": {"x": 1}})", R"({"goal": 3})", R"({"mates": 3})", R"({"mates": {}})",
        R"({"mates": [1]})", R"({"mates": [{"number": 1.5}]})", R"({"mates": [{"says": 3}]})",
        R"({"mates": [{}, {}, {}]})"}) {
    std::vector<SetValue> values;
    try {
      values = read_values(json, declared);
    } catch (const BadMessage&) {  // a number that no double can represent
      continue;
    }
    ASSERT_EQ(values.size(), 1u) << json;
    const DeclaredValue& value = declared.values[values[0].value];
    const bool fits = values[0].records <= std::max(1u, value.most) &&
                      mistake_in(values[0].data, value.fields, values[0].records).empty();
    EXPECT_FALSE(fits) << json;
  }
}

TEST(ValuesAsJson, ThatAreNoSuchObjectAreRefused) {
  std::string deep;
  for (int i = 0; i < 100'00; ++i) deep += R"({"ball":)";
  for (const std::string& json :
       {std::string(), std::string("3"), std::string("[]"), std::string("{"), std::string("{\"ball\": {}} x"),
        std::string("{\"bal\": 1}"), std::string("{\"ball\": {\"z\": 1}}"), std::string("\xff\xfe"),
        std::string("{\"mates\": [{\"nummer\": 1}]}"), deep, std::string(20'000, '[')}) {
    EXPECT_THROW(read_values(json, team()), BadMessage) << json.substr(0, 40);
  }
  EXPECT_TRUE(read_values("{}", team()).empty());
  EXPECT_TRUE(read_values(R"({"ball": {}})", team()).empty());
}

TEST(ArgumentsAsJson, HaveTheTypesOfTheirDeclaration) {
  EXPECT_EQ(arguments_json({1, 0, {{0.0}, {"ri\"ght"}}}, team().actions[0]), R"({"foot":"ri\"ght","hard":false})");
  EXPECT_EQ(arguments_json({1, 1, {{1.5, 2.0, 4.0}, {}}}, team().actions[1]),
            R"({"count":4,"where":{"x":1.5,"y":2.0}})");
  EXPECT_NO_THROW(arguments_json({1, 0, {{0.0}, {"\xff"}}}, team().actions[0]));
}

TEST(PendingActions, AreSentUntilAReportAndNotAfterTheirTime) {
  PendingActions actions;
  std::vector<std::uint32_t> sent;
  const auto send = [&](const reorient_action& action) { return sent.push_back(action.id), true; };
  const ApplicationInterface declared = team();
  EXPECT_EQ(actions.add({1, 0, {{1.0}, {"left"}}}, declared.actions[0], 10.0), "");
  EXPECT_EQ(actions.add({2, 1, {{1.0, 2.0, 3.0}, {}}}, declared.actions[1], 10.0), "");
  actions.send(10.0, [](const reorient_action&) { return false; });
  actions.send(10.1, send);
  actions.send(10.2, send);
  EXPECT_EQ(sent, (std::vector<std::uint32_t>{1, 2}));
  actions.begin_connection();
  actions.send(10.3, send);
  EXPECT_EQ(sent, (std::vector<std::uint32_t>{1, 2, 1})) << "only the one with reports is sent again";
  actions.begin_connection();
  actions.send(12.5, send);
  EXPECT_EQ(sent.size(), 3u) << "its 2 s are over";
  actions.add({3, 0, {{1.0}, {"left"}}}, declared.actions[0], 13.0);
  actions.acknowledge(3);
  actions.send(13.0, send);
  EXPECT_EQ(sent.size(), 3u);
  EXPECT_NE(actions.add({4, 0, {{1.0}, {std::string(2000, 'x')}}}, declared.actions[0], 13.0).find("1975 bytes"),
            std::string::npos);
}

/// Declares a value with another type.
constexpr const char* kOtherText = "the text of the next session";

class ApplicationClient : public testing::Test {
 protected:
  ApplicationClient() {
    KnownRobots known = no_known_robots();
    known.interface = [](std::string_view text, const std::string& name) {
      if (text != "the text" && text != kOtherText) throw std::runtime_error(name + ":1: no");
      ApplicationInterface declared = team();
      if (text == kOtherText) declared.values[1].fields = {declared_field("", FieldType::text, {{}, {"no"}})};
      return declared;
    };
    companion_.emplace(CompanionOptions{folder_.path() / "socket", known, 77, [this] { return now_; },
                                        [this] { return ++looks_ > 3; }, 0.0});
  }

  std::vector<std::byte> hello(const std::string& text, std::uint32_t size) {
    std::vector<std::byte> bytes;
    reorient_interface block{};
    set_text(block.name, "team");
    block.size = size;
    const auto append = [&](const void* data, std::size_t count) {
      const auto* const begin = static_cast<const std::byte*>(data);
      bytes.insert(bytes.end(), begin, begin + count);
    };
    const reorient_hello hello = small_hello();
    const reorient_lens lenses[2]{};
    const reorient_header header{
        static_cast<std::uint32_t>(sizeof(hello) + sizeof(lenses) + sizeof(block) + text.size()), REORIENT_HELLO,
        REORIENT_VERSION_2};
    append(&header, sizeof(header));
    append(&hello, sizeof(hello));
    append(&lenses, sizeof(lenses));
    append(&block, sizeof(block));
    append(text.data(), text.size());
    return bytes;
  }
  RawClient greeted() {
    RawClient client(folder_.path() / "socket");
    client.introduce(hello("the text", 8));
    looks_ = 0;
    const Handshake* const handshake = companion_->wait_for_handshake();
    EXPECT_NE(handshake, nullptr);
    if (handshake != nullptr && !begun_) companion_->begin(*handshake, false, 3);
    begun_ = true;
    static_cast<void>(observed());
    return client;
  }
  std::optional<Observation> observed() {
    looks_ = 0;
    Observation observation;
    if (!companion_->observe(observation)) return std::nullopt;
    return observation;
  }
  static void send_values(RawClient& client, const std::string& json) {
    std::vector<std::byte> bytes(sizeof(reorient_header) + json.size());
    const reorient_header header{static_cast<std::uint32_t>(json.size()), REORIENT_VALUES, REORIENT_VERSION_2};
    std::memcpy(bytes.data(), &header, sizeof(header));
    std::memcpy(bytes.data() + sizeof(header), json.data(), json.size());
    client.send_bytes(bytes);
  }

  TemporaryFolder folder_;
  double now_ = 1000.0;
  int looks_ = 0;
  bool begun_ = false;
  std::optional<Companion> companion_;
};

TEST_F(ApplicationClient, DeclaresItsInterfaceInTheHello) {
  greeted();
  EXPECT_EQ(companion_->wait_for_handshake()->application.values.size(), 4u);
}

TEST_F(ApplicationClient, IsRefusedForAWrongInterface) {
  const struct {
    std::string text;
    std::uint32_t size;
    const char* why;
  } cases[] = {{"the text", 9, "expected 9 bytes of text, found 8"},
               {"the text", 7, "expected 7 bytes of text, found 8"},
               {"", 0, "expected a text of 1 to 32768 bytes, found 0"},
               {std::string(40'000, 'x'), 40'000, "expected a text of 1 to 32768 bytes, found 40000"},
               {"a mistake", 9, "hello: interface: team:1: no"}};
  for (const auto& [text, size, why] : cases) {
    RawClient client(folder_.path() / "socket");
    client.send_bytes(hello(text, size));
    looks_ = 0;
    companion_->wait_for_handshake();
    EXPECT_NE(client.refusal().find(why), std::string::npos) << why;
  }
}

TEST_F(ApplicationClient, ValuesArriveWithTheNextFrameTheLatestOfEach) {
  RawClient client = greeted();
  send_values(client, R"({"ball": {"x": 1, "seen": true}})");
  send_values(client, R"({"ball": {"x": 2}})");
  client.send_frame(33.0, 1);
  auto observation = observed();
  ASSERT_TRUE(observation);
  ASSERT_EQ(observation->external.values.size(), 2u);
  EXPECT_EQ(observation->external.values[1].data.numbers[0], 2.0);
  client.send_frame(33.1, 2);
  observation = observed();
  ASSERT_TRUE(observation);
  EXPECT_TRUE(observation->external.values.empty());
}

TEST_F(ApplicationClient, MaySendThousandsOfValuesForOneFrame) {
  RawClient client = greeted();
  std::vector<std::byte> flood;
  constexpr int kMessages = 3000;
  for (int i = 1; i <= kMessages; ++i) {
    const std::string json = R"({"ball": {"x": )" + std::to_string(i) + "}}";
    const reorient_header header{static_cast<std::uint32_t>(json.size()), REORIENT_VALUES, REORIENT_VERSION_2};
    const auto head = std::as_bytes(std::span(&header, 1)), text = std::as_bytes(std::span(json));
    flood.insert(flood.end(), head.begin(), head.end());
    flood.insert(flood.end(), text.begin(), text.end());
  }
  ASSERT_TRUE(client.send_bytes(flood));
  std::optional<Observation> observation;
  for (std::uint64_t frame = 1; frame < 100; ++frame) {
    client.send_frame(33.0 + 0.033 * static_cast<double>(frame), frame);
    const std::optional<Observation> next = observed();
    if (!next) continue;
    EXPECT_LE(next->external.values.size(), 1u) << "only the latest of each value";
    if (!next->external.values.empty()) observation = next;
    if (observation && observation->external.values[0].data.numbers[0] == kMessages) break;
  }
  ASSERT_TRUE(observation);
  EXPECT_EQ(observation->external.values[0].data.numbers[0], kMessages);
}

TEST_F(ApplicationClient, IsAnotherRobotIfATypeOfItsInterfaceHasChanged) {
  {
    RawClient client = greeted();
    send_values(client, R"({"ball": {"seen": true}})");
    client.send_frame(33.0, 1);
    ASSERT_TRUE(observed());
  }
  static_cast<void>(observed());  // notices the end
  RawClient client(folder_.path() / "socket");
  client.introduce(hello(kOtherText, static_cast<std::uint32_t>(std::strlen(kOtherText))));
  EXPECT_FALSE(observed());
  client.send_frame(33.1, 1);
  EXPECT_FALSE(observed());
  ASSERT_TRUE(companion_->has_other_robot()) << "it needs an engine of its own: the stored value has the old type";
  looks_ = 0;
  const Handshake* const handshake = companion_->wait_for_handshake();
  ASSERT_NE(handshake, nullptr);
  EXPECT_EQ(handshake->application.values[1].fields.at(0).type, FieldType::text);
}

TEST_F(ApplicationClient, IsRefusedForUnknownNamesAndTooManyBytes) {
  for (const std::string& json : {std::string(R"({"bal": 1})"), std::string("no"), std::string(33'000, ' ')}) {
    RawClient client = greeted();
    send_values(client, json);
    static_cast<void>(observed());
    EXPECT_EQ(client.refusal().find("values: "), 0u) << json.substr(0, 20) << client.refusal();
  }
}

TEST_F(ApplicationClient, ActionsAreSentWithTheirArgumentsAndReportsArrive) {
  RawClient client = greeted();
  client.send_frame(33.0, 1);
  ASSERT_TRUE(observed());
  Answer answer;
  answer.actions = {{5, 0, {{1.0}, {"right"}}}};
  companion_->answer(answer);
  std::optional<reorient_action> action;
  for (const RawClient::Heard& heard : client.hear()) {
    if (heard.kind == REORIENT_ACTION) action = heard.as<reorient_action>();
  }
  ASSERT_TRUE(action);
  EXPECT_EQ(action->id, 5u);
  EXPECT_EQ(text_of(action->name), "kick");
  EXPECT_EQ(text_of(action->arguments), R"({"foot":"right","hard":true})");
  reorient_report report{5, REORIENT_ACTION_FAILED, {}};
  set_text(report.reason, "no ball");
  client.send(REORIENT_REPORT, report);
  client.send_frame(33.1, 2);
  const auto observation = observed();
  ASSERT_TRUE(observation);
  ASSERT_EQ(observation->external.reports.size(), 1u);
  EXPECT_EQ(observation->external.reports[0].state, ActionState::failed);
  EXPECT_EQ(observation->external.reports[0].reason, "no ball");
}

TEST_F(ApplicationClient, ActionsWithoutAReportAreSentAgainToTheSameRobot) {
  Answer answer;
  answer.actions = {{5, 0, {{1.0}, {"right"}}}};
  const auto actions_heard = [](RawClient& client) {
    int count = 0;
    for (const RawClient::Heard& heard : client.hear()) count += heard.kind == REORIENT_ACTION;
    return count;
  };
  {
    RawClient client = greeted();
    client.send_frame(33.0, 1);
    ASSERT_TRUE(observed());
    companion_->answer(answer);
    EXPECT_EQ(actions_heard(client), 1);
  }
  static_cast<void>(observed());  // notices the end
  RawClient client = greeted();
  client.send_frame(33.2, 1);
  ASSERT_TRUE(observed());
  companion_->answer({});
  EXPECT_EQ(actions_heard(client), 1);
  companion_->answer({});
  EXPECT_EQ(actions_heard(client), 0);
}

TEST_F(ApplicationClient, IsRefusedForAWrongReport) {
  for (const std::uint32_t state : {0u, 4u, 0xffffffffu}) {
    RawClient client = greeted();
    client.send(REORIENT_REPORT, reorient_report{1, state, {}});
    static_cast<void>(observed());
    EXPECT_NE(client.refusal().find("report: state is"), std::string::npos) << state;
  }
  RawClient client = greeted();
  client.send(REORIENT_REPORT, reorient_memory{1, 1});
  static_cast<void>(observed());
  EXPECT_NE(client.refusal().find("report: expected 128 bytes, found 8"), std::string::npos);
}

}  // namespace
}  // namespace reorient
