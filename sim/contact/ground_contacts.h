// Which points of the robot may touch the ground or an obstacle within the next step.
//
// The corners of a sole carry the sole's declared spring and damper, against the ground and against
// obstacles.  Every other shape is a handful of probes, small spheres or bare points: corners,
// edges and faces of a box, the spine of a cylinder, the corners of a mesh's hull.  They exist so
// that a fallen robot lies on the ground and a hand does not pass through a table; an edge of an
// obstacle that enters a shape between its probes is not seen.
//
// With contact patch a link that is no foot has its area instead of probes (sim/contact/link_patches.h).
//
// Tiles of uneven ground meet the soles, and of a robot without soles every probe: its feet are points.
//
// The bristles of friction are remembered here from step to step: the anchor of a point that is
// fixed in its link, the stretch of one that rolls along it.

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/contact/contact_solve.h"
#include "sim/contact/link_patches.h"
#include "sim/contact/sole_patches.h"
#include "sim/world/solid.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

inline constexpr int kMostContacts = 128;

// Sideways rubber is taken as so much stiffer than the one spring that a model gives for a sole,
// damped half critically for this mass at each point.  The other engine's soles do not yield
// sideways at all.
ContactParams rubber(double stiffness, double damping, double friction);

// Of a point of a link, as much damped at any stiffness.
ContactParams shell(double stiffness, double friction);

// Whether its dampers grow with the depth.
inline bool damps_by_depth(ContactModel contact) noexcept {
  return contact == ContactModel::kHuntCrossley || contact == ContactModel::kPatch;
}

// Damped as the world's contact model asks.
ContactParams as_asked(const WorldConfig& config, const ContactParams& params);

// Must have a shape.
Solid solid_of(const Obstacle& obstacle) noexcept;

// Springs and dampers so many times as strong.
ContactParams times(const ContactParams& params, double share) noexcept;

// Of a point from a tile of uneven ground: all that is below its top is in it, and pushed out
// upwards.
Distance under_tile(const Obstacle& tile, const Eigen::Vector3d& point) noexcept;

class GroundContacts {
 public:
  GroundContacts(const Model& model, const WorldConfig& config);

  // Contacts of the body as placed: those that touch, and those that could within the next h [s].
  // h zero: only those that touch.  Always in the same order.  contacts must have kMostContacts
  // reserved; more are left out.
  void find(const ArticulatedBody& body, double h, std::vector<Contact>& contacts) const noexcept;
  // After the solve of a step h: what the bristles of the robot's, which is that system of the
  // solve, are like at its end.
  void remember(const std::vector<Contact>& contacts, int system, double h) noexcept;
  void forget() noexcept { memory_.clear(); }
  // The bristles as they are, for a step that is taken again.
  void save() noexcept { saved_ = memory_; }
  void restore() noexcept { memory_ = saved_; }

  // By link, what is nearer to the ground or an obstacle than what is there already: of what is no sole [m].
  void clearance(const World& world, std::vector<double>& nearest) const;

  void set_corner_offset(int sole, int corner, double offset) noexcept;
  double corner_offset(int sole, int corner) const noexcept;
  int sole_link(int sole) const noexcept { return soles_[static_cast<std::size_t>(sole)].link; }
  const ContactParams& sole_params(int sole) const noexcept {
    return sole_params_[static_cast<std::size_t>(sole)];
  }

 private:
  friend class LaneWorlds;
  struct LinkProbe {
    Eigen::Vector3d center;  // link frame
    double radius;
    bool skin;  // so near the sole that the ground is its corners' business
  };
  struct ShapeProbes {
    int link;
    Eigen::Vector3d center;  // of the bounding sphere, link frame
    double radius;
    std::size_t first, count;
    std::size_t bare;  // of them: those that are no skin, which come first
    double extent;     // no probe is further from the link's origin [m]
    int area;          // of link_patches_; -1: its probes touch
  };
  // Of a point that touches, or may soon.
  struct Found {
    int link, sole;
    int key = 0;
    bool material = false;
    const ContactParams* params;
    Eigen::Vector3d r = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    double depth = 0.0;
    double stored = 0.0;  // energy that its spring does not show [J]
    bool foreseen = false;  // its law is taken about the speed that the last step foretells
  };
  struct Memory {
    int key;
    Eigen::Vector3d bristle;  // anchor, or stretch of a point that rolls
    Eigen::Vector3d turned;   // as Contact::turned
    Eigen::Vector3d gain;     // as Contact::gain
  };

  void add_probes(int link, int number, const Shape& shape, const Model& model);
  Distance distance(std::size_t surface, const Eigen::Vector3d& point) const noexcept;
  // The tile in which that point, so far from the ground, is deeper, and how far from it then; 0: it is deepest in the ground.
  std::size_t deepest_tile(const Eigen::Vector3d& point, Distance& d) const noexcept;
  void find_corners(const ArticulatedBody& body, double h,
                    std::vector<Contact>& contacts) const noexcept;
  void find_patches(const ArticulatedBody& body, double h, std::size_t& cursor,
                    std::vector<Contact>& contacts) const noexcept;
  void find_probes(const ArticulatedBody& body, double h,
                   std::vector<Contact>& contacts) const noexcept;
  void press(const ArticulatedBody& body, const LinkNow& link, const ShapeProbes& shape, std::size_t surface, double h,
             std::size_t& cursor, std::vector<Contact>& contacts) const noexcept;
  // velocity: of the link that is found to touch.
  void add(const ArticulatedBody& body, const Screw& velocity, const Found& found, double h,
           std::size_t& cursor, std::vector<Contact>& contacts) const noexcept;

  bool fixed_base_;
  std::array<Sole, 2> soles_;
  std::array<std::array<Eigen::Vector3d, kSoleCorners>, 2> corner_;  // link frame
  std::array<ContactParams, 2> sole_params_;
  ContactParams shell_params_;
  std::optional<SolePatches> patches_;  // of contact patch
  std::optional<LinkPatches> link_patches_;  // the same, but of robots on points on uneven ground
  int sole_keys_ = 0;                   // of its surfaces
  std::array<double, 2> ground_height_;
  std::array<std::array<double, kSoleCorners>, 2> offset_{};
  std::vector<Obstacle> obstacles_;  // the solid ones, then the tiles of uneven ground
  std::size_t solid_ = 0;            // so many
  std::vector<double> obstacle_radius_;
  bool tiled_ = false;               // probes meet tiles too
  double rise_ = 0.0;                // no tile that they meet is higher [m]
  std::vector<LinkProbe> probes_;
  std::vector<ShapeProbes> shapes_;
  std::vector<Memory> memory_;  // in the order of find()
  std::vector<Memory> saved_;
  double reach_ = 0.0;  // no shape is further from link 0's origin [m]
};

}  // namespace twinbus::sim
