#pragma once
// Loops whose ends do not meet as written are closed by moving the joints, as a start is assembled. Of no format:
// bodies are indices of poses.

#include <limits>
#include <map>

#include "compiler/import/assembly.hpp"

namespace mbgen::importing {

/// Two frames that a loop brings together.
struct LoopEnds {
  JointType type = JointType::fixed;
  Isometry3d from = Isometry3d::Identity(), to = Isometry3d::Identity();
  Vector3d axis{1, 0, 0};  ///< unit, in both frames
};

/// Gap of a loop: m, then rad.
struct Gap {
  Vector3d apart = Vector3d::Zero(), turned = Vector3d::Zero();
  bool is_below(double length, double angle) const { return apart.norm() <= length && turned.norm() <= angle; }
};

/// Of the ends of a loop, both in the same frame, in the axes of its frame on `from`.
Gap gap_between(const LoopEnds& ends);

/// A joint of the tree. One of several coordinates moves, too; it has no position.
struct ChainJoint {
  std::string name;  ///< for messages
  JointType type = JointType::fixed;
  int from = -1, to = -1;
  Isometry3d start = Isometry3d::Identity();                                ///< its frame in `from`
  Isometry3d end = Isometry3d::Identity();                                  ///< `to` in its frame at zero
  Vector3d axis{1, 0, 0};                                                   ///< unit, in its frame
  double position = 0;                                                      ///< rad or m
  double lower = -std::numeric_limits<double>::infinity(), upper = -lower;  ///< rad or m
  int leader = -1;                    ///< joint that it follows; circles of leaders are not allowed
  std::vector<double> relation = {};  ///< position = sum of relation[k] (leader's position)^k; alone without a leader
};

struct ChainLoop {
  std::string name;
  int from = -1, to = -1;
  LoopEnds ends;  ///< in the bodies
};

/// A mechanism as a tree of joints and the loops that close it.
struct Chain {
  std::vector<ChainJoint> joints;  ///< in any order; a body that is `to` of none stays where it is
  std::vector<Isometry3d> poses;   ///< of the bodies, global
  std::vector<ChainLoop> loops;
};

struct Closed {
  bool has_moved = false;  ///< loops or relations were open, and all close now
  double widest = 0;       ///< m, the largest gap as written
  double remaining = 0;    ///< m, the largest gap that is left
  std::string moves = {};  ///< `, "knee" by 0.3 rad` for the first joints that were moved
  std::map<std::string, std::string, std::less<>> left_open = {};  ///< by loop: how far no position closes it
};

/// Closes loops that are open as written by moving the joints of the tree, within their limits and as little as will
/// do: positions and poses are set. Where that fails all stays as it was, and left_open names what stays open. A gap
/// below 2 mm and 5e-3 rad that no joint closes may be left. Cost: some hundred factorisations of loops by joints.
Closed close_chain(Chain& chain);

/// The note about joints that were moved.
void note_moves(Reading& reading, Spot spot, const Closed& closed, const std::string& hint);

}  // namespace mbgen::importing
