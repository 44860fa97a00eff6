// SPDX-License-Identifier: MIT
#include "robots/footage/frames_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <span>
#include <sstream>

#include "robots/footage/messages/bad_message.h"

namespace reorient {
namespace {

using messages::in_quotes;

constexpr double kFarthest = 1e4;            // m
constexpr double kHighest = 10.0;            // m: a height in centimeters is larger
constexpr double kMostTilted = 2.0 * kPi;    // rad
constexpr double kMostTurned = 20.0 * kPi;   // rad: may count full turns; degrees soon exceed it
constexpr double kMostOdometryTurned = 1e6;  // rad: may count turns for hours
constexpr std::size_t kMostRows = 10'000'000;
constexpr std::size_t kMostCells = 1000;

struct Unit {
  std::string_view name;
  double factor;
};
constexpr Unit kSeconds[] = {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
constexpr Unit kMeters[] = {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}};
constexpr Unit kAngles[] = {{"rad", 1.0}, {"deg", kPi / 180.0}};

/// A column, in the order of FrameColumn.
struct ColumnKind {
  std::string_view name;
  std::span<const Unit> units;
  double most;  // largest absolute value, in the first unit
};
constexpr double kLatest = 1e12;  // s
constexpr std::array<ColumnKind, kFrameColumns> kColumns{{{"time", kSeconds, kLatest},
                                                          {"x", kMeters, kFarthest},
                                                          {"y", kMeters, kFarthest},
                                                          {"rotation", kAngles, kMostTurned},
                                                          {"odometry_x", kMeters, kFarthest},
                                                          {"odometry_y", kMeters, kFarthest},
                                                          {"odometry_rotation", kAngles, kMostOdometryTurned},
                                                          {"camera_height", kMeters, kHighest},
                                                          {"roll", kAngles, kMostTilted},
                                                          {"pitch", kAngles, kMostTilted},
                                                          {"camera_yaw", kAngles, kMostTilted}}};
constexpr std::string_view kImage = "image";

std::string units_text(std::span<const Unit> units) {
  std::string text;
  for (const Unit& unit : units) text.append(text.empty() ? "" : ", ").append(unit.name);
  return text;
}

/// The cell of a column in each row, and the factor on its numbers.
struct Place {
  std::size_t cell = 0;
  double factor = 1.0;
  bool is_there = false;
};

class FramesParser {
 public:
  FramesParser(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  TableHeaders read_headers(const ColumnHeaders& headers) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // editors on Windows write it
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
    if (rest_.empty()) refuse("expected a line of column headers, found an empty file");
    separator_ = separator_of(rest_.substr(0, rest_.find('\n')));
    read_line();
    find_columns(headers);
    return table_headers(headers);
  }

  /// Call it after read_headers().
  std::vector<FrameRow> read_rows() {
    require_together({FrameColumn::x, FrameColumn::y, FrameColumn::rotation}, true);
    require_together({FrameColumn::odometry_x, FrameColumn::odometry_y, FrameColumn::odometry_rotation}, false);
    std::vector<FrameRow> rows;
    while (!rest_.empty()) {
      read_line();
      if (cells_.size() == 1 && cells_[0].empty()) continue;
      if (rows.size() >= kMostRows) refuse("expected at most " + std::to_string(kMostRows) + " rows, found more");
      FrameRow row = row_of_line();
      check_time(rows, row);
      rows.push_back(std::move(row));
    }
    if (rows.empty()) refuse("expected a row for each image, found none");
    return rows;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw BadFootage(name_ + ":" + std::to_string(line_) + ": " + why);
  }

  static char separator_of(std::string_view header) {
    char best = ',';
    for (const char candidate : {';', '\t'}) {
      if (std::count(header.begin(), header.end(), candidate) > std::count(header.begin(), header.end(), best))
        best = candidate;
    }
    return best;
  }

  /// Reads a line into cells_, with quotes as in RFC 4180.
  void read_line() {
    line_ = next_line_;
    cells_.assign(1, "");
    bool quoted = false;
    std::size_t at = 0;
    for (; at < rest_.size(); ++at) {
      const char letter = rest_[at];
      if (letter == '\n') ++next_line_;
      if (quoted) {
        if (letter != '"') {
          cells_.back() += letter;
        } else if (at + 1 < rest_.size() && rest_[at + 1] == '"') {
          cells_.back() += rest_[++at];
        } else {
          quoted = false;
        }
      } else if (letter == '"' && cells_.back().empty()) {
        quoted = true;
      } else if (letter == separator_) {
        if (cells_.size() >= kMostCells)
          refuse("expected at most " + std::to_string(kMostCells) + " cells, found more");
        cells_.emplace_back();
      } else if (letter == '\n') {
        break;
      } else if (letter != '\r') {
        cells_.back() += letter;
      }
    }
    if (quoted) refuse("expected the end of a text in quotes, found the end of the file");
    rest_.remove_prefix(std::min(rest_.size(), at + 1));
    for (std::string& cell : cells_) trim(cell);
  }

