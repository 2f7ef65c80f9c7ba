#pragma once
// A judge of its own in complex numbers: Newton-Euler equations of the tree at the global origin with multipliers of
// every closure. A step of 1e-30 i leaves no error of truncation and none of cancellation. Source: W. Squire, G. Trapp,
// Using Complex Variables to Estimate Derivatives of Real Functions, SIAM Review 40, 1998.

#include <Eigen/Dense>
#include <complex>
#include <map>
#include <vector>

#include "compiler/topology/topology.hpp"
#include "tests/system/property/random_mechanism.hpp"

namespace mbgen::testing::complex_step {

using Number = std::complex<double>;
using Vector = Eigen::Matrix<Number, 3, 1>;
using Turn = Eigen::Matrix<Number, 3, 3>;
using Twist = Eigen::Matrix<Number, 6, 1>;  ///< turning first, then the point of the body at the global origin
using Numbers = Eigen::VectorX<Number>;
using Matrix = Eigen::MatrixX<Number>;

constexpr double kStep = 1e-30;

/// Numbers of a mechanism that derivatives are taken by.
struct Varied {
  Number gravity, mass, stiffness;  ///< of all; of body 0; of link 0
  Number hook = 0, pin = 0;         ///< m, by which the start of link 0 and the point of the last joint move along x
};

/// The body that a tree body is a part of, seen at the global origin.
struct Seen {
  Turn turn = Turn::Identity();  ///< a point r of the reference is at turn r + shift
  Vector shift = Vector::Zero();
  Twist velocity = Twist::Zero(), bias = Twist::Zero();  ///< bias: of the acceleration without zdd
  std::vector<int> path;                                 ///< tree bodies from the root to it
};

/// One way to say the equations of motion; nothing of it is mbgen's but the tree.
class ComplexJudge {
 public:
  ComplexJudge(const RandomMechanism& random, const Topology& topology, const Varied& varied)
      : random_(random), topology_(topology), varied_(varied) {}

  Numbers accelerations(const Numbers& z, const Numbers& zd, const std::vector<double>& tau);
  /// Moves a state that nearly closes to the nearest one that does.
  void close(Numbers& z, Numbers& zd);
  /// A step of h seconds by Runge-Kutta, closed.
  void step(Numbers& z, Numbers& zd, double h);

 private:
  bool is_in_tree(int joint) const;
  const Seen& body(int index) const { return index == kOnGround ? ground_ : seen_[place_.at(index)]; }
  Vector pin_of(const RandomJoint& joint) const;
  Vector start_of(std::size_t link) const;
  void see(const Numbers& z, const Numbers& zd);
  void push(const Seen& seen, const Twist& wrench);
  void add_body(int index);
  void add_link(std::size_t k);
  void add_row(const Seen& a, const Vector& from, const Seen& b, const Vector& to, const Vector& direction, Number side,
               Number gap);
  void add_joint(const RandomJoint& joint);
  /// The shortest vector with these products with the rows.
  Numbers shortest(const Numbers& products) const;
  Matrix all_rows() const;

  const RandomMechanism& random_;
  const Topology& topology_;
  Varied varied_;
  Seen ground_;
  std::vector<Seen> seen_;
  std::vector<Twist> along_;
  std::map<int, std::size_t> place_;  ///< tree body of each body
  Matrix mass_;
  Numbers force_;
  std::vector<Numbers> rows_;
  std::vector<Number> sides_, gaps_;  ///< per row: its product with the accelerations; the residual of the closure
};

}  // namespace mbgen::testing::complex_step
