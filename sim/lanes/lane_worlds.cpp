#include "sim/lanes/lane_worlds.h"

#include <algorithm>
#include <stdexcept>

namespace twinbus::inline sim {

namespace {

void set(const Eigen::Vector3d& v, std::size_t lane, Three<Vec4>& to) noexcept {
  to.x[lane] = v.x();
  to.y[lane] = v.y();
  to.z[lane] = v.z();
}
Eigen::Vector3d vector_of(const Three<Vec4>& v, std::size_t lane) noexcept { return {v.x[lane], v.y[lane], v.z[lane]}; }
void set_params(const ContactParams& params, std::size_t lane, CornerLanes& to) noexcept {
  to.k[lane] = params.stiffness;
  to.c[lane] = params.damping;
  to.kt[lane] = params.tangent_stiffness;
  to.ct[lane] = params.tangent_damping;
  to.mu[lane] = params.friction;
  to.ramp[lane] = params.ramp;
}
double* numbers_of(LaneBlock& block, std::size_t rank, std::size_t field, std::size_t lane) noexcept {
  return reinterpret_cast<double*>(&block.body.links[rank]) + field * kWorldLanes + lane;
}

void set_target(const ServoTarget& target, std::size_t lane, JointLanes& to) noexcept {
  to.q[lane] = target.q;
  to.qd[lane] = target.qd;
  to.tau[lane] = target.tau;
  to.kp[lane] = target.kp;
  to.kd[lane] = target.kd;
}
// Of the ground below it, which is the only surface.
int key_of(const CornerLanes& corner) noexcept { return corner.sole * kSoleCorners + corner.corner; }

}  // namespace

// A world of the four.  Either the lanes know how it is or the world of engine articulated; the latter may know it too.
class LaneWorlds::Lane final : public ForwardingWorld {
 public:
  Lane(LaneWorlds& all, int number, std::unique_ptr<World> owner, ArticulatedWorld& world)
      : number_(number), owner_(std::move(owner)), world_(world), all_(all) {}

  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override {
    return outside().set(configuration, tau);
  }
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override {
    return world_.push(link, point, force);
  }
  void set_corner_offset(int sole, int corner, double offset) noexcept override {
    outside().set_corner_offset(sole, corner, offset);
  }
  void estimate_contact_forces() noexcept override { outside().estimate_contact_forces(); }
  Status set_loose(int body, const LooseState& state) noexcept override { return outside().set_loose(body, state); }
  Status hold(int tie, bool holds) noexcept override { return outside().hold(tie, holds); }
  Status step() noexcept override {
    std::array<Status, kWorldLanes> status;
    all_.step(1 << number_, status);
    return status[at(number_)];
  }

  std::size_t number() const noexcept { return at(number_); }
  // Which step was to be taken in the lanes and was not.
  Status step_outside() noexcept {
    ArticulatedWorld& world = outside();
    const Status status = world.step();
    trust_ = world.trust();
    return status;
  }
  // The loose bodies go first: they, and what touches them, are in the world itself.
  bool begin_loose(const Eigen::AlignedBox3d& robot) noexcept { return world_.step_loose(robot); }
  void stepped(double doubted_depth) noexcept {
    trust_ = world_.trust();
    trust_[Doubt::kDeep] = trust_[Doubt::kDeep] || doubted_depth > 0.0;
    trust_.first_depth = std::max(trust_.first_depth, doubted_depth);
    shown_ = world_.placed_ = false;
    world_.pushes_.clear();
    world_.rest();
  }

 private:
  friend class LaneWorlds;
  const World& shown() const noexcept override {
    if (!shown_) all_.leave(*this);
    shown_ = true;
    return world_;
  }
  ArticulatedWorld& outside() noexcept {
    (void)shown();
    if (viewed_) world_.body_.place(world_.configuration_);
    viewed_ = inside_ = false;
    return world_;
  }

