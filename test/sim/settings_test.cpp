#include "sim/scene/settings.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

TEST(Settings, ReachTheirField) {
  SimSettings s;
  apply_settings({{"model.mass_scale", "1.03"},
                  {"sensor.imu_yaw_drift", "3e-3"},
                  {"ground.left_height_error", "0.001"},
                  {"sensor.delay_ms", "4"},
                  {"servo.delay_ms", "2"}},
                 0.002, s);
  EXPECT_DOUBLE_EQ(s.world.mass_scale, 1.03);
  EXPECT_DOUBLE_EQ(s.sensors.yaw_drift, 0.003);
  EXPECT_DOUBLE_EQ(s.world.ground_height[0], 0.001);
  EXPECT_EQ(s.sensors.delay_ticks, 2);
  EXPECT_DOUBLE_EQ(s.servo_delay_ms, 2.0);
}

TEST(Settings, AnUnknownKeyNamesTheNearest) {
  SimSettings s;
  const std::string complaint = apply_setting("model.mass", "1", 0.002, s);
  EXPECT_NE(complaint.find("'model.mass'"), std::string::npos);
  EXPECT_NE(complaint.find("'model.mass_scale'"), std::string::npos);
  EXPECT_THROW(apply_settings({{"sensor.noise.encodr", "0"}}, 0.002, s), std::runtime_error);
}

TEST(Settings, ContactIsOneOfThoseThatThereAre) {
  SimSettings s;
  EXPECT_TRUE(apply_setting("contact", "rigid", 0.002, s).empty());
  EXPECT_EQ(s.world.contact, ContactModel::kRigid);
  EXPECT_EQ(apply_setting("contact", "hunt_crossley", 0.002, s), "");
  EXPECT_EQ(s.world.contact, ContactModel::kHuntCrossley);
  EXPECT_EQ(apply_setting("contact.dissipation", "0.5", 0.002, s), "");
  EXPECT_DOUBLE_EQ(s.world.dissipation, 0.5);
  EXPECT_NE(apply_setting("contact", "magic", 0.002, s).find("rigid"), std::string::npos);
}

TEST(Settings, AValueOutOfRangeOrNoNumberIsRefused) {
  for (const char* value : {"", "x", "1x", "nan", "inf", "-1", "1e9"}) {
    SimSettings s;
    EXPECT_FALSE(apply_setting("model.mass_scale", value, 0.002, s).empty()) << value;
    EXPECT_DOUBLE_EQ(s.world.mass_scale, 1.0);
  }
}

TEST(Settings, HelpListsThem) {
  EXPECT_NE(settings_help().find("sensor.noise.gyro"), std::string::npos);
  SimSettings s;
  for (const auto& [key, refused] : {std::pair{"engine", apply_setting("engine", "magic", 0.002, s)}, {"contact", apply_setting("contact", "magic", 0.002, s)}}) {
    EXPECT_NE(settings_help().find(std::string("  ") + key + " "), std::string::npos);
    EXPECT_NE(refused.find(key), std::string::npos);
  }
  for (const char* name : kEngineNames) {
    EXPECT_NE(settings_help().find(std::string("    ") + name + " "), std::string::npos) << name;
    EXPECT_NE(apply_setting("engine", "magic", 0.002, s).find(name), std::string::npos) << name;
  }
  for (const char* name : kContactNames) {
    EXPECT_NE(settings_help().find(std::string("    ") + name + " "), std::string::npos) << name;
    EXPECT_NE(apply_setting("contact", "magic", 0.002, s).find(name), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace twinbus
