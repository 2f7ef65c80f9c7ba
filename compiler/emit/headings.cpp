#include "compiler/emit/headings.hpp"

#include "compiler/emit/text.hpp"

namespace mbgen {
namespace {

/// Least length of a run of values that returns to a section, or to an owner in a mixed order, for a heading; and of a
/// run of an owner in an order by section.
constexpr std::size_t kShortestRun = 12, kShortestSortedRun = 3;

/// The same of an owner in a text for people.
constexpr std::size_t kShortestReadRun = 1;

std::size_t shortest_run(ValueOrder order) {
  return order == ValueOrder::fewest_alive ? kShortestRun
         : order == ValueOrder::reading    ? kShortestReadRun
                                           : kShortestSortedRun;
}

/// "12 add, 20 multiply, 1 divide": the kinds of operation that occur, "none" when none does.
std::string operations_text(const OperationCount& count) {
  const std::pair<long, const char*> kinds[] = {
      {count.add, "add"},   {count.multiply, "multiply"},     {count.divide, "divide"},
      {count.sqrt, "sqrt"}, {count.trigonometric, "sin cos"}, {count.other, "other"}};
  std::string text;
  for (const auto& [number, kind] : kinds) {
    if (number > 0) text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + kind;
  }
  return text.empty() ? "none" : text;
}

}  // namespace

Headings::Headings(const Program& program, const Schedule& schedule, const Titles& titles)
    : program_(program), schedule_(schedule), titles_(titles), counts_(count_operations_by_section(program)) {
  for (std::size_t i = 0; i < schedule.order.size(); ++i) end_[section_of(i)] = i;
  for (const auto& [section, end] : end_) ends_.insert(end);
}

void Headings::start_part() {
  section_.reset();
  owner_.reset();
}

bool Headings::goes_on(std::size_t i, std::size_t length, bool with_owner) const {
  const Node& first = node_at(i);
  for (std::size_t k = i; k < i + length; ++k)
    if (k >= schedule_.order.size() || section_of(k) != first.section ||
        (with_owner && (node_at(k).owner != first.owner || node_at(k).mirrored != first.mirrored)))
      return false;
  return true;
}

void Headings::write_section(const Node& node, PartText& part) {
  const std::string title = titles_.section(node.section);
  const bool again = !entered_.insert(node.section).second;
  const bool is_known = std::ranges::find(part.sections, title) != part.sections.end();
  if (!title.empty() && !is_known) part.sections.push_back(title);
  if (section_) part.body += "\n";
  if (!title.empty()) add_comment(part, "--- " + comment_text(title) + (again ? ", continued" : "") + " ---");
  section_ = node.section;
  owner_.reset();
}

void Headings::write_before(std::size_t i, bool has_owner, PartText& part) {
  const Node& node = node_at(i);
  const bool is_known = section_ && entered_.contains(node.section);
  if (section_ != node.section && (!is_known || goes_on(i, kShortestRun, false))) write_section(node, part);
  const bool is_worth_it = node.label >= 0 || goes_on(i, shortest_run(schedule_.ordered), true);
  const Owners owners{node.owner, node.mirrored};
  if (owner_ == owners || !has_owner || !is_worth_it) return;
  std::string title = titles_.owner(node.owner);
  if (node.mirrored != Owner{} && node.mirrored != node.owner)
    title += "; and likewise " + titles_.owner(node.mirrored);
  // People would read on under the heading of the part before.
  if (title.empty() && owner_ && schedule_.ordered == ValueOrder::reading) title = "of no single part";
  if (!title.empty()) add_comment(part, comment_text(title));
  owner_ = owners;
}

void Headings::write_before_loop(const ScheduledUnit& loop, PartText& part) {
  write_before(loop.first, true, part);
  const Owner& last = node_at(loop.last() - loop.period).owner;
  if (last != node_at(loop.first).owner) add_comment(part, "to " + comment_text(titles_.owner(last)));
}

void Headings::write_after(std::size_t first, std::size_t last, PartText& part) const {
  const bool is_sorted = schedule_.ordered != ValueOrder::fewest_alive;
  if (!is_sorted && last < schedule_.order.size()) return;
  const auto end_from_first = ends_.lower_bound(first);
  if (is_sorted && (end_from_first == ends_.end() || *end_from_first >= last)) return;
  for (std::size_t s = 0; s < counts_.size(); ++s) {
    const Section& section = program_.sections[s];
    if (section.step == Step::none || !end_.contains(section)) continue;
    const std::size_t end = end_.at(section);
    if (!is_sorted)
      add_comment(part, "operations of " + comment_text(titles_.section(section)) + ": " + operations_text(counts_[s]));
    else if (end >= first && end < last && entered_.contains(section))
      add_comment(part, "operations: " + operations_text(counts_[s]));
  }
}

std::optional<int> Headings::ended_step(std::size_t end) const {
  if (!section_ || section_->step == Step::none) return {};
  if (end < schedule_.order.size() && section_of(end) == *section_) return {};
  return number_of(section_->step);
}

}  // namespace mbgen
