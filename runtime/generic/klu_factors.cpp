#include "runtime/generic/klu_factors.hpp"

#include <klu.h>

#include <utility>

namespace mbgen {
namespace {

// Pivots of last time are kept while their ratio stays above this share of its value when they were chosen.
constexpr double kStale = 0.1;

}  // namespace

/// Data of KLU for one matrix.
struct KluFactors::Library {
  Library() {
    klu_defaults(&common);
    common.scale = 0;  // rows of rounding errors must not look like rows of ones
  }
  ~Library() {
    klu_free_numeric(&numeric, &common);
    klu_free_symbolic(&symbolic, &common);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  double pivot_ratio() { return klu_rcond(symbolic, numeric, &common) ? common.rcond : 0; }

  klu_common common;
  klu_symbolic* symbolic = nullptr;
  klu_numeric* numeric = nullptr;
};

KluFactors::KluFactors(std::vector<int> starts, std::vector<int> rows)
    : starts_(std::move(starts)), rows_(std::move(rows)), values_(rows_.size()), library_(std::make_unique<Library>()) {
  Library& klu = *library_;
  klu.symbolic = klu_analyze(static_cast<int>(starts_.size()) - 1, starts_.data(), rows_.data(), &klu.common);
}

KluFactors::~KluFactors() = default;

double KluFactors::factorise() {
  Library& klu = *library_;
  if (!klu.symbolic) return 0;
  if (klu.numeric &&
      klu_refactor(starts_.data(), rows_.data(), values_.data(), klu.symbolic, klu.numeric, &klu.common)) {
    const double ratio = klu.pivot_ratio();
    if (ratio > kStale * fresh_ratio_) return ratio;
  }
  klu_free_numeric(&klu.numeric, &klu.common);
  klu.numeric = klu_factor(starts_.data(), rows_.data(), values_.data(), klu.symbolic, &klu.common);
  fresh_ratio_ = klu.numeric ? klu.pivot_ratio() : 0;
  return fresh_ratio_;
}

void KluFactors::solve(int count, std::vector<double>& b) {
  const int n = static_cast<int>(starts_.size()) - 1;
  klu_solve(library_->symbolic, library_->numeric, n, count, b.data(), &library_->common);
}

}  // namespace mbgen
