#pragma once
// Evaluations of a search, in memory and on disk, a line each, so that a killed one goes on from there with the same
// result.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "workbench/host/journal_file.hpp"

namespace mbgen {

/// Hashes of the contents of files, for the description of a search. Fails: UserError.
std::vector<std::string> hashes_of_files(const std::vector<std::string>& files);

/// Results by the text of their arguments. The method asks for the same arguments in the same order whenever it starts
/// from the same data, and gets what the first run computed, bit by bit.
class EvaluationJournal {
 public:
  /// Opens or creates a journal; path "": in memory alone. command: "fit"; description: of the search, one line.
  /// restart: discards its lines. Fails: UserError for a journal of another search, one that another process holds, or
  /// that cannot be written.
  EvaluationJournal(const std::filesystem::path& path, const std::string& command, const std::string& description,
                    bool restart);

  /// Number of evaluations that the file held when it was opened.
  long known() const { return known_; }
  /// The result of these arguments, null if it is not known.
  const std::vector<double>* find(const std::string& arguments) const;
  /// Keeps a result, and syncs it to disk. Fails: UserError.
  void add(const std::string& arguments, const std::vector<double>& numbers);

 private:
  void read(const std::string& text, const std::string& command, const std::string& description);
  std::filesystem::path path_;
  std::optional<JournalFile> file_;
  long known_ = 0;
  std::map<std::string, std::vector<double>> lines_;
};

}  // namespace mbgen
