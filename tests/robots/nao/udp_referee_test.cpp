// SPDX-License-Identifier: MIT
// Datagrams of several GameControllers in one network, sent through addresses of the loopback interface.
#include "robots/nao/udp_referee.h"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/waiting.h"

namespace reorient::nao {
namespace {

sockaddr_in address_of(const char* address, std::uint16_t port) {
  sockaddr_in all{};
  all.sin_family = AF_INET;
  all.sin_port = htons(port);
  inet_pton(AF_INET, address, &all.sin_addr);
  return all;
}

/// A sender with its own address.
class Speaker {
 public:
  explicit Speaker(const char* address) : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    const sockaddr_in from = address_of(address, 0);
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&from), sizeof(from)) != 0)
      ADD_FAILURE() << "cannot open a socket at " << address;
  }
  ~Speaker() { close(socket_); }
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  std::uint16_t port() const {
    sockaddr_in from{};
    socklen_t length = sizeof(from);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&from), &length);
    return ntohs(from.sin_port);
  }
  void say(const std::string& text, std::uint16_t port) const {
    const sockaddr_in to = address_of("127.0.0.1", port);
    EXPECT_EQ(sendto(socket_, text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof(to)),
              static_cast<ssize_t>(text.size()));
  }
  /// Returns the next received datagram, or an empty text.
  std::string heard() const {
    char text[64];
    const ssize_t size = recv(socket_, text, sizeof(text), MSG_DONTWAIT);
    return {text, static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
  }
  /// Waits for the next datagram. The kernel may deliver it a moment after it was sent.
  std::string await_heard() const {
    std::string text;
    await([&] { return !(text = heard()).empty(); });
    return text;
  }

 private:
  int socket_;
};

class UdpRefereeTest : public testing::Test {
 protected:
  static std::uint16_t free_port() { return Speaker("127.0.0.1").port(); }
  std::string hear() {
    const std::span<const std::byte> datagram = referee_.receive();
    return {reinterpret_cast<const char*>(datagram.data()), datagram.size()};
  }
  std::string await_heard() {
    std::string text;
    await([&] { return !(text = hear()).empty(); });
    return text;
  }

  double now_ = 100.0;
  std::uint16_t port_ = free_port();
  Speaker ours_{"127.0.0.2"}, others_{"127.0.0.3"};
  UdpReferee referee_{port_, ours_.port(), [this] { return now_; }};
};

TEST_F(UdpRefereeTest, ReceivesFromEachSenderUntilOneIsAccepted) {
  others_.say("RGme, of another field", port_);
  EXPECT_EQ(await_heard(), "RGme, of another field");
  ours_.say("RGme, of ours", port_);
  EXPECT_EQ(await_heard(), "RGme, of ours") << "the datagram of the other sender is ignored";
  referee_.accept_sender();
  others_.say("RGme, of another field", port_);
  EXPECT_EQ(hear(), "");
  now_ += 9.0;
  others_.say("RGme, of another field", port_);
  ours_.say("RGme, again", port_);
  EXPECT_EQ(await_heard(), "RGme, again");
  referee_.accept_sender();
  now_ += 11.0;
  others_.say("RGme, another machine", port_);
  EXPECT_EQ(await_heard(), "RGme, another machine") << "the accepted sender is silent";
}

TEST_F(UdpRefereeTest, AnswersTheSender) {
  ours_.say("nothing of a referee", port_);
  ours_.say("RGme", port_);
  EXPECT_EQ(await_heard(), "RGme");
  const std::string text = "here I am";
  referee_.answer(std::as_bytes(std::span(text)));
  EXPECT_EQ(ours_.await_heard(), text);
  EXPECT_EQ(others_.heard(), "");
}

TEST_F(UdpRefereeTest, NamesThePortThatIsInUse) {
  const Speaker holder("0.0.0.0");
  try {
    const UdpReferee other(holder.port(), 1, [] { return 0.0; });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("UDP port " + std::to_string(holder.port())), std::string::npos);
  }
}

}  // namespace
}  // namespace reorient::nao
