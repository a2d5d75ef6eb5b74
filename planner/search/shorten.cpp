#include "planner/search/shorten.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "common/math/index.h"

namespace twinbus::inline planner {

namespace {

constexpr int kRounds = 5;
constexpr float kLeastGain = 0.02F;  // a corner whose cut gains less is left [rad]

SearchPoint mixed(const SearchPoint& a, const SearchPoint& b, float share, int joints) {
  SearchPoint q{};
  for (std::size_t j = 0; j < at(joints); ++j) q[j] = a[j] + share * (b[j] - a[j]);
  return q;
}

// A path whose points have numbers, so that a line that was found blocked is not asked for again.
class Shortener {
 public:
  Shortener(LineTest& test, SearchPath& path, int joints)
      : test_(test), path_(path), joints_(joints) {
    for (std::size_t i = 0; i < path.size(); ++i) numbers_.push_back(next_++);
  }

  // From each point to the farthest later one in sight.
  bool shortcut() {
    bool changed = false;
    for (std::size_t i = 0; i + 2 < path_.size(); ++i) {
      for (std::size_t k = path_.size() - 1; k > i + 1; --k) {
        if (!sees(i, k)) continue;
        const auto gap = [&](auto& v) {
          v.erase(v.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                  v.begin() + static_cast<std::ptrdiff_t>(k));
        };
        gap(path_);
        gap(numbers_);
        changed = true;
        break;
      }
    }
    return changed;
  }

  // A corner is cut from the middle of its lines, or from a quarter of the way, where that is free
  // and gains enough.
  bool cut_corners() {
    bool changed = false;
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      for (const float share : {0.5F, 0.25F}) {
        const SearchPoint a = mixed(path_[i], path_[i - 1], share, joints_);
        const SearchPoint b = mixed(path_[i], path_[i + 1], share, joints_);
        const float gain = distance(a, path_[i], joints_) + distance(path_[i], b, joints_) -
                           distance(a, b, joints_);
        if (!(gain > kLeastGain)) break;
        if (!test_.between(a, b, joints_)) continue;
        path_[i] = a;
        numbers_[i] = next_++;
        path_.insert(path_.begin() + static_cast<std::ptrdiff_t>(i) + 1, b);
        numbers_.insert(numbers_.begin() + static_cast<std::ptrdiff_t>(i) + 1, next_++);
        ++i;
        changed = true;
        break;
      }
    }
    return changed;
  }

 private:
  bool sees(std::size_t i, std::size_t k) {
    const std::pair<int, int> line{numbers_[i], numbers_[k]};
    if (std::find(blocked_.begin(), blocked_.end(), line) != blocked_.end()) return false;
    if (test_.between(path_[i], path_[k], joints_)) return true;
    blocked_.push_back(line);
    return false;
  }

  LineTest& test_;
  SearchPath& path_;
  int joints_;
  int next_ = 0;
  std::vector<int> numbers_;
  std::vector<std::pair<int, int>> blocked_;
};

}  // namespace

void shorten(LineTest& test, SearchPath& path, int joints) {
  if (path.size() <= 2) return;
  Shortener shortener(test, path, joints);
  for (int round = 0; round < kRounds; ++round) {
    const bool shorter = shortener.shortcut();
    const bool smoother = shortener.cut_corners();
    if (!shorter && !smoother) break;
  }
}

}  // namespace twinbus::planner
