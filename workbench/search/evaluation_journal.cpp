#include "workbench/search/evaluation_journal.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "compiler/text/characters.hpp"
#include "compiler/text/hash.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {
namespace {

// Format of a journal: this line with a description appended, then one line per evaluation: hash of the rest of the
// line, arguments, a bar, numbers.
std::string any_journal(const std::string& command) { return fmt::format("mbgen {} journal ", command); }

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

std::vector<std::string> hashes_of_files(const std::vector<std::string>& files) {
  std::vector<std::string> list;
  for (const std::string& file : files) {
    Hash hash;
    hash.add(read_text(file));
    list.push_back(hash.text());
  }
  return list;
}

EvaluationJournal::EvaluationJournal(const std::filesystem::path& path, const std::string& command,
                                     const std::string& description, bool restart)
    : path_(path) {
  if (path.empty()) return;
  file_.emplace(path, command, restart);
  read(file_->kept(), command, description);
  file_->begin(any_journal(command) + "1 " + description);
}

void EvaluationJournal::read(const std::string& text, const std::string& command, const std::string& description) {
  if (text.empty()) return;
  const std::size_t end = text.find('\n');
  const std::string first = text.substr(0, end);
  if (!first.starts_with(any_journal(command)))
    throw UserError(fmt::format("{}: is not a journal of mbgen {}; choose another --out\n", path_.string(), command));
  if (first != any_journal(command) + "1 " + description)
    throw UserError(
        fmt::format("{}: belongs to another run of mbgen {}: its model, data or options differ\n  hint: run the "
                    "command as before to go on with it, with --restart to begin anew, or with another "
                    "--out\n",
                    path_.string(), command));
  for (const std::string& line : split_at(std::string_view(text).substr(end + 1), '\n')) {
    const std::optional<std::string> content = content_of_line(line);
    const std::size_t bar = content ? content->find(" | ") : std::string::npos;
    if (bar != std::string::npos)
      lines_[content->substr(0, bar)] = numbers_in(std::string_view(*content).substr(bar + 3));
  }
  known_ = static_cast<long>(lines_.size());
}

const std::vector<double>* EvaluationJournal::find(const std::string& arguments) const {
  const auto found = lines_.find(arguments);
  return found == lines_.end() ? nullptr : &found->second;
}

void EvaluationJournal::add(const std::string& arguments, const std::vector<double>& numbers) {
  std::string content = arguments + " |";
  for (const double number : numbers) content += fmt::format(" {}", number);
  if (file_) file_->append(journal_line(content));
  lines_[arguments] = numbers;
}

}  // namespace mbgen
