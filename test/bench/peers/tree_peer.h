// What the peers of free motion share: a scene as physics_lab.py's tree_of() writes it, and the clock around an engine.
//
//     PEER version
//     PEER step MODEL.tree METHOD H [SECONDS]             us a step, median of batches
//     PEER run  MODEL.tree METHOD H DURATION [REPEATS]    CPU ms per simulated s, where all links end
//
// An Engine stands at the start when it is made, from (tree, method, h), and has step() and com(link).  It throws for a method
// that it has not.

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "test/measure.h"

struct TreeLink {
  int parent = -1;
  Eigen::Isometry3d placement;  // of its frame in the parent's at q = 0; of link 0 in world
  Eigen::Vector3d axis;         // of the hinge, in its frame
  double mass = 0.0;
  Eigen::Vector3d com;      // in its frame
  Eigen::Matrix3d inertia;  // about the com, axes of its frame
  double q = 0.0, qd = 0.0;
};

struct Tree {
  bool fixed = false;
  Eigen::Vector3d velocity, angular_velocity;  // of link 0's origin, in world
  std::vector<TreeLink> links;
};

constexpr double kTreeGravity = 9.81;

inline Tree read_tree(const std::string& file) {
  std::ifstream in(file);
  const auto number = [&in] {
    double value = 0.0;
    in >> value;
    return value;
  };
  const auto vector = [&number] {
    const double x = number(), y = number(), z = number();
    return Eigen::Vector3d(x, y, z);
  };
  Tree tree;
  std::string base;
  in >> base;
  tree.fixed = base == "fixed";
  tree.velocity = vector();
  tree.angular_velocity = vector();
  TreeLink link;
  while (in >> link.parent) {
    link.placement.setIdentity();
    link.placement.translation() = vector();
    const double w = number();
    const Eigen::Vector3d v = vector();
    link.placement.linear() = Eigen::Quaterniond(w, v.x(), v.y(), v.z()).toRotationMatrix();
    link.axis = vector();
    link.mass = number();
    link.com = vector();
    const Eigen::Vector3d moments = vector(), products = vector();  // xx yy zz, xy xz yz
    link.inertia << moments[0], products[0], products[1],           //
        products[0], moments[1], products[2],                       //
        products[1], products[2], moments[2];
    link.q = number();
    link.qd = number();
    tree.links.push_back(link);
  }
  if (tree.links.empty() || !in.eof()) throw std::runtime_error(file + ": not a tree");
  return tree;
}

using twinbus::thread_cpu_seconds;
using twinbus::median;

template <class Engine>
void time_steps(const Tree& tree, const std::string& method, double h, double seconds) {
  constexpr int kBatch = 32;
  const long most = std::lround(1.0 / h);  // then it begins again
  std::unique_ptr<Engine> engine;
  std::vector<double> batches;
  const double begun = thread_cpu_seconds();
  for (long done = most; batches.empty() || thread_cpu_seconds() - begun < seconds; done += kBatch) {
    if (done + kBatch > most) {
      engine = std::make_unique<Engine>(tree, method, h);
      done = 0;
    }
    const double t = thread_cpu_seconds();
    for (int i = 0; i < kBatch; ++i) engine->step();
    batches.push_back(1e6 * (thread_cpu_seconds() - t) / kBatch);
  }
  std::printf("us %.4f\n", median(batches));
}

template <class Engine>
void run(const Tree& tree, const std::string& method, double h, double duration, int repeats) {
  const long steps = std::lround(duration / h);
  std::unique_ptr<Engine> engine;
  std::vector<double> costs;
  double total = 0.0;
  for (int r = 0; r < repeats || (total < 0.02 && r < 50 * repeats); ++r) {
    engine = std::make_unique<Engine>(tree, method, h);
    const double t = thread_cpu_seconds();
    for (long i = 0; i < steps; ++i) engine->step();
    costs.push_back(1e3 * (thread_cpu_seconds() - t) / duration);
    total += thread_cpu_seconds() - t;
  }
  std::printf("ms_per_s %.6f at", median(costs));
  for (int i = 0; i < static_cast<int>(tree.links.size()); ++i) {
    const Eigen::Vector3d com = engine->com(i);
    std::printf(" %.17g %.17g %.17g", com.x(), com.y(), com.z());
  }
  std::printf("\n");
}

template <class Engine>
int peer_main(int argc, char** argv, const std::string& version) try {
  const std::string what = argc > 1 ? argv[1] : "";
  if (what == "version") {
    std::printf("%s\n", version.c_str());
    return 0;
  }
  if (argc < 5 || (what != "step" && what != "run"))
    throw std::runtime_error("usage: see tree_peer.h");
  const Tree tree = read_tree(argv[2]);
  const double h = std::atof(argv[4]), fifth = argc > 5 ? std::atof(argv[5]) : 0.3;
  if (what == "step") {
    time_steps<Engine>(tree, argv[3], h, fifth);
  } else {
    run<Engine>(tree, argv[3], h, fifth, argc > 6 ? std::atoi(argv[6]) : 3);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
  return 1;
}
