// MuJoCo against mbgen's import of the same robot's file: accelerations at random states. Both read the file from the
// disk, so that nothing of mbgen stands between it and MuJoCo.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstdio>
#include <map>
#include <sstream>

#include "compiler/algebra/dense.hpp"
#include "compiler/reader/read_model.hpp"
#include "tests/import/import_support.hpp"
#include "workbench/import/known.hpp"

namespace mbgen {
namespace {

using namespace mbgen::testing;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// MuJoCo's model of the file, without contact, limits and friction.
struct MujocoRobot {
  std::unique_ptr<mjModel, void (*)(mjModel*)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data{nullptr, mj_deleteData};

  explicit MujocoRobot(const std::string& name) {
    char error[1000] = "";
    model.reset(mj_loadXML(source_path("tests/import/" + name).c_str(), nullptr, error, sizeof error));
    if (!model) throw std::runtime_error(error);
    model->opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_FRICTIONLOSS;
    model->opt.jacobian = mjJAC_DENSE;
    data.reset(mj_makeData(model.get()));
  }
};

/// Motion of a spherical or free joint: angles in the order x, y, z of the axes they turn about first, second, third.
struct Turning {
  Matrix3d rotation = Matrix3d::Identity();
  Vector3d omega = Vector3d::Zero(), alpha = Vector3d::Zero();  ///< in the axes of the frame that carries the joint
};

/// Three turns about moving axes: z, y, x. Source: differentiated twice by hand.
Turning turning(const Vector3d& z, const Vector3d& zd, const Vector3d& zdd) {
  const std::array<Vector3d, 3> letters = {Vector3d::UnitZ(), Vector3d::UnitY(), Vector3d::UnitX()};
  Turning t;
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = t.rotation * letters[i];
    t.alpha += axis * zdd[i] + t.omega.cross(axis) * zd[i];
    t.omega += axis * zd[i];
    t.rotation = t.rotation * Eigen::AngleAxisd(z[i], letters[i]).toRotationMatrix();
  }
  return t;
}

/// The state of mbgen's model in MuJoCo's coordinates, and its accelerations in MuJoCo's.
struct Translation {
  const Mechanism& mechanism;
  const MujocoRobot& robot;
  std::map<std::string, double> zeros = {};  ///< MuJoCo's coordinates where the model's are zero, unless at its qpos0

  std::size_t coordinate(const std::string& name) const {
    for (std::size_t i = 0; i < mechanism.topology.bodies.size(); ++i)
      if (mechanism.topology.bodies[i].coordinate == name) return i;
    throw std::runtime_error("no coordinate " + name);
  }
  Vector3d three(const std::vector<double>& values, const std::string& joint,
                 const std::array<const char*, 3>& ends) const {
    Vector3d v;
    for (int i = 0; i < 3; ++i) v[i] = values[coordinate(joint + ends[i])];
    return v;
  }

  /// z, zd into qpos and qvel; the accelerations that are zdd. Sets the coordinates of `data`.
  VectorXd set(const GenericState& state, const std::vector<double>& zdd) const {
    const mjModel* m = robot.model.get();
    mjData* d = robot.data.get();
    mj_resetData(m, d);
    VectorXd acceleration = VectorXd::Zero(m->nv);
    for (int j = 0; j < m->njnt; ++j) {
      const std::string name = mj_id2name(m, mjOBJ_JOINT, j);
      const int q = m->jnt_qposadr[j], v = m->jnt_dofadr[j];
      if (m->jnt_type[j] == mjJNT_HINGE || m->jnt_type[j] == mjJNT_SLIDE) {
        const std::size_t i = coordinate(name);
        const auto zero = zeros.find(name);
        d->qpos[q] = (zero == zeros.end() ? m->qpos0[q] : zero->second) + state.z[i];
        d->qvel[v] = state.zd[i];
        acceleration[v] = zdd[i];
        continue;
      }
      const bool is_free = m->jnt_type[j] == mjJNT_FREE;
      if (is_free) {
        const std::array<const char*, 3> slides = {"_tx", "_ty", "_tz"};
        const Vector3d t = three(state.z, name, slides), td = three(state.zd, name, slides),
                       tdd = three(zdd, name, slides);
        for (int i = 0; i < 3; ++i) {
          d->qpos[q + i] = m->qpos0[q + i] + t[i];
          d->qvel[v + i] = td[i];
          acceleration[v + i] = tdd[i];
        }
      }
      const int body = m->jnt_bodyid[j];
      const mjtNum* r = is_free ? m->qpos0 + q + 3 : m->body_quat + 4 * body;
      const Quaterniond reference(r[0], r[1], r[2], r[3]);
      const std::array<const char*, 3> turns = {"_rz", "_ry", "_rx"};
      const Turning t = turning(three(state.z, name, turns), three(state.zd, name, turns), three(zdd, name, turns));
      const Matrix3d now = t.rotation * reference.toRotationMatrix();
      const Quaterniond quaternion(is_free ? now : Matrix3d(reference.toRotationMatrix().transpose() * now));
      const Vector3d omega = now.transpose() * t.omega, alpha = now.transpose() * t.alpha;
      const int to_q = is_free ? q + 3 : q, to_v = is_free ? v + 3 : v;
      const std::array<double, 4> wxyz = {quaternion.w(), quaternion.x(), quaternion.y(), quaternion.z()};
      for (int i = 0; i < 4; ++i) d->qpos[to_q + i] = wxyz[i];
      for (int i = 0; i < 3; ++i) {
        d->qvel[to_v + i] = omega[i];
        acceleration[to_v + i] = alpha[i];
      }
    }
    return acceleration;
  }

