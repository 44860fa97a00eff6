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
  bool has_head = false;
  // The application of the first frame; that of a later one may be another, if a client of a companion was replaced.
  std::vector<NamedScalar> application;
  const auto write_head = [&] {
    out << "frame";
    for (const WorldField& field : world_fields()) out << ',' << field.full_name();
    for (const NamedScalar& scalar : application) out << ',' << scalar.name;
    out << ",truth.x,truth.y,truth.rotation\n";
    has_head = true;
  };
  std::vector<double> values;
  const std::uint64_t left_out =
      each_record(recording, out, [&](const RecordedFrame& frame, const FrameRecord& record) {
        const std::vector<NamedScalar> now = application_values(record.application, record.world.time);
        if (!has_head) {
          application = now;
          write_head();
        }
        values.clear();
        append_world(record.world, values);
        out << record.world.frame;
        for (std::size_t i = 0; i < values.size(); ++i) out << ',' << exact_text(world_fields()[i], values[i]);
        for (std::size_t i = 0; i < application.size(); ++i) {
          const bool has_it = i < now.size() && now[i].name == application[i].name;
          out << ',' << (has_it ? csv_cell(as_line(exact_text(now[i]))) : std::string());
        }
        if (const std::optional<GroundTruth>& truth = frame.entry.scene.truth) {
          out << ',' << exact_text(truth->pose.position.x()) << ',' << exact_text(truth->pose.position.y()) << ','
              << exact_text(truth->pose.rotation) << '\n';
        } else {
          out << ",,,\n";
        }
      });
  if (!has_head) write_head();
  return left_out;
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
