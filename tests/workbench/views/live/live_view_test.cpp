// SPDX-License-Identifier: MIT
// A run for viewers, frame by frame: what viewers receive and change, and that a frame never waits for them.
#include "workbench/views/live/live_view.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/record/record_bytes.h"
#include "tests/engine/frame_fixture.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"
#include "tests/workbench/views/live/test_viewer.h"
#include "tests/workbench/views/unsupported_schema.h"
#include "workbench/files/input_file.h"
#include "workbench/views/live/services.h"

namespace reorient::live {
namespace {

using nlohmann::json;

constexpr const char* kParameter = "field_features.pixel_deviation";

/// The size of a message of data before its JSON.
constexpr std::size_t kHeadOfData = 13;

std::vector<ViewerTopic> all_topics() {
  std::vector<ViewerTopic> topics(kViewerTopics.size());
  std::transform(kViewerTopics.begin(), kViewerTopics.end(), topics.begin(),
                 [](const ViewerTopicInfo& info) { return info.topic; });
  return topics;
}

/// Answers as the example of the service; a question that contains "slow" only once it is stopped.
class TestedWhatIf : public WhatIf, public Observer {
 public:
  Observer& memory() override { return *this; }
  void observe(const FrameRecord& /*frame*/, const SceneTruth& /*scene*/) override { ++frames; }
  std::string answer(const std::string& payload, const std::function<bool()>& stop) override {
    if (payload.find("slow") != std::string::npos) {
      is_busy = true;
      if (!await(stop)) return "{}";
      ++stopped;
      throw std::runtime_error("it was stopped\x1b");
    }
    return std::string(kServices[static_cast<std::size_t>(Service::what_if)].response);
  }

  int frames = 0;  // of the thread of the frames
  std::atomic<bool> is_busy = false;
  std::atomic<int> stopped = 0;
};

class ViewedRun : public ::testing::Test {
 protected:
  void start(LiveViewOptions options = {}) {
    options.port = 0;
    folder.write("scripts/behaviors/tested.lua", kIdle);
    LiveSubject subject;
    subject.parameters = [this] { return loop.engine->parameters(); };
    subject.scripts = folder.path() / "scripts";
    subject.ask = [](const std::vector<std::string>& words) -> PromptReply {
      if (words.back() == "unknown") throw std::runtime_error("unknown machine 'unknown'");
      return [words](const FrameRecord&, const SceneTruth&) { return words.front() + " answered"; };
    };
    subject.engine = [this] { return &*loop.engine; };
    subject.what_if = what_if;
    subject.controls = &controls;
    live.emplace(options, subject);
    const std::string link = live->link();
    port = std::stoi(link.substr(link.rfind(':') + 1));
    token = link.substr(link.rfind('=') + 1);
  }
  std::unique_ptr<TestViewer> connect(bool with_token = true) const {
    auto viewer = std::make_unique<TestViewer>(port);
    viewer->open(with_token ? token : "");
    viewer->await_operation("advertiseServices");
    return viewer;
  }
  /// Everything that the viewer sent before has arrived.
  static void sync(TestViewer& viewer) {
    viewer.send_text("sync");
    viewer.await([](const Received& one) { return one.data.find("'sync'") != std::string::npos; });
  }
  const FrameRecord& step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      live->add_to(loop.inputs);
      live->before(loop.inputs, *loop.engine);
      loop.wanted = live->wanted();
      loop.step();
      live->observe(loop.record(), scene);
    }
    return loop.record();
  }
  static void subscribe(const TestViewer& viewer, const std::vector<ViewerTopic>& topics) {
    json all = json::array();
    for (const ViewerTopic topic : topics) {
      const auto channel = channel_of(static_cast<std::size_t>(topic));
      all.push_back({{"id", 100 + channel}, {"channelId", channel}});
    }
    viewer.send_json({{"op", "subscribe"}, {"subscriptions", all}});
  }
  /// The next message of this topic.
  static json await_data(TestViewer& viewer, ViewerTopic topic) {
    const auto message = viewer.await([&](const Received& one) {
      std::uint32_t id = 0;
      if (one.opcode != kBinaryFrame || one.data.size() < kHeadOfData || one.data[0] != 1) return false;
      std::memcpy(&id, one.data.data() + 1, sizeof id);
      return id == 100 + channel_of(static_cast<std::size_t>(topic));
    });
    return message ? json::parse(message->data.substr(kHeadOfData)) : json();
  }
  double value(const std::string& name) const {
    for (const Parameter& parameter : loop.engine->parameters()) {
      if (parameter.name == name) return std::get<double>(parameter.value);
    }
    return -1.0;
  }

  TemporaryFolder folder;
  HandFedLoop loop{kIdle};
  RunControls controls{true, true};
  SceneTruth scene;
  std::shared_ptr<TestedWhatIf> what_if = std::make_shared<TestedWhatIf>();
  std::optional<LiveView> live;
  int port = 0;
  std::string token;
};

