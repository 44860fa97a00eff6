// SPDX-License-Identifier: MIT
// Messages for viewers: each fits its schema, and contains the values of the frame's record.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>
#include <turbojpeg.h>

#include "engine/script/language/world_fields.h"
#include "tests/engine/eventful_run.h"
#include "tests/paths.h"
#include "tests/workbench/views/unsupported_schema.h"
#include "workbench/files/input_file.h"
#include "workbench/views/viewer/base64.h"
#include "workbench/views/viewer/foxglove.h"
#include "workbench/views/viewer/viewer_messages.h"

namespace reorient {
namespace {

using foxglove::Json;

/// Checks the part of JSON Schema that our schemas use. Returns the first position at which `value` does not fit;
/// empty: it fits.
std::string misfit(const Json& value, const Json& schema, const std::string& where = "") {
  if (schema.contains("oneOf")) {
    for (const Json& choice : schema["oneOf"]) {
      if (choice.at("const") == value) return "";
    }
    return where + " is not one of the constants";
  }
  const std::string type = schema.at("type");
  const bool fits = type == "object"    ? value.is_object()
                    : type == "array"   ? value.is_array()
                    : type == "string"  ? value.is_string()
                    : type == "boolean" ? value.is_boolean()
                    : type == "integer" ? value.is_number_integer()
                                        : value.is_number();
  if (!fits) return where + " is no " + type + ": " + value.dump();
  if (schema.contains("minimum") && value < schema["minimum"]) return where + " is too small";
  if (schema.contains("maximum") && value > schema["maximum"]) return where + " is too large";
  if (schema.contains("minItems") && value.size() < schema["minItems"]) return where + " has too few items";
  if (schema.contains("maxItems") && value.size() > schema["maxItems"]) return where + " has too many items";
  std::string inner;
  if (type == "array") {
    for (std::size_t i = 0; i < value.size() && inner.empty(); ++i)
      inner = misfit(value[i], schema["items"], fmt::format("{}[{}]", where, i));
    return inner;
  }
  if (type != "object") return "";
  if (schema.contains("required")) {
    for (const std::string name : schema["required"])
      if (!value.contains(name)) return fmt::format("{} lacks {}", where, name);
  }
  for (const auto& [name, item] : value.items()) {
    if (!schema.at("properties").contains(name))
      return fmt::format("{} has {}, which the schema does not contain", where, name);
    inner = misfit(item, schema["properties"][name], fmt::format("{}.{}", where, name));
    if (!inner.empty()) break;
  }
  return inner;
}

/// The messages of a run with many events, each checked against its schema.
class ViewerMessagesTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const ViewerTopicInfo& row : kViewerTopics) schemas_[row.topic] = Json::parse(schema_text(row.schema));
    ViewerMessages viewer;
    FrameLoop engine(eventful_setup());
    SceneTruth scene;
    scene.truth = GroundTruth{Pose2(1.0, 2.0, 0.5), false, false};
    int frames = 0;
    for (const Bytes& bytes : eventful_run(300)) {
      const StoredInputs stored(bytes);
      const FrameInputs& inputs = stored.inputs();
      const FrameRecord& frame = engine.step(inputs, kViewedTopics);
      ViewedFrame viewed{frame, frame, scene, {}, frames++ == 0};
      if (inputs.observation.upper) viewed.images[0] = inputs.observation.upper->image;
      last_world_ = frame.world;
      viewer.add(viewed, [&](ViewerTopic topic, std::string_view text) {
        Json message = Json::parse(text);
        const std::string wrong = misfit(message, schemas_.at(topic), std::string(info(topic).name));
        if (!wrong.empty() && mistakes_.size() < 10) mistakes_.push_back(wrong);
        ++counts_[topic];
        last_[topic] = std::move(message);
      });
    }
  }

  std::map<ViewerTopic, Json> schemas_, last_;
  std::map<ViewerTopic, int> counts_;
  std::vector<std::string> mistakes_;
  World last_world_;
};

