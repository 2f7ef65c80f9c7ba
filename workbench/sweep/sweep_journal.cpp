#include "workbench/sweep/sweep_journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "compiler/text/user_error.hpp"
#include "workbench/host/files.hpp"

namespace mbgen {
namespace {

namespace fs = std::filesystem;

// Format of a journal: this line with a description appended, then one line per case: hash of the rest of the line,
// number of the case, values of the metrics, relative error of the energy, numbers of the manoeuvre as an array of
// [name, unit, value], status.
constexpr std::string_view kFirstLine = "mbgen sweep journal 3 ", kAnyJournal = "mbgen sweep journal ";

std::string line_of(long index, const CaseResult& result) {
  std::string content = fmt::format("{} {}", index, result.metrics.size());
  for (const double value : result.metrics) content += fmt::format(" {}", value);
  nlohmann::json numbers = nlohmann::json::array();
  for (const ManoeuvreResult& number : result.of_manoeuvre)
    numbers.push_back(nlohmann::json::array({number.name, number.unit, number.value}));
  content += fmt::format(" {} {} {}", result.energy_error, numbers.dump(), result.status);
  return journal_line(content);
}

/// Adds the case of a line; ignores a damaged line.
void read_line(const std::string& line, CaseResults& results) {
  const std::optional<std::string> content = content_of_line(line);
  if (!content) return;
  std::istringstream words(*content);
  long index = 0;
  std::size_t count = 0;
  words >> index >> count;
  CaseResult result;
  const auto number = [&words] {
    std::string word;
    double value = 0;
    words >> word;
    std::from_chars(word.data(), word.data() + word.size(), value);
    return value;
  };
  while (result.metrics.size() < count && words) result.metrics.push_back(number());
  result.energy_error = number();
  nlohmann::json numbers;
  words >> numbers;
  for (const nlohmann::json& one : numbers) result.of_manoeuvre.push_back({one[0], one[1], one[2]});
  words.get();
  std::getline(words, result.status);
  results[index] = std::move(result);
}

/// Names of the entries in which two descriptions differ.
std::vector<std::string> differences(const std::string& one, const std::string& other) {
  using Json = nlohmann::ordered_json;
  const Json a = Json::parse(one, nullptr, false), b = Json::parse(other, nullptr, false);
  std::vector<std::string> words;
  if (!a.is_object() || !b.is_object()) return {"everything"};
  for (const auto& [word, value] : b.items()) {
    if (!a.contains(word) || a[word] != value) words.push_back(word);
  }
  return words;
}

/// Checks that a journal's first line describes this study.
void check_first_line(const fs::path& path, const std::string& line, const std::string& description) {
  if (!line.starts_with(kAnyJournal)) {
    throw UserError(fmt::format("{}: is not a journal of mbgen sweep; choose another --out\n", path.string()));
  }
  const bool is_of_this_format = line.starts_with(kFirstLine);
  const std::string found = is_of_this_format ? line.substr(kFirstLine.size()) : "";
  if (is_of_this_format && found == description) return;
  throw UserError(fmt::format(
      "{}: holds cases of another study, they differ in: {}\n  hint: run the command as before to go on with it, "
      "with --restart to begin anew, or with another --out\n",
      path.string(),
      is_of_this_format ? fmt::format("{}", fmt::join(differences(found, description), ", ")) : "mbgen"));
}

CaseResults parse(const fs::path& path, const std::string& text, const std::string& description) {
  CaseResults results;
  std::istringstream lines(whole_lines(text));
  std::string line;
  if (!std::getline(lines, line)) return results;
  check_first_line(path, line, description);
  while (std::getline(lines, line)) read_line(line, results);
  return results;
}

}  // namespace

fs::path journal_path(const std::string& table, const SweepPart& part) {
  const std::string whole = table + ".journal";
  return part.count == 1 ? whole : fmt::format("{}.{}-of-{}", whole, part.index + 1, part.count);
}

std::vector<fs::path> journals_of(const std::string& table) {
  const fs::path whole = journal_path(table, {});
  const fs::path directory = whole.has_parent_path() ? whole.parent_path() : ".";
  std::vector<fs::path> paths;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(directory, problem)) {
    const std::string name = entry.path().filename().string(), first = whole.filename().string();
    if (name == first || (name.starts_with(first + ".") && name.find("-of-", first.size()) != std::string::npos)) {
      paths.push_back(whole.parent_path() / name);
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

CaseResults read_journal(const fs::path& path, const std::string& description) {
  std::error_code problem;
  if (!fs::exists(path, problem)) return {};
  return parse(path, read_text(path), description);
}

Journal::Journal(const fs::path& path, const std::string& description, bool restart) : file_(path, "sweep", restart) {
  parse(path, file_.kept(), description);
  file_.begin(fmt::format("{}{}", kFirstLine, description));
}

void Journal::add(long index, const CaseResult& result) { file_.append(line_of(index, result)); }

bool is_held(const fs::path& journal) {
  const int file = ::open(journal.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool is_locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return is_locked;
}

}  // namespace mbgen
