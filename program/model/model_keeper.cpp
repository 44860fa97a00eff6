// SPDX-License-Identifier: MIT
#include "program/model/model_keeper.h"

#include <stdexcept>
#include <utility>

#include "program/model/model_file.h"

namespace reorient {
namespace {

constexpr double kSavingPeriod = 30.0;  // s

}  // namespace

std::optional<SavedModel> as_mounted(std::optional<SavedModel> model, std::uint64_t mounting) {
  if (model && model->camera_bias) model->camera_bias->body ^= mounting;
  return model;
}

ModelKeeper::ModelKeeper(std::filesystem::path file, const std::optional<SavedModel>& loaded, bool sides_changed,
                         std::uint64_t mounting)
    : file_(std::move(file)),
      sides_changed_(sides_changed),
      mounting_(mounting),
      learned_before_(loaded ? loaded->learned : 0.0),
      camera_bias_(loaded ? loaded->camera_bias : std::nullopt) {
  if (loaded) kept_ = Kept{loaded->basis, loaded->model.known_tiles()};
}

/// The model if it must be saved: it was learned since the last check, and continues the model in the file.
std::optional<SavedModel> ModelKeeper::news(const FrameRecord& frame) {
  if (const auto known = known_bias(frame.world)) camera_bias_ = KnownBias{known->body ^ mounting_, known->bias};
  const double learned = frame.world.trained_seconds;
  if (frame.room.model.empty() || learned <= learned_before_) return std::nullopt;
  SavedModel model{frame.room.basis, learned, BackgroundModel(frame.room.model), camera_bias_};
  const int known_tiles = model.model.known_tiles();
  if (known_tiles == 0) return std::nullopt;
  // A parameter change in the run can clear the engine's model; the file must keep it.
  is_forgotten_ = kept_ && (!differences(kept_->basis, model.basis).empty() || known_tiles < kept_->known_tiles);
  if (is_forgotten_) return std::nullopt;
  kept_ = Kept{model.basis, known_tiles};
  any_news_ = true;
  if (sides_changed_ != frame.world.sides_changed) model.rotate_by_180_degrees();
  return model;
}

void ModelKeeper::observe(const FrameRecord& frame, const SceneTruth& /*scene*/) {
  if (frame.world.time < next_) return;
  if (writing_.is_busy()) return;  // try again in the next frame
  next_ = frame.world.time + kSavingPeriod;
  std::optional<SavedModel> model = news(frame);
  if (!model) return;
  learned_before_ = model->learned;
  writing_.start([model = std::move(*model), file = file_] { write_model_file(model, file); });
}

void ModelKeeper::finish(const FrameRecord& last, const SceneTruth& /*scene*/) {
  writing_.end();
  if (any_news_) learned_before_ = 0.0;  // the last time may have failed
  end_ = news(last);
}

void ModelKeeper::save() {
  if (is_forgotten_) {
    throw std::runtime_error("--model " + file_.string() +
                             ": not saved, because the parameters of the wall or the colors changed in this run, and "
                             "the learned room was lost");
  }
  if (!end_) return;
  write_model_file(*end_, file_);
  is_saved_ = true;
}

std::string ModelKeeper::outcome() const {
  if (is_saved_) return "saved";
  if (end_ || is_forgotten_) return "not saved";
  return "unchanged: nothing new was learned";
}

}  // namespace reorient
