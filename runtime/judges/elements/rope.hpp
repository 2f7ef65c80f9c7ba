#pragma once
// Ropes and belts. Lengths by angles of tangents; loads are their derivatives by the motions of the bodies, from
// complex steps; slips of grooves from a general linear solver.

#include "runtime/judges/elements/rope_in_space.hpp"

namespace mbgen::cartesian {

/// A groove with friction.
struct GrooveInSpace {
  std::size_t before = 0, behind = 0;  ///< spans
  double grip = 1;                     ///< largest ratio of tensions
};

/// A rope at one instant.
struct RopeNow {
  SpansInSpace spans;
  std::vector<double> stretch, rate, stiffness, elastic, tension;
  std::vector<double> length, lengthens;  ///< free lengths now, m, and their rates without slip
  std::vector<GrooveInSpace> grooves;
  std::vector<double> slip_rates;
  std::vector<double> holds;  ///< see holds_of
  Motions still;
};

/// Speeds of slip: the fixed point of each groove's own speed at those of the others, without grooves that would slip
/// against the larger tension.
inline Eigen::VectorXd slip_speeds(const RopeNow& now, double lag, bool has_ea) {
  const auto n = static_cast<Eigen::Index>(now.grooves.size());
  Eigen::VectorXd way(n), rest(n), part(n);
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd own = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const GrooveInSpace& groove = now.grooves[static_cast<std::size_t>(j)];
    const double front = now.elastic[groove.behind], back = now.elastic[groove.before];
    const bool onwards = front >= back;
    way[j] = onwards ? 1 : -1;
    const auto strain = [&](std::size_t g) { return has_ea ? std::max(now.stretch[g], 0.0) / now.length[g] : 0.0; };
    const auto weight = [&](std::size_t g, bool leads) {
      return (leads ? 1 : groove.grip) * now.stiffness[g] * (now.stretch[g] >= 0 ? 1 + strain(g) : 1e-6);
    };
    // Of the elastic tension, over that by a metre of slip.
    const auto drift = [&](std::size_t g) { return (now.rate[g] - strain(g) * now.lengthens[g]) / (1 + strain(g)); };
    const double ahead = weight(groove.behind, onwards), after = weight(groove.before, !onwards), sum = ahead + after;
    const double excess = std::max(front, back) - groove.grip * std::min(front, back);
    own[j] = (ahead * drift(groove.behind) - after * drift(groove.before)) / sum;
    const double width = 0.2 * (groove.grip - 1) * std::min(front, back) + sum * (lag * std::abs(own[j]) + 1e-12);
    const double s = std::clamp(1 + excess / width, 0.0, 1.0);
    part[j] = (1 - 1e-6) * s * s;
    rest[j] = std::max(excess, 0.0) / (sum * lag);
    for (Eigen::Index i = 0; i < n; ++i) {
      const GrooveInSpace& other = now.grooves[static_cast<std::size_t>(i)];
      if (i != j && other.before == groove.behind) shares(j, i) += ahead / sum;
      if (i != j && other.behind == groove.before) shares(j, i) += after / sum;
    }
  }
  const auto solve = [&](const Eigen::VectorXd& slides) {
    const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(n, n) - slides.asDiagonal() * shares;
    return Eigen::VectorXd(matrix.fullPivLu().solve(slides.cwiseProduct(own)));
  };
  Eigen::VectorXd speeds = solve(part);
  if (n > 1) {
    for (Eigen::Index j = 0; j < n; ++j) part[j] = way[j] * speeds[j] >= 0 ? part[j] : 0;
    speeds = solve(part);
  }
  for (Eigen::Index j = 0; j < n; ++j) speeds[j] = way[j] * (std::max(way[j] * speeds[j], 0.0) + rest[j]);
  return speeds;
}

/// Free lengths of the spans at the reference and their rates.
inline std::vector<Jet<double>> free_lengths(const AtWork& at, const Rope& rope, const SpansInSpace& reference) {
  double total = 0;
  for (const Complex& length : reference.length) total += length.real();
  for (std::size_t s = 0; s < rope.path.size(); ++s)
    if (rope.path[s].kind == RopeStation::Kind::pulley && rope.path[s].separates())
      total += at.value(rope.path[s].radius) * reference.wraps[s];
  std::vector<Jet<double>> lengths;
  for (const Complex& length : reference.length) {
    const double geometric = length.real();
    Jet<double> free(geometric);
    if (rope.free_length) {
      const Jet<double> whole = evaluate<Jet<double>>(*rope.free_length, at.c.model.expressions,
                                                      MotionEnvironment<double, Values>{at.c.model.inputs, at.value});
      free = Jet<double>(geometric / total) * whole;
    } else if (rope.pretension) {
      const double pull = at.value(*rope.pretension);
      free = rope.ea ? geometric / (1 + pull / at.value(*rope.ea)) : geometric - pull / at.value(*rope.stiffness);
    }
    lengths.push_back(free);
  }
  return lengths;
}

