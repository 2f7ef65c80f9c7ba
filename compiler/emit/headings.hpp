#pragma once
// Headings of sections and blocks in the text of a program, and the operation counts below sections.

#include <set>
#include <string>
#include <vector>

#include "compiler/emit/arrangement.hpp"
#include "compiler/emit/function_text.hpp"
#include "compiler/emit/layout.hpp"

namespace mbgen {

/// Adds words as a comment of its own lines.
void add_comment(PartText& part, const std::string& words);

/// Writes headings while the values of a program are written in order, part by part.
class Headings {
 public:
  Headings(const Program& program, const Arrangement& arrangement);

  void start_part();
  /// Writes the heading before the i-th value of the order. in_call: of a call for many arguments, which belongs to all
  /// blocks of its section.
  void write_before(std::size_t i, bool in_call, PartText& part);
  /// Writes the text after it: the operations of a section that ends.
  void write_after(std::size_t i, PartText& part) const;
  /// Number of the step that ends with the part whose last value is before place `end`, "" for none.
  std::string ended_step(std::size_t end) const;

 private:
  int section_of(std::size_t i) const { return program_.nodes[arrangement_.order[i]].section; }
  /// True when more than a few values of a section follow from place `i` on. The names of the others tell their step.
  bool is_worth_heading(std::size_t i) const;

  const Program& program_;
  const Arrangement& arrangement_;
  std::vector<OperationCount> counts_;  ///< per section
  std::vector<std::size_t> end_;        ///< place of the last value of each section
  std::set<int> entered_;               ///< sections with a heading so far
  int section_ = -1, block_ = -1;
};

}  // namespace mbgen
