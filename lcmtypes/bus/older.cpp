#include "lcmtypes/bus/older.h"

#include <algorithm>
#include <cstddef>

namespace twinbus::inline lcmtypes {

namespace {

constexpr std::size_t kFingerprint = 8;  // bytes at the head of a message

struct OlderPart {
  std::size_t from, to, bytes;  // in the older message, in that of now
};

struct OlderMessage {
  std::span<const std::uint8_t> fingerprint;
  std::size_t size;
  std::span<const std::uint8_t> blank;  // of now, with its fingerprint, and what the older one does not say
  std::span<const OlderPart> parts;
};

}  // namespace

}  // namespace twinbus::lcmtypes

#include "lcmtypes/bus/older_messages.h"  // made by lcmtypes/generate.py

namespace twinbus::inline lcmtypes {

namespace {

bool begins_with(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> head) noexcept {
  return std::equal(head.begin(), head.end(), bytes.begin());
}

}  // namespace

std::span<const std::uint8_t> renewed(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> room) noexcept {
  for (const OlderMessage& older : kOlderMessages) {
    const std::size_t size = older.blank.size();
    if (bytes.size() != older.size || room.size() < size || !begins_with(bytes, older.fingerprint)) continue;
    std::copy(older.blank.begin(), older.blank.end(), room.begin());
    for (const OlderPart& part : older.parts) {
      std::ranges::copy(bytes.subspan(part.from, part.bytes), room.subspan(part.to).begin());
    }
    return room.first(size);
  }
  return bytes;
}

std::span<const std::uint8_t> as_before(std::span<const std::uint8_t> bytes, std::span<std::uint8_t> room) noexcept {
  for (const OlderMessage& older : kOlderMessages) {
    const std::span<const std::uint8_t> fingerprint = older.blank.first(kFingerprint);
    if (bytes.size() != older.blank.size() || room.size() < older.size || !begins_with(bytes, fingerprint)) continue;
    std::copy(older.fingerprint.begin(), older.fingerprint.end(), room.begin());
    for (const OlderPart& part : older.parts) {
      std::ranges::copy(bytes.subspan(part.to, part.bytes), room.subspan(part.from).begin());
    }
    return room.first(older.size);
  }
  return {};
}

}  // namespace twinbus::lcmtypes