  int number_;
  std::unique_ptr<World> owner_;
  ArticulatedWorld& world_;
  LaneWorlds& all_;
  bool inside_ = false;          // the lanes know
  mutable bool shown_ = true;    // the world knows
  mutable bool viewed_ = false;  // of its body only where links are and how fast
};

Status LaneWorlds::Lane::set_servo(int joint, const ServoTarget& target) noexcept {
  const Status status = world_.set_servo(joint, target);
  if (status != Status::kOk) return status;
  set_target(world_.joints_[at(joint)].target_, number(), all_.joint(at(joint)));
  return status;
}

std::string LaneWorlds::why_not(const WorldConfig& config) {
  if (config.engine != Engine::kArticulated) return "engine is not articulated";
  if (config.order != 1) return "solver.order is not 1";
  if (config.flight != Flight::kImplicit) return "flight is not implicit";
  if (config.contact != ContactModel::kSpringDamper && config.contact != ContactModel::kHuntCrossley)
    return "contact is neither spring_damper nor hunt_crossley";
  if (config.rolling_friction > 0.0 || config.torsional_friction > 0.0) return "contacts have rolling or torsional friction";
  if (config.twin) return "there is a twin";
  if (!config.ties.empty()) return "there are ties";
  if (!config.robots.empty() || config.self_contact) return "robots touch one another or themselves";
  if (!config.obstacles.empty() || !config.tiles.empty()) return "there are obstacles or uneven ground";
  const auto any = [](const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); };
  return any(config.held) || any(config.rigid_robots) ? "less than all is modelled" : "";
}

LaneWorlds::LaneWorlds(const std::vector<const Model*>& models, std::vector<std::unique_ptr<World>> worlds) {
  if (models.empty() || models.size() > kWorldLanes || models.size() != worlds.size())
    throw std::runtime_error("lanes: one to four worlds");
  for (auto& world : worlds) {
    auto* ours = dynamic_cast<ArticulatedWorld*>(world.get());
    if (ours == nullptr) throw std::runtime_error("lanes: a world of another engine");
    if (const std::string why = why_not(ours->config_); !why.empty()) throw std::runtime_error("lanes: " + why);
    lanes_.push_back(std::make_unique<Lane>(*this, count(), std::move(world), *ours));
    const WorldConfig &mine = ours->config_, &first = lanes_.front()->world_.config_;
    if (mine.step != first.step || mine.fixed_base != first.fixed_base || mine.loose.empty() != first.loose.empty())
      throw std::runtime_error("lanes: worlds differ in their step or base, or only some have loose bodies");
  }
  const WorldConfig& config = lanes_.front()->world_.config_;
  block_.h = config.step;
  block_.root.floating = !config.fixed_base;
  // What no world stands in is another one of the first.
  for (int k = 0; k < kWorldLanes; ++k) fill_lane(k, *models[k < count() ? at(k) : 0]);
}

LaneWorlds::~LaneWorlds() = default;

World& LaneWorlds::world(int lane) noexcept { return *lanes_[at(lane)]; }