TEST_F(ViewedRun, IntroducesItselfWithTopicsAndServices) {
  start();
  for (const char* name : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    TestViewer viewer(port);
    EXPECT_TRUE(viewer.open(token, name).starts_with("HTTP/1.1 101 "));
    const json info = viewer.receive()->json();
    EXPECT_EQ(info["op"], "serverInfo");
    EXPECT_EQ(info["capabilities"], json({"parameters", "parametersSubscribe", "services", "time"}));
    EXPECT_EQ(viewer.receive()->json()["channels"].size(), kViewerTopics.size());
    const json services = viewer.receive()->json()["services"];
    ASSERT_EQ(services.size(), kServices.size());
    for (const json& service : services) {
      for (const char* part : {"request", "response"})
        EXPECT_EQ(json::parse(service[part]["schema"].get<std::string>())["type"], "object");
    }
  }
}

TEST_F(ViewedRun, CopiesNothingWithoutAViewer) {
  start();
  step(3);
  EXPECT_EQ(live->wanted(), Topics());
  const auto viewer = connect();
  step();
  EXPECT_EQ(live->wanted(), Topics()) << "a viewer without subscriptions";
  subscribe(*viewer, {ViewerTopic::costs});
  sync(*viewer);
  step();
  EXPECT_EQ(live->wanted(), Topics{Topic::costs});
}

TEST_F(ViewedRun, SendsEverySubscribedTopic) {
  start();
  scene.truth.emplace();
  const auto viewer = connect();
  const std::vector<ViewerTopic> topics{
      ViewerTopic::transforms, ViewerTopic::pose,       ViewerTopic::pose_particles,    ViewerTopic::truth,
      ViewerTopic::field,      ViewerTopic::wall,       ViewerTopic::upper_image,       ViewerTopic::upper_calibration,
      ViewerTopic::world,      ViewerTopic::machines,   ViewerTopic::upper_annotations, ViewerTopic::request,
      ViewerTopic::costs,      ViewerTopic::parameters, ViewerTopic::percepts,          ViewerTopic::room,
      ViewerTopic::conditions};
  for (const ViewerTopic topic : topics) {
    subscribe(*viewer, {topic});
    sync(*viewer);
    step(static_cast<int>(kParticlesEvery));
    EXPECT_TRUE(await_data(*viewer, topic).is_object()) << info(topic).name;
    viewer->send_json(
        {{"op", "unsubscribe"}, {"subscriptionIds", {100 + channel_of(static_cast<std::size_t>(topic))}}});
    sync(*viewer);
  }
}

TEST_F(ViewedRun, SendsLastingMessagesToLateSubscribersAtOnce) {
  start();
  const auto first = connect();
  subscribe(*first, {ViewerTopic::field, ViewerTopic::upper_calibration});
  sync(*first);
  step();
  EXPECT_TRUE(await_data(*first, ViewerTopic::field).is_object());
  EXPECT_TRUE(await_data(*first, ViewerTopic::upper_calibration).is_object());
  const auto second = connect();
  subscribe(*second, {ViewerTopic::field});
  EXPECT_TRUE(await_data(*second, ViewerTopic::field).is_object()) << "without another frame";
}

TEST(FrameMailbox, PassesTheMessagesOfABeginOnIfTheFrameIsDropped) {
  FrameMailbox mailbox;
  const auto add = [&](bool begins) {
    std::unique_ptr<FrameCopy> copy = mailbox.get_free();
    copy->begins = begins;
    copy->topics.reset().set(static_cast<std::size_t>(ViewerTopic::world));
    if (begins) copy->topics.set(static_cast<std::size_t>(ViewerTopic::field));
    mailbox.add(std::move(copy));
  };
  add(true);
  for (std::size_t i = 0; i < 2 * FrameMailbox::kMostWaiting; ++i) add(false);
  EXPECT_EQ(mailbox.dropped(), FrameMailbox::kMostWaiting + 1);
  const std::unique_ptr<FrameCopy> first = mailbox.take(), second = mailbox.take();
  EXPECT_TRUE(first->begins);
  EXPECT_TRUE(first->topics.test(static_cast<std::size_t>(ViewerTopic::field)));
  EXPECT_FALSE(second->begins);
  EXPECT_FALSE(second->topics.test(static_cast<std::size_t>(ViewerTopic::field)));
}