  static void trim(std::string& cell) {
    const auto is_blank = [](char letter) { return letter == ' ' || letter == '\t'; };
    while (!cell.empty() && is_blank(cell.back())) cell.pop_back();
    cell.erase(cell.begin(), std::find_if_not(cell.begin(), cell.end(), is_blank));
  }

  void find_columns(const ColumnHeaders& headers) {
    headers_ = cells_;
    for (const auto& [column, header] : headers) {
      if (!header.empty()) name_column(column, header);
    }
    for (std::size_t cell = 0; cell < headers_.size(); ++cell) {
      if (headers_[cell] == kImage && !headers.contains(std::string(kImage))) take_image(cell);
      for (std::size_t i = 0; i < kColumns.size(); ++i) {
        if (headers.contains(std::string(kColumns[i].name))) continue;
        for (const Unit& unit : kColumns[i].units) {
          if (headers_[cell] == std::string(kColumns[i].name) + "_" + std::string(unit.name))
            take(i, cell, unit.factor);
        }
      }
    }
  }

  /// Uses the header that the caller passed for a column.
  void name_column(const std::string& column, const std::string& header) {
    const std::size_t colon = header.rfind(':');
    const bool is_image = column == kImage;
    const std::string title = is_image ? header : header.substr(0, colon);
    const auto cell = static_cast<std::size_t>(std::find(headers_.begin(), headers_.end(), title) - headers_.begin());
    if (cell == headers_.size())
      refuse("expected a column " + in_quotes(title) + " for " + column + ", found " + headers_text());
    if (is_image) return take_image(cell);
    const auto kind =
        std::find_if(kColumns.begin(), kColumns.end(), [&](const auto& one) { return one.name == column; });
    if (kind == kColumns.end()) refuse("unknown column " + in_quotes(column) + " (expected " + names_text() + ")");
    const auto unit_called = [&](std::string_view name) {
      return std::find_if(kind->units.begin(), kind->units.end(), [&](const Unit& one) { return one.name == name; });
    };
    const std::size_t underscore = title.rfind('_');
    auto unit = underscore == std::string::npos ? kind->units.end() : unit_called(title.substr(underscore + 1));
    if (colon != std::string::npos) {
      const std::string_view given = std::string_view(header).substr(colon + 1);
      if (unit != kind->units.end() && unit->name != given)
        refuse(in_quotes(title) + ": expected the unit of its name, " + in_quotes(unit->name) + ", found " +
               in_quotes(given));
      unit = unit_called(given);
      if (unit == kind->units.end())
        refuse("expected a unit of " + column + " (" + units_text(kind->units) + "), found " + in_quotes(given));
    }
    take(static_cast<std::size_t>(kind - kColumns.begin()), cell,
         unit == kind->units.end() ? kind->units.front().factor : unit->factor);
  }

  /// A column that the caller excludes is not missing.
  TableHeaders table_headers(const ColumnHeaders& headers) const {
    TableHeaders table;
    for (std::size_t cell = 0; cell < headers_.size(); ++cell) {
      const auto is_here = [cell](const Place& place) { return place.is_there && place.cell == cell; };
      if (!is_here(image_) && std::none_of(places_.begin(), places_.end(), is_here))
        table.unused.push_back(headers_[cell]);
    }
    if (!image_.is_there && !headers.contains(std::string(kImage))) table.missing.emplace_back(kImage);
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      if (places_[i].is_there || headers.contains(std::string(kColumns[i].name))) continue;
      for (const Unit& unit : kColumns[i].units)
        table.missing.push_back(std::string(kColumns[i].name) + "_" + std::string(unit.name));
    }
    return table;
  }

  static std::string names_text() {
    std::string text{kImage};
    for (const ColumnKind& kind : kColumns) text.append(", ").append(kind.name);
    return text;
  }

  std::string headers_text() const {
    constexpr std::size_t kMost = 8;
    std::string text;
    for (std::size_t i = 0; i < std::min(headers_.size(), kMost); ++i)
      text.append(i == 0 ? "" : ", ").append(in_quotes(headers_[i]));
    return text + (headers_.size() > kMost ? ", ..." : "");
  }

  void take_image(std::size_t cell) {
    if (image_.is_there) refuse("expected one column with images, found two");
    image_ = {cell, 1.0, true};
  }

  void take(std::size_t column, std::size_t cell, double factor) {
    if (places_[column].is_there)
      refuse("expected one column for " + std::string(kColumns[column].name) + ", found two");
    places_[column] = {cell, factor, true};
  }

  bool has(FrameColumn column) const { return places_[static_cast<std::size_t>(column)].is_there; }

  /// `last_alone`: the rotation may be the only one of the three.
  void require_together(const std::array<FrameColumn, 3>& columns, bool last_alone) const {
    const bool x = has(columns[0]), y = has(columns[1]), rotation = has(columns[2]);
    if (x == y && (y == rotation || (last_alone && !x))) return;
    std::string names, missing;
    for (const FrameColumn column : columns) {
      const std::string_view name = kColumns[static_cast<std::size_t>(column)].name;
      names.append(names.empty() ? "" : ", ").append(name);
      if (!has(column) && missing.empty()) missing = name;
    }
    refuse("expected all of the columns " + names + ", or none of them, found " + headers_text() +
           "; if a column has another name, use --column " + missing + "=HEADER[:UNIT]");
  }

