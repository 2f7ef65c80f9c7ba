#pragma once
// Which frame carries which body: the choice of axes and origins that keeps the equations small and well conditioned.

#include <string>
#include <vector>

#include "compiler/topology/topology.hpp"

namespace mbgen {

/// Frame choice of a tree body. A frame is named by its body; kGround is the global frame. All frames are parallel to
/// the global axes at the reference configuration; the origin of body i's frame is the point of joint i.
struct BodyLayout {
  bool own_frame =
      false;  ///< inertia and forces of the body are held in its own frame (a base), else in the frame of `base`
  int base = kGround;         ///< nearest frame body below this one
  int joint_frame = kGround;  ///< frame of the axis of joint i: its base, or the own body that its chain leads to
  int chain_start = -1;  ///< for an own body whose joints are in its frame: first body of the chain of joints, else -1
  bool rotor = false;    ///< symmetric about its joint axis: its inertia needs no rotation
};

struct Layout {
  std::vector<BodyLayout> bodies;
  /// Frame in which inertias and forces of body i are accumulated; kGround for kGround.
  int frame_of(int body) const { return body == kGround ? kGround : bodies[body].own_frame ? body : bodies[body].base; }
};

/// Which bodies outside loop blocks have frames of their own.
enum class Frames {
  few,  ///< where it saves work on accumulated inertias: the matrix form
  own,  ///< all but rotors, whose inertia their base holds: the recursive form
  all   ///< rotors as well
};

/// Per tree body: a force element or a rod holds on to it.
std::vector<bool> loaded_bodies(const Model& model, const Topology& topology);

/// Chooses the frames: own frames for block bases, for the first massive or branching body above ground (so that the
/// far inertial origin never enters) and for massive branching bodies outside loop blocks. Source:
/// docs/method/recursive.md, "What keeps it small".
Layout choose_layout(const Model& model, const Topology& topology, Frames frames = Frames::few);

}  // namespace mbgen
