#include "control/guard/hold_words.h"

#include <bit>
#include <cstdio>
#include <span>

#include "common/math/index.h"
#include "robot/collision/thing_name.h"

namespace twinbus::inline control {

namespace {
constexpr double kQuiet = 2.0;  // who goes on asking for what is held is told so often [s]
}

const char* HoldWords::tell(std::int64_t waits, std::int64_t given_up, const Guard* guard, const GuardReport* heard,
                            std::int64_t tick) noexcept {
  if ((waits | given_up) == 0) return nullptr;
  if (given_up == 0) {
    const bool again = (waits & ~told_) == 0 && tick >= told_tick_;
    if (again && static_cast<double>(tick - told_tick_) * model_->period() < kQuiet) return nullptr;
    told_ = waits;
    told_tick_ = tick;
  }
  const std::int64_t held = given_up != 0 ? given_up : waits;
  const int cause = guard != nullptr && guard->cause().joint >= 0 ? model_->bus_index[at(guard->cause().joint)] : -1;
  const int k = cause >= 0 && (held & bit(cause)) != 0 ? cause : std::countr_zero(static_cast<std::uint64_t>(held));
  auto& text = sentences_[sentence_];
  sentence_ = (sentence_ + 1) % sentences_.size();
  const int used = std::snprintf(text.data(), text.size(), "%.40s %s", model_->joints[at(model_->bus_joints[at(k)])].name.c_str(),
                                 given_up != 0 ? "was held thrice and stays; what leads away moves it"
                                               : "is held and waits till its way is free; what leads away is obeyed");
  const std::span<char> rest = std::span(text).subspan(at(used));
  if (guard != nullptr && guard->cause().found) {
    rest[0] = ':', rest[1] = ' ';
    describe(*model_, guard->obstacles(), guard->cause(), rest.subspan(2));
  } else if (heard != nullptr && heard->pairs_near > 0) {
    const std::vector<Obstacle>& obstacles = guard != nullptr ? guard->obstacles() : none_;
    const ThingName one = thing_name(*model_, obstacles, heard->link_a[0]);
    const ThingName other = thing_name(*model_, obstacles, heard->link_b[0]);
    const int more = std::snprintf(rest.data(), rest.size(), ": %s and %s are %.1f mm apart", one.data(), other.data(),
                                   1e3 * static_cast<double>(heard->distance[0]));
    if (more < 0) rest[0] = '\0';
  }
  return text.data();
}

}  // namespace twinbus::control
