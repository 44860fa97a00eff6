// SPDX-License-Identifier: MIT
// The main job in real time: the guard as a separate process between LoLA's socket and the shared memory, images
// through the simulated V4L2, and the simulator behind both. Takes as long as on a robot.
//   nao_real_time_job GUARD [SEED] [WIDTH] [SECONDS]
// Exit code 1: the job does not end right, or a joint gets an invalid command. With SECONDS the robot only stands and
// looks around for this time.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/nao/main_job.h"
#include "tests/robots/nao/twin/lola_server.h"
#include "tests/robots/nao/twin/twin_nao.h"
#include "tests/temporary_folder.h"

namespace reorient::main_job {
namespace {

double now() { return 1e-9 * static_cast<double>(nao::monotonic_nanoseconds()); }

/// The guard as a process. When it is terminated, the robot sits down.
class GuardProcess {
 public:
  GuardProcess(std::string program, std::string lola, std::string body) {
    std::array<std::string, 5> words{std::move(program), "--lola", std::move(lola), "--body", std::move(body)};
    std::array<char*, 6> argv{};
    for (std::size_t i = 0; i < words.size(); ++i) argv[i] = words[i].data();
    if (posix_spawn(&process_, argv[0], nullptr, nullptr, argv.data(), environ) != 0)
      throw std::runtime_error(words[0] + " cannot be started");
  }
  ~GuardProcess() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

 private:
  pid_t process_ = -1;
};

/// Serves LoLA and the cameras while the engine's robot waits.
class World {
 public:
  World(int width, const RobotBody& body, std::uint64_t seed, const std::string& lola, std::string shared)
      : nao_(with_images_of_width(width), body, FieldDimensions{}, hall(), beside_the_field(), seed),
        server_(lola.c_str()),
        file_(std::move(shared)),
        next_(nao::monotonic_nanoseconds()) {}

  nao::NaoSurroundings surroundings(std::function<bool()> is_over) {
    nao::NaoSurroundings around;
    around.now = now;
    around.wait = [this](double seconds, std::span<const int> /*descriptors*/) { wait(seconds); };
    around.is_over = std::move(is_over);
    around.body = [this]() -> nao::SharedBody* {
      if (!mapped_ || !*mapped_) mapped_.emplace(file_, nao::MappedBody::Side::engine);
      return *mapped_ ? &**mapped_ : nullptr;
    };
    around.upper = &nao_.camera();
    return around;
  }

  nao::TwinNao& nao() { return nao_; }
  const nao::LolaServer::Counts& counts() const { return server_.counts(); }
  long delays() const { return delays_; }

 private:
  void wait(double seconds) {
    const std::uint64_t before = nao_.camera().shown();
    const long end = nao::monotonic_nanoseconds() + static_cast<long>(1e9 * seconds);
    while (nao_.camera().shown() == before && nao::monotonic_nanoseconds() < end) {
      server_.hear(std::min(next_, end), [this](const nao::Command& command) { nao_.take(command); });
      if (nao::monotonic_nanoseconds() >= next_) cycle();
    }
  }

  void cycle() {
    if (server_.welcome()) nao_.body().meet();
    std::array<std::byte, 2048> packet{};
    const std::size_t size = nao_.feel(packet);
    if (server_.has_client()) {
      server_.begin_cycle();
      server_.send(std::span(packet).first(size), size);
    }
    nao_.show(now());
    next_ += nao::kCycleNanoseconds;
    if (nao::monotonic_nanoseconds() > next_) {  // the engine's frame, or another program on this computer, took longer
      ++delays_;
      next_ = nao::monotonic_nanoseconds();
    }
  }

  nao::TwinNao nao_;
  nao::LolaServer server_;
  std::string file_;
  std::optional<nao::MappedBody> mapped_;
  long next_;
  long delays_ = 0;
};

int run(const char* guard, std::uint64_t seed, int width, double seconds) {
  const TemporaryFolder folder;
  const std::string lola = (folder.path() / "lola").string(), shared = (folder.path() / "body").string();
  const RobotBody body = body_without_legs_to_walk_with();
  World world(width, body, seed, lola, shared);
  const GuardProcess process(guard, lola, shared);
  nao::NaoOptions options;
  options.body = body;
  options.width = width;
  options.stands_at_once = true;
  const double begin = now();
  const auto nao_end = [&] { return seconds > 0.0 && now() - begin > seconds; };
  auto robot = std::make_unique<nao::Nao>(options, world.surroundings(nao_end));
  const nao::Nao& nao = *robot;
  bool succeeded = stand_up(*robot);
  std::string told = succeeded ? "it stands" : "it never stood";
  Flips flips;
  if (seconds <= 0.0) {
    RobotInstance instance{std::move(robot), body, RobotInstance::Clock::real, &world.nao().simulator(),
                           &world.nao().simulator()};
    const std::optional<ScenarioVerdict> verdict = play(instance, seed, flips);
    succeeded = verdict && verdict->succeeded && flips.count > 0;
    told = verdict ? verdict->text : "no verdict";
    std::printf("frames %llu\n", static_cast<unsigned long long>(nao.counts().frames));
  }
  const nao::LolaServer::Counts& counts = world.counts();
  const std::string& complaint = world.nao().body().complaint();
  std::printf("%s\nflips %d\nseconds %.0f\nLoLA: answers %ld, missed %ld, slowest %ld us, late cycles of ours %ld\n",
              told.c_str(), flips.count, now() - begin, counts.answers, counts.missed, counts.slowest / 1000,
              world.delays());
  if (!complaint.empty()) std::printf("a joint got an invalid command: %s\n", complaint.c_str());
  return succeeded && complaint.empty() ? 0 : 1;
}

}  // namespace
}  // namespace reorient::main_job

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "nao_real_time_job GUARD [SEED] [WIDTH] [SECONDS]\n");
    return 2;
  }
  try {
    return reorient::main_job::run(words[1], count > 2 ? std::strtoull(words[2], nullptr, 10) : 1,
                                   count > 3 ? std::atoi(words[3]) : 320, count > 4 ? std::atof(words[4]) : 0.0);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "nao_real_time_job: %s\n", error.what());
    return 2;
  }
}
