// SPDX-License-Identifier: MIT
#include "robots/nao/guard/guard_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <time.h>
#include <unistd.h>

#include "robots/nao/guard/session.h"

namespace reorient::nao {
namespace {

constexpr double kSilent = 1.0;           // s without a packet, after which the guard connects again
constexpr double kAgain = 0.5;            // s between two attempts to connect
constexpr double kLongestFarewell = 8.0;  // s, limit for sitting down at the end

volatile std::sig_atomic_t signals = 0;
void count_signal(int) { signals = signals + 1; }

double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class Socket {
 public:
  Socket() = default;
  ~Socket() { hang_up(); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  bool is_open() const { return socket_ >= 0; }
  int get() const { return socket_; }
  void hang_up() {
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
  }
  /// Returns false if no process listens there.
  bool connect(const sockaddr_un& address) {
    hang_up();
    socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket_ < 0) return false;
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0) return true;
    hang_up();
    return false;
  }

 private:
  int socket_ = -1;
};

sockaddr_un address_of(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string text = path.string();
  if (text.empty() || text.size() >= sizeof(address.sun_path))
    throw std::runtime_error("--lola " + text + ": path of " + std::to_string(text.size()) + " bytes (expected 1 to " +
                             std::to_string(sizeof(address.sun_path) - 1) + ")");
  std::copy(text.begin(), text.end(), address.sun_path);
  return address;
}

constexpr std::array<const char*, kGuardStates> kStates{"waiting for LoLA",
                                                        "soft",
                                                        "standing up",
                                                        "standing",
                                                        "sitting down",
                                                        "sitting",
                                                        "fallen: soft until a request to sit"};

struct WarningText {
  std::uint32_t warning;
  const char* text;
};
constexpr std::array<WarningText, 11> kWarnings{{
    {kNoRequest, "no requests from the engine"},
    {kTilted, "tilted too far to stand up or sit down"},
    {kHot, "a motor is hot"},
    {kTooHot, "a motor is too hot"},
    {kBatteryLow, "the battery is low"},
    {kBatteryEmpty, "the battery is empty"},
    {kJointStuck, "a joint does not reach its target"},
    {kJointGivenUp, "a leg joint did not reach its target for 3 s"},
    {kBlind, "LoLA's packets contain no positions or angles"},
    {kForeignBody, "unsupported body version (expected 6): no motion"},
    {kStandRefused, "stands up only after a request to sit: press the button on the chest"},
}};

/// Prints changes. A slow reader must not block the guard, so a line that cannot be written at once is dropped.
class Narrator {
 public:
  explicit Narrator(int out) : out_(out) {}

  void line(std::string_view text) {
    std::array<char, 200> bytes{};
    const int size = std::snprintf(bytes.data(), bytes.size(), "reorient-nao-guard: %.*s\n",
                                   static_cast<int>(text.size()), text.data());
    pollfd room{out_, POLLOUT, 0};
    if (poll(&room, 1, 0) != 1 || (room.revents & POLLOUT) == 0) return;
    const auto length = std::min(static_cast<std::size_t>(std::max(size, 0)), bytes.size() - 1);
    static_cast<void>(!write(out_, bytes.data(), length));
  }

  void tell(const GuardReport& report) {
    if (report.state != state_) line(kStates[static_cast<std::size_t>(report.state)]);
    state_ = report.state;
    constexpr double kPause = 0.5;  // s; limits warnings that change in each cycle
    if (report.warnings == warnings_ || report.time < next_) return;
    next_ = report.time + kPause;
    for (const WarningText& warning : kWarnings) {
      const bool is = (report.warnings & warning.warning) != 0, was = (warnings_ & warning.warning) != 0;
      if (is == was) continue;
      const bool has_joint = is && (warning.warning & (kHot | kTooHot | kJointStuck | kJointGivenUp)) != 0;
      std::array<char, 120> text{};
      std::snprintf(text.data(), text.size(), has_joint ? "%s%s (joint %u)" : "%s%s",
                    is ? "" : "no longer: ", warning.text, report.joint);
      line(text.data());
    }
    warnings_ = report.warnings;
  }

