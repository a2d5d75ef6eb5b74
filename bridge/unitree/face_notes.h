// What a robot's face says of the program that drives it: one line per fault and occasion, with the remedy.

#pragma once

#include <array>
#include <cstdint>

namespace twinbus::inline bridge {

enum class FaceNote : std::int8_t {
  kProgramBegins = 0,
  kSilent,
  kPaused,
  kStopped,
  kSize,
  kCrc,
  kNotFinite,
  kGain,
  kMotorMode,
  kLevel,
  kModePr,
  kModeMachine,
  kTooOld,
  kSecondWriter,
  kTooFast,
  kOtherController,
  kCount
};

struct FaceLine {
  std::array<char, 190> text{};  // an EVENT has 200, the sender's name included
  int severity = 0;  // 0 information, 1 warning
};

class FaceNotes {
 public:
  // A fault that goes on is told once; one that has not been seen for so long is told again.
  static constexpr std::int64_t kQuiet = 10'000'000'000;  // [ns]

  __attribute__((format(printf, 5, 6))) void add(FaceNote note, int severity, std::int64_t now_ns, const char* format,
                                                 ...) noexcept;
  // The oldest line that has not been taken.
  bool take(FaceLine& line) noexcept;
  std::int64_t count(FaceNote note) const noexcept { return count_[static_cast<std::size_t>(note)]; }

 private:
  static constexpr std::size_t kNotes = static_cast<std::size_t>(FaceNote::kCount);
  std::array<std::int64_t, kNotes> count_{}, seen_ns_{};
  std::array<FaceLine, kNotes> waiting_{};  // a ring; more than one of each kind never waits
  std::size_t first_ = 0, held_ = 0;
};

}  // namespace twinbus::bridge
