// SPDX-License-Identifier: MIT
#include "tests/robots/nao/twin/nao_world.h"

#include <new>
#include <utility>

namespace reorient::nao {

NaoWorld::NaoWorld(SimulatorParameters parameters, const RobotBody& body, const FieldDimensions& field,
                   const Room& room, const Pose2& start, std::uint64_t seed)
    : nao_(parameters, body, field, room, start, seed), shared_(std::make_unique<SharedBody>()) {
  restart_guard();
}

void NaoWorld::restart_guard() {
  new (shared_.get()) SharedBody;
  session_.emplace(*shared_).connected();
}

NaoSurroundings NaoWorld::surroundings(std::function<bool()> is_over) {
  NaoSurroundings around;
  around.now = [this] { return now_; };
  around.wait = [this](double seconds, std::span<const int> /*descriptors*/) {
    const std::uint64_t before = camera().shown();
    for (const double end = now_ + seconds; now_ < end && camera().shown() == before;) step();
  };
  around.is_over = std::move(is_over);
  around.body = [this] { return guard_is_hidden_ ? nullptr : shared_.get(); };
  around.upper = &camera();
  return around;
}

void NaoWorld::step() {
  now_ += kCycle;
  session_->received(nao_.feel(session_->space()), now_);
  while (!session_->to_send().empty()) {
    nao_.take(session_->to_send());
    session_->sent(session_->to_send().size(), now_);
  }
  nao_.show(now_);
}

}  // namespace reorient::nao
