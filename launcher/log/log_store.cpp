#include "launcher/log/log_store.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "lcmtypes/bus/wire.h"
#include "lcmtypes/msg/journal.h"
#include "viewer_log/log/message_schema.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::int64_t kKeepTicks = 4'000'000;      // [us]
constexpr std::int64_t kKeepDemands = 900'000'000;  // [us]
constexpr std::size_t kMostTicks = 100'000, kMostDemands = 50'000;
constexpr std::array kOnDemand = {"MODE_REQUEST", "WALK", "ARM_GOAL",
                                  "ARM_PATH",     "STOP", "OBSTACLES"};

const MessageSchema* schema_of(const std::string& channel) {
  const ChannelInfo* info = find_channel(channel.c_str());
  return info == nullptr ? nullptr : find_schema(info->type);
}

// The hash without compute_ns.
std::int64_t plain_hash(const std::string& channel, std::vector<std::uint8_t> bytes) {
  if (channel == "GUARD" || channel == "CONTROLLER_STATUS") {
    const MessageSchema* schema = schema_of(channel);
    const int field = schema->find("compute_ns");
    const std::size_t offset = schema->fields[static_cast<std::size_t>(field)].offset;
    if (bytes.size() == schema->bytes) std::memset(bytes.data() + offset, 0, 4);
  }
  return content_hash(bytes);
}

}  // namespace

LogStore::LogStore() {
  shelves_[0].keep_us = kKeepTicks;
  shelves_[0].most = kMostTicks;
  shelves_[1].keep_us = kKeepDemands;
  shelves_[1].most = kMostDemands;
}

bool LogStore::on_demand(const std::string& channel) {
  return std::find(kOnDemand.begin(), kOnDemand.end(), channel) != kOnDemand.end();
}

void LogStore::drop_front(Shelf& shelf) {
  const StoredMessage& front = shelf.messages.front();
  for (const std::int64_t hash : {front.hash, front.plain_hash}) {
    const auto found = places_.find(hash);
    if (found != places_.end() && found->second.number == shelf.first &&
        &shelves_[found->second.shelf] == &shelf) {
      places_.erase(found);
    }
  }
  shelf.messages.pop_front();
  ++shelf.first;
}

void LogStore::add(const std::string& channel, std::int64_t utime,
                   std::vector<std::uint8_t> bytes) {
  const int which = on_demand(channel) ? 1 : 0;
  Shelf& shelf = shelves_[which];
  while (!shelf.messages.empty() && (utime - shelf.messages.front().utime > shelf.keep_us ||
                                     shelf.messages.size() >= shelf.most)) {
    drop_front(shelf);
  }
  StoredMessage message;
  message.channel = channel;
  message.utime = utime;
  message.hash = content_hash(bytes);
  message.plain_hash = plain_hash(channel, bytes);
  message.bytes = std::move(bytes);
  const Place place{which, shelf.first + static_cast<std::int64_t>(shelf.messages.size())};
  places_[message.hash] = place;
  places_[message.plain_hash] = place;
  shelf.messages.push_back(std::move(message));
}

const StoredMessage* LogStore::find(std::int64_t hash) const {
  const auto found = places_.find(hash);
  if (found == places_.end()) return nullptr;
  const Shelf& shelf = shelves_[found->second.shelf];
  return &shelf.messages[static_cast<std::size_t>(found->second.number - shelf.first)];
}

const StoredMessage* LogStore::look(const std::string& channel,
                                    const std::function<bool(const StoredMessage&)>& visit) const {
  const Shelf& shelf = shelves_[on_demand(channel) ? 1 : 0];
  for (auto it = shelf.messages.rbegin(); it != shelf.messages.rend(); ++it) {
    if (it->channel == channel && visit(*it)) return &*it;
  }
  return nullptr;
}

// Every step of content_hash can be taken back, so the word that a place must have had follows from what is before it and
// from the hash and what is behind it: one pass over the message, not one for each bit.
std::vector<std::uint8_t> with_one_bit_mended(std::vector<std::uint8_t> bytes, std::int64_t hash,
                                              std::size_t& byte) {
  std::vector<std::uint64_t> before;  // the hash of what lies before each word
  std::vector<std::uint64_t> words;
  HashSteps steps(bytes.size());
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    words.push_back(HashSteps::word_at(bytes, at));
    before.push_back(steps.hash());
    steps.take(words.back());
  }
  std::uint64_t after = static_cast<std::uint64_t>(hash);
  for (std::size_t i = words.size(); i-- > 0;) {
    const std::uint64_t mixed =
        HashSteps::undone(after);  // what was before this word, with the word in it
    const std::uint64_t flipped = mixed ^ before[i] ^ words[i];
    if (std::has_single_bit(flipped)) {
      byte = 8 * i + static_cast<std::size_t>(std::countr_zero(flipped)) / 8;
      if (byte < bytes.size()) {
        bytes[byte] =
            static_cast<std::uint8_t>(bytes[byte] ^ (1U << (std::countr_zero(flipped) % 8)));
        return bytes;
      }
    }
    after = mixed ^ words[i];
  }
  return {};
}

std::string first_difference(const std::string& channel, const std::vector<std::uint8_t>& logged,
                             const std::vector<std::uint8_t>& now, const char* word_for_now) {
  const MessageSchema* schema = schema_of(channel);
  if (schema == nullptr || logged.size() != schema->bytes || now.size() != schema->bytes) {
    return std::string("size: ").append(std::to_string(logged.size())) + " bytes in the log, " +
           std::to_string(now.size()) + " " + word_for_now;
  }
  for (const MessageField& field : schema->fields) {
    const std::size_t at = field.offset;
    if (field.name == "compute_ns") continue;
    if (std::memcmp(logged.data() + at, now.data() + at, size_of(field.type)) == 0) continue;
    std::string text = field.name + ": ";
    append_field(text, field, logged);
    text += " in the log, ";
    append_field(text, field, now);
    return text + " " + word_for_now;
  }
  return "";
}

}  // namespace twinbus::launcher
