#include "launcher/check/check_pairs.h"

#include <cstdio>
#include <stdexcept>

#include "common/file/write_file.h"
#include "robot/collision/collision_pairs.h"
#include "common/math/index.h"
#include "robot/collision/exact/pair_proof.h"

namespace twinbus::inline launcher {

namespace {

bool left_out(const Model& model, const CollisionPair& pair) {
  for (const auto& p : model.disabled_pairs) {
    if ((p[0] == pair.link_a && p[1] == pair.link_b) ||
        (p[0] == pair.link_b && p[1] == pair.link_a))
      return true;
  }
  return false;
}

void print_posture(const Model& model, const PairVerdict& v) {
  for (int j = 0; j < model.joint_count(); ++j) {
    if (joint_moves_pair(model, j, v.pair.link_a, v.pair.link_b))
      std::printf(" %s=%.3f", model.joints[at(j)].name.c_str(), v.posture[j]);
  }
}

}  // namespace

int check_pairs(const Model& model, const std::string& file) {
  const RobotGeometry geometry = build_geometry(model);
  const std::vector<PairVerdict> verdicts = judge_pairs(model, geometry);
  int count[5] = {};
  int unsound = 0;
  for (const PairVerdict& v : verdicts) {
    ++count[static_cast<int>(v.kind)];
    const char* a = model.links[at(v.pair.link_a)].name.c_str();
    const char* b = model.links[at(v.pair.link_b)].name.c_str();
    const bool out = left_out(model, v.pair);
    if (v.kind == PairKind::kNever) std::printf("never: %s, %s (%d cells)\n", a, b, v.cells);
    if (v.kind == PairKind::kAlwaysSeen)
      std::printf("touches in every sample: %s, %s; look at their geometry\n", a, b);
    if (!out) continue;
    if (v.kind == PairKind::kTouches) {
      ++unsound;
      std::printf("UNSOUND: the SRDF leaves out %s, %s, which touch at", a, b);
      print_posture(model, v);
      std::printf("\n");
    } else if (v.kind == PairKind::kUnproved) {
      std::printf("not proved: the SRDF leaves out %s, %s; no contact was seen\n", a, b);
    }
  }
  std::printf("%zu pairs:", verdicts.size());
  for (int k = 0; k < 5; ++k)
    std::printf("%s %d %s", k == 0 ? "" : ",", count[k], name(static_cast<PairKind>(k)));
  std::printf("; %zu are left out by the SRDF, %d of them unsoundly\n", model.disabled_pairs.size(),
              unsound);
  if (!file.empty()) {
    write_new(file, srdf_with_pairs(model, verdicts));
    std::printf("written: %s\n", file.c_str());
  }
  return unsound > 0 ? 1 : 0;
}

}  // namespace twinbus::launcher