/// Calls use(station, span, way) for each side of a wheel that takes rope in and out of a span: way 1 at its beginning,
/// -1 at its end.
template <class Use>
void each_wheel_side(const Rope& rope, const Use& use) {
  for (const RopeLeg& leg : legs_of(rope))
    for (const auto& [s, way] : {std::pair{leg.from, 1.0}, std::pair{leg.to, -1.0}})
      if (rope.path[s].separates() && rope.path[s].has_wheel())
        use(rope.path[s], static_cast<std::size_t>(leg.span), way);
}

/// Sets stretches, their rates without slip and the grooves. Result: rope that came into each span.
inline std::vector<double> stretch_spans(const AtWork& at, const Rope& rope, const SpansInSpace& reference,
                                         const std::vector<Jet<double>>& free, RopeNow& now) {
  const std::size_t count = free.size();
  for (std::size_t g = 0; g < count; ++g) {
    const double arcs =
        (now.spans.reach[g] - reference.reach[g]).real() - (now.spans.length[g] - reference.length[g]).real();
    now.stretch.push_back(now.spans.length[g].real() + arcs - free[g].value);
    now.rate.push_back(now.spans.reach[g].imag() / kRopeStep - free[g].first);
    now.lengthens.push_back(free[g].first);
  }
  std::vector<double> paid(count, 0.0);
  each_wheel_side(rope, [&](const RopeStation& station, std::size_t g, double way) {
    const double arm = way * station.sense * at.value(station.radius) * station.wheel_sense;
    paid[g] += arm * at.value.position(station.wheel);
    now.lengthens[g] += arm * at.value.velocity(station.wheel);
  });
  const double* slip = at.x.data() + state_of_element(at.c.model, rope);
  for (std::size_t s = 0; s < rope.path.size(); ++s) {
    if (rope.path[s].contact != RopeStation::Contact::rubs) continue;
    GrooveInSpace groove;
    for (const RopeLeg& leg : legs_of(rope)) {
      if (leg.to == s) groove.before = static_cast<std::size_t>(leg.span);
      if (leg.from == s) groove.behind = static_cast<std::size_t>(leg.span);
    }
    groove.grip = std::exp(at.value(rope.path[s].friction) * std::max(now.spans.wraps[s], 0.0));
    now.grooves.push_back(groove);
    now.stretch[groove.before] += *slip;
    now.stretch[groove.behind] -= *slip;
    paid[groove.before] -= *slip;
    paid[groove.behind] += *slip++;
  }
  return paid;
}

/// Where the rope has no way, lifts off taut, or is wound up: legs, pulleys, spans; negative or NaN there.
inline std::vector<double> holds_of(const Rope& rope, const RopeNow& now) {
  std::vector<double> holds = now.spans.rooms;
  for (const RopeLeg& leg : legs_of(rope)) {
    if (rope.path[leg.to].kind != RopeStation::Kind::pulley) continue;
    const double wrap = now.spans.wraps[leg.to], tension = now.tension[static_cast<std::size_t>(leg.span)];
    holds.push_back(wrap >= 0 || tension <= 0 ? 0 : -1);
  }
  for (std::size_t g = 0; g < now.stretch.size(); ++g)
    holds.push_back(std::isfinite(now.stretch[g]) && (!rope.ea || now.length[g] >= 0) ? 0 : -1);
  return holds;
}

