// What Pinocchio costs per call, without Python between; pinocchio_peer.py --cost runs it.
//
// Reads the model as numbers, so that no parser has to be linked: per joint parent, kind, axis (3),
// placement (12), mass, centre of mass (3), inertia (9); then 64 lines q v a.  Not part of the build: with P
// the prefix of the wheel (site-packages/cmeel.prefix), and some minutes and 3 GB,
//
//     g++ -std=c++20 -O2 -DNDEBUG -DBOOST_MPL_LIMIT_LIST_SIZE=30 -DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
//       -DPINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION -isystem $P/include -isystem /usr/include/eigen3
//       pinocchio_cost.cpp -o pinocchio_cost -L$P/lib -lpinocchio_default -Wl,-rpath,$P/lib
//
// measures the library of the wheel.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/center-of-mass.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>
#include <string>
#include <vector>

namespace pin = pinocchio;

namespace {

template <class Call>
void measure(const char* name, Call call) {
  constexpr int kBatch = 16;  // as kinematics_bench
  std::vector<double> times;
  for (int i = 0; i < 200; ++i) call(i % 64);
  for (int i = 0; i < 40000; i += kBatch) {
    const auto begin = std::chrono::steady_clock::now();
    for (int k = 0; k < kBatch; ++k) call((i + k) % 64);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin)
            .count() /
        kBatch);
  }
  std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
  std::printf("%s,%.4f\n", name, times[times.size() / 2]);
}

pin::SE3 placement(std::istream& in) {
  pin::SE3 m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) in >> m.rotation()(r, c);
  }
  for (int r = 0; r < 3; ++r) in >> m.translation()[r];
  return m;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ifstream in(argv[1]);
  pin::Model model;
  int joints = 0;
  in >> joints;
  for (int j = 0; j < joints; ++j) {
    std::string kind;
    pin::JointIndex parent = 0;
    Eigen::Vector3d axis, com;
    double mass = 0.0;
    Eigen::Matrix3d inertia;
    in >> parent >> kind >> axis[0] >> axis[1] >> axis[2];
    const pin::SE3 at = placement(in);
    in >> mass >> com[0] >> com[1] >> com[2];
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) in >> inertia(r, c);
    }
    pin::JointModel joint;
    if (kind == "JointModelFreeFlyer")
      joint = pin::JointModelFreeFlyer();
    else if (kind == "JointModelRX")
      joint = pin::JointModelRX();
    else if (kind == "JointModelRY")
      joint = pin::JointModelRY();
    else if (kind == "JointModelRZ")
      joint = pin::JointModelRZ();
    else if (kind == "JointModelRevoluteUnaligned")
      joint = pin::JointModelRevoluteUnaligned(axis);
    else
      return 1;
    const pin::JointIndex id =
        model.addJoint(parent, joint, at, std::string("j") + std::to_string(j));
    model.appendBodyToJoint(id, pin::Inertia(mass, com, inertia), pin::SE3::Identity());
  }
  std::vector<Eigen::VectorXd> q(64, Eigen::VectorXd(model.nq)), v(64, Eigen::VectorXd(model.nv)),
      a = v;
  for (std::size_t i = 0; i < 64; ++i) {
    for (auto* x : {&q[i], &v[i], &a[i]}) {
      for (Eigen::Index k = 0; k < x->size(); ++k) in >> (*x)[k];
    }
  }
  if (!in) return 1;
  pin::Data data(model);
  std::vector<pin::JointIndex> ends;  // leaves, at most four: hands and feet
  for (pin::JointIndex j = 1; j < static_cast<pin::JointIndex>(model.njoints); ++j) {
    if (model.children[j].empty() && ends.size() < 4) ends.push_back(j);
  }
  pin::Data::Matrix6x jacobian(6, model.nv);
  jacobian.setZero();
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  measure("all: kinematics and jacobians", [&](int i) {
    pin::computeJointJacobians(model, data, q[at(i)]);
    for (const auto end : ends) {
      jacobian.setZero();
      pin::getJointJacobian(model, data, end, pin::LOCAL_WORLD_ALIGNED, jacobian);
    }
    pin::jacobianCenterOfMass(model, data, q[at(i)]);
  });
  measure("all: inverse dynamics",
          [&](int i) { pin::rnea(model, data, q[at(i)], v[at(i)], a[at(i)]); });
  measure("all: mass matrix",
          [&](int i) { pin::crba(model, data, q[at(i)], pin::Convention::WORLD); });
  measure("all: mass matrix, local",
          [&](int i) { pin::crba(model, data, q[at(i)], pin::Convention::LOCAL); });
  measure("all: forward dynamics", [&](int i) {
    pin::aba(model, data, q[at(i)], v[at(i)], a[at(i)], pin::Convention::WORLD);
  });
  measure("all: forward dynamics, local", [&](int i) {
    pin::aba(model, data, q[at(i)], v[at(i)], a[at(i)], pin::Convention::LOCAL);
  });
  return 0;
}
