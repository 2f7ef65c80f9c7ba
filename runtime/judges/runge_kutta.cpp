#include "runtime/judges/runge_kutta.hpp"

namespace mbgen {
namespace {

/// All rates of one stage.
struct Stage {
  std::vector<CartesianBody> motion;  ///< velocity and spin of the bodies, attitude: rate of the quaternion
  CartesianRates rates;
};

/// Adds `weight` (s) times a stage to a state.
void add(const Stage& stage, double weight, CartesianState& state) {
  for (std::size_t b = 0; b < state.bodies.size(); ++b) {
    CartesianBody& body = state.bodies[b];
    const CartesianBody& rate = stage.motion[b];
    body.position += weight * rate.velocity;
    body.attitude.coeffs() += weight * rate.attitude.coeffs();
    body.velocity += weight * stage.rates.qdd.segment<3>(6 * static_cast<Eigen::Index>(b));
    body.spin += weight * stage.rates.qdd.segment<3>(6 * static_cast<Eigen::Index>(b) + 3);
  }
  for (std::size_t i = 0; i < state.x.size(); ++i) state.x[i] += weight * stage.rates.xd[i];
}

void normalise(CartesianState& state) {
  for (CartesianBody& body : state.bodies) body.attitude.normalize();
}

Status evaluate(const CartesianDerivative& derivative, const CartesianState& state, Stage& stage) {
  stage.motion = state.bodies;
  for (CartesianBody& body : stage.motion) {
    const Eigen::Quaterniond spin(0, body.spin.x(), body.spin.y(), body.spin.z());
    body.attitude.coeffs() = 0.5 * (spin * body.attitude).coeffs();
  }
  return derivative(state, stage.rates);
}

}  // namespace

Status runge_kutta_step(const CartesianDerivative& derivative, CartesianState& state, double h) {
  const double reach[] = {0, h / 2, h / 2, h}, share[] = {h / 6, h / 3, h / 3, h / 6};
  CartesianState result = state;
  Stage stage;
  for (int k = 0; k < 4; ++k) {
    CartesianState at = state;
    at.t = state.t + reach[k];
    if (k > 0) add(stage, reach[k], at);
    normalise(at);
    if (const Status status = evaluate(derivative, at, stage); !status.ok()) return status;
    add(stage, share[k], result);
  }
  normalise(result);
  result.t = state.t + h;
  state = std::move(result);
  return {};
}

}  // namespace mbgen
