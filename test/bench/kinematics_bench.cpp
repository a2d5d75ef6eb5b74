// `twinbus bench kinematics`: what one call of the robot library costs, on hrp1s in random
// postures.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/estimation/estimator.h"
#include "test/oracles/forward_dynamics.h"
#include "robot/kinematics/inverse_kinematics.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/load.h"
#include "test/oracles/mass_matrix.h"
#include "common/process/options.h"
#include "common/process/process.h"
#include "common/time/latency_histogram.h"

using namespace twinbus;

namespace {

constexpr int kBatch = 16;  // calls between two looks at the clock

struct Row {
  std::string name;
  RateStats stats;
};

template <class Call>
Row measure(const std::string& name, std::int64_t calls, int batch, Call call) {
  Row row{name, {}};
  for (int i = 0; i < 200; ++i) call(i);
  for (std::int64_t i = 0; i < calls; i += batch) {
    const std::int64_t start = monotonic_ns();
    for (int k = 0; k < batch; ++k) call(static_cast<int>((i + k) % 64));
    row.stats.add((monotonic_ns() - start) / batch);
  }
  return row;
}

std::vector<Configuration> postures(const Model& model) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Configuration> result;
  for (int i = 0; i < 64; ++i) {
    Configuration c(model);
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      const double low = std::max(joint.lower, -3.0), high = std::min(joint.upper, 3.0);
      c.q[j] = low + unit(random) * (high - low);
      c.qd[j] = unit(random) - 0.5;
    }
    result.push_back(c);
  }
  return result;
}

// Everything that a peer computes too, as lines `name value value ...`, columns first: peers/pinocchio_peer.py compares.
void dump(const Model& model, const std::string& file_name) {
  std::FILE* file = std::fopen(file_name.c_str(), "w");
  if (file == nullptr) throw std::runtime_error(file_name + ": cannot be written");
  const auto line = [&](const char* name, const Eigen::MatrixXd& values) {
    std::fprintf(file, "%s", name);
    for (Eigen::Index i = 0; i < values.size(); ++i) std::fprintf(file, " %.17g", values.data()[i]);
    std::fprintf(file, "\n");
  };
  const Eigen::Index n = model.joint_count();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto vector = [&](Eigen::Index size) {
    Eigen::VectorXd v(size);
    for (Eigen::Index i = 0; i < size; ++i) v[i] = unit(random);
    return v;
  };
  std::fprintf(file, "joints");
  for (const Joint& joint : model.joints) std::fprintf(file, " %s", joint.name.c_str());
  std::fprintf(file, "\n");
  Kinematics k(model);
  MassMatrix mass(model);
  InverseDynamics inverse(model);
  ForwardDynamics forward(model);
  const int hand = model.hands[0].link > 0 ? model.hands[0].link : model.link_count() - 1;
  std::fprintf(file, "link %s\n", model.links[static_cast<std::size_t>(hand)].name.c_str());
  for (Configuration c : postures(model)) {
    c.base.linear() = Eigen::Quaterniond(vector(4).normalized().eval().data()).toRotationMatrix();
    c.base.translation() = vector(3);
    c.base_velocity = vector(3);
    c.base_angular_velocity = vector(3);
    k.update(c);
    mass.update(k);
    const Eigen::VectorXd acceleration = vector(6 + n);
    Eigen::VectorXd tau(n), qdd(n), wrench(6), base(6);
    wrench = inverse.solve(k, c, acceleration.tail(n), acceleration.head<3>(),
                           acceleration.segment<3>(3), {}, tau);
    Eigen::MatrixXd jacobian(6, 6 + n), com(3, 6 + n);
    k.point_jacobian(hand, k.link_in_world(hand).translation(), jacobian);
    k.com_jacobian(com);
    const Eigen::Vector4d turn = Eigen::Quaterniond(c.base.linear()).coeffs();  // x y z w
    line("position", c.base.translation());
    line("turn", turn);
    line("q", c.q);
    Eigen::VectorXd v(6 + n);
    v << c.base_velocity, c.base_angular_velocity, c.qd;
    line("v", v);
    line("a", acceleration);
    line("com", k.com());
    line("hand", k.link_in_world(hand).translation());
    line("hand_jacobian", jacobian);
    line("com_jacobian", com);
    line("mass_matrix", mass.matrix());
    Eigen::VectorXd forces(6 + n);
    forces << wrench, tau;
    line("inverse_dynamics", forces);
    Eigen::VectorXd still(n);
    wrench = inverse.solve(k, c, Eigen::VectorXd::Zero(n), Eigen::Vector3d::Zero(),
                           Eigen::Vector3d::Zero(), {}, still);
    forces << wrench, still;
    line("bias", forces);
    forward.solve(k, c, tau, {}, qdd);
    base << forward.base_acceleration(), forward.base_angular_acceleration();
    forces << base, qdd;
    line("forward_dynamics", forces);
    line("end", Eigen::VectorXd());
  }
  if (std::fclose(file) != 0) throw std::runtime_error(file_name + ": cannot be written");
}

