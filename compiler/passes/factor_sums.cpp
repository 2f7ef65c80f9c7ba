#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/passes/passes.hpp"
#include "compiler/program/rounded.hpp"

namespace mbgen {
namespace {

bool is_sum(Op op) { return op == Op::add || op == Op::subtract || op == Op::negate; }

/// A signed term: one value, or the product of two.
struct Term {
  bool negative = false;
  ValueId first = kNoValue, second = kNoValue;  ///< of the rewritten program; second is kNoValue for a plain term
  bool is_product() const { return second != kNoValue; }
};

/// The order in which a sum takes its terms.
enum class TermOrder {
  as_known,     ///< the one that is known first comes first: they need not wait for each other
  largest_last  ///< the same but for the largest one: partial sums stay small, and so do their roundings
};

constexpr std::size_t kProbes = 2;
/// Times the bound of its roundings before: the most that a sum may have, at every probe.
constexpr double kMostOfSums = 2;

/// Rounding bounds at one ordinary state, of the original program and of its factored part.
struct SumProbe {
  RoundedValues before, now;
};

class SumWriter {
 public:
  explicit SumWriter(const Program& program)
      : program_(program),
        builder_(ProgramBuilder::like(program)),
        uses_(program.nodes.size(), 0),
        renamed_(program.nodes.size(), kNoValue) {
    for (const Node& node : program.nodes)
      for (int k = 0; k < arity(node.op); ++k) ++uses_[node.operands[k]];
    for (const OutputValue& output : program.outputs) uses_[output.value] += 2;
    find_absorbed();
    for (std::size_t number = 0; number < kProbes; ++number) {
      std::vector<Rounded> inputs;  // each known to a rounding, as a state is
      for (const double input : ordinary_inputs(program, number))
        inputs.push_back({input, std::numeric_limits<double>::epsilon() * std::abs(input)});
      probes_.push_back({RoundedValues(inputs), RoundedValues(inputs)});
      for (const Node& node : program.nodes) probes_.back().before.append(node);
    }
  }

  Program rewritten() {
    for (ValueId v = 0; v < program_.nodes.size(); ++v) {
      if (absorbed_[v]) continue;
      const Node& node = program_.nodes[v];
      renamed_[v] = is_sum(node.op) ? write_sum(v) : builder_.copy(program_, node, renamed_);
    }
    for (const auto& [slot, value] : program_.outputs) builder_.output(slot.group, slot.index, renamed_[value]);
    return builder_.finish();
  }

 private:
  /// Sums and products inside a sum: they are written with it.
  void find_absorbed() {
    absorbed_.assign(program_.nodes.size(), false);
    for (ValueId v = 0; v < program_.nodes.size(); ++v) {
      const Node& user = program_.nodes[v];
      if (!is_sum(user.op)) continue;
      for (int k = 0; k < arity(user.op); ++k) {
        const ValueId operand = user.operands[k];
        const Node& node = program_.nodes[operand];
        const bool fits = is_sum(node.op) || node.op == Op::multiply;
        if (fits && uses_[operand] == 1 && node.label < 0) absorbed_[operand] = true;
      }
    }
  }

  /// Terms of the sum `root`, in the order in which they stand; without recursion, for sums of any length.
  std::vector<Term> terms_of(ValueId root) const {
    std::vector<Term> terms;
    std::vector<std::pair<ValueId, bool>> pending{{root, false}};  // value and sign, the next one last
    while (!pending.empty()) {
      const auto [v, negative] = pending.back();
      pending.pop_back();
      const Node& node = program_.nodes[v];
      if (v != root && !absorbed_[v]) {
        terms.push_back({negative, renamed_[v], kNoValue});
      } else if (!is_sum(node.op)) {
        terms.push_back({negative, renamed_[node.operands[0]], renamed_[node.operands[1]]});
      } else {
        for (int k = arity(node.op) - 1; k >= 0; --k) {
          const bool minus = node.op == Op::negate || (node.op == Op::subtract && k == 1);
          pending.push_back({node.operands[k], negative != minus});
        }
      }
    }
    return terms;
  }

