#pragma once
// Rates of inputs whose caller gives values only. Input and rates follow a spline through the values, so that each rate
// is the derivative of its input: a driven joint neither drifts nor jumps, and bodies feel its acceleration.

#include <cmath>

namespace mbgen {

/// An input and at most eight derivatives.
constexpr int kLongestInputRow = 9;

/// An input with its derivatives among the inputs, the input first. size: at least two. last_is_made: the model names
/// all rates except the last, which the caller need not know.
template <class Inputs, class Real>
struct InputRow {
  int size;
  Real Inputs::*members[kLongestInputRow];
  bool last_is_made = false;
};

namespace path_detail {

/// Weight of derivative i times h^i in the newest control point of a cardinal B-spline of this degree, by the
/// derivatives at the start of the interval that the point opens: e_i(1, 2, .., degree) / (i! binomial(degree, i)), e_i
/// the elementary symmetric polynomial. Source: L. Ramshaw, "Blossoms are polar forms", 1989.
constexpr double newest_weight(int degree, int i) noexcept {
  double e[kLongestInputRow] = {1};
  for (int knot = 1; knot <= degree; ++knot) {
    for (int k = knot; k > 0; --k) e[k] += knot * e[k - 1];
  }
  double weight = e[i];
  for (int k = 0; k < i; ++k) weight /= degree - k;
  return weight;
}

/// Taylor polynomial of derivative `first`, dt later.
template <class Real>
Real later(const Real* values, int size, int first, Real dt) noexcept {
  Real sum = values[size - 1];
  for (int k = size - 2; k >= first; --k) sum = values[k] + dt / static_cast<Real>(k - first + 1) * sum;
  return sum;
}

}  // namespace path_detail

/// The inputs of a run whose caller may leave rates out. Of each row of `kRows` whose rates were zero since the start,
/// the rates are made: the input follows the cardinal B-spline whose control points are the values, one a step, of the
/// degree that the row has derivatives. So it
///   - stays within the values that were given, and rests `degree` steps after they do;
///   - lags (degree + 1) / 2 steps behind them: one step with a rate, one and a half with rate and acceleration;
///   - has all rates continuous but the last, which is constant during a step.
/// A row with any rate other than zero is left as it is given, bit for bit, and so are inputs that are in no row; a
/// last rate that the model does not name is then the slope of the rate before it over the last step, until it is
/// given. The first step stands at the values that it is given, at rest. While steps change their size the path stays
/// smooth, but may leave the values a little. Plain data: a copy is the way back from a step that failed.
template <class Inputs, const auto& kRows>
class InputPaths {
  static constexpr int kCount = sizeof(kRows) / sizeof(kRows[0]);

 public:
  bool rates_given = false;  ///< whether rates count as given, also where they are zero

  /// Forgets the past: the next step stands at the values that it is given.
  void restart() noexcept {
    has_started_ = false;
    for (Row& row : rows_) row = {};
  }

  /// Inputs for a step of h seconds from now; `wanted`: the caller's inputs at its start. Afterwards the paths are at
  /// the end of the step.
  Inputs of_step(const Inputs& wanted, double h) noexcept {
    Inputs result = wanted;
    for (int r = 0; r < kCount; ++r) {
      rows_[r].given = rows_[r].given || has_rates(r, wanted);
      rows_[r].last_given = rows_[r].last_given || wanted.*kRows[r].members[kRows[r].size - 1] != 0;
      Real values[kLongestInputRow];
      const int size = kRows[r].size;
      for (int k = 0; k < size; ++k) values[k] = wanted.*kRows[r].members[k];
      if (!is_given(r, wanted)) {
        follow(r, static_cast<Real>(h), values);
      } else if (makes_last(r, wanted)) {
        Row& row = rows_[r];
        row.made = values[size - 1] = row.size > 0 ? (values[size - 2] - row.before) / row.size : 0;
      }
      rows_[r].before = wanted.*kRows[r].members[size - 2];
      rows_[r].size = static_cast<Real>(h);
      for (int k = 0; k < size; ++k) {
        result.*kRows[r].members[k] = values[k];
        rows_[r].values[k] = path_detail::later(values, size, k, static_cast<Real>(h));
      }
    }
    has_started_ = true;
    return result;
  }

