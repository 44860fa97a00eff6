// SPDX-License-Identifier: MIT
// Messages of the Foxglove WebSocket protocol: each message of a client is read, each of the server has the protocol's
// form, and invalid ones are refused with one line.
#include "workbench/views/live/protocol/foxglove_protocol.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/parameters/utf8.h"
#include "workbench/views/viewer/viewer_topics.h"

namespace reorient::live {
namespace {

using nlohmann::json;

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

template <typename Message>
Message read_as(const std::string& text) {
  return std::get<Message>(read_client_text(text));
}

std::string refusal_of(const std::string& text) {
  try {
    read_client_text(text);
  } catch (const BadClientMessage& bad) {
    return bad.what();
  }
  return "";
}

std::string binary_refusal_of(const std::string& bytes) {
  try {
    read_client_binary(bytes_of(bytes));
  } catch (const BadClientMessage& bad) {
    return bad.what();
  }
  return "";
}

template <typename Number>
std::string little_endian(Number number) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

TEST(Subprotocol, IsTheFirstKnownOneOfTheClient) {
  EXPECT_EQ(choose_subprotocol("foxglove.websocket.v1"), "foxglove.websocket.v1");
  EXPECT_EQ(choose_subprotocol("foxglove.sdk.v1"), "foxglove.sdk.v1");
  EXPECT_EQ(choose_subprotocol("foxglove.websocket.v1, foxglove.sdk.v1"), "foxglove.websocket.v1");
  EXPECT_EQ(choose_subprotocol("foxglove.sdk.v1,foxglove.websocket.v1"), "foxglove.sdk.v1");
  EXPECT_EQ(choose_subprotocol("chat,\tfoxglove.sdk.v1 "), "foxglove.sdk.v1");
}

TEST(Subprotocol, IsRefusedIfUnknown) {
  for (const char* offered : {"", ",", ",,,", "chat", "foxglove.websocket.v2", "FOXGLOVE.SDK.V1", "foxglove.sdk.v1x"})
    EXPECT_EQ(choose_subprotocol(offered), "") << offered;
}

TEST(ClientText, SubscribesAndUnsubscribes) {
  const auto subscribe = read_as<Subscribe>(
      R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":4294967295,"channelId":1}]})");
  ASSERT_EQ(subscribe.subscriptions.size(), 2u);
  EXPECT_EQ(subscribe.subscriptions[0].channel, 3u);
  EXPECT_EQ(subscribe.subscriptions[1].id, 4294967295u);
  EXPECT_EQ(read_as<Unsubscribe>(R"({"op":"unsubscribe","subscriptionIds":[0,7]})").ids,
            (std::vector<std::uint32_t>{0, 7}));
}

TEST(ClientText, GetsParameters) {
  const auto all = read_as<GetParameters>(R"({"op":"getParameters","parameterNames":[],"id":"a"})");
  EXPECT_TRUE(all.names.empty());
  EXPECT_EQ(all.id, "a");
  const auto one = read_as<GetParameters>(R"({"op":"getParameters","parameterNames":["x.y"]})");
  EXPECT_EQ(one.names, std::vector<std::string>{"x.y"});
  EXPECT_FALSE(one.id);
}

TEST(ClientText, SetsParametersOfEachType) {
  const auto set = read_as<SetParameters>(
      R"({"op":"setParameters","id":"s","parameters":[{"name":"a","value":3,"type":"float64"},{"name":"b","value":0.25},
          {"name":"c","value":true},{"name":"d","value":"left"},{"name":"e"},{"name":"f","value":null},
          {"name":"g","value":[1]},{"name":"h","value":{}}]})");
  ASSERT_EQ(set.parameters.size(), 8u);
  EXPECT_EQ(set.id, "s");
  EXPECT_EQ(set.parameters[0].value, "3");
  EXPECT_EQ(set.parameters[1].value, "0.25");
  EXPECT_EQ(set.parameters[2].value, "true");
  EXPECT_EQ(set.parameters[3].value, "left");
  for (std::size_t i = 4; i < set.parameters.size(); ++i) EXPECT_FALSE(set.parameters[i].value) << i;
}

TEST(ClientText, WatchesParameters) {
  EXPECT_TRUE(read_as<WatchParameters>(R"({"op":"subscribeParameterUpdates","parameterNames":["a"]})").begins);
  EXPECT_FALSE(read_as<WatchParameters>(R"({"op":"unsubscribeParameterUpdates","parameterNames":["a"]})").begins);
}

