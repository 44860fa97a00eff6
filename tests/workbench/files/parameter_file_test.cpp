// SPDX-License-Identifier: MIT
#include "workbench/files/parameter_file.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/parameters/utf8.h"
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
  const auto changes =
      read("[view]\nparticles = 50\npaper = true\ndistance = \"ssd3\"\n[orientation]\nlingering = 0.4\n");
  ASSERT_EQ(changes.size(), 4u);
  for (const ParameterChange& change : changes) EXPECT_EQ(change.origin, ParameterOrigin::file);
  const auto find = [&](const std::string& name) {
    return *std::find_if(changes.begin(), changes.end(), [&](const auto& change) { return change.name == name; });
  };
  EXPECT_EQ(find("view.particles").value, "50");
  EXPECT_EQ(find("view.paper").value, "true");
  EXPECT_EQ(find("view.distance").value, "ssd3");
  EXPECT_EQ(find("orientation.lingering").value, "0.4");
  EXPECT_TRUE(find("orientation.lingering").source.ends_with("p.toml:6"));
}

TEST_F(ParameterFile, ReportsMistakesWithFileAndLine) {
  EXPECT_NE(
      refusal("[view]\nnoise = [1]\n").find("p.toml:2: expected a number, true, false or a name in quotes, found [1]"),
      std::string::npos);
  EXPECT_NE(refusal("[view\n").find("p.toml:1"), std::string::npos);
  EXPECT_NE(refusal(std::string("\0\xff\x01", 3)).find("p.toml"), std::string::npos);
  EXPECT_EQ(refusal(""), "accepted");
  EXPECT_THROW(read_parameters(folder_.path() / "gone.toml"), std::runtime_error);
  EXPECT_THROW(read_parameters(folder_.path()), std::runtime_error);
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST_F(ParameterFile, WithAKeyOfAHundredThousandPartsDoesNotExhaustTheStack) {
  EXPECT_TRUE(
      refusal("x = 1\na" + repeated(".a", 100'000) + " = 1\n")
          .ends_with("p.toml:2: expected a line of at most 1000 letters, found a longer one; break it into several"));
  EXPECT_NE(refusal("[a" + repeated(".a", 100'000) + "]\n").find("p.toml:1: expected a line of at most 1000 letters"),
            std::string::npos);
  // Line by line, as deep as the parser goes.
  const std::string level = "{a" + repeated(".a", 490) + " = [\n";
  EXPECT_NE(refusal("a = [\n" + repeated(level, 120)).find("p.toml:"), std::string::npos);
}

TEST_F(ParameterFile, WithTablesNestedTooDeeplyIsRefused) {
  EXPECT_EQ(refusal("a" + repeated(".a", 15) + " = 1\n"), "accepted");
  EXPECT_NE(refusal("\na" + repeated(".a", 400) + " = 1\n")
                .find("p.toml:2: expected names such as orientation.lingering, found tables"),
            std::string::npos);
}

TEST_F(ParameterFile, OfAHundredThousandKeysIsRefused) {
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += "k" + std::to_string(i) + "=1\n";
  EXPECT_NE(refusal(keys).find("expected at most 10000 parameters"), std::string::npos);
}

TEST_F(ParameterFile, ThatIsTooLargeIsRefused) {
  EXPECT_NE(refusal(repeated("# a comment, of which there is no end\n", 30'000))
                .find("p.toml: expected a parameter file of at most 1 MiB, found a larger one (1114 KiB)"),
            std::string::npos);
}

TEST_F(ParameterFile, MayHaveDifferentKeysOfTheSameLengthBeyondAscii) {
  const std::vector<ParameterChange> changes = parse_parameters(
      "\"\u00e4\" = 1\n\"\u00f6\" = 2\n\"%C3%B6\" = 3\n\"%25C3%25B6\" = 4\n\"\u20ac\u20ac\" = 5\n\"\u00e4%%\" = 6\n",
      "p.toml");
  std::map<std::string, std::string> values;
  for (const ParameterChange& change : changes) values[change.name] = change.value;
  const std::map<std::string, std::string> expected{{"\u00e4", "1"},     {"\u00f6", "2"},       {"%C3%B6", "3"},
                                                    {"%25C3%25B6", "4"}, {"\u20ac\u20ac", "5"}, {"\u00e4%%", "6"}};
  EXPECT_EQ(values, expected);
  const std::string twice = refusal("\"\u00e4\" = 1\n\"\u00f6\" = 2\n\"a%25\u00e4\" = 3\n\"a%25\u00e4\" = 4\n");
  EXPECT_NE(twice.find("p.toml:4: "), std::string::npos) << twice;
  EXPECT_NE(twice.find("cannot redefine existing integer"), std::string::npos) << twice;
  EXPECT_NE(twice.find("%25\u00e4\""), std::string::npos) << "the name as it is in the file: " << twice;
}

TEST_F(ParameterFile, MayHaveOtherLettersThanAsciiOnlyInQuotesAndComments) {
  for (const char* text :
       {"a = 1 # \xc2\xa1", "\xef\xbb\xbf\x61 = 1", "\"\xc2\xa1\" = '\xc2\xa1'", "a = \"\\\"\xc2\xa1\"",
        "a = \"\"\"\n\xc2\xa1\"\"\"\"\" # \xc2\xa1", "a = '''\xc2\xa1'\n''\xc2\xa1'''", "a = '''\\\xc2\xa1'''",
        "a = \"\"\"\\\n \\\"\xc2\xa1\"\"\""}) {
    EXPECT_EQ(refusal(text), "accepted") << text;
  }
  for (const char* text :
       {"\na = 1 \xc2\xa1", "\n\xc2\xa1 = 1", "\ntuned\xef\xb3\xbf{ lead = 1", "a = '''\n''' \xc2\xa0",
        "a = \"\"\"\n\\\xc2\xa1\"\"\"", "a = \"\"\"\\ \n\xc2\xa1\"\"\"", "\"\"\"\n\\ \xef\xbb\x98"})
    EXPECT_NE(refusal(text).find("p.toml:2: expected ASCII letters, found another one"), std::string::npos) << text;
}

TEST_F(ParameterFile, ThatIsNotTomlIsRefusedWithAnyLetters) {
  EXPECT_EQ(refusal("\nother = -n\"\"\"\"[[((\xef\xbb\xb9o"), refusal("\nother = -n\"\"\"\"[[((?o"));
  EXPECT_NE(refusal("\nother = -n\"\"\"\"[[((\xef\xbb\xb9o").find("p.toml:2: "), std::string::npos);
}

TEST_F(ParameterFile, ReportsMistakesOnOneLineForAnyBytes) {
  for (const std::string& text : {std::string("\"\\u001b[2J\\n\" = []\n"), std::string("a\x1b = 1"),
                                  std::string("a = \x07"), std::string("\xff\xfe"), std::string("a = 'x\0'", 8)}) {
    const std::string message = refusal(text);
    EXPECT_NE(message, "accepted");
    for (const char letter : message) EXPECT_GE(static_cast<unsigned char>(letter), ' ') << message;
    EXPECT_TRUE(is_utf8(message));
  }
}

TEST_F(ParameterFile, StoresValuesThatDifferFromTheDefaults) {
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

TEST_F(ParameterFile, KeepsACopyOfTheFileThatItReplaces) {
  Parameter noise;
  noise.name = "view.noise";
  noise.maximum = 1.0;
  noise.value = 0.25;
  noise.origin = ParameterOrigin::live;
  const std::filesystem::path file = folder_.path() / "tuned.toml", backup = folder_.path() / "tuned.toml.bak";
  EXPECT_EQ(save_parameters({noise}, {}, file), "");
  EXPECT_EQ(save_parameters({noise}, {}, file), "") << "the same text";
  EXPECT_FALSE(std::filesystem::exists(backup));
  noise.value = 0.5;
  EXPECT_EQ(save_parameters({noise}, {}, file), backup);
  EXPECT_EQ(read_parameters(backup).front().value, "0.25");
  EXPECT_EQ(read_parameters(file).front().value, "0.5");
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
    if (parameter.value != parameter.default_value) saved[parameter.name] = to_text(parameter.value);
    parameters.push_back(parameter);
  }
  std::vector<ParameterChange> kept;
  for (int i = 0; i < *rc::gen::inRange(0, 4); ++i) {
    const std::string value =
        *rc::gen::element<std::string>("true", "0.5", "1e-05", "-3", "1.", "inf", "007", "-0", "", any_text());
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
