// What is left of a run that somebody or something ends.
#include <csignal>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <toml++/toml.h>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

constexpr const char* kPictures[] = {"world_view.png", "camera_view.png", "confidences.png", "reorientations.png"};

class InterruptedRun : public ::testing::Test {
 protected:
  /// A long run that writes all that there is to be written.
  std::vector<std::string> words(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"run",           "patrol",
                                 "--width",       "160",
                                 "--set",         "orientation.lead=0.4",
                                 "--save-params", (folder.path() / "tuned.toml").string(),
                                 "--json",        (folder.path() / "run.json").string(),
                                 "--out",         (folder.path() / "pictures").string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  nlohmann::json json() const { return nlohmann::json::parse(read_text(folder.path() / "run.json")); }

  void expect_all_outputs() const {
    EXPECT_EQ(json()["scenario"], "patrol");
    EXPECT_EQ(toml::parse_file((folder.path() / "tuned.toml").string())["orientation"]["lead"].value<double>(), 0.4);
    for (const char* picture : kPictures)
      EXPECT_TRUE(read_text(folder.path() / "pictures" / picture).ends_with(std::string("IEND\xAE\x42\x60\x82")))
          << picture;
  }
  /// What was begun beside a file and never given its name.
  int left_overs() const {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
      count += entry.path().string().ends_with(".partial");
    return count;
  }

  TemporaryFolder folder;
};

class InterruptedBy : public InterruptedRun, public ::testing::WithParamInterface<int> {};

TEST_P(InterruptedBy, TellsAndWritesWhatThereIs) {
  for (const bool realtime : {false, true}) {
    SCOPED_TRACE(realtime);
    ChildProgram run(folder.path(),
                     words(realtime ? std::vector<std::string>{"--realtime"} : std::vector<std::string>{}));
    ASSERT_TRUE(run.await("patrol: "));
    ASSERT_TRUE(run.await("> waiting (start)\n")) << "the timeline is there while the run goes on";
    run.kill(GetParam());
    EXPECT_EQ(run.wait(), 128 + GetParam());
    EXPECT_NE(run.out().find("wrong: interrupted\n"), std::string::npos) << run.out();
    EXPECT_NE(run.out().find("digest: "), std::string::npos);
    EXPECT_EQ(json()["verdict"], "interrupted");
    EXPECT_FALSE(json()["succeeded"].get<bool>());
    EXPECT_GT(json()["frames"].get<int>(), 0);
    expect_all_outputs();
    EXPECT_EQ(left_overs(), 0);
    std::filesystem::remove_all(folder.path() / "pictures");
  }
}

TEST_P(InterruptedBy, TellsTheTestsThatRan) {
  folder.write("a_test.lua", R"(test("a", function() advance(1) end)
test("b", function()
  load_behavior "head_scan"
  load_behavior "penalty_marks"
  while true do advance(0) end
end)
test("c", function() end))");
  ChildProgram tests(folder.path(), {"test", (folder.path() / "a_test.lua").string(), "--junit",
                                     (folder.path() / "junit.xml").string()});
  ASSERT_TRUE(tests.await("a_test.lua: a\n"));
  tests.kill(GetParam());
  EXPECT_EQ(tests.wait(), 128 + GetParam());
  EXPECT_NE(tests.out().find("1 passed, 1 failed, interrupted before the rest\n"), std::string::npos) << tests.out();
  const std::string report = read_text(folder.path() / "junit.xml");
  EXPECT_NE(report.find("name=\"b\""), std::string::npos) << report;
  EXPECT_TRUE(report.ends_with("</testsuite>\n"));
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedBy, ::testing::Values(SIGINT, SIGTERM, SIGHUP), [](const auto& signal) {
  return std::string(signal.param == SIGINT ? "Int" : signal.param == SIGTERM ? "Term" : "Hup");
});

TEST_F(InterruptedRun, EndsAtOnceWhereItIsAskedTwice) {
  ChildProgram run(folder.path(), words());
  ASSERT_TRUE(run.await("patrol: "));
  run.kill(SIGSTOP);  // so that both have come before it can do anything
  run.kill(SIGINT);
  run.kill(SIGTERM);
  run.kill(SIGCONT);
  const int code = run.wait();
  EXPECT_TRUE(code == -SIGINT || code == -SIGTERM) << code;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run.json"));
}

TEST_F(InterruptedRun, GoesOnWhereTheSignalIsIgnored) {
  ChildProgram run(folder.path(), words({"--seconds", "12"}), [] { std::signal(SIGHUP, SIG_IGN); });  // as nohup does
  ASSERT_TRUE(run.await("patrol: "));
  run.kill(SIGHUP);
  EXPECT_EQ(run.wait(), kWrong);
  EXPECT_EQ(json()["verdict"], "the scenario did not end in time");
}

TEST_F(InterruptedRun, LeavesNothingHalfWrittenWhereItIsKilled) {
  for (int i = 0; i < 36; ++i) {
    ChildProgram run(folder.path(), words({"--seconds", "1"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(20 * i));
    run.kill(SIGKILL);
    run.wait();
    if (std::filesystem::exists(folder.path() / "run.json")) {
      EXPECT_EQ(json()["scenario"], "patrol");
    }
    if (std::filesystem::exists(folder.path() / "tuned.toml")) {
      EXPECT_NO_THROW(toml::parse_file((folder.path() / "tuned.toml").string()));
    }
    for (const char* picture : kPictures) {
      const std::filesystem::path file = folder.path() / "pictures" / picture;
      if (std::filesystem::exists(file)) {
        EXPECT_TRUE(read_text(file).ends_with(std::string("IEND\xAE\x42\x60\x82"))) << picture;
      }
    }
  }
  EXPECT_LT(left_overs(), 36);
}

// ---- what cannot be written does not take the rest with it

TEST_F(InterruptedRun, WritesTheRestWhereOnePictureCannotBe) {
  std::filesystem::create_directories(folder.path() / "pictures" / "world_view.png" / "in the way");
  ChildProgram run(folder.path(), words({"--seconds", "1"}));
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("reorient: cannot write '" + (folder.path() / "pictures" / "world_view.png").string()),
            std::string::npos)
      << run.err();
  EXPECT_EQ(json()["scenario"], "patrol");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "pictures" / "confidences.png"));
  EXPECT_NE(run.out().find("wrong: "), std::string::npos);
}

