// SPDX-License-Identifier: MIT
#include "engine/record/record_bytes.h"

#include "geometry/bytes.h"

namespace reorient {
namespace {

/// "RRFD". Change it, and the format of recordings, with the content of a topic that is always filled. Recordings
/// contain no other topics.
constexpr std::uint32_t kRecordMagic = 0x44465252;

/// One topic's content, the same for writing and reading.
template <typename Archive>
void visit_topic(Archive& archive, Topic topic, auto& record) {
  switch (topic) {
    case Topic::inputs:
      return archive(record.inputs);
    case Topic::world:
      return archive(record.world);
    case Topic::percepts:
      return archive(record.percepts);
    case Topic::machines:
      return archive(record.machines, record.transitions, record.published);
    case Topic::commands:
      return archive(record.commands, record.leases, record.begun, record.reorientation);
    case Topic::answer:
      return archive(record.answer, record.claims);
    case Topic::events:
      return archive(record.posture_change, record.logs, record.faults, record.reloads, record.parameter_changes);
    case Topic::application:
      return archive(record.application);
    case Topic::images:
      return archive(record.images);
    case Topic::pose_particles:
      return archive(record.pose_particles);
    case Topic::room:
      return archive(record.room);
    case Topic::conditions:
      return archive(record.conditions);
    case Topic::parameters:
      return archive(record.parameters);
    case Topic::costs:
      return archive(record.costs);
    case Topic::feature_fits:
      return archive(record.feature_fits);
  }
}

}  // namespace

void write_topic(const FrameRecord& record, Topic topic, std::vector<std::byte>& bytes) {
  ByteWriter writer(bytes);
  visit_topic(writer, topic, record);
}

void write_record(const FrameRecord& record, std::vector<std::byte>& bytes, Topics requested,
                  std::vector<std::size_t>* places) {
  ByteWriter writer(bytes);
  const Topics written = record.filled & requested;
  writer(kRecordMagic, written, *record.names);
  if (places != nullptr) places->assign(1, bytes.size());
  for (const TopicInfo& row : kTopics) {
    if (!written.has(row.topic)) continue;
    write_topic(record, row.topic, bytes);
    if (places != nullptr) places->push_back(bytes.size());
  }
}

FrameRecord read_record(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  std::uint32_t magic = 0;
  reader(magic);
  if (magic != kRecordMagic) throw BadBytes("record: not written by this version of the program");
  FrameRecord record;
  NameTable names;
  reader(record.filled, names);
  if (names.names.empty()) throw BadBytes("record: table of names is empty");
  record.names = std::make_shared<NameTable>(std::move(names));
  for (const TopicInfo& row : kTopics) {
    if (record.filled.has(row.topic)) visit_topic(reader, row.topic, record);
  }
  reader.finish();
  return record;
}

void RecordDigest::add(const FrameRecord& record) {
  bytes_.clear();
  for (const TopicInfo& row : kTopics) {
    // Without an application, a run has the digest of a program that knows no applications.
    const bool is_left_out = row.topic == Topic::application && record.application.declared->is_empty();
    if (row.always && row.reproducible && !is_left_out) write_topic(record, row.topic, bytes_);
  }
  digest_.add(bytes_);
  for (const ImageView* const image : {&record.images.upper, &record.images.lower}) {
    if (!record.filled.has(Topic::images) || image->empty()) continue;
    for (int y = 0; y < image->height; ++y)
      digest_.add(std::as_bytes(std::span(image->row(y), static_cast<std::size_t>(2 * image->width))));
  }
}

}  // namespace reorient
