#include "workbench/describe/paragraphs.hpp"

#include <fmt/format.h>

#include <sstream>

namespace mbgen {
namespace {

constexpr std::size_t kExplanationWidth = 100;

}  // namespace

std::string paragraph(const std::string& words, const std::string& margin) {
  std::istringstream stream(words);
  std::string text, line = margin, word;
  while (stream >> word) {
    if (line.size() > margin.size() && line.size() + 1 + word.size() > kExplanationWidth) {
      text += line + "\n";
      line = margin;
    }
    line += (line.size() > margin.size() ? " " : "") + word;
  }
  return text + line + "\n";
}

std::string heading(const std::string& title) { return "\n" + title + "\n" + std::string(title.size(), '-') + "\n"; }

std::string counted(long count, const std::string& one, std::string several) {
  if (several.empty()) several = one + "s";
  return fmt::format("{} {}", count == 0 ? "no" : std::to_string(count), count == 1 ? one : several);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

}  // namespace mbgen
