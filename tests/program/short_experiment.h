// SPDX-License-Identifier: MIT
// An experiment that takes seconds, for the command's tests.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/paths.h"
#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {

/// Seconds instead of minutes, in small images. The scripts same_on_parallel and same_on_slurm run it, too.
inline const std::string kShort = read_text(std::string(kSourceFolder) + "/tests/program/short_experiment.toml");

/// The lines without progress lines, which slow machines print after ten seconds.
inline int complaints(const ProgramRun& run) {
  int count = 0;
  std::istringstream lines(run.err);
  for (std::string line; std::getline(lines, line);)
    count += line.starts_with("reorient: ") || line.find(" trials, ") == std::string::npos ? 1 : 0;
  return count;
}

class ShortExperiment : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder.path() / name).string(); }
  std::vector<std::string> words(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"--log", "off", "experiment", file.string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  ProgramRun run(const std::vector<std::string>& more) const { return run_reorient(words(more)); }
  /// Its table as JSON.
  std::string table(const std::string& out, std::vector<std::string> more = {}) const {
    const std::string json = path(out + ".json");
    more.insert(more.end(), {"--out", path(out), "--json", json});
    const ProgramRun done = run(more);
    EXPECT_EQ(done.code, kSuccess) << done.err;
    return read_text(json);
  }
  void expect_refused(const std::vector<std::string>& more, const std::string& culprit) const {
    const ProgramRun refused = run(more);
    EXPECT_EQ(refused.code, kBadInput);
    EXPECT_EQ(refused.out, "");
    EXPECT_NE(refused.err.find(culprit), std::string::npos) << refused.err;
    EXPECT_EQ(complaints(refused), 1) << refused.err;
  }

  /// The result file of a task.
  std::filesystem::path result(const std::string& out, int task) const {
    return folder.path() / out / "tasks" / ("00000" + std::to_string(task) + ".json");
  }

  TemporaryFolder folder;
  std::filesystem::path file = folder.write("short.toml", kShort);
};

}  // namespace reorient