TEST(FrameMailbox, KeepsTheEventsOfFramesThatItDrops) {
  FrameMailbox mailbox;
  constexpr std::size_t kFrames = 2 * FrameMailbox::kMostEvents;
  for (std::size_t i = 0; i < kFrames; ++i) {
    std::unique_ptr<FrameCopy> copy = mailbox.get_free();
    copy->time = static_cast<double>(i);
    copy->topics.reset().set(static_cast<std::size_t>(ViewerTopic::world));
    if (i % 2 == 1) copy->topics.set(static_cast<std::size_t>(ViewerTopic::events));
    mailbox.add(std::move(copy));
  }
  std::vector<double> whole, events;
  while (const std::unique_ptr<FrameCopy> copy = mailbox.take()) {
    const bool is_whole = copy->topics.test(static_cast<std::size_t>(ViewerTopic::world));
    (is_whole ? whole : events).push_back(copy->time);
    EXPECT_TRUE(is_whole || whole.empty()) << "in the order of time";
  }
  EXPECT_EQ(whole.size(), FrameMailbox::kMostWaiting);
  ASSERT_EQ(events.size(), kFrames / 2 - FrameMailbox::kMostWaiting / 2);
  EXPECT_EQ(events.front(), 1.0);
  EXPECT_TRUE(mailbox.is_empty());
  EXPECT_EQ(mailbox.dropped(), kFrames - FrameMailbox::kMostWaiting);
}

TEST_F(ViewedRun, ShowsTheLastFrameToAViewerThatComesDuringAPause) {
  start();
  step();
  const auto first = connect(), second = connect();
  subscribe(*first, {ViewerTopic::world, ViewerTopic::pose});
  sync(*first);
  step();
  EXPECT_TRUE(await_data(*first, ViewerTopic::pose).is_object());
  live->add_while_paused(loop.inputs, loop.record(), scene);
  subscribe(*second, {ViewerTopic::world});
  EXPECT_TRUE(await_data(*second, ViewerTopic::world).is_object());
}

TEST_F(ViewedRun, SendsEventsOfAllFramesAlsoIfItShowsSome) {
  start({.every = 1000});
  step();
  const auto viewer = connect();
  subscribe(*viewer, {ViewerTopic::log, ViewerTopic::pose});
  viewer->call(id_of(Service::note), 1, R"({"text":"now"})");
  sync(*viewer);
  step();
  EXPECT_EQ(await_data(*viewer, ViewerTopic::log)["message"], "note: now");
}

TEST_F(ViewedRun, ChangesAParameterInTheNextFrame) {
  start();
  step();
  const auto viewer = connect();
  const double wanted = value(kParameter) * 1.5;
  viewer->send_json({{"op", "setParameters"},
                     {"id", "mine"},
                     {"parameters", {{{"name", kParameter}, {"value", wanted}, {"type", "float64"}}}}});
  sync(*viewer);
  step();
  EXPECT_EQ(value(kParameter), wanted) << "one frame after it arrived";
  const json values = viewer->await_operation("parameterValues");
  EXPECT_EQ(values["id"], "mine");
  ASSERT_EQ(values["parameters"].size(), 1u);
  EXPECT_EQ(values["parameters"][0]["value"], wanted);
}

TEST_F(ViewedRun, AnswersARefusedValueWithTheOneInForceAndTheReason) {
  start();
  step();
  const double before = value(kParameter);
  const auto viewer = connect();
  for (const json& bad : {json(-1e9), json("many"), json(true), json(), json::array({1}), json::object()}) {
    viewer->send_json({{"op", "setParameters"},
                       {"id", "mine"},
                       {"parameters", {{{"name", kParameter}, {"value", bad}}, {{"name", "no.such"}, {"value", 1}}}}});
    sync(*viewer);
    step();
    const json values = viewer->await_operation("parameterValues");
    ASSERT_EQ(values["parameters"].size(), 1u) << bad;
    EXPECT_EQ(values["parameters"][0]["value"], before) << bad;
    std::string reasons;
    for (int i = 0; i < 2; ++i) {
      const json status = viewer->await_operation("status");
      EXPECT_EQ(status["level"], 1);
      reasons += status["message"].get<std::string>();
    }
    EXPECT_NE(reasons.find(kParameter), std::string::npos) << reasons;
    EXPECT_NE(reasons.find("no.such"), std::string::npos) << reasons;
  }
  EXPECT_EQ(value(kParameter), before);
}

TEST_F(ViewedRun, GetsAllParametersOrSome) {
  start();
  step();
  const auto viewer = connect(false);
  viewer->send_json({{"op", "getParameters"}, {"parameterNames", json::array()}, {"id", "all"}});
  viewer->send_json({{"op", "getParameters"}, {"parameterNames", {kParameter, "no.such"}}, {"id", "one"}});
  sync(*viewer);
  step();
  EXPECT_EQ(viewer->await_operation("parameterValues")["parameters"].size(), loop.engine->parameters().size());
  const json one = viewer->await_operation("parameterValues");
  EXPECT_EQ(one["id"], "one");
  EXPECT_EQ(one["parameters"].size(), 1u);
}