TEST_F(ViewerMessagesTest, FitTheirSchemasAndContainTheValuesOfTheRecord) {
  EXPECT_EQ(mistakes_, std::vector<std::string>());
  for (const ViewerTopic topic :
       {ViewerTopic::transforms, ViewerTopic::pose, ViewerTopic::truth, ViewerTopic::percepts, ViewerTopic::world,
        ViewerTopic::machines, ViewerTopic::request, ViewerTopic::costs, ViewerTopic::conditions,
        ViewerTopic::pose_particles, ViewerTopic::upper_image, ViewerTopic::parameters})
    EXPECT_GE(counts_[topic], 299) << info(topic).name;
  EXPECT_EQ(counts_[ViewerTopic::field], 1);
  EXPECT_EQ(counts_[ViewerTopic::upper_calibration], 1);
  EXPECT_GT(counts_[ViewerTopic::wall], 0);
  EXPECT_EQ(counts_[ViewerTopic::room], counts_[ViewerTopic::wall]);
  EXPECT_GT(counts_[ViewerTopic::events], 0);
  EXPECT_GT(counts_[ViewerTopic::log], 0);
  EXPECT_NEAR(last_[ViewerTopic::pose]["pose"]["position"]["x"], last_world_.pose.pose.position.x(), 1e-4);
  EXPECT_EQ(last_[ViewerTopic::world]["clock"]["frame"], last_world_.frame);
  EXPECT_EQ(last_[ViewerTopic::world]["confidence"]["current"], last_world_.confidence.current);
  EXPECT_EQ(last_[ViewerTopic::truth]["pose"]["position"]["y"], 2.0);
}

/// The message of one topic of a frame with all topics.
Json message_of(const FrameRecord& frame, ViewerTopic wanted) {
  Json message;
  ViewerMessages().add({frame, frame, {}, {}, true}, [&](ViewerTopic topic, std::string_view text) {
    if (topic == wanted) message = Json::parse(text);
  });
  EXPECT_EQ(misfit(message, Json::parse(schema_text(info(wanted).schema))), "");
  return message;
}

TEST(ViewerMessages, ContainTheEvidenceOfEachTileAndTheFitOfTheTilesInView) {
  FrameRecord frame;
  frame.filled = Topics::all();
  frame.room.basis.wall.rows = 1;
  frame.room.basis.wall.columns = 4;
  frame.room.model.resize(4);
  frame.room.evidence = {0.0, -1.25, 0.5, std::numeric_limits<double>::quiet_NaN()};
  frame.room.perceived.resize(3);
  for (int i = 0; i < 3; ++i) frame.room.perceived[static_cast<std::size_t>(i)].tile = i;
  frame.room.perceived[1].counts = frame.room.perceived[2].counts = true;
  frame.room.compared = {{1, 0.2, 0.6, true, true}, {2, 0.0, 0.3, false, true}};
  frame.room.cells = {{0.5, 0.4}, {1.0, 0.1}, {1.5, 0.001}};
  const Json tiles = message_of(frame, ViewerTopic::room);
  EXPECT_EQ(tiles["view"], Json::array({{{"azimuth", 0.5}, {"share", 1.0}}, {{"azimuth", 1.0}, {"share", 0.25}}}));
  EXPECT_EQ(tiles["evidence"], Json({0.0, -1.25, 0.5, 0.0}));
  EXPECT_EQ(tiles["columns"], 4);
  EXPECT_EQ(tiles["in_view"],
            Json::array({{{"tile", 1}, {"believed", 0.2}, {"mirrored", 0.6}}, {{"tile", 2}, {"mirrored", 0.3}}}));
  frame.room.evidence = {0.0, -1.25, 0.5, 0.25};
  EXPECT_EQ(message_of(frame, ViewerTopic::room)["sum"], -0.5);
}

TEST(ViewerMessages, ContainTheMachinesOfTheBehaviorsAndOfTheScenario) {
  FrameRecord frame;
  frame.world.time = 5.0;
  frame.names = std::make_shared<NameTable>(NameTable{{"", "orientation", "watching"}});
  frame.machines = {{1, 2, 3.0, false, 0}};
  frame.claims = {{kLegs, {1, 2, 0}, 5.0, kNoName}};
  SceneTruth scene;
  scene.scenario.names = std::make_shared<NameTable>(NameTable{{"", "mirrored_placement", "carrying"}});
  scene.scenario.machines = {{1, 2, 4.5, true, 2}, {1, 999, 0.0, false, 0}};
  Json found;
  ViewerMessages().add({frame, frame, scene, {}, true}, [&](ViewerTopic topic, std::string_view text) {
    if (topic == ViewerTopic::machines) found = Json::parse(text);
  });
  EXPECT_EQ(misfit(found, Json::parse(schema_text("reorient.Machines"))), "");
  EXPECT_EQ(found["machines"], Json::parse(R"([
    {"name":"orientation","state":"watching","seconds":2.0,"stopped":false,"errors":0,"scenario":false,"parts":[{"part":"legs","outranked_by":""}]},
    {"name":"mirrored_placement","state":"carrying","seconds":0.5,"stopped":true,"errors":2,"scenario":true,"parts":[]},
    {"name":"mirrored_placement","state":"","seconds":5.0,"stopped":false,"errors":0,"scenario":true,"parts":[]}])"));
}

