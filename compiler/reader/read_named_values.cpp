// Expressions under a name, for use in several places.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/reader/formula.hpp"
#include "compiler/reader/raw.hpp"
#include "compiler/reader/read_states.hpp"

namespace mbgen::reading {
namespace {

/// Names in the text of an expression.
std::vector<std::string_view> words_in(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
    const bool is_part = at > 0 && text[at - 1] == '.';  // of z.NAME and out.NAME
    if (end > at && is_letter(text[at]) && !is_part) words.push_back(text.substr(at, end - at));
    at = std::max(end, at + 1);
  }
  return words;
}

/// Reads each value after the values in its text.
class NamedValues {
 public:
  NamedValues(Reader& reader, const Entries& entries)
      : reader_(reader), entries_(entries), states_(entries.size(), State::open), is_circular_(entries.size()) {
    for (std::size_t i = 0; i < entries.size(); ++i) places_.emplace(entries[i].name, i);
  }

  void read(std::size_t first) {
    if (states_[first] == State::open) begin(first);
    while (!path_.empty()) {
      Visit& visit = path_.back();
      if (visit.next == visit.used.size()) {
        finish(visit.value);
        path_.pop_back();
        continue;
      }
      const std::size_t used = visit.used[visit.next++];
      if (states_[used] == State::reading) {
        report_circle(visit.value, used);
      } else if (states_[used] == State::open) {
        begin(used);
      }
    }
  }

 private:
  enum class State { open, reading, done };
  /// A value, the values in its text, and the next of these to be read.
  struct Visit {
    std::size_t value;
    std::vector<std::size_t> used;
    std::size_t next = 0;
  };

  void begin(std::size_t i) {
    states_[i] = State::reading;
    path_.push_back({i, used_by(entries_[i])});
  }

  void finish(std::size_t i) {
    states_[i] = State::done;
    const InScope in_scope(reader_, entries_[i].scope);
    if (is_circular_[i]) return;
    check_value_name(reader_, entries_[i]);
    add(entries_[i]);
  }

  void report_circle(std::size_t i, std::size_t used) {
    const std::string name = in_quotes(entries_[i].written);
    report(reader_, *entries_[i].value,
           used == i ? fmt::format("value {} uses itself", name)
                     : fmt::format("values {} and {} use each other", name, in_quotes(entries_[used].written)));
    if (!is_circular_[used]) define(entries_[used], entries_[used].written, Formula(1.0).nodes);  // so that it is known
    is_circular_[used] = true;
  }

  std::vector<std::size_t> used_by(const Entry& entry) const {
    std::vector<std::size_t> used;
    const InScope in_scope(reader_, entry.scope);
    for (const std::string_view word : words_in(entry.value->text)) {
      const auto found = find_visible(places_, word, current_scope(reader_).visible);
      if (found != places_.end()) used.push_back(found->second);
    }
    return used;
  }

  void add(const Entry& entry) {
    Quantity value;
    read_value(reader_, *entry.value, {.name = "value", .angle = true, .sees_accelerations = true}, value);
    if (value.expression < 0) {
      define(entry, entry.written, Formula(std::isnan(value.value) ? 1 : value.value).nodes);
    } else {
      reader_.names.named_values.emplace(entry.name, value.expression);
    }
  }

  void define(const Entry& entry, const std::string& text, const std::vector<ExpressionNode>& nodes) {
    reader_.names.named_values.emplace(entry.name, static_cast<int>(reader_.model.expressions.size()));
    reader_.model.expressions.push_back({text, nodes});
  }

  Reader& reader_;
  const Entries& entries_;
  std::vector<State> states_;
  std::vector<bool> is_circular_;
  std::vector<Visit> path_ = {};
  NameMap<std::size_t> places_;
};

}  // namespace

void read_named_values(Reader& reader, const Entries& entries) {
  NamedValues values(reader, entries);
  for (std::size_t i = 0; i < entries.size(); ++i) values.read(i);
}

}  // namespace mbgen::reading
