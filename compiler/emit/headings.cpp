#include "compiler/emit/headings.hpp"

#include "compiler/emit/program_text.hpp"
#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Values of a section that come back to it for less than this have no heading of their own.
constexpr std::size_t kShortestRun = 12;

/// The first number in a section's title, as in "step 3: Rz", "" for none.
std::string step_number(const std::string& title) {
  constexpr const char* kDigits = "0123456789";
  const std::size_t first = title.find_first_of(kDigits);
  return first == std::string::npos ? "" : title.substr(first, title.find_first_not_of(kDigits, first) - first);
}

}  // namespace

Headings::Headings(const Program& program, const Schedule& schedule)
    : program_(program),
      schedule_(schedule),
      counts_(count_operations_by_section(program)),
      end_(program.sections.size(), 0) {
  for (std::size_t i = 0; i < schedule.order.size(); ++i) end_[static_cast<std::size_t>(section_of(i))] = i;
}

void Headings::start_part() { section_ = block_ = -1; }

bool Headings::is_worth_heading(std::size_t i) const {
  const int section = section_of(i);
  const std::size_t last = i + kShortestRun;
  while (i < last && i < schedule_.order.size() && section_of(i) == section) ++i;
  return i == last;
}

void Headings::write_before(std::size_t i, bool in_call, PartText& part) {
  const Node& node = node_at(i);
  if (section_ != node.section) {
    const std::string& title = program_.sections[node.section];
    if (section_ >= 0 && entered_.count(node.section) > 0 && !is_worth_heading(i)) return;
    const bool again = !entered_.insert(node.section).second;
    part.sections.push_back(title);
    if (section_ >= 0) part.body += "\n";
    if (!title.empty()) add_comment(part, "--- " + comment_text(title) + (again ? ", continued" : "") + " ---");
    section_ = node.section;
    block_ = -1;
  }
  if (block_ == node.block || in_call) return;
  const std::string& title = program_.blocks[node.block];
  if (!title.empty()) add_comment(part, comment_text(title));
  block_ = node.block;
}

void Headings::write_before_loop(const ScheduledUnit& loop, PartText& part) {
  write_before(loop.first, false, part);
  const int last = node_at(loop.last() - loop.period).block;
  if (last != node_at(loop.first).block) add_comment(part, "to " + comment_text(program_.blocks[last]));
}

void Headings::write_after(std::size_t first, std::size_t last, PartText& part) const {
  for (std::size_t s = 0; s < end_.size(); ++s)
    if (end_[s] >= first && end_[s] < last && entered_.count(static_cast<int>(s)) > 0 && !program_.sections[s].empty())
      add_comment(part, "operations: " + operations_text(counts_[s]));
}

std::string Headings::ended_step(std::size_t end) const {
  return section_ >= 0 && end_[section_] + 1 == end ? step_number(program_.sections[section_]) : "";
}

}  // namespace mbgen
