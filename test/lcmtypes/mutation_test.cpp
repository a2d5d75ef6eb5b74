// Damages every message at random and demands that decode() refuses it or gives something fit to be
// sent again.
//
//   mutation_test [mutations per message] [seed]

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <random>

#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/wire.h"
#include "test/lcmtypes/samples.h"

using namespace twinbus;

namespace {

// A few bytes flipped, a run overwritten, a run copied elsewhere, or the size changed.
std::size_t mutate(std::uint8_t* bytes, std::size_t size, std::size_t capacity,
                   std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::size_t changes = 1 + below(4);
  for (std::size_t i = 0; i < changes; ++i) {
    // The first 8 bytes are the type hash: mostly left alone, else nothing behind it is ever
    // reached.
    const std::size_t at = below(20) == 0 ? below(size) : 8 + below(size - 8);
    switch (below(5)) {
      case 0:
        bytes[at] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1u << below(8)));
        break;
      case 2: {
        static constexpr std::uint8_t kSpecial[] = {0x00, 0x01, 0x7f, 0x80, 0xf0, 0xff};
        const std::uint8_t value = kSpecial[below(sizeof kSpecial)];
        std::memset(bytes + at, value, std::min(size - at, 1 + below(16)));
        break;
      }
      case 3:
        std::memmove(bytes + at, bytes + below(size - 8), std::min<std::size_t>(size - at, 8));
        break;
      default:
        if (below(8) == 0) size = 9 + below(capacity - 9);
    }
    if (at >= size) break;
  }
  return size;
}

template <class T>
bool survives(long mutations, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const T good = sample<T>();
  long accepted = 0;
  for (long i = 0; i < mutations; ++i) {
    std::uint8_t bytes[2 * kLargestMessage] = {};
    const std::size_t size =
        mutate(bytes, static_cast<std::size_t>(encode(good, bytes)), sizeof bytes, random);
    // On the heap and of exactly this size, so that the address sanitizer sees one byte read too
    // far.
    const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[size]);
    std::memcpy(exact.get(), bytes, size);
    T value;
    if (decode({exact.get(), size}, value) != Status::kOk) continue;
    ++accepted;
    std::uint8_t again[kLargestMessage];
    if (encode(value, again) != Wire<T>::kBytes) {
      std::printf("%s: mutation %ld of seed %llu was accepted but is not fit to be sent\n",
                  Message<T>::getTypeName(), i, static_cast<unsigned long long>(seed));
      return false;
    }
  }
  std::printf("%-22s %ld mutations, %ld accepted, %ld refused\n", Message<T>::getTypeName(),
              mutations, accepted, mutations - accepted);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  const long mutations = argc > 1 ? std::atol(argv[1]) : 20000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 0) : 1;
  std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
  bool passed = mutations > 0;
  for_every_type([&]<class T>() { passed = survives<T>(mutations, seed) && passed; });
  return passed ? 0 : 1;
}
