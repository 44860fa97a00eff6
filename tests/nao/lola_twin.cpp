// SPDX-License-Identifier: MIT
// A simulated LoLA in real time, with a body that falls after invalid commands. It sends a packet every 12 ms and
// expects an answer before the next one.
//   lola_twin SOCKET STATUS [SECONDS]
// STATUS: file to which it writes the state of the body once a second and at the end. Reads commands from the standard
// input, one per line: push, lift, close (the connection), silent (for 3 s), split, hot, cool.
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <span>
#include <string>

#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include "robots/nao/lola/sensor_packet.h"
#include "tests/robots/nao/twin/lola_server.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {
namespace {

/// Stolen time of all processors since the start of the computer, in ticks of 10 ms.
long stolen() {
  std::ifstream file("/proc/stat");
  std::string name;
  std::array<long, 8> ticks{};
  file >> name;
  for (long& tick : ticks) file >> tick;
  return ticks[7];
}

volatile std::sig_atomic_t ended = 0;

class Twin {
 public:
  explicit Twin(const char* path) : server_(path) {}

  void serve(const char* status, double seconds) {
    const long begin = monotonic_nanoseconds();
    const long steal_before = stolen();
    long next = begin, next_status = begin;
    while (ended == 0 && (seconds <= 0.0 || monotonic_nanoseconds() - begin < static_cast<long>(1e9 * seconds))) {
      next += kCycleNanoseconds;
      server_.hear(next, [this](const Command& command) { body_.take(command); });
      if (monotonic_nanoseconds() - next > kCycleNanoseconds) {  // this process could not run in time
        ++own_delays_;
        next = monotonic_nanoseconds();
      }
      obey();
      cycle();
      if (monotonic_nanoseconds() >= next_status) {
        next_status += 1'000'000'000;
        tell(status, stolen() - steal_before);
      }
    }
    tell(status, stolen() - steal_before);
  }

 private:
  void cycle() {
    body_.step();
    if (server_.welcome()) body_.meet();
    if (!server_.has_client()) return;
    server_.begin_cycle();
    if (silent_ > 0) {
      --silent_;
      return;
    }
    std::array<std::byte, 2048> packet{};
    const std::size_t size = write_sensor_packet(body_.measurement(), body_.identity(), packet);
    const bool is_split = split_ > 0 && --split_ % 2 == 0;
    server_.send(std::span(packet).first(size), is_split ? size / 3 : size);
    ++cycles_;
  }

  void obey() {
    std::array<char, 256> bytes{};
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size() - 1);
    if (size <= 0) return;
    const std::string words(bytes.data(), static_cast<std::size_t>(size));
    const auto has = [&words](const char* word) { return words.find(word) != std::string::npos; };
    if (has("push") && body_.stands()) {
      body_.push();
      ++pushes_;
    }
    if (has("lift")) body_.pick_up_and_put_down();
    if (has("close")) server_.hang_up();
    if (has("silent")) silent_ = 250;
    if (has("split")) split_ = 250;
    if (has("hot")) body_.set_status(2.0f);
    if (has("cool")) body_.set_status(0.0f);
  }

  void tell(const char* status, long steal) const {
    const std::string beside = std::string(status) + ".new";
    std::ofstream file(beside);
    const LolaServer::Counts& counts = server_.counts();
    file << "cycles " << cycles_ << "\nanswers " << counts.answers << "\nmissed " << counts.missed << "\nown_delays "
         << own_delays_ << "\nslowest_us " << counts.slowest / 1000 << "\nsteal_ms " << 10 * steal << "\nconnections "
         << counts.connections << "\nnonsense " << counts.nonsense << "\nfalls " << body_.falls() << "\npushes "
         << pushes_ << "\nposture "
         << (body_.lies()     ? "lies"
             : body_.stands() ? "stands"
             : body_.sits()   ? "sits"
                              : "between")
         << "\nsoft " << body_.is_soft() << "\ncomplaint " << (body_.complaint().empty() ? "none" : body_.complaint())
         << '\n';
    file.close();
    std::rename(beside.c_str(), status);
  }

  TwinBody body_;
  LolaServer server_;
  long cycles_ = 0, own_delays_ = 0, pushes_ = 0;
  int silent_ = 0, split_ = 0;
};

}  // namespace
}  // namespace reorient::nao

int main(int count, char** words) {
  if (count < 3) {
    std::fprintf(stderr, "lola_twin SOCKET STATUS [SECONDS]\n");
    return 2;
  }
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, [](int) { reorient::nao::ended = 1; });
  std::signal(SIGPIPE, SIG_IGN);
  fcntl(STDIN_FILENO, F_SETFL, O_NONBLOCK);
  // The service of a real robot has real-time priority, too.
  sched_param parameter{};
  parameter.sched_priority = 30;
  static_cast<void>(sched_setscheduler(0, SCHED_FIFO, &parameter));
  static_cast<void>(mlockall(MCL_CURRENT | MCL_FUTURE));
  try {
    reorient::nao::Twin(words[1]).serve(words[2], count > 3 ? std::atof(words[3]) : 0.0);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "lola_twin: %s\n", error.what());
    return 2;
  }
}