// What never changes.
void LaneWorlds::fill_lane(int lane, const Model& model) {
  const auto k = at(lane);
  const ArticulatedWorld& world = lanes_[lane < count() ? k : 0]->world_;
  std::vector<int> parent{-1};
  for (const Joint& joint : model.joints) parent.push_back(joint.parent);
  BodyLanes<double> one;
  LinkNumbers numbers;
  one.ranks = side_by_side(parent, 1);
  fill(one, model, world.config_.mass_scale, numbers);
  BodyLanes<Vec4>& all = block_.body;
  const GroundContacts& ground = world.ground_;
  const std::size_t links = one.links.size();
  if (lane == 0) {
    all.ranks = one.ranks;
    rank_.resize(links);
    for (std::size_t r = 0; r < links; ++r) rank_[at(one.ranks[r].link[0])] = static_cast<int>(r);
    all.links.resize(links);
    std::fill_n(reinterpret_cast<double*>(all.links.data()), links * sizeof(LinkLanes<Vec4>) / sizeof(double), 0.0);
    all.folded.resize(one.folded.size());
    all.stiff.resize(links);
    for (auto* each : {&all.angle, &all.rate, &all.sine, &all.cosine, &all.force, &all.gain})
      each->assign(links * kWorldLanes, 0.0);
    block_.joints.assign(model.joints.size(), JointLanes{});
    block_.shells.assign(ground.shapes_.size(), ShellLanes{});
    for (int side = 0; side < 2; ++side) {
      const Sole& sole = model.soles[at(side)];
      if (sole.link < 0 || (sole.link == 0 && world.config_.fixed_base)) continue;
      for (int corner = 0; corner < kSoleCorners; ++corner) {
        CornerLanes& added = block_.corners.emplace_back();
        added.sole = side;
        added.corner = corner;
      }
    }
  }
  bool alike = all.ranks.size() == one.ranks.size() && block_.shells.size() == ground.shapes_.size();
  for (std::size_t r = 0; alike && r < links; ++r) {
    const Rank &a = all.ranks[r], &b = one.ranks[r];
    alike = b.link[0] == a.link[0] && b.parents == a.parents && b.slides == a.slides && b.turned == a.turned;
  }
  if (!alike) throw std::runtime_error("lanes: robots that are not alike in links and shapes");
  const double* from = reinterpret_cast<const double*>(one.links.data());
  constexpr std::size_t kNumbers = offsetof(LinkLanes<double>, acceleration) / sizeof(double);
  for (std::size_t r = 0; r < links; ++r) {
    for (std::size_t n = 0; n < kNumbers; ++n)
      *numbers_of(block_, r, n, k) = from[r * sizeof(LinkLanes<double>) / sizeof(double) + n];
  }
  for (std::size_t j = 0; j < block_.joints.size(); ++j) {
    const JointLaw& law = world.joints_[j];
    JointLanes& to = joint(j);
    to.lower[k] = law.lower_;
    to.upper[k] = law.upper_;
    to.limit[k] = law.limit_;
    to.damping[k] = law.damping_;
    to.friction[k] = law.friction_;
    to.backlash[k] = law.backlash_;
    to.stick[k] = law.stick_;
    to.stick_gain[k] = law.stick_gain_;
  }
  for (CornerLanes& corner : block_.corners) {
    const auto side = at(corner.sole);
    corner.link = model.soles[side].link;
    corner.rank = rank(corner.link);
    set(ground.corner_[side][at(corner.corner)], k, corner.local);
    set_params(ground.sole_params_[side], k, corner);
  }
  for (std::size_t s = 0; s < block_.shells.size(); ++s) {
    const auto& shape = ground.shapes_[s];
    ShellLanes& to = block_.shells[s];
    to.probes.resize(lane == 0 ? shape.bare : to.probes.size());
    if (to.probes.size() != shape.bare) throw std::runtime_error("lanes: robots that are not alike in shapes");
    to.rank = rank(shape.link);
    set(shape.center, k, to.center);
    to.radius[k] = shape.radius;
    to.extent[k] = shape.extent;
    for (std::size_t p = 0; p < shape.bare; ++p) {
      set(ground.probes_[shape.first + p].center, k, to.probes[p].center);
      to.probes[p].radius[k] = ground.probes_[shape.first + p].radius;
    }
  }
  block_.reach[k] = ground.reach_;
  if (world.loose_.count() > 0) {
    block_.extents.resize(links, Vec4{});
    for (std::size_t r = 0; r < links; ++r) block_.extents[r][k] = world.loose_.extent(one.ranks[r].link[0]);
  }
  if (lane < count()) return;
  // Nobody's: where the first world is set, it stands.
  for (int i = 0; i < 3; ++i) reinterpret_cast<Vec4*>(&block_.rotation)[4 * i][k] = 1.0;
}

