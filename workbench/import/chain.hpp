#pragma once
// Format-independent mechanism: a tree of joints with the loops that close it; bodies are indices of poses.

#include <limits>

#include "workbench/import/assembly.hpp"

namespace mbgen::importing {

/// Two frames that coincide in a closed loop.
struct LoopEnds {
  JointType type = JointType::fixed;
  Isometry3d from = Isometry3d::Identity(), to = Isometry3d::Identity();
  Vector3d axis{1, 0, 0};  ///< unit, in both frames; of a universal joint in `from` alone
  Vector3d far{0, 1, 0};   ///< of a universal joint: its axis in `to`, at a right angle to the other one
};

/// Gap of a loop: m, then rad.
struct Gap {
  Vector3d apart = Vector3d::Zero(), turned = Vector3d::Zero();
  bool is_below(double length, double angle) const { return apart.norm() <= length && turned.norm() <= angle; }
};

/// Gap between the ends of a loop, both in the same frame, in the axes of its frame on `from`.
Gap gap_between(const LoopEnds& ends);

/// A joint of the tree. A joint of several coordinates moves too, but has no position.
struct ChainJoint {
  std::string name;  ///< for messages
  JointType type = JointType::fixed;
  int from = -1, to = -1;
  Isometry3d start = Isometry3d::Identity();                                ///< its frame in `from`
  Isometry3d end = Isometry3d::Identity();                                  ///< `to` in its frame at zero
  Vector3d axis{1, 0, 0};                                                   ///< unit, in its frame
  double position = 0;                                                      ///< rad or m
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;  ///< rad or m
  int leader = -1;                                                          ///< joint that it follows; no cycles
  std::vector<double> relation =
      {};  ///< position = sum of relation[k] (leader's position)^k; one term without a leader
};

struct ChainLoop {
  std::string name;
  int from = -1, to = -1;
  LoopEnds ends;  ///< in the bodies
};

/// A mechanism as a tree of joints and the loops that close it.
struct Chain {
  std::vector<ChainJoint> joints;  ///< in any order; a body that is `to` of no joint is fixed
  std::vector<Isometry3d> poses;   ///< of the bodies, global
  std::vector<ChainLoop> loops;
};

}  // namespace mbgen::importing
