#include "robot/description/model_hash.h"

#include <cmath>
#include <string_view>

#include "common/text/xml.h"
#include "robot/description/parallel_joints.h"

namespace twinbus::inline robot {

namespace {

// FNV-1a, 64 bit.  Numbers enter rounded to 1e-9, so that the last bit of another machine's sine
// does not matter.
class Hash {
 public:
  void bytes(std::string_view text) {
    for (const char c : text) byte(static_cast<unsigned char>(c));
  }
  void integer(std::int64_t value) {
    for (int i = 0; i < 8; ++i)
      byte(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i)));
  }
  void text(const std::string& value) {
    integer(static_cast<std::int64_t>(value.size()));
    bytes(value);
  }
  void number(double value) {
    integer(std::abs(value) < 9e9 ? std::llround(value * 1e9)
            : value > 0.0         ? INT64_MAX
                                  : INT64_MIN);
  }
  void pose(const Eigen::Isometry3d& pose) {
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) number(pose.matrix()(row, column));
    }
  }
  template <class Matrix>
  void matrix(const Matrix& values) {
    for (Eigen::Index i = 0; i < values.size(); ++i) number(values.data()[i]);
  }
  std::uint64_t value() const { return hash_; }

 private:
  void byte(unsigned char b) { hash_ = (hash_ ^ b) * 0x100000001b3u; }
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

std::int64_t model_hash(const Model& model) {
  Hash hash;
  hash.text("twinbus model 1");
  hash.integer(model.floating_base ? 1 : 0);
  for (const Joint& joint : model.joints) {
    hash.text(joint.name);
    hash.integer(static_cast<int>(joint.kind));
    hash.integer(joint.parent);
    hash.pose(joint.placement);
    hash.matrix(joint.axis);
    for (const double limit : {joint.lower, joint.upper, joint.velocity, joint.effort})
      hash.number(limit);
    hash.number(joint.rotor_inertia);
    hash.integer(joint.mimic);
    hash.number(joint.mimic_multiplier);
    hash.number(joint.mimic_offset);
  }
  for (const Link& link : model.links) {
    hash.text(link.name);
    hash.number(link.mass);
    hash.matrix(link.com);
    hash.matrix(link.inertia);
    for (const Shape& shape : link.collision) {
      hash.integer(static_cast<int>(shape.kind));
      hash.matrix(shape.size);
      hash.pose(shape.pose);
      if (shape.kind == ShapeKind::kMesh) hash.bytes(read_file(shape.mesh));
    }
  }
  for (const int joint : model.bus_joints) hash.integer(joint);
  for (const Sole& sole : model.soles) {
    hash.integer(sole.link);
    hash.pose(sole.frame);
    hash.pose(sole.sensor);
    for (const double edge : {sole.front, sole.back, sole.left, sole.right}) hash.number(edge);
  }
  for (const Hand& hand : model.hands) {
    hash.integer(hand.link);
    hash.pose(hand.frame);
    hash.pose(hand.sensor);
  }
  for (const Hand& hand : model.more_hands) {
    hash.text(hand.name);
    hash.integer(hand.link);
    hash.pose(hand.frame);
  }
  for (const ParallelJoints& pair : parallel_joints_of(model)) {
    for (const int i : {0, 1}) {
      const RodMotor& motor = pair.drive.motor(i);
      hash.integer(pair.joints[static_cast<std::size_t>(i)]);
      hash.text(motor.name);
      for (const Eigen::Vector3d& v : {motor.center, motor.axis, motor.arm, motor.rod}) hash.matrix(v);
      for (const double limit : {motor.torque, motor.speed, motor.lower, motor.upper}) hash.number(limit);
    }
  }
  hash.integer(model.imu_link);
  hash.pose(model.imu);
  const auto value = static_cast<std::int64_t>(hash.value() & ((std::uint64_t{1} << 53) - 1));
  return value == 0 ? 1 : value;
}

}  // namespace twinbus::robot
