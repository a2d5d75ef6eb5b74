// A mapping for a pad that SDL does not know, learned by asking for one button or stick after another.
//
// Fed with what the pad shows raw; gives a line in SDL's own format (gamecontrollerdb), to be kept in a file.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace twinbus::inline control {

// Raw: as the driver numbers them.
struct RawPad {
  std::span<const std::int16_t> axes;
  std::span<const std::uint8_t> buttons;  // 1 while pressed
  std::span<const std::uint8_t> hats;     // bits: 1 up, 2 right, 4 down, 8 left
};

class PadMapper {
 public:
  // What the pad shows while nobody touches it.
  void rest(const RawPad& raw);

  // What to ask for next, as a sentence; empty when everything has been learned.
  std::string question() const;
  // Looks at the pad; true when the question has been answered and the control has been let go.
  bool look(const RawPad& raw);
  // The pad has no such control.
  void skip();

  // SDL's line; guid: 32 hexadecimal digits.
  std::string line(const std::string& guid, const std::string& name) const;

 private:
  std::size_t step_ = 0;
  std::vector<std::int16_t> rest_;
  std::string held_;  // the control that answers the question, until it is let go
  std::vector<std::pair<std::string, std::string>> learned_;
};

}  // namespace twinbus::control
