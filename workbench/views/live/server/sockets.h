// SPDX-License-Identifier: MIT
// Sockets of the web server, which civetweb does not hand out, found among the descriptors of this process; and sending
// to a slow viewer.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace reorient::live {

/// The connection of this process at its own port `port` with that peer; -1: none.
int find_connection(int port, const std::string& peer_address, int peer_port);

/// Ends all connections at this port, and no more are accepted: each thread that reads or writes one returns at once.
void shut_down_port(int port);

/// Sends all bytes, however long the peer takes, until `is_given_up` returns true. False: the connection has ended.
bool send_all(int socket, std::span<const std::byte> bytes, const std::function<bool()>& is_given_up);

/// A peer that vanished without a word is noticed after a minute.
void notice_vanished_peer(int socket);

}  // namespace reorient::live
