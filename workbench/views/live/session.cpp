// SPDX-License-Identifier: MIT
#include "workbench/views/live/session.h"

#include <exception>
#include <stdexcept>
#include <vector>

#include "engine/parameters/utf8.h"
#include "workbench/views/live/services.h"

namespace reorient::live {
namespace {

constexpr const char* kTooMany = "too many requests at once; wait for the answers and try again";

}  // namespace

Session::Session(const SessionParts& parts, std::shared_ptr<ViewerMailbox> mailbox, Access access)
    : parts_(parts), mailbox_(std::move(mailbox)), access_(std::move(access)), viewer_(0) {
  mailbox_->add_control(server_info(parts_.info));
  mailbox_->add_control(advertise_topics(parts_.viewers.application()));
  mailbox_->add_control(advertise_live_services());
  if (!access_.changes) mailbox_->add_control(status(StatusLevel::info, access_.why_not, "access"));
  viewer_ = parts_.viewers.add(mailbox_);
}

Session::~Session() {
  parts_.what_ifs.forget(viewer_);
  parts_.viewers.remove(viewer_);
}

void Session::warn(const std::string& problem) {
  mailbox_->add_control(status(StatusLevel::warning, as_line(problem)));
}

void Session::receive_text(std::string_view text) {
  try {
    receive(read_client_text(text));
  } catch (const BadClientMessage& bad) {
    warn(bad.what());
  }
}

void Session::receive_binary(std::span<const std::byte> bytes) {
  try {
    receive(read_client_binary(bytes));
  } catch (const BadClientMessage& bad) {
    warn(bad.what());
  }
}

void Session::receive(const ClientMessage& message) {
  std::visit([this](const auto& one) { take(one); }, message);
}

void Session::take(const Subscribe& message) {
  for (const Subscribe::One& one : message.subscriptions) {
    if (const std::string problem = parts_.viewers.subscribe(viewer_, one); !problem.empty()) warn(problem);
  }
}

void Session::take(const Unsubscribe& message) {
  for (const std::uint32_t id : message.ids) {
    if (const std::string problem = parts_.viewers.unsubscribe(viewer_, id); !problem.empty()) warn(problem);
  }
}

bool Session::post(FrameRequest request) { return parts_.requests.add(std::move(request)); }

void Session::take(const GetParameters& message) {
  if (!post({{.viewer = viewer_, .request = message.id, .names = message.names}, ListParameters{}})) warn(kTooMany);
}

void Session::take(const SetParameters& message) {
  AnswerAddress to{.viewer = viewer_, .request = message.id};
  for (const ParameterText& one : message.parameters) to.names.push_back(one.name);
  if (to.names.empty()) return warn("setParameters: expected at least one parameter, found none");
  if (!access_.changes) {
    warn("setParameters: refused: " + access_.why_not);
    // The values in force show the viewer that nothing has changed.
    if (!post({std::move(to), ListParameters{}})) warn(kTooMany);
    return;
  }
  if (!post({std::move(to), ChangeParameters{message.parameters}})) warn(kTooMany);
}

void Session::take(const WatchParameters& message) {
  parts_.viewers.watch(viewer_, message);
  // For no viewer: the values now, with which later ones are compared.
  if (message.begins && !post({{}, ListParameters{}})) warn(kTooMany);
}

FrameTask Session::read_call(const CallService& message, AnswerAddress& to) const {
  const ServiceRow* const row = find_service(message.service);
  if (row == nullptr) throw BadClientMessage("unknown service " + std::to_string(message.service));
  if (message.encoding != "json")
    throw BadClientMessage(std::string(row->name) + ": expected the encoding json, found '" +
                           as_line(std::string_view(message.encoding).substr(0, 40)) + "'");
  if (row->changes && !access_.changes)
    throw BadClientMessage(std::string(row->name) + ": refused: " + access_.why_not);
  to.row = static_cast<std::size_t>(row->service);
  if (row->service == Service::reload) return parts_.scripts.reload(message.payload);
  return read_service_request(*row, message.payload, to);
}

void Session::take(const CallService& message) {
  const auto respond = [&](const std::string& json) {
    mailbox_->add_control(
        Outgoing{WebSocketType::binary, service_response(message.service, message.call, json), nullptr});
  };
  AnswerAddress to{.viewer = viewer_, .service = message.service, .call = message.call};
  try {
    FrameTask task = read_call(message, to);
    const auto service = static_cast<Service>(to.row);
    if (service == Service::file_parameters) return respond(file_parameters(message.payload));
    if (service == Service::what_if) return parts_.what_ifs.ask(to, message.payload);
    if (const auto json = parts_.scripts.answer(service, message.payload)) return respond(*json);
    if (!post({std::move(to), std::move(task)})) throw std::runtime_error(kTooMany);
  } catch (const std::exception& error) {  // whatever it is, the run continues
    mailbox_->add_control(service_failure(message.service, message.call, as_line(error.what())));
  }
}

void Session::take(const FetchAsset& message) {
  mailbox_->add_control(
      Outgoing{WebSocketType::binary,
               asset_failure(message.request, "this server has no assets; robots are drawn as arrows"), nullptr});
}

void Session::take(const ControlPlayback& message) {
  if (!parts_.control_playback) return warn("playback: expected a replay, found a run; use the service pace");
  if (!access_.changes) return warn("playback: refused: " + access_.why_not);
  parts_.control_playback(viewer_, message);
}

void Session::take(const NotOffered& message) { warn("this server does not offer " + std::string(message.operation)); }

}  // namespace reorient::live
