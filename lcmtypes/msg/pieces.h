// What is too long for one datagram and travels in pieces: the structs behind the messages, without the bus.  Field comments
// and units: the .lcm file.

#pragma once

#include <array>
#include <cstdint>

namespace twinbus {

enum class ArmPathStatus : std::int8_t {
  kOk = 0,
  kUnreachable = 1,
  kStartInCollision = 2,
  kGoalInCollision = 3,
  kTimeLimit = 4,
  kCancelled = 5,
  kBadGoal = 6,
};

inline constexpr int kArmJoints = 12;     // columns of a path
inline constexpr int kKnotsPerPiece = 6;  // rows of one message

struct ArmPathPiece {  // arm_path_t
  std::int64_t utime = 0;
  std::int64_t planner_id = 0;
  std::int64_t run_id = 0;
  std::int64_t goal_id = 0;
  std::int64_t path_id = 0;
  std::int16_t piece = 0;
  std::int16_t pieces = 0;
  std::int16_t joint_count = 0;
  std::int16_t knot_count = 0;
  std::array<std::int16_t, kArmJoints> joint{};
  ArmPathStatus status = ArmPathStatus::kOk;
  std::int8_t link_a = 0;
  std::int8_t link_b = 0;
  float miss = 0;
  float clearance = 0;
  std::array<double, kKnotsPerPiece> time{};
  std::array<std::array<double, kArmJoints>, kKnotsPerPiece> q{};
  std::array<std::array<float, kArmJoints>, kKnotsPerPiece> qd{};
};

inline constexpr int kObstaclesPerPiece = 12;
enum class ObstacleShape : std::int8_t { kNone = 0, kBox = 1, kSphere = 2, kCylinder = 3 };

struct ObstaclesPiece {
  std::int64_t utime = 0;
  std::int64_t scene_id = 0;
  std::int16_t piece = 0;
  std::int16_t pieces = 0;
  std::int16_t count = 0;
  std::array<ObstacleShape, kObstaclesPerPiece> shape{};
  std::array<std::array<float, 3>, kObstaclesPerPiece> size{};
  std::array<std::array<float, 3>, kObstaclesPerPiece> position{};
  std::array<std::array<float, 4>, kObstaclesPerPiece> attitude{};
};



inline constexpr int kModelTextBytes = 1300;

struct ModelTextPiece {
  std::int64_t utime = 0;
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int32_t size = 0;
  std::int16_t piece = 0;
  std::int16_t pieces = 0;
  std::int16_t count = 0;
  std::int8_t kind = 0;
  std::array<char, kModelTextBytes> text{};
};

}  // namespace twinbus
