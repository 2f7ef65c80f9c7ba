#pragma once
// KLU of SuiteSparse for one pattern: ordered once, pivoted when needed, else refactored with the pivots of last time.

#include <memory>
#include <vector>

namespace mbgen {

class KluFactors {
 public:
  /// A square matrix by compressed columns: starts of the columns (one more than there are) and the row of each entry.
  KluFactors(std::vector<int> starts, std::vector<int> rows);
  ~KluFactors();

  /// Of the entries, in the order of the pattern, to fill in before factorise.
  std::vector<double>& values() { return values_; }
  /// Result: smallest over largest pivot, 0 or NaN for a matrix that is singular.
  double factorise();
  /// b = A^-1 b for a matrix b of `count` columns, column-major. Requires: factorise gave a result above zero.
  void solve(int count, std::vector<double>& b);

 private:
  struct Library;

  std::vector<int> starts_, rows_;
  std::vector<double> values_;
  std::unique_ptr<Library> library_;
  double fresh_ratio_ = 0;  ///< when the pivots were chosen
};

}  // namespace mbgen