  ValueId write_sum(ValueId v) {
    const Node& node = program_.nodes[v];
    builder_.set_origin(node);
    const ValueId sum = accurate_sum(v);
    builder_.label_like(sum, program_, node);
    return sum;
  }

  /// The first form of a sum that is known as well as it was; where none is, operands are at fault, and the first form
  /// is as good as any.
  ValueId accurate_sum(ValueId v) {
    const std::vector<Term> terms = terms_of(v);
    const ValueId first = write(terms, TermOrder::as_known);
    if (is_accurate(first, v)) return first;
    const ValueId second = write(terms, TermOrder::largest_last);
    if (is_accurate(second, v)) return second;
    const ValueId third = as_it_stands(v);
    return is_accurate(third, v) ? third : first;
  }

  /// Bounds of all values up to this one.
  void follow_to(ValueId value) {
    for (SumProbe& probe : probes_)
      while (probe.now.size() <= value) probe.now.append(builder_.node(static_cast<ValueId>(probe.now.size())));
  }

  bool is_accurate(ValueId sum, ValueId v) {
    follow_to(sum);
    return std::ranges::none_of(probes_, [&](const SumProbe& probe) {
      const RoundedLanes &now = probe.now[sum], &before = probe.before[v];
      return now.first.error > kMostOfSums * before.first.error || now.second.error > kMostOfSums * before.second.error;
    });
  }

  /// Largest value of a term at the probes.
  double size_of(const Term& term) {
    follow_to(term.is_product() ? std::max(term.first, term.second) : term.first);
    double largest = 0;
    for (const SumProbe& probe : probes_) {
      RoundedLanes value = probe.now[term.first];
      if (term.is_product()) {
        value.first.value *= probe.now[term.second].first.value;
        value.second.value *= probe.now[term.second].second.value;
      }
      largest = std::max({largest, std::abs(value.first.value), std::abs(value.second.value)});
    }
    return largest;
  }

  /// The sum with its brackets and without common factors, as the program has it.
  ValueId as_it_stands(ValueId root) {
    std::vector<ValueId> parts{root};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Node& node = program_.nodes[parts[i]];
      for (int k = 0; k < arity(node.op); ++k)
        if (is_sum(node.op) && absorbed_[node.operands[k]]) parts.push_back(node.operands[k]);
    }
    std::ranges::sort(parts);
    for (const ValueId v : parts) renamed_[v] = builder_.copy(program_, program_.nodes[v], renamed_);
    return renamed_[root];
  }

  /// One value for all constants that are the same number under several names.
  ValueId number_of(ValueId value) {
    if (value == kNoValue || !builder_.is_constant(value)) return value;
    return first_of_number_.try_emplace(builder_.node(value).constant, value).first->second;
  }

  /// Removes each term with the first later one that is its opposite.
  void cancel(std::vector<Term>& terms) {
    struct Place {
      ValueId first, second;  // the term up to its sign
      std::size_t term;
      bool operator==(const Place& other) const { return first == other.first && second == other.second; }
    };
    std::vector<Place> order;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      const ValueId first = number_of(terms[i].first), second = number_of(terms[i].second);
      order.push_back({first, second, i});
    }
    std::ranges::sort(order, {}, [](const Place& place) { return std::tuple(place.first, place.second, place.term); });
    std::vector<bool> cancelled(terms.size(), false);
    auto waiting = order.begin();  // the first of equal terms, which have one sign while they wait
    for (auto place = order.begin(); place != order.end(); ++place) {
      if (*waiting != *place) waiting = place;
      while (waiting != place && cancelled[waiting->term]) ++waiting;
      if (waiting == place || terms[waiting->term].negative == terms[place->term].negative) continue;
      cancelled[place->term] = cancelled[waiting->term] = true;
    }
    std::size_t i = 0;
    std::erase_if(terms, [&](const Term&) { return cancelled[i++]; });
  }

