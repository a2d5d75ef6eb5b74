// The scene in MuJoCo: loading it, where its joints and geoms are, reading and writing its state.

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/math/index.h"
#include "sim/mujoco/mujoco_world.h"
#include "sim/world/coulomb_friction.h"

namespace twinbus::inline sim {

namespace {
constexpr std::size_t kMostContacts = 512;
constexpr std::size_t kMostPushes = 16;
}  // namespace

Model changed_by(const Model& nominal, const WorldConfig& config) {
  Model model = nominal;
  model.floating_base = !config.fixed_base;
  for (Link& link : model.links) {
    link.mass *= config.mass_scale;
    link.inertia *= config.mass_scale;
  }
  for (Joint& joint : model.joints) {
    joint.friction = coulomb_friction(joint, config);
    joint.damping *= config.friction_scale;
  }
  return model;
}

void MujocoWorld::load() {
  ExportedMeshes meshes;
  const std::string title = model_.name.empty() ? "robot" : model_.name;
  const MjcfWorld world = mjcf_of_world(title, model_, config_, configuration_, MjcfUse::kEngine, meshes);
  std::vector<MujocoLibrary::File> files;
  for (const auto& [name, shape] : meshes.all()) files.push_back({"meshes/" + name + ".obj", obj_of_hull(shape)});  // it touches with hulls alone, and takes seconds to find them in a fine mesh
  simulated_ = mujoco_.load(world.xml, files.data(), files.size());
  data_ = mujoco_.make_data(simulated_);
  scratch_ = mujoco_.make_data(simulated_);
  if (data_ == nullptr || scratch_ == nullptr) throw std::runtime_error("engine mujoco: no memory for the scene");
  const auto size = [&](int bit) { return at(mujoco_.state_size(simulated_, bit)); };
  qpos_.resize(size(mujoco_.bits().qpos));
  qvel_.resize(size(mujoco_.bits().qvel));
  forces_.resize(size(mujoco_.bits().qfrc_applied));
  xfrc_.resize(size(mujoco_.bits().xfrc_applied));
  warmstart_.resize(size(mujoco_.bits().warmstart));
  mujoco_.get_state(simulated_, data_, qpos_.data(), mujoco_.bits().qpos);
  start_qpos_ = qpos_;
  start_qvel_ = qvel_;
  start_warmstart_ = warmstart_;
  armatures_ = mujoco_.armatures(simulated_);
  find_places();
  find_geoms(world.geoms);
  contacts_.reserve(kMostContacts);
  pushes_.reserve(kMostPushes);
}

// Joints have their places in qpos in the order of their numbers, a free one has 7 and 6, the others have one.
void MujocoWorld::find_places() {
  joints_.resize(model_.joints.size());
  loose_.resize(config_.loose.size());
  std::map<std::string, Place*> wanted;
  for (std::size_t j = 0; j < joints_.size(); ++j) wanted[model_.joints[j].name] = &joints_[j];
  std::map<std::string, Place*> free;
  if (model_.floating_base) free[kMjcfBase] = &base_;
  for (std::size_t i = 0; i < loose_.size(); ++i) free[mjcf_loose_joint(i)] = &loose_[i];
  Place next;
  std::size_t found = 0;
  for (int id = 0;; ++id) {
    const char* name = mujoco_.id_to_name(simulated_, MujocoLibrary::kJoint, id);
    if (name == nullptr) break;
    const auto is_free = free.find(name);
    Place* place = is_free != free.end() ? is_free->second : wanted.at(name);
    *place = next;
    next.q += is_free != free.end() ? 7 : 1;
    next.v += is_free != free.end() ? 6 : 1;
    ++found;
  }
  servos_.resize(joints_.size());
  pairs_ = parallel_joints_of(model_);
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = model_.joints[j];
    // Joints that share motors are limited there.
    servos_[j].limit = pair_with(pairs_, static_cast<int>(j)) != nullptr ? std::numeric_limits<double>::infinity() : joint.effort;
    servos_[j].rotor = joint.rotor_inertia;
    servos_[j].damping = joint.damping;
    servos_[j].follows = joint.mimic >= 0;
  }
  if (found != wanted.size() + free.size() || next.q != qpos_.size() || next.v != qvel_.size())
    throw std::runtime_error("engine mujoco: MuJoCo read other joints than the robot's");
}

int MujocoWorld::body_of(int link) const {
  for (int i = link; i < model_.link_count(); ++i) {  // one without mass is part of the next
    const int body = mujoco_.name_to_id(simulated_, MujocoLibrary::kBody, model_.links[at(i)].name.c_str());
    if (body >= 0) return body;
  }
  return 0;
}

void MujocoWorld::find_geoms(const std::map<std::string, MjcfText::Geom>& geoms) {
  for (int i = 0; i < model_.link_count(); ++i) bodies_.push_back(body_of(i));
  for (const auto& [name, owner] : geoms) {
    const int id = mujoco_.name_to_id(simulated_, MujocoLibrary::kGeom, name.c_str());
    if (id < 0) continue;
    if (geom_owners_.size() <= at(id)) geom_owners_.resize(at(id) + 1, {-1, -1});
    geom_owners_[at(id)] = owner;
  }
}

