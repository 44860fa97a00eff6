// SPDX-License-Identifier: MIT
// `reorient experiment field_images`, called as by a user.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program/program.h"
#include "tests/program/footage/decoder.h"
#include "tests/program/program_run.h"
#include "tests/shared_data.h"
#include "tests/temporary_folder.h"
#include "workbench/field_images/field_labels.h"

namespace reorient {
namespace {

/// Labels of a raw image that the test writes.
std::string labels_for(const std::string& bytes) {
  return "[[images]]\nname = \"plain\"\ndigest = \"" + digest_of(bytes) +
         "\"\nraw = [64, 48, 4]\nwidth = 64\nfield_of_view = 60\npitch = 20\nlines = [[0, 30, 63, 30]]\n";
}

TEST(FieldImages, AreFoundByTheirBytesAndScored) {
  const TemporaryFolder folder;
  const std::string bytes(4 + 64 * 48 * 2, 'k');
  folder.write("images/any name.raw", bytes);
  folder.write("images/notes.txt", "nothing");
  const auto labels = folder.write("l.toml", labels_for(bytes)), json = folder.path() / "s.json";
  const ProgramRun run =
      run_reorient({"experiment", "field_images", (folder.path() / "images").string(), "--labels", labels.string(),
                    "--out", (folder.path() / "out").string(), "--json", json.string()});
  ASSERT_EQ(run.code, kSuccess) << run.err;
  EXPECT_NE(run.out.find("1 labeled image in "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("no labels: " + (folder.path() / "images/notes.txt").string() + ": digest "),
            std::string::npos)
      << run.out;
  const auto scores = nlohmann::json::parse(std::ifstream(json));
  ASSERT_GT(scores.size(), 20u);
  EXPECT_EQ(scores[0]["image"], "plain");
  EXPECT_EQ(scores[0]["line_points"], 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / ("field_images_" + digest_of(bytes) + ".png")));
}

TEST(FieldImages, ThatCannotBeUsedAreReported) {
  const TemporaryFolder folder;
  const std::string bytes(4 + 64 * 48 * 2 - 1, 'k');  // a byte is missing
  const auto image = folder.write("short.raw", bytes), other = folder.write("other.raw", "x");
  const auto labels = folder.write("l.toml", labels_for(bytes)), broken = folder.write("b.toml", "images = 3");
  const auto complaint = [&](const std::string& source, const std::string& file) {
    const ProgramRun run = run_reorient(
        {"experiment", "field_images", source, "--labels", file, "--out", (folder.path() / "out").string()});
    EXPECT_EQ(run.code, kBadInput) << run.out;
    return run.err;
  };
  EXPECT_NE(complaint(image.string(), labels.string())
                .find("expected 6144 bytes of an image behind 4 of a header, "
                      "found 6147"),
            std::string::npos);
  EXPECT_NE(complaint(other.string(), labels.string()).find("expected images with labels in"), std::string::npos);
  EXPECT_NE(complaint("missing.png", labels.string()).find("expected a readable image file, found none"),
            std::string::npos);
  EXPECT_NE(complaint(image.string(), broken.string()).find("b.toml:1: images: expected one or more tables"),
            std::string::npos);
  EXPECT_NE(
      complaint(image.string(), (folder.path() / "none.toml").string()).find("expected a file (labels), found none"),
      std::string::npos);
}

}  // namespace
}  // namespace reorient
