#pragma once
// The shortest of all changes of a block that differ by its free directions.

namespace mbgen {

/// Factors L D L' of Rz' Rz in place of the lower triangle: no square root, which lanes are slow at.
/// rz: coordinates x free row by row, of full column rank; gram: free * free numbers. Real: a row of lanes as well.
template <class Real>
inline void factorise_gram(int coordinates, int free, const Real* rz, Real* gram) noexcept {
  for (int p = 0; p < free; ++p) {
    Real* row = gram + p * free;
    for (int q = 0; q <= p; ++q) {
      row[q] = Real{};
      for (int c = 0; c < coordinates; ++c) row[q] = row[q] + rz[c * free + p] * rz[c * free + q];
    }
    for (int q = 0; q < p; ++q) {
      for (int k = 0; k < q; ++k) row[q] = row[q] - row[k] * gram[q * free + k];
    }
    for (int k = 0; k < p; ++k) {
      const Real factor = row[k] / gram[k * free + k];
      row[p] = row[p] - factor * row[k];
      row[k] = factor;
    }
  }
}

/// Removes the component along the free directions from x: the shortest of all x that differ by them. gram: of
/// factorise_gram; x: per coordinate; along: free.
template <class Real>
inline void shorten(int coordinates, int free, const Real* rz, const Real* gram, Real* along, Real* x) noexcept {
  for (int p = 0; p < free; ++p) {
    along[p] = Real{};
    for (int c = 0; c < coordinates; ++c) along[p] = along[p] + rz[c * free + p] * x[c];
    for (int k = 0; k < p; ++k) along[p] = along[p] - gram[p * free + k] * along[k];
  }
  for (int p = free - 1; p >= 0; --p) {
    along[p] = along[p] / gram[p * free + p];
    for (int k = p + 1; k < free; ++k) along[p] = along[p] - gram[k * free + p] * along[k];
  }
  for (int c = 0; c < coordinates; ++c) {
    for (int p = 0; p < free; ++p) x[c] = x[c] - rz[c * free + p] * along[p];
  }
}

}  // namespace mbgen
