#include "robot/lint/mirrored_ranges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "common/math/index.h"
#include "robot/collision/collision_pairs.h"
#include "robot/kinematics/kinematics.h"
#include "robot/onboarding/anatomy.h"
#include "robot/onboarding/rest_pairs.h"

namespace twinbus::inline robot {

namespace {

constexpr double kSameLimit = 0.01;     // limits of left and right [rad]
constexpr double kParallel = 0.98;  // cosine between an axis and the image of the other

bool same(double a, double b) { return std::abs(a - b) <= kSameLimit; }

using Range = std::pair<double, double>;

Range range_of(const Joint& joint) { return {joint.lower, joint.upper}; }
Range turned(const Range& r) { return {-r.second, -r.first}; }
bool same(const Range& a, const Range& b) { return same(a.first, b.first) && same(a.second, b.second); }

// How far the joint goes the way that a leg needs most [rad].  in_middle: its leg has joints that turn about y above and below it.
double way_that_counts(const Joint& joint, const Eigen::Vector3d& axis, bool on_left, bool in_middle) {
  Eigen::Index main = 0;
  axis.cwiseAbs().maxCoeff(&main);
  // About +y a leg goes back, a shank bends as knees do, toes go down, about -y a shank leans forward on its foot; about +x the left
  // leg goes out, about +z its toes turn out.
  const bool along = main == 1 ? in_middle : on_left;
  return along == (axis[main] > 0.0) ? joint.upper : -joint.lower;
}

}  // namespace

std::vector<UnmirroredRange> unmirrored_ranges(const Model& model, const std::vector<int>& legs) {
  std::vector<UnmirroredRange> found;
  const Kinematics k = at_rest(model);
  const std::vector<int> images = mirror_images(model);
  const auto is_of_leg = [&](int joint) { return std::find(legs.begin(), legs.end(), joint) != legs.end(); };
  const auto turns_about_y = [&](int link) { return is_of_leg(link - 1) && std::abs(k.axis_in_world(link - 1).y()) > 0.7; };
  const auto is_in_middle = [&](int link) {
    bool above = false, below = false;
    for (const int j : legs) {
      if (j + 1 == link || !turns_about_y(j + 1)) continue;
      above = above || hangs_on(model, link, j + 1);
      below = below || hangs_on(model, j + 1, link);
    }
    return above && below;
  };
  for (int link = 1; link < model.link_count(); ++link) {
    const int image = images[at(link)];
    if (image <= link || images[at(image)] != link) continue;
    const Joint &a = model.joints[at(link - 1)], &b = model.joints[at(image - 1)];
    if (a.kind != JointKind::kRevolute || b.kind != JointKind::kRevolute) continue;
    const Eigen::Vector3d axis_a = k.axis_in_world(link - 1), axis_b = k.axis_in_world(image - 1);
    const double along = Eigen::Vector3d(-axis_a.x(), axis_a.y(), -axis_a.z()).dot(axis_b);
    if (std::abs(along) < kParallel) continue;
    const bool equal = along > 0.0;
    const auto in_mirror = [&](const Range& r) { return equal ? r : turned(r); };
    if (same(in_mirror(range_of(a)), range_of(b)) || !same(turned(in_mirror(range_of(a))), range_of(b))) continue;
    UnmirroredRange fault;
    fault.of_leg = is_of_leg(link - 1) && is_of_leg(image - 1);
    const bool a_on_left = k.com_of_link(link).y() > 0.0, in_middle = is_in_middle(link);
    const bool keeps_a = way_that_counts(a, axis_a, a_on_left, in_middle) >= way_that_counts(b, axis_b, !a_on_left, in_middle);
    fault.kept = keeps_a ? link - 1 : image - 1;
    fault.other = keeps_a ? image - 1 : link - 1;
    std::tie(fault.lower, fault.upper) = in_mirror(range_of(model.joints[at(fault.kept)]));
    found.push_back(fault);
  }
  return found;
}

}  // namespace twinbus::robot
