// SPDX-License-Identifier: MIT
// The pages of --help; the list of commands comes from the program itself.
#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include "program/robots.h"
#include "program/subcommand.h"
#include "tests/program/program_run.h"

namespace reorient {
namespace {

using CommandPath = std::vector<std::string>;

std::string joined(const CommandPath& words) {
  std::string text;
  for (const std::string& word : words) text += " " + word;
  return text;
}

std::vector<std::string> page_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The lines below `title`, up to the next empty line.
std::vector<std::string> section_of(const std::string& page, const std::string& title) {
  const std::vector<std::string> lines = page_lines(page);
  const auto begin = std::find(lines.begin(), lines.end(), title + ":");
  if (begin == lines.end()) return {};
  return {begin + 1, std::find(begin, lines.end(), "")};
}

std::string help_of(CommandPath words) {
  words.emplace_back("--help");
  const ProgramRun run = run_reorient(words);
  EXPECT_EQ(run.code, kSuccess) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

/// The path of each command and subcommand, by the list in the help of its parent.
void add_commands_below(const CommandPath& path, std::vector<CommandPath>& all) {
  all.push_back(path);
  for (const std::string& line : section_of(help_of(path), "Commands")) {
    CommandPath command = path;
    command.push_back(line.substr(2, line.find(' ', 2) - 2));
    add_commands_below(command, all);
  }
}

std::vector<CommandPath> all_commands() {
  std::vector<CommandPath> all;
  add_commands_below({}, all);
  return all;
}

/// The words that call each page: those of `run` for each robot, too.
std::vector<CommandPath> all_pages() {
  std::vector<CommandPath> all = all_commands();
  for (const std::string& robot : robot_names()) all.push_back({"run", "--robot", robot});
  return all;
}

TEST(Help, ListsAllCommands) {
  const std::vector<CommandPath> all = all_commands();
  for (const CommandPath& words : {CommandPath{"run"}, {"experiment", "tables"}, {"model", "merge"}, {"room", "rate"}})
    EXPECT_NE(std::find(all.begin(), all.end(), words), all.end()) << joined(words);
  EXPECT_EQ(section_of(help_of({}), "Commands").size(), 19U);
}

TEST(Help, IsPrintedByACommandToo) {
  for (const CommandPath& words : all_commands()) {
    CommandPath asked{"help"};
    asked.insert(asked.end(), words.begin(), words.end());
    EXPECT_EQ(run_reorient(asked).out, help_of(words)) << joined(asked);
  }
  const ProgramRun mistyped = run_reorient({"help", "room", "rat"});
  EXPECT_EQ(mistyped.code, kBadInput);
  EXPECT_EQ(mistyped.err, "reorient: unknown command 'room rat' (did you mean 'rate'?)\n");
}

TEST(Help, FitsAPageOf100ColumnsAnd60Lines) {
  for (const CommandPath& words : all_pages()) {
    SCOPED_TRACE("reorient" + joined(words));
    const std::vector<std::string> lines = page_lines(help_of(words));
    EXPECT_LE(lines.size(), 60U);
    for (const std::string& line : lines) {
      EXPECT_LE(line.size(), 100U) << line;
      EXPECT_FALSE(line.ends_with(' ')) << line;
    }
  }
}

TEST(Help, ShowsTheWholeCommandInItsUsage) {
  for (const CommandPath& words : all_commands())
    EXPECT_TRUE(help_of(words).starts_with("Usage: reorient" + joined(words) + " ")) << joined(words);
  EXPECT_TRUE(help_of({"room", "rate"}).starts_with("Usage: reorient room rate [OPTIONS] ROOM\n"));
}

TEST(Help, HasTwoToFiveExamplesOfItsOwnCommand) {
  for (const CommandPath& words : all_commands()) {
    const std::string page = help_of(words);
    SCOPED_TRACE(page);
    const std::vector<std::string> lines = section_of(page, "Examples");
    const auto begins = [&](const std::string& start) {
      return std::count_if(lines.begin(), lines.end(),
                           [&](const std::string& line) { return line.starts_with(start); });
    };
    EXPECT_GE(begins("  reorient "), 2);
    EXPECT_LE(begins("  reorient "), 5);
    EXPECT_GE(begins("  reorient" + joined(words)), 1);
  }
}

TEST(Help, ContainsNoTermsOfTheParser) {
  const std::regex artifact(R"(\{|\bin \[|\b(TEXT|INT|FLOAT|UINT)\b|Needs:|Excludes:|REQUIRED|Positionals|=\[)");
  for (const CommandPath& words : all_pages()) {
    const std::string page = help_of(words);
    std::smatch found;
    EXPECT_FALSE(std::regex_search(page, found, artifact)) << found.str() << " in" << joined(words) << "\n" << page;
  }
}

TEST(Help, DescribesEachOptionAndArgument) {
  const std::regex bare(R"(^  (-\S+(, -\S+)*( [A-Z]\S*)?|[A-Z]\S*) *$)");
  for (const CommandPath& words : all_pages()) {
    const std::vector<std::string> lines = page_lines(help_of(words));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!std::regex_match(lines[i], bare)) continue;
      EXPECT_TRUE(i + 1 < lines.size() && lines[i + 1].starts_with("        ")) << lines[i];  // on the next line
    }
  }
}

TEST(Help, OfRunShowsEachOptionWithTheRobotsThatUseIt) {
  CLI::App program;
  const CLI::App* const run = add_run(program).parser;
  std::string pages;
  for (const std::string& robot : robot_names()) pages += help_of({"run", "--robot", robot});
  for (const CLI::Option* option : run->get_options()) {
    if (option->get_positional()) continue;
    for (const std::string& name : option->get_lnames())
      EXPECT_TRUE(std::regex_search(pages, std::regex("--" + name + "\\b(?!-)"))) << name;
  }
  EXPECT_EQ(help_of({"run"}), help_of({"run", "--robot", "simulator"}));
  EXPECT_NE(help_of({"run"}).find("reorient run --robot footage --help"), std::string::npos);
  const auto shows = [](const std::string& robot, const std::string& option) {
    return help_of({"run", "--robot", robot}).find("\n  " + option + " ") != std::string::npos;
  };
  EXPECT_TRUE(shows("simulator", "--room"));
  EXPECT_FALSE(shows("footage", "--room"));
  EXPECT_TRUE(shows("footage", "--column"));
  EXPECT_FALSE(shows("simulator", "--column"));
  EXPECT_TRUE(shows("companion", "--socket"));
  EXPECT_FALSE(shows("nao", "--socket"));
  EXPECT_TRUE(shows("nao", "--team"));
}

}  // namespace
}  // namespace reorient
