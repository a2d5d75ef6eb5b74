// posture_probe [--scene S] [--robot R]: how near a posture is to touching itself and the scene's
// obstacles, for tests that recorded postures from the bus.
//
// One posture per line in: base position and quaternion w x y z in the world, then the joints in
// bus order.  One line per posture out: nearest self distance and nearest obstacle distance [m],
// whether FCL's other solver finds anything touching, left and right hand in the world [m].

#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/description/load.h"
#include "common/process/options.h"
#include "sim/scene/scene.h"
#include "test/oracles/fcl_oracle.h"

using namespace twinbus;

namespace {

constexpr double kFar = 1.0;  // [m]

int probe(const Model& model, const std::vector<Obstacle>& obstacles) {
  Collision collision(model);
  collision.set_obstacles(obstacles);
  FclOracle oracle(model);
  oracle.set_obstacles(obstacles);
  Kinematics kinematics(model);
  Configuration posture(model);
  std::vector<CollisionPair> pairs = collision.pairs();
  std::vector<int> with_geometry;
  for (int link = 0; link < model.link_count(); ++link) {
    if (!model.links[static_cast<std::size_t>(link)].collision.empty())
      with_geometry.push_back(link);
  }
  for (const int link : with_geometry) {
    for (int o = 0; o < static_cast<int>(obstacles.size()); ++o)
      pairs.push_back({link, model.link_count() + o});
  }

  std::string line;
  for (long number = 1; std::getline(std::cin, line); ++number) {
    std::istringstream in(line);
    double b[7];
    for (double& value : b) in >> value;
    for (const int joint : model.bus_joints) in >> posture.q[joint];
    if (!in) {
      std::fprintf(stderr, "posture_probe: line %ld: %d numbers are needed\n", number,
                   7 + model.bus_count());
      return 1;
    }
    posture.base = Eigen::Translation3d(b[0], b[1], b[2]) *
                   Eigen::Quaterniond(b[3], b[4], b[5], b[6]).normalized();
    kinematics.update(posture);
    double self = kFar;
    double obstacle = kFar;
    bool touching = false;
    for (const CollisionPair& pair : pairs) {
      double& nearest = pair.link_b < model.link_count() ? self : obstacle;
      PairDistance found;
      if (collision.pair_nearer_than(kinematics, pair.link_a, pair.link_b, nearest, found))
        nearest = std::min(nearest, found.distance);
      touching = touching || oracle.touches(kinematics, pair);
    }
    std::printf("%.6f %.6f %d", self, obstacle, touching ? 1 : 0);
    for (const Hand& hand : model.hands) {
      const Eigen::Vector3d at =
          hand.link < 0
              ? Eigen::Vector3d::Zero()
              : Eigen::Vector3d((kinematics.link_in_world(hand.link) * hand.frame).translation());
      std::printf(" %.6f %.6f %.6f", at.x(), at.y(), at.z());
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Options options("posture_probe", "How near postures are to touching; one per line of input.");
  std::string robot = "hrp1s", scene;
  options.text("--robot", "NAME_OR_DIR", robot, "the robot");
  options.text("--scene", "SCENE", scene, "whose obstacles count");
  options.parse(argc, argv);
  return probe(load_robot(robot),
               scene.empty() ? std::vector<Obstacle>{} : load_scene(scene).obstacles);
} catch (const std::exception& error) {
  std::fprintf(stderr, "posture_probe: %s\n", error.what());
  return 1;
}