TEST_F(ViewedRun, SendsChangesToViewersThatWatchThem) {
  start();
  step();
  const auto watcher = connect(false), other = connect();
  watcher->send_json({{"op", "getParameters"}, {"parameterNames", json::array()}});
  watcher->send_json({{"op", "subscribeParameterUpdates"}, {"parameterNames", {kParameter}}});
  sync(*watcher);
  step();
  watcher->await_operation("parameterValues");
  other->call(id_of(Service::set_parameters), 1, json{{"parameters", {{{"name", kParameter}, {"value", 3.0}}}}}.dump());
  sync(*other);
  step();
  json changed;
  do {
    changed = watcher->await_operation("parameterValues")["parameters"];
  } while (!changed.is_null() && (changed.size() != 1 || changed[0]["value"] != 3.0));
  EXPECT_EQ(changed[0]["name"], kParameter);
}

TEST_F(ViewedRun, AnswersEachServiceAsItsExampleShows) {
  start();
  step();
  const auto viewer = connect();
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());  // `save` writes there
  std::uint32_t call = 0;
  for (const ServiceRow& row : kServices) {
    std::string request(row.request);
    // The names of the shipped scripts are those of the example.
    for (const auto& [shipped, own] : std::map<std::string, std::string>{{"orientation.lingering", kParameter},
                                                                         {"orientation.lua", "tested.lua"},
                                                                         {"\"orientation\"", "\"tested\""}}) {
      if (const std::size_t place = request.find(shipped); place != std::string::npos)
        request.replace(place, shipped.size(), own);
    }
    viewer->call(id_of(row.service), ++call, request);
    // Those of scripts are answered without a frame.
    const bool is_at_once = row.service == Service::scripts || row.service == Service::script ||
                            row.service == Service::check_script || row.service == Service::save_script ||
                            row.service == Service::what_if || row.service == Service::file_parameters;
    if (!is_at_once) sync(*viewer);
    step();
    const json response = viewer->await_response(call);
    const json shown = json::parse(row.response);
    for (const auto& [member, example] : shown.items())
      EXPECT_TRUE(response.contains(member)) << row.name << ": " << response.dump().substr(0, 300);
  }
  std::filesystem::current_path(before);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "tuned.toml"));
}

TEST_F(ViewedRun, KeepsFramesForWhatIfOnlyWhileAViewerIsConnected) {
  start();
  step(3);
  EXPECT_EQ(what_if->frames, 0);
  auto viewer = connect();
  step(2);
  EXPECT_EQ(what_if->frames, 2);
}

TEST_F(ViewedRun, AnswersTheNewestQuestionOfAViewerAndStopsTheOthers) {
  start();
  step();
  const auto viewer = connect(), other = connect();
  viewer->call(id_of(Service::what_if), 1, R"({"slow":1})");
  ASSERT_TRUE(await([&] { return what_if->is_busy.load(); }));
  other->call(id_of(Service::what_if), 1, "{}");
  viewer->call(id_of(Service::parameter_list), 2, "{}");
  sync(*viewer);
  step();
  EXPECT_TRUE(viewer->await_response(2).contains("parameters")) << "a question does not delay other messages";
  EXPECT_EQ(what_if->stopped, 0);
  viewer->call(id_of(Service::what_if), 3, R"({"slow":2})");
  viewer->call(id_of(Service::what_if), 4, "{}");
  auto answers = viewer->await_responses({1, 3, 4});
  const std::string stopped = answers[1].value("message", ""), replaced = answers[3].value("message", "");
  EXPECT_EQ(stopped.substr(0, 14), "it was stopped");
  EXPECT_EQ(stopped.find('\x1b'), std::string::npos);
  EXPECT_NE(replaced, "");
  EXPECT_TRUE(answers[4].contains("first_decision"));
  EXPECT_TRUE(other->await_response(1).contains("first_decision"));
}

TEST_F(ViewedRun, StopsAQuestionIfItsViewerLeavesOrTheRunEnds) {
  start();
  step();
  auto viewer = connect();
  viewer->call(id_of(Service::what_if), 1, R"({"slow":1})");
  ASSERT_TRUE(await([&] { return what_if->is_busy.load(); }));
  viewer->close();
  EXPECT_TRUE(await([&] { return what_if->stopped == 1; }));
  what_if->is_busy = false;
  viewer = connect();
  viewer->call(id_of(Service::what_if), 2, R"({"slow":2})");
  ASSERT_TRUE(await([&] { return what_if->is_busy.load(); }));
  live.reset();
  EXPECT_EQ(what_if->stopped, 2);
}

TEST_F(ViewedRun, SaysThatItKeepsNoFrames) {
  what_if.reset();
  start();
  step();
  const auto viewer = connect();
  viewer->call(id_of(Service::what_if), 1, "{}");
  EXPECT_NE(viewer->await_response(1).value("message", "").find("keeps no frames"), std::string::npos);
}

TEST_F(ViewedRun, DescribesParametersForAPage) {
  start();
  step();
  const auto viewer = connect(false);
  viewer->call(id_of(Service::parameter_list), 1, "{}");
  sync(*viewer);
  step();
  const json all = viewer->await_response(1)["parameters"];
  ASSERT_EQ(all.size(), loop.engine->parameters().size());
  for (const json& one : all) {
    for (const char* member : {"name", "value", "default", "unit", "description", "origin", "type"})
      EXPECT_TRUE(one.contains(member)) << one;
    EXPECT_EQ(one.contains("min"), one["type"] == "real" || one["type"] == "integer") << one;
  }
}

