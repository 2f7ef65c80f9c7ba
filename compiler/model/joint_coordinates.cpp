#include "compiler/model/bodies.hpp"

namespace mbgen {
namespace {

constexpr JointCoordinates kCoordinates[] = {
    {JointType::revolute, "", "NAME", "about axis"},
    {JointType::prismatic, "", "NAME", "along axis"},
    {JointType::cylindrical, R"("axis": "y")", "NAME_ty, NAME_ry", "along axis, about axis"},
    {JointType::cylindrical, R"("axis": [0, 0.6, 0.8])", "NAME_tz, NAME_rz", "along axis, about axis"},
    {JointType::universal, R"("axis": "x", "axis2": "y")", "NAME_rx, NAME_ry", "about axis, about axis2"},
    {JointType::universal, R"("axis": "x", "axis2": [0, 0.6, 0.8])", "NAME_r1, NAME_r2", "about axis, about axis2"},
    {JointType::spherical, "", "NAME_rz, NAME_ry, NAME_rx", "about z, about y, about x"},
    {JointType::spherical, R"("sequence": "xyz")", "NAME_rx, NAME_ry, NAME_rz", "about x, about y, about z"},
    {JointType::planar, R"("axis": "x")", "NAME_ty, NAME_tz, NAME_rx", "along y, along z, about axis"},
    {JointType::planar, R"("axis": "y")", "NAME_tz, NAME_tx, NAME_ry", "along z, along x, about axis"},
    {JointType::planar, R"("axis": "z")", "NAME_tx, NAME_ty, NAME_rz", "along x, along y, about axis"},
    {JointType::planar, R"("axis": [0.6, 0, 0.8])", "NAME_t1, NAME_t2, NAME_rz", "along e, along axis x e, about axis"},
    {JointType::free, "", "NAME_tx, NAME_ty, NAME_tz, NAME_rz, NAME_ry, NAME_rx",
     "along x, along y, along z, about z, about y, about x"},
    {JointType::fixed, "", "", ""},
};

}  // namespace

std::span<const JointCoordinates> joint_coordinates() { return kCoordinates; }

}  // namespace mbgen
