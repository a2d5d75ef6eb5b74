#include "control/loop/pose_way.h"

#include <algorithm>
#include <cstdio>

#include "common/math/index.h"
#include "control/balance/straight_way.h"

namespace twinbus::inline control {

namespace {
constexpr double kMargin = 0.010;    // of the guard, which would hold the joints there [m]
constexpr double kNoNearer = 0.001;  // two links that are near already [m]
}  // namespace

PoseWay::PoseWay(const Model& model)
    : model_(&model), collision_(model), shares_(model), kinematics_(model), place_(model) {}

void PoseWay::start(const Configuration& base, const PerJoint<double>& from, const PerJoint<double>& to,
                    std::int64_t mask) noexcept {
  place_ = base;
  from_ = from;
  to_ = to;
  mask_ = mask;
  next_ = near_at_start_ = 0;
}

PoseWay::Verdict PoseWay::look() noexcept {
  for (const int last = std::min(next_ + kPerTick, kPlaces + 1); next_ < last; ++next_) {
    const double share = static_cast<double>(next_) / kPlaces;
    place_on_way(*model_, from_, to_, mask_, share, place_);
    kinematics_.update(place_);
    const int count = collision_.near_pairs(kinematics_, kMargin, near_.data(), kMostPairs);
    if (next_ == 0) {
      at_start_ = near_;
      near_at_start_ = count;
      continue;
    }
    for (int i = 0; i < count; ++i) {
      const PairDistance& pair = near_[at(i)];
      const auto end = at_start_.begin() + near_at_start_;
      const auto before = std::find_if(at_start_.begin(), end, [&](const PairDistance& p) {
        return p.link_a == pair.link_a && p.link_b == pair.link_b;
      });
      if (!(pair.distance < kMargin * shares_.of(pair.link_a, pair.link_b))) continue;
      if (before != end && pair.distance > before->distance - kNoNearer) continue;
      hit_ = pair;
      return Verdict::kTouches;
    }
  }
  return next_ > kPlaces ? Verdict::kFree : Verdict::kLooks;
}

const char* PoseWay::why() noexcept {
  auto& text = sentences_[sentence_];
  sentence_ = (sentence_ + 1) % sentences_.size();
  std::snprintf(text.data(), text.size(),
                "on the way to the pose %.40s and %.40s would touch; ask for one that keeps them apart, or go there in two moves",
                model_->links[at(hit_.link_a)].name.c_str(), model_->links[at(hit_.link_b)].name.c_str());
  return text.data();
}

}  // namespace twinbus::control
