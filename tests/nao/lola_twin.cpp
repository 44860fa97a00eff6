// LoLA in real time, in front of a body that falls where it is told wrong things: a packet every 12 ms, an answer
// wanted before the next one.
//   lola_twin SOCKET STATUS [SECONDS]
// STATUS: a file that says once a second, and in the end, how the body does. Commands on its standard input, a line
// each: push, lift, close (the connection), silent (for 3 s), split, hot, cool, chest.
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "robots/nao/lola/command_packet.h"
#include "robots/nao/lola/packet_stream.h"
#include "robots/nao/lola/sensor_packet.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {
namespace {

constexpr long kCycle = 12'000'000;  // ns

long now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1'000'000'000L * time.tv_sec + time.tv_nsec;
}

/// Of all processors, since the machine was started: what others took of them, ticks of 10 ms.
long stolen() {
  std::ifstream file("/proc/stat");
  std::string name;
  std::array<long, 8> ticks{};
  file >> name;
  for (long& tick : ticks) file >> tick;
  return ticks[7];
}

volatile std::sig_atomic_t ended = 0;

class Server {
 public:
  explicit Server(const char* path) {
    listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::snprintf(address.sun_path, sizeof(address.sun_path), "%s", path);
    unlink(path);
    if (bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
        listen(listener_, 1) != 0) {
      std::perror("lola_twin");
      std::exit(2);
    }
  }

  void serve(const char* status, double seconds) {
    const long begin = now();
    const long steal_before = stolen();
    long next = begin, next_status = begin;
    while (ended == 0 && (seconds <= 0.0 || now() - begin < static_cast<long>(1e9 * seconds))) {
      next += kCycle;
      listen_until(next);
      if (now() - next > kCycle) {  // we ourselves were kept from running
        ++own_delays_;
        next = now();
      }
      obey();
      cycle();
      if (now() >= next_status) {
        next_status += 1'000'000'000;
        tell(status, stolen() - steal_before);
      }
    }
    tell(status, stolen() - steal_before);
  }

 private:
  void cycle() {
    body_.step();
    if (client_ < 0) {
      client_ = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
      if (client_ < 0) return;
      ++connections_;
      body_.meet();
      stream_.clear();
      awaits_ = false;
    }
    if (awaits_) {
      ++missed_;
      awaits_ = false;
    }
    if (silent_ > 0) {
      --silent_;
      return;
    }
    std::array<std::byte, 2048> packet{};
    const std::size_t size = write_sensor_packet(body_.measurement(), body_.identity(), packet);
    std::size_t first = size;
    if (split_ > 0 && --split_ % 2 == 0) first = size / 3;
    if (!put(packet.data(), first) || (first < size && !put(packet.data() + first, size - first))) return hang_up();
    sent_at_ = now();
    awaits_ = true;
    ++cycles_;
  }

  bool put(const std::byte* bytes, std::size_t size) {
    return send(client_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL) == static_cast<ssize_t>(size) || errno == EAGAIN;
  }

  void hang_up() {
    if (client_ >= 0) close(client_);
    client_ = -1;
  }

  void listen_until(long time) {
    while (true) {
      const long left = time - now();
      if (left <= 0) return;
      pollfd wait{client_, POLLIN, 0};
      const timespec patience{0, left};
      if (ppoll(&wait, client_ >= 0 ? 1 : 0, &patience, nullptr) <= 0) continue;
      const std::span<std::byte> space = stream_.space();
      const ssize_t size = recv(client_, space.data(), space.size(), MSG_DONTWAIT);
      if (size <= 0 && !(size < 0 && (errno == EAGAIN || errno == EINTR))) {
        hang_up();
        continue;
      }
      if (size <= 0) continue;
      stream_.written(static_cast<std::size_t>(size));
      std::span<const std::byte> packet;
      PacketStream::State state{};
      while ((state = stream_.next(packet)) == PacketStream::State::packet) {
        Command command;
        if (!read_command_packet(packet, command)) ++nonsense_;
        body_.take(command);
        const long took = now() - sent_at_;
        if (awaits_ && took < kCycle) {
          awaits_ = false;
          slowest_ = std::max(slowest_, took);
          ++answers_;
        }
      }
      if (state == PacketStream::State::nonsense) {
        ++nonsense_;
        hang_up();
      }
    }
  }

  void obey() {
    std::array<char, 256> bytes{};
    const ssize_t size = read(STDIN_FILENO, bytes.data(), bytes.size() - 1);
    if (size <= 0) return;
    const std::string words(bytes.data(), static_cast<std::size_t>(size));
    const auto has = [&words](const char* word) { return words.find(word) != std::string::npos; };
    if (has("push") && body_.stands()) {
      body_.push();
      ++pushes_;
    }
    if (has("lift")) body_.pick_up_and_put_down();
    if (has("close")) hang_up();
    if (has("silent")) silent_ = 250;
    if (has("split")) split_ = 250;
    if (has("hot")) body_.set_status(2.0f);
    if (has("cool")) body_.set_status(0.0f);
  }

  void tell(const char* status, long steal) const {
    const std::string beside = std::string(status) + ".new";
    std::ofstream file(beside);
    file << "cycles " << cycles_ << "\nanswers " << answers_ << "\nmissed " << missed_ << "\nown_delays " << own_delays_
         << "\nslowest_us " << slowest_ / 1000 << "\nsteal_ms " << 10 * steal << "\nconnections " << connections_
         << "\nnonsense " << nonsense_ << "\nfalls " << body_.falls() << "\npushes " << pushes_ << "\nposture "
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
  int listener_ = -1, client_ = -1;
  PacketStream stream_;
  bool awaits_ = false;
  long sent_at_ = 0, slowest_ = 0;
  long cycles_ = 0, answers_ = 0, missed_ = 0, own_delays_ = 0, connections_ = 0, nonsense_ = 0, pushes_ = 0;
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
  // A robot's own service has real time, too.
  sched_param parameter{};
  parameter.sched_priority = 30;
  static_cast<void>(sched_setscheduler(0, SCHED_FIFO, &parameter));
  static_cast<void>(mlockall(MCL_CURRENT | MCL_FUTURE));
  reorient::nao::Server(words[1]).serve(words[2], count > 3 ? std::atof(words[3]) : 0.0);
  return 0;
}
