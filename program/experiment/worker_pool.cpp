// SPDX-License-Identifier: MIT
#include "program/experiment/worker_pool.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace reorient {
namespace {

constexpr std::size_t kLongestMistake = 2000;  // bytes

/// The worker's end of the socket: receives task numbers and sends the outcome of each, one message per task.
[[noreturn]] void serve(int socket, const std::function<void(int task)>& work) {
  int task = 0;
  while (recv(socket, &task, sizeof task, 0) == sizeof task) {
    std::string mistake;
    try {
      work(task);
    } catch (const std::exception& error) {
      mistake = std::string(error.what()).substr(0, kLongestMistake);
      if (mistake.empty()) mistake = "unknown error";
    }
    // A message has at least one byte: an empty one would look like the end.
    mistake.insert(mistake.begin(), ' ');
    if (send(socket, mistake.data(), mistake.size(), MSG_NOSIGNAL) < 0) break;
  }
  _exit(0);  // without flushing the buffers of the parent
}

class Worker {
 public:
  /// `others`: sockets of other workers, which this process closes.
  Worker(const std::function<void(int task)>& work, const std::vector<int>& others) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
      throw std::system_error(errno, std::generic_category(), "cannot create a socket for a worker");
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) {
      const int error = errno;
      close(ends[0]);
      close(ends[1]);
      throw std::system_error(error, std::generic_category(), "cannot create a process for a worker");
    }
    if (process_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // a worker ends with its parent
      if (getppid() != parent) _exit(0);
      close(ends[0]);
      for (const int other : others) close(other);
      serve(ends[1], work);
    }
    close(ends[1]);
    socket_ = ends[0];
  }
  ~Worker() { end(); }
  Worker(Worker&& other) noexcept
      : process_(std::exchange(other.process_, 0)), socket_(std::exchange(other.socket_, -1)), task_(other.task_) {}
  Worker& operator=(Worker&&) = delete;

  int socket() const { return socket_; }
  bool is_busy() const { return task_.has_value(); }

  void give(int task) {
    task_ = task;
    send(socket_, &task, sizeof task, MSG_NOSIGNAL);  // if the worker has ended, the next read detects it
  }

  /// The outcome of its task; nothing: its process ended without a task.
  std::optional<TaskEnd> take(bool& is_gone) {
    std::array<char, kLongestMistake + 1> message{};
    const ssize_t size = recv(socket_, message.data(), message.size(), 0);
    TaskEnd end;
    end.number = task_.value_or(0);
    const bool had_one = is_busy();
    task_.reset();
    is_gone = size <= 0;
    if (!is_gone) {
      end.mistake.assign(message.data() + 1, static_cast<std::size_t>(size) - 1);
      return end;
    }
    const int status = this->end();
    if (!had_one) return std::nullopt;
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    if (end.signal == 0) end.mistake = "its process ended";
    return end;
  }

 private:
  /// Ends the process in any state. Returns the status of waitpid.
  int end() {
    if (process_ <= 0) return 0;
    int status = 0;
    // A process that ended by itself keeps its own status.
    kill(process_, SIGKILL);
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    close(socket_);
    process_ = 0;
    socket_ = -1;
    return status;
  }

  pid_t process_ = 0;
  int socket_ = -1;
  std::optional<int> task_;
};

}  // namespace

void run_in_processes(const std::vector<int>& tasks, int jobs, const std::function<void(int task)>& work,
                      const std::function<bool(const TaskEnd& end)>& tell, const std::function<bool()>& stop) {
  constexpr int kLongestWait = 100;  // ms between two checks whether to stop
  std::vector<Worker> workers;
  auto next = tasks.begin();
  while (next != tasks.end() || std::any_of(workers.begin(), workers.end(), [](auto& one) { return one.is_busy(); })) {
    for (Worker& worker : workers) {
      if (!worker.is_busy() && next != tasks.end()) worker.give(*next++);
    }
    while (next != tasks.end() && static_cast<int>(workers.size()) < jobs) {
      std::vector<int> others;
      others.reserve(workers.size());
      for (const Worker& worker : workers) others.push_back(worker.socket());
      workers.emplace_back(work, others);
      workers.back().give(*next++);
    }
    std::vector<pollfd> waiting;
    waiting.reserve(workers.size());
    for (const Worker& worker : workers) waiting.push_back({worker.socket(), POLLIN, 0});
    poll(waiting.data(), waiting.size(), kLongestWait);
    if (stop()) return;
    for (std::size_t i = workers.size(); i-- > 0;) {
      if (waiting[i].revents == 0) continue;
      bool is_gone = false;
      const std::optional<TaskEnd> end = workers[i].take(is_gone);
      if (end && !tell(*end)) return;
      if (is_gone) {
        std::vector<Worker> rest;
        for (std::size_t j = 0; j < workers.size(); ++j) {
          if (j != i) rest.push_back(std::move(workers[j]));
        }
        workers.swap(rest);
      }
    }
  }
}

}  // namespace reorient
