#pragma once
// Random mechanisms as values: made from a seed, transformed, shrunk and written as model files.

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace mbgen::testing {

using Point = std::array<double, 3>;

inline Point plus(Point a, const Point& b) {
  for (int i = 0; i < 3; ++i) a[i] += b[i];
  return a;
}

inline Point times(double factor, Point a) {
  for (double& component : a) component *= factor;
  return a;
}

/// A direction across another.
inline Point across(const Point& axis) {
  Point result = std::abs(axis[0]) < 0.6 ? Point{0, -axis[2], axis[1]} : Point{-axis[1], axis[0], 0};
  const double length = std::hypot(result[0], result[1], result[2]);
  for (double& component : result) component /= length;
  return result;
}

inline bool rolls(const std::string& type) {
  return type == "rolling_disc" || type == "rolling_ball" || type == "knife_edge";
}

constexpr int kOnGround = -1;
constexpr double kFreeLength = 0.2;  ///< of every spring, m

struct RandomBody {
  std::string name;
  double mass = 1;  ///< kg, 0: a massless link
  Point com{};
  std::array<double, 6> inertia{0.1, 0.1, 0.1, 0, 0, 0};  ///< xx yy zz xy xz yz, about the centre of mass
};

struct RandomJoint {
  std::string name, type;
  int from = kOnGround, to = 0;  ///< bodies
  Point at{}, axis{0, 0, 1};
  bool cut = false;
  double swing = 0;  ///< rad or m, of one that a motion drives
  double stop = 0;   ///< N/m or N m/rad, of a plain one: a bump stop begins near the reference
  double grip = 0;   ///< N or N m, of a plain one: it sticks by bristles
};

/// A rod, or a spring where it has a stiffness.
struct RandomLink {
  std::string name;
  int from = kOnGround, to = 0;
  Point start{}, end{};
  double mass = 0;
  double stiffness = 0;
  double stroke = 0;      ///< m, of a rod that is an actuator
  double oil = 0;         ///< N/m/s, of a spring: its stretch fills a state that pulls along with it
  double stop = 0;        ///< N/m, of a spring: a bump stop begins near the reference
  double grip = 0;        ///< of a spring: coefficient of friction of its bristles, which its own force presses
  std::string felt = {};  ///< plain joint whose coordinate the state of the spring follows, too; "" for none
};

/// A bushing of constant stiffnesses, N/m and N m/rad.
struct RandomBushing {
  std::string name;
  int from = kOnGround, to = 0;
  Point at{}, axis{0, 0, 1}, axis2{1, 0, 0};
  std::array<double, 6> stiffness{};
};

/// A sphere at `start` on a surface at `end` that stands across the way between them, which it enters by a tenth of its
/// distance. Shapes: plane, sphere, cylinder, infinite cylinder, box.
struct RandomContact {
  std::string name;
  int from = kOnGround, to = 0;
  Point start{}, end{}, axis{0, 0, 1}, axis2{1, 0, 0};
  int shape = 0;
  double stiffness = 0;  ///< N/m
};

/// A relation between the coordinates of joints that holds at the reference: an expression, or the first one as a
/// spline over the second.
struct RandomRelation {
  std::string name, text;
  std::vector<std::string> joints;                 ///< whose coordinates they are
  std::vector<std::array<double, 2>> points = {};  ///< of the spline
  bool periodic = false;                           ///< the spline
};

/// All points in global axes at the reference; no damping but of stops and bristles, no motions but those of actuators
/// and of cut joints.
struct RandomMechanism {
  std::uint64_t seed = 0;
  Point gravity{0, 0, -9.81};
  std::vector<RandomBody> bodies;
  std::vector<RandomJoint> joints;
  std::vector<RandomLink> links;
  std::vector<RandomRelation> relations = {};
  std::vector<RandomBushing> bushings = {};
  std::vector<RandomContact> contacts = {};
};

/// Kinds of mechanisms that a seed may ask for.
enum class Family {
  tree,
  deep_chain,      ///< up to 60 joints
  closed_chain,    ///< by a spherical joint or another one, to a body or to ground
  planar_loops,    ///< four-bars with redundant equations, on a moving base
  rods,            ///< with and without mass, several in one block
  actuators,       ///< rods without mass whose lengths are given over time, and others
  massless_links,  ///< between massive bodies
  floating,        ///< a free base without gravity
  coupled,         ///< trees and chains of four with relations between two or three coordinates, linear or not
  tiny,            ///< one body or none
  locked,          ///< overconstrained linkages that move by their geometry, and structures, beside a part that moves
  mirror_halves,   ///< a left half and its mirror image on a base between them
  nearly_mirror_halves,  ///< the same, but for one number
  equal_legs,            ///< three equal legs, a third of a turn apart, under a platform
  equal_cells,           ///< a row of equal four-bars on a base
  alike_cells,           ///< the same with masses of their own
  rolling,               ///< a free body with a tail, on discs, balls and blades that roll on ground or a moving body
  guided_rolling,        ///< the same on one contact, guided by a plane that holds what rolling holds again
  by_equations,          ///< closed by joints that have no coordinates: points on lines and planes, directions, shafts
  driven_cuts,           ///< chains that a joint closes which is driven where it is cut
  coupled_joints         ///< joints of several coordinates, any of which are in relations with others further out
};

RandomMechanism random_mechanism(Family family, std::uint64_t seed);

/// A closed chain of six pins whose axes are three random lines and their images under a half turn about a line: it has
/// one freedom. Source: R. Bricard, "Lecons de cinematique" II, 1927, the line-symmetric case.
RandomMechanism random_bricard(std::uint64_t seed);

/// The model file. Outputs: velocity of each body's centre of mass (x, y, z), then the energy of springs and bushings
/// where nothing is driven.
std::string model_text(const RandomMechanism& mechanism);

/// True where an actuator, a motion or a state does work, or a stop or bristles take it.
bool is_driven(const RandomMechanism& mechanism);

/// True where forces have corners: bump stops, bristles, contacts.
bool has_corners(const RandomMechanism& mechanism);

/// Smaller or simpler mechanisms, the smallest first.
std::vector<RandomMechanism> simpler(const RandomMechanism& mechanism);

/// Every point r becomes R r + t, every direction R d; rotation: row by row.
RandomMechanism moved(RandomMechanism mechanism, const std::array<Point, 3>& rotation, const Point& translation);

/// The mirror image in the plane y = 0, with axes that keep every coordinate. Requires: revolute and prismatic joints.
RandomMechanism mirrored(RandomMechanism mechanism);

/// Bodies, joints and links in another order.
RandomMechanism renumbered(RandomMechanism mechanism, std::uint64_t seed);

/// Whether all coordinates belong to axes of the file: revolute and prismatic joints, and cuts of any kind that look at
/// points and axes only.
bool has_plain_joints(const RandomMechanism& mechanism);

/// Whether the last six joints, a closed chain of pins, leave one motion at the reference and not two: with four
/// parallel axes and two others across it may stand where two of its ways meet. A loop through both of them is rigid,
/// but not against the first bit of a motion.
bool has_one_way(const RandomMechanism& mechanism);

}  // namespace mbgen::testing
