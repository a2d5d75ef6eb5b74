#include "sim/contact/soft_contact.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline sim {

namespace {

constexpr double kTimeConstant = 0.02;  // [s]
constexpr double kFirst = 0.9, kLast = 0.95, kWidth = 1e-3;  // of the impedance, and over which depth [m]
constexpr double kReweigh = 1.25;  // once an armature has changed by this factor
constexpr double kDeepest = 1.0;   // [m]

// A quadratic curve in two halves.
double impedance(double depth) noexcept {
  const double x = std::clamp(depth / kWidth, 0.0, 1.0);
  const double y = x < 0.5 ? 2.0 * x * x : 1.0 - 2.0 * (1.0 - x) * (1.0 - x);
  return kFirst + y * (kLast - kFirst);
}

}  // namespace

SoftContact::SoftContact(const Model& model, const WorldConfig& config)
    : body_(model, config.fixed_base, config.mass_scale),
      rows_(model.joints.size()),
      weighed_(model.joints.size(), 0.0),
      inverse_masses_(model.links.size(), 1.0),
      step_(config.step),
      time_constant_(std::max(kTimeConstant, 2.0 * config.step)) {
  Configuration zero(model);
  body_.place(zero);
  for (int i = 0; i < model.link_count(); ++i) {
    const LinkNow link = body_.link(i);
    coms_.push_back(link.origin + link.rotation * model.links[at(i)].com);
  }
  for (const Joint& joint : model.joints) rotors_.push_back(joint.rotor_inertia);
  weigh_links();
}

void SoftContact::weigh(const std::vector<JointLaw>& joints) noexcept {
  bool changed = false;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    // The spring too, where it is too stiff to be that of the start of a step.
    const double damping = joints[j].damping(), spring = step_ * joints[j].stiffness();
    rows_[j].gain = damping + (step_ * spring > rotors_[j] + step_ * damping ? spring : 0.0);
    const double now = rotors_[j] + step_ * rows_[j].gain, then = rotors_[j] + step_ * weighed_[j];
    changed = changed || now > kReweigh * then || kReweigh * now < then;
  }
  if (!changed) return;
  for (std::size_t j = 0; j < joints.size(); ++j) weighed_[j] = rows_[j].gain;
  weigh_links();
}

void SoftContact::weigh_links() noexcept {
  const int first = body_.floating() ? 0 : 1;
  for (int link = first; link < body_.link_count(); ++link) {
    if (!body_.inward(rows_, step_)) return;
    body_.outward();
    const Eigen::Vector3d& r = coms_[at(link)];
    const Eigen::Vector3d free = at_point(body_.acceleration(link), r);
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d force = Eigen::Vector3d::Unit(axis), torque = r.cross(force);
      if (!body_.inward(rows_, step_)) return;
      body_.add_wrench(link, Screw{Vec4{torque.x(), torque.y(), torque.z(), 0.0}, Vec4{force.x(), force.y(), force.z(), 0.0}});
      body_.outward();
      sum += (at_point(body_.acceleration(link), r) - free)[axis];
    }
    if (sum > 0.0) inverse_masses_[at(link)] = sum / 3.0;
  }
}

void SoftContact::resume(const SoftContact& other) noexcept {
  weighed_ = other.weighed_;
  inverse_masses_ = other.inverse_masses_;
}

SoftContact::Law SoftContact::law(int link, double friction, double depth) const noexcept {
  const double i = impedance(depth), time = kLast * time_constant_;
  Law made;
  made.rate = 2.0 / time;
  made.reference = i * depth / (time * time);
  made.tangent = (1.0 - i) / i * inverse_masses_[at(link)] * (1.0 + friction * friction);
  made.normal = 0.5 * friction * friction * made.tangent;
  if (!(friction > 0.0)) made.normal = made.tangent;  // no pyramid
  return made;
}

// R f in terms of what contact_force() knows: a spring 1 / (h h R), without a damper.
void SoftContact::give(double h, std::vector<Contact>& contacts) const noexcept {
  const auto fixed = [](const Contact& c) { return c.system == 0 && c.other_system < 0 && c.tie == TieKind::kNone; };
  const auto open = [&](const Contact& c) { return fixed(c) && !(c.depth > 0.0); };
  contacts.erase(std::remove_if(contacts.begin(), contacts.end(), open), contacts.end());
  for (Contact& c : contacts) {
    if (!fixed(c)) continue;
    const Law of = law(c.link, c.params.friction, c.depth);
    const double vn = c.normal.dot(c.v0), kept = 1.0 - h * of.rate;
    c.soft = true;
    c.lead = h * (h * of.reference + kept * vn) - c.depth;
    c.stretch = -h * kept * (c.v0 - vn * c.normal);
    c.params.stiffness = 1.0 / (h * h * of.normal);
    c.params.tangent_stiffness = 1.0 / (h * h * of.tangent);
    c.params.damping = c.params.tangent_damping = 0.0;
  }
}

double SoftContact::depth_under(int link, double friction, double force) const noexcept {
  double low = 0.0, high = kDeepest;
  for (int i = 0; i < 60; ++i) {
    const double depth = 0.5 * (low + high);
    const Law of = law(link, friction, depth);
    (of.reference < of.normal * force ? low : high) = depth;
  }
  return high;
}

double SoftContact::stiffness(int link, double friction, double force) const noexcept {
  return force / depth_under(link, friction, force);
}

double SoftContact::damping(int link, double friction, double force) const noexcept {
  const Law of = law(link, friction, depth_under(link, friction, force));
  return of.rate / of.normal;
}

}  // namespace twinbus::sim
