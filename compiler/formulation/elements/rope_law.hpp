#pragma once
// Law of ropes: tensions of their spans over stretch, and slip in grooves with friction.

#include <optional>
#include <utility>
#include <vector>

#include "compiler/model/model.hpp"
#include "mbgen/scalar.hpp"

namespace mbgen::detail {

/// Share of the largest difference of tensions up to which a rope in a groove sticks.
inline constexpr double kRopeSticks = 0.8;
/// Largest share of the speed of slip: below 1, so that two grooves that slip at once share it.
inline constexpr double kRopeSlips = 1 - 1e-6;
/// m: stretch that counts as none, where a groove without tension slips.
inline constexpr double kLeastRopeStretch = 1e-12;
/// Share of its stiffness that a slack span has in speeds of slip.
inline constexpr double kSlackRope = 1e-6;

/// A groove with friction between two spans.
struct RopeGroove {
  std::size_t station = 0, before = 0, behind = 0;  ///< index into the path; the spans before and behind it
};

inline std::vector<RopeGroove> grooves_of(const Rope& rope) {
  std::vector<RopeGroove> grooves;
  const std::vector<RopeLeg> legs = legs_of(rope);
  for (std::size_t s = 0; s < rope.path.size(); ++s) {
    if (rope.path[s].contact != RopeStation::Contact::rubs) continue;
    RopeGroove groove{s, 0, 0};
    for (const RopeLeg& leg : legs) {
      if (leg.to == s) groove.before = static_cast<std::size_t>(leg.span);
      if (leg.from == s) groove.behind = static_cast<std::size_t>(leg.span);
    }
    grooves.push_back(groove);
  }
  return grooves;
}

/// Numbers of the law of a rope.
template <class T>
struct RopeNumbers {
  std::vector<T> slack, slack_rate;  ///< per span: reach without stretch, m, and its rate
  std::vector<T> stiffness;          ///< N/m
  std::vector<T> length, lengthens;  ///< with EA: free lengths now, m, and their rates without slip
  std::optional<T> ea;               ///< N
  T damping{0.0}, lag{0.0};          ///< s
  std::vector<T> grip;               ///< per groove: exp(friction wrap)
  std::vector<RopeGroove> grooves;
};

/// Tensions of a rope over the reaches of its spans, their rates and its slips.
template <class A>
struct RopeForces {
  std::vector<A> stretch, rate, elastic, tension;  ///< per span: m, m/s, N, N
  std::vector<A> slip_rate;                        ///< per groove, m/s
  /// Per span of a rope with grooves: loss of elastic tension by a metre of slip into it, N/m, and the speed of slip
  /// that would keep its tension, m/s.
  std::vector<A> loss_by_slip, keeping_slip;
};

/// Solves (I - C) x = b for the slips of grooves that share spans; C has row sums below 1.
template <class A>
std::vector<A> slips_together(std::vector<std::vector<A>> shares, std::vector<A> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) shares[i][j] = A(i == j ? 1.0 : 0.0) - shares[i][j];
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const A factor = shares[i][k] / shares[k][k];
      for (std::size_t j = k + 1; j < n; ++j) shares[i][j] = shares[i][j] - factor * shares[k][j];
      b[i] = b[i] - factor * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] = b[k] - shares[k][j] * b[j];
    b[k] = b[k] / shares[k][k];
  }
  return b;
}

/// A groove in the act of slipping, towards the larger tension.
template <class A>
struct SlippingGroove {
  A way;             ///< 1 towards the span behind, -1 towards the span before
  A excess;          ///< N, of the larger tension over exp(friction wrap) times the smaller one
  A behind, before;  ///< N/m: loss of the excess by a metre of slip, by the change of either span
  A sum;             ///< N/m, of both
  A slides;          ///< share of the speed that would keep the excess: 0 where the groove sticks
};

template <class T, class A>
SlippingGroove<A> slipping_groove(const RopeNumbers<T>& numbers, std::size_t j, const RopeForces<A>& rope) {
  using mbgen::max, mbgen::min, mbgen::select;
  const RopeGroove& groove = numbers.grooves[j];
  const A grip(numbers.grip[j]), &front = rope.elastic[groove.behind], &back = rope.elastic[groove.before];
  const A onwards = front - back, low = min(front, back), one(1.0), zero(0.0);
  SlippingGroove<A> s;
  s.way = select(onwards, one, A(-1.0));
  s.excess = max(front, back) - grip * low;
  s.behind = select(onwards, one, grip) * rope.loss_by_slip[groove.behind];
  s.before = select(onwards, grip, one) * rope.loss_by_slip[groove.before];
  s.sum = s.behind + s.before;
  const A speed = (s.behind * rope.keeping_slip[groove.behind] - s.before * rope.keeping_slip[groove.before]) / s.sum;
  const A width =
      A(1 - kRopeSticks) * (grip - one) * low + s.sum * (A(numbers.lag) * abs(speed) + A(kLeastRopeStretch));
  const A part = max(zero, min(one, one + s.excess / width));
  s.slides = A(kRopeSlips) * part * part;
  return s;
}

/// Sets how the spans' elastic tensions change by slip, and by their rates without slip: k dstretch - tension dlength /
/// length.
template <class T, class A>
void set_changes_by_slip(const RopeNumbers<T>& numbers, RopeForces<A>& rope) {
  using mbgen::max, mbgen::select;
  for (std::size_t g = 0; g < rope.stretch.size(); ++g) {
    const A stiffness(numbers.stiffness[g]), slack(T(kSlackRope) * numbers.stiffness[g]);
    if (!numbers.ea) {
      rope.loss_by_slip.push_back(select(rope.stretch[g], stiffness, slack));
      rope.keeping_slip.push_back(rope.rate[g]);
      continue;
    }
    const A strain = max(rope.stretch[g], A(0.0)) / A(numbers.length[g]), strained = A(1.0) + strain;
    rope.loss_by_slip.push_back(select(rope.stretch[g], stiffness * strained, slack));
    rope.keeping_slip.push_back((rope.rate[g] - strain * A(numbers.lengthens[g])) / strained);
  }
}