TEST(ViewerMessages, ContainTheThresholdsOfTheEvidenceIfTheRunHasTheirParameters) {
  FrameRecord frame;
  const auto parameter = [](std::string name, double value) {
    Parameter one;
    one.name = std::move(name);
    one.value = value;
    return one;
  };
  frame.parameters = {parameter("decision.disturbances", 5.0), parameter("decision.looks", 240.0),
                      parameter("decision.false_flips", 0.02), parameter("decision.least", 2.0)};
  const auto count = [&] {
    int messages = 0;
    ViewerMessages().add({frame, frame, {}, {}, true},
                         [&](ViewerTopic topic, std::string_view) { messages += topic == ViewerTopic::decision; });
    return messages;
  };
  EXPECT_EQ(count(), 0) << "without the topic of the parameters";
  frame.filled = Topics::all();
  const Json thresholds = message_of(frame, ViewerTopic::decision);
  EXPECT_NEAR(thresholds["confirmed"], std::log(12000.0), 1e-9);
  EXPECT_NEAR(thresholds["unconfirmed"], std::log(250.0), 1e-9);
  frame.parameters.pop_back();
  EXPECT_EQ(count(), 0) << "without one of its parameters";
}

TEST(ViewerMessages, DrawRejectedFeaturesTranslucent) {
  FrameRecord frame;
  frame.filled = Topics::all();
  frame.percepts[1].goal_posts.resize(3);
  frame.feature_fits[1].goal_posts = {0.2F, 1.0F, FeatureFits::kIgnored};
  const auto opacities = [&] {
    std::vector<double> all;
    const Json message = message_of(frame, ViewerTopic::percepts);
    for (const Json& post : message["entities"][0]["cylinders"]) all.push_back(post["color"]["a"]);
    return all;
  };
  EXPECT_EQ(opacities(), (std::vector{1.0, 0.4, 0.2}));
  frame.filled = Topics::always();
  EXPECT_EQ(opacities(), (std::vector{1.0, 1.0, 1.0}));
}

TEST(ViewerMessages, OmitNumbersThatAreNotFiniteAndCorrectInvalidText) {
  FrameRecord frame;
  frame.world.time_since_disturbance = std::numeric_limits<double>::infinity();
  frame.world.pose.pose.position.x() = std::numeric_limits<double>::quiet_NaN();
  frame.logs.push_back({0, 0, "caf\xe9", 0, true});
  std::map<ViewerTopic, Json> messages;
  ViewerMessages().add({frame, frame, {}, {}, true}, [&](ViewerTopic topic, std::string_view text) {
    messages[topic] = Json::parse(text);
    EXPECT_EQ(misfit(messages[topic], Json::parse(schema_text(info(topic).schema))), "") << text;
  });
  EXPECT_FALSE(messages[ViewerTopic::world]["robot"].contains("time_since_disturbance"));
  EXPECT_FALSE(messages[ViewerTopic::world]["pose"].contains("x"));
  EXPECT_EQ(messages[ViewerTopic::log]["message"], "note: caf\xef\xbf\xbd");
  EXPECT_EQ(messages[ViewerTopic::log]["name"], "note");
}

TEST(ViewerMessages, ContainOnlyTheDwellTimesThatAConditionHas) {
  FrameRecord frame;
  frame.filled = frame.filled | Topics{Topic::conditions};
  frame.names = std::make_shared<NameTable>(NameTable{{"", "m", "a", "b", "why"}});
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  frame.conditions = {{1, 2, 3, 4, 7, WhenValue::yes, 0.1000004, 0.5, 1.2, 0.0},
                      {1, 0, 3, 4, 8, WhenValue::none, 0.0, 0.0, 1.2, kUnknown},
                      {1, 999, 3, 4, 9, WhenValue::failed, 0.0, 0.0, 0.0, 0.0}};
  Json found;
  ViewerMessages().add({frame, frame, {}, {}, true}, [&](ViewerTopic topic, std::string_view text) {
    if (topic == ViewerTopic::conditions) found = Json::parse(text);
  });
  EXPECT_EQ(misfit(found, Json::parse(schema_text("reorient.Conditions"))), "");
  EXPECT_EQ(found["conditions"], Json::parse(R"([
    {"machine":"m","from":"a","target":"b","reason":"why","line":7,"when":"yes","held":0.1,"lasting":0.5},
    {"machine":"m","from":"","target":"b","reason":"why","line":8,"when":"none","waited":1.2},
    {"machine":"m","from":"","target":"b","reason":"why","line":9,"when":"failed"}])"));
}

