#include "runtime/generic/paper_lu.hpp"

#include <cblas.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "runtime/generic/block_factors.hpp"

namespace mbgen {
namespace {

// A column is taken at once when elimination left it this share of its size, else after the others with a smaller one;
// in the end only rounding counts.
constexpr double kLeastShares[] = {1e-2, 1e-4, 1e-6, 1e-8, 0};

}  // namespace

PaperLu::PaperLu(int rows, int columns, std::vector<int> group_of_candidate, std::vector<int> most_of)
    : rows_(rows),
      columns_(columns),
      candidates_(static_cast<int>(group_of_candidate.size())),
      group_(std::move(group_of_candidate)),
      most_(std::move(most_of)),
      found_(most_.size()),
      matrix_(static_cast<std::size_t>(rows) * columns),
      column_size_(candidates_),
      group_size_(most_.size()),
      row_at_(rows),
      column_at_(columns) {}

int PaperLu::factorise() {
  std::iota(row_at_.begin(), row_at_.end(), 0);
  std::iota(column_at_.begin(), column_at_.end(), 0);
  std::fill(found_.begin(), found_.end(), 0);
  std::fill(group_size_.begin(), group_size_.end(), 0.0);
  for (int c = 0; c < candidates_; ++c) {
    const double* column = matrix_.data() + static_cast<std::size_t>(c) * rows_;
    column_size_[c] = rows_ > 0 ? std::abs(column[cblas_idamax(rows_, column, 1)]) : 0;
    group_size_[group_[c]] = std::max(group_size_[group_[c]], column_size_[c]);
  }
  const int wanted = std::accumulate(most_.begin(), most_.end(), 0);
  pivots_ = 0;
  for (const double share : kLeastShares)
    for (int place = pivots_; place < candidates_ && pivots_ < wanted; ++place) pivots_ += take_pivot(place, share);
  return pivots_;
}

bool PaperLu::take_pivot(int place, double share) {
  const int original = column_at_[place], group = group_[original];
  if (found_[group] == most_[group]) return false;
  const double* column = matrix_.data() + static_cast<std::size_t>(place) * rows_;
  const int row = pivots_ + static_cast<int>(cblas_idamax(rows_ - pivots_, column + pivots_, 1));
  const double least = std::max(share * column_size_[original], kRankTolerance<double> * group_size_[group]);
  if (!(std::abs(column[row]) > least)) return false;
  eliminate(row, place);
  ++found_[group];
  return true;
}

void PaperLu::eliminate(int row, int place) {
  const int k = pivots_;
  double* a = matrix_.data();
  const std::size_t ld = rows_;
  if (place != k) {
    cblas_dswap(rows_, a + k * ld, 1, a + place * ld, 1);
    std::swap(column_at_[k], column_at_[place]);
  }
  if (row != k) {
    cblas_dswap(columns_, a + k, rows_, a + row, rows_);
    std::swap(row_at_[k], row_at_[row]);
  }
  double* pivot = a + k * ld + k;
  cblas_dscal(rows_ - k - 1, 1 / *pivot, pivot + 1, 1);
  if (k + 1 < rows_ && k + 1 < columns_)
    cblas_dger(CblasColMajor, rows_ - k - 1, columns_ - k - 1, -1.0, pivot + 1, 1, pivot + ld, rows_, pivot + ld + 1,
               rows_);
}

void PaperLu::dependence(int first, int count, std::vector<double>& x) const {
  x.resize(static_cast<std::size_t>(pivots_) * count);
  const double* a = matrix_.data();
  const std::size_t ld = rows_;
  for (int c = 0; c < count; ++c)
    std::copy_n(a + (first + c) * ld, pivots_, x.data() + c * static_cast<std::size_t>(pivots_));
  for (int k = pivots_ - 1; k >= 0; --k) {
    cblas_dscal(count, 1 / a[k * ld + k], x.data() + k, pivots_);
    cblas_dger(CblasColMajor, k, count, -1.0, a + k * ld, 1, x.data() + k, pivots_, x.data(), pivots_);
  }
}

void PaperLu::solve(const std::vector<double>& b, const std::vector<double>& given, std::vector<double>& x) const {
  x.resize(pivots_);
  const double* a = matrix_.data();
  const std::size_t ld = rows_;
  for (int k = 0; k < pivots_; ++k) x[k] = b[row_at_[k]];
  for (int k = 0; k < pivots_; ++k)
    cblas_dger(CblasColMajor, pivots_ - k - 1, 1, -1.0, a + k * ld + k + 1, 1, x.data() + k, pivots_, x.data() + k + 1,
               pivots_);
  if (pivots_ > 0 && pivots_ < columns_)
    cblas_dgemv(CblasColMajor, CblasNoTrans, pivots_, columns_ - pivots_, -1.0, a + pivots_ * ld, rows_, given.data(),
                1, 1.0, x.data(), 1);
  for (int k = pivots_ - 1; k >= 0; --k) {
    x[k] /= a[k * ld + k];
    cblas_dger(CblasColMajor, k, 1, -1.0, a + k * ld, 1, x.data() + k, pivots_, x.data(), pivots_);
  }
}

}  // namespace mbgen