// From its own world into the lanes.
void LaneWorlds::enter(Lane& lane) noexcept {
  const std::size_t k = lane.number();
  const ArticulatedWorld& world = lane.world_;
  const Configuration& now = world.configuration_;
  set(now.base.linear().col(0), k, block_.rotation.x);
  set(now.base.linear().col(1), k, block_.rotation.y);
  set(now.base.linear().col(2), k, block_.rotation.z);
  set(now.base.translation(), k, block_.origin);
  set(now.base_velocity, k, block_.velocity);
  set(now.base_angular_velocity, k, block_.spin);
  for (std::size_t j = 0; j < block_.joints.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    const std::size_t place = rank(static_cast<int>(j) + 1) * kWorldLanes + k;
    block_.body.angle[place] = now.q[index];
    block_.body.rate[place] = now.qd[index];
    joint(j).play[k] = world.joints_[j].play_;
    joint(j).torque[k] = world.joints_[j].tau_;
    set_target(world.joints_[j].target_, k, joint(j));
  }
  for (CornerLanes& corner : block_.corners) {
    const auto side = at(corner.sole), c = at(corner.corner);
    corner.height[k] = world.ground_.ground_height_[side] - world.ground_.offset_[side][c];
    corner.known[k] = 0.0;
    for (const auto& memory : world.ground_.memory_) {  // there are no other surfaces
      if (memory.key != key_of(corner)) continue;
      corner.known[k] = 1.0;
      corner.anchor_x[k] = memory.bristle.x();
      corner.anchor_y[k] = memory.bristle.y();
    }
    block_.deep[side][k] = 0.0;
    for (const auto& pair : world.deep_) {
      if (pair.who == std::array<int, 4>{0, corner.link, -1, -1}) block_.deep[side][k] = pair.depth;
    }
  }
  block_.fresh[k] = world.placed_ ? 1.0 : 0.0;
  lane.inside_ = true;
  placed_ = false;
}

// From the lanes into its own world.
void LaneWorlds::leave(const Lane& lane) noexcept {
  place();
  const std::size_t k = lane.number();
  ArticulatedWorld& world = lane.world_;
  Configuration& now = world.configuration_;
  now.base.linear() << vector_of(block_.rotation.x, k), vector_of(block_.rotation.y, k), vector_of(block_.rotation.z, k);
  now.base.translation() = vector_of(block_.origin, k);
  now.base_velocity = vector_of(block_.velocity, k);
  now.base_angular_velocity = vector_of(block_.spin, k);
  for (std::size_t j = 0; j < block_.joints.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    const std::size_t place = rank(static_cast<int>(j) + 1) * kWorldLanes + k;
    now.q[index] = block_.body.angle[place];
    now.qd[index] = block_.body.rate[place];
    world.joints_[j].play_ = joint(j).play[k];
    world.joints_[j].tau_ = joint(j).torque[k];
  }
  world.ground_.memory_.clear();
  std::erase_if(world.deep_, [](const auto& pair) { return pair.who[0] == 0; });
  for (const CornerLanes& corner : block_.corners) {
    if (corner.known[k] > 0.0) {
      const Eigen::Vector3d anchor(corner.anchor_x[k], corner.anchor_y[k], 0.0), none = Eigen::Vector3d::Zero();
      world.ground_.memory_.push_back({key_of(corner), anchor, none, none});
    }
    const double deep = block_.deep[at(corner.sole)][k];
    if (corner.corner == 0 && deep > 0.0) world.deep_.push_back({{0, corner.link, -1, -1}, deep});
  }
  world.placed_ = block_.fresh[k] > 0.0;
  show_body(lane);
  show_contacts(lane);
}

// Where its links are and how fast, and its momentum.
void LaneWorlds::show_body(const Lane& lane) noexcept {
  const std::size_t k = lane.number();
  ArticulatedBody& body = lane.world_.body_;
  constexpr std::size_t kFirst = TWINBUS_LANE_FIELD(rotation), kEnd = TWINBUS_LANE_FIELD(axis);
  for (int i = 0; i < body.link_count(); ++i) {
    const double* from = numbers_of(block_, rank(i), kFirst, k);
    double* to = body.links_.of(i, kFirst);
    for (std::size_t n = 0; n < kEnd - kFirst; ++n) to[n * body.links_.stride] = from[n * kWorldLanes];
  }
  body.state_.origin = lane.world_.configuration_.base.translation();
  const auto show = [&](auto& to) {
    constexpr std::size_t kLanes = sizeof(to.moment.x) / sizeof(double);
    const auto show_three = [&](const Three<Vec4>& from, auto& three) {
      double* lanes = reinterpret_cast<double*>(&three);
      std::fill_n(lanes, 3 * kLanes, 0.0);
      for (std::size_t n = 0; n < 3; ++n) lanes[n * kLanes] = reinterpret_cast<const double*>(&from)[n * kWorldLanes + k];
    };
    show_three(block_.body.momentum.w, to.momentum.w);
    show_three(block_.body.momentum.v, to.momentum.v);
    show_three(block_.body.moment, to.moment);
  };
  body.wide_ ? show(body.four_) : show(body.one_);
  lane.viewed_ = true;
}

