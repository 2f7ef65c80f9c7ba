#include "runtime/generic/klu_factors.hpp"

#include <utility>

namespace mbgen {
namespace {

// Pivots of last time are kept while their ratio stays above this share of what it was when they were chosen.
constexpr double kStale = 0.1;

}  // namespace

KluFactors::KluFactors(std::vector<int> starts, std::vector<int> rows)
    : starts_(std::move(starts)), rows_(std::move(rows)), values_(rows_.size()) {
  klu_defaults(&common_);
  symbolic_ = klu_analyze(static_cast<int>(starts_.size()) - 1, starts_.data(), rows_.data(), &common_);
}

KluFactors::~KluFactors() {
  forget();
  klu_free_symbolic(&symbolic_, &common_);
}

void KluFactors::forget() { klu_free_numeric(&numeric_, &common_); }

double KluFactors::pivot_ratio() { return klu_rcond(symbolic_, numeric_, &common_) ? common_.rcond : 0; }

double KluFactors::factorise() {
  if (!symbolic_) return 0;
  if (numeric_ && klu_refactor(starts_.data(), rows_.data(), values_.data(), symbolic_, numeric_, &common_)) {
    const double ratio = pivot_ratio();
    if (ratio > kStale * fresh_ratio_) return ratio;
  }
  forget();
  numeric_ = klu_factor(starts_.data(), rows_.data(), values_.data(), symbolic_, &common_);
  fresh_ratio_ = numeric_ ? pivot_ratio() : 0;
  return fresh_ratio_;
}

void KluFactors::solve(int count, std::vector<double>& b) {
  const int n = static_cast<int>(starts_.size()) - 1;
  klu_solve(symbolic_, numeric_, n, count, b.data(), &common_);
}

}  // namespace mbgen
