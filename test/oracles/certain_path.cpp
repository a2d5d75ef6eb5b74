#include "test/oracles/certain_path.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "common/math/index.h"

namespace twinbus {

namespace {

class CertainLineTest : public LineTest {
 public:
  CertainLineTest(BlockCheck& check, float density) : check_(&check), quick_(check, density) {}

  bool free(const SearchPoint& from, const SearchPoint& step, float length) override {
    return quick_.free(from, step, length) && check_->line_certain(from.data(), step.data());
  }

 private:
  BlockCheck* check_;
  BlockLineTest quick_;
};

// How long balls alone are tried.
struct Patience {
  int asked = 0;
  bool (*keep_on)(void*) = nullptr;
  void* user = nullptr;

  static bool go_on(void* of) {
    auto& p = *static_cast<Patience*>(of);
    return ++p.asked < kMost && (p.keep_on == nullptr || p.keep_on(p.user));
  }
  static constexpr int kMost = 20;
};

bool proved(BlockCheck& check, const SearchPath& path, int joints) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    SearchPoint step{};
    for (std::size_t j = 0; j < at(joints); ++j) step[j] = path[i + 1][j] - path[i][j];
    if (!check.line_certain(path[i].data(), step.data())) return false;
  }
  return true;
}

}  // namespace

bool certain_at(BlockCheck& check, const SearchPoint& q) {
  static constexpr SearchPoint kNowhere{};
  return check.line_certain(q.data(), kNowhere.data());
}

CertainPath find_certain(JointSearch& search, BlockCheck& check, float density,
                         const SearchPoint& start, const SearchPath& goals, bool (*keep_on)(void*),
                         void* user) {
  const int joints = check.robot().joints;
  BlockLineTest quick(check, density);
  CertainLineTest slow(check, density);
  CertainPath result;
  // Balls are quick and leave room: at first hulls, and pieces of what they do not part, settle only what touches at the ends.
  std::vector<const float*> postures{start.data()};
  for (const SearchPoint& goal : goals) postures.push_back(goal.data());
  check.settle_by_pieces(true);
  check.settle_touching(postures);
  // No proved line ends where the posture alone cannot be proved.
  SearchPath ends;
  if (certain_at(check, start))
    std::copy_if(goals.begin(), goals.end(), std::back_inserter(ends),
                 [&](const SearchPoint& goal) { return certain_at(check, goal); });
  if (ends.empty()) return result;
  Patience patience{.keep_on = keep_on, .user = user};
  result.path = search.find(quick, start, ends, &Patience::go_on, &patience);
  result.rounds = search.rounds();
  shorten(quick, result.path, joints);
  result.certain = !result.path.empty() && proved(check, result.path, joints);
  check.settle_all();
  if (result.certain) return result;
  const SearchPath found = search.find(quick, start, ends, keep_on, user);
  result.rounds += search.rounds();
  if (found.empty()) return result;
  result.path = found;
  shorten(quick, result.path, joints);
  result.certain = proved(check, result.path, joints);
  if (result.certain) return result;
  result.path = found;
  if (!proved(check, found, joints)) {
    result.path = search.find(slow, start, ends, keep_on, user);
    result.rounds += search.rounds();
    if (result.path.empty()) return result;
  }
  shorten(slow, result.path, joints);
  result.certain = true;
  return result;
}

}  // namespace twinbus