TEST_F(ViewedRun, UndoesChangesOfViewersOneAfterTheOther) {
  start();
  step();
  const double before = value(kParameter);
  const auto viewer = connect();
  std::uint32_t call = 0;
  const auto set = [&](double to) {
    viewer->call(id_of(Service::set_parameters), ++call,
                 json{{"parameters", {{{"name", kParameter}, {"value", to}}}}}.dump());
    sync(*viewer);
    step();
    return viewer->await_response(call);
  };
  const auto undo = [&] {
    viewer->call(id_of(Service::undo), ++call, "{}");
    sync(*viewer);
    step();
    return viewer->await_response(call);
  };
  set(2.5);
  set(3.5);
  EXPECT_EQ(set(-1e9)["refused"].size(), 1u) << "a refused change is not undone";
  EXPECT_EQ(undo()["parameters"][0]["value"], 2.5);
  EXPECT_EQ(undo()["parameters"][0]["value"], before);
  EXPECT_EQ(undo()["op"], "serviceCallFailure");
  EXPECT_EQ(value(kParameter), before);
  const std::vector<Parameter> all = loop.engine->parameters();
  const auto found = std::find_if(all.begin(), all.end(), [](const Parameter& one) { return one.name == kParameter; });
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->origin, ParameterOrigin::default_value) << "an edit of the default would not be hidden";
}

TEST(LiveServices, HaveSchemasThatFoxgloveSupports) {
  const json advertised = json::parse(advertise_live_services());
  for (const json& service : advertised["services"]) {
    for (const char* part : {"request", "response"}) {
      const std::string text = service[part]["schema"];
      EXPECT_EQ(unsupported(json::parse(text), service["name"].get<std::string>() + " " + part), "");
    }
  }
}

TEST_F(ViewedRun, IsNotChangedWithoutTheToken) {
  start();
  step();
  const double before = value(kParameter);
  const auto viewer = connect(false);
  EXPECT_NE(viewer->await_operation("status")["message"].get<std::string>().find("token"), std::string::npos);
  std::uint32_t call = 0;
  for (const ServiceRow& row : kServices) {
    if (!row.changes) continue;
    viewer->call(id_of(row.service), ++call, std::string(row.request));
    const json response = viewer->await_response(call);
    EXPECT_EQ(response["op"], "serviceCallFailure") << row.name;
    EXPECT_NE(response["message"].get<std::string>().find("token"), std::string::npos) << response;
  }
  viewer->send_json({{"op", "setParameters"}, {"id", "x"}, {"parameters", {{{"name", kParameter}, {"value", 3.0}}}}});
  EXPECT_NE(viewer->await_operation("status")["message"].get<std::string>().find("token"), std::string::npos);
  sync(*viewer);
  step(2);
  EXPECT_EQ(viewer->await_operation("parameterValues")["parameters"][0]["value"], before);
  EXPECT_EQ(value(kParameter), before);
  viewer->call(id_of(Service::save_script), ++call,
               json{{"file", "behaviors/tested.lua"}, {"text", ""}, {"expected", kIdle}}.dump());
  EXPECT_NE(viewer->await_response(call).value("message", "").find("token"), std::string::npos);
  EXPECT_EQ(read_input(folder.path() / "scripts/behaviors/tested.lua", "a script"), kIdle);
}

