#include "control/teleop/pad_mapping.h"

#include <array>
#include <cstdlib>
#include <utility>

namespace twinbus::inline control {

namespace {

struct Step {
  const char* name;  // SDL's
  const char* question;
};

constexpr std::array<Step, 16> kSteps = {{
    {"a", "press the lower button (A, cross)"},
    {"b", "press the right button (B, circle): it will stop the robot"},
    {"x", "press the left button (X, square)"},
    {"y", "press the upper button (Y, triangle)"},
    {"leftshoulder", "press the left shoulder button: the dead-man"},
    {"rightshoulder", "press the right shoulder button"},
    {"back", "press back or select"},
    {"start", "press start"},
    {"dpup", "press up on the cross"},
    {"dpdown", "press down on the cross"},
    {"leftx", "push the left stick to the right"},
    {"lefty", "pull the left stick towards you"},
    {"rightx", "push the right stick to the right"},
    {"righty", "pull the right stick towards you"},
    {"lefttrigger", "pull the left trigger"},
    {"righttrigger", "pull the right trigger"},
}};
constexpr int kMoved = 16000, kNearRest = 8000;  // of 32767

}  // namespace

void PadMapper::rest(const RawPad& raw) { rest_.assign(raw.axes.begin(), raw.axes.end()); }

std::string PadMapper::question() const {
  return step_ < kSteps.size() ? kSteps[step_].question : "";
}

void PadMapper::skip() {
  held_.clear();
  if (step_ < kSteps.size()) ++step_;
}

bool PadMapper::look(const RawPad& raw) {
  if (step_ >= kSteps.size()) return false;
  std::string moved;
  bool quiet = true;
  for (std::size_t i = 0; i < raw.buttons.size(); ++i) {
    if (raw.buttons[i] != 0) moved = std::string("b").append(std::to_string(i));
  }
  for (std::size_t i = 0; i < raw.hats.size(); ++i) {
    if (raw.hats[i] != 0)
      moved = std::string("h").append(std::to_string(i)) + "." + std::to_string(raw.hats[i]);
  }
  for (std::size_t i = 0; i < raw.axes.size(); ++i) {
    const int from_rest = raw.axes[i] - (i < rest_.size() ? rest_[i] : 0);
    if (std::abs(from_rest) > kNearRest) quiet = false;
    // Right and towards oneself are positive in SDL; a pad that counts the other way is turned round.
    if (std::abs(from_rest) > kMoved && moved.empty()) {
      moved = std::string("a").append(std::to_string(i));
      if (from_rest < 0) moved += "~";
    }
  }
  quiet = quiet && moved.empty();
  if (held_.empty()) {
    held_ = moved;
    return false;
  }
  if (!quiet) return false;
  for (const auto& [name, control] : learned_) {
    if (control != held_) continue;
    held_.clear();  // this one has another meaning already: asked again
    return false;
  }
  learned_.emplace_back(kSteps[step_].name, std::exchange(held_, {}));
  ++step_;
  return true;
}

std::string PadMapper::line(const std::string& guid, const std::string& name) const {
  std::string text = guid + ",";
  for (const char c : name) text += c == ',' ? ' ' : c;
  for (const auto& [control, raw] : learned_) text += "," + control + ":" + raw;
  return text + ",platform:Linux,";
}

}  // namespace twinbus::control
