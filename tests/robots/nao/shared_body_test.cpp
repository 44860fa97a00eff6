// SPDX-License-Identifier: MIT
#include "robots/nao/guard/shared_body.h"

#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/temporary_folder.h"

namespace reorient::nao {
namespace {

using Side = MappedBody::Side;

class SharedBodyTest : public testing::Test {
 protected:
  std::string refusal(Side side) const {
    try {
      const MappedBody body(file_, side);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
  const TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "body";
};

Measurement at(double time) {
  Measurement measurement;
  measurement.time = time;
  measurement.position.fill(static_cast<float>(time));
  return measurement;
}

TEST_F(SharedBodyTest, TransfersMeasurementsToTheEngineAndRequestsToTheGuard) {
  const MappedBody guard(file_, Side::guard), engine(file_, Side::engine);
  ASSERT_TRUE(guard);
  ASSERT_TRUE(engine);
  Measurement measurement;
  EXPECT_FALSE(engine->newest(measurement));
  for (int i = 1; i <= 100; ++i) guard->add(at(i));
  std::vector<Measurement> news;
  EXPECT_EQ(engine->news(0, news), 100u);
  ASSERT_EQ(news.size(), kMeasurements);
  EXPECT_EQ(news.front().time, 37.0);
  EXPECT_EQ(news.back().time, 100.0);
  news.clear();
  EXPECT_EQ(engine->news(98, news), 100u);
  EXPECT_EQ(news.size(), 2u);

  BodyRequest request;
  EXPECT_FALSE(guard->request.read(request));
  request.head_yaw = 0.5f;
  engine->request.write(request);
  request = {};
  ASSERT_TRUE(guard->request.read(request));
  EXPECT_EQ(request.head_yaw, 0.5f);
}

TEST_F(SharedBodyTest, IsAccessibleOnlyToItsUser) {
  const MappedBody guard(file_, Side::guard);
  struct stat status {};
  ASSERT_EQ(stat(file_.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
}

TEST_F(SharedBodyTest, DoesNotExistForAnEngineWithoutAGuard) { EXPECT_FALSE(MappedBody(file_, Side::engine)); }

TEST_F(SharedBodyTest, HasOneGuard) {
  const MappedBody guard(file_, Side::guard);
  EXPECT_EQ(refusal(Side::guard), file_.string() + ": another guard controls the body; stop it first");
}

TEST_F(SharedBodyTest, HasOneEngineAndAWalk) {
  const MappedBody guard(file_, Side::guard);
  {
    const MappedBody engine(file_, Side::engine);
    EXPECT_EQ(refusal(Side::engine),
              file_.string() +
                  ": another program uses this guard; stop it first, for example: systemctl --user stop reorient");
    EXPECT_EQ(refusal(Side::walk), "");
  }
  EXPECT_EQ(refusal(Side::engine), "") << "the other engine has ended";
}

TEST_F(SharedBodyTest, ServesARunningEngineAfterItsGuardWasKilledAndRestarted) {
  const pid_t first = fork();
  if (first == 0) {
    const MappedBody guard(file_, Side::guard);
    for (int i = 1; i <= 10; ++i) guard->add(at(i));
    _exit(0);  // without the destructor, as after SIGKILL
  }
  ASSERT_EQ(waitpid(first, nullptr, 0), first);
  const MappedBody engine(file_, Side::engine);
  ASSERT_TRUE(engine);
  BodyRequest request;
  engine->request.write(request);
  const MappedBody second(file_, Side::guard);
  EXPECT_FALSE(second->request.read(request)) << "a request to the previous guard";
  second->add(at(50));
  std::vector<Measurement> news;
  EXPECT_EQ(engine->news(10, news), 1u);
  ASSERT_EQ(news.size(), 1u);
  EXPECT_EQ(news[0].time, 50.0);
}

TEST_F(SharedBodyTest, RefusesAFileOfAnotherVersion) {
  std::ofstream(file_) << "something";
  EXPECT_EQ(refusal(Side::engine),
            file_.string() + ": file of another version of the guard; start the guard of this version");
}

TEST_F(SharedBodyTest, RefusesAFileOfAnotherLayout) {
  const MappedBody guard(file_, Side::guard);
  guard->layout.store(SharedBody::kLayout + 1);
  EXPECT_NE(refusal(Side::engine).find("of another version of the guard"), std::string::npos);
}

TEST_F(SharedBodyTest, DoesNotExistForTheEngineWhileItIsCreated) {
  std::ofstream(file_) << "";
  EXPECT_FALSE(MappedBody(file_, Side::engine)) << "the file exists, but is still empty";
  const MappedBody guard(file_, Side::guard);
  EXPECT_TRUE(MappedBody(file_, Side::engine));
  guard->layout.store(0);
  EXPECT_FALSE(MappedBody(file_, Side::engine)) << "the guard has not initialized it yet";
}

TEST_F(SharedBodyTest, IsRemovedWhenItsGuardEnds) {
  { const MappedBody guard(file_, Side::guard); }
  EXPECT_FALSE(std::filesystem::exists(file_));
  {
    const MappedBody guard(file_, Side::guard);
    std::filesystem::remove(file_);
    std::ofstream(file_) << "of another program";
  }
  EXPECT_EQ(std::filesystem::file_size(file_), 18u) << "it removes only its own file";
}

TEST_F(SharedBodyTest, DoesNotOverwriteAFileOfAnotherProgram) {
  const std::string texts[] = {"x", "seven b", "something precious", std::string(sizeof(SharedBody), 'x'),
                               std::string(sizeof(SharedBody) + 1, '\0')};
  for (const std::string& text : texts) {
    std::ofstream(file_, std::ios::binary) << text;
    ASSERT_EQ(chmod(file_.c_str(), 0600), 0);
    EXPECT_EQ(refusal(Side::guard),
              file_.string() + ": expected a guard's file or no file, found another file; choose another file");
    std::ifstream in(file_, std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text);
  }
  std::ofstream(file_, std::ios::binary) << "";
  EXPECT_EQ(refusal(Side::guard), "") << "a guard was killed while it created the file";
  // Of an earlier version with another size.
  const std::uint64_t layout = SharedBody::kLayout - 1;
  std::ofstream(file_, std::ios::binary).write(reinterpret_cast<const char*>(&layout), sizeof(layout));
  EXPECT_EQ(refusal(Side::guard), "");
}

TEST_F(SharedBodyTest, RefusesAFileThatOtherUsersMayWrite) {
  const std::string why =
      file_.string() + ": expected a file that only its user may write, found one that others may write; remove it";
  std::ofstream(file_) << "";
  for (const mode_t mode : {0602u, 0620u, 0666u}) {
    ASSERT_EQ(chmod(file_.c_str(), mode), 0);
    for (const Side side : {Side::guard, Side::engine, Side::walk}) EXPECT_EQ(refusal(side), why);
  }
  ASSERT_EQ(chmod(file_.c_str(), 0644), 0);
  EXPECT_EQ(refusal(Side::guard), "") << "others may only read it";
}

TEST_F(SharedBodyTest, SurvivesItsTruncation) {
  MappedBody guard(file_, Side::guard);
  const MappedBody engine(file_, Side::engine);
  double time = 0.0;
  for (const std::size_t size : {std::size_t{0}, std::size_t{100}, sizeof(SharedBody) - 1}) {
    std::filesystem::resize_file(file_, size);
    BodyRequest request;
    request.head_yaw = 0.25f;
    engine->request.write(request);
    guard->add(at(++time));
    EXPECT_EQ(guard.restore(), size != 100) << size << ": the access to a missing page restored it";
    EXPECT_FALSE(guard.restore());
    request = {};
    ASSERT_TRUE(guard->request.read(request));
    EXPECT_EQ(request.head_yaw, 0.25f);
    std::vector<Measurement> news;
    engine->news(0, news);
    ASSERT_FALSE(news.empty());
    EXPECT_EQ(news.back().time, time);
    EXPECT_EQ(std::filesystem::file_size(file_), sizeof(SharedBody));
  }
}

TEST_F(SharedBodyTest, DoesNotHideOtherBusErrors) {
  const MappedBody guard(file_, Side::guard);
  EXPECT_EXIT(raise(SIGBUS), testing::KilledBySignal(SIGBUS), "");
}

TEST_F(SharedBodyTest, RefusesASymbolicLink) {
  std::ofstream(folder_.path() / "precious") << "keep me";
  std::filesystem::create_symlink(folder_.path() / "precious", file_);
  EXPECT_NE(refusal(Side::guard), "");
  EXPECT_EQ(std::filesystem::file_size(folder_.path() / "precious"), 7u);
}

TEST(SharedValue, IsNeverReadPartly) {
  struct Wide {
    std::array<std::uint64_t, 100> numbers{};
  };
  SharedValue<Wide> value;
  std::atomic<bool> ends = false;
  std::thread writer([&] {
    Wide wide;
    for (std::uint64_t i = 1; !ends; ++i) {
      wide.numbers.fill(i);
      value.write(wide);
    }
  });
  Wide seen;
  for (int reads = 0; reads < 2000;) {
    if (!value.read(seen)) continue;
    ++reads;
    for (const std::uint64_t number : seen.numbers) ASSERT_EQ(number, seen.numbers[0]);
  }
  ends = true;
  writer.join();
}

TEST(SharedValue, WithAnUnfinishedWriteDoesNotBlockReaders) {
  SharedValue<int> value;
  value.write(1);
  // The state that a writer leaves if it is stopped during a write.
  reinterpret_cast<std::atomic<std::uint64_t>&>(value).fetch_add(1);
  int seen = 0;
  EXPECT_FALSE(value.read(seen));
  value.write(2);
  EXPECT_TRUE(value.read(seen));
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace reorient::nao