/// Sets the speeds of slip. A groove sticks while the larger tension is below exp(friction wrap) times the smaller one;
/// at the limit it slips as fast as the ratio stays there, and an excess fades with the lag. Slip never acts
/// against the larger tension, so that it takes energy only. Requires: set_changes_by_slip.
template <class T, class A>
void set_slips(const RopeNumbers<T>& numbers, RopeForces<A>& rope) {
  using mbgen::max, mbgen::select;
  const std::vector<RopeGroove>& grooves = numbers.grooves;
  const std::size_t n = grooves.size();
  std::vector<SlippingGroove<A>> slipping;
  for (std::size_t j = 0; j < n; ++j) slipping.push_back(slipping_groove(numbers, j, rope));
  std::vector<A> slides;
  for (const SlippingGroove<A>& s : slipping) slides.push_back(s.slides);
  const auto solved = [&] {
    std::vector<std::vector<A>> shares = std::vector<std::vector<A>>(n, std::vector<A>(n, A(0.0)));
    std::vector<A> speeds;
    for (std::size_t j = 0; j < n; ++j) {
      const SlippingGroove<A>& s = slipping[j];
      const A behind = slides[j] * (s.behind / s.sum), before = slides[j] * (s.before / s.sum);
      speeds.push_back(behind * rope.keeping_slip[grooves[j].behind] - before * rope.keeping_slip[grooves[j].before]);
      for (std::size_t i = 0; i < n; ++i) {  // slip at the far ends of both spans; its own is in the sum
        if (i == j) continue;
        if (grooves[i].before == grooves[j].behind) shares[j][i] = shares[j][i] + behind;
        if (grooves[i].behind == grooves[j].before) shares[j][i] = shares[j][i] + before;
      }
    }
    return slips_together(std::move(shares), std::move(speeds));
  };
  std::vector<A> speeds = solved();
  if (n > 1) {  // without the grooves that would slip against the larger tension
    for (std::size_t j = 0; j < n; ++j) slides[j] = select(slipping[j].way * speeds[j], slides[j], A(0.0));
    speeds = solved();
  }
  for (std::size_t j = 0; j < n; ++j) {
    const SlippingGroove<A>& s = slipping[j];
    const A rest = max(s.excess, A(0.0)) / (s.sum * A(numbers.lag));
    rope.slip_rate.push_back(s.way * (max(s.way * speeds[j], A(0.0)) + rest));
  }
}

/// Rates of stretch that damping acts against, m/s: with EA those of the strain, times the free length, so that a rope
/// of constant tension that is paid out has none.
template <class T, class A>
std::vector<A> damped_rates(const RopeNumbers<T>& numbers, const RopeForces<A>& rope) {
  using mbgen::max;
  if (!numbers.ea) return rope.rate;
  std::vector<A> lengthens(numbers.lengthens.begin(), numbers.lengthens.end()), rates;
  for (std::size_t j = 0; j < numbers.grooves.size(); ++j) {
    A &before = lengthens[numbers.grooves[j].before], &behind = lengthens[numbers.grooves[j].behind];
    before = before - rope.slip_rate[j];
    behind = behind + rope.slip_rate[j];
  }
  for (std::size_t g = 0; g < lengthens.size(); ++g)
    rates.push_back(rope.rate[g] - max(rope.stretch[g], A(0.0)) / A(numbers.length[g]) * lengthens[g]);
  return rates;
}

/// The law of a rope. reach, rate: of its spans; slips: of its grooves.
template <class T, class A>
RopeForces<A> rope_law(const RopeNumbers<T>& numbers, const std::vector<A>& reach, const std::vector<A>& rate,
                       const A* slips) {
  using mbgen::max, mbgen::min;
  RopeForces<A> rope;
  const A zero(0.0);
  const auto slip = [&](std::vector<A>& of, const auto& by) {
    for (std::size_t j = 0; j < numbers.grooves.size(); ++j) {
      of[numbers.grooves[j].before] = of[numbers.grooves[j].before] + by[j];
      of[numbers.grooves[j].behind] = of[numbers.grooves[j].behind] - by[j];
    }
  };
  for (std::size_t g = 0; g < reach.size(); ++g) {
    rope.stretch.push_back(reach[g] - A(numbers.slack[g]));
    rope.rate.push_back(rate[g] - A(numbers.slack_rate[g]));
  }
  slip(rope.stretch, slips);
  for (std::size_t g = 0; g < reach.size(); ++g)
    rope.elastic.push_back(A(numbers.stiffness[g]) * max(rope.stretch[g], zero));
  if (!numbers.grooves.empty()) {
    set_changes_by_slip(numbers, rope);
    set_slips(numbers, rope);
    slip(rope.rate, rope.slip_rate);
  }
  const std::vector<A> rates = damped_rates(numbers, rope);
  for (std::size_t g = 0; g < reach.size(); ++g) {
    const A& elastic = rope.elastic[g];
    const A damped = A(numbers.stiffness[g] * numbers.damping) * rates[g];
    rope.tension.push_back(elastic + max(-elastic, min(elastic, damped)));
  }
  return rope;
}

}  // namespace mbgen::detail
