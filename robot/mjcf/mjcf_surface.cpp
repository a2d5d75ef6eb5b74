#include "robot/mjcf/mjcf_surface.h"

#include <algorithm>

namespace twinbus::inline robot {

namespace {

constexpr double kLargest = 1e9;
constexpr double kNoWeight = 1e-15;  // of solmix

void read_condim(const MjcfElement& element, MjcfSurface& surface) {
  surface.contact.condim = element.whole("condim", surface.contact.condim);
  for (const int condim : {1, 3, 4, 6}) {
    if (surface.contact.condim == condim) return;
  }
  element.fail("condim", "must be 1, 3, 4 or 6");
}

template <std::size_t N>
void read_some(const MjcfElement& element, const char* key, std::array<double, N>& numbers) {
  const std::vector<double> given = element.numbers(key, 1, N, kLargest);
  std::copy(given.begin(), given.end(), numbers.begin());
}

void read_solver(const MjcfElement& element, MjcfSurface& surface) {
  read_condim(element, surface);
  read_some(element, "solref", surface.contact.solref);
  read_some(element, "solimp", surface.contact.solimp);
}

void check_friction(const MjcfElement& element, const std::vector<double>& friction) {
  if (std::any_of(friction.begin(), friction.end(), [](double value) { return value < 0.0; }))
    element.fail("friction", "must not be negative");
}

}  // namespace

MjcfSurface read_mjcf_surface(const MjcfElement& element) {
  MjcfSurface surface;
  const std::vector<double> friction = element.numbers("friction", 1, 3, 1e3);
  check_friction(element, friction);
  std::copy(friction.begin(), friction.end(), surface.contact.friction.begin());
  read_solver(element, surface);
  surface.priority = element.whole("priority", 0);
  surface.solmix = element.number("solmix", 1.0, 0.0, kLargest);
  return surface;
}

MjcfSurface touching(const MjcfSurface& a, const MjcfSurface& b) {
  if (a.priority != b.priority) return a.priority > b.priority ? a : b;
  MjcfSurface both = a;
  both.contact.condim = std::max(a.contact.condim, b.contact.condim);
  for (std::size_t i = 0; i < 3; ++i) both.contact.friction[i] = std::max(a.contact.friction[i], b.contact.friction[i]);
  const double sum = a.solmix + b.solmix;
  const double share = sum > kNoWeight ? a.solmix / sum : 0.5;
  const bool direct = !(a.contact.solref[0] > 0.0 && b.contact.solref[0] > 0.0);  // stiffness and damping: the smaller
  for (std::size_t i = 0; i < 2; ++i) {
    const double own = a.contact.solref[i], other = b.contact.solref[i];
    both.contact.solref[i] = direct ? std::min(own, other) : share * own + (1.0 - share) * other;
  }
  for (std::size_t i = 0; i < 5; ++i) both.contact.solimp[i] = share * a.contact.solimp[i] + (1.0 - share) * b.contact.solimp[i];
  return both;
}

MjcfSurface read_mjcf_pair(const MjcfElement& element) {
  MjcfSurface surface;
  // Two of sliding, which here are one, spinning, two of rolling.
  const std::vector<double> friction = element.numbers("friction", 1, 5, 1e3);
  check_friction(element, friction);
  if (!friction.empty()) surface.contact.friction[0] = friction[0];
  if (friction.size() > 2) surface.contact.friction[1] = friction[2];
  if (friction.size() > 3) surface.contact.friction[2] = friction[3];
  read_solver(element, surface);
  return surface;
}

}  // namespace twinbus::robot