  /// Present inputs, at the end of the last step, for outputs and accelerations.
  Inputs now(const Inputs& wanted) const noexcept {
    Inputs result = wanted;
    for (int r = 0; r < kCount && has_started_; ++r) {
      if (is_given(r, wanted)) {
        const int last = kRows[r].size - 1;
        if (makes_last(r, wanted)) result.*kRows[r].members[last] = slope(rows_[r], wanted.*kRows[r].members[last - 1]);
        continue;
      }
      for (int k = 0; k < kRows[r].size; ++k) result.*kRows[r].members[k] = rows_[r].values[k];
    }
    return result;
  }

  /// Whether a step from now moves an input with computed rates; multistep methods then restart.
  bool moves(const Inputs& wanted) const noexcept {
    for (int r = 0; r < kCount && has_started_; ++r) {
      if (!is_given(r, wanted) && !is_at_rest(r, wanted.*kRows[r].members[0])) return true;
    }
    return false;
  }

 private:
  template <class Number>
  static Number member_type(Number Inputs::*);
  using Real = decltype(member_type(kRows[0].members[0]));

  struct Row {
    Real values[kLongestInputRow] = {};   ///< at the end of the last step
    Real reach = 0;                       ///< largest value since the path was at rest
    bool given = false;                   ///< whether a rate was other than zero since the start
    bool last_given = false;              ///< whether the last rate was
    Real before = 0, made = 0, size = 0;  ///< of the last step: rate before the last one, slope that was made, s
  };

  static bool has_rates(int r, const Inputs& inputs) noexcept {
    for (int k = 1; k < kRows[r].size; ++k) {
      if (inputs.*kRows[r].members[k] != 0) return true;
    }
    return false;
  }

  bool is_given(int r, const Inputs& wanted) const noexcept {
    return rates_given || rows_[r].given || has_rates(r, wanted);
  }

  /// Whether the last rate of a row whose others are given is to be made of them.
  bool makes_last(int r, const Inputs& wanted) const noexcept {
    return kRows[r].last_is_made && !rows_[r].last_given && wanted.*kRows[r].members[kRows[r].size - 1] == 0;
  }

  /// Slope of the second last rate since the last step began; if the caller did not change the rate, the slope of the
  /// previous step.
  static Real slope(const Row& row, Real rate) noexcept {
    return row.size > 0 && rate != row.before ? (rate - row.before) / row.size : row.made;
  }

  bool is_at_rest(int r, Real value) const noexcept {
    const Row& row = rows_[r];
    if (row.values[0] != value) return false;
    for (int k = 1; k < kRows[r].size; ++k) {
      if (row.values[k] != 0) return false;
    }
    return true;
  }

  /// Derivatives at the start of a step towards values[0], the newest control point.
  void follow(int r, Real h, Real* values) noexcept {
    Row& row = rows_[r];
    const int degree = kRows[r].size - 1;
    const Real newest = values[0];
    if (!has_started_ || is_at_rest(r, newest)) return;
    row.reach = std::fmax(row.reach, std::fmax(std::abs(newest), std::abs(row.values[0])));
    Real missing = newest, power = 1, distance = std::abs(newest - row.values[0]);
    for (int k = 0; k < degree; ++k, power *= h) {
      values[k] = row.values[k];
      missing -= static_cast<Real>(path_detail::newest_weight(degree, k)) * values[k] * power;
      if (k > 0) distance += std::abs(values[k] * power);
    }
    values[degree] = missing / (power * static_cast<Real>(path_detail::newest_weight(degree, degree)));
    if (distance > kRounding * row.reach) return;
    values[0] = newest;  // it has come to rest, but for rounding
    for (int k = 1; k <= degree; ++k) values[k] = 0;
    row.reach = 0;
  }

  static constexpr Real kRounding = sizeof(Real) == sizeof(double) ? Real(1e-13) : Real(1e-5);

  bool has_started_ = false;
  Row rows_[kCount];
};

}  // namespace mbgen
