// Whatever bytes come on whatever channel: decode() must neither crash nor let through what it
// would not send itself.
//
// The first byte chooses the message type, and bytes 1..8 of a datagram of the right size are made
// its fingerprint, so that the fuzzer gets past the door.

#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/wire.h"
#include "test/lcmtypes/samples.h"

using namespace twinbus;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::uint8_t chosen = data[0];
  std::uint8_t number = 0;
  for_every_type([&]<class T>() {
    if (number++ != chosen % 20) return;
    std::vector<std::uint8_t> bytes(data + 1, data + size);
    if (chosen & 0x80) bytes.resize(Wire<T>::kBytes);
    if (bytes.size() == static_cast<std::size_t>(Wire<T>::kBytes)) {
      const auto hash = static_cast<std::uint64_t>(Message<T>::getHash());
      for (std::size_t i = 0; i < 8; ++i)
        bytes[i] = static_cast<std::uint8_t>(hash >> (56 - 8 * i));
    }
    T value;
    if (decode(bytes, value) != Status::kOk) return;
    std::array<std::uint8_t, kLargestMessage> again;
    if (encode(value, again) != Wire<T>::kBytes) std::abort();
  });
  return 0;
}
