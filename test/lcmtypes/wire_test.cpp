#include "lcmtypes/bus/wire.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lcmtypes/bus/convert.h"
#include "lcmtypes/bus/older.h"
#include "lcmtypes/msg/robot_io.h"
#include "test/lcmtypes/layout.h"
#include "test/lcmtypes/samples.h"

namespace twinbus {
namespace {

template <class T>
std::vector<std::uint8_t> bytes_of(const T& value) {
  std::vector<std::uint8_t> bytes(kLargestMessage);
  bytes.resize(static_cast<std::size_t>(encode(value, bytes)));
  return bytes;
}

// LCM is big-endian.
void put(std::vector<std::uint8_t>& bytes, std::size_t offset, std::uint64_t bits,
         std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes[offset + i] = static_cast<std::uint8_t>(bits >> (8 * (size - 1 - i)));
  }
}
void put_number(std::vector<std::uint8_t>& bytes, const FieldElement& at, double value) {
  if (at.size == 8) {
    put(bytes, at.offset, std::bit_cast<std::uint64_t>(value), 8);
  } else {
    put(bytes, at.offset, std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
  }
}
bool is_real(const FieldElement& e) { return e.type == "double" || e.type == "float"; }

TEST(Wire, SizesAreThoseOfTheProtocol) {
  EXPECT_EQ(Wire<RobotState>::kBytes, 1113);
  EXPECT_EQ(Wire<JointCommand>::kBytes, 1200);
  EXPECT_EQ(Wire<StopPlanPiece>::kBytes, 1224);
  EXPECT_EQ(Wire<StopRequest>::kBytes, 34);
}

TEST(Wire, EncodedSizesFitOneEthernetFrameAndMatchTheTable) {
  for_every_type([]<class T>() {
    EXPECT_EQ(Message<T>().getEncodedSize(), Wire<T>::kBytes) << Message<T>::getTypeName();
    EXPECT_LE(Wire<T>::kBytes, kLargestMessage) << Message<T>::getTypeName();
    const auto layout = layout_of(Message<T>::getTypeName());
    EXPECT_EQ(layout.back().offset + layout.back().size, static_cast<std::size_t>(Wire<T>::kBytes))
        << Message<T>::getTypeName();
  });
}

TEST(Wire, EveryChannelHasOneRowAndEveryTypeItsOwnFingerprint) {
  std::set<std::string> channels;
  std::set<std::string> types;
  std::set<std::int64_t> fingerprints;
  for (const ChannelInfo& info : channel_table()) {
    EXPECT_TRUE(channels.insert(info.channel).second) << info.channel;
    types.insert(info.type);
    fingerprints.insert(info.fingerprint);
    EXPECT_EQ(find_channel(info.channel), &info);
  }
  EXPECT_EQ(types.size(), 25u);
  EXPECT_EQ(fingerprints.size(), types.size());
  EXPECT_EQ(find_channel("NO_SUCH_CHANNEL"), nullptr);
}

TEST(Wire, DecodingIsTheInverseOfEncoding) {
  for_every_type([]<class T>() {
    const auto bytes = bytes_of(sample<T>());
    ASSERT_EQ(bytes.size(), static_cast<std::size_t>(Wire<T>::kBytes)) << Message<T>::getTypeName();
    T value;
    ASSERT_EQ(decode(bytes, value), Status::kOk) << Message<T>::getTypeName();
    EXPECT_EQ(bytes_of(value), bytes) << Message<T>::getTypeName();
  });
}

TEST(Wire, NoOtherSizeAndNoOtherTypeIsAccepted) {
  for_every_type([]<class T>() {
    const auto bytes = bytes_of(sample<T>());
    T value;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      // A copy of its own, so that a sanitizer sees one byte read too far.
      const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<long>(size));
      EXPECT_NE(decode(cut, value), Status::kOk) << Message<T>::getTypeName() << " " << size;
    }
    auto longer = bytes;
    longer.push_back(0);
    EXPECT_NE(decode(longer, value), Status::kOk) << Message<T>::getTypeName();
    for (std::size_t i = 0; i < 8; ++i) {
      auto other = bytes;
      other[i] ^= 1;
      EXPECT_NE(decode(other, value), Status::kOk) << Message<T>::getTypeName();
    }
  });
}

