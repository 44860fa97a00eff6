// SPDX-License-Identifier: MIT
// For inputs that are texts of lines: half of the mutations remove, repeat or swap whole lines. A text that is still
// well-formed reaches more code than one that the parser refuses.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned int seed) {
  std::minstd_rand random(seed);
  if (random() % 2 == 0) return LLVMFuzzerMutate(data, size, longest);
  std::vector<std::string> lines;
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  for (std::string line; std::getline(text, line);) lines.push_back(line + "\n");
  if (lines.size() < 2) return LLVMFuzzerMutate(data, size, longest);
  const std::size_t one = random() % lines.size();
  const std::size_t other = random() % lines.size();
  const auto place = [&lines](std::size_t index) { return lines.begin() + static_cast<std::ptrdiff_t>(index); };
  switch (random() % 3) {
    case 0:
      lines.erase(place(one));
      break;
    case 1:
      lines.insert(place(one), std::string(lines[other]));
      break;
    default:
      std::swap(lines[one], lines[other]);
  }
  std::string result;
  for (const std::string& line : lines) result += line;
  result.resize(std::min(result.size(), longest));
  std::copy(result.begin(), result.end(), data);
  return result.size();
}
