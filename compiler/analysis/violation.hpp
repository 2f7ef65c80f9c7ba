#pragma once
// A finite motion of a part of a block, the equations that it opens, and the refusal for them.

#include <string>
#include <vector>

#include "compiler/analysis/part.hpp"

namespace mbgen {

constexpr double kStep = 0.1;             ///< rad, or times the lever arm: far enough to see a residual of second order
constexpr double kShortestStep = 0.005;   ///< below it a motion that cannot be closed is given up
constexpr double kContradiction = 1e-10;  ///< m or 1: rounding leaves 1e-13, closed is 1e-11

/// Share that a residual keeps, over-estimated, on a step of an eighth when equations contradict; less is left when the
/// longer step came to another branch of the equations that were closed.
constexpr double kJump = 1e-5;

/// How far an equation opened on a finite motion.
struct Violation {
  int equation = 0;           ///< row of the block
  double residual = 0;        ///< m or 1
  int coordinate = 0;         ///< tree index of the coordinate that moved most
  double motion = 0;          ///< of it, rad or m
  bool second_order = false;  ///< it opens with the square of the motion: nothing hinders the first bit of it
};

/// Changes the joints of a part by `direction` (free of units, per column of the part).
void move(const LoopBlock& block, const PartView& view, const Eigen::VectorXd& direction, std::vector<double>& z);

/// Largest change of a joint of the part between two positions, free of units; its tree index goes to `coordinate`.
double distance(const LoopBlock& block, const PartView& view, const std::vector<double>& from,
                const std::vector<double>& to, int& coordinate);

/// `loop "a"` or `loops "a", "b"`.
std::string loops_text(const Topology& topology, const std::vector<int>& loops);

/// The diagnostic for an equation that opens: at the joint whose axis is off, else at the loop that has the equation.
/// fault: the loops and their fault, in words.
Diagnostic refusal(const Model& model, const Topology& topology, const std::vector<int>& loops,
                   const std::string& fault, const Violation& violation, const ClosureEquation& equation);

}  // namespace mbgen
