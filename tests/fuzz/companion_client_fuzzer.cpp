// SPDX-License-Identifier: MIT
// Arbitrary bytes from the process that listens at the companion's socket: the client of the header reads them or
// closes the connection, never blocks, and returns zero-terminated texts.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#define REORIENT_COMPANION_CLIENT
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "robots/companion/reorient_companion.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

void hear(const std::uint8_t* data, std::size_t size) {
  const Haste haste(5.0);
  static reorient_client client;
  std::memset(&client, 0, sizeof client);
  client.memory[0] = client.memory[1] = -1;
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0, ends) != 0) return;
  client.socket = ends[0];
  // In two pieces, as a stream may arrive.
  const std::size_t first = size > 0 ? data[0] % size : 0;
  int messages = 0;
  for (const auto& [from, to] : {std::pair{std::size_t{0}, first}, std::pair{first, size}}) {
    if (send(ends[1], data + from, to - from, MSG_NOSIGNAL) < 0) break;
    reorient_event event;
    while (const int kind = reorient_receive(&client, &event)) {
      require(++messages < 10'000, "the number of messages is bounded");
      if (kind == REORIENT_REFUSAL) require(std::memchr(event.refusal.why, 0, sizeof event.refusal.why), "a text ends");
      if (kind == REORIENT_NOTE) require(std::memchr(event.note.text, 0, sizeof event.note.text), "a text ends");
      if (kind == REORIENT_STATE) {
        require(std::memchr(event.state.behavior, 0, sizeof event.state.behavior), "a text ends");
        require(std::memchr(event.state.state, 0, sizeof event.state.state), "a text ends");
      }
      if (kind == REORIENT_ANSWER) {
        reorient_take_command(&client, &event.answer);
        require(reorient_take_command(&client, &event.answer) == 0, "a command is returned once");
      }
    }
  }
  reorient_disconnect(&client);
  close(ends[1]);
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::hear(data, size);
  return 0;
}