 private:
  int out_;
  GuardState state_ = GuardState::waiting;
  std::uint32_t warnings_ = 0;
  double next_ = 0.0;  // s
};

void ask_for_real_time(int priority, Narrator& narrator) {
  if (priority <= 0) return;
  sched_param parameter{};
  parameter.sched_priority = priority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0)
    narrator.line("real-time priority is not permitted; answers may be late (LimitRTPRIO=, or CAP_SYS_NICE)");
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    narrator.line("memory cannot be locked; answers may be late (LimitMEMLOCK=)");
}

}  // namespace

void run_guard(const GuardOptions& options, int out) {
  const sockaddr_un address = address_of(options.lola);
  MappedBody body(options.body, MappedBody::Side::guard);
  struct sigaction action {};
  action.sa_handler = count_signal;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  struct sigaction ignored {};
  ignored.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignored, nullptr);

  Narrator narrator(out);
  ask_for_real_time(options.priority, narrator);
  Session session(*body);
  Socket socket;
  double heard = 0.0;  // time of the last packet
  double next_attempt = 0.0;
  double farewell = 0.0;  // time at which the guard must end

  const auto hang_up = [&](const char* why) {
    socket.hang_up();
    session.disconnected();
    narrator.line(why);
  };
  const auto send_answer = [&] {
    while (!session.to_send().empty()) {
      const std::span<const std::byte> bytes = session.to_send();
      const ssize_t size = send(socket.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (size > 0) {
        session.sent(static_cast<std::size_t>(size), now());
      } else if (size == 0 || errno != EINTR) {
        return size == 0 || errno == EAGAIN || errno == EWOULDBLOCK;
      }
    }
    return true;
  };
  /// Returns false if the connection is closed.
  const auto read_packets = [&] {
    while (true) {
      const std::span<std::byte> space = session.space();
      const ssize_t size = recv(socket.get(), space.data(), space.size(), MSG_DONTWAIT);
      if (size < 0 && errno == EINTR) continue;
      if (size < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
      if (size == 0) return false;
      heard = now();
      if (!session.received(static_cast<std::size_t>(size), heard)) return false;
      if (static_cast<std::size_t>(size) < space.size()) return true;
    }
  };

  narrator.line("waiting for LoLA");
  while (true) {
    const double time = now();
    if (body.restore()) narrator.line("another program truncated the shared memory; it is restored");
    if (signals > 0) {
      session.finish();
      if (farewell <= 0.0) farewell = time + kLongestFarewell;
      const bool is_done = session.is_at_rest() && session.to_send().empty();
      if (signals > 1 || time > farewell || is_done) return;
    }
    if (!socket.is_open()) {
      if (time >= next_attempt) {
        next_attempt = time + kAgain;
        if (socket.connect(address)) {
          heard = time;
          session.connected();
          narrator.line("connected to LoLA");
        }
      }
      if (!socket.is_open()) {
        constexpr int kPause = 100;  // ms
        poll(nullptr, 0, kPause);
        continue;
      }
    }
    pollfd wait{socket.get(), POLLIN, 0};
    if (!session.to_send().empty()) wait.events |= POLLOUT;
    constexpr int kPatience = 100;  // ms
    const int ready = poll(&wait, 1, kPatience);
    if (ready > 0 && (wait.revents & (POLLIN | POLLHUP | POLLERR)) != 0 && !read_packets()) {
      hang_up("lost the connection to LoLA; connecting again");
      continue;
    }
    if (!send_answer()) {
      hang_up("LoLA accepts no answers; connecting again");
      continue;
    }
    if (now() - heard > kSilent) {
      hang_up("no packet from LoLA for 1 s; connecting again");
      continue;
    }
    narrator.tell(session.report(heard));
  }
}

}  // namespace reorient::nao
