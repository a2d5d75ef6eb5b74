#include "bridge/adaptor/adaptor_host.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "test/bridge/small_robot.h"

namespace twinbus {
namespace {

std::string adaptor(const std::string& name) {
  return std::string(TWINBUS_TEST_ADAPTORS) + "/" + name + ".so";
}

std::string complaint(const std::string& name_or_path) {
  try {
    const LoadedAdaptor loaded(name_or_path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(AdaptorHost, LoadsAnAdaptorAndRunsIt) {
  LoadedAdaptor loaded(adaptor("good_adaptor"));
  const Model model = test::small_model();
  ASSERT_EQ(loaded->open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(loaded->read(state, 0.0), Status::kOk);
  EXPECT_EQ(state.q[0], 0.25);
  loaded->close();
}

TEST(AdaptorHost, EveryBadSharedObjectIsRefusedWithWhatIsWrongAndWhere) {
  const struct {
    const char *name, *word;
  } cases[] = {
      {"not_an_adaptor", "not an adaptor"},      {"wrong_mark_adaptor", "mark"},
      {"wrong_version_adaptor", "version"},      {"wrong_state_adaptor", "state size"},
      {"wrong_model_adaptor", "model size"},     {"null_adaptor", "could not be made"},
      {"throwing_adaptor", "could not be made"},
  };
  for (const auto& c : cases) {
    const std::string text = complaint(adaptor(c.name));
    EXPECT_NE(text.find(c.word), std::string::npos) << c.name << ": " << text;
    EXPECT_NE(text.find(c.name), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

TEST(AdaptorHost, WhatIsNotThereOrNoSharedObjectIsRefused) {
  EXPECT_NE(complaint("").find("installed are"), std::string::npos);
  EXPECT_NE(complaint("no_such_robot").find("no_such_robot"), std::string::npos);
  EXPECT_NE(complaint("/nowhere/at_all.so").find("/nowhere/at_all.so"), std::string::npos);
  EXPECT_NE(complaint(__FILE__), "");  // or the program's own folder, when it is gone
  EXPECT_NE(complaint("/"), "");
}

}  // namespace
}  // namespace twinbus