  FrameRow row_of_line() const {
    if (cells_.size() != headers_.size())
      refuse("expected " + std::to_string(headers_.size()) + " cells, found " + std::to_string(cells_.size()));
    FrameRow row;
    row.line = line_;
    row.values.fill(std::numeric_limits<double>::quiet_NaN());
    if (image_.is_there) row.image = cells_[image_.cell];
    if (image_.is_there && row.image.empty()) refuse("expected the name of an image, found an empty cell");
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      const Place& place = places_[i];
      if (!place.is_there || cells_[place.cell].empty()) continue;
      row.values[i] = number(cells_[place.cell], headers_[place.cell]) * place.factor;
      if (!(std::abs(row.values[i]) <= kColumns[i].most)) refuse_size(kColumns[i], place);
    }
    const auto is_whole = [&](FrameColumn x, FrameColumn y, FrameColumn rotation) {
      return row.value(x).has_value() == row.value(y).has_value() && (!row.value(x) || row.value(rotation).has_value());
    };
    if (!is_whole(FrameColumn::x, FrameColumn::y, FrameColumn::rotation) ||
        !is_whole(FrameColumn::odometry_x, FrameColumn::odometry_y, FrameColumn::odometry_rotation))
      refuse("expected x, y and rotation together, found an empty cell among them");
    return row;
  }

  [[noreturn]] void refuse_size(const ColumnKind& kind, const Place& place) const {
    std::ostringstream most;
    most << std::setprecision(3) << kind.most;
    refuse(in_quotes(headers_[place.cell]) + ": expected at most " + most.str() + " " +
           std::string(kind.units.front().name) + ", found " + in_quotes(cells_[place.cell]) +
           "; a header ends with the unit, as in " + std::string(kind.name) + "_" +
           std::string(kind.units[1].name));  // the most likely other unit
  }

  double number(std::string cell, const std::string& header) const {
    const std::string_view found = cell;
    if (found.find('.') == std::string_view::npos && std::count(found.begin(), found.end(), ',') == 1)
      cell[cell.find(',')] = '.';
    const char* const begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
    const char* const end = cell.data() + cell.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
      refuse(in_quotes(header) + ": expected a finite number, found " + in_quotes(cell));
    return value;
  }

  void check_time(const std::vector<FrameRow>& rows, const FrameRow& row) const {
    if (!has(FrameColumn::time)) return;
    const std::optional<double> time = row.value(FrameColumn::time);
    if (!time) refuse("expected a time, found an empty cell");
    if (rows.empty()) return;
    const double before = *rows.back().value(FrameColumn::time);
    if (!(*time > before))
      refuse("expected a time after that of line " + std::to_string(rows.back().line) + ", " + std::to_string(before) +
             " s, found " + std::to_string(*time) + " s");
  }

  std::string_view rest_;
  std::string name_;
  char separator_ = ',';
  int line_ = 1, next_line_ = 1;
  std::vector<std::string> cells_, headers_;
  Place image_;
  std::array<Place, kFrameColumns> places_;
};

}  // namespace

std::optional<Pose2> FrameRow::pose() const {
  const auto x = value(FrameColumn::x), y = value(FrameColumn::y), rotation = value(FrameColumn::rotation);
  return x && y && rotation ? std::optional(Pose2(*x, *y, *rotation)) : std::nullopt;
}

std::optional<Pose2> FrameRow::odometry() const {
  const auto x = value(FrameColumn::odometry_x), y = value(FrameColumn::odometry_y),
             rotation = value(FrameColumn::odometry_rotation);
  return x && y && rotation ? std::optional(Pose2(*x, *y, *rotation)) : std::nullopt;
}

std::optional<double> FrameRow::heading() const {
  return value(FrameColumn::x) ? std::nullopt : value(FrameColumn::rotation);
}

Isometry3 FrameRow::robot_from_camera(double usual_height) const {
  Isometry3 pose = Isometry3::Identity();
  pose.translation().z() = value(FrameColumn::camera_height).value_or(usual_height);
  pose.linear() = rotation_about_z(value(FrameColumn::camera_yaw).value_or(0.0)) *
                  rotation_about_y(value(FrameColumn::pitch).value_or(0.0)) *
                  rotation_about_x(value(FrameColumn::roll).value_or(0.0));
  return pose;
}

std::vector<std::string> frame_column_names() {
  std::vector<std::string> names{std::string(kImage)};
  for (const ColumnKind& kind : kColumns) names.emplace_back(kind.name);
  return names;
}

TableHeaders read_headers(std::string_view text, const std::string& name, const ColumnHeaders& headers) {
  return FramesParser(text, name).read_headers(headers);
}

std::vector<FrameRow> parse_frames(std::string_view text, const std::string& name, const ColumnHeaders& headers) {
  FramesParser parser(text, name);
  static_cast<void>(parser.read_headers(headers));
  return parser.read_rows();
}

}  // namespace reorient
