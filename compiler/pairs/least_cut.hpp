#pragma once
// The cheapest of all ways to decide many questions with two answers each.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace mbgen {

/// The cost of leaving `to` beyond a cut with `from` on this side.
struct CostArc {
  std::uint32_t from, to;
  long room;
};

/// Questions that are answered yes or no, with costs of answers and of pairs of answers: a minimum cut.
class Decisions {
 public:
  using Question = std::size_t;
  static constexpr long kNever = 1L << 40;

  Question add(long cost_of_yes, long cost_of_no);
  void add_cost_of_yes(Question q, long cost) { arc(q, kNo, cost); }
  void add_cost_of_no(Question q, long cost) { arc(kYes, q, cost); }
  /// Costs when `yes` is answered yes and `no` no.
  void add_cost(Question yes, Question no, long cost) { arc(yes, no, cost); }

  /// Answers of the least cost, by question; of several such, the one with the fewest yes. Method: augmenting paths by
  /// levels (Dinic 1970).
  std::vector<bool> decided();

 private:
  static constexpr std::size_t kYes = 0, kNo = 1;
  void arc(std::size_t from, std::size_t to, long room);
  std::size_t nodes_ = 2;
  std::vector<CostArc> arcs_;
};

}  // namespace mbgen
