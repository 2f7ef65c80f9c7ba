#pragma once
// The table of a motion on its way to a file, and the file that identifies its run.

#include <string>
#include <vector>

#include "workbench/host/files.hpp"
#include "workbench/motion/simulation.hpp"
#include "workbench/results/results.hpp"

namespace mbgen {

enum class TableFormat { csv, mat };

/// Format by its name, else by the file's ending: .mat, or CSV. Fails: UserError for an unknown name.
TableFormat table_format(const std::string& name, const std::string& file);

/// Name of the file beside a CSV table with the text of run_json.
std::string run_file(const std::string& table);

/// Takes the points of a motion and writes every n-th of them, the first and the last. CSV is written row by row; MAT,
/// which starts with its size, is kept in memory until the end.
class MotionTable {
 public:
  /// step: of the motion, s; read: the files that the command reads. Fails: UserError, as AtomicFile.
  /// more: further columns.
  MotionTable(const std::string& path, TableFormat format, const Compilation& compilation, double step, long every,
              std::vector<std::string> read, const std::vector<Heading>& more = {});
  /// more: of the further columns.
  void add(const Sample& sample, const std::vector<double>& more = {});
  /// The last point is always written. Result: rows.
  long finish();
  /// Gives the file its name, and writes `run` into it (MAT) or beside it (CSV that is no device). Requires: finished.
  void commit(const std::string& run);

 private:
  void write(const Sample& sample, const std::vector<double>& more);
  std::string path_;
  std::vector<std::string> read_;
  TableFormat format_;
  AtomicFile file_;
  Results results_;  ///< the rows of a MAT file
  int decimals_;     ///< of the step
  long every_;
  long rows_ = 0;
  bool is_written_ = true;
  Sample last_;
  std::vector<double> last_more_;
};

}  // namespace mbgen
