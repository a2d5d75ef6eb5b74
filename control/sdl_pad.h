// The first gamepad that is plugged in, through SDL: no display, no configuration, hot-plug.  The
// one door to SDL.

#pragma once

#include <cstdint>
#include <memory>

#include "control/teleop.h"

namespace twinbus {

class SdlPad {
 public:
  // Throws std::runtime_error if SDL cannot start.  One at a time.
  SdlPad();
  ~SdlPad();
  SdlPad(const SdlPad&) = delete;
  SdlPad& operator=(const SdlPad&) = delete;

  // What the pad shows now; not connected while there is none.  Never throws, does I/O but does not
  // wait.
  void poll(PadInput& input);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A pad that exists in SDL only, for tests and for `--virtual`: what it shows comes back through
// SdlPad by SDL's own path of a real one.  Needs a living SdlPad.
class VirtualPad {
 public:
  ~VirtualPad();
  // False if SDL refuses.
  bool plug();
  void unplug();
  void set_axis(int axis, std::int16_t value);
  void set_button(std::int32_t button, bool pressed);  // one PadButton

 private:
  int device_ = -1;
  void* joystick_ = nullptr;
};

}  // namespace twinbus
