#include "sim/scene/scene_seed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "common/math/random.h"

namespace twinbus::inline sim {

namespace {

constexpr double kThick = 0.2;  // of a tile [m]

int link_of(const Scene& scene, const Model& model, const std::string& name) {
  const int link = model.find_link(name);
  if (link < 0)
    throw std::runtime_error("scene " + scene.name + ": the robot " + model.name +
                             " has no moving link '" + name + "'");
  return link;
}

struct Ground {
  double height, pitch;  // [m], [rad]
};

// So far along a terrain: up, level, down; whole tiles each.
Ground ramp_at(const Terrain& terrain, double along) {
  const double third = terrain.tile * std::round(terrain.length / (3.0 * terrain.tile));
  const double rise = std::tan(terrain.ramp);
  if (along < third) return {rise * along, -terrain.ramp};
  if (along < 2.0 * third) return {rise * third, 0.0};
  return {rise * std::max(0.0, 3.0 * third - along), terrain.ramp};
}

// Its top's middle is as high as drawn; its sides stand a hair into the neighbours', so that there is no gap.
Obstacle tile_at(const Terrain& terrain, double x, double y, Random& random) {
  const Ground ramp = ramp_at(terrain, x - terrain.from);
  const double height = ramp.height + terrain.height * random.uniform();
  const double roll = terrain.slope * (2.0 * random.uniform() - 1.0);
  const double pitch = ramp.pitch + terrain.slope * (2.0 * random.uniform() - 1.0);
  Obstacle tile;
  tile.shape = ObstacleShape::kBox;
  tile.size << terrain.tile / std::cos(ramp.pitch), terrain.tile, kThick;
  tile.pose.linear() = (Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                        Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                           .toRotationMatrix();
  tile.pose.translation() =
      Eigen::Vector3d(x, y, height) - 0.5 * kThick * tile.pose.linear().col(2);
  return tile;
}

void lay_tiles(Scene& scene, Random& random) {
  const Terrain& t = scene.terrain;
  scene.tiles.clear();
  if (!(t.length > 0.0)) return;
  const int along = static_cast<int>(std::ceil(t.length / t.tile - 1e-9));
  const int across = static_cast<int>(std::ceil(t.width / t.tile - 1e-9));
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < across; ++j) {
      const double x = t.from + t.tile * (i + 0.5);
      const double y = t.tile * (j + 0.5 - 0.5 * across);
      scene.tiles.push_back(tile_at(t, x, y, random));
    }
  }
}

// Impulse in one of eight directions, counted from forward to the left: an ellipse through the strengths asked for.
Eigen::Vector3d impulse_of(const PushRound& round, int direction, double mass) {
  const double angle = 0.25 * std::numbers::pi * direction;
  const double c = std::cos(angle), s = std::sin(angle);
  const double along = c > 0.0 ? round.forward : round.back;
  const double speed =
      1.0 / std::hypot(c / std::max(along, 1e-6), s / std::max(round.sideways, 1e-6));
  return mass * speed * Eigen::Vector3d(c, s, 0.0);
}

void draw_pushes(Scene& scene, const Model& model, Random& random) {
  const PushRound& round = scene.push_round;
  if (round.count == 0) return;
  const std::string link = round.link.empty()
                               ? model.links.front().name
                               : model.links[at(link_of(scene, model, round.link))].name;
  const int first = static_cast<int>(random.next() % 8);
  for (int i = 0; i < round.count; ++i) {
    Push push;
    push.link = link;
    push.impulse = impulse_of(round, (first + i) % 8, model.total_mass());
    push.at = round.at + round.every * i + round.phase * random.uniform();
    push.duration = round.duration;
    scene.pushes.push_back(push);
  }
}

// Times a setting that the scene may have already.
void scale_setting(Scene& scene, const std::string& key, double factor, double otherwise) {
  const auto is_it = [&](const auto& each) { return each.first == key; };
  const auto found = std::find_if(scene.settings.rbegin(), scene.settings.rend(), is_it);
  const double before = found != scene.settings.rend() ? std::stod(found->second) : otherwise;
  std::erase_if(scene.settings, is_it);
  scene.settings.emplace_back(key, std::to_string(factor * before));
}

bool has_setting(const Scene& scene, const std::string& key) {
  return std::any_of(scene.settings.begin(), scene.settings.end(), [&](const auto& each) { return each.first == key; });
}

// Every number is drawn, used or not: one figure of a disturbance changes nothing of the others.
void disturb(Scene& scene, const Model& model, Random& random) {
  const Disturbance& d = scene.disturbance;
  const auto within = [&random](double most) { return most * (2.0 * random.uniform() - 1.0); };
  const auto three = [&](double most) {
    const double x = within(most), y = within(most), z = within(most);
    return Eigen::Vector3d(x, y, z);
  };
  // What lies on something is not pressed into it.
  const auto along = [&](const Eigen::Vector3d& way) { return Eigen::Vector3d(way.x(), way.y(), d.level ? 0.0 : way.z()); };
  const auto about = [&](const Eigen::Vector3d& turn) { return d.level ? Eigen::Vector3d(0.0, 0.0, turn.z()) : turn; };
  if (!is_disturbed(scene)) return;
  for (LooseBody& body : scene.loose) {
    body.start.pose.translation() += along(three(d.position));
    const Eigen::Vector3d turn = about(three(d.angle));
    if (turn.norm() > 0.0)
      body.start.pose.linear() =
          Eigen::AngleAxisd(turn.norm(), turn.normalized()) * body.start.pose.linear();
    body.start.velocity += along(three(d.velocity));
    body.start.angular_velocity += about(three(d.spin));
    body.mass *= 1.0 + within(d.mass);
    body.friction *= 1.0 + within(d.friction);
  }
  const double rougher = 1.0 + within(d.friction);
  scene.ground_friction *= rougher;
  if (d.friction > 0.0 && has_setting(scene, "contact.friction")) scale_setting(scene, "contact.friction", rougher, 1.0);
  const double heavier = 1.0 + within(d.mass);
  if (d.mass > 0.0) scale_setting(scene, "model.mass_scale", heavier, 1.0);
  for (const Joint& joint : model.joints) {
    const double speed = within(d.joints);
    if (d.joints > 0.0 && joint.mimic < 0) scene.start_velocity.emplace_back(joint.name, speed);
  }
}

}  // namespace

