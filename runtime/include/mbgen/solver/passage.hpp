#pragma once
// The motion of loop blocks through a singular position, for one step: positions of their coordinates as polynomials,
// from closed positions on both sides. See passing.hpp.

namespace mbgen {

/// Most evaluations of the closures in a step of a generated solver: in its projection, and, where it is taken again
/// with care, in the projections of all stages and for nodes around a singular position. From here on it fails.
constexpr int kStepClosures = 36;
/// Of them at most for one look at a passage, so that a step near a singular position that it does not pass keeps
/// enough.
constexpr int kLookClosures = 20;
/// Coefficients of a position: even and odd parts of a polynomial of degree five.
constexpr int kPassageTerms = 6;
/// Most nodes around a singular position of a generated solver: two, and four for blocks with several free directions.
constexpr int kPassageNodes = 4;

/// Spacings of the nodes that are tried at most.
constexpr int kPassageTries = 3;

/// Blocks of a solver with N coordinates, B loop blocks and P numbers of Rz. The parameter of all polynomials is the
/// time of a straight motion of the free coordinates, over `spacing`, from -1 to 1 between the inner nodes.
template <class Real, int N, int B, int P>
struct Passage {
  int closures = 0;          ///< evaluations of the closures that are left to the step
  unsigned char crosses[B];  ///< per block, whether it goes by the passage
  int lead[B];               ///< free coordinate by whose position the parameter is known, -1: by the time
  double lead_start[B];      ///< rad or m, its position in the middle
  double lead_rate[B];       ///< rad/s or m/s, its velocity there
  bool is_led[B];            ///< it is the only free direction, without motions: Rz is the velocity over its rate
  unsigned char is_free[N];  ///< per coordinate, whether it is a free one of a block that crosses
  bool is_met = false;       ///< the middle is at the singular position, not only near it
  double t = 0;              ///< s, the middle
  double spacing = 0;        ///< s, of the inner nodes; 0: no passage is known
  Real position[kPassageTerms][N];  ///< by powers of the parameter
  Real rz[kPassageNodes][P];        ///< likewise, of blocks that are not led
};

}  // namespace mbgen
