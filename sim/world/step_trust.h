// Whether a step of an engine is to be trusted, said in that step, and how often it was not.
//
// A doubt is no failure: the step was taken.  It says that the result may be wrong by more than the
// step's own error.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace twinbus::inline sim {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

enum class Doubt {
  kUnconverged,  // the contacts did not settle even in the smallest part of the step
  kUnsettled,    // a joint ended on a wrong piece of its law
  kEnergy,       // there is more energy than servos, pushes and springs have given
  kDeep,         // a contact was first seen deeper than its speed explains
  kThrough,      // a contact is deeper than half of what it touches: it may come out behind it
  kCoarse,       // its steps add up to an error: sim/engine/local_error.h; with half the step it would be elsewhere: twinned_world.h
};
inline constexpr std::size_t kDoubts = 6;
inline constexpr const char* kDoubtNames[kDoubts] = {"unconverged", "unsettled", "energy_gained",
                                                     "first_seen_deep", "tunnelling", "step_too_coarse"};

// A contact that nothing says why it is deeper when it is first seen is doubted [m].
inline constexpr double kFirstDepth = 2e-3;

// Of each doubt that has a size, the least limit with which no step of a run would have had it.  A run whose error was measured
// is doubted beyond what it came to there: what these say of it is then known, and only more is news.
struct TrustBands {
  double off = 0.0;    // what steps add up to: sim/engine/local_error.h [m]
  double gain = 0.0;   // of energy in a step [J]
  double rise = 0.0;   // of energy over the least there was [J]
  double depth = 0.0;  // of a contact first seen too deep [m]
  bool operator==(const TrustBands&) const = default;

  // So many times each; nothing of one that has no bound.
  TrustBands times(double factor) const noexcept {
    const auto each = [factor](double band) { return std::isfinite(band) ? factor * band : 0.0; };
    return {each(off), each(gain), each(rise), each(depth)};
  }
};

// Of one step.
struct StepTrust {
  std::array<bool, kDoubts> doubt{};
  double first_depth = 0.0;  // of the deepest contact that was first seen too deep [m]

  bool& operator[](Doubt d) noexcept { return doubt[static_cast<std::size_t>(d)]; }
  bool operator[](Doubt d) const noexcept { return doubt[static_cast<std::size_t>(d)]; }
  // A contact seen no deeper than that is no news.
  void know(const TrustBands& bands) noexcept {
    if (first_depth <= bands.depth) (*this)[Doubt::kDeep] = false;
  }
  bool any() const noexcept {
    return std::any_of(doubt.begin(), doubt.end(), [](bool each) { return each; });
  }
};

// Of a run.
struct TrustCounts {
  std::array<long, kDoubts> steps{};  // with that doubt
  long doubted = 0;                   // with any
  double first_at = -1.0;             // the first of them [s]
  Doubt first = Doubt::kUnconverged, last = Doubt::kUnconverged;
  double energy_gain = 0.0;  // the most in a step [J]
  double first_depth = 0.0;  // the most [m]

  void add(const StepTrust& step, double gain, double time) noexcept {
    energy_gain = std::max(energy_gain, gain);
    first_depth = std::max(first_depth, step.first_depth);
    if (!step.any()) return;
    const auto worst = std::find(step.doubt.begin(), step.doubt.end(), true) - step.doubt.begin();
    last = static_cast<Doubt>(worst);
    if (doubted++ == 0) {
      first_at = time;
      first = last;
    }
    for (std::size_t i = 0; i < kDoubts; ++i) steps[i] += step.doubt[i] ? 1 : 0;
  }
};

}  // namespace twinbus::sim
