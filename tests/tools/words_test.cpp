// SPDX-License-Identifier: MIT
// tools/words on small trees.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/tool_tree.h"

namespace reorient {
namespace {

constexpr const char* kWords = "[words]\n\"goes back\" = \"returns\"\n\"*flavor*\" = \"taste\"\nwonky = \"unstable\"\n";

class Words : public testing::Test {
 protected:
  Words() { tree.copy("tools/words"); }

  void write(const std::string& file, const std::string& text) { tree.folder.write(file, text); }

  void write_rules(const std::string& exceptions = "") { write("tools/words.toml", kWords + exceptions); }

  std::string check(const std::string& files = "") {
    const ToolTree::Result result = tree.run("tools/words " + files);
    return result.text + "exit " + std::to_string(result.code);
  }

  std::string git(const std::string& line) { return tree.run("git -c user.name=a -c user.email=a@b " + line).text; }

  ToolTree tree;
};

TEST_F(Words, ChecksTheWholeTree) {
  write_rules();
  write("README.md", "The robot is fine.\nThe robot is Wonky.\n");
  write("docs/a.md", "It goes\nback.\n");
  EXPECT_EQ(check(), "README.md:2: 'Wonky' (write: unstable)\ndocs/a.md:1: 'goes back' (write: returns)\nexit 1");
}

TEST_F(Words, ChecksOnlyTheFilesThatAreGiven) {
  write_rules();
  write("README.md", "wonky\n");
  write("other.md", "wonky\n");
  EXPECT_EQ(check("other.md"), "other.md:1: 'wonky' (write: unstable)\nexit 1");
}

TEST_F(Words, MatchesPartsOfWordsOnlyWithAStar) {
  write_rules();
  write("a.md", "wonkyness, unwonky, flavors, unflavored\n");
  EXPECT_EQ(check(), "a.md:1: 'flavors' (write: taste)\na.md:1: 'unflavored' (write: taste)\nexit 1");
}

TEST_F(Words, SkipCodeLinksOutputAndGeneratedPartsOfMarkdown) {
  write_rules();
  write("a.md",
        "`wonky` and [link](wonky.md)\n\n```console\nwonky\n```\n<!-- rows wonky.json: a -->\nwonky\n"
        "<!-- end of rows -->\n```lua\n-- wonky\n```\n");
  EXPECT_EQ(check(), "a.md:10: 'wonky' (write: unstable)\nexit 1");
}

TEST_F(Words, ReadCommentsStringsAndNamesOfSources) {
  write_rules();
  write("a.cpp",
        "// It goes\n// back.\nconst char* text = \"it goes \"\n    \"back\";\nvoid GoesBack();\nint wonky_count;\n");
  EXPECT_EQ(check(),
            "a.cpp:1: 'goes back' (write: returns)\na.cpp:3: 'goes back' (write: returns)\n"
            "a.cpp:5: 'Goes Back' (write: returns)\na.cpp:6: 'wonky' (write: unstable)\nexit 1");
}

TEST_F(Words, AcceptAnExceptionAndReportOneThatIsNotNeeded) {
  const std::string exception = "[[exception]]\nfiles = \"docs/*\"\nword = \"wonky\"\nreason = \"a name\"\n";
  write_rules(exception);
  write("docs/a.md", "wonky\n");
  EXPECT_EQ(check(), "exit 0");
  write("docs/a.md", "fine\n");
  EXPECT_EQ(check(), "tools/words.toml: the exception of 'wonky' in docs/* is not needed\nexit 1");
}

TEST_F(Words, RejectMistakesInTheirRules) {
  write_rules("[[exception]]\nfiles = \"a.md\"\nword = \"wonky\"\n");
  EXPECT_EQ(check(),
            "tools/words: tools/words.toml: exception 1 has no 'reason' (expected files, word and reason)\nexit 2");
  write_rules("[[exception]]\nfiles = \"a.md\"\nword = \"fine\"\nreason = \"a name\"\n");
  EXPECT_EQ(check(), "tools/words: tools/words.toml: exception 1: [words] has no 'fine'\nexit 2");
}

TEST_F(Words, LimitTheLinesOfMarkdownTo100ColumnsOutsideOfTablesLinksAndCode) {
  write_rules();
  const std::string words = std::string(96, 'a') + " ";
  write("a.md", words + "bbb\n" + words + "bbbb\n| " + words + "bbbb |\n```\n" + words + "bbbb\n```\n" + words +
                    "[b b](c.md)\n" + words + "`b b b b`\n" + words + "[b](" + words + ")\n" + words + "`b b b b` c\n");
  EXPECT_EQ(check(), "a.md:2: 101 columns (expected at most 100)\na.md:10: 108 columns (expected at most 100)\nexit 1");
}

TEST_F(Words, SkipTitlesOfCommitsWhereTheFirstCheckedOneIsMissing) {
  write_rules();
  git("init -q");
  git("commit -q --allow-empty -m '" + std::string(80, 'a') + "'");
  EXPECT_EQ(check(), "exit 0");
}

TEST_F(Words, LimitTitlesOfCommitsTo72Characters) {
  write_rules();
  git("init -q");
  git("commit -q --allow-empty -m '" + std::string(73, 'a') + "'");
  git("commit -q --allow-empty -m first");
  git("commit -q --allow-empty -m '" + std::string(72, 'b') + "'");
  git("commit -q --allow-empty -m '" + std::string(73, 'c') + "'");
  tree.run("sed -i \"s/^FIRST_CHECKED_COMMIT = .*/FIRST_CHECKED_COMMIT = '$(git rev-parse HEAD~2)'/\" tools/words");
  const std::string found = check();
  EXPECT_NE(found.find(": the title has 73 characters (expected at most 72)\nexit 1"), std::string::npos) << found;
  EXPECT_EQ(std::count(found.begin(), found.end(), '\n'), 1) << found;
}

}  // namespace
}  // namespace reorient
