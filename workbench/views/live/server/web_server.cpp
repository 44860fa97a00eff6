// SPDX-License-Identifier: MIT
#include "workbench/views/live/server/web_server.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <civetweb.h>
#include <poll.h>
#include <sys/socket.h>

#include "engine/parameters/utf8.h"
#include "workbench/run/batch_thread.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"
#include "workbench/views/live/server/compression.h"
#include "workbench/views/live/server/sockets.h"

namespace reorient::live {
namespace {

constexpr std::uint16_t kGoingAway = 1001;

/// civetweb ignores SIGPIPE for the whole program. Neither it nor this file needs that, and the program decides it.
class KeepPipeSignal {
 public:
  KeepPipeSignal() { sigaction(SIGPIPE, nullptr, &before_); }
  ~KeepPipeSignal() { sigaction(SIGPIPE, &before_, nullptr); }
  KeepPipeSignal(const KeepPipeSignal&) = delete;
  KeepPipeSignal& operator=(const KeepPipeSignal&) = delete;

 private:
  struct sigaction before_ {};
};

std::string header(const mg_connection* connection, const char* name) {
  const char* const value = mg_get_header(connection, name);
  return value != nullptr ? value : "";
}

RequestHead head_of(const mg_connection* connection) {
  const mg_request_info& info = *mg_get_request_info(connection);
  const auto text = [](const char* one) { return std::string(one != nullptr ? one : ""); };
  RequestHead head{text(info.request_method), text(info.local_uri_raw), text(info.query_string), {}, {}, false, {}};
  head.host = header(connection, "Host");
  if (mg_get_header(connection, "Origin") != nullptr) head.origin = header(connection, "Origin");
  head.is_websocket = mg_get_header(connection, "Upgrade") != nullptr;
  for (int i = 0; i < info.num_headers; ++i) {  // it may stand several times
    if (mg_strcasecmp(info.http_headers[i].name, "Sec-WebSocket-Protocol") == 0)
      head.subprotocols.append(head.subprotocols.empty() ? "" : ",").append(text(info.http_headers[i].value));
  }
  return head;
}

/// `more`: headers, each with its line end.
int respond(mg_connection* connection, int code, std::string_view type, std::string_view text, bool with_text,
            std::string_view more = "") {
  const std::string head =
      "HTTP/1.1 " + std::to_string(code) + ' ' + mg_get_response_code_text(connection, code) +
      "\r\nContent-Type: " + std::string(type) + "\r\nContent-Length: " + std::to_string(text.size()) + "\r\n" +
      std::string(more) +
      "Cache-Control: no-store\r\nConnection: close\r\nX-Content-Type-Options: nosniff\r\n"
      "X-Frame-Options: DENY\r\nReferrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\n"
      "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
      "img-src 'self' data: blob:; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'\r\n\r\n";
  mg_write(connection, head.data(), head.size());
  if (with_text && !text.empty()) mg_write(connection, text.data(), text.size());
  return code;
}

int respond(mg_connection* connection, const ServedFile& file, bool with_text) {
  constexpr std::string_view kVaries = "Vary: Accept-Encoding\r\n";
  if (file.gzip.empty() || !accepts_gzip(header(connection, "Accept-Encoding")))
    return respond(connection, 200, file.type, file.text, with_text, kVaries);
  return respond(connection, 200, file.type, file.gzip, with_text, "Content-Encoding: gzip\r\n" + std::string(kVaries));
}

/// After the last message: the viewer reads it and ends the connection, too. To close a socket with unread bytes would
/// reset the connection, and the viewer would lose what it has not read yet, such as the reason of the end.
template <typename IsGivenUp>
void end_gently(int socket, const IsGivenUp& is_given_up) {
  constexpr int kStep = 20;  // ms
  shutdown(socket, SHUT_WR);
  for (pollfd ended{socket, POLLRDHUP, 0}; !is_given_up() && poll(&ended, 1, kStep) == 0;) {
  }
  shutdown(socket, SHUT_RDWR);
}

void send_messages(int socket, ViewerMailbox& mailbox) {
  become_batch_thread(kLiveNiceness);
  const auto is_given_up = [&mailbox] { return mailbox.is_given_up(); };
  while (const std::optional<Outgoing> message = mailbox.wait()) {
    std::vector<std::byte> begin;
    if (message->type != WebSocketType::close) begin = websocket_head(message->type, message->size());
    begin.insert(begin.end(), message->own.begin(), message->own.end());
    if (!send_all(socket, begin, is_given_up)) break;
    if (message->shared && !send_all(socket, std::as_bytes(std::span(*message->shared)), is_given_up)) break;
  }
  mailbox.close_now(kGoingAway, "");  // nothing is collected for a viewer that is gone
  end_gently(socket, is_given_up);
}

/// Waits for bytes. Nothing: the connection has ended.
std::span<const std::byte> receive_some(int socket, std::span<std::byte> memory) {
  while (true) {
    pollfd waiting{socket, POLLIN, 0};
    poll(&waiting, 1, -1);
    const ssize_t size = recv(socket, memory.data(), memory.size(), MSG_DONTWAIT);
    if (size > 0) return memory.first(static_cast<std::size_t>(size));
    if (size == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) return {};
  }
}

void hand_over(const WebSocketMessage& message, ViewerSession& session, ViewerMailbox& mailbox) {
  if (message.type == WebSocketType::ping) mailbox.add_control(Outgoing{WebSocketType::pong, message.data, nullptr});
  if (message.type == WebSocketType::pong) mailbox.receive_pong(message.data);
  if (message.type == WebSocketType::close) mailbox.close_now(kNormalClose, "");
  if (message.type == WebSocketType::binary) session.receive_binary(message.data);
  if (message.type == WebSocketType::text)
    session.receive_text({reinterpret_cast<const char*>(message.data.data()), message.data.size()});
}

/// Until the connection ends.
void read_messages(int socket, ViewerSession& session, ViewerMailbox& mailbox) {
  WebSocketReader reader(kLargestClientMessage);
  std::vector<std::byte> memory(std::size_t{64} << 10);
  while (true) {
    const std::span<const std::byte> bytes = receive_some(socket, memory);
    if (bytes.empty()) return;
    reader.add(bytes);
    while (const std::optional<WebSocketMessage> message = reader.next()) {
      hand_over(*message, session, mailbox);
      if (message->type == WebSocketType::close) return;
    }
    if (!reader.failure().empty()) return mailbox.close_now(reader.failure_code(), reader.failure());
  }
}

}  // namespace

struct WebServer::Parts {
  Parts(WebServerOptions given, Find find_file, Open open_session)
      : options(std::move(given)), find(std::move(find_file)), open(std::move(open_session)) {}

