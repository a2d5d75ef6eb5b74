#include "robot/motion/motion_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "robot/motion/motion_spline.h"
#include "robot/motion/npz.h"
#include "test/error_of.h"
#include "test/temporary_folder.h"

namespace twinbus {
namespace {

MotionFile csv(const std::string& text, const MotionFormat& format = {}) {
  return parse_motion_csv("m.csv", text, format);
}

TEST(MotionCsv, AHeaderNamesTheColumnsInAnyOrder) {
  const MotionFile m = csv("# made by hand\nb,time,a\n1,0.5,2\n3,0.6,4\n");
  ASSERT_EQ(m.frames(), 2);
  EXPECT_EQ(m.joints, (std::vector<std::string>{"b", "a"}));
  EXPECT_DOUBLE_EQ(m.time[0], 0.0);
  EXPECT_NEAR(m.time[1], 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(m.at(1, 1), 4.0);
  EXPECT_TRUE(m.root.empty());
}

TEST(MotionCsv, TheRootIsAPoseWithItsQuaternionByName) {
  const MotionFile m = csv(
      "root_qw,root_qx,root_qy,root_qz,root_x,root_y,root_z,a\n0,0,0,1,1,2,3,0\n0,0,0,1,1,2,3,0\n",
      {.rate = 10.0});
  ASSERT_EQ(m.root.size(), 2U);
  EXPECT_NEAR((m.root[0] * Eigen::Vector3d(1.0, 0.0, 0.0) - Eigen::Vector3d(0.0, 2.0, 3.0)).norm(),
              0.0, 1e-12);
}

TEST(MotionCsv, Lafan1HasItsOwnOrderAndThirtyFramesASecond) {
  const MotionFormat format{.columns = motion_columns("lafan1")};
  std::string row = "0.1,0.2,0.7,0,0,0,1";
  for (int j = 0; j < 29; ++j) row += "," + std::to_string(0.01 * j);
  const MotionFile m = csv(row + "\n" + row + "\n" + row + "\n", format);
  ASSERT_EQ(m.joints.size(), 29U);
  EXPECT_EQ(m.joints[3], "left_knee_joint");
  EXPECT_NEAR(m.time[2], 2.0 / 30.0, 1e-12);
  EXPECT_NEAR(m.at(0, 28), 0.28, 1e-12);
  EXPECT_TRUE(m.root[0].linear().isIdentity(1e-12));
}

TEST(MotionCsv, WhatIsWrongIsOneErrorWithItsLine) {
  const auto error = [](const std::string& text, MotionFormat format = {}) {
    return test::error_of<std::runtime_error>([&] { (void)csv(text, format); });
  };
  EXPECT_NE(error("time,a\n0,1\n1,nan\n").find("m.csv:3: column 2: 'nan' is no finite number"),
            std::string::npos);
  EXPECT_NE(error("time,a\n0,1\n1,1e999\n").find("m.csv:3: column 2"), std::string::npos);
  EXPECT_NE(error("time,a\n0,1\n1\n").find("m.csv:3: has 1 columns, and must have 2"),
            std::string::npos);
  EXPECT_NE(error("time,a\n0,1\n0,1\n").find("m.csv:3: the time does not increase"),
            std::string::npos);
  EXPECT_NE(error("time,a\n0,1\n-1,1\n").find("the time does not increase"), std::string::npos);
  EXPECT_NE(error("0,1\n0,1\n").find("--columns"), std::string::npos);
  EXPECT_NE(error("a,a\n0,1\n").find("two columns are called a"), std::string::npos);
  EXPECT_NE(error("a,b\n0,1\n1,1\n").find("--rate"), std::string::npos);
  EXPECT_NE(error("time,a\n0,1\n1,1\n", {.rate = 10.0}).find("leave one out"), std::string::npos);
  EXPECT_NE(error("time,root_x,a\n0,1,1\n").find("a root needs all of"), std::string::npos);
  EXPECT_NE(
      error("time,root_x,root_y,root_z,root_qw,root_qx,root_qy,root_qz,a\n0,0,0,0,0,0,0,0,0\n")
          .find("length 0"),
      std::string::npos);
  EXPECT_NE(error("time,a\n0,1\n").find("fewer than two frames"), std::string::npos);
  EXPECT_NE(error("").find("has no frames"), std::string::npos);
  EXPECT_EQ(error("time,a\n0,1\n1,2"), "") << "a last line without an end";
  EXPECT_EQ(error("\xef\xbb\xbftime;a;\r\n0;1;\r\n1;+2;\r\n"), "") << "as spreadsheets write it";
}

TEST(MotionCsv, APartIsTakenOfIt) {
  const MotionFile m = csv("time,a\n0,0\n1,1\n2,2\n3,3\n4,4\n", {.from = 1.0, .until = 3.0});
  ASSERT_EQ(m.frames(), 3);
  EXPECT_DOUBLE_EQ(m.time[0], 0.0);
  EXPECT_DOUBLE_EQ(m.at(2, 0), 3.0);
}

// As numpy.savez and numpy.savez_compressed write them.
class Archive {
 public:
  Archive& add(const std::string& name, const std::string& descr, const std::string& shape,
               const std::string& data, bool deflate = false) {
    std::string header =
        "{'descr': '" + descr + "', 'fortran_order': False, 'shape': " + shape + ", }";
    header.resize((10 + header.size() + 64) / 64 * 64 - 10, ' ');
    header.back() = '\n';
    std::string npy("\x93NUMPY\x01\x00", 8);
    npy += two(header.size()) + header + data;
    const uLong sum =
        crc32(0, reinterpret_cast<const Bytef*>(npy.data()), static_cast<uInt>(npy.size()));
    const std::string packed = deflate ? squeeze(npy) : npy;
    const std::string common = two(20) + two(0) + two(deflate ? 8 : 0) + two(0) + two(33) +
                               four(sum) + four(packed.size()) + four(npy.size()) +
                               two(name.size() + 4) + two(0);
    list_ += "PK\x01\x02" + two(20) + common + two(0) + two(0) + two(0) + four(0) +
             four(bytes_.size()) + name + ".npy";
    bytes_ += "PK\x03\x04" + common + name + ".npy" + packed;
    ++count_;
    return *this;
  }
  std::string bytes() const {
    return bytes_ + list_ + "PK\x05\x06" + two(0) + two(0) + two(count_) + two(count_) +
           four(list_.size()) + four(bytes_.size()) + two(0);
  }

 private:
  static std::string number(std::size_t x, int size) {
    std::string text;
    for (int i = 0; i < size; ++i) text += static_cast<char>(x >> 8 * i & 255);
    return text;
  }
  static std::string two(std::size_t x) { return number(x, 2); }
  static std::string four(std::size_t x) { return number(x, 4); }
  static std::string squeeze(const std::string& from) {
    std::string to(from.size() + 1000, '\0');
    z_stream s{};
    EXPECT_EQ(deflateInit2(&s, 6, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
    s.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(from.data()));
    s.avail_in = static_cast<uInt>(from.size());
    s.next_out = reinterpret_cast<Bytef*>(to.data());
    s.avail_out = static_cast<uInt>(to.size());
    EXPECT_EQ(deflate(&s, Z_FINISH), Z_STREAM_END);
    to.resize(s.total_out);
    deflateEnd(&s);
    return to;
  }
  std::string bytes_, list_;
  std::size_t count_ = 0;
};

template <class Number>
std::string raw(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

std::string unicode(const std::vector<std::string>& words, std::size_t width) {
  std::string text;
  for (const std::string& word : words) {
    for (std::size_t i = 0; i < width; ++i)
      text += std::string(1, i < word.size() ? word[i] : '\0') + std::string(3, '\0');
  }
  return text;
}

Archive good(bool deflate) {
  return Archive()
      .add("fps", "<i8", "()", raw(std::vector<std::int64_t>{50}), deflate)
      .add("joint_names", "<U2", "(2,)", unicode({"a", "bb"}, 2), deflate)
      .add("joint_pos", "<f4", "(3, 2)", raw(std::vector<float>{0, 1, 2, 3, 4, 5}), deflate)
      .add("root_pos", "<f8", "(3, 3)", raw(std::vector<double>(9, 0.5)), deflate)
      .add("root_rot", "<f8", "(3, 4)",
           raw(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}), deflate);
}

TEST(MotionNpz, StoredAndCompressedArraysAreRead) {
  for (const bool deflate : {false, true}) {
    const MotionFile m = parse_motion_npz("m.npz", good(deflate).bytes(), {});
    EXPECT_EQ(m.joints, (std::vector<std::string>{"a", "bb"}));
    ASSERT_EQ(m.frames(), 3);
    EXPECT_NEAR(m.time[2], 0.04, 1e-12);
    EXPECT_DOUBLE_EQ(m.at(2, 1), 5.0);
    ASSERT_EQ(m.root.size(), 3U);
    EXPECT_TRUE(m.root[2].linear().isIdentity(1e-12)) << "x y z w";
  }
}

TEST(MotionNpz, WhatIsWrongIsOneErrorThatNamesTheArray) {
  const auto error = [](const Archive& archive, MotionFormat format = {}) {
    return test::error_of<std::runtime_error>([&] { (void)parse_motion_npz("m.npz", archive.bytes(), format); });
  };
  const auto joints = [](const std::string& shape, std::vector<float> q) {
    return Archive()
        .add("fps", "<i8", "()", raw(std::vector<std::int64_t>{50}))
        .add("dof_pos", "<f4", shape, raw(q));
  };
  EXPECT_NE(error(Archive()).find("no array joint_pos"), std::string::npos);
  EXPECT_NE(error(joints("(2, 1)", {0, 1})).find("--columns"), std::string::npos);
  EXPECT_EQ(error(joints("(2, 1)", {0, 1}), {.columns = {"a"}}), "");
  EXPECT_NE(error(joints("(2, 1)", {0, NAN}), {.columns = {"a"}})
                .find("m.npz: dof_pos: frame 1, column 1 is no finite"),
            std::string::npos);
  EXPECT_NE(error(joints("(2, 1)", {0, 1}), {.columns = {"a", "b"}})
                .find("2 names of joints for 1 columns"),
            std::string::npos);
  EXPECT_NE(
      error(joints("(1000000, 512)", {0, 1}), {.columns = {"a"}}).find("more numbers than it has"),
      std::string::npos);
  EXPECT_NE(error(joints("(99999999999999999999, 9)", {0, 1})).find("too large"),
            std::string::npos);
  EXPECT_NE(error(Archive().add("joint_pos", "|O", "(2, 1)", "xxxxxxxx")).find("Python objects"),
            std::string::npos);
  EXPECT_NE(error(Archive().add("joint_pos", ">f4", "(1, 1)", "xxxx")).find("big-endian"),
            std::string::npos);
  std::string damaged = good(false).bytes();
  damaged[damaged.find("joint_pos.npy") + 13 + 128 + 3] ^= 1;
  EXPECT_NE(
      test::error_of<std::runtime_error>([&] { (void)parse_motion_npz("m.npz", damaged, {}); }).find("its checksum is wrong"),
      std::string::npos);
}

TEST(MotionNpz, NoByteAndNoLengthOfAnArchiveDoesMoreThanAnError) {
  for (const bool deflate : {false, true}) {
    const std::string whole = good(deflate).bytes();
    for (std::size_t size = 0; size < whole.size(); size += 7)
      (void)test::error_of<std::runtime_error>([&] { (void)read_npz("m.npz", whole.substr(0, size)); });
    for (std::size_t i = 0; i < whole.size(); ++i) {
      for (const int bits : {0xff, 0x80, 0x01}) {
        std::string bytes = whole;
        bytes[i] = static_cast<char>(bytes[i] ^ bits);
        (void)test::error_of<std::runtime_error>([&] { (void)parse_motion_npz("m.npz", bytes, {}); });
      }
    }
  }
}

TEST(MotionFile, AFileThatIsNoMotionIsRefused) {
  const test::TemporaryFolder folder;
  EXPECT_NE(
      test::error_of<std::runtime_error>([&] { (void)read_motion(folder.path() + "/none.csv", {}); }).find("cannot be read"),
      std::string::npos);
  EXPECT_NE(test::error_of<std::runtime_error>([&] {
              (void)read_motion(folder.write("m.pkl", std::string("\x80\x04\x00\x01", 4)), {});
            }).find("numpy.savez"),
            std::string::npos);
  EXPECT_NE(test::error_of<std::runtime_error>([] { (void)motion_columns("nonsense"); }).find("lafan1"), std::string::npos);
}

TEST(MotionSpline, PassesThroughItsValuesAndItsRatesAreItsSlopes) {
  std::vector<double> x;
  for (int i = 0; i < 40; ++i) x.push_back(std::sin(0.3 * i) + 0.1 * i);
  std::vector<double> c = x;
  spline_frames(c);
  const auto value = [&](double time, const std::array<double, 4> SplinePlace::*weights) {
    const SplinePlace place = spline_place(time, 40, 0.02);
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += (place.*weights)[i] * c[static_cast<std::size_t>(place.frame[i])];
    return sum;
  };
  for (int i = 0; i < 40; ++i)
    EXPECT_NEAR(value(0.02 * i, &SplinePlace::position), x[static_cast<std::size_t>(i)], 1e-9) << i;
  constexpr double h = 1e-5;
  for (double t = 0.013; t < 0.76; t += 0.017) {
    EXPECT_NEAR(
        value(t, &SplinePlace::velocity),
        (value(t + h, &SplinePlace::position) - value(t - h, &SplinePlace::position)) / (2.0 * h),
        1e-5);
    EXPECT_NEAR(
        value(t, &SplinePlace::acceleration),
        (value(t + h, &SplinePlace::velocity) - value(t - h, &SplinePlace::velocity)) / (2.0 * h),
        1e-2);
  }
}

}  // namespace
}  // namespace twinbus