TEST_F(ViewedRun, RefusesHostileCallsWithOneLine) {
  start();
  step();
  const auto viewer = connect();
  std::uint32_t call = 0;
  const auto failure = [&](std::uint32_t service, const std::string& payload, const std::string& encoding = "json") {
    viewer->call(service, ++call, payload, encoding);
    const json response = viewer->await_response(call);
    EXPECT_EQ(response["op"], "serviceCallFailure") << payload.substr(0, 100) << response.dump().substr(0, 200);
    return response.value("message", "");
  };
  EXPECT_NE(failure(0, "{}"), "");
  EXPECT_NE(failure(kServiceCount + 1, "{}"), "");
  EXPECT_NE(failure(id_of(Service::note), "{}", "cdr").find("json"), std::string::npos);
  for (const char* payload : {"", "{", "[]", "{}", R"({"text":3})", R"({"text":""})"})
    EXPECT_NE(failure(id_of(Service::note), payload), "") << payload;
  EXPECT_NE(failure(id_of(Service::note), R"({"text":")" + std::string(1001, 'x') + "\"}").find("bytes"),
            std::string::npos);
  const std::string huge(100'000, 'x');
  for (const auto& [service, member] : {std::pair{Service::why, "machine"}, {Service::world, "pattern"}})
    EXPECT_NE(failure(id_of(service), json{{member, huge}}.dump()).find("bytes"), std::string::npos);
  EXPECT_NE(failure(id_of(Service::script), json{{"file", huge}}.dump()).find("unknown script"), std::string::npos);
  for (const char* file : {"", "/etc/passwd", "../scripts/behaviors/tested.lua", "behaviors/../behaviors/tested.lua",
                           "behaviors", "behaviors/tested.lua\\u0000"})
    EXPECT_NE(failure(id_of(Service::script), std::string(R"({"file":")") + file + "\"}").find("unknown script"),
              std::string::npos)
        << file;
  for (const char* file : {"", ".toml", "../x.toml", "/tmp/x.toml", "x.lua", "a/b.toml", ".x.toml", "x .toml"})
    for (const Service service : {Service::save, Service::file_parameters})
      EXPECT_NE(failure(id_of(service), std::string(R"({"file":")") + file + "\"}").find(".toml"), std::string::npos)
          << file;
  EXPECT_NE(failure(id_of(Service::file_parameters), R"({"file":"no_such.toml"})").find("no_such.toml"),
            std::string::npos);
  EXPECT_NE(failure(id_of(Service::reload), R"({"script":"no_such"})").find("unknown script"), std::string::npos);
  viewer->call(id_of(Service::why), ++call, R"({"machine":"unknown"})");
  sync(*viewer);
  step();
  EXPECT_NE(viewer->await_response(call).value("message", "").find("unknown machine"), std::string::npos);
}