  int begin_request(mg_connection* connection) const;
  void serve_viewer(mg_connection* connection);
  bool is_full() const {
    const std::lock_guard lock(mutex);
    return stops || mailboxes.size() >= static_cast<std::size_t>(options.most_viewers);
  }

  const WebServerOptions options;
  const Find find;
  const Open open;
  AccessRules rules;
  std::array<const char*, kSubprotocols.size()> names{kSubprotocols[0].data(), kSubprotocols[1].data()};
  mg_websocket_subprotocols subprotocols{static_cast<int>(names.size()), names.data()};
  mg_context* context = nullptr;
  int port = 0;
  std::atomic<bool> is_starting = true;
  std::string trouble;  // what civetweb reports while it starts

  mutable std::mutex mutex;  // protects all members below
  std::condition_variable changed;
  std::set<std::shared_ptr<ViewerMailbox>> mailboxes;
  bool stops = false;
};

/// Answers the request, or lets civetweb do the handshake of a WebSocket (0).
int WebServer::Parts::begin_request(mg_connection* connection) const {
  const RequestHead head = head_of(connection);
  const bool with_text = head.method != "HEAD";
  const auto refuse_request = [&](int code, const std::string& reason) {
    return respond(connection, code, "text/plain; charset=utf-8", reason + "\n", with_text);
  };
  const Access access = decide(head, rules);
  if (access.refusal != 0) return refuse_request(access.refusal, access.reason);
  if (head.is_websocket) {
    if (!is_full()) return 0;
    return refuse_request(
        503, "expected at most " + std::to_string(options.most_viewers) + " viewers at once; close one of them");
  }
  const ServedFile* const file = find(head.path);
  if (file == nullptr) return refuse_request(404, "unknown path; the page is at /");
  return respond(connection, *file, with_text);
}

/// On the thread of the connection, after the handshake, until the viewer is gone.
void WebServer::Parts::serve_viewer(mg_connection* connection) {
  const mg_request_info& info = *mg_get_request_info(connection);
  const int socket = find_connection(port, info.remote_addr, info.remote_port);
  if (socket < 0) return;
  notice_vanished_peer(socket);
  const auto mailbox = std::make_shared<ViewerMailbox>(options.mailbox);
  const bool is_one_too_many = is_full();
  {
    const std::lock_guard lock(mutex);
    mailboxes.insert(mailbox);
    if (stops) mailbox->close(kGoingAway, "the run has ended");
  }
  if (is_one_too_many) mailbox->close(kPolicyViolation, "too many viewers at once; close one of them");
  const RequestHead head = head_of(connection);
  mailbox->measure(is_own_page(head));
  std::thread sender(send_messages, socket, std::ref(*mailbox));
  {
    const std::unique_ptr<ViewerSession> session = open(mailbox, decide(head, rules));
    read_messages(socket, *session, *mailbox);
  }
  mailbox->close_now(kNormalClose, "");
  sender.join();
  shutdown(socket, SHUT_RDWR);  // so that civetweb, which reads next, closes it
  const std::lock_guard lock(mutex);
  mailboxes.erase(mailbox);
  changed.notify_all();
}

WebServer::WebServer(WebServerOptions options, Find find, Open open)
    : parts_(std::make_unique<Parts>(std::move(options), std::move(find), std::move(open))) {
  Parts& parts = *parts_;
  const WebServerOptions& given = parts.options;
  parts.rules = {given.address, given.token, given.allowed_origins};
  const bool is_v6 = given.address.find(':') != std::string::npos;
  const std::string ports = (is_v6 ? "[" + given.address + "]" : given.address) + ":" + std::to_string(given.port);
  const std::string threads = std::to_string(given.most_viewers + 8);  // a viewer occupies one
  const char* const settings[] = {"listening_ports",
                                  ports.c_str(),
                                  "num_threads",
                                  threads.c_str(),
                                  "request_timeout_ms",
                                  "3000",
                                  "enable_directory_listing",
                                  "no",
                                  "enable_keep_alive",
                                  "no",
                                  "tcp_nodelay",
                                  "1",
                                  nullptr};
  mg_callbacks callbacks{};
  callbacks.begin_request = [](mg_connection* connection) {
    return static_cast<Parts*>(mg_get_user_data(mg_get_context(connection)))->begin_request(connection);
  };
  // civetweb's own answer to a request that it cannot read has a Date header, whose text its threads share.
  callbacks.http_error = [](mg_connection* connection, int status, const char* /*message*/) {
    respond(connection, status, "text/plain; charset=utf-8", "expected an HTTP request that this server reads\n", true);
    return 0;
  };
  callbacks.log_message = [](const mg_connection* connection, const char* message) {
    auto* const all = static_cast<Parts*>(mg_get_user_data(mg_get_context(connection)));
    if (all != nullptr && all->is_starting) all->trouble = message;
    return 1;
  };
  callbacks.init_thread = [](const mg_context* /*context*/, int /*type*/) -> void* {
    become_batch_thread(kLiveNiceness);
    return nullptr;
  };
  const KeepPipeSignal keep;
  mg_init_library(MG_FEATURES_DEFAULT);
  parts.context = mg_start(&callbacks, &parts, const_cast<const char**>(settings));
  if (parts.context == nullptr) {
    mg_exit_library();
    throw std::runtime_error("--live " + std::to_string(given.port) + ": cannot listen at " + ports +
                             ": expected an address of this computer and a port that no other program uses; choose "
                             "another port, or 0 for a free one" +
                             (parts.trouble.empty() ? "" : " (" + as_line(parts.trouble) + ")"));
  }
  parts.is_starting = false;
  mg_server_port listening{};
  mg_get_server_ports(parts.context, 1, &listening);
  parts.port = listening.port;
  mg_set_websocket_handler_with_subprotocols(
      parts.context, "/", &parts.subprotocols,
      [](const mg_connection* connection, void* /*data*/) {
        // civetweb chooses the name; the same as decide(), except for unusual spaces.
        return mg_get_request_info(connection)->acceptedWebSocketSubprotocol != nullptr ? 0 : 1;
      },
      [](mg_connection* connection, void* data) { static_cast<Parts*>(data)->serve_viewer(connection); }, nullptr,
      nullptr, &parts);
}

WebServer::~WebServer() { stop("the run has ended"); }

int WebServer::port() const { return parts_->port; }

void WebServer::stop(const std::string& reason) {
  Parts& parts = *parts_;
  if (parts.context == nullptr) return;
  {
    std::unique_lock lock(parts.mutex);
    parts.stops = true;
    for (const auto& mailbox : parts.mailboxes) mailbox->close(kGoingAway, reason);
    parts.changed.wait_for(lock, ViewerMailbox::kPatience, [&] { return parts.mailboxes.empty(); });
  }
  shut_down_port(parts.port);
  mg_stop(std::exchange(parts.context, nullptr));
  mg_exit_library();
}

}  // namespace reorient::live