TEST_F(InterruptedRun, TellsEachOutputThatVanishedWithItsFolder) {
  ChildProgram run(folder.path(), words({"--seconds", "12"}));
  ASSERT_TRUE(run.await("patrol: "));
  std::filesystem::remove_all(folder.path() / "pictures");
  EXPECT_EQ(run.wait(), kBadInput);
  for (const char* picture : kPictures) EXPECT_NE(run.err().find(picture), std::string::npos) << run.err();
  EXPECT_EQ(json()["scenario"], "patrol");
}

TEST_F(InterruptedRun, WritesTheRestWhereNobodyReadsWhatItPrints) {
  ChildProgram run(folder.path(), words({"--seconds", "1"}), [] {
    int ends[2];
    if (pipe(ends) != 0) _exit(126);
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
  });
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("cannot write to the standard output"), std::string::npos) << run.err();
  expect_all_outputs();
}

TEST_F(InterruptedRun, WritesWhatIsSmallWhereFilesMayNotGrow) {
  ChildProgram run(folder.path(), words({"--seconds", "1"}), [] {
    const rlimit small{16 * 1024, 16 * 1024};
    setrlimit(RLIMIT_FSIZE, &small);
  });
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("world_view.png': File too large"), std::string::npos) << run.err();
  EXPECT_EQ(json()["scenario"], "patrol");
  EXPECT_EQ(left_overs(), 0);
}

TEST_F(InterruptedRun, SaysWhatADeviceSays) {
  ChildProgram run(folder.path(), {"run", "--seconds", "1", "--width", "160", "--no-pictures", "--json", "/dev/full"});
  EXPECT_EQ(run.wait(), kBadInput);
  EXPECT_NE(run.err().find("cannot write '/dev/full': No space left on device"), std::string::npos) << run.err();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST_F(InterruptedRun, DoesNotFollowWhatSomebodyPutBeside) {
  folder.write("precious.txt", "mine");
  std::filesystem::create_symlink(folder.path() / "precious.txt", folder.path() / "run.json.partial");
  ChildProgram run(folder.path(), words({"--seconds", "1"}));
  EXPECT_EQ(run.wait(), kWrong);
  EXPECT_EQ(read_text(folder.path() / "precious.txt"), "mine");
  expect_all_outputs();
}

TEST_F(InterruptedRun, SharesAFolderWithAnother) {
  TemporaryFolder other;
  ChildProgram first(folder.path(), words({"--seconds", "2"}));
  ChildProgram second(other.path(), words({"--seconds", "2"}));
  EXPECT_EQ(first.wait(), kWrong);
  EXPECT_EQ(second.wait(), kWrong);
  expect_all_outputs();
  EXPECT_EQ(left_overs(), 0);
}

}  // namespace
}  // namespace reorient