// source_status_t had no faded_in then: 154 bytes, with the fingerprint that lcm-gen gave that type.
TEST(Wire, SourceStatusOfOlderLogsIsReadAndItsControllerIsFadedIn) {
  SourceStatus status = sample<SourceStatus>();
  status.faded_in = 0.25F;
  auto bytes = bytes_of(status);
  bytes.erase(bytes.begin() + 144, bytes.begin() + 148);
  put(bytes, 0, 0xa10fffc4d8b72360U, 8);
  ASSERT_EQ(bytes.size(), 154U);
  SourceStatus read;
  ASSERT_EQ(decode(bytes, read), Status::kOk);
  status.faded_in = 1.0F;
  EXPECT_EQ(bytes_of(read), bytes_of(status));
  ++bytes[7];
  EXPECT_EQ(decode(bytes, read), Status::kWrongSize) << "another fingerprint";
  --bytes[7];
  bytes.push_back(0);
  EXPECT_EQ(decode(bytes, read), Status::kWrongSize);
}

// STATE had two feet then: 1013 bytes, the rows of the hands behind theirs.
TEST(Wire, StateOfOlderLogsIsReadWithItsHandsBehindTheFeet) {
  RobotState state = sample<RobotState>();
  for (std::size_t row = kRightFoot + 1; row < kLeftHand; ++row) {
    state.wrench_kind[row] = WrenchKind::kAbsent;
    state.wrench[row] = {};
  }
  const auto now = bytes_of(state);
  std::array<std::uint8_t, kLargestMessage> room;
  const std::span<const std::uint8_t> before = as_before(now, room);
  ASSERT_EQ(before.size(), 1013U);
  std::vector<std::uint8_t> older(now.begin(), now.end());  // by hand: where layout_of says the fields are
  std::size_t kinds = 0, wrenches = 0;
  for (const FieldElement& element : layout_of("robot_state_t")) {
    if (element.field == "wrench_kind" && element.index == 2) kinds = element.offset;
    if (element.field == "wrench" && element.index == 12) wrenches = element.offset;
  }
  older.erase(older.begin() + static_cast<std::ptrdiff_t>(wrenches), older.begin() + static_cast<std::ptrdiff_t>(wrenches) + 96);
  older.erase(older.begin() + static_cast<std::ptrdiff_t>(kinds), older.begin() + static_cast<std::ptrdiff_t>(kinds) + 4);
  put(older, 0, 0x2c552651dafa2de4U, 8);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), older.begin(), older.end()));
  RobotState read;
  ASSERT_EQ(decode(older, read), Status::kOk);
  EXPECT_EQ(bytes_of(read), now);
  ++older[7];
  EXPECT_EQ(decode(older, read), Status::kWrongSize) << "another fingerprint";
  --older[7];
  older.pop_back();
  EXPECT_EQ(decode(older, read), Status::kWrongSize);
}

// What was not said yet is nothing doubted.
void doubt_nothing(SimTruth& truth) {
  truth.doubted = {};
  truth.doubted_steps = 0;
  truth.doubted_since = 0.0;
  truth.last_doubt = StepDoubt::kNone;
}

// The last thing it says, with the head of that version: 665 bytes.
TEST(Wire, TruthOfOlderLogsDoubtsNothing) {
  SimTruth truth = sample<SimTruth>();
  doubt_nothing(truth);
  const auto now = bytes_of(truth);
  ASSERT_EQ(now.size(), 702U);
  std::array<std::uint8_t, kLargestMessage> room;
  const std::span<const std::uint8_t> before = as_before(now, room);
  ASSERT_EQ(before.size(), 665U);
  EXPECT_TRUE(std::equal(before.begin() + 8, before.end(), now.begin() + 8));
  std::vector<std::uint8_t> older(now.begin(), now.begin() + 665);
  put(older, 0, 0x0e322565671b8031U, 8);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), older.begin(), older.end()));
  SimTruth read = sample<SimTruth>();
  ASSERT_EQ(decode(older, read), Status::kOk);
  EXPECT_EQ(bytes_of(read), now);
}

// By hand: where layout_of says the fields are.
TEST(Wire, TruthOfOlderLogsHasTwoFeet) {
  SimTruth truth = sample<SimTruth>();
  doubt_nothing(truth);
  truth.foot_count = 2;
  for (std::size_t foot = 2; foot < kMaxFeet; ++foot) {
    truth.foot_position[foot] = truth.foot_force[foot] = {};
    truth.foot_attitude[foot] = {};
    truth.foot_slip[foot] = 0.0F;
  }
  const auto now = bytes_of(truth);
  std::vector<std::uint8_t> older(now.begin(), now.begin() + 665);
  const std::map<std::string, std::size_t> numbers = {{"foot_position", 3}, {"foot_attitude", 4}, {"foot_force", 3}, {"foot_slip", 1}};
  const auto layout = layout_of("sim_truth_t");
  for (auto element = layout.rbegin(); element != layout.rend(); ++element) {
    const auto found = numbers.find(element->field);
    const bool gone = element->field == "foot_count" || (found != numbers.end() && element->index >= 2 * found->second);
    const auto from = older.begin() + static_cast<std::ptrdiff_t>(gone ? element->offset : 0);
    if (gone) older.erase(from, from + static_cast<std::ptrdiff_t>(element->size));
  }
  ASSERT_EQ(older.size(), 487U);
  put(older, 0, 0x3793d2020c8b0176U, 8);
  SimTruth read;
  ASSERT_EQ(decode(older, read), Status::kOk);
  EXPECT_EQ(bytes_of(read), now);
  std::array<std::uint8_t, kLargestMessage> room;
  EXPECT_TRUE(as_before(bytes_of(sample<StopRequest>()), room).empty());
}

