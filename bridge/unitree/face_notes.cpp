#include "bridge/unitree/face_notes.h"

#include <cstdarg>
#include <cstddef>
#include <cstdio>

namespace twinbus::inline bridge {

void FaceNotes::add(FaceNote note, int severity, std::int64_t now_ns, const char* format, ...) noexcept {
  const auto i = static_cast<std::size_t>(note);
  const bool told = count_[i]++ > 0 && now_ns - seen_ns_[i] < kQuiet;
  seen_ns_[i] = now_ns;
  if (told || held_ == kNotes) return;
  FaceLine& line = waiting_[(first_ + held_++) % kNotes];
  line.severity = severity;
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line.text.data(), line.text.size(), format, arguments);
  va_end(arguments);
}

bool FaceNotes::take(FaceLine& line) noexcept {
  if (held_ == 0) return false;
  line = waiting_[first_];
  first_ = (first_ + 1) % kNotes;
  --held_;
  return true;
}

}  // namespace twinbus::bridge
