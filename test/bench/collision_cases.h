// What the collision benches share: the robot, its random postures, and times.

#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "common/process/process.h"

namespace twinbus {

// "jvrc29" (JVRC-1 of TWINBUS_DATA without its distal finger links), a robot's name or folder, or a
// .urdf; package: NAME=FOLDER, what package:// means; links with `drop` in their name bear nothing.
Model load_case(const std::string& robot, const std::string& package, const std::string& drop);

class Postures {
 public:
  explicit Postures(const Model& model, std::uint64_t seed = 1)
      : model_(model), now_(model), random_(seed) {}
  // Uniform within the limits, or near zero.
  const Configuration& draw(bool near_home);
  double uniform() { return uniform_(random_); }

 private:
  const Model& model_;
  Configuration now_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0.0, 1.0};
  std::normal_distribution<double> normal_;
};

struct Times {
  std::vector<double> us;
  double at_share(double share) {
    if (us.empty()) return 0.0;
    std::sort(us.begin(), us.end());
    return us[static_cast<std::size_t>(share * static_cast<double>(us.size() - 1) + 0.5)];
  }
};

// Calls with 0 .. count - 1; keeps the time of one.
template <class Call>
void time(Times& times, int count, Call call) {
  const std::int64_t begin = monotonic_ns();
  for (int k = 0; k < count; ++k) call(k);
  times.us.push_back(1e-3 * static_cast<double>(monotonic_ns() - begin) / count);
}

}  // namespace twinbus
