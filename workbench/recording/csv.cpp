// SPDX-License-Identifier: MIT
#include "workbench/recording/csv.h"

#include <ostream>
#include <stdexcept>

#include "engine/parameters/utf8.h"
#include "engine/record/record_bytes.h"
#include "geometry/bytes.h"
#include "workbench/files/csv_text.h"
#include "workbench/recording/value_text.h"
#include "workbench/run/timeline.h"

namespace reorient {
namespace {

// Beginnings of the first lines of the tables.
constexpr std::string_view kWorldHead = "frame,clock.", kEventsHead = "time,machine,state,command,verdict,reason";

/// Calls `write` with each frame and its record. Returns the number of frames whose record cannot be read.
template <typename Write>
std::uint64_t each_record(Recording& recording, const std::ostream& out, Write write) {
  std::uint64_t left_out = 0;
  RecordedFrame frame;
  while (out && recording.next(frame)) {
    try {
      write(frame, read_record(frame.entry.record));
    } catch (const BadBytes& bad) {
      recording.add_damage(frame, bad.what());
      ++left_out;
    }
  }
  return left_out;
}

std::uint64_t write_world(Recording& recording, std::ostream& out) {
  out << "frame";
  for (const WorldField& field : world_fields()) out << ',' << field.full_name();
  out << ",truth.x,truth.y,truth.rotation\n";
  std::vector<double> values;
  return each_record(recording, out, [&](const RecordedFrame& frame, const FrameRecord& record) {
    values.clear();
    append_world(record.world, values);
    out << record.world.frame;
    for (std::size_t i = 0; i < values.size(); ++i) out << ',' << exact_text(world_fields()[i], values[i]);
    if (const std::optional<GroundTruth>& truth = frame.entry.scene.truth) {
      out << ',' << exact_text(truth->pose.position.x()) << ',' << exact_text(truth->pose.position.y()) << ','
          << exact_text(truth->pose.rotation) << '\n';
    } else {
      out << ",,,\n";
    }
  });
}

std::uint64_t write_events(Recording& recording, std::ostream& out) {
  out << kEventsHead << '\n';
  return each_record(recording, out, [&](const RecordedFrame& frame, const FrameRecord& record) {
    for (const TimelineEvent& event : timeline_events(record, frame.entry.scene)) {
      out << exact_text(event.time);
      for (const std::string* const text :
           {&event.machine, &event.state, &event.command, &event.verdict, &event.reason})
        out << ',' << csv_cell(as_line(*text));
      out << '\n';
    }
  });
}

struct CsvTopic {
  std::string_view name;
  std::uint64_t (*write)(Recording&, std::ostream&);
};
constexpr CsvTopic kCsvTopics[] = {{"world", write_world}, {"events", write_events}};

}  // namespace

std::vector<std::string> csv_topics() {
  std::vector<std::string> names;
  for (const CsvTopic& topic : kCsvTopics) names.emplace_back(topic.name);
  return names;
}

bool begins_csv(std::string_view text) { return text.starts_with(kWorldHead) || text.starts_with(kEventsHead); }

std::uint64_t write_csv(Recording& recording, std::string_view topic, std::ostream& out) {
  for (const CsvTopic& known : kCsvTopics) {
    if (known.name == topic) return known.write(recording, out);
  }
  throw std::runtime_error("unknown table '" + std::string(topic) + "' (expected world or events)");
}

}  // namespace reorient
