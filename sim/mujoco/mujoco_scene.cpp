// The scene in MuJoCo: loading it, where its joints and geoms are, reading and writing its state.

#include <array>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "sim/mujoco/mujoco_impl.h"
#include "sim/world/coulomb_friction.h"

namespace twinbus {

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

void MujocoWorld::Impl::load() {
  ExportedMeshes meshes;
  const std::string title = model.name.empty() ? "robot" : model.name;
  const MjcfWorld world = mjcf_of_world(title, model, config, configuration, MjcfUse::kEngine, meshes);
  std::vector<MujocoLibrary::File> files;
  for (const auto& [name, shape] : meshes.all()) files.push_back({"meshes/" + name + ".obj", obj_of_hull(shape)});  // it touches with hulls alone, and takes seconds to find them in a fine mesh
  simulated = mujoco.load(world.xml, files.data(), files.size());
  data = mujoco.make_data(simulated);
  scratch = mujoco.make_data(simulated);
  if (data == nullptr || scratch == nullptr) throw std::runtime_error("engine mujoco: no memory for the scene");
  const auto size = [&](int bit) { return at(mujoco.state_size(simulated, bit)); };
  qpos.resize(size(mujoco.bits().qpos));
  qvel.resize(size(mujoco.bits().qvel));
  forces.resize(size(mujoco.bits().qfrc_applied));
  xfrc.resize(size(mujoco.bits().xfrc_applied));
  warmstart.resize(size(mujoco.bits().warmstart));
  mujoco.get_state(simulated, data, qpos.data(), mujoco.bits().qpos);
  start_qpos = qpos;
  start_qvel = qvel;
  start_warmstart = warmstart;
  armatures = mujoco.armatures(simulated);
  find_places();
  find_geoms(world.geoms);
  contacts.reserve(kMostContacts);
  pushes.reserve(kMostPushes);
}

// Joints have their places in qpos in the order of their numbers, a free one has 7 and 6, the others have one.
void MujocoWorld::Impl::find_places() {
  joints.resize(model.joints.size());
  loose.resize(config.loose.size());
  std::map<std::string, Place*> wanted;
  for (std::size_t j = 0; j < joints.size(); ++j) wanted[model.joints[j].name] = &joints[j];
  std::map<std::string, Place*> free;
  if (model.floating_base) free[kMjcfBase] = &base;
  for (std::size_t i = 0; i < loose.size(); ++i) free[mjcf_loose_joint(i)] = &loose[i];
  Place next;
  std::size_t found = 0;
  for (int id = 0;; ++id) {
    const char* name = mujoco.id_to_name(simulated, MujocoLibrary::kJoint, id);
    if (name == nullptr) break;
    const auto is_free = free.find(name);
    Place* place = is_free != free.end() ? is_free->second : wanted.at(name);
    *place = next;
    next.q += is_free != free.end() ? 7 : 1;
    next.v += is_free != free.end() ? 6 : 1;
    ++found;
  }
  servos.resize(joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    servos[j].limit = joint.effort;
    servos[j].rotor = joint.rotor_inertia;
    servos[j].damping = joint.damping;
    servos[j].follows = joint.mimic >= 0;
  }
  if (found != wanted.size() + free.size() || next.q != qpos.size() || next.v != qvel.size())
    throw std::runtime_error("engine mujoco: MuJoCo read other joints than the robot's");
}

int MujocoWorld::Impl::body_of(int link) const {
  for (int i = link; i < model.link_count(); ++i) {  // one without mass is part of the next
    const int body = mujoco.name_to_id(simulated, MujocoLibrary::kBody, model.links[at(i)].name.c_str());
    if (body >= 0) return body;
  }
  return 0;
}

void MujocoWorld::Impl::find_geoms(const std::map<std::string, MjcfText::Geom>& geoms) {
  for (int i = 0; i < model.link_count(); ++i) bodies.push_back(body_of(i));
  for (const auto& [name, owner] : geoms) {
    const int id = mujoco.name_to_id(simulated, MujocoLibrary::kGeom, name.c_str());
    if (id < 0) continue;
    if (geom_owners.size() <= at(id)) geom_owners.resize(at(id) + 1, {-1, -1});
    geom_owners[at(id)] = owner;
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

void MujocoWorld::Impl::write_state() noexcept {
  if (model.floating_base) {
    write_mujoco_pose(configuration.base, &qpos[base.q]);
    write_mujoco_velocity(configuration.base.linear(), configuration.base_velocity, configuration.base_angular_velocity,
                          &qvel[base.v]);
  } else {
    std::array<double, 7> pose{};
    write_mujoco_pose(configuration.base, pose.data());
    mujoco.set_state(simulated, data, pose.data(), mujoco.bits().mocap_pos);
    mujoco.set_state(simulated, data, pose.data() + 3, mujoco.bits().mocap_quat);
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    qpos[joints[j].q] = configuration.q[static_cast<Eigen::Index>(j)];
    qvel[joints[j].v] = configuration.qd[static_cast<Eigen::Index>(j)];
  }
  mujoco.set_state(simulated, data, qpos.data(), mujoco.bits().qpos);
  mujoco.set_state(simulated, data, qvel.data(), mujoco.bits().qvel);
  mujoco.set_state(simulated, data, warmstart.data(), mujoco.bits().warmstart);  // zeros
}

void MujocoWorld::Impl::read_state() noexcept {
  mujoco.get_state(simulated, data, qpos.data(), mujoco.bits().qpos);
  mujoco.get_state(simulated, data, qvel.data(), mujoco.bits().qvel);
  if (model.floating_base) {
    configuration.base = read_mujoco_pose(&qpos[base.q]);
    const double* v = &qvel[base.v];
    configuration.base_velocity = Eigen::Vector3d(v[0], v[1], v[2]);
    configuration.base_angular_velocity = configuration.base.linear() * Eigen::Vector3d(v[3], v[4], v[5]);
  }
  for (std::size_t j = 0; j < joints.size(); ++j) {
    configuration.q[static_cast<Eigen::Index>(j)] = qpos[joints[j].q];
    configuration.qd[static_cast<Eigen::Index>(j)] = qvel[joints[j].v];
  }
}

bool MujocoWorld::Impl::sane() const noexcept {
  const auto within = [](const std::vector<double>& values, double bound) {
    return std::all_of(values.begin(), values.end(), [bound](double value) { return std::abs(value) <= bound; });
  };
  return within(qpos, kMaxDistance) && within(qvel, kMaxSpeed);
}

void MujocoWorld::Impl::read_contacts() noexcept {
  contacts.clear();
  elastic = 0.0;
  const int count = mujoco.contact_count(data);
  for (int i = 0; i < count; ++i) {
    const MujocoContact each = mujoco.contact(data, i);
    std::array<double, 6> local{};
    mujoco.contact_force(simulated, data, i, local.data());
    const Eigen::Map<const Eigen::Matrix3d> axes(each.frame);  // columns: MuJoCo's rows
    const Eigen::Vector3d force = axes * Eigen::Vector3d(local[0], local[1], local[2]);
    const double depth = std::max(0.0, -each.distance);
    if (!force.allFinite()) continue;
    elastic += 0.5 * std::max(0.0, local[0]) * depth;
    for (int end = 0; end < 2; ++end) {
      const int geom = each.geom[end];
      if (geom < 0 || at(geom) >= geom_owners.size() || geom_owners[at(geom)].link < 0) continue;
      if (contacts.size() == contacts.capacity()) return;
      ContactPoint& point = contacts.emplace_back();
      point.link = geom_owners[at(geom)].link;
      point.sole = geom_owners[at(geom)].sole;
      point.point = Eigen::Vector3d(each.position[0], each.position[1], each.position[2]);
      point.force = end == 0 ? Eigen::Vector3d(-force) : force;  // MuJoCo's is on the second
      point.depth = depth;
    }
  }
}

}  // namespace twinbus