inline RopeNow rope_now(const AtWork& at, const Rope& rope) {
  constexpr double kNot = std::numeric_limits<double>::quiet_NaN();
  Motions motions;
  for (const Moving& body : at.bodies) motions.push_back({body.velocity, body.spin});
  std::vector<Moving> then;
  for (const Part& part : at.c.parts.bodies)
    then.push_back({part.axes, part.centre, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  RopeNow now;
  now.still.assign(at.bodies.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  now.spans = spans_in_space({at, rope, at.bodies}, motions);
  const SpansInSpace reference = spans_in_space({at, rope, then, true}, now.still);
  const std::vector<Jet<double>> free = free_lengths(at, rope, reference);
  const std::vector<double> paid = stretch_spans(at, rope, reference, free, now);
  for (std::size_t g = 0; g < free.size(); ++g) {
    const double length = free[g].value + paid[g];
    now.length.push_back(length);
    now.stiffness.push_back(!rope.ea ? at.value(*rope.stiffness) : length > 0 ? at.value(*rope.ea) / length : kNot);
    now.elastic.push_back(now.stiffness[g] * std::max(now.stretch[g], 0.0));
  }
  if (!now.grooves.empty()) {
    const Eigen::VectorXd speeds = slip_speeds(now, *rope.lag, rope.ea.has_value());
    for (std::size_t j = 0; j < now.grooves.size(); ++j) {
      now.slip_rates.push_back(speeds[static_cast<Eigen::Index>(j)]);
      now.rate[now.grooves[j].before] += now.slip_rates[j];
      now.rate[now.grooves[j].behind] -= now.slip_rates[j];
      now.lengthens[now.grooves[j].before] -= now.slip_rates[j];
      now.lengthens[now.grooves[j].behind] += now.slip_rates[j];
    }
  }
  for (std::size_t g = 0; g < free.size(); ++g) {
    // The rate of the strain, times the free length.
    const double stretched = rope.ea ? std::max(now.stretch[g], 0.0) / now.length[g] * now.lengthens[g] : 0.0;
    const double damped = now.stiffness[g] * at.value(rope.damping) * (now.rate[g] - stretched);
    const double tension = now.elastic[g] + std::clamp(damped, -now.elastic[g], now.elastic[g]);
    now.tension.push_back(tension);
  }
  now.holds = holds_of(rope, now);
  for (std::size_t g = 0; g < free.size(); ++g)
    if (now.spans.least[g] < 0 && now.tension[g] > 0) now.tension[g] = kNot;
  return now;
}

inline void apply(const AtWork& at, const Rope& rope, Forces& forces) {
  if (rope.path.empty()) return;  // its first span acts
  const RopeNow now = rope_now(at, rope);
  forces.hold.insert(forces.hold.end(), now.holds.begin(), now.holds.end());
  auto rates = forces.xd.data() + state_of_element(at.c.model, rope);
  for (const double rate : now.slip_rates) *rates++ = rate;
  const RopeInSpace space{at, rope, at.bodies};
  std::vector<int> touched;
  for (const RopeStation& station : rope.path)
    for (const int body : {space.index(station.at.body), space.index(station.carrier)})
      if (std::find(touched.begin(), touched.end(), body) == touched.end()) touched.push_back(body);
  for (const int body : touched) {
    Load load{body, Vector6d::Zero()};
    for (int k = 0; k < 6; ++k) {
      Motions motions = now.still;
      auto& [velocity, spin] = motions[static_cast<std::size_t>(body)];
      (k < 3 ? velocity : spin)[k % 3] = 1;
      const SpansInSpace moved = spans_in_space(space, motions);
      for (std::size_t g = 0; g < now.tension.size(); ++g)
        load.wrench[k] -= now.tension[g] * moved.reach[g].imag() / kRopeStep;
    }
    forces.loads.push_back(load);
  }
  if (!rope.ea) return;
  each_wheel_side(rope, [&](const RopeStation& station, std::size_t g, double way) {
    const double density = now.elastic[g] * now.elastic[g] / (2 * at.value(*rope.ea));
    add_on_coordinate(at, station.wheel, way * station.sense * station.wheel_sense * at.value(station.radius) * density,
                      forces);
  });
}

inline double energy_of(const AtWork& at, const Rope& rope) {
  const auto span = static_cast<std::size_t>(rope.span);
  const RopeNow now = rope_now(at, *(&rope - rope.span));
  const double stretch = std::max(now.stretch[span], 0.0);
  return now.stiffness[span] * stretch * stretch / 2;
}

inline double shown(const AtWork& at, const Forces&, const Rope& rope, int quantity, int) {
  const auto span = static_cast<std::size_t>(rope.span);
  const RopeNow now = rope_now(at, *(&rope - rope.span));
  const double values[] = {now.tension[span], now.spans.length[span].real(), now.stretch[span], now.rate[span],
                           now.spans.wrap[span]};
  return values[quantity];
}

}  // namespace mbgen::cartesian
