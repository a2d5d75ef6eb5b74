#include "common/text/printable.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

TEST(Printable, NothingDrivesATerminal) {
  EXPECT_EQ(printable("a\x1b[2Jb\r\n\x7f\x07"), "a?[2Jb????");
  EXPECT_EQ(printable("line\nline\x1b", 100, true), "line\nline?");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "??31m");  // CSI of eight bits, as UTF-8
  EXPECT_EQ(printable("\x9b"
                      "31m\xff\xc3"),
            "?31m??");                                                   // no UTF-8
  EXPECT_EQ(printable("\xc0\xaf\xe0\x80\xaf\xed\xa0\x80"), "????????");  // overlong, a surrogate
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "evil"),
            "???evil");  // turns the direction of writing
  EXPECT_EQ(printable("J\xc3\xbcrgen \xe2\x82\xac \xf0\x9f\x99\x82"),
            "J\xc3\xbcrgen \xe2\x82\xac \xf0\x9f\x99\x82");
}

TEST(Printable, LongTextsLoseTheirMiddle) {
  const std::string text = printable(std::string(1'000'000, 'x'), 100);
  EXPECT_LT(text.size(), 200U);
  EXPECT_NE(text.find("(999900 bytes left out)"), std::string::npos) << text;
}

TEST(Printable, InPlaceItKeepsTheLength) {
  char text[] = "a\x1b\xff\xc3\xa4";
  make_printable(text, sizeof text - 1);
  EXPECT_STREQ(text, "a??\xc3\xa4");
}

}  // namespace
}  // namespace twinbus
