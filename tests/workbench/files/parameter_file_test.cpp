#include "workbench/files/parameter_file.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class ParameterFile : public ::testing::Test {
 protected:
  std::vector<ParameterChange> read(const std::string& text) const {
    return read_parameters(folder_.write("p.toml", text));
  }
  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
};

TEST_F(ParameterFile, HasTablesAsPrefixesAndLinesAsSources) {
  const auto changes = read("[view]\nparticles = 50\npaper = true\ndistance = \"ssd3\"\n[orientation]\nlead = 0.4\n");
  ASSERT_EQ(changes.size(), 4u);
  for (const ParameterChange& change : changes) EXPECT_EQ(change.origin, ParameterOrigin::file);
  const auto find = [&](const std::string& name) {
    return *std::find_if(changes.begin(), changes.end(), [&](const auto& change) { return change.name == name; });
  };
  EXPECT_EQ(find("view.particles").value, "50");
  EXPECT_EQ(find("view.paper").value, "true");
  EXPECT_EQ(find("view.distance").value, "ssd3");
  EXPECT_EQ(find("orientation.lead").value, "0.4");
  EXPECT_TRUE(find("orientation.lead").source.ends_with("p.toml:6"));
}

TEST_F(ParameterFile, TellsItsMistakesWithFileAndLine) {
  EXPECT_NE(refusal("[view]\nnoise = [1]\n").find("p.toml:2: a parameter is a number"), std::string::npos);
  EXPECT_NE(refusal("[view\n").find("p.toml:1"), std::string::npos);
  EXPECT_NE(refusal(std::string("\0\xff\x01", 3)).find("p.toml"), std::string::npos);
  EXPECT_EQ(refusal(""), "accepted");
  EXPECT_THROW(read_parameters(folder_.path() / "gone.toml"), std::runtime_error);
  EXPECT_THROW(read_parameters(folder_.path()), std::runtime_error);
}

TEST_F(ParameterFile, KeepsWhatDiffersFromTheDefaults) {
  Parameter noise;
  noise.name = "view.noise";
  noise.value = 0.123456789012345;
  noise.maximum = 1.0;
  noise.unit = "rad";
  noise.description = "how much";
  noise.origin = ParameterOrigin::live;
  Parameter distance;
  distance.name = "view.distance";
  distance.kind = ParameterKind::choice;
  distance.value = std::string("ssd3");
  distance.origin = ParameterOrigin::command_line;
  Parameter untouched;
  untouched.name = "view.particles";
  const std::filesystem::path file = folder_.path() / "saved.toml";
  save_parameters({noise, distance, untouched}, {}, file);
  const std::vector<ParameterChange> changes = read_parameters(file);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].name, "view.distance");
  EXPECT_EQ(changes[0].value, "ssd3");
  EXPECT_EQ(changes[1].name, "view.noise");
  EXPECT_EQ(changes[1].value, "0.123456789012345");
  EXPECT_THROW(save_parameters({noise}, {}, folder_.path() / "gone" / "saved.toml"), std::runtime_error);
}

/// Printable or not, ASCII or not, but UTF-8; without a dot, which parts a name.
std::string any_text() {
  const std::vector<std::string> letters{"a",
                                         "Z",
                                         "0",
                                         "_",
                                         "-",
                                         " ",
                                         "\"",
                                         "\\",
                                         "'",
                                         "#",
                                         "=",
                                         "[",
                                         "\n",
                                         "\t",
                                         "\r",
                                         "\x01",
                                         "\x7f",
                                         "\xc3\xa4",
                                         "\xe2\x82\xac",
                                         "\xf0\x9f\xa4\x96"};
  std::string text;
  const int count = *rc::gen::inRange(1, 12);
  for (int i = 0; i < count; ++i) text += *rc::gen::elementOf(letters);
  return text;
}

RC_GTEST_FIXTURE_PROP(ParameterFile, ReadsWhatItWrote, ()) {
  std::map<std::string, std::string> saved;
  std::vector<Parameter> parameters;
  const int count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    Parameter parameter;
    parameter.name = any_text() + "." + any_text() + std::to_string(i);
    parameter.description = any_text();
    parameter.origin = ParameterOrigin::live;
    parameter.kind = *rc::gen::elementOf(
        std::vector{ParameterKind::real, ParameterKind::integer, ParameterKind::boolean, ParameterKind::choice});
    if (parameter.kind == ParameterKind::real)
      parameter.value = *rc::gen::inRange(-1000, 1000) * std::pow(10.0, *rc::gen::inRange(-30, 30));
    if (parameter.kind == ParameterKind::integer) parameter.value = *rc::gen::arbitrary<int>();
    if (parameter.kind == ParameterKind::boolean) parameter.value = *rc::gen::arbitrary<bool>();
    if (parameter.kind == ParameterKind::choice) {
      parameter.value = any_text();
      parameter.choices = {std::get<std::string>(parameter.value), any_text()};
    }
    saved[parameter.name] = to_text(parameter.value);
    parameters.push_back(parameter);
  }
  std::vector<ParameterChange> kept;
  for (int i = 0; i < *rc::gen::inRange(0, 4); ++i) {
    const std::string value =
        *rc::gen::element<std::string>("true", "0.5", "1e-05", "-3", "1.", "inf", "007", "", any_text());
    kept.push_back({"others." + any_text() + std::to_string(i), value, ParameterOrigin::file, "here.toml:1"});
    saved[kept.back().name] = value;
  }
  const std::filesystem::path file = folder_.path() / "any.toml";
  save_parameters(parameters, kept, file);
  const std::vector<ParameterChange> changes = read_parameters(file);
  RC_ASSERT(changes.size() == saved.size());
  for (const ParameterChange& change : changes) {
    const std::string& expected = saved.at(change.name);
    RC_ASSERT(change.value == expected);
  }
}

}  // namespace
}  // namespace reorient
