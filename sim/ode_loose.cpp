// Loose bodies in the ODE world: bodies and geoms of ODE's own, soft contact rows like the robot's.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/contact/contact_mesh.h"
#include "sim/loose_mesh.h"
#include "sim/ode_impl.h"

namespace twinbus {

namespace {

constexpr int kPointsPerLoosePair = 8;

double springs_in_series(double a, double b) { return a + b > 0.0 ? a * b / (a + b) : 0.0; }

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
  loose_feedback.resize(loose.size() * static_cast<std::size_t>(kMostLooseContacts));
  loose_rows.reserve(loose_feedback.size());
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

void OdeWorld::Impl::find_loose_contacts() noexcept {
  loose_rows.clear();
  for (std::size_t i = 0; i < loose.size(); ++i) {
    const LooseBody& own = config.loose[i];
    const auto meet = [&](dGeomID geom, const LooseSide& side) {
      dReal a[6], b[6];
      dGeomGetAABB(loose[i].geom, a);
      dGeomGetAABB(geom, b);
      if (bounds_meet(a, b)) meet_loose(i, geom, side);
    };
    const double mu = config.ground_friction;
    const LooseSide fixed{nullptr, -1, own.stiffness, own.damping, std::sqrt(own.friction * mu)};
    meet(plane, fixed);
    for (const dGeomID obstacle : obstacle_geoms) meet(obstacle, fixed);
    for (const dGeomID tile : tile_geoms) meet(tile, fixed);
    for (std::size_t j = i + 1; j < loose.size(); ++j) {
      const LooseBody& other = config.loose[j];
      meet(loose[j].geom, {loose[j].body, -1, springs_in_series(own.stiffness, other.stiffness),
                           springs_in_series(own.damping, other.damping),
                           std::sqrt(own.friction * other.friction)});
    }
    for (const OdeGeom& geom : link_geoms) {
      meet(geom.geom,
           {body(geom.link), geom.link, springs_in_series(own.stiffness, kLinkStiffness),
            springs_in_series(own.damping, kLinkDamping), std::sqrt(own.friction * kLinkFriction)});
    }
  }
}

void OdeWorld::Impl::meet_loose(std::size_t index, dGeomID geom, const LooseSide& side) noexcept {
  dContactGeom found[kPointsPerLoosePair];
  const LooseBody& own = config.loose[index];
  const int count =
      dCollide(loose[index].geom, geom, kPointsPerLoosePair, found, sizeof(dContactGeom));
  for (int i = 0; i < count; ++i) {
    if (loose_rows.size() >= loose_feedback.size()) return;
    const Eigen::Vector3d point = vector(found[i].pos);
    double k = side.stiffness, c = side.damping, mu = side.friction;
    const int sole_side = sole_at(side.link, point);
    if (sole_side >= 0) {
      const Sole& sole = model.soles[static_cast<std::size_t>(sole_side)];
      k = springs_in_series(own.stiffness, sole.stiffness / kSoleCorners * config.stiffness_scale);
      c = springs_in_series(own.damping, sole.damping / kSoleCorners * config.damping_scale);
      mu = std::sqrt(own.friction * sole.friction);
    }
    dVector3 v, other{0.0, 0.0, 0.0, 0.0};
    dBodyGetPointVel(loose[index].body, point.x(), point.y(), point.z(), v);
    if (side.body != nullptr) {
      dBodyGetPointVel(side.body, point.x(), point.y(), point.z(), other);
    }
    if (config.contact == ContactModel::kHuntCrossley) c = damping_at(k, c, found[i].depth);
    LooseRow row;
    row.contact =
        soft_row(found[i], vector(v) - vector(other), loose_state(index).pose.linear(), k, c, mu);
    row.own = loose[index].body;
    row.other = side.body;
    row.reported = -1;
    if (side.link >= 0 && contacts.size() < static_cast<std::size_t>(kMaxContacts)) {
      row.reported = static_cast<int>(contacts.size());
      contacts.push_back({.link = side.link,
                          .sole = sole_side,
                          .point = point,
                          .force = Eigen::Vector3d::Zero(),
                          .depth = found[i].depth});
    }
    loose_rows.push_back(row);
  }
}

void OdeWorld::Impl::create_loose_joints() noexcept {
  for (std::size_t i = 0; i < loose_rows.size(); ++i) {
    const dJointID joint = dJointCreateContact(world, contact_group, &loose_rows[i].contact);
    dJointAttach(joint, loose_rows[i].own, loose_rows[i].other);
    dJointSetFeedback(joint, &loose_feedback[i]);
  }
}

void OdeWorld::Impl::read_loose_forces() noexcept {
  for (std::size_t i = 0; i < loose_rows.size(); ++i) {
    if (loose_rows[i].reported < 0) continue;
    contacts[static_cast<std::size_t>(loose_rows[i].reported)].force = vector(loose_feedback[i].f2);
  }
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
  impl_->frozen = false;
  return Status::kOk;
}

}  // namespace twinbus