bool is_disturbed(const Scene& scene) {
  const Disturbance& d = scene.disturbance;
  const auto asked = {d.position, d.angle, d.velocity, d.spin, d.mass, d.friction, d.joints};
  return std::any_of(asked.begin(), asked.end(), [](double most) { return most > 0.0; });
}

bool draws_from_seed(const Scene& scene) {
  return scene.terrain.length > 0.0 || scene.push_round.count > 0 || is_disturbed(scene);
}

Disturbance small_disturbance() {
  Disturbance d;
  d.position = 1e-3;
  d.angle = 5e-3;
  d.velocity = 5e-3;
  d.spin = 2e-2;
  d.mass = 0.02;
  d.friction = 0.1;
  d.joints = 0.05;
  d.level = true;
  return d;
}

void apply_seed(Scene& scene, const Model& model, std::uint64_t seed) {
  Random random(seed);
  lay_tiles(scene, random);
  draw_pushes(scene, model, random);
  disturb(scene, model, random);
}

Model changed_model(const Model& model, const Scene& scene) {
  Model changed = model;
  for (const BodyChange& change : scene.bodies) {
    Link& link = changed.links[at(link_of(scene, model, change.link))];
    link.com += change.shift;
    if (!(change.mass > 0.0)) continue;
    // A point mass: both inertias about the common centre.
    const double mass = link.mass + change.mass;
    const Eigen::Vector3d com = (link.mass * link.com + change.mass * change.at) / mass;
    const auto moved = [](double m, const Eigen::Vector3d& d) {
      return Eigen::Matrix3d(m *
                             (d.squaredNorm() * Eigen::Matrix3d::Identity() - d * d.transpose()));
    };
    link.inertia += moved(link.mass, link.com - com) + moved(change.mass, change.at - com);
    link.mass = mass;
    link.com = com;
  }
  return changed;
}

}  // namespace twinbus::sim
