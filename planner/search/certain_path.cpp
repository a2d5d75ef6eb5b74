#include "planner/search/certain_path.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

#include "common/math/index.h"

namespace twinbus::inline planner {

namespace {

// Answers of a line test, kept: what was found blocked, by looking or by a proof that failed, is not asked for again.
class KeptAnswers : public LineTest {
 public:
  explicit KeptAnswers(LineTest& test) : test_(&test) {}

  bool free(const SearchPoint& from, const SearchPoint& step, float length) override {
    const bool answer = test_->free(from, step, length);
    lines_.push_back({from, step, answer});
    return answer;
  }
  // As the test is now, or was when it was asked.
  bool was_free(const SearchPoint& from, const SearchPoint& step, float length) {
    for (const Line& line : lines_) {
      if (line.from == from && line.step == step) return line.free;
    }
    return test_->free(from, step, length);
  }
  void refute(const SearchPoint& from, const SearchPoint& step) { lines_.insert(lines_.begin(), {from, step, false}); }

 private:
  struct Line {
    SearchPoint from, step;
    bool free;
  };
  LineTest* test_;
  std::vector<Line> lines_;
};

class CertainLineTest : public LineTest {
 public:
  CertainLineTest(BlockCheck& check, KeptAnswers& quick) : check_(&check), quick_(&quick) {}

  bool free(const SearchPoint& from, const SearchPoint& step, float length) override {
    return quick_->was_free(from, step, length) && check_->line_certain(from.data(), step.data());
  }

 private:
  BlockCheck* check_;
  KeptAnswers* quick_;
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

// Leaves a check as whoever asks next expects it.
class AsAtFirst {
 public:
  explicit AsAtFirst(BlockCheck& check) : check_(&check) {}
  ~AsAtFirst() { check_->settle_as_at_first(); }
  AsAtFirst(const AsAtFirst&) = delete;
  AsAtFirst& operator=(const AsAtFirst&) = delete;

 private:
  BlockCheck* check_;
};

SearchPoint between(const SearchPoint& from, const SearchPoint& to, int joints) {
  SearchPoint step{};
  for (std::size_t j = 0; j < at(joints); ++j) step[j] = to[j] - from[j];
  return step;
}

// Is every line?  The first that is not is kept as blocked.
bool proved(BlockCheck& check, KeptAnswers& quick, const SearchPath& path, int joints) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const SearchPoint step = between(path[i], path[i + 1], joints);
    if (check.line_certain(path[i].data(), step.data())) continue;
    quick.refute(path[i], step);
    return false;
  }
  return true;
}

// The path made shorter by looking alone, which is quick, or, where that leaves a line that cannot be proved, by proofs.  Empty
// when it is not proved as it is.
SearchPath shortened(BlockCheck& check, LineTest& quick, const SearchPath& found) {
  const int joints = check.robot().joints;
  KeptAnswers kept(quick);
  SearchPath path = found;
  shorten(kept, path, joints);
  if (proved(check, kept, path, joints)) return path;
  if (!proved(check, kept, found, joints)) return {};
  path = found;
  CertainLineTest slow(check, kept);
  shorten(slow, path, joints);
  return path;
}

}  // namespace

bool certain_at(BlockCheck& check, const SearchPoint& q) {
  static constexpr SearchPoint kNowhere{};
  return check.line_certain(q.data(), kNowhere.data());
}

CertainPath find_certain(JointSearch& search, BlockCheck& check, float density,
                         const SearchPoint& start, const SearchPath& goals, bool (*keep_on)(void*),
                         void* user) {
  BlockLineTest quick(check, density);
  CertainPath result;
  // Balls are quick and leave room: at first hulls, and pieces of what they do not part, settle only what touches at the ends.
  std::vector<const float*> postures{start.data()};
  for (const SearchPoint& goal : goals) postures.push_back(goal.data());
  check.settle_by_pieces(true);
  check.settle_touching(postures);
  const AsAtFirst when_done(check);
  // No proved line ends where the posture alone cannot be proved.
  SearchPath ends;
  if (certain_at(check, start))
    std::copy_if(goals.begin(), goals.end(), std::back_inserter(ends),
                 [&](const SearchPoint& goal) { return certain_at(check, goal); });
  result.ends_certain = !ends.empty();
  if (ends.empty()) return result;
  const auto find = [&](LineTest& test, bool (*go_on)(void*), void* of) {
    SearchPath found = search.find(test, start, ends, go_on, of);
    result.rounds += search.rounds();
    return found;
  };
  Patience patience{.keep_on = keep_on, .user = user};
  result.path = shortened(check, quick, find(quick, &Patience::go_on, &patience));
  if (result.path.empty()) {
    check.settle_all();
    const SearchPath found = find(quick, keep_on, user);
    if (found.empty()) return result;  // settled by all already
    result.path = shortened(check, quick, found);
  }
  if (result.path.empty()) {
    KeptAnswers none(quick);
    CertainLineTest slow(check, none);
    result.path = find(slow, keep_on, user);
    shorten(slow, result.path, check.robot().joints);
  }
  result.certain = !result.path.empty();
  return result;
}

}  // namespace twinbus::planner
