#include "launcher/run/less.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kShares[] = {0.7, 0.2, 0.06};  // of the error that a way may be
constexpr double kLean = 4.0;                   // so much more a robot may move that is one rigid body and not still
constexpr double kLay = 0.1;                    // of their time loose bodies lie still where it may pay to let them sleep
constexpr double kClear = 0.05;                  // of what never comes nearer, beside 10 errors, a link is not asked whether it touches [m]
constexpr double kErrorsClear = 10.0;
constexpr double kAloft = 5e-3;                  // of the ground, a link without its soles is not asked either [m]
constexpr double kLinkSize = 0.1;               // of a link beyond its origin [m]

// What moved no farther than `most` [m].  still: what may stands still, else joints are held and robots rigid.
Less set_of(const Model& model, const Moved& moved, const std::vector<double>& way, double most, bool still) {
  Less less;
  for (std::size_t j = 0; j < way.size(); ++j) {
    if (way[j] <= most) less.held.push_back(model.joints[j].name);
  }
  for (std::size_t i = 0; i < moved.robots.size(); ++i) {
    if (moved.robot_ways[i] <= kLean * most)
      (still && moved.robot_ways[i] <= most ? less.still : less.rigid).push_back(moved.robots[i]);
  }
  if (still && moved.links <= most) {
    less.still.insert(less.still.begin(), "base");
    less.held.clear();
    for (const Joint& joint : model.joints) less.held.push_back(joint.name);
  }
  return less;
}

}  // namespace

std::vector<double> ways(const Model& model, const Moved& moved) {
  Kinematics kinematics(model);
  kinematics.update(Configuration(model));
  std::vector<double> reach(model.joints.size(), 0.0);
  for (int link = 1; link < model.link_count(); ++link) {
    const Eigen::Vector3d at_link = kinematics.link_in_world(link).translation();
    for (int up = link; up > 0; up = model.links[at(up)].parent) {
      const double far = (at_link - kinematics.link_in_world(up).translation()).norm() + kLinkSize;
      reach[at(up - 1)] = std::max(reach[at(up - 1)], far);
    }
  }
  std::vector<double> way(model.joints.size());
  for (std::size_t j = 0; j < way.size(); ++j) {
    const bool slides = model.joints[j].kind == JointKind::kPrismatic;
    way[j] = j < moved.joints.size() ? moved.joints[j] * (slides ? 1.0 : reach[j]) : 0.0;
  }
  return way;
}

std::vector<Less> proposals(const Model& model, const Moved& moved, double error, bool apart) {
  const std::vector<double> way = ways(model, moved);
  std::vector<Less> sets;
  const auto add = [&](const Less& less) {
    if (!less.none() && std::find(sets.begin(), sets.end(), less) == sets.end()) sets.push_back(less);
  };
  const auto beyond = [&](const std::vector<double>& nearest, double least) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      if (std::isfinite(nearest[i]) && nearest[i] > least) names.push_back(model.links[i].name);
    }
    return names;
  };
  const std::vector<std::string> far = beyond(moved.clear, kClear + kErrorsClear * error), aloft = beyond(moved.above, kAloft);
  for (const bool asleep : {true, false}) {
    if (asleep && moved.lay < kLay) continue;
    for (const double share : kShares) {
      // Where links touch, or what hardly moves has to give way, the same with that modelled may hold the error.
      for (const bool still : {true, false}) {
        Less less = set_of(model, moved, way, share * error, still);
        less.asleep = asleep;
        less.aloft = aloft;
        for (const bool drop : {true, false}) {
          less.apart = drop && apart;
          less.untouched = !apart || less.apart ? far : std::vector<std::string>{};
          add(less);
        }
      }
    }
    Less alone;
    alone.asleep = asleep;
    alone.aloft = aloft;
    alone.untouched = apart ? std::vector<std::string>{} : far;
    add(alone);
  }
  return sets;
}

Scene without(const Scene& scene, const Less& less) {
  Scene changed = scene;
  changed.held.insert(changed.held.end(), less.held.begin(), less.held.end());
  changed.held.insert(changed.held.end(), less.still.begin(), less.still.end());
  changed.self_contact = changed.self_contact && !less.apart;
  changed.asleep = changed.asleep || less.asleep;
  changed.untouched.insert(changed.untouched.end(), less.untouched.begin(), less.untouched.end());
  changed.aloft.insert(changed.aloft.end(), less.aloft.begin(), less.aloft.end());
  changed.rigid.insert(changed.rigid.end(), less.rigid.begin(), less.rigid.end());
  return changed;
}

std::string words_of(const Less& less) {
  std::string words;
  const auto add = [&](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  for (const std::string& name : less.still) add((name == "base" ? "the robot" : "robot " + name) + std::string(" still"));
  if (!less.held.empty() && (less.still.empty() || less.still[0] != "base"))
    add(std::to_string(less.held.size()) + (less.held.size() == 1 ? " joint held" : " joints held"));
  for (const std::string& robot : less.rigid) add("robot " + robot + " rigid");
  if (less.apart) add("no contact within a robot");
  if (!less.untouched.empty())
    add(std::to_string(less.untouched.size()) + (less.untouched.size() == 1 ? " link" : " links") + " that nothing comes near");
  if (!less.aloft.empty())
    add(std::to_string(less.aloft.size()) + (less.aloft.size() == 1 ? " link" : " links") + " that nothing fixed comes near");
  if (less.asleep) add("loose bodies asleep where they lie still");
  return words;
}

}  // namespace twinbus::launcher
