#include "control/sdl_pad.h"

#include <SDL2/SDL.h>

#include <cstdio>
#include <stdexcept>
#include <string>

namespace twinbus {

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
  if (impl_->pad != nullptr && SDL_GameControllerGetAttached(impl_->pad) == SDL_FALSE) {
    impl_->drop();
  }
  impl_->take_any();
  input = {};
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

}  // namespace twinbus
