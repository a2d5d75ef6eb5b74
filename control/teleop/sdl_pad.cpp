#include "control/teleop/sdl_pad.h"

#include <SDL.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace twinbus::inline control {

struct SdlPad::Impl {
  SDL_GameController* pad = nullptr;

  void take_any() {
    for (int i = 0; pad == nullptr && i < SDL_NumJoysticks(); ++i) {
      if (SDL_IsGameController(i)) pad = SDL_GameControllerOpen(i);
    }
  }
  void drop() {
    if (pad != nullptr) SDL_GameControllerClose(pad);
    pad = nullptr;
  }
};

SdlPad::SdlPad() : impl_(std::make_unique<Impl>()) {
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");  // there is no window to have focus
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");                // Ctrl-C stays ours
  if (SDL_Init(SDL_INIT_GAMECONTROLLER | SDL_INIT_EVENTS) != 0) {
    throw std::runtime_error(std::string("gamepad: SDL cannot start: ") + SDL_GetError() +
                             "; use --keyboard");
  }
}

SdlPad::~SdlPad() {
  impl_->drop();
  SDL_Quit();
}

void SdlPad::poll(PadInput& input) {
  SDL_JoystickUpdate();
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) {
    // Only to empty the queue and to learn of unplugging: the state is asked for below.
  }
  input = {};
  if (impl_->pad != nullptr && SDL_GameControllerGetAttached(impl_->pad) == SDL_FALSE) {
    impl_->drop();
    return;
  }
  impl_->take_any();
  SDL_GameController* pad = impl_->pad;
  if (pad == nullptr) return;
  input.connected = true;
  for (int i = 0; i < 6; ++i) {
    input.axes[static_cast<std::size_t>(i)] =
        SDL_GameControllerGetAxis(pad, static_cast<SDL_GameControllerAxis>(i));
  }
  for (int i = 0; i < 15; ++i) {
    if (SDL_GameControllerGetButton(pad, static_cast<SDL_GameControllerButton>(i)) != 0) {
      input.buttons |= 1 << i;
    }
  }
  const char* name = SDL_GameControllerName(pad);
  std::snprintf(input.name.data(), input.name.size(), "%s", name == nullptr ? "pad" : name);
  // The message promises ASCII.
  for (char& c : input.name) {
    if (c != '\0' && (c < ' ' || c > '~')) c = '?';
  }
}

void SdlPad::rumble(double seconds) {
  constexpr Uint16 kStrong = 0xc000;
  if (impl_->pad != nullptr)
    (void)SDL_GameControllerRumble(impl_->pad, kStrong, kStrong,
                                   static_cast<Uint32>(1e3 * seconds));
}

int SdlPad::take_mappings(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return -1;
  return SDL_GameControllerAddMappingsFromFile(file.c_str());
}

bool RawSdlPad::open() {
  SDL_JoystickUpdate();
  if (joystick_ == nullptr && SDL_NumJoysticks() > 0) joystick_ = SDL_JoystickOpen(0);
  auto* joystick = static_cast<SDL_Joystick*>(joystick_);
  if (joystick == nullptr) return false;
  const auto count = [](int n) { return static_cast<std::size_t>(n > 0 ? n : 0); };
  axes_.resize(count(SDL_JoystickNumAxes(joystick)));
  buttons_.resize(count(SDL_JoystickNumButtons(joystick)));
  hats_.resize(count(SDL_JoystickNumHats(joystick)));
  return true;
}

RawSdlPad::~RawSdlPad() {
  auto* joystick = static_cast<SDL_Joystick*>(joystick_);
  if (joystick != nullptr && SDL_WasInit(SDL_INIT_JOYSTICK) != 0) SDL_JoystickClose(joystick);
}

const RawPad& RawSdlPad::poll() {
  auto* joystick = static_cast<SDL_Joystick*>(joystick_);
  SDL_JoystickUpdate();
  for (std::size_t i = 0; i < axes_.size(); ++i)
    axes_[i] = SDL_JoystickGetAxis(joystick, static_cast<int>(i));
  for (std::size_t i = 0; i < buttons_.size(); ++i)
    buttons_[i] = SDL_JoystickGetButton(joystick, static_cast<int>(i));
  for (std::size_t i = 0; i < hats_.size(); ++i)
    hats_[i] = SDL_JoystickGetHat(joystick, static_cast<int>(i));
  raw_ = {axes_, buttons_, hats_};
  return raw_;
}

std::string RawSdlPad::guid() const {
  char text[33];
  SDL_JoystickGetGUIDString(SDL_JoystickGetGUID(static_cast<SDL_Joystick*>(joystick_)), text,
                            sizeof text);
  return text;
}

std::string RawSdlPad::name() const {
  const char* name = SDL_JoystickName(static_cast<SDL_Joystick*>(joystick_));
  return name == nullptr ? "pad" : name;
}

VirtualPad::~VirtualPad() { unplug(); }

bool VirtualPad::plug() {
  if (device_ >= 0) return true;
  SDL_VirtualJoystickDesc description;
  SDL_zero(description);
  description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
  description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
  description.naxes = 6;
  description.nbuttons = 15;
  description.vendor_id = 0x045e;  // as an Xbox 360 pad, for which SDL has a mapping
  description.product_id = 0x028e;
  description.name = "virtual pad";
  description.userdata = &rumbles_;
  description.Rumble = [](void* count, Uint16 low, Uint16 high) {
    if (low != 0 || high != 0) ++*static_cast<int*>(count);
    return 0;
  };
  device_ = SDL_JoystickAttachVirtualEx(&description);
  if (device_ < 0) return false;
  joystick_ = SDL_JoystickOpen(device_);
  return joystick_ != nullptr;
}

void VirtualPad::unplug() {
  if (device_ < 0) return;
  if (joystick_ != nullptr) SDL_JoystickClose(static_cast<SDL_Joystick*>(joystick_));
  SDL_JoystickDetachVirtual(device_);
  device_ = -1;
  joystick_ = nullptr;
}

void VirtualPad::set_axis(int axis, std::int16_t value) {
  if (joystick_ == nullptr) return;
  SDL_JoystickSetVirtualAxis(static_cast<SDL_Joystick*>(joystick_), axis, value);
}

void VirtualPad::set_button(std::int32_t button, bool pressed) {
  if (joystick_ == nullptr) return;
  for (int i = 0; i < 15; ++i) {
    if (button != 1 << i) continue;
    SDL_JoystickSetVirtualButton(static_cast<SDL_Joystick*>(joystick_), i,
                                 pressed ? SDL_PRESSED : SDL_RELEASED);
  }
}

}  // namespace twinbus::control
