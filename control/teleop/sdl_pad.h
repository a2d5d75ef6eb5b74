// The first gamepad that is plugged in, through SDL: no display, no configuration, hot-plug.  The
// one door to SDL.

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "control/teleop/pad_mapping.h"
#include "control/teleop/teleop.h"

namespace twinbus::inline control {

class SdlPad {
 public:
  // Throws std::runtime_error if SDL cannot start.  One at a time.
  SdlPad();
  ~SdlPad();
  SdlPad(const SdlPad&) = delete;
  SdlPad& operator=(const SdlPad&) = delete;

  // Mappings learned with --map: how many the file has for this system, -1 when it cannot be read.
  int take_mappings(const std::string& file);
  // What the pad shows now; not connected while there is none, nor at once after one has vanished: the next one is
  // another, that nobody has taken hold of.  Never throws, does I/O but does not wait.
  void poll(PadInput& input);
  // Shakes the pad, if it can.
  void rumble(double seconds);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The first joystick that is plugged in, as its driver shows it: for a pad without a mapping.
class RawSdlPad {
 public:
  // Needs a living SdlPad.  False while there is none.
  bool open();
  ~RawSdlPad();
  const RawPad& poll();
  std::string guid() const;
  std::string name() const;

 private:
  void* joystick_ = nullptr;
  std::vector<std::int16_t> axes_;
  std::vector<std::uint8_t> buttons_, hats_;
  RawPad raw_;
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
  int rumbles() const { return rumbles_; }             // how often it has been shaken

 private:
  int device_ = -1, rumbles_ = 0;
  void* joystick_ = nullptr;
};

}  // namespace twinbus::control
