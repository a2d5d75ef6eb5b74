// Loose bodies in the ODE world: bodies and geoms of ODE's own, soft contact rows like the robot's.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/mesh_contact/contact_mesh.h"
#include "sim/contact/ground_contacts.h"
#include "sim/contact/rigid_object_contacts.h"
#include "sim/contact/rigid_object_mesh.h"
#include "sim/engine/ode_impl.h"

namespace twinbus {

namespace {

constexpr int kPointsPerLoosePair = 8;

}  // namespace

dGeomID OdeWorld::Impl::add_mesh(const ContactMesh& mesh) {
  OdeMesh& added = meshes.emplace_back();
  for (const Eigen::Vector3d& point : mesh.vertices()) added.add_point(point);
  for (const ContactFace& face : mesh.faces())
    added.add_triangle(face.vertex[0], face.vertex[1], face.vertex[2]);
  return added.create_geom();
}

void OdeWorld::Impl::add_loose() {
  for (const LooseBody& body : config.loose) {
    const Eigen::Matrix3d inertia = inertia_of(body);
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2), 0, 0,
                       0);
    const dBodyID id = dBodyCreate(world);
    dBodySetMass(id, &mass);
    dBodySetGyroscopicMode(id, 1);
    const dGeomID geom = body.mesh != nullptr ? add_mesh(*body.mesh) : geom_of(body.solid);
    dGeomSetBody(geom, id);
    loose.push_back({id, geom});
    set_loose(loose.size() - 1, body.start);
  }
}

void OdeWorld::Impl::set_loose(std::size_t index, const LooseState& to) noexcept {
  const dBodyID id = loose[index].body;
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

LooseState OdeWorld::Impl::loose_state(std::size_t index) const noexcept {
  const dBodyID id = loose[index].body;
  const dReal* q = dBodyGetQuaternion(id);
  LooseState state;
  state.pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  state.pose.translation() = vector(dBodyGetPosition(id));
  state.velocity = vector(dBodyGetLinearVel(id));
  state.angular_velocity = vector(dBodyGetAngularVel(id));
  return state;
}

ContactParams OdeWorld::Impl::surface(const LooseBody& body) const noexcept {
  return {body.stiffness, body.damping, body.stiffness, body.damping, body.friction};
}

void OdeWorld::Impl::find_loose_contacts() noexcept {
  for (std::size_t i = 0; i < loose.size(); ++i) {
    dReal own_box[6];
    dGeomGetAABB(loose[i].geom, own_box);
    const auto near = [&](dGeomID geom) {
      dReal box[6];
      dGeomGetAABB(geom, box);
      return bounds_meet(own_box, box);
    };
    if (near(plane)) meet_fixed(i, plane);
    for (const dGeomID obstacle : obstacle_geoms) {
      if (near(obstacle)) meet_fixed(i, obstacle);
    }
    for (const dGeomID tile : tile_geoms) {
      if (near(tile)) meet_fixed(i, tile);
    }
    for (std::size_t j = i + 1; j < loose.size(); ++j) {
      if (near(loose[j].geom)) meet_loose(i, j);
    }
    for (std::size_t robot = 0; robot < robots.size(); ++robot) {
      for (const OdeGeom& geom : robots[robot].geoms) {
        if (near(geom.geom)) meet_link(i, robot, geom);
      }
    }
  }
}

void OdeWorld::Impl::meet_fixed(std::size_t index, dGeomID geom) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const int count =
      dCollide(loose[index].geom, geom, kPointsPerLoosePair, found, sizeof(dContactGeom));
  const ContactParams params = together(surface(config.loose[index]), ground);
  for (int i = 0; i < count; ++i) add_loose_row(found[i], loose[index].body, nullptr, params, -1);
}

void OdeWorld::Impl::meet_loose(std::size_t index, std::size_t other) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const int count = dCollide(loose[index].geom, loose[other].geom, kPointsPerLoosePair, found,
                             sizeof(dContactGeom));
  const ContactParams params = together(surface(config.loose[index]), surface(config.loose[other]));
  for (int i = 0; i < count; ++i) {
    add_loose_row(found[i], loose[index].body, loose[other].body, params, -1);
  }
}

void OdeWorld::Impl::meet_link(std::size_t index, std::size_t robot, const OdeGeom& geom) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const int count =
      dCollide(loose[index].geom, geom.geom, kPointsPerLoosePair, found, sizeof(dContactGeom));
  for (int i = 0; i < count && has_room(); ++i) {
    const int sole = robots[robot].sole_at(geom.link, vector(found[i].pos));
    const int felt = feel(robot, geom.link, sole, found[i]);
    add_loose_row(found[i], loose[index].body, robots[robot].body(geom.link),
                  together(surface(config.loose[index]), robots[robot].surface(sole)), felt);
  }
}

void OdeWorld::Impl::add_loose_row(const dContactGeom& geom, dBodyID first, dBodyID second,
                                   const ContactParams& params, int felt_by_other) noexcept {
  if (!has_room()) return;
  const double c = damps_by_depth(config.contact) ? damping_at(as_asked(config, params), geom.depth)
                                                  : params.damping;
  rows.push_back({soft_row(geom, velocity_between(geom, first, second), first, params.stiffness, c,
                           params.friction),
                  first, second, -1, felt_by_other});
}

int OdeWorld::loose_count() const noexcept { return static_cast<int>(impl_->loose.size()); }

LooseState OdeWorld::loose(int body) const noexcept {
  return impl_->loose_state(static_cast<std::size_t>(body));
}

Status OdeWorld::set_loose(int body, const LooseState& state) noexcept {
  if (body < 0 || body >= loose_count()) return Status::kWrongSize;
  const Status status = check_loose(state);
  if (status != Status::kOk) return status;
  impl_->set_loose(static_cast<std::size_t>(body), state);
  impl_->placed = true;
  impl_->frozen = false;
  return Status::kOk;
}

}  // namespace twinbus
