#include "workbench/fit/fit_journal.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "compiler/text/characters.hpp"
#include "compiler/text/user_error.hpp"

namespace mbgen::fit {
namespace {

// Format of a journal: this line with a description appended, then one line per evaluation: hash of the rest of the
// line, arguments, a bar, numbers.
constexpr std::string_view kFirstLine = "mbgen fit journal 1 ", kAnyJournal = "mbgen fit journal ";

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  const char *place = text.data(), *end = text.data() + text.size();
  while (place < end) {
    double value = 0;
    const auto [next, error] = std::from_chars(place, end, value);
    if (error != std::errc()) return {};
    numbers.push_back(value);
    place = next + 1;
  }
  return numbers;
}

}  // namespace

FitJournal::FitJournal(const std::filesystem::path& path, const std::string& description, bool restart)
    : path_(path), file_(path, "fit", restart) {
  read(file_.kept(), description);
  file_.begin(fmt::format("{}{}", kFirstLine, description));
}

void FitJournal::read(const std::string& text, const std::string& description) {
  if (text.empty()) return;
  const std::size_t end = text.find('\n');
  const std::string first = text.substr(0, end);
  if (!first.starts_with(kAnyJournal))
    throw UserError(fmt::format("{}: is not a journal of mbgen fit; choose another --out\n", path_.string()));
  if (first != fmt::format("{}{}", kFirstLine, description))
    throw UserError(
        fmt::format("{}: belongs to another fit: its model, data or options differ\n  hint: run with the "
                    "words of before to go on with it, with --restart to begin anew, or with another "
                    "--out\n",
                    path_.string()));
  for (const std::string& line : split_at(std::string_view(text).substr(end + 1), '\n')) {
    const std::optional<std::string> content = content_of_line(line);
    const std::size_t bar = content ? content->find(" | ") : std::string::npos;
    if (bar != std::string::npos)
      lines_[content->substr(0, bar)] = numbers_in(std::string_view(*content).substr(bar + 3));
  }
  known_ = static_cast<long>(lines_.size());
}

const std::vector<double>* FitJournal::find(const std::string& arguments) const {
  const auto found = lines_.find(arguments);
  return found == lines_.end() ? nullptr : &found->second;
}

void FitJournal::add(const std::string& arguments, const std::vector<double>& numbers) {
  std::string content = arguments + " |";
  for (const double number : numbers) content += fmt::format(" {}", number);
  file_.append(journal_line(content));
  lines_[arguments] = numbers;
}

}  // namespace mbgen::fit