  /// Constants become one term, last of the plain ones, unless their sum is too large for a number.
  void merge_constants(std::vector<Term>& terms) {
    const auto numbers = std::stable_partition(
        terms.begin(), terms.end(), [&](const Term& t) { return t.is_product() || !builder_.is_constant(t.first); });
    if (terms.end() - numbers < 2) return;
    ValueId sum = builder_.constant(0);
    for (auto t = numbers; t != terms.end(); ++t)
      sum = builder_.append(t->negative ? Op::subtract : Op::add, sum, t->first);
    if (!builder_.is_constant(sum)) return;
    terms.erase(numbers, terms.end());
    if (!builder_.is_constant(sum, 0)) terms.push_back({false, sum, kNoValue});
  }

  /// The value that most products have as a factor, kNoValue when none is in two.
  ValueId common_factor(const std::vector<Term>& terms) {
    std::vector<ValueId> factors;
    for (const Term& t : terms) {
      if (!t.is_product()) continue;
      factors.push_back(number_of(t.first));
      if (number_of(t.second) != number_of(t.first)) factors.push_back(number_of(t.second));
    }
    std::ranges::sort(factors);
    ValueId best = kNoValue;
    std::ptrdiff_t most = 1;
    for (auto run = factors.begin(); run != factors.end();) {
      const auto end = std::upper_bound(run, factors.end(), *run);
      if (end - run > most) best = *run, most = end - run;
      run = end;
    }
    return best;
  }

  /// Takes common factors out, one after the other.
  void factor(std::vector<Term>& terms, TermOrder order) {
    for (ValueId common = common_factor(terms); common != kNoValue; common = common_factor(terms)) {
      std::vector<Term> cofactors, others;
      for (const Term& t : terms) {
        if (t.is_product() && (number_of(t.first) == common || number_of(t.second) == common))
          cofactors.push_back({t.negative, number_of(t.first) == common ? t.second : t.first, kNoValue});
        else
          others.push_back(t);
      }
      terms = std::move(others);
      const bool all_negative =
          std::all_of(cofactors.begin(), cofactors.end(), [](const Term& t) { return t.negative; });
      for (Term& t : cofactors) t.negative = t.negative != all_negative;
      const ValueId sum = write(std::move(cofactors), order);
      if (!builder_.is_constant(sum, 0)) terms.push_back({all_negative, common, sum});
    }
  }

  /// The value from which on a term is known.
  ValueId known_from(const Term& term) const {
    ValueId last = 0;
    for (const ValueId value : {term.first, term.second})
      if (value != kNoValue && !builder_.is_constant(value)) last = std::max(last, value);
    return last;
  }

  void put_in_order(std::vector<Term>& terms, TermOrder order) {
    std::ranges::stable_sort(terms, {}, [&](const Term& t) { return known_from(t); });
    if (order == TermOrder::as_known || terms.empty()) return;
    const auto largest = std::ranges::max_element(terms, {}, [&](const Term& t) { return size_of(t); });
    std::rotate(largest, largest + 1, terms.end());
  }

  ValueId write(std::vector<Term> terms, TermOrder order) {
    cancel(terms);
    merge_constants(terms);
    factor(terms, order);
    put_in_order(terms, order);
    if (terms.empty()) return builder_.constant(0);
    const auto first = std::find_if(terms.begin(), terms.end(), [](const Term& t) { return !t.negative; });
    if (first != terms.end()) std::rotate(terms.begin(), first, first + 1);
    ValueId sum = kNoValue;
    for (const Term& t : terms) {
      const ValueId value = t.is_product() ? builder_.append(Op::multiply, t.first, t.second) : t.first;
      if (sum == kNoValue)
        sum = t.negative ? builder_.append(Op::negate, value) : value;
      else
        sum = builder_.append(t.negative ? Op::subtract : Op::add, sum, value);
    }
    return sum;
  }

  const Program& program_;
  ProgramBuilder builder_;
  std::vector<int> uses_;
  std::vector<bool> absorbed_;
  std::map<double, ValueId> first_of_number_;
  std::vector<ValueId> renamed_;
  std::vector<SumProbe> probes_;
};

}  // namespace

Program factor_sums(const Program& program) { return SumWriter(program).rewritten(); }

}  // namespace mbgen
