// SPDX-License-Identifier: MIT
#include "tests/robots/companion/raw_client.h"

#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace reorient {

reorient_hello small_hello(std::uint64_t client, std::uint32_t way) {
  reorient_hello hello{};
  hello.client = client;
  hello.way = way;
  hello.wants = REORIENT_WANT_HEAD | REORIENT_WANT_WALK;
  reorient_camera& camera = hello.cameras[0];
  camera.width = 64;
  camera.height = 64;
  camera.format = REORIENT_GRAY;
  camera.focal[0] = camera.focal[1] = 60.0;
  camera.center[0] = camera.center[1] = 31.5;
  reorient_body& body = hello.body;
  set_text(body.name, "a test robot");
  body.has = REORIENT_BODY_NUMBERS | REORIENT_BODY_WALK | REORIENT_BODY_FEET;
  body.torso_height = 0.25;
  body.first_axis[2] = 0.2;
  body.yaw_limit = 2.0;
  body.pitch_limit[0] = -0.5;
  body.pitch_limit[1] = 0.5;
  body.head_speed = 4.0;
  body.standing_load = 5.0;
  body.walk_limit[0] = body.walk_limit[1] = body.walk_limit[2] = 0.5;
  body.cruise = 0.2;
  reorient_field& field = hello.field;
  field.length = 9.0;
  field.width = 6.0;
  field.border = 0.7;
  field.line_width = 0.05;
  field.penalty_area[0] = 1.65;
  field.penalty_area[1] = 4.0;
  field.penalty_mark = 3.2;
  field.mark_size = 0.1;
  field.circle_radius = 0.75;
  field.post_y = 0.8;
  field.goal_height = 0.8;
  field.goal_depth = 0.5;
  field.post_diameter = 0.1;
  return hello;
}

reorient_frame standing_frame(std::uint64_t number, double time, std::uint64_t sequence) {
  reorient_frame frame{};
  frame.number = number;
  frame.time = time;
  frame.has = REORIENT_HAS_TIME;
  frame.images[0].present = sequence > 0 ? 1 : 0;
  frame.images[0].slot = static_cast<std::uint32_t>(sequence / 2 % REORIENT_SLOTS);
  frame.images[0].sequence = sequence;
  return frame;
}

KnownRobots no_known_robots() {
  return {[](const std::string&) { return std::optional<RobotBody>(); },
          [](const std::string&) { return std::optional<FieldDimensions>(); }};
}

RawClient::RawClient(const std::filesystem::path& path)
    : socket_(socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
  if (connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) end();
}

bool RawClient::send_bytes(std::span<const std::byte> bytes, int descriptor) {
  if (!socket_) return false;
  iovec part{const_cast<std::byte*>(bytes.data()), bytes.size()};
  union {
    cmsghdr header;
    char bytes[CMSG_SPACE(sizeof(int))];
  } control{};
  msghdr all{};
  all.msg_iov = &part;
  all.msg_iovlen = 1;
  if (descriptor >= 0) {
    all.msg_control = &control;
    all.msg_controllen = sizeof(control);
    cmsghdr* const header = CMSG_FIRSTHDR(&all);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof(int));
  }
  return sendmsg(socket_.get(), &all, MSG_DONTWAIT | MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

OwnedDescriptor memory_of(std::size_t bytes, bool sealed) {
  OwnedDescriptor memory(memfd_create("test", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!memory || ftruncate(memory.get(), static_cast<off_t>(bytes)) != 0) throw std::runtime_error("memfd failed");
  if (sealed) fcntl(memory.get(), F_ADD_SEALS, F_SEAL_SHRINK);
  return memory;
}

void RawClient::introduce(const reorient_hello& hello) {
  std::vector<std::byte> bytes;
  append_message(REORIENT_HELLO, hello, bytes);
  introduce(bytes);
}

void RawClient::introduce(std::span<const std::byte> hello) {
  slot_size_ = REORIENT_SLOT_HEADER + 64 * 64;
  const std::size_t bytes = std::size_t{REORIENT_SLOTS} * slot_size_;
  memory_ = memory_of(bytes, true);
  void* const base = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory_.get(), 0);
  if (base == MAP_FAILED) throw std::runtime_error("mmap failed");
  slots_ = {static_cast<std::byte*>(base), [bytes](std::byte* slots) { munmap(slots, bytes); }};
  send_bytes(hello);
  send(REORIENT_MEMORY, reorient_memory{0, slot_size_}, memory_.get());
}

std::uint64_t RawClient::paint(std::uint8_t gray) {
  sequence_ += 2;
  std::byte* const slot = slots_.get() + sequence_ / 2 % REORIENT_SLOTS * slot_size_;
  std::memset(slot + REORIENT_SLOT_HEADER, gray, 64 * 64);
  std::memcpy(slot, &sequence_, sizeof(sequence_));
  return sequence_;
}

bool RawClient::send_frame(double time, std::uint64_t number) {
  return send(REORIENT_FRAME, standing_frame(number, time, paint(static_cast<std::uint8_t>(number))));
}

std::vector<RawClient::Heard> RawClient::hear() {
  std::vector<Heard> all;
  std::byte piece[4096];
  ssize_t got = 0;
  while (socket_ && (got = recv(socket_.get(), piece, sizeof(piece), MSG_DONTWAIT)) > 0)
    in_.insert(in_.end(), piece, piece + got);
  if (got == 0) end();
  std::span<const std::byte> rest = in_;
  while (rest.size() >= sizeof(reorient_header)) {
    std::span<const std::byte> bytes = rest;
    const auto header = take_message<reorient_header>(bytes, "a header");
    if (bytes.size() < header.size) break;
    all.push_back({header.kind, {bytes.begin(), bytes.begin() + header.size}});
    rest = bytes.subspan(header.size);
  }
  in_.assign(rest.begin(), rest.end());
  return all;
}

std::optional<reorient_answer> RawClient::answer() {
  std::optional<reorient_answer> last;
  for (const Heard& one : hear()) {
    if (one.kind == REORIENT_ANSWER) last = one.as<reorient_answer>();
  }
  return last;
}

std::string RawClient::refusal() {
  for (const Heard& one : hear()) {
    if (one.kind == REORIENT_REFUSAL) return text_of(one.as<reorient_refusal>().why);
  }
  return {};
}

}  // namespace reorient
