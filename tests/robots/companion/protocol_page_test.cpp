// SPDX-License-Identifier: MIT
// Compares the tables of docs/companion.md with the header: they are generated from the header's text.
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "robots/companion/reorient_companion.h"
#include "tests/paths.h"

namespace reorient {
namespace {

const std::string kHeader = std::string(kSourceFolder) + "/robots/companion/reorient_companion.h";
const std::string kPage = std::string(kSourceFolder) + "/docs/companion.md";

std::string text_of_file(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

struct Kind {
  std::string name;  // its name on the page
  std::size_t size = 0;
};

Kind kind_of(const std::string& type) {
  const std::pair<const char*, Kind> kinds[] = {{"uint8_t", {"u8", 1}},
                                                {"uint16_t", {"u16", 2}},
                                                {"uint32_t", {"u32", 4}},
                                                {"int32_t", {"i32", 4}},
                                                {"uint64_t", {"u64", 8}},
                                                {"float", {"f32", 4}},
                                                {"double", {"f64", 8}},
                                                {"char", {"text", 1}},
                                                {"struct reorient_camera", {"camera", sizeof(reorient_camera)}},
                                                {"struct reorient_body", {"body", sizeof(reorient_body)}},
                                                {"struct reorient_field", {"field", sizeof(reorient_field)}},
                                                {"struct reorient_image", {"image", sizeof(reorient_image)}}};
  for (const auto& [known, kind] : kinds) {
    if (type == known) return kind;
  }
  ADD_FAILURE() << "unknown type in the header: " << type;
  return {"?", 1};
}

/// The table of one structure: offset, type, name, meaning.
std::string table_of(const std::string& header, const std::string& structure) {
  const std::size_t begin = header.find("struct " + structure + " {");
  const std::size_t end = header.find("\n};", begin);
  EXPECT_NE(begin, std::string::npos) << structure;
  std::string body = header.substr(begin, end - begin);
  body = body.substr(body.find('{') + 1);
  std::ostringstream table;
  table << "| byte | what | name | meaning |\n|---|---|---|---|\n";
  std::size_t offset = 0;
  // A declaration and the comment after it.
  const std::regex line(R"(((?:struct )?\w+)\s+([^;{}]+);\s*(?:/\*([\s\S]*?)\*/)?)");
  for (std::sregex_iterator one(body.begin(), body.end(), line), last; one != last; ++one) {
    const Kind kind = kind_of((*one)[1]);
    std::string meaning = std::regex_replace((*one)[3].str(), std::regex(R"(\s+)"), " ");
    meaning = std::regex_replace(meaning, std::regex(R"(^ | $)"), "");
    std::stringstream names((*one)[2].str());
    for (std::string name; std::getline(names, name, ',');) {
      std::smatch parts;
      std::regex_search(name, parts, std::regex(R"((\w+)(?:\[(\w+)\])?)"));
      const std::string count_text = parts[2] == "REORIENT_LONGEST_TEXT"       ? "240"
                                     : parts[2] == "REORIENT_LONGEST_DATAGRAM" ? "256"
                                                                               : parts[2].str();
      const std::size_t count = count_text.empty() ? 1 : std::stoul(count_text);
      table << "| " << offset << " | " << (count > 1 ? std::to_string(count) + " x " : "") << kind.name << " | `"
            << parts[1].str() << "` | " << meaning << " |\n";
      offset += count * kind.size;
    }
  }
  table << "\nTogether " << offset << " bytes.\n";
  return table.str();
}

TEST(ProtocolPage, MatchesTheHeaderByteForByte) {
  const std::string header = text_of_file(kHeader);
  std::string page = text_of_file(kPage);
  const std::regex block(R"(<!-- struct (\w+) -->\n([\s\S]*?)<!-- end of struct -->)");
  std::string made;
  std::size_t from = 0;
  int tables = 0;
  for (std::sregex_iterator one(page.begin(), page.end(), block), last; one != last; ++one, ++tables) {
    made += page.substr(from, static_cast<std::size_t>(one->position()) - from);
    made += "<!-- struct " + (*one)[1].str() + " -->\n" + table_of(header, (*one)[1]) + "<!-- end of struct -->";
    from = static_cast<std::size_t>(one->position() + one->length());
  }
  made += page.substr(from);
  EXPECT_EQ(tables, 24) << "each structure has a table";
  if (std::getenv("REORIENT_REGENERATE") != nullptr) std::ofstream(kPage) << made;
  EXPECT_EQ(made, std::getenv("REORIENT_REGENERATE") != nullptr ? made : page)
      << "REORIENT_REGENERATE=1 generates the tables";
}

TEST(ProtocolPage, HasTheSizesOfTheCompiledHeader) {
  const std::string page = text_of_file(kPage);
  const std::pair<const char*, std::size_t> sizes[] = {
      {"reorient_hello", sizeof(reorient_hello)},   {"reorient_frame", sizeof(reorient_frame)},
      {"reorient_answer", sizeof(reorient_answer)}, {"reorient_camera", sizeof(reorient_camera)},
      {"reorient_body", sizeof(reorient_body)},     {"reorient_sample", sizeof(reorient_sample)},
      {"reorient_lens", sizeof(reorient_lens)},     {"reorient_percept", sizeof(reorient_percept)}};
  for (const auto& [name, size] : sizes) {
    const std::size_t table = page.find("<!-- struct " + std::string(name) + " -->");
    ASSERT_NE(table, std::string::npos) << name;
    const std::size_t sum = page.find("Together ", table);
    EXPECT_EQ(page.substr(sum, page.find('\n', sum) - sum), "Together " + std::to_string(size) + " bytes.") << name;
  }
}

}  // namespace
}  // namespace reorient
