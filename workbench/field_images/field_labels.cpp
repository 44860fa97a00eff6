// SPDX-License-Identifier: MIT
#include "workbench/field_images/field_labels.h"

#include <algorithm>
#include <functional>
#include <set>

#include "engine/record/digest.h"
#include "geometry/angle.h"
#include "workbench/files/table_reader.h"

namespace reorient {
namespace {

constexpr double kFarthest = 10'000.0;  // pixels

std::vector<double> numbers_in(const TableReader& in, const std::string& key, const toml::node& node,
                               std::size_t least_points) {
  const toml::array* const array = node.as_array();
  if (array == nullptr || array->size() % 2 != 0 || array->size() < 2 * least_points)
    in.refuse(node, "each of " + key + ": expected a list of " + std::to_string(least_points) +
                        " or more points: [u, v, ...]" + found_text(node));
  return in.numbers("each of " + key, node, array->size(), -kFarthest, kFarthest);
}

LabeledPixels pixels_of(const std::vector<double>& numbers) {
  LabeledPixels pixels;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) pixels.emplace_back(numbers[i], numbers[i + 1]);
  return pixels;
}

/// Reads a list of lists.
TableReader::Reader each(const TableReader& in,
                         std::function<void(const std::string& key, const toml::node& value)> read) {
  return [&in, read = std::move(read)](const std::string& key, const toml::node& value) {
    const toml::array* const array = value.as_array();
    if (array == nullptr) in.refuse(value, key + ": expected a list of lists of numbers" + found_text(value));
    for (const toml::node& one : *array) read(key, one);
  };
}

TableReader::Reader into(const TableReader& in, std::vector<LabeledPixels>& shapes, std::size_t least_points) {
  return each(in, [&in, &shapes, least_points](const std::string& key, const toml::node& value) {
    shapes.push_back(pixels_of(numbers_in(in, key, value, least_points)));
  });
}

RawFormat raw_format_of(const TableReader& in, const std::string& key, const toml::node& value) {
  constexpr double kLargest = 8192.0, kLargestHeader = 4096.0;
  const std::vector<double> numbers = in.numbers(key, value, 3, 0.0, kLargest);
  if (numbers[0] < 2.0 || numbers[1] < 1.0 || numbers[2] > kLargestHeader)
    in.refuse(value, key + ": expected [width, height, bytes of the header]" + found_text(value));
  return {static_cast<int>(numbers[0]) / 2 * 2, static_cast<int>(numbers[1]), static_cast<std::size_t>(numbers[2])};
}

FieldLabels labels_in(const toml::table& table, const std::string& file) {
  constexpr double kWidest = 170.0, kSteepest = 89.0;  // degrees
  constexpr std::int64_t kLargest = 8192;              // pixels
  const TableReader in(table, file);
  FieldLabels labels;
  const auto degrees_into = [&in](double& angle, double least, double most) {
    return [&in, &angle, least, most](const std::string& key, const toml::node& value) {
      angle = from_degrees(in.number(key, value, least, most));
    };
  };
  const auto text_into = [&in](std::string& text) {
    return [&in, &text](const std::string& key, const toml::node& value) { text = in.text(key, value); };
  };
  in.read_all(
      {{"name", text_into(labels.name)},
       {"digest", text_into(labels.digest)},
       {"width", [&](const std::string& key,
                     const toml::node& value) { labels.width = static_cast<int>(in.whole(key, value, 2, kLargest)); }},
       {"field_of_view", degrees_into(labels.field_of_view, 10.0, kWidest)},
       {"pitch", degrees_into(labels.pitch, -kSteepest, kSteepest)}},
      {{"roll", degrees_into(labels.roll, -kSteepest, kSteepest)},
       {"raw", [&](const std::string& key, const toml::node& value) { labels.raw = raw_format_of(in, key, value); }},
       {"lines", into(in, labels.lines, 2)},
       {"posts", each(in,
                      [&](const std::string& key, const toml::node& value) {
                        const LabeledPixels ends =
                            pixels_of(in.numbers("each of " + key, value, 4, -kFarthest, kFarthest));
                        labels.posts.push_back({ends[0], ends[1]});
                      })},
       {"balls", each(in,
                      [&](const std::string& key, const toml::node& value) {
                        const std::vector<double> ball = in.numbers("each of " + key, value, 3, -kFarthest, kFarthest);
                        if (ball[2] <= 0.0)
                          in.refuse(value, "each of balls: expected [u, v, radius]" + found_text(value));
                        labels.balls.push_back({{ball[0], ball[1]}, ball[2]});
                      })},
       {"feet", into(in, labels.feet, 3)},
       {"boards", into(in, labels.boards, 3)},
       {"marks", into(in, labels.marks, 3)},
       {"ignored", into(in, labels.ignored, 3)}});
  return labels;
}

}  // namespace

std::string digest_of(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.hex();
}

std::vector<FieldLabels> parse_field_labels(std::string_view text, const std::string& name) {
  const toml::table table = parse_table(text, name);
  const TableReader in(table, name);
  std::vector<FieldLabels> all;
  std::set<std::string> digests;
  in.read_all({{"images", [&](const std::string& key, const toml::node& value) {
                  for (const toml::node& one : in.tables(key, value)) {
                    all.push_back(labels_in(*one.as_table(), name));
                    if (!digests.insert(all.back().digest).second)
                      in.refuse(one, "expected different digests, found '" + all.back().digest + "' twice");
                  }
                }}});
  return all;
}

std::vector<FieldLabels> load_field_labels(const std::filesystem::path& file) {
  return parse_field_labels(read_data_file(file, "labels", "assets/labels"), file.string());
}

const FieldLabels* labels_of(std::span<const FieldLabels> all, const std::string& digest) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const FieldLabels& one) { return one.digest == digest; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace reorient
