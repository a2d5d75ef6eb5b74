// Loose bodies in the ODE world: bodies and geoms of ODE's own, soft contact rows like the robot's.

#include "geometry/mesh_contact/contact_mesh.h"
#include "sim/contact/ground_contacts.h"
#include "sim/objects/rigid_object_contacts.h"
#include "sim/objects/rigid_object_mesh.h"
#include "sim/engine/ode_world.h"

namespace twinbus::inline sim {

namespace {

constexpr int kPointsPerLoosePair = 8;

}  // namespace

dGeomID OdeWorld::add_mesh(const ContactMesh& mesh) {
  OdeMesh& added = meshes_.emplace_back();
  for (const Eigen::Vector3d& point : mesh.vertices()) added.add_point(point);
  for (const ContactFace& face : mesh.faces())
    added.add_triangle(face.vertex[0], face.vertex[1], face.vertex[2]);
  return added.create_geom();
}

void OdeWorld::add_loose() {
  for (const LooseBody& body : config_.loose) {
    const Eigen::Matrix3d inertia = inertia_of(body);
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2), 0, 0,
                       0);
    const dBodyID id = dBodyCreate(world_);
    dBodySetMass(id, &mass);
    dBodySetGyroscopicMode(id, 1);
    const dGeomID geom = body.mesh != nullptr ? add_mesh(*body.mesh) : geom_of(body.solid);
    dGeomSetBody(geom, id);
    loose_.push_back({id, geom});
    place_loose(loose_.size() - 1, body.start);
  }
}

void OdeWorld::place_loose(std::size_t index, const LooseState& to) noexcept {
  const dBodyID id = loose_[index].body;
  const Eigen::Quaterniond q = Eigen::Quaterniond(to.pose.linear()).normalized();
  const dQuaternion attitude = {q.w(), q.x(), q.y(), q.z()};
  const Eigen::Vector3d& p = to.pose.translation();
  dBodySetPosition(id, p.x(), p.y(), p.z());
  dBodySetQuaternion(id, attitude);
  dBodySetLinearVel(id, to.velocity.x(), to.velocity.y(), to.velocity.z());
  const Eigen::Vector3d& w = to.angular_velocity;
  dBodySetAngularVel(id, w.x(), w.y(), w.z());
  dBodySetForce(id, 0.0, 0.0, 0.0);
  dBodySetTorque(id, 0.0, 0.0, 0.0);
}

LooseState OdeWorld::loose(int body) const noexcept {
  const dBodyID id = loose_[static_cast<std::size_t>(body)].body;
  const dReal* q = dBodyGetQuaternion(id);
  LooseState state;
  state.pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  state.pose.translation() = vector(dBodyGetPosition(id));
  state.velocity = vector(dBodyGetLinearVel(id));
  state.angular_velocity = vector(dBodyGetAngularVel(id));
  return state;
}

ContactParams OdeWorld::surface(const LooseBody& body) const noexcept {
  return {body.stiffness, body.damping, body.stiffness, body.damping, body.friction};
}

void OdeWorld::find_loose_contacts() noexcept {
  for (std::size_t i = 0; i < loose_.size(); ++i) {
    dReal own_box[6];
    dGeomGetAABB(loose_[i].geom, own_box);
    const auto near = [&](dGeomID geom) {
      dReal box[6];
      dGeomGetAABB(geom, box);
      return bounds_meet(own_box, box);
    };
    if (near(plane_)) meet_fixed(i, plane_);
    for (const dGeomID obstacle : obstacle_geoms_) {
      if (near(obstacle)) meet_fixed(i, obstacle);
    }
    for (const dGeomID tile : tile_geoms_) {
      if (near(tile)) meet_fixed(i, tile);
    }
    for (std::size_t j = i + 1; j < loose_.size(); ++j) {
      if (near(loose_[j].geom)) meet_loose(i, j);
    }
    for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
      for (const OdeGeom& geom : robots_[robot].geoms) {
        if (near(geom.geom)) meet_link(i, robot, geom);
      }
    }
  }
}

void OdeWorld::meet_fixed(std::size_t index, dGeomID geom) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const int count =
      dCollide(loose_[index].geom, geom, kPointsPerLoosePair, found, sizeof(dContactGeom));
  const ContactParams params = together(surface(config_.loose[index]), ground_);
  for (int i = 0; i < count; ++i) add_loose_row(found[i], loose_[index].body, nullptr, params, -1);
}

void OdeWorld::meet_loose(std::size_t index, std::size_t other) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const int count = dCollide(loose_[index].geom, loose_[other].geom, kPointsPerLoosePair, found,
                             sizeof(dContactGeom));
  const ContactParams params = together(surface(config_.loose[index]), surface(config_.loose[other]));
  for (int i = 0; i < count; ++i) {
    add_loose_row(found[i], loose_[index].body, loose_[other].body, params, -1);
  }
}

void OdeWorld::meet_link(std::size_t index, std::size_t robot, const OdeGeom& geom) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const int count =
      dCollide(loose_[index].geom, geom.geom, kPointsPerLoosePair, found, sizeof(dContactGeom));
  for (int i = 0; i < count && has_room(); ++i) {
    const int sole = robots_[robot].sole_at(geom.link, vector(found[i].pos));
    const int felt = feel(robot, geom.link, sole, found[i]);
    add_loose_row(found[i], loose_[index].body, robots_[robot].body(geom.link),
                  together(surface(config_.loose[index]), robots_[robot].surface(sole)), felt);
  }
}

void OdeWorld::add_loose_row(const dContactGeom& geom, dBodyID first, dBodyID second,
                             const ContactParams& params, int felt_by_other) noexcept {
  if (!has_room()) return;
  const double c = damps_by_depth(config_.contact) ? damping_at(as_asked(config_, params), geom.depth)
                                                  : params.damping;
  rows_.push_back({soft_row(geom, velocity_between(geom, first, second), first, params.stiffness, c,
                           params.friction),
                  first, second, -1, felt_by_other});
}

Status OdeWorld::set_loose(int body, const LooseState& state) noexcept {
  if (body < 0 || body >= loose_count()) return Status::kWrongSize;
  const Status status = check_loose(state);
  if (status != Status::kOk) return status;
  place_loose(static_cast<std::size_t>(body), state);
  placed_ = true;
  frozen_ = false;
  return Status::kOk;
}

}  // namespace twinbus::sim
