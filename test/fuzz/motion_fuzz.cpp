// Motion files are somebody else's: whatever the bytes, a motion whose numbers are finite and fit together comes out, or one error.

#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "robot/motion/motion_file.h"

using namespace twinbus;

namespace {

void check(const MotionFile& motion) {
  const std::size_t frames = motion.time.size();
  if (motion.q.size() != frames * motion.joints.size() || (!motion.root.empty() && motion.root.size() != frames)) std::abort();
  for (std::size_t i = 0; i < frames; ++i) {
    if (!std::isfinite(motion.time[i]) || (i > 0 && !(motion.time[i] > motion.time[i - 1]))) std::abort();
  }
  for (const double q : motion.q) {
    if (!std::isfinite(q)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  for (const bool named : {true, false}) {
    MotionFormat format;
    format.rate = named ? 0.0 : 30.0;
    if (!named) format.columns = {"a", "-", "bb"};
    try {
      check(bytes.starts_with("PK") ? parse_motion_npz("m", bytes, format) : parse_motion_csv("m", bytes, format));
    } catch (const std::runtime_error&) {
    }
  }
  return 0;
}