// What is said of a good message with another number in this place.
template <class T>
Status decoded_with(std::vector<std::uint8_t> bytes, const FieldElement& element, double number) {
  put_number(bytes, element, number);
  T value;
  return decode(bytes, value);
}

// Exhaustive: every number of every message.
TEST(Wire, NotFiniteOrAbsurdNumbersRefuseTheWholeMessageInEveryField) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  int tried = 0;
  for_every_type([&]<class T>() {
    const auto good = bytes_of(sample<T>());
    for (const FieldElement& element : layout_of(Message<T>::getTypeName())) {
      if (!is_real(element)) continue;
      for (const double bad :
           {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::quiet_NaN(),
            kInf, -kInf, element.size == 8 ? 1e300 : 3e38, element.size == 8 ? -1e300 : -3e38}) {
        EXPECT_NE(decoded_with<T>(good, element, bad), Status::kOk) << Message<T>::getTypeName() << "." << element.field << "[" << element.index << "] = " << bad;
        ++tried;
      }
    }
  });
  EXPECT_GT(tried, 6 * 900);
}

TEST(Wire, NegativeZeroAndDenormalNumbersAreAcceptedInEveryField) {
  for_every_type([&]<class T>() {
    const auto good = bytes_of(sample<T>());
    for (const FieldElement& element : layout_of(Message<T>::getTypeName())) {
      if (!is_real(element)) continue;
      // A rotation with one element missing is none; knots of a path are in order.
      const bool bound = element.field.find("attitude") != std::string::npos ||
                         element.field == "orientation" ||
                         (element.field == "time" && element.index > 0);
      if (bound && element.field != "foot_attitude") continue;
      for (const double odd : {-0.0, element.size == 8 ? 5e-324 : 1e-45}) {
        EXPECT_EQ(decoded_with<T>(good, element, odd), Status::kOk) << Message<T>::getTypeName() << "." << element.field << "[" << element.index << "] = " << odd;
      }
    }
  });
}

// The same for every count, enumeration, flag and identifier: whatever an
// integer field holds, what comes out stays inside its array, list and range.
TEST(Wire, ExtremeIntegersNeverComeOutOutOfRange) {
  for_every_type([&]<class T>() {
    const auto good = bytes_of(sample<T>());
    for (const FieldElement& element : layout_of(Message<T>::getTypeName())) {
      if (is_real(element)) continue;
      const int bits = static_cast<int>(8 * element.size);
      for (const std::uint64_t extreme :
           {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{49}, std::uint64_t{127},
            ~std::uint64_t{0}, std::uint64_t{1} << (bits - 1),
            (std::uint64_t{1} << (bits - 1)) - 1}) {
        auto bytes = good;
        put(bytes, element.offset, extreme, element.size);
        T value;
        if (decode(bytes, value) != Status::kOk) continue;
        if constexpr (requires { value.joint_count; }) {
          EXPECT_GE(value.joint_count, 0);
          EXPECT_LE(value.joint_count, kMaxJoints);
        }
        if constexpr (requires { value.run_id; }) {
          EXPECT_GE(value.run_id, 0);
          EXPECT_LT(value.run_id, std::int64_t{1} << 53);
        }
        // Fit to be sent on: encode applies the same rules.
        EXPECT_FALSE(bytes_of(value).empty()) << Message<T>::getTypeName() << "." << element.field;
      }
    }
  });
}

TEST(Wire, JointCountsOutsideTheArrayAreRefused) {
  for (const int count : {-32768, -1, 49, 32767}) {
    RobotState state = sample<RobotState>();
    auto bytes = bytes_of(state);
    for (const FieldElement& element : layout_of("robot_state_t")) {
      if (element.field == "joint_count")
        put(bytes, element.offset, static_cast<std::uint64_t>(count), 2);
    }
    EXPECT_EQ(decode(bytes, state), Status::kWrongSize) << count;
  }
}

TEST(Wire, NotFiniteNumbersAreNotSentEither) {
  RobotState state = sample<RobotState>();
  state.q[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(bytes_of(state).empty());
  std::array<std::uint8_t, 1000> small{};
  EXPECT_EQ(encode(sample<RobotState>(), small), 0);
}

}  // namespace
}  // namespace twinbus