// As its last step found them.
void LaneWorlds::show_contacts(const Lane& lane) noexcept {
  const std::size_t k = lane.number();
  ArticulatedWorld& world = lane.world_;
  std::vector<Contact>& contacts = world.contacts_;
  for (const CornerLanes& from : block_.corners) {
    Contact& c = contacts.emplace_back();
    c.link = from.link;
    c.sole = from.sole;
    c.key = key_of(from);
    c.material = true;
    c.params = world.ground_.sole_params_[at(from.sole)];
    c.r = vector_of(from.r, k);
    c.point = c.r + Eigen::Vector3d(block_.before.x[k], block_.before.y[k], block_.before.z[k]);
    c.normal = Eigen::Vector3d::UnitZ();
    c.depth = from.depth[k];
    c.stretch = {from.stretch_x[k], from.stretch_y[k], 0.0};
    c.v0 = vector_of(from.v0, k);
    c.v = vector_of(from.v, k);
    c.now.force = vector_of(from.force, k);
    c.now.mode = from.open[k] > 0.0 ? ContactMode::kOpen : from.slip[k] > 0.0 ? ContactMode::kSlip : ContactMode::kStick;
  }
  // They come first.
  std::rotate(contacts.begin(), contacts.end() - static_cast<std::ptrdiff_t>(block_.corners.size()), contacts.end());
  world.last_h_ = block_.h;
  world.report_contacts();
}

void LaneWorlds::push(const Lane& lane) noexcept {
  const std::size_t k = lane.number();
  for (const auto& push : lane.world_.pushes_) {
    const Eigen::Vector3d torque = (push.point - vector_of(block_.origin, k)).cross(push.force);
    for (std::size_t i = 0; i < 3; ++i) {
      *numbers_of(block_, rank(push.link), TWINBUS_LANE_FIELD(bias) + i, k) -= torque[static_cast<Eigen::Index>(i)];
      *numbers_of(block_, rank(push.link), TWINBUS_LANE_FIELD(bias) + 3 + i, k) -= push.force[static_cast<Eigen::Index>(i)];
    }
  }
}

void LaneWorlds::place() noexcept {
  if (!placed_) place_lanes(block_);
  placed_ = true;
}

void LaneWorlds::step(int asked, std::array<Status, kWorldLanes>& status) noexcept {
  int ready = 0;
  for (const auto& lane : lanes_) {
    if ((asked >> lane->number() & 1) == 0) continue;
    ++steps_;
    if (lane->world_.frozen_) continue;
    if (!lane->inside_) enter(*lane);
    ready |= 1 << lane->number();
  }
  for (const auto& lane : lanes_) {  // of those that wait, what their last step found is lost in this one
    if ((asked >> lane->number() & 1) == 0) (void)lane->shown();
  }
  place();
  if (!block_.extents.empty()) bound_lanes(block_);
  for (const auto& lane : lanes_) {
    const std::size_t k = lane->number();
    if ((ready >> k & 1) == 0) continue;
    const Eigen::AlignedBox3d robot(vector_of(block_.low, k), vector_of(block_.high, k));
    if (lane->begin_loose(robot)) push(*lane);
    else ready &= ~(1 << k);
  }
  const int taken = step_lanes(block_, ready);
  placed_ = false;
  for (const auto& lane : lanes_) {
    const std::size_t k = lane->number();
    if ((asked >> k & 1) == 0) continue;
    if ((taken >> k & 1) != 0) {
      status[k] = Status::kOk;
      lane->stepped(block_.doubt_depth[k]);
      ++in_lanes_;
    } else {
      if ((ready >> k & 1) != 0) lane->world_.loose_.restore();
      lane->shown_ = !lane->inside_;  // its contacts are gone
      status[k] = lane->step_outside();
    }
  }
}

}  // namespace twinbus::sim
