#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/refusal_text.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace twinbus {
namespace {

TEST(RefusalText, EveryReasonHasItsOwnSentence) {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(Refusal::kDevice); ++i) {
    const std::string text = refusal_text(static_cast<Refusal>(i));
    EXPECT_FALSE(text.empty());
    EXPECT_TRUE(texts.insert(text).second) << text;
    EXPECT_LT(text.size(), 180u);
  }
  EXPECT_NE(refusal_text(static_cast<Refusal>(100)), nullptr);
}

}  // namespace
}  // namespace twinbus