RobotState standing(const Model& model) {
  RobotState state;
  state.run_id = 1;
  state.joint_count = static_cast<std::int16_t>(model.bus_count());
  state.sensor_flags =
      kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
  const auto& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    state.q[k] = pose[static_cast<std::size_t>(model.bus_joints[k])];
  }
  for (std::size_t foot = 0; foot < 2; ++foot) {
    state.wrench_kind[foot] = WrenchKind::kMeasured;
    state.wrench[foot][2] = static_cast<float>(0.5 * kGravity * model.total_mass());
  }
  return state;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("kinematics_bench", "Costs of the robot library per call.");
  std::string csv, dump_file, robot = "hrp1s";
  std::int64_t calls = 200000;
  options.text("--robot", "NAME_OR_DIR", robot,
               "a robot with legs, arms and a pose half_sitting; to dump, any or a .urdf");
  options.integer("--calls", "N", calls, 1000, 100'000'000, "per case");
  options.text("--csv", "FILE", csv, "also as rows");
  options.text("--dump", "FILE", dump_file, "no costs: results for a peer to compare");
  options.parse(argc, argv);

  const bool urdf = std::filesystem::path(robot).extension() == ".urdf";
  const Model model = urdf ? load_urdf(robot, {}) : load_robot(robot);
  if (!dump_file.empty()) {
    dump(model, dump_file);
    return 0;
  }
  if (model.find_pose("half_sitting") < 0 || model.soles[0].link < 0 || model.hands[0].link < 0) {
    std::fprintf(stderr, "kinematics_bench: %s has no pose half_sitting, soles or hands\n",
                 robot.c_str());
    return 1;
  }
  const std::vector<Configuration> c = postures(model);
  Kinematics kinematics(model);
  Eigen::MatrixXd jacobian(6, 6 + model.joint_count()), com_jacobian(3, 6 + model.joint_count());
  InverseDynamics dynamics(model);
  Eigen::VectorXd tau(model.joint_count());
  const Eigen::VectorXd qdd = Eigen::VectorXd::Ones(model.joint_count());
  const std::vector<ExternalWrench> external(2);
  Estimator estimator(model);
  const RobotState state = standing(model);
  InverseKinematics leg(model, 0, model.soles[0].link, model.soles[0].frame);
  InverseKinematics arm(
      model, model.joints[static_cast<std::size_t>(model.hands[0].joints.front())].parent,
      model.hands[0].link, model.hands[0].frame);
  const auto& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
  const Eigen::VectorXd rest =
      Eigen::Map<const Eigen::VectorXd>(pose.data(), static_cast<Eigen::Index>(pose.size()));
  Eigen::VectorXd q = rest;
  const auto near = [&](const InverseKinematics& chain, int i, double size) {
    Eigen::Isometry3d target = chain.pose(rest);
    target.translation() +=
        size * Eigen::Vector3d(((i * 7) % 64) / 64.0 - 0.5, ((i * 13) % 64) / 64.0 - 0.5,
                               ((i * 29) % 64) / 64.0 - 0.2);
    return target;
  };

  std::vector<Row> rows;
  rows.push_back(measure("kinematics update", calls, kBatch,
                         [&](int i) { kinematics.update(c[static_cast<std::size_t>(i % 64)]); }));
  rows.push_back(measure("point jacobian", calls, kBatch, [&](int) {
    kinematics.point_jacobian(model.hands[0].link, Eigen::Vector3d::Zero(), jacobian);
  }));
  rows.push_back(
      measure("com jacobian", calls, kBatch, [&](int) { kinematics.com_jacobian(com_jacobian); }));
  rows.push_back(measure("inverse dynamics", calls, kBatch, [&](int i) {
    dynamics.solve(kinematics, c[static_cast<std::size_t>(i % 64)], qdd, Eigen::Vector3d::Zero(),
                   Eigen::Vector3d::Zero(), external, tau);
  }));
  // As a controller needs them, kinematics included; compared with a peer's.
  const auto at_posture = [&](int i) -> const Configuration& {
    return c[static_cast<std::size_t>(i % 64)];
  };
  MassMatrix mass(model);
  ForwardDynamics forward(model);
  Eigen::VectorXd result(model.joint_count());
  rows.push_back(measure("all: kinematics and jacobians", calls, kBatch, [&](int i) {
    kinematics.update(at_posture(i));
    for (std::size_t side = 0; side < 2; ++side) {
      const int foot = model.soles[side].link, hand = model.hands[side].link;
      kinematics.point_jacobian(foot, kinematics.link_in_world(foot).translation(), jacobian);
      kinematics.point_jacobian(hand, kinematics.link_in_world(hand).translation(), jacobian);
    }
    kinematics.com_jacobian(com_jacobian);
  }));
  rows.push_back(measure("all: inverse dynamics", calls, kBatch, [&](int i) {
    kinematics.update(at_posture(i));
    dynamics.solve(kinematics, at_posture(i), qdd, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                   external, tau);
  }));
  rows.push_back(measure("all: mass matrix", calls, kBatch, [&](int i) {
    kinematics.update(at_posture(i));
    mass.update(kinematics);
  }));
  rows.push_back(measure("all: forward dynamics", calls, kBatch, [&](int i) {
    kinematics.update(at_posture(i));
    forward.solve(kinematics, at_posture(i), tau, external, result);
  }));
  rows.push_back(measure("estimator update", calls, kBatch, [&](int) { estimator.update(state); }));
  rows.push_back(measure("leg inverse kinematics, 1 cm", calls / 10, 4, [&](int i) {
    q = rest;
    leg.solve(near(leg, i, 0.01), {}, q);
  }));
  rows.push_back(measure("arm inverse kinematics, 20 cm", calls / 10, 4, [&](int i) {
    q = rest;
    arm.solve(near(arm, i, 0.2), {}, q);
  }));
  rows.push_back(measure("load of the robot", 100, 1, [&](int) { load_robot(robot); }));

  std::printf("%-32s %10s %10s %10s %10s\n", "microseconds per call", "median", "p99", "p99.9",
              "worst");
  for (const Row& row : rows) {
    std::printf("%-32s %10.3f %10.3f %10.3f %10.3f\n", row.name.c_str(),
                1e-3 * row.stats.median_ns(), 1e-3 * row.stats.p99_ns(), 1e-3 * row.stats.p999_ns(),
                1e-3 * static_cast<double>(row.stats.max_ns()));
  }
  if (csv.empty()) return 0;
  std::FILE* file = std::fopen(csv.c_str(), "a");
  if (file == nullptr) {
    std::fprintf(stderr, "kinematics_bench: %s cannot be written\n", csv.c_str());
    return 1;
  }
  for (const Row& row : rows) {
    std::fprintf(file, "kinematics,\"%s\",cost,us,%.3f,%.3f,%.3f,%.3f,,,\n", row.name.c_str(),
                 1e-3 * row.stats.median_ns(), 1e-3 * row.stats.p99_ns(),
                 1e-3 * row.stats.p999_ns(), 1e-3 * static_cast<double>(row.stats.max_ns()));
  }
  return std::fclose(file) == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "kinematics_bench: %s\n", error.what());
  return 1;
}
