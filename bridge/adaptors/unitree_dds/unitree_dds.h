// Unitree's low-level topics and its motion service on DDS (Eclipse CycloneDDS): the only code that calls it.
//
// Either end: kRobot writes rt/lowstate and reads rt/lowcmd, kProgram the opposite.  Frames go in and out as the bytes of
// bridge/unitree/frames.h, unjudged; DDS's own threads receive them, fileno() says when there are some, so one thread waits for
// these and for the bus.
//
// DDS knows no passwords: whoever reaches its ports on the interface can command.  A linked-in second CycloneDDS of another
// version does not work in one process, so only one program and a driver link this library.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "bridge/unitree/frames.h"
#include "bridge/unitree/low_frames.h"
#include "bridge/unitree/motion_service.h"

namespace twinbus::inline bridge {

struct DdsOptions {
  std::string interface = "lo";  // network interface by name; it must be named, since an automatic choice can hang
  int domain = 0;
};

struct DdsSample {
  std::span<const std::byte> bytes;  // until the next take()
  std::uint64_t writer = 0;          // tells writers apart; never 0
  std::int64_t stamp_ns = 0;         // by the writer's wall clock
};

class UnitreeDds {
 public:
  enum class Side : std::int8_t { kRobot, kProgram };

  // Throws std::runtime_error naming the interface when DDS cannot be opened there.
  UnitreeDds(UnitreeFamily family, Side side, const DdsOptions& options);
  ~UnitreeDds();
  UnitreeDds(const UnitreeDds&) = delete;
  UnitreeDds& operator=(const UnitreeDds&) = delete;

  // Readable when take() or serve() has something to do; quiet() before these makes it unreadable again.
  int fileno() const noexcept { return event_; }
  void quiet() noexcept;

  // The next frame that came on the topic that is read, oldest first; false: none is left.  Never throws, does not block.
  bool take(DdsSample& sample) noexcept;
  // A LowState or LowCmd, whole; false if it could not be sent.
  [[nodiscard]] bool write(std::span<const std::byte> frame) noexcept;

  // kRobot: answers the calls of the vendor's motion service that have come, as released.
  void serve() noexcept;

 private:
  void open_frames(UnitreeFamily family);
  void open_service();
  void close() noexcept;

  Side side_;
  int event_ = -1;
  std::size_t read_bytes_ = 0, write_bytes_ = 0;
  std::int32_t domain_ = 0, participant_ = 0, reader_ = 0, writer_ = 0, calls_ = 0, answers_ = 0;
  alignas(8) std::array<std::byte, kLargestFrame> taken_{}, sent_{};
};

}  // namespace twinbus::bridge