TEST(ViewerTopics, HaveEachNameOnceAndASchema) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kViewerTopics.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kViewerTopics[i].topic), i);
    EXPECT_TRUE(names.insert(kViewerTopics[i].name).second) << kViewerTopics[i].name;
    EXPECT_EQ(Json::parse(schema_text(kViewerTopics[i].schema)).at("type"), "object");
  }
}

TEST(ViewerTopics, HaveSchemasThatFoxgloveSupports) {
  for (const ViewerTopicInfo& row : kViewerTopics)
    EXPECT_EQ(unsupported(Json::parse(schema_text(row.schema)), std::string(row.name)), "");
}

TEST(ViewerTopics, DescribeTheValuesOfTheApplication) {
  ApplicationInterface declared;
  DeclaredField number, pose;
  number.unit = "m";
  number.initial.numbers = {0.0};
  pose.type = FieldType::pose;
  pose.initial.numbers = {0.0, 0.0, 0.0};
  declared.values = {{"ball.distance", "how far", {number}}, {"goal", "where", {pose}}};
  declared.actions = {{"kick", "kicks", {}}};
  const Json tables = Json::parse(schema_text("reorient.World", declared)).at("properties");
  const Json input = tables.at("input").at("properties");
  EXPECT_EQ(input.at("ball").at("properties").at("distance"),
            (Json{{"type", "number"}, {"description", "how far (m)"}}));
  EXPECT_EQ(input.at("goal").at("properties").at("rotation").at("type"), "number");
  EXPECT_EQ(input.at("valid").at("properties").at("goal").at("type"), "boolean");
  EXPECT_EQ(tables.at("action").at("properties").at("kick").at("properties").at("state").at("type"), "string");
  EXPECT_EQ(unsupported(Json::parse(schema_text("reorient.World", declared)), "/world"), "");
  declared.values[0].description = "\xff";
  EXPECT_NO_THROW(Json::parse(schema_text("reorient.World", declared)));
}

TEST(Base64, FollowsTheStandard) {
  const std::pair<std::string, std::string> kVectors[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"},
                                                          {"\xff\xfe\xfd", "//79"}};
  for (const auto& [bytes, text] : kVectors) EXPECT_EQ(base64(std::as_bytes(std::span(bytes))), text);
}

TEST(Jpeg, ShowsTheColorsOfTheImage) {
  constexpr int kWidth = 50, kHeight = 30;  // not multiples of JPEG's blocks
  Image image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      std::uint8_t* const pixel = image.row(y) + 2 * x;
      pixel[0] = static_cast<std::uint8_t>(60 + 3 * x);
      pixel[1] = x % 2 == 0 ? 90 : 160;  // Cb, then Cr
    }
  }
  JpegEncoder encoder(90);
  const std::span<const std::byte> jpeg = encoder.encode(image.view());
  const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), tjDestroy);
  std::vector<std::uint8_t> rgb(3 * kWidth * kHeight);
  ASSERT_EQ(tjDecompress2(decoder.get(), reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size(), rgb.data(),
                          kWidth, 0, kHeight, TJPF_RGB, 0),
            0);
  for (int x = 0; x < kWidth; x += 7) {
    const double luma = 60 + 3 * x;
    const std::uint8_t* const pixel = &rgb[3 * (15 * kWidth + static_cast<std::size_t>(x))];
    EXPECT_NEAR(pixel[0], std::min(255.0, luma + 1.402 * (160 - 128)), 6.0) << x;
    EXPECT_NEAR(pixel[2], std::max(0.0, luma + 1.772 * (90 - 128)), 6.0) << x;
  }
  EXPECT_TRUE(encoder.encode({}).empty());
}

TEST(Foxglove, WritesTimeInSecondsAndNanoseconds) {
  EXPECT_EQ(foxglove::time(1.25), Json({{"sec", 1}, {"nsec", 250000000}}));
  EXPECT_EQ(foxglove::time(0.9999999999), Json({{"sec", 1}, {"nsec", 0}}));
  EXPECT_EQ(foxglove::time(-3.0), Json({{"sec", 0}, {"nsec", 0}}));
  EXPECT_EQ(foxglove::time(std::nan("")), Json({{"sec", 0}, {"nsec", 0}}));
}

