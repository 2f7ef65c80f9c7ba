#pragma once
// Headings of sections and owners in the text of a program, and the operation counts below sections.

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "compiler/emit/function_text.hpp"
#include "compiler/emit/shapes.hpp"
#include "compiler/schedule/schedule.hpp"

namespace mbgen {

/// Writes headings while the values of a program are written in order, part by part.
class Headings {
 public:
  Headings(const Program& program, const Schedule& schedule, const Titles& titles);

  void start_part();
  /// Writes the heading before the i-th value of the order. has_owner: false for a value of a call for many arguments,
  /// which belongs to all owners in its section, and for a value that is written only inside another expression.
  void write_before(std::size_t i, bool has_owner, PartText& part);
  /// Writes the heading before a loop: the heading of its first value, and the owner of its last slice.
  void write_before_loop(const ScheduledUnit& loop, PartText& part);
  /// Writes the text after the values from `first` to before `last`: the operations of sections that end there.
  void write_after(std::size_t first, std::size_t last, PartText& part) const;
  /// A loop has many owners: the heading of the next owner is written again.
  void leave_loop() { owner_.reset(); }
  /// Number of the step that ends with the part whose last value is before place `end`.
  std::optional<int> ended_step(std::size_t end) const;

 private:
  const Node& node_at(std::size_t i) const { return program_.nodes[schedule_.order[i]]; }
  const Section& section_of(std::size_t i) const { return node_at(i).section; }
  /// Whether the values from place `i` on remain in its section, and with its owner, for this length. Otherwise their
  /// names tell the step.
  bool goes_on(std::size_t i, std::size_t length, bool with_owner) const;
  void write_section(const Node& node, PartText& part);

  const Program& program_;
  const Schedule& schedule_;
  const Titles& titles_;
  std::vector<OperationCount> counts_;  ///< per section
  std::map<Section, std::size_t> end_;  ///< place of the last value of each section
  std::set<std::size_t> ends_;          ///< these places
  std::set<Section> entered_;           ///< sections with a heading so far
  std::optional<Section> section_;
  using Owners = std::pair<Owner, Owner>;  ///< of a value and of its second lane
  std::optional<Owners> owner_;
};

}  // namespace mbgen
