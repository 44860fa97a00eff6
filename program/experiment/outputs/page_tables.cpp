// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/page_tables.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <vector>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view kBegin = "<!-- rows ";
constexpr std::string_view kEnd = "<!-- end of rows -->";

/// The contents of a comment.
struct TableWish {
  std::string file;
  std::vector<std::string> columns;
  std::map<std::string, std::vector<std::string>> only;  ///< keys of a row, with the values that it may have there
};

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    if (std::string part = trimmed(text.substr(0, end)); !part.empty()) parts.push_back(std::move(part));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

TableWish wish_of(std::string_view comment) {
  constexpr std::string_view kClose = "-->";
  if (!comment.ends_with(kClose)) throw std::runtime_error("expected --> at the end of the line, found none");
  comment = comment.substr(kBegin.size(), comment.size() - kBegin.size() - kClose.size());
  const std::size_t colon = comment.find(':');
  const auto fail = [&] { throw std::runtime_error("expected FILE.json: COLUMNS, found '" + trimmed(comment) + "'"); };
  if (colon == std::string_view::npos) fail();
  TableWish wish;
  wish.file = trimmed(comment.substr(0, colon));
  const std::vector<std::string> parts = split(comment.substr(colon + 1), '|');
  for (const std::string& part : parts) {
    for (const std::string& one : split(part, ',')) {
      const std::size_t equals = one.find('=');
      if (equals == std::string::npos) {
        wish.columns.push_back(one);
      } else {
        wish.only[trimmed(one.substr(0, equals))].push_back(trimmed(one.substr(equals + 1)));
      }
    }
  }
  if (wish.file.empty() || wish.columns.empty()) fail();
  return wish;
}

ordered_json parsed(const std::string& text, const std::string& file) {
  ordered_json json = ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) throw std::runtime_error(file + ": expected JSON, found invalid or truncated text");
  return json;
}

const ordered_json& value_of(const ordered_json& row, const std::string& key) {
  const auto found = row.find(key);
  if (found != row.end()) return *found;
  std::vector<std::string> keys;
  for (const auto& [name, value] : row.items()) keys.push_back(name);
  throw std::runtime_error("unknown key '" + key + "'" + did_you_mean(key, keys));
}

bool is_share(const std::string& key) {
  constexpr std::string_view kShares[] = {"failed",           "flip",     "purge",    "reset", "uninformative",
                                          "displaced_failed", "mirrored", "within_95"};
  return key.starts_with("eer_") || key.starts_with("silent_") ||
         std::find(std::begin(kShares), std::end(kShares), key) != std::end(kShares);
}

std::string number_text(const std::string& key, const ordered_json& value, const char* nothing = "–") {
  if (value.is_null()) return nothing;
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return std::to_string(value.get<std::int64_t>());
  if (!value.is_number())
    throw std::runtime_error("'" + key + "': expected a number or a text, found " + value.type_name());
  if (is_share(key)) return fmt::format("{:.1f} %", 100.0 * value.get<double>());
  if (key.starts_with("auc_") || key.ends_with("_m")) return fmt::format("{:.3f}", value.get<double>());
  return fmt::format("{:.{}f}", value.get<double>(), key.ends_with("_s") || key.ends_with("_mean_low") ? 1 : 2);
}

/// One cell; rates and means have their intervals.
std::string cell_of(const ordered_json& row, const std::string& key) {
  if (key == "false_flips_per_hour") {
    return number_text(key, value_of(row, key + "_low")) + " to " +
           number_text(key, value_of(row, key + "_high"), "any number");
  }
  std::string text = number_text(key, value_of(row, key));
  const ordered_json nothing;
  const std::string low = key == "right_mean_s" ? "right_mean_low" : key + "_low";
  const std::string high = key == "right_mean_s" ? "right_mean_high" : key + "_high";
  if (!row.contains(low) || !row.contains(high) || row[low].is_null() || row[high].is_null()) return text;
  return text + " (" + number_text(key, row[low]) + " to " + number_text(key, row[high]) + ")";
}

