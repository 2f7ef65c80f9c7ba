// The equations of cut joints by name.
#include "compiler/model/model.hpp"

namespace mbgen {

std::span<const ClosureRow> closure_rows(JointType type) {
  static constexpr ClosureRow kPoint[] = {{"x", "N"},        {"y", "N"},        {"z", "N"},
                                          {"axis_1", "N m"}, {"axis_2", "N m"}, {"twist", "N m"}};
  static constexpr ClosureRow kUniversal[] = {{"x", "N"}, {"y", "N"}, {"z", "N"}, {"perpendicular", "N m"}};
  static constexpr ClosureRow kHomokinetic[] = {{"x", "N"}, {"y", "N"}, {"z", "N"}, {"twist", "N m"}};
  static constexpr ClosureRow kAlong[] = {
      {"across_1", "N"}, {"across_2", "N"}, {"axis_1", "N m"}, {"axis_2", "N m"}, {"twist", "N m"}};
  static constexpr ClosureRow kPlanar[] = {{"plane", "N"}, {"axis_1", "N m"}, {"axis_2", "N m"}};
  static constexpr ClosureRow kDisc[] = {{"normal", "N"}, {"longitudinal", "N", true}, {"lateral", "N", true}};
  static constexpr ClosureRow kBall[] = {{"normal", "N"}, {"tangent_1", "N", true}, {"tangent_2", "N", true}};
  const std::span<const ClosureRow> point(kPoint), along(kAlong);
  switch (type) {
    case JointType::spherical:
      return point.first(3);
    case JointType::revolute:
      return point.first(5);
    case JointType::fixed:
      return point;
    case JointType::universal:
      return kUniversal;
    case JointType::cylindrical:
      return along.first(4);
    case JointType::prismatic:
      return along;
    case JointType::planar:
      return kPlanar;
    case JointType::point_on_line:
      return along.first(2);
    case JointType::point_on_plane:
      return std::span<const ClosureRow>(kPlanar).first(1);
    case JointType::parallel_axes:
      return point.subspan(3, 2);
    case JointType::orientation:
      return point.last(3);
    case JointType::homokinetic:
      return kHomokinetic;
    case JointType::rolling_disc:
      return kDisc;
    case JointType::rolling_ball:
      return kBall;
    case JointType::knife_edge:
      return std::span<const ClosureRow>(kDisc).last(1);
    case JointType::free:
      break;
  }
  return {};
}

}  // namespace mbgen
