// SPDX-License-Identifier: MIT
// Viewers act as the operator, and set the pace of a run.
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/temporary_folder.h"
#include "tests/workbench/run/hand_fed_robot.h"
#include "tests/workbench/views/live/test_viewer.h"
#include "workbench/views/live/live_view.h"
#include "workbench/views/live/services.h"

namespace reorient::live {
namespace {

using nlohmann::json;
using Texts = std::vector<std::string>;

/// A run whose loop is stepped by the test, with one viewer.
class RunOfAViewer : public ::testing::Test {
 protected:
  void start(bool has_operator = true, bool sets_pace = true, bool is_replay = false,
             std::optional<double> data_start = {}) {
    run.emplace(has_operator, sets_pace);
    LiveSubject subject;
    subject.parameters = [this] { return run->loop.engine->parameters(); };
    subject.scripts = folder.path();
    subject.controls = is_replay ? nullptr : &run->controls;
    live.emplace(LiveViewOptions{.port = 0, .data_start = data_start}, subject);
    run_loop.emplace(run->parts({&*live}, {&*live}));
    viewer = connect(true);
    run_loop->step();
  }
  std::unique_ptr<TestViewer> connect(bool with_token) const {
    const std::string link = live->link();
    auto one = std::make_unique<TestViewer>(std::stoi(link.substr(link.rfind(':') + 1)));
    one->open(with_token ? link.substr(link.rfind('=') + 1) : "");
    one->await_operation("advertiseServices");
    return one;
  }
  /// Everything that the viewer sent before has arrived.
  static void sync(TestViewer& one) {
    one.send_text("sync");
    one.await([](const Received& message) { return message.data.find("'sync'") != std::string::npos; });
  }
  void send(Service service, const json& request) {
    viewer->call(id_of(service), ++call, request.dump());
    sync(*viewer);
  }
  /// The response after one frame.
  json answer(Service service, const json& request) {
    send(service, request);
    run_loop->step();
    return viewer->await_response(call);
  }
  /// The response of a paused run.
  json answer_in_pause(Service service, const json& request) {
    send(service, request);
    poll();
    return viewer->await_response(call);
  }
  /// As the run loop in a pause.
  void poll() { live->add_while_paused(inputs_of_pause, run->loop.record(), run_loop->scene()); }
  /// A message for a viewer that connects during a pause or in a paused replay. `rest`: a part of the pause that makes
  /// it; empty: it was made for another viewer.
  json shown_to_a_late_viewer(ViewerTopic topic, const std::function<void()>& rest) const {
    const auto late = connect(false);
    const auto channel = channel_of(static_cast<std::size_t>(topic));
    late->send_json({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", channel}}}}});
    if (rest) {
      sync(*late);
      rest();
    }
    const auto message =
        late->await([](const Received& one) { return one.opcode == kBinaryFrame && one.data[0] == 1; });
    return message ? json::parse(message->data.substr(13)) : json();
  }
  std::string failure(Service service, const json& request) { return answer(service, request).value("message", ""); }
  /// Why a request is refused before it reaches the run.
  std::string refusal(Service service, const json& request) {
    viewer->call(id_of(service), ++call, request.dump());
    return viewer->await_response(call).value("message", "");
  }

  TemporaryFolder folder;
  std::optional<HandFedRun> run;
  std::optional<LiveView> live;
  std::optional<RunLoop> run_loop;
  std::unique_ptr<TestViewer> viewer;
  FrameInputs inputs_of_pause;
  std::uint32_t call = 0;
};

TEST_F(RunOfAViewer, ShowsItsOperatorAndItsPace) {
  start();
  const auto guest = connect(false);
  guest->call(id_of(Service::run_state), 1, "{}");
  sync(*guest);
  run_loop->step();
  const json state = guest->await_response(1);
  EXPECT_EQ(state["operator"], true);
  EXPECT_EQ(state["pace"], true);
  EXPECT_EQ(state["paused"], false);
  EXPECT_EQ(state["speed"], 1.0);
}

TEST_F(RunOfAViewer, CarriesOutItsActions) {
  start();
  EXPECT_TRUE(answer(Service::operate, {{"action", "pick_up"}}).contains("time"));
  run_loop->step();
  EXPECT_EQ(run->robot->done, (Texts{"pick_up"}));
  ASSERT_EQ(run_loop->scene().scenario.logs.size(), 1u);
  const LogRecord& log = run_loop->scene().scenario.logs[0];
  EXPECT_EQ(run_loop->scene().scenario.name(log.machine), "viewer");
  EXPECT_EQ(log.text, "pick_up");
  answer(Service::operate, {{"action", "put_down"}, {"x", 1.0}, {"y", -2.0}, {"degrees", 90}});
  answer(Service::operate, {{"action", "penalize"}, {"penalized", false}});
  answer(Service::operate, {{"action", "set_exposure_compensation"}, {"stops", -1}});
  answer(Service::operate, {{"action", "mirror"}});
  run_loop->step();
  EXPECT_EQ(run->robot->done,
            (Texts{"pick_up", "put_down", "end the penalty", "light -1.000000", "pick_up", "put_down"}));
  expect_near(run->robot->pose, reflect(Pose2(1.0, -2.0, 0.5 * kPi)), 1e-9);
}

TEST_F(RunOfAViewer, UndoesTheChangeThatItRequestedLastInAPausedRun) {
  const std::string name = "field_features.pixel_deviation";
  const auto value = [&] {
    const std::vector<Parameter> all = run->loop.engine->parameters();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Parameter& one) { return one.name == name; });
    return std::get<double>(found->value);
  };
  start();
  const double standard = value();
  const auto request = [&](Service service, const json& content) {
    send(service, content);
    poll();
    return call;
  };
  const auto set = [&](double to) {
    return request(Service::set_parameters, {{"parameters", {{{"name", name}, {"value", to}}}}});
  };
  const auto frame = [&] {  // as in the run loop, with the inputs of the pause
    run->loop.engine->step({run->loop.inputs.observation, inputs_of_pause.parameter_changes, {}, {}});
    inputs_of_pause.parameter_changes.clear();
    live->observe(run->loop.record(), run_loop->scene());
  };
  const std::uint32_t first = set(3.0), refused = set(-1.0), last = set(4.0),
                      undo = request(Service::undo, json::object());
  frame();
  EXPECT_EQ(value(), 3.0);
  EXPECT_EQ(viewer->await_response(first)["parameters"][0]["value"], 3.0);
  EXPECT_EQ(viewer->await_response(refused)["refused"].size(), 1u);
  EXPECT_EQ(viewer->await_response(last)["parameters"][0]["value"], 3.0) << "the value in force after the frame";
  EXPECT_EQ(viewer->await_response(undo)["parameters"][0]["value"], 3.0);
  const std::uint32_t again = request(Service::undo, json::object());
  frame();
  EXPECT_EQ(viewer->await_response(again)["parameters"][0]["value"], standard);
  EXPECT_EQ(value(), standard);
}

TEST_F(RunOfAViewer, RefusesHostileActionsWithOneLine) {
  start();
  const json put_down{{"action", "put_down"}, {"x", 1.0}, {"y", 2.0}, {"degrees", 3.0}};
  for (const char* member : {"x", "y", "degrees"}) {
    for (const json& bad :
         {json("1"), json(true), json(), json::array({1}), json::object(), json(1e300), json(-1e300)}) {
      json request = put_down;
      request[member] = bad;
      EXPECT_NE(refusal(Service::operate, request).find("expected"), std::string::npos) << request;
    }
    json request = put_down;
    request.erase(member);
    EXPECT_NE(refusal(Service::operate, request).find("found none"), std::string::npos) << request;
  }
  for (const json& bad : {json(), json(3), json(""), json("half_time"), json(std::string(10'000, 'x'))})
    EXPECT_LT(refusal(Service::operate, {{"action", bad}}).size(), 300u);
  EXPECT_NE(refusal(Service::operate, json::object()).find("action"), std::string::npos);
  EXPECT_NE(refusal(Service::operate, {{"action", "penalize"}, {"penalized", 1}}).find("true or false"),
            std::string::npos);
  EXPECT_NE(refusal(Service::operate, {{"action", "set_exposure_compensation"}, {"stops", 1e9}}).find("-8 to 8"),
            std::string::npos);
  for (const json& bad : {json(0), json(1.5), json(1001), json(-1), json(1e300), json("1"), json()})
    EXPECT_NE(refusal(Service::pace, {{"action", "frame"}, {"frames", bad}}).find("expected"), std::string::npos)
        << bad;
  for (const json& bad : {json("1"), json(), json(true)})
    EXPECT_NE(refusal(Service::pace, {{"action", "speed"}, {"factor", bad}}).find("a number"), std::string::npos)
        << bad;
  for (const double bad : {0.0, 0.04, 21.0, -1.0, 1e300})
    EXPECT_NE(failure(Service::pace, {{"action", "speed"}, {"factor", bad}}).find("0.05 to 20"), std::string::npos)
        << bad;
  EXPECT_NE(refusal(Service::pace, {{"action", "speed"}}).find("found none"), std::string::npos);
  EXPECT_NE(refusal(Service::pace, {{"action", "stop"}}).find("pause, resume, frame or speed"), std::string::npos);
  run_loop->step();
  EXPECT_EQ(run->robot->done, Texts());
  EXPECT_FALSE(run->controls.pace().is_paused());
}

TEST_F(RunOfAViewer, IsRefusedWithoutAnOperatorOrAPace) {
  start(false, false);
  EXPECT_NE(failure(Service::operate, {{"action", "pick_up"}}).find("can lift and place"), std::string::npos);
  EXPECT_NE(failure(Service::pace, {{"action", "pause"}}).find("sets its own pace"), std::string::npos);
  EXPECT_TRUE(
      answer(Service::operate, {{"action", "set_initial_pose"}, {"x", 1}, {"y", 2}, {"degrees", 3}}).contains("time"));
  const json state = answer(Service::run_state, json::object());
  EXPECT_EQ(state["operator"], false);
  EXPECT_EQ(state["pace"], false);
}

TEST_F(RunOfAViewer, IsRefusedInAReplay) {
  start(true, true, true);
  EXPECT_EQ(failure(Service::operate, {{"action", "pick_up"}}), "expected a run, found a replay");
  EXPECT_EQ(failure(Service::pace, {{"action", "pause"}}), "expected a run, found a replay");
  EXPECT_EQ(answer(Service::run_state, json::object())["operator"], false);
}

TEST_F(RunOfAViewer, AnswersWhileItIsPaused) {
  start();
  EXPECT_EQ(answer(Service::pace, {{"action", "pause"}})["paused"], true);
  EXPECT_FALSE(run->controls.pace().permits_frame());
  EXPECT_EQ(answer_in_pause(Service::run_state, json::object())["paused"], true);
  EXPECT_EQ(answer_in_pause(Service::parameter_list, json::object())["parameters"].size(),
            run->loop.engine->parameters().size());
  EXPECT_TRUE(answer_in_pause(Service::operate, {{"action", "pick_up"}}).contains("time"));
  EXPECT_EQ(answer_in_pause(Service::pace, {{"action", "speed"}, {"factor", 4}})["speed"], 4.0);
  EXPECT_EQ(run->robot->done, Texts()) << "before the next frame";
  EXPECT_EQ(answer_in_pause(Service::pace, {{"action", "frame"}})["paused"], true);
  EXPECT_TRUE(run->controls.pace().permits_frame());
  run_loop->step();
  EXPECT_EQ(run->robot->done, (Texts{"pick_up"}));
  EXPECT_FALSE(run->controls.pace().permits_frame());
  EXPECT_EQ(answer_in_pause(Service::pace, {{"action", "resume"}})["paused"], false);
}

TEST_F(RunOfAViewer, ShowsTheLastFrameToViewersThatConnectDuringAPause) {
  start();
  answer(Service::pace, {{"action", "pause"}});
  poll();
  for (const ViewerTopic topic : {ViewerTopic::world, ViewerTopic::field, ViewerTopic::upper_image, ViewerTopic::wall,
                                  ViewerTopic::pose_particles, ViewerTopic::parameters, ViewerTopic::machines}) {
    EXPECT_TRUE(shown_to_a_late_viewer(topic, [this] { poll(); }).is_object()) << info(topic).name;
    EXPECT_TRUE(shown_to_a_late_viewer(topic, {}).is_object()) << info(topic).name << " again";
  }
  run->controls.take_frames(1);
  run_loop->step();
  poll();
  EXPECT_EQ(shown_to_a_late_viewer(ViewerTopic::world, [this] { poll(); })["clock"]["frame"],
            run->loop.record().world.frame);
}

TEST_F(RunOfAViewer, ShowsTheLastFrameToViewersThatConnectToAPausedReplay) {
  start(true, true, true, 0.0);
  run_loop->step();
  const auto rest = [this] { live->poll_without_frames("the replay is paused; play it first"); };
  rest();
  for (const ViewerTopic topic : {ViewerTopic::world, ViewerTopic::upper_image, ViewerTopic::wall})
    EXPECT_TRUE(shown_to_a_late_viewer(topic, rest).is_object()) << info(topic).name;
}

TEST_F(RunOfAViewer, SaysOnceThatChangesOfAPauseWaitForTheNextFrame) {
  start();
  answer(Service::pace, {{"action", "pause"}});
  send(Service::note, {{"text", "first"}});
  const std::uint32_t first = call;
  poll();
  EXPECT_EQ(viewer->await_operation("status").value("message", ""),
            "the run is paused; changes take effect with the next frame");
  send(Service::note, {{"text", "second"}});
  poll();
  ASSERT_EQ(inputs_of_pause.external.notes.size(), 2u);
  EXPECT_TRUE(answer_in_pause(Service::run_state, json::object()).contains("time")) << "the next message";
  run_loop->step();
  EXPECT_TRUE(viewer->await_response(first).contains("time"));
}

TEST_F(RunOfAViewer, BoundsTheChangesOfAPause) {
  start();
  answer(Service::pace, {{"action", "pause"}});
  for (int i = 0; i < 220; ++i) {
    viewer->call(id_of(Service::note), ++call, R"({"text":"again"})");
    if (i % 10 == 9) {
      sync(*viewer);
      poll();
    }
  }
  poll();
  EXPECT_EQ(inputs_of_pause.external.notes.size(), 200u);
  EXPECT_NE(viewer->await_response(call).value("message", "").find("resume the run first"), std::string::npos);
  EXPECT_EQ(answer_in_pause(Service::pace, {{"action", "resume"}})["paused"], false);
}

}  // namespace
}  // namespace reorient::live