/// "mean_s" as "mean, s", "rmse_m" as "rmse, m".
std::string title_of(std::string key) {
  if (key.ends_with("_s") || key.ends_with("_m")) key = key.substr(0, key.size() - 2) + ", " + key.back();
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

/// A bar or a line break would end the cell.
std::string in_cell(const std::string& text) {
  std::string cell;
  for (const char letter : as_line(text)) cell += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return cell;
}

std::string table_of(const TableWish& wish, const ordered_json& rows) {
  if (!rows.is_array()) throw std::runtime_error(wish.file + ": expected a list of rows, found " + rows.type_name());
  std::string head = "|", line = "|", body;
  for (const std::string& column : wish.columns) {
    head += " " + in_cell(title_of(column)) + " |";
    line += "---|";
  }
  for (const ordered_json& row : rows) {
    if (!row.is_object()) throw std::runtime_error(wish.file + ": expected objects as rows, found " + row.type_name());
    const bool is_wanted = std::all_of(wish.only.begin(), wish.only.end(), [&row](const auto& only) {
      const auto& [key, values] = only;
      return std::find(values.begin(), values.end(), number_text(key, value_of(row, key))) != values.end();
    });
    if (!is_wanted) continue;
    body += "|";
    for (const std::string& column : wish.columns) body += " " + in_cell(cell_of(row, column)) + " |";
    body += "\n";
  }
  if (body.empty()) throw std::runtime_error(wish.file + ": expected rows with the required values, found none");
  return head + "\n" + line + "\n" + body;
}

/// One line with the command and circumstances of the results.
std::string origin_of(const std::string& text, const std::string& file) {
  if (text.empty()) return {};
  const ordered_json run = parsed(text, file);
  if (!run.is_object()) throw std::runtime_error(file + ": expected an object, found " + run.type_name());
  std::string line = "\n";
  for (const char* key : {"command", "commit", "seeds", "machine", "when"}) {
    const std::string value = as_line(number_text(key, value_of(run, key)));
    line += line.size() > 1 ? "; " : "";
    line += std::string_view(key) == "command" ? "`" + value + "`" : key + (" " + value);
  }
  return line + "\n";
}

/// A line of a page with its line ending: \n, \r\n, or nothing at the end of the file.
struct PageLine {
  std::string_view text, end;
};

PageLine take_line(std::string_view& rest) {
  const std::string_view line = rest.substr(0, std::min(rest.size(), rest.find('\n')) + 1);
  rest.remove_prefix(line.size());
  const std::size_t length = line.find_last_not_of("\r\n") + 1;  // 0 for an empty line
  return {line.substr(0, length), line.substr(length)};
}

/// Whether a line of Markdown is in a fenced code block, or begins or ends one: comments there are examples.
class CodeBlocks {
 public:
  bool contains(std::string_view line) {
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    line.remove_prefix(indent);
    const char mark = line.empty() ? char{} : line.front();
    const std::size_t count = mark == '`' || mark == '~' ? std::min(line.find_first_not_of(mark), line.size()) : 0;
    const bool is_fence = indent <= 3 && count >= 3;
    if (count_ == 0) {
      if (is_fence && (mark == '~' || line.find('`', count) == std::string_view::npos)) mark_ = mark, count_ = count;
      return count_ > 0;
    }
    if (is_fence && mark == mark_ && count >= count_ && trimmed(line.substr(count)).empty()) count_ = 0;
    return true;
  }

 private:
  char mark_ = 0;
  std::size_t count_ = 0;  // marks of the open fence; 0: none
};

std::string with_line_ends(const std::string& text, std::string_view end) {
  std::string ended;
  for (const char letter : text) ended += letter == '\n' ? end : std::string_view(&letter, 1);
  return ended;
}

}  // namespace

bool has_tables(std::string_view page) {
  CodeBlocks code;
  while (!page.empty()) {
    const std::string_view line = take_line(page).text;
    if (!code.contains(line) && line.starts_with(kBegin)) return true;
  }
  return false;
}

std::string with_tables(std::string_view page,
                        const std::function<std::string(const std::filesystem::path& file)>& read) {
  std::string made;
  int open = 0;  // line of the comment that began the table; 0: no table
  int number = 0;
  CodeBlocks code;
  while (!page.empty()) {
    const auto [line, line_end] = take_line(page);
    ++number;
    if (open == 0 && code.contains(line)) {
      made.append(line).append(line_end);
      continue;
    }
    if (line == kEnd) {
      if (open == 0)
        throw std::runtime_error(
            fmt::format("line {}: expected {}... --> before this comment, found none", number, kBegin));
      open = 0;
    } else if (open > 0 && !line.starts_with(kBegin)) {
      continue;  // the old table
    }
    made.append(line).append(line_end);
    if (!line.starts_with(kBegin)) continue;
    if (open > 0)
      throw std::runtime_error(
          fmt::format("line {}: expected {} for the rows of line {}, found other rows", number, kEnd, open));
    open = number;
    try {
      const TableWish wish = wish_of(line);
      const std::filesystem::path file = wish.file;
      const std::filesystem::path run = std::filesystem::path(file).replace_extension(".run.json");
      const std::string table = table_of(wish, parsed(read(file), wish.file)) + origin_of(read(run), run.string());
      made += with_line_ends(table, line_end);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("line {}: {}", number, error.what()));
    }
  }
  if (open > 0) throw std::runtime_error(fmt::format("line {}: expected {} after these rows, found none", open, kEnd));
  return made;
}

}  // namespace reorient
