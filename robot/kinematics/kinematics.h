// Poses, velocities and Jacobians of every link.
//
// One Kinematics object holds the result for one robot; update() allocates nothing.  Frames:
// "world" is whatever frame the base pose was given in.

#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "robot/description/model.h"
#include "common/simd/vec4.h"

namespace twinbus::inline robot {

// Configuration of the whole robot, in model joint order (mimic joints included).
struct Configuration {
  explicit Configuration(const Model& model);
  // In one of the model's poses; all joints at zero where it has none of that name.
  Configuration(const Model& model, const std::string& pose);
  Configuration() = default;
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();   // link 0 in world
  Eigen::Vector3d base_velocity = Eigen::Vector3d::Zero();  // of link 0's origin, in world [m/s]
  Eigen::Vector3d base_angular_velocity = Eigen::Vector3d::Zero();  // in world [rad/s]
  Eigen::VectorXd q;                                                // [joint_count]
  Eigen::VectorXd qd;                                               // [joint_count]
};

// Fills q and qd from bus arrays, mimic joints from the joints they follow.  The base is left
// alone.
void set_joints(const Model& model, const RobotState& state, Configuration& configuration) noexcept;
// Mimic joints from the joints they follow, q and qd.
void set_mimics(const Model& model, Configuration& configuration) noexcept;

// A link as it is now, in world axes, so that kernels read it four numbers at a time.
struct alignas(64) LinkState {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  PaddedVector omega, velocity;  // of the link; of its origin
  PaddedVector axis;             // of the joint that moves it
  PaddedVector com;
};

// Of a link, in its own axes.
struct alignas(64) LinkMass {
  PaddedVector com;
  PaddedVector inertia[3];  // about the com: columns
  double mass = 0.0;
};

class Kinematics {
 public:
  explicit Kinematics(const Model& model);

  void update(const Configuration& configuration) noexcept;
  // Base and links moved by `joints` alone, each after those before it: other links, and every centre of mass, stay as they were.
  void update(const Configuration& configuration, const std::vector<int>& joints) noexcept;

  const Eigen::Isometry3d& link_in_world(int link) const noexcept { return state(link).pose; }
  const Eigen::Vector3d& angular_velocity(int link) const noexcept {
    return state(link).omega.value;
  }
  const Eigen::Vector3d& origin_velocity(int link) const noexcept {
    return state(link).velocity.value;
  }
  const Eigen::Vector3d& axis_in_world(int joint) const noexcept {
    return state(joint + 1).axis.value;
  }
  // Velocity of the material point of a link that is at `point` (world) [m/s].
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept;

  // Centre of mass of one link, world [m].
  const Eigen::Vector3d& com_of_link(int link) const noexcept { return state(link).com.value; }
  const Eigen::Vector3d& com() const noexcept { return com_; }  // world [m]
  struct Momentum {
    Eigen::Vector3d com_velocity;  // world [m/s]
    Eigen::Vector3d angular;       // about the centre of mass, world [kg m^2/s]
  };
  Momentum momentum() const noexcept;  // visits every link
  Eigen::Vector3d com_velocity() const noexcept { return momentum().com_velocity; }
  Eigen::Vector3d angular_momentum() const noexcept { return momentum().angular; }
  double mass() const noexcept { return mass_; }

  // jacobian [6 x (6 + joint_count)], rows: linear then angular velocity of `point` fixed to
  // `link`, in world; columns: base linear, base angular, joints.  Must be sized by the caller.
  void point_jacobian(int link, const Eigen::Vector3d& point,
                      Eigen::MatrixXd& jacobian) const noexcept;
  // [3 x (6 + joint_count)]
  void com_jacobian(Eigen::MatrixXd& jacobian) const noexcept;

  const Model& model() const noexcept { return *model_; }
  const LinkState& state(int link) const noexcept { return links_[static_cast<std::size_t>(link)]; }
  const LinkMass& mass_of(int link) const noexcept {
    return masses_[static_cast<std::size_t>(link)];
  }

 private:
  // How a joint turns its link: about a coordinate axis two columns mix, and most joints are so.
  enum class Turn { kX, kY, kZ, kAny, kSlides };
  struct alignas(64) Hinge {
    PaddedVector offset;        // of the joint, in the parent's axes
    PaddedVector placement[3];  // columns
    PaddedVector axis;          // in the joint's axes
    int parent = 0;
    Turn turn = Turn::kAny;
    bool turned = false;  // the placement turns
    double sign = 1.0;    // of the coordinate axis
  };

  void sines(const Configuration& configuration) noexcept;
  void move_base(const Configuration& configuration) noexcept;
  void move_link(std::size_t j, double q, double qd) noexcept;
  void move_links(const double* q, const double* qd) noexcept;
  void move_links(const std::vector<int>& joints, const double* q, const double* qd) noexcept;

  const Model* model_;
  std::vector<LinkState> links_;
  std::vector<LinkMass> masses_;
  std::vector<Hinge> hinges_;                  // of link i + 1
  std::vector<double> angle_, sine_, cosine_;  // of joints, filled up to a multiple of four
  std::vector<double> subtree_mass_;           // of a link and everything behind it
  std::vector<PaddedVector> subtree_moment_;   // mass times centre of mass of it, world
  Eigen::Vector3d com_;
  double mass_ = 0.0;
};

}  // namespace twinbus::robot