TEST(ClientText, FetchesAssets) {
  EXPECT_EQ(read_as<FetchAsset>(R"({"op":"fetchAsset","uri":"package://x","requestId":5})").request, 5u);
}

TEST(ClientText, NamesTheCapabilityThatIsNotOffered) {
  for (const char* op : {"advertise", "unadvertise", "subscribeConnectionGraph", "unsubscribeConnectionGraph"})
    EXPECT_NE(read_as<NotOffered>(json{{"op", op}}.dump()).operation, "") << op;
}

TEST(ClientText, IsRefusedWithOneLine) {
  const std::string deep = R"({"op":)" + std::string(100000, '[');
  const std::string long_text(kLargestClientMessage + 1, ' ');
  for (const std::string& bad : {std::string(),
                                 std::string("{"),
                                 std::string("[]"),
                                 std::string("null"),
                                 std::string("{}"),
                                 std::string("\xFF\xFE"),
                                 std::string(1000, '\0'),
                                 deep,
                                 long_text,
                                 std::string(R"({"op":3})"),
                                 std::string(R"({"op":"dance\n\u001b[2J"})"),
                                 std::string(R"({"op":"subscribe"})"),
                                 std::string(R"({"op":"subscribe","subscriptions":{}})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[1]})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[{"id":1.5,"channelId":1}]})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[{"id":1e99,"channelId":1}]})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[{"id":1}]})"),
                                 std::string(R"({"op":"unsubscribe","subscriptionIds":["1"]})"),
                                 std::string(R"({"op":"getParameters","parameterNames":[1]})"),
                                 std::string(R"({"op":"getParameters","parameterNames":[],"id":1})"),
                                 std::string(R"({"op":"setParameters","parameters":[{"value":1}]})"),
                                 std::string(R"({"op":"setParameters","parameters":[{"name":1,"value":1}]})"),
                                 std::string(R"({"op":"fetchAsset"})"),
                                 std::string(R"({"op":"subscribe","subscriptions":[]}x)")}) {
    const std::string refusal = refusal_of(bad);
    EXPECT_NE(refusal.find("expected"), std::string::npos) << bad.substr(0, 100) << ": " << refusal;
    EXPECT_LT(refusal.size(), 400u);
    EXPECT_EQ(refusal, as_line(refusal));
  }
}

TEST(ClientText, MayContainBracketsInTexts) {
  const std::string brackets(1000, '[');
  EXPECT_EQ(read_as<GetParameters>(R"({"op":"getParameters","parameterNames":["\")" + brackets + R"("]})").names[0],
            "\"" + brackets);
}

TEST(ClientBinary, CallsAService) {
  const std::string bytes = "\x02" + little_endian(7u) + little_endian(8u) + little_endian(4u) + "json{\"a\":1}";
  const auto call = std::get<CallService>(read_client_binary(bytes_of(bytes)));
  EXPECT_EQ(call.service, 7u);
  EXPECT_EQ(call.call, 8u);
  EXPECT_EQ(call.encoding, "json");
  EXPECT_EQ(call.payload, "{\"a\":1}");
}

TEST(ClientBinary, ControlsPlayback) {
  const std::string bytes = std::string("\x03\x01", 2) + little_endian(2.0f) + "\x01" +
                            little_endian(std::uint64_t{5'000'000'000}) + little_endian(2u) + "id";
  const auto control = std::get<ControlPlayback>(read_client_binary(bytes_of(bytes)));
  EXPECT_TRUE(control.pauses);
  EXPECT_EQ(control.speed, 2.0f);
  EXPECT_EQ(control.seek, std::uint64_t{5'000'000'000});
  EXPECT_EQ(control.request, "id");
}

TEST(ClientBinary, IsRefusedWithOneLine) {
  const std::string huge = little_endian(0xFFFFFFFFu);
  const std::string zeros(8, '\0');
  const std::string call = "\x02" + zeros + huge;
  for (const std::string& bad :
       {std::string(), std::string(1, '\0'), std::string("\x04"), std::string("\xFF"), std::string("\x02"),
        "\x02" + zeros, call, std::string(call).append("json"), std::string("\x03"),
        std::string("\x03\x02") + std::string(17, '\0'), std::string("\x03\x01") + std::string(13, '\0') + huge,
        std::string("\x03\x01") + little_endian(std::numeric_limits<float>::quiet_NaN()) + std::string(13, '\0'),
        std::string("\x03\x01") + little_endian(-1.0f) + std::string(13, '\0'),
        std::string("\x03\x01") + std::string(17, '\0') + "more"}) {
    const std::string refusal = binary_refusal_of(bad);
    EXPECT_NE(refusal.find("expected"), std::string::npos) << refusal;
    EXPECT_EQ(refusal, as_line(refusal));
  }
}

TEST(ClientBinary, CannotPublishMessages) {
  EXPECT_TRUE(std::holds_alternative<NotOffered>(read_client_binary(bytes_of(std::string("\x01\0\0\0\0{}", 7)))));
}

TEST(ServerText, IntroducesTheServer) {
  const json info = json::parse(server_info({"reorient", {"parameters"}, "s", "0.1", 1'500'000'000, 2'000'000'001}));
  EXPECT_EQ(info["op"], "serverInfo");
  EXPECT_EQ(info["capabilities"], json({"parameters"}));
  EXPECT_EQ(info["sessionId"], "s");
  EXPECT_EQ(info["dataStartTime"], (json{{"sec", 1}, {"nsec", 500'000'000}}));
  EXPECT_EQ(info["dataEndTime"], (json{{"sec", 2}, {"nsec", 1}}));
  EXPECT_FALSE(json::parse(server_info({"x", {}, "s", ""})).contains("dataStartTime"));
}

TEST(ServerText, AdvertisesTheTopicsOfRecordings) {
  const json channels = json::parse(advertise_topics())["channels"];
  ASSERT_EQ(channels.size(), kViewerTopics.size());
  std::set<std::uint32_t> ids;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const json& channel = channels[i];
    EXPECT_EQ(channel["topic"], kViewerTopics[i].name);
    EXPECT_EQ(channel["schemaName"], kViewerTopics[i].schema);
    EXPECT_EQ(channel["schema"], schema_text(kViewerTopics[i].schema));
    EXPECT_EQ(channel["encoding"], "json");
    EXPECT_EQ(topic_of(channel["id"].get<std::uint32_t>()), i);
    ids.insert(channel["id"].get<std::uint32_t>());
  }
  EXPECT_EQ(ids.size(), channels.size());
  for (const std::uint32_t unknown : {0u, static_cast<std::uint32_t>(channels.size()) + 1, 0xFFFFFFFFu})
    EXPECT_FALSE(topic_of(unknown)) << unknown;
}

TEST(ServerText, SendsParametersWithTheirTypes) {
  std::vector<Parameter> all(4);
  all[0].name = "a";
  all[0].value = 3.0;
  all[1].name = "b";
  all[1].kind = ParameterKind::integer;
  all[1].value = 4;
  all[2].name = "c";
  all[2].kind = ParameterKind::boolean;
  all[2].value = true;
  all[3].name = "d";
  all[3].kind = ParameterKind::choice;
  all[3].value = std::string("left");
  const json values = json::parse(parameter_values(all, "r"));
  EXPECT_EQ(values["id"], "r");
  EXPECT_EQ(values["parameters"][0], (json{{"name", "a"}, {"value", 3.0}, {"type", "float64"}}));
  EXPECT_EQ(values["parameters"][1], (json{{"name", "b"}, {"value", 4}}));
  EXPECT_EQ(values["parameters"][2], (json{{"name", "c"}, {"value", true}}));
  EXPECT_EQ(values["parameters"][3], (json{{"name", "d"}, {"value", "left"}}));
  EXPECT_FALSE(json::parse(parameter_values({}, std::nullopt)).contains("id"));
}

TEST(ServerText, StaysValidWithBytesThatAreNotUtf8) {
  for (const std::string& text : {status(StatusLevel::warning, "\xFF\"\n", "\xC3"), remove_status("\xFF"),
                                  service_failure(1, 2, "\xFF"), parameter_values({}, "\xFF")})
    EXPECT_TRUE(json::accept(text)) << text;
}

TEST(ServerText, AdvertisesServices) {
  const ServiceInfo one[]{{3, "note", R"({"type":"object"})", R"({"type":"object"})"}};
  const json service = json::parse(advertise_services(one))["services"][0];
  EXPECT_EQ(service["id"], 3);
  EXPECT_EQ(service["name"], "note");
  EXPECT_EQ(service["request"]["encoding"], "json");
  EXPECT_EQ(service["request"]["schemaEncoding"], "jsonschema");
  EXPECT_EQ(service["response"]["schemaName"], "note.Response");
}

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(ServerBinary, HasTheProtocolsBytes) {
  EXPECT_EQ(text_of(message_data_head(5, 6)), "\x01" + little_endian(5u) + little_endian(std::uint64_t{6}));
  EXPECT_EQ(text_of(service_response(1, 2, "{}")),
            "\x03" + little_endian(1u) + little_endian(2u) + little_endian(4u) + "json{}");
  EXPECT_EQ(text_of(asset_failure(9, "no")), "\x04" + little_endian(9u) + "\x01" + little_endian(2u) + "no");
  EXPECT_EQ(text_of(playback_state(PlaybackStatus::ended, 7, 0.5f, true, "r")),
            std::string("\x05\x03") + little_endian(std::uint64_t{7}) + little_endian(0.5f) + "\x01" +
                little_endian(1u) + "r");
}

TEST(ServerTime, IsInNanosecondsAndNeverNegative) {
  EXPECT_EQ(to_nanoseconds(1.5), 1'500'000'000u);
  for (const double bad : {-1.0, -0.0, std::nan(""), -HUGE_VAL}) EXPECT_EQ(to_nanoseconds(bad), 0u);
  EXPECT_EQ(to_nanoseconds(HUGE_VAL), to_nanoseconds(1e300));
}

}  // namespace
}  // namespace reorient::live