  /// Generalised forces on hinges and slides.
  void apply(const std::vector<double>& tau) const {
    const mjModel* m = robot.model.get();
    for (int j = 0; j < m->njnt; ++j)
      if (m->jnt_type[j] == mjJNT_HINGE || m->jnt_type[j] == mjJNT_SLIDE)
        robot.data->qfrc_applied[m->jnt_dofadr[j]] = tau[coordinate(mj_id2name(m, mjOBJ_JOINT, j))];
  }
};

/// The zeros of coordinates by the comments above the joints of a model.
std::map<std::string, double> zeros_of(const std::string& json) {
  std::map<std::string, double> zeros;
  std::istringstream lines(json);
  constexpr std::string_view words = "zero is ";
  for (std::string line, joint; std::getline(lines, line);) {
    const std::size_t at = line.find(words);
    if (at == std::string::npos || !std::getline(lines, joint)) continue;
    const std::size_t start = joint.find('"') + 1;
    zeros[joint.substr(start, joint.find('"', start) - start)] = std::stod(line.substr(at + words.size()));
  }
  return zeros;
}

/// Rows of MuJoCo's equalities over its velocities.
MatrixXd equality_rows(const MujocoRobot& robot) {
  const mjData* d = robot.data.get();
  const int columns = robot.model->nv;
  MatrixXd rows(d->ne, columns);
  for (int i = 0; i < d->ne; ++i)
    for (int j = 0; j < columns; ++j) rows(i, j) = d->efc_J[i * columns + j];
  return rows;
}

/// Accelerations that keep MuJoCo's equalities exactly, of its mass matrix and forces: its own are springs.
/// The rows' rate of change along the motion is a central difference.
VectorXd closed_accelerations(const MujocoRobot& robot) {
  const mjModel* m = robot.model.get();
  mjData* d = robot.data.get();
  const int n = m->nv;
  const std::vector<mjtNum> q(d->qpos, d->qpos + m->nq);
  const VectorXd v = Eigen::Map<VectorXd>(d->qvel, n);
  constexpr double step = 1e-5;
  std::array<VectorXd, 2> rates;
  for (const int side : {0, 1}) {
    std::copy(q.begin(), q.end(), d->qpos);
    mj_integratePos(m, d->qpos, d->qvel, side == 0 ? -step : step);
    mj_forward(m, d);
    rates[side] = equality_rows(robot) * v;
  }
  std::copy(q.begin(), q.end(), d->qpos);
  mj_forward(m, d);
  const MatrixXd rows = equality_rows(robot);
  const VectorXd bias = (rates[1] - rates[0]) / (2 * step);
  std::vector<mjtNum> full(static_cast<std::size_t>(n) * n);
  mj_fullM(m, full.data(), d->qM);
  const MatrixXd mass = Eigen::Map<MatrixXd>(full.data(), n, n);
  const VectorXd force = Eigen::Map<VectorXd>(d->qfrc_applied, n) + Eigen::Map<VectorXd>(d->qfrc_passive, n) +
                         Eigen::Map<VectorXd>(d->qfrc_actuator, n) - Eigen::Map<VectorXd>(d->qfrc_bias, n);
  const VectorXd free = solved(mass, force);
  const MatrixXd by_multipliers = solved(mass, rows.transpose());
  return free + by_multipliers * least_squares(rows * by_multipliers, -bias - rows * free, 1e-8);
}

/// The lines of MuJoCo's own schema: an element, how often it stands there, its attributes, which may go on in lines.
TEST(ImportMjcf, KnowsEveryElementAndAttributeOfMujocosSchema) {
  std::vector<char> buffer(1 << 20);
  ASSERT_GT(mj_printSchema(nullptr, buffer.data(), static_cast<int>(buffer.size()), 0, 0), 0);
  std::istringstream schema(buffer.data());
  std::vector<std::string> path;
  std::string line, unknown;
  int attributes = 0;
  while (std::getline(schema, line)) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    std::istringstream words(line.substr(indent));
    std::string word;
    if (const std::size_t mark = line.find(" ("); mark != std::string::npos) {
      words >> word;
      path.resize(std::min(path.size(), indent / 3));
      path.push_back(word == "(world)body" ? "body" : word);
      words >> word;
      word.clear();
    }
    const std::string context = path.size() < 2                                              ? ""
                                : path[path.size() - 2] == "mujoco" && path.back() == "body" ? "body"
                                                                                             : path[path.size() - 2];
    bool is_left_out = false;  // with an element above it
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      is_left_out =
          is_left_out || importing::is_known(importing::kMjcf, path[i - 1] + "/" + path[i], "no such attribute");
    if (is_left_out) continue;
    const std::string place = context + "/" + path.back();
    if (!importing::is_known(importing::kMjcf, place, "")) unknown += place + "\n";
    while (words >> word) {
      ++attributes;
      if (!importing::is_known(importing::kMjcf, place, word)) unknown += place + " " + word + "\n";
    }
  }
  EXPECT_EQ(unknown, "");
  EXPECT_GT(attributes, 300);
}

