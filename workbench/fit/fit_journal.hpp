#pragma once
// Evaluations of a fit on disk, a line each, so that a killed fit goes on from there with the same result.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "workbench/fit/least_squares.hpp"
#include "workbench/host/journal_file.hpp"

namespace mbgen::fit {

/// Results by the text of their arguments. The method asks for the same arguments in the same order whenever it starts
/// from the same data, and gets what the first run computed, bit by bit.
class FitJournal {
 public:
  /// Opens or creates a journal; description: of the fit, one line. restart: discards its lines. Fails: UserError for a
  /// journal of another fit, one that another process holds, or that cannot be written.
  FitJournal(const std::filesystem::path& path, const std::string& description, bool restart);

  /// Number of evaluations that it held when it was opened.
  long known() const { return known_; }
  /// The result of these arguments, null if it is not known. Rows of the matrix are `columns` long.
  const std::vector<double>* find(const std::string& arguments) const;
  /// Writes a result and syncs it to disk. Fails: UserError.
  void add(const std::string& arguments, const std::vector<double>& numbers);

 private:
  void read(const std::string& text, const std::string& description);
  std::filesystem::path path_;
  JournalFile file_;
  long known_ = 0;
  std::map<std::string, std::vector<double>> lines_;
};

}  // namespace mbgen::fit
