// Tests that hold for every engine: a fixture that makes worlds of the engine it is given.

#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "sim/engine/make_world.h"
#include "sim/world/world.h"

namespace twinbus::test {

inline std::string engine_name(Engine engine) {
  return kEngineNames[static_cast<std::size_t>(engine)];
}

class BothEngines : public ::testing::TestWithParam<Engine> {
 protected:
  static std::unique_ptr<World> make(const Model& model, WorldConfig config = {}) {
    config.engine = GetParam();
    return make_world(model, config);
  }
  // In this configuration.
  static std::unique_ptr<World> make_at(const Configuration& start, const Model& model, const WorldConfig& config = {}) {
    auto world = make(model, config);
    EXPECT_EQ(world->set(start), Status::kOk);
    return world;
  }
  // On a fixed base, all joints at zero.
  static std::unique_ptr<World> make_hung(const Model& model, WorldConfig config = {}) {
    config.fixed_base = true;
    return make_at(Configuration(model), model, config);
  }
  static bool is_ode() { return GetParam() == Engine::kOde; }
};

#define TWINBUS_FOR_BOTH_ENGINES(suite)                                                           \
  INSTANTIATE_TEST_SUITE_P(Engines, suite, ::testing::Values(Engine::kArticulated, Engine::kOde), \
                           [](const auto& each) { return test::engine_name(each.param); })

// A suite of its own, without more than that.
#define TWINBUS_BOTH_ENGINES(suite)          \
  class suite : public test::BothEngines {}; \
  TWINBUS_FOR_BOTH_ENGINES(suite)

}  // namespace twinbus::test
