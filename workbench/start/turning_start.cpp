#include "workbench/start/turning_start.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "compiler/text/user_error.hpp"
#include "compiler/topology/poles.hpp"

namespace mbgen {
namespace {

using Axis = Eigen::Map<const Eigen::Vector3d>;
using Axes = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

int ball_of(const Topology& topology, int joint) {
  const auto is_it = [&](const Ball& ball) { return topology.bodies[ball.coordinate[0]].joint == joint; };
  const auto found = std::find_if(topology.balls.begin(), topology.balls.end(), is_it);
  return found == topology.balls.end() ? -1 : static_cast<int>(found - topology.balls.begin());
}

[[noreturn]] void refuse(const Compilation& compilation, const InitialTurning& turning) {
  const std::string& name = compilation.model.joints[static_cast<std::size_t>(turning.joint)].name;
  std::string why = "no others can be taken";
  for (const RealPole& real : real_poles(compilation.model, compilation.topology))
    if (real.joint == turning.joint) why = fmt::format("{} is on {}, so that {}", real.user, real.coordinate, why);
  throw UserError(Diagnostics{
      {turning.where, fmt::format("the angles of joint \"{}\" are at their pole here and have no rates: {}", name, why),
       "give the joint another \"sequence\"", ""}});
}

/// The turn of a ball at angles of chart 0, with the angular velocity that is asked for. The tree may run from `to` to
/// `from`: then the ball turns `from` against `to`, as the axes of `to` see it.
ball_detail::Turn<double> turn_at(const Compilation& compilation, const InitialTurning& turning, const Ball& ball,
                                  const GenericState& state) {
  using namespace ball_detail;
  const TreeBody& first = compilation.topology.bodies[ball.coordinate[0]];
  const TreeBody& second = compilation.topology.bodies[ball.coordinate[1]];
  const Joint& joint = compilation.model.joints[static_cast<std::size_t>(turning.joint)];
  const Body& from = compilation.model.bodies[static_cast<std::size_t>(joint.from.body)];
  const Eigen::Vector3d velocity = Axes(from.pose.rotation.data()) * Axis(turning.angular_velocity.data());
  const Axis one(first.axis.data()), two(second.axis.data());
  const double along[] = {one.dot(velocity), two.dot(velocity), one.cross(two).dot(velocity)};
  const double* none = nullptr;
  Turn<double> turn = turn_of(read(ball, state.z.data(), none, none));
  for (int row = 0; row < 3; ++row) {
    const double* r = turn.row[row];
    turn.velocity[row] = first.reversed ? -(r[0] * along[0] + r[1] * along[1] + r[2] * along[2]) : along[row];
  }
  return turn;
}

}  // namespace

std::vector<TurningRate> turning_rates(const Compilation& compilation, GenericState& state) {
  const std::vector<Ball>& balls = compilation.topology.balls;
  std::vector<TurningRate> rates;
  for (const InitialTurning& turning : compilation.model.initial.turnings) {
    const int b = ball_of(compilation.topology, turning.joint);
    if (b < 0) refuse(compilation, turning);
    const Ball& ball = balls[static_cast<std::size_t>(b)];
    ball_detail::Turn<double> turn = turn_at(compilation, turning, ball, state);
    if (leaves_chart(ball, 0.0, state.z.data())) {
      state.charts.resize(balls.size(), 0.0);
      state.charts[static_cast<std::size_t>(b)] = 1;
      ball_detail::take_over(turn, 1.0);
    }
    const ball_detail::Angles<double> angles = ball_detail::angles_of(turn);
    std::vector<double> zd(state.z.size(), 0.0);
    ball_detail::write(ball, angles, state.z.data(), zd.data(), static_cast<double*>(nullptr));
    for (const int i : ball.coordinate) rates.push_back({i, zd[static_cast<std::size_t>(i)], &turning});
  }
  return rates;
}

}  // namespace mbgen