TEST_F(ViewedRun, AnswersEveryMessageOfTheProtocol) {
  start();
  step();
  const auto viewer = connect();
  const auto warning = [&](const json& message) {
    viewer->send_json(message);
    const json status = viewer->await_operation("status");
    EXPECT_EQ(status["level"], 1);
    return status.value("message", "");
  };
  for (const char* op : {"advertise", "unadvertise", "subscribeConnectionGraph", "unsubscribeConnectionGraph"})
    EXPECT_NE(warning({{"op", op}}).find("does not offer"), std::string::npos);
  EXPECT_NE(
      warning({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", 999}}}}}).find("unknown channel"),
      std::string::npos);
  subscribe(*viewer, {ViewerTopic::pose});
  EXPECT_NE(warning({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", 2}}}}}), "")
      << "the same channel twice";
  EXPECT_NE(warning({{"op", "subscribe"}, {"subscriptions", {{{"id", 102}, {"channelId", 1}}}}}), "")
      << "the same id twice";
  EXPECT_NE(warning({{"op", "unsubscribe"}, {"subscriptionIds", {77}}}).find("unknown subscription"),
            std::string::npos);
  EXPECT_NE(warning({{"op", "setParameters"}, {"parameters", json::array()}}), "");
  viewer->send_json({{"op", "fetchAsset"}, {"uri", "package://robot/nao.urdf"}, {"requestId", 5}});
  const auto asset = viewer->await([](const Received& one) { return one.opcode == kBinaryFrame && one.data[0] == 4; });
  ASSERT_TRUE(asset);
  EXPECT_EQ(asset->data[5], 1);
  viewer->send_bytes(client_frame(kBinaryFrame, std::string("\x01\x01\0\0\0{}", 7)));
  EXPECT_NE(viewer->await_operation("status").value("message", "").find("does not offer"), std::string::npos);
  viewer->send_bytes(client_frame(kBinaryFrame, std::string("\x03", 1) + std::string(18, '\0')));
  EXPECT_NE(viewer->await_operation("status").value("message", "").find("replay"), std::string::npos);
}

TEST_F(ViewedRun, NeverWaitsForAViewerThatDoesNotRead) {
  start({.viewer_bytes = 100'000});
  const auto stalled = std::make_unique<TestViewer>(port, 4096);
  stalled->open(token);
  const std::vector<ViewerTopic> topics = all_topics();
  subscribe(*stalled, topics);
  // The frames go on until the viewer's memory is full, and messages are dropped.
  EXPECT_TRUE(await([&] {
    step();
    return live->counts().dropped_messages > 10;
  }));
  const json status = [&] {
    std::optional<Received> found = stalled->await([](const Received& one) {
      return one.opcode == kTextFrame && one.data.find("Send buffer limit reached") != std::string::npos;
    });
    return found ? found->json() : json();
  }();
  EXPECT_EQ(status["message"], "Send buffer limit reached");
}

TEST_F(ViewedRun, SendsAllEventsAndTheNewestFrameToASlowViewer) {
  start();
  TestViewer viewer(port, 4096);
  viewer.answers_pings = true;
  viewer.open(token);
  viewer.await_operation("advertiseServices");
  subscribe(viewer, all_topics());
  sync(viewer);
  step();
  EXPECT_TRUE(await_data(viewer, ViewerTopic::world).is_object());
  // The viewer reads nothing while the run continues with a note in each frame.
  std::size_t notes = 0;
  EXPECT_TRUE(await([&] {
    loop.inputs.external.notes.push_back("note " + std::to_string(notes++));
    step();
    return live->counts().left_out.frames > 20;
  }));
  const double newest = loop.record().world.time;
  const FrameCounts left_out = live->counts().left_out;
  std::size_t worlds = 0, next_note = 0;
  bool has_newest = false;
  while (next_note < notes || !has_newest) {
    const auto message = viewer.receive();
    ASSERT_TRUE(message) << next_note << " of " << notes << " notes";
    if (message->opcode != kBinaryFrame || message->data[0] != 1) continue;
    const json data = json::parse(message->data.substr(kHeadOfData));
    if (data.value("message", "") == "note: note " + std::to_string(next_note)) ++next_note;
    std::uint64_t time = 0;
    std::uint32_t id = 0;
    std::memcpy(&id, message->data.data() + 1, sizeof id);
    std::memcpy(&time, message->data.data() + 5, sizeof time);
    if (id != 100 + channel_of(static_cast<std::size_t>(ViewerTopic::world))) continue;
    ++worlds;
    has_newest = time == to_nanoseconds(newest);
  }
  EXPECT_LE(worlds, notes - left_out.frames + 1);
}

TEST_F(ViewedRun, RefusesManyAndHugeNamesWithoutDelay) {
  start();
  step();
  const auto viewer = connect();
  json many = json::array();
  for (int i = 0; i < 201; ++i) many.push_back({{"name", "no.such" + std::to_string(i)}, {"value", 1}});
  viewer->send_json({{"op", "setParameters"}, {"id", "many"}, {"parameters", many}});
  viewer->send_json(
      {{"op", "setParameters"}, {"id", "huge"}, {"parameters", {{{"name", std::string(500'000, 'x')}, {"value", 1}}}}});
  sync(*viewer);
  step();
  EXPECT_NE(viewer->await_operation("status").value("message", "").find("at most 200"), std::string::npos);
  EXPECT_LT(viewer->await_operation("status").value("message", "").size(), 300u);
}

TEST_F(ViewedRun, RefusesRequestsThatComeTooFast) {
  start();
  step();
  const auto viewer = connect();
  std::string flood;
  for (int i = 0; i < 400; ++i)
    flood += client_frame(kTextFrame, R"({"op":"getParameters","parameterNames":["no.such"]})");
  viewer->send_bytes(flood);
  EXPECT_NE(viewer->await_operation("status").value("message", "").find("too many requests"), std::string::npos);
  step(40);
  EXPECT_EQ(viewer->await_operation("parameterValues")["parameters"].size(), 0u) << "the first ones are answered";
}

TEST_F(ViewedRun, AnswersWithoutFrames) {
  start();
  const auto viewer = connect();
  viewer->send_json({{"op", "setParameters"}, {"id", "x"}, {"parameters", {{{"name", kParameter}, {"value", 3.0}}}}});
  viewer->call(id_of(Service::note), 1, R"({"text":"now"})");
  sync(*viewer);
  live->poll_without_frames("no robot is connected");
  EXPECT_EQ(viewer->await_operation("status").value("message", ""), "no robot is connected");
  EXPECT_EQ(viewer->await_response(1).value("message", ""), "no robot is connected");
}

TEST_F(ViewedRun, IsTheSameWithAndWithoutViewers) {
  start();
  const auto viewer = connect();
  const std::vector<ViewerTopic> topics = all_topics();
  subscribe(*viewer, topics);
  sync(*viewer);
  HandFedLoop alone{kIdle};
  RecordDigest viewed, unviewed;
  for (int i = 0; i < 60; ++i) {
    viewed.add(step());
    unviewed.add(alone.step());
  }
  EXPECT_EQ(viewed.digest().hex(), unviewed.digest().hex());
}

TEST_F(ViewedRun, SendsTheThresholdsOfTheEvidenceWhenTheyChange) {
  const std::string library = read_input(std::filesystem::path(kSourceFolder) / "scripts/lib/decision.lua", "it");
  start();
  loop.inputs.script_edits = {
      {"lib/decision.lua", ScriptText{library, ""}},
      {"behaviors/tested.lua", ScriptText{"require 'lib.decision'\n" + std::string(kIdle), ""}}};
  step(2);
  const auto viewer = connect();
  subscribe(*viewer, {ViewerTopic::decision});
  viewer->call(id_of(Service::set_parameters), 1, R"({"parameters":[{"name":"decision.least","value":7}]})");
  sync(*viewer);
  step();
  EXPECT_EQ(await_data(*viewer, ViewerTopic::decision)["unconfirmed"], 7.0);
  viewer->call(id_of(Service::set_parameters), 2, R"({"parameters":[{"name":"decision.least","value":8}]})");
  sync(*viewer);
  step();
  EXPECT_EQ(await_data(*viewer, ViewerTopic::decision)["unconfirmed"], 8.0) << "in the frame of the change";
}

constexpr const char* kWaiting = R"(behavior "tested" {
  initial = "dark",
  state "dark" {
    { "bright", when = function() return confidence.status == "usable" or robot.penalized end, lasting = 0.5, because = "light" },
  },
  state "bright" {},
})";

TEST_F(ViewedRun, DescribesAMachineAsItRuns) {
  start();
  step();
  const auto viewer = connect(false);
  std::uint32_t call = 0;
  const auto described = [&] {
    viewer->call(id_of(Service::machine), ++call, R"({"machine":"tested"})");
    sync(*viewer);
    step();
    return viewer->await_response(call);
  };
  EXPECT_TRUE(described()["machine"]["transitions"].empty());
  folder.write("scripts/behaviors/tested.lua", "-- not what runs");
  loop.inputs.script_edits.push_back({"behaviors/tested.lua", ScriptText{kWaiting, ""}});
  step();
  const json answer = described();
  EXPECT_NEAR(answer["time"], loop.world().time, 1e-9);
  const json& machine = answer["machine"];
  EXPECT_EQ(machine["states"].size(), 3u);
  ASSERT_EQ(machine["transitions"].size(), 1u);
  EXPECT_EQ(machine["transitions"][0]["line"], 4);
  EXPECT_EQ(machine["transitions"][0]["lasting"], "0.5 s");
  EXPECT_EQ(machine["transitions"][0]["reads"], json({"confidence.status", "robot.penalized"}));
}

TEST_F(ViewedRun, SendsTheOpenTransitionsOfEachFrame) {
  start();
  loop.inputs.script_edits.push_back({"behaviors/tested.lua", ScriptText{kWaiting, ""}});
  step();
  const auto viewer = connect();
  subscribe(*viewer, {ViewerTopic::conditions});
  sync(*viewer);
  step();
  json open = await_data(*viewer, ViewerTopic::conditions)["conditions"];
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0]["target"], "bright");
  EXPECT_EQ(open[0]["when"], "no");
  EXPECT_EQ(open[0]["lasting"], 0.5);
  for (int i = 0; i < 4; ++i) {
    loop.inputs.external.referee = RefereeState{.penalized = true};
    step();
    open = await_data(*viewer, ViewerTopic::conditions)["conditions"];
  }
  EXPECT_EQ(open[0]["when"], "yes");
  EXPECT_NEAR(open[0]["held"], 3 * HandFedLoop::kStep, 1e-3);
}

TEST_F(ViewedRun, DescribesNoMachineWithAHostileName) {
  start();
  step();
  const auto viewer = connect(false);
  std::uint32_t call = 0;
  const auto refusal = [&](const std::string& payload, bool needs_frame) {
    viewer->call(id_of(Service::machine), ++call, payload);
    if (needs_frame) {
      sync(*viewer);
      step();
    }
    const json refused = viewer->await_response(call);
    EXPECT_EQ(refused.value("op", ""), "serviceCallFailure") << payload;
    return refused.value("message", "");
  };
  for (const char* payload : {"", "{", "[]", "{}", R"({"machine":3})", R"({"machine":null})"})
    EXPECT_NE(refusal(payload, false), "") << payload;
  for (const char* name : {"", "testd", "../tested", "tested\\u0000", "\\u001b[2J\\nx"}) {
    const std::string reason = refusal(std::string(R"({"machine":")") + name + "\"}", true);
    EXPECT_TRUE(reason.starts_with("unknown machine '")) << reason;
    EXPECT_EQ(reason.find_first_of("\n\x1b"), std::string::npos) << reason;
  }
  EXPECT_NE(refusal(json{{"machine", std::string(5000, 'x')}}.dump(), false).find("at most 100 bytes"),
            std::string::npos);
}

TEST_F(ViewedRun, DescribesAMachineAlsoWithoutFrames) {
  start();
  step();
  const auto viewer = connect(false);
  viewer->call(id_of(Service::machine), 1, R"({"machine":"tested"})");
  viewer->call(id_of(Service::machine), 2, R"({"machine":"unknown"})");
  sync(*viewer);
  live->poll_without_frames("the replay is paused; play it first");
  EXPECT_EQ(viewer->await_response(1)["machine"]["name"], "tested");
  EXPECT_NE(viewer->await_response(2).value("message", "").find("unknown machine"), std::string::npos);
}

TEST(LiveViewPage, ListsTheServicesAsTheyAre) {
  const std::string page = read_input(std::filesystem::path(kSourceFolder) / "docs" / "live-view.md", "the page");
  for (const ServiceRow& row : kServices) {
    const std::string line = "| `" + std::string(row.name) + "` | " + (row.changes ? "yes" : "no") + " | " +
                             std::string(row.description) + " | `" + std::string(row.request) + "` | `" +
                             std::string(row.response) + "` |";
    EXPECT_NE(page.find(line + "\n"), std::string::npos) << "docs/live-view.md lacks the line\n" << line;
  }
}

}  // namespace
}  // namespace reorient::live
