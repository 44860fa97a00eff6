// SPDX-License-Identifier: MIT
// Threads beside the frames: writers of files, and servers of viewers.
#pragma once

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace reorient {

inline constexpr int kLiveNiceness = 19;  ///< of threads that serve viewers: the least, because a frame never waits

/// Called in the thread. SCHED_BATCH: its wake-up does not preempt a running frame. `niceness`: more than that of the
/// frames' thread gives it less of a busy processor.
inline void become_batch_thread(int niceness = 0) {
  const sched_param none{};
  pthread_setschedparam(pthread_self(), SCHED_BATCH, &none);
  if (niceness > 0) setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), niceness);
}

}  // namespace reorient
