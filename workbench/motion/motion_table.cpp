#include "workbench/motion/motion_table.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "compiler/text/number.hpp"
#include "compiler/text/user_error.hpp"
#include "workbench/motion/simulation_text.hpp"

namespace mbgen {
namespace {

/// The header of a CSV file, with a line end.
std::string csv_header(const std::vector<Column>& columns) {
  std::string line;
  for (const Column& column : columns) {
    if (!line.empty()) line += ',';
    line += csv_field(heading_text(column.heading));
  }
  return line + "\n";
}

/// Numbers in the shortest form that reads back the same, with a line end.
std::string csv_row(const std::vector<double>& values) {
  std::string line;
  for (const double value : values) fmt::format_to(std::back_inserter(line), "{}{}", line.empty() ? "" : ",", value);
  return line + "\n";
}

}  // namespace

TableFormat table_format(const std::string& name, const std::string& file) {
  if (name.empty()) return file.ends_with(".mat") ? TableFormat::mat : TableFormat::csv;
  if (name == "mat") return TableFormat::mat;
  if (name != "csv") throw UserError(fmt::format("--format: no format \"{}\"; there are: csv, mat\n", name));
  return TableFormat::csv;
}

std::string run_file(const std::string& table) { return table + ".run.json"; }

MotionTable::MotionTable(const std::string& path, TableFormat format, const Compilation& compilation, double step,
                         long every, std::vector<std::string> read, const std::vector<Heading>& more)
    : path_(path),
      read_(std::move(read)),
      format_(format),
      file_(path, read_),
      decimals_(decimals_of(step)),
      every_(every) {
  if (format_ == TableFormat::csv && !is_special(path_)) require_other_file(run_file(path_), read_);
  for (Heading& heading : headings(compilation)) results_.columns.push_back({std::move(heading), {}});
  for (const Heading& heading : more) results_.columns.push_back({heading, {}});
  if (format_ == TableFormat::csv) file_.write(csv_header(results_.columns));
}

void MotionTable::add(const Sample& sample, const std::vector<double>& more) {
  is_written_ = sample.step % every_ == 0;
  if (is_written_) {
    write(sample, more);
  } else {
    last_ = sample;
    last_more_ = more;
  }
}

long MotionTable::finish() {
  if (!is_written_) write(last_, last_more_);
  is_written_ = true;
  return rows_;
}

void MotionTable::commit(const std::string& run) {
  if (format_ == TableFormat::mat) {
    results_.run = run;
    file_.write(mat_text(results_));
  }
  const bool stands_alone = format_ == TableFormat::mat || is_special(path_);
  file_.commit();
  if (stands_alone) return;
  write_file(run_file(path_), run, read_);
}

void MotionTable::write(const Sample& sample, const std::vector<double>& more) {
  std::vector<double> row = table_row(sample, decimals_);
  row.insert(row.end(), more.begin(), more.end());
  if (format_ == TableFormat::csv) file_.write(csv_row(row));
  if (format_ == TableFormat::mat) {
    for (std::size_t c = 0; c < row.size(); ++c) results_.columns[c].values.push_back(row[c]);
  }
  ++rows_;
}

}  // namespace mbgen
