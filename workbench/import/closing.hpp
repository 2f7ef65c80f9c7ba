#pragma once
// Open loops are closed by moving the joints, in the same way as a start is assembled.

#include <map>

#include "workbench/import/chain.hpp"

namespace mbgen::importing {

struct Closed {
  bool has_moved = false;                      ///< loops or relations were open, and all are closed now
  double widest = 0, widest_turned = 0;        ///< m and rad, largest gaps as written
  double remaining = 0, remaining_turned = 0;  ///< m and rad, largest remaining gaps
  std::string moves = {};                      ///< `, "knee" by 0.3 rad` for the first moved joints
  std::map<std::string, std::string, std::less<>> left_open = {};  ///< by loop: remaining gap
};

/// Closes loops that are open as written by moving the joints of the tree, within their limits and as little as will
/// do: positions and poses are set. Where that fails all stays as it was, and left_open names what stays open. A gap
/// below 2 mm and 5e-3 rad that no joint closes may be left, and moves no joint further than it explains. Cost: some
/// hundred factorisations of loops by joints.
Closed close_chain(Chain& chain);

/// The note about joints that were moved, for loops or for relations alone, and gaps that remain.
void note_moves(Reading& reading, Spot spot, const Closed& closed, const std::string& hint);

/// Makes the axis of a revolute joint that closes a planar loop parallel to all others of the loop where it is tilted
/// by less than 5e-3 rad: tilted, it would hold the loop. Notes the angle.
void align_closing_axes(Reading& reading, Spot spot, Assembly& assembly);

}  // namespace mbgen::importing
