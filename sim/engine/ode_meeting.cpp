// Robots that touch one another in the ODE world, and links of one robot that do: each pair of
// shapes as ODE collides them, springs and dampers of both sides in series.

#include "sim/objects/rigid_object_contacts.h"
#include "sim/engine/ode_world.h"

namespace twinbus::inline sim {

void OdeWorld::find_meetings() noexcept {
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    if (config_.self_contact) find_meetings(robot, robot);
    for (std::size_t other = robot + 1; other < robots_.size(); ++other) {
      find_meetings(robot, other);
    }
  }
}

void OdeWorld::find_meetings(std::size_t robot, std::size_t other) noexcept {
  const std::vector<OdeGeom>& geoms = robots_[robot].geoms;
  const std::vector<OdeGeom>& others = robots_[other].geoms;
  const bool self = robot == other;
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    dReal box[6];
    dGeomGetAABB(geoms[i].geom, box);
    for (std::size_t j = self ? i + 1 : 0; j < others.size(); ++j) {
      if (self && robots_[robot].never.never_touch(geoms[i].link, others[j].link)) continue;
      dReal other_box[6];
      dGeomGetAABB(others[j].geom, other_box);
      if (bounds_meet(box, other_box)) meet(robot, geoms[i], other, others[j]);
    }
  }
}

void OdeWorld::meet(std::size_t robot, const OdeGeom& geom, std::size_t other,
                    const OdeGeom& other_geom) noexcept {
  const OdeRobot& one = robots_[robot];
  const OdeRobot& two = robots_[other];
  const dBodyID body = one.body(geom.link), other_body = two.body(other_geom.link);
  if (body == nullptr && other_body == nullptr) return;
  if (body == nullptr) {  // the first of a row is to move
    meet(other, other_geom, robot, geom);
    return;
  }
  dContactGeom found[kPointsPerPair];
  const int count =
      dCollide(geom.geom, other_geom.geom, kPointsPerPair, found, sizeof(dContactGeom));
  for (int i = 0; i < count && has_room(); ++i) {
    const Eigen::Vector3d point = vector(found[i].pos);
    const int sole = one.sole_at(geom.link, point);
    const int other_sole = two.sole_at(other_geom.link, point);
    const int felt = feel(robot, geom.link, sole, found[i]);
    const int felt_by_other = feel(other, other_geom.link, other_sole, found[i]);
    add_row(found[i], body, other_body, together(one.surface(sole), two.surface(other_sole)), felt,
            felt_by_other);
  }
}

}  // namespace twinbus::sim