void write_mujoco_pose(const Eigen::Isometry3d& pose, double* to) noexcept {
  const Eigen::Quaterniond q(pose.linear());
  const Eigen::Vector3d p = pose.translation();
  const std::array<double, 7> numbers{p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
  std::copy(numbers.begin(), numbers.end(), to);
}

Eigen::Isometry3d read_mujoco_pose(const double* from) noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(from[0], from[1], from[2]);
  pose.linear() = Eigen::Quaterniond(from[3], from[4], from[5], from[6]).normalized().toRotationMatrix();
  return pose;
}

void write_mujoco_velocity(const Eigen::Matrix3d& axes, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                           double* to) noexcept {
  const Eigen::Vector3d own = axes.transpose() * angular;
  for (int i = 0; i < 3; ++i) {
    to[i] = linear[i];
    to[i + 3] = own[i];
  }
}

void MujocoWorld::write_state() noexcept {
  if (model_.floating_base) {
    write_mujoco_pose(configuration_.base, &qpos_[base_.q]);
    write_mujoco_velocity(configuration_.base.linear(), configuration_.base_velocity, configuration_.base_angular_velocity,
                          &qvel_[base_.v]);
  } else {
    std::array<double, 7> pose{};
    write_mujoco_pose(configuration_.base, pose.data());
    mujoco_.set_state(simulated_, data_, pose.data(), mujoco_.bits().mocap_pos);
    mujoco_.set_state(simulated_, data_, pose.data() + 3, mujoco_.bits().mocap_quat);
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    qpos_[joints_[j].q] = configuration_.q[static_cast<Eigen::Index>(j)];
    qvel_[joints_[j].v] = configuration_.qd[static_cast<Eigen::Index>(j)];
  }
  mujoco_.set_state(simulated_, data_, qpos_.data(), mujoco_.bits().qpos);
  mujoco_.set_state(simulated_, data_, qvel_.data(), mujoco_.bits().qvel);
  mujoco_.set_state(simulated_, data_, warmstart_.data(), mujoco_.bits().warmstart);  // zeros
}

void MujocoWorld::read_state() noexcept {
  mujoco_.get_state(simulated_, data_, qpos_.data(), mujoco_.bits().qpos);
  mujoco_.get_state(simulated_, data_, qvel_.data(), mujoco_.bits().qvel);
  if (model_.floating_base) {
    configuration_.base = read_mujoco_pose(&qpos_[base_.q]);
    const double* v = &qvel_[base_.v];
    configuration_.base_velocity = Eigen::Vector3d(v[0], v[1], v[2]);
    configuration_.base_angular_velocity = configuration_.base.linear() * Eigen::Vector3d(v[3], v[4], v[5]);
  }
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    configuration_.q[static_cast<Eigen::Index>(j)] = qpos_[joints_[j].q];
    configuration_.qd[static_cast<Eigen::Index>(j)] = qvel_[joints_[j].v];
  }
}

bool MujocoWorld::sane() const noexcept {
  const auto within = [](const std::vector<double>& values, double bound) {
    return std::all_of(values.begin(), values.end(), [bound](double value) { return std::abs(value) <= bound; });
  };
  return within(qpos_, kMaxDistance) && within(qvel_, kMaxSpeed);
}

void MujocoWorld::read_contacts() noexcept {
  contacts_.clear();
  elastic_ = 0.0;
  const int count = mujoco_.contact_count(data_);
  for (int i = 0; i < count; ++i) {
    const SolvedContact each = mujoco_.contact(data_, i);
    std::array<double, 6> local{};
    mujoco_.contact_force(simulated_, data_, i, local.data());
    const Eigen::Map<const Eigen::Matrix3d> axes(each.frame);  // columns: MuJoCo's rows
    const Eigen::Vector3d force = axes * Eigen::Vector3d(local[0], local[1], local[2]);
    const double depth = std::max(0.0, -each.distance);
    if (!force.allFinite()) continue;
    elastic_ += 0.5 * std::max(0.0, local[0]) * depth;
    for (int end = 0; end < 2; ++end) {
      const int geom = each.geom[end];
      if (geom < 0 || at(geom) >= geom_owners_.size() || geom_owners_[at(geom)].link < 0) continue;
      if (contacts_.size() == contacts_.capacity()) return;
      ContactPoint& point = contacts_.emplace_back();
      point.link = geom_owners_[at(geom)].link;
      point.sole = geom_owners_[at(geom)].sole;
      point.point = Eigen::Vector3d(each.position[0], each.position[1], each.position[2]);
      point.force = end == 0 ? Eigen::Vector3d(-force) : force;  // MuJoCo's is on the second
      point.depth = depth;
    }
  }
}

}  // namespace twinbus::sim
