#include "robot/collision/near_pairs.h"

#include <algorithm>

#include "common/math/index.h"
#include "common/text/strict_yaml.h"
#include "lcmtypes/msg/guard_defaults.h"

namespace twinbus {

namespace {

constexpr double kLeast = 0.001;  // [m]

NearPair read_near_pair(const ConfigNode& node, const Model& model) {
  const std::vector<std::string> links = node.texts("links");
  if (links.size() != 2) node.fail("links", "must name two links");
  NearPair pair;
  pair.margin = node.number("margin", kLeast, GuardDefaults::kInController);
  node.finish();
  int* const index[] = {&pair.link_a, &pair.link_b};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto frame = std::find_if(model.frames.begin(), model.frames.end(),
                                    [&](const Frame& f) { return f.name == links[i]; });
    if (frame == model.frames.end()) node.fail("links", "'" + links[i] + "' is no link of the robot");
    *index[i] = frame->link;
  }
  if (links[0] == links[1]) node.fail("links", "names " + links[0] + " twice; name two links");
  return pair;
}

}  // namespace

std::vector<NearPair> near_pairs_of(const Model& model) {
  std::vector<NearPair> pairs;
  if (model.yaml_text.empty()) return pairs;
  const ConfigNode top = ConfigNode::parse(model.yaml_text, "robot.yaml of " + model.name);
  for (const ConfigNode& node : top.list("near_pairs")) {
    const NearPair pair = read_near_pair(node, model);
    if (pair.link_a != pair.link_b) pairs.push_back(pair);
  }
  return pairs;
}

MarginShares::MarginShares(const Model& model) : links_(model.link_count()) {
  const auto n = at(links_);
  for (const NearPair& pair : near_pairs_of(model)) {
    if (share_.empty()) share_.assign(n * n, 1.0);
    const double share = pair.margin / GuardDefaults::kInController;
    for (double* of : {&share_[at(pair.link_a) * n + at(pair.link_b)], &share_[at(pair.link_b) * n + at(pair.link_a)]})
      *of = std::min(*of, share);
    least_ = std::min(least_, share);
  }
}

}  // namespace twinbus