struct Case {
  const char *file, *loops;
  bool has_equalities, is_at_rest;
  double tolerance;
};

/// For names of tests.
void PrintTo(const Case& parameter, std::ostream* out) {
  *out << parameter.file << (parameter.is_at_rest ? " at rest" : "");
}

class InMujoco : public ::testing::TestWithParam<Case> {};

TEST_P(InMujoco, HasTheSameAccelerations) {
  const Case& parameter = GetParam();
  const ImportedModel model = imported(parameter.file, parameter.loops);
  Result<Model> read = read_model(model.json, parameter.file);
  ASSERT_TRUE(read) << to_text(read.problems());
  read->frictions.clear();                                 // MuJoCo's friction is a constraint
  if (!parameter.has_equalities) read->couplings.clear();  // and reads no <mimic> of URDF
  const Mechanism m = analysed(read);
  const MujocoRobot robot(parameter.file);
  const Translation translation{m, robot, zeros_of(model.json)};
  GenericSolver solver(m.model, m.topology, m.analysis);
  std::vector<double> inputs;
  while (inputs.size() < m.model.inputs.size()) inputs.push_back(0.3 + 0.2 * static_cast<double>(inputs.size()));
  solver.set_inputs(inputs);
  std::vector<double> tau = random_tau(m, 5);
  for (std::size_t i = 0; i < tau.size(); ++i) {
    const std::string& name = m.topology.bodies[i].coordinate;
    tau[i] *= mj_name2id(robot.model.get(), mjOBJ_JOINT, name.c_str()) < 0 ? 0 : 0.1;
  }
  double error = 0;
  const std::vector<GenericState> states = random_states(m, 5);
  ASSERT_EQ(states.size(), 5u);
  for (GenericState state : states) {
    if (parameter.is_at_rest) std::fill(state.zd.begin(), state.zd.end(), 0.0);
    GenericDerivative derivative;
    ASSERT_TRUE(solver.accelerations(state, tau, derivative).ok());
    const VectorXd expected = translation.set(state, derivative.zdd);
    translation.apply(tau);
    for (int i = 0; i < robot.model->nu; ++i) {
      const std::string name = mj_id2name(robot.model.get(), mjOBJ_ACTUATOR, i);
      for (std::size_t k = 0; k < inputs.size(); ++k)
        if (m.model.inputs[k].name == name || m.model.inputs[k].name == name + "_2") robot.data->ctrl[i] = inputs[k];
    }
    mj_forward(robot.model.get(), robot.data.get());
    const VectorXd actual = parameter.has_equalities
                                ? closed_accelerations(robot)
                                : VectorXd(Eigen::Map<VectorXd>(robot.data->qacc, robot.model->nv));
    ASSERT_TRUE(actual.allFinite());
    error = std::max(error, (actual - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff());
  }
  std::printf("%s: accelerations as in MuJoCo, %.1e relative\n", parameter.file, error);
  EXPECT_LT(error, parameter.tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, InMujoco,
    ::testing::Values(Case{"arm.urdf", "", false, false, 1e-9}, Case{"quadruped.urdf", "", false, false, 1e-9},
                      // MuJoCo finds the principal axes of geoms together, to 1e-8 or so
                      Case{"walker.xml", "", false, false, 1e-7}, Case{"relations.xml", "", true, true, 1e-7},
                      Case{"relations.xml", "", true, false, 1e-6}, Case{"linkage.xml", "", true, true, 1e-9},
                      Case{"linkage.xml", "", true, false, 1e-6}, Case{"open_linkage.xml", "", true, true, 1e-9},
                      Case{"open_linkage.xml", "", true, false, 1e-6}, Case{"servos.xml", "", false, false, 1e-9}));

}  // namespace
}  // namespace mbgen