TEST(Foxglove, NamesTheModelOfACameraAsRosDoes) {
  const auto calibration = [](CameraProjection projection, const std::vector<double>& coefficients) {
    CameraModel camera;
    camera.projection = projection;
    EXPECT_EQ(camera.set_coefficients(coefficients), "");
    return foxglove::camera_calibration(1.0, "camera", camera);
  };
  const std::vector<double> five{0.1, 0.2, 0.3, 0.4, 0.5}, eight{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
  const std::vector<double> four{0.1, 0.2, 0.3, 0.4};
  Json message = calibration(CameraProjection::pinhole, {0.1, 0.2});
  EXPECT_EQ(message["distortion_model"], "plumb_bob");
  EXPECT_EQ(message["D"], Json({0.1, 0.2, 0.0, 0.0, 0.0}));
  message = calibration(CameraProjection::pinhole, five);
  EXPECT_EQ(message["distortion_model"], "plumb_bob");
  EXPECT_EQ(message["D"], Json(five));
  message = calibration(CameraProjection::pinhole, eight);
  EXPECT_EQ(message["distortion_model"], "rational_polynomial");
  EXPECT_EQ(message["D"], Json(eight));
  message = calibration(CameraProjection::fisheye, four);
  EXPECT_EQ(message["distortion_model"], "equidistant");
  EXPECT_EQ(message["D"], Json(four));
  EXPECT_EQ(calibration(CameraProjection::equirectangular, {})["D"], Json::array());
}

// A layout shows nothing for a topic that is not sent.

/// Checks that a path such as "/world.confidence.current" names a known topic and a field of its schema.
void expect_path(const std::string& path, char separator) {
  for (const ViewerTopicInfo& row : kViewerTopics) {
    if (!path.starts_with(row.name)) continue;
    const std::string rest = path.substr(row.name.size());
    if (!rest.empty() && rest[0] != separator) continue;
    Json schema = Json::parse(schema_text(row.schema));
    std::istringstream parts(std::regex_replace(rest, std::regex(R"(\[:\]\{[^}]*\})"), ""));
    for (std::string part; std::getline(parts, part, separator);) {
      if (part.empty()) continue;
      if (schema["type"] == "array") schema = Json(schema["items"]);
      ASSERT_TRUE(schema["properties"].contains(part)) << path << ": " << part;
      schema = Json(schema["properties"][part]);
    }
    return;
  }
  ADD_FAILURE() << path << ": unknown topic";
}

TEST(ViewerTopics, AreListedOnThePageAboutRecordings) {
  const std::string page = read_input(std::filesystem::path(kSourceFolder) / "docs" / "recordings.md", "a file");
  for (const ViewerTopicInfo& row : kViewerTopics) {
    const std::string line = "| `" + std::string(row.name) + "` | `" + std::string(row.schema) + "` | " +
                             std::string(row.description) + " |\n";
    EXPECT_NE(page.find(line), std::string::npos) << line;
  }
}

TEST(ViewerLayouts, NameExistingTopicsAndFields) {
  const std::filesystem::path folder = std::filesystem::path(kSourceFolder) / "assets" / "views";
  const Json layout = Json::parse(read_input(folder / "lichtblick.json", "a file"));
  int paths = 0;
  const std::function<void(const Json&)> visit = [&](const Json& json) {
    for (const auto& [key, value] : json.items()) {
      if (json.is_object() && key.starts_with("/")) {
        expect_path(key, '.');
        ++paths;
      }
      if (value.is_string() && value.get<std::string>().starts_with("/")) {
        expect_path(value, '.');
        ++paths;
      }
      if (value.is_structured()) visit(value);
    }
  };
  visit(layout.at("configById"));
  const std::function<void(const Json&)> visit_panels = [&](const Json& place) {
    if (place.is_string()) {
      EXPECT_TRUE(layout["configById"].contains(place.get<std::string>())) << place;
      return;
    }
    visit_panels(place.at("first"));
    visit_panels(place.at("second"));
  };
  visit_panels(layout.at("layout"));
  const std::string xml = read_input(folder / "plotjuggler.xml", "a file");
  const std::regex curve("curve name=\"([^\"]+)\"");
  for (std::sregex_iterator it(xml.begin(), xml.end(), curve), end; it != end; ++it, ++paths)
    expect_path((*it)[1], '/');
  EXPECT_GT(paths, 15);
}

}  // namespace
}  // namespace reorient
