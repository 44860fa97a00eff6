// SPDX-License-Identifier: MIT
// A frame never waits for the disk that contains the scripts.
#include "program/run/script_edits.h"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "tests/waiting.h"

namespace reorient {
namespace {

/// The edits of the next frame.
std::vector<ScriptEdit> next_edits(ScriptEdits& edits) {
  FrameInputs inputs;
  edits.add_to(inputs);
  return inputs.script_edits;
}

TEST(ScriptEdits, DoNotDelayAFrameWhileTheFileSystemHangs) {
  // Both outlive the thread, which ends after the test.
  const auto answers = std::make_shared<std::promise<void>>();
  const auto is_looking = std::make_shared<std::atomic<bool>>(false);
  {
    const std::shared_future<void> answer = answers->get_future().share();
    ScriptEdits edits(ScriptTexts(), [answer, is_looking] {
      *is_looking = true;
      answer.wait();
      return std::vector<ScriptEdit>();
    });
    ASSERT_TRUE(await([&] { return is_looking->load(); }));
    // A single wait for the file system would not end.
    for (int frame = 0; frame < 1000; ++frame) EXPECT_TRUE(next_edits(edits).empty());
    EXPECT_TRUE(edits.texts().files().empty());
  }  // does not wait either
  answers->set_value();
}

TEST(ScriptEdits, OfASlowFileSystemComeInTheirOrder) {
  int count = 0;
  ScriptEdits edits(ScriptTexts(), [&count]() -> std::vector<ScriptEdit> {
    let_time_pass(0.02);
    if (count >= 3) return {};
    ++count;
    return {{"lib/a.lua", ScriptText{std::to_string(count), ""}}};
  });
  std::string seen;
  ASSERT_TRUE(await([&] {
    for (const ScriptEdit& edit : next_edits(edits)) seen += edit.text->text;
    return seen.size() >= 3;
  }));
  EXPECT_EQ(seen, "123");
  ASSERT_NE(edits.texts().find("lib/a.lua"), nullptr);
  EXPECT_EQ(edits.texts().find("lib/a.lua")->text, "3");
}

TEST(ScriptEdits, AreThoseOfTheFoldersWithScripts) {
  const TemporaryFolder folder;
  folder.write("behaviors/a.lua", "1");
  ScriptEdits edits(folder.path());
  EXPECT_EQ(edits.texts().find("behaviors/a.lua")->text, "1");
  folder.write("behaviors/a.lua", "22");
  std::vector<ScriptEdit> found;
  ASSERT_TRUE(await([&] {
    found = next_edits(edits);
    return !found.empty();
  }));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].file, "behaviors/a.lua");
  EXPECT_EQ(found[0].text->text, "22");
}

TEST(ScriptEdits, ThatTextsAlreadyContainsDoNotComeAgain) {
  std::atomic<int> looks = 0;
  ScriptEdits edits(ScriptTexts(), [&looks]() -> std::vector<ScriptEdit> {
    if (looks++ > 0) return {};
    return {{"lib/a.lua", ScriptText{"new", ""}}};
  });
  ASSERT_TRUE(await([&] { return edits.texts().find("lib/a.lua") != nullptr; }));
  EXPECT_TRUE(next_edits(edits).empty()) << "an engine that starts with these texts has them";
  edits.add_missed(ScriptTexts());
  const std::vector<ScriptEdit> missed = next_edits(edits);
  ASSERT_EQ(missed.size(), 1u) << "an older engine misses them";
  EXPECT_EQ(missed[0].text->text, "new");
  EXPECT_TRUE(next_edits(edits).empty());
}

}  // namespace
}  // namespace reorient
