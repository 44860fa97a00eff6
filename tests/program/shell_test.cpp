// SPDX-License-Identifier: MIT
// What a shell asks of the program: lists of names, completion, and the manual page.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "program/shell/catalog.h"
#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

std::vector<std::string> words_of(const std::string& text, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

/// The candidates for the last of these words, without their descriptions; "files" and "folders" follow a tab.
std::vector<std::string> completed(std::vector<std::string> words) {
  words.insert(words.begin(), "complete");
  const ProgramRun run = run_reorient(words);
  EXPECT_EQ(run.code, kSuccess) << run.err;
  EXPECT_EQ(run.err, "");
  std::vector<std::string> candidates = words_of(run.out, '\n');
  for (std::string& candidate : candidates)
    if (!candidate.starts_with('\t')) candidate.resize(candidate.find('\t'));
  return candidates;
}

using Words = std::vector<std::string>;

TEST(List, HasTheNamesOfEachKindThatACommandAccepts) {
  const std::map<std::string, std::set<std::string>> expected{{"scenarios", {"kidnapped", "mirrored_placement"}},
                                                              {"behaviors", {"orientation", "paper/paper_orientation"}},
                                                              {"robots", {"companion", "footage", "nao", "simulator"}},
                                                              {"bodies", {"booster-k1", "booster-t1", "nao-v6"}},
                                                              {"fields", {"large", "spl"}},
                                                              {"parameters", {"light/hard", "paper"}},
                                                              {"rooms", {"hall"}},
                                                              {"experiments", {"orientation", "table1"}},
                                                              {"conditions", {"default", "paper"}}};
  for (const CatalogKind& kind : catalog()) {
    const ProgramRun run = run_reorient({"list", kind.name, "--names"});
    ASSERT_EQ(run.code, kSuccess) << run.err;
    const std::vector<std::string> names = words_of(run.out, '\n');
    ASSERT_TRUE(expected.contains(kind.name)) << kind.name;
    for (const std::string& name : expected.at(kind.name))
      EXPECT_NE(std::find(names.begin(), names.end(), name), names.end()) << kind.name << " " << name;
  }
  EXPECT_EQ(catalog().size(), expected.size());
}

TEST(List, DescribesEachNameInASentence) {
  const ProgramRun run = run_reorient({"list"});
  EXPECT_EQ(run.code, kSuccess);
  EXPECT_NE(run.out.find("fields: reorient run --field NAME\n"), std::string::npos) << run.out;
  for (const CatalogKind& kind : catalog()) {
    for (const CatalogEntry& entry : kind.entries(kProjectFolder / "scripts"))
      EXPECT_TRUE(entry.text.ends_with('.') || entry.text.ends_with('?') || entry.text.find('"') == std::string::npos)
          << kind.name << " " << entry.name << ": " << entry.text;
  }
  for (const std::string& line : words_of(run.out, '\n')) EXPECT_LE(line.size(), 100U) << line;
}

TEST(List, ShowsTheScriptsOfAnotherFolder) {
  const TemporaryFolder folder;
  folder.write("behaviors/lamp.lua", "\xEF\xBB\xBF--- Switches\n--- a lamp\x1B[31m. More.\n");
  folder.write("behaviors/bare.lua", "behavior \"bare\" {}\n");
  const ProgramRun run = run_reorient({"list", "behaviors", "--scripts", folder.path().string()});
  EXPECT_EQ(run.code, kSuccess) << run.err;
  EXPECT_EQ(run.out,
            "behaviors: reorient run --with NAME\n"
            "  bare\n"
            "  lamp  Switches a lamp\\x1B[31m.\n");
}

TEST(List, RefusesAnUnknownKind) {
  const ProgramRun run = run_reorient({"list", "scenario"});
  EXPECT_EQ(run.code, kBadInput);
  EXPECT_EQ(run.err, "reorient: unknown kind 'scenario' (did you mean 'scenarios'?)\n");
}

TEST(FirstSentence, IsFoundInLuaAndToml) {
  EXPECT_EQ(first_sentence("-- SPDX-License-Identifier: MIT\n--- One. Two.\n"), "One.");
  EXPECT_EQ(first_sentence("# One\r\n# and a half.\r\nkey = 1\r\n"), "One and a half.");
  EXPECT_EQ(first_sentence("title = \"Why?\"\ntrials = 1\n"), "Why?");
  EXPECT_EQ(first_sentence("key = 1 # no\n"), "");
  EXPECT_EQ(first_sentence("title = \""), "");
  EXPECT_EQ(first_sentence(""), "");
}

TEST(CompletionOfWords, KnowsCommandsOptionsAndValues) {
  EXPECT_EQ(completed({"ver"}), (Words{"version"}));
  EXPECT_EQ(completed({"room", ""}), (Words{"rate"}));
  EXPECT_EQ(completed({"help", "rec"}), (Words{"recording", "record-test"}));
  EXPECT_EQ(completed({"run", "--bo"}), (Words{"--body"}));
  EXPECT_EQ(completed({"--lo"}), (Words{"--log"}));
  EXPECT_EQ(completed({"run", "--lo"}), (Words{"--log"})) << "global options are allowed behind the command";
  EXPECT_EQ(completed({"--log", "war"}), (Words{"warning"}));
  EXPECT_EQ(completed({"run", "--width", "1"}), (Words{"160"}));
  EXPECT_EQ(completed({"run", "--width=5"}), (Words{"--width=544"}));
  EXPECT_EQ(completed({"run", "--body", "booster-k"}), (Words{"booster-k1", "\tfiles", "\tfolders"}));
  EXPECT_EQ(completed({"run", "kidn"}), (Words{"kidnapped", "\tfiles", "\tfolders"}));
  EXPECT_EQ(completed({"run", "--seed", "7", "kidn"}), (Words{"kidnapped", "\tfiles", "\tfolders"}));
  EXPECT_EQ(completed({"run", "--realtime", "kidn"}), (Words{"kidnapped", "\tfiles", "\tfolders"}));
  EXPECT_EQ(completed({"run", "--with", "kidn"}), (Words{"kidnap_recovery"}));
  EXPECT_EQ(completed({"run", "--set", "wall.rad"}), (Words{"wall.radius="}));
  EXPECT_EQ(completed({"run", "--set=wall.rad"}), (Words{"--set=wall.radius="}));
  EXPECT_EQ(completed({"list", "sc"}), (Words{"scenarios"}));
  EXPECT_EQ(completed({"test", "--scripts", ""}), (Words{"\tfolders"}));
  EXPECT_EQ(completed({"experiment", "table"}), (Words{"tables", "table1", "\tfiles", "\tfolders"}));
  EXPECT_EQ(completed({"com"}), (Words{})) << "the command for shells is hidden";
}

TEST(CompletionOfWords, IsEmptyForUnknownWordsAndNeverFails) {
  const TemporaryFolder folder;
  folder.write("behaviors/broken.lua", "behavior \"");
  for (const Words& words :
       {Words{"xyz"}, Words{"--nothing"}, Words{"run", "--nothing=", "x", "--"}, Words{"run", "-", "-x=", "=x"},
        Words{"run", "--scripts", "/nowhere", "--with", "o"}, Words{"--help"}, Words{"run", "--help"},
        Words{"run", "--scripts", folder.path().string(), "--set", "wall"}, Words{"\xFF\x01", "\n"}, Words{}})
    completed(words);
  EXPECT_EQ(completed({"run", "--scripts", "/nowhere", "--with", "o"}), (Words{}));
}

TEST(CompletionOfBash, CompletesTheTypedLine) {
  const TemporaryFolder folder;
  const auto typed = [&](const std::string& line) {
    const std::string out = (folder.path() / "out.txt").string();
    const std::string script = ". '" + (kProjectFolder / "assets/completion/reorient.bash").string() +
                               "'; COMP_LINE=\"$0\" COMP_POINT=${#0}; _reorient 2>/dev/null; printf '%s\\n' "
                               "\"${COMPREPLY[@]}\" > '" +
                               out + "'";
    setenv("REORIENT_HOME", kSourceFolder, 1);
    std::ofstream(folder.path() / "run.sh") << script;
    const std::string command =
        "bash -c \"$(cat '" + (folder.path() / "run.sh").string() + "')\" '" + std::string(kProgram) + " " + line + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return words_of(read_text(out), '\n');
  };
  EXPECT_EQ(typed("ver"), (Words{"version"}));
  EXPECT_EQ(typed("room "), (Words{"rate"}));
  EXPECT_EQ(typed("run --body=booster-k"), (Words{"booster-k1"})) << "bash replaces only what follows '='";
  EXPECT_EQ(typed("run --set wall.rad"), (Words{"wall.radius="}));
}

TEST(GeneratedFiles, TheManualPageMatchesTheHelp) {
  const std::filesystem::path file = kProjectFolder / "docs" / "reorient.1";
  const std::string page = run_reorient({"help", "--man"}).out;
  if (std::getenv("REORIENT_REGENERATE") != nullptr) std::ofstream(file, std::ios::binary) << page;
  EXPECT_EQ(read_text(file), page) << "docs/reorient.1 is stale: set REORIENT_REGENERATE=1 and run this test";
}

TEST(ManualPage, HasEachCommandAndNoAccidentalRequest) {
  const std::string page = run_reorient({"help", "--man"}).out;
  for (const char* heading : {".SH NAME\n", ".SH SYNOPSIS\n", ".SS \"reorient run\"\n", ".SS \"reorient room rate\"\n",
                              ".SS \"reorient run \\-\\-robot nao\"\n"})
    EXPECT_NE(page.find(heading), std::string::npos) << heading;
  const std::set<std::string> macros{".TH", ".SH", ".SS", ".B", ".br", ".PP", ".TP", ".nf", ".fi", ".\\\""};
  for (const std::string& line : words_of(page, '\n')) {
    for (const char letter : line) EXPECT_TRUE(letter >= ' ' && letter <= '~') << line;
    EXPECT_TRUE(!line.starts_with('.') || macros.contains(line.substr(0, line.find(' ')))) << line;
    EXPECT_FALSE(line.starts_with('\'')) << line;
  }
}

}  // namespace
}  // namespace reorient
