// Which points of loose bodies may touch the ground, an obstacle, a robot or one another within
// the next step, which of one robot another robot and, if asked for, which links of a robot one
// another.  Neighbours and the SRDF's disabled pairs never do.
//
// Every shape is a piece: probes (sim/world/solid.h) that enter the other pieces, and a solid that their
// probes enter.  A sole has its corners for probes and no solid.  Springs and dampers of two pieces
// act in series, friction is the geometric mean.  Two boxes that overlap while no corner is about as deep
// in the other, as where edges cross, meet where they overlap (sim/objects/box_overlap.h).  A body of triangles meets
// the triangles of all else (sim/objects/rigid_object_mesh.h).  With contact patch what is convex presses
// with an area (geometry/mesh_contact/patch.h), and everything loose so presses ground and tiles; pairs with another keep the manifold's points.

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "common/math/key_index.h"
#include "geometry/mesh_contact/manifold.h"
#include "geometry/mesh_contact/patch.h"
#include "sim/objects/box_overlap.h"
#include "sim/contact/contact_solve.h"
#include "sim/objects/entry_faces.h"
#include "sim/world/link_pairs.h"
#include "sim/world/solid.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// Springs and dampers in series.
ContactParams together(const ContactParams& a, const ContactParams& b);

class LooseContacts {
 public:
  // Systems: the robot's is 0, that of loose body i is i + 1, the further robots come after them.
  LooseContacts(const Model& model, const WorldConfig& config);

  bool active() const noexcept { return loose_ > 0 || robots_meet_; }
  bool robots_meet() const noexcept { return robots_meet_; }  // one another or themselves

  // Appends contacts as far as their capacity goes, always in the same order.  away: after away_from(), of the loose bodies alone.
  // Wakes what is asleep and touched.
  void find(const std::vector<ArticulatedBody*>& systems, double h, std::vector<Contact>& contacts, bool away = false) noexcept;
  // Whether no loose body comes near that box, or the robot, in the next h [s].
  bool away_from(const Eigen::AlignedBox3d& box, const std::vector<ArticulatedBody*>& systems, double h) noexcept;
  bool away_from_robot(const std::vector<ArticulatedBody*>& systems, double h) noexcept;
  double extent(int link) const noexcept;  // nothing of that link of the robot is further from its origin [m]
  // After the solve of a step h, the systems still as they were at its start.
  void remember(const std::vector<ArticulatedBody*>& systems, const std::vector<Contact>& contacts,
                double h) noexcept;
  void forget() noexcept;  // wakes everything too
  // So deep that the middle of one has nearly passed that of the other, which turns the normal round.
  bool may_come_through(const Contact& contact, double depth) const noexcept;
  // The bristles as they are, for a step that is taken again.
  void save() noexcept {
    saved_ = memory_;
    faces_.save();
  }
  void restore() noexcept {
    memory_ = saved_;
    index_memory();
    faces_.restore();
  }

  bool asleep(int system) const noexcept { return sleepers_ && system >= 0 && heap_[at(system)] > 0; }
  void sleep_on() noexcept { std::fill(woke_.begin(), woke_.end(), 0); }  // what woke in a step is awake like others
  bool woke(int system) const noexcept { return system >= 0 && woke_[at(system)] != 0; }  // in the last step
  // heap: by system, 0 for what stays awake.  Those with one number wake together.  After remember(), the bodies placed and at rest.
  void fall_asleep(const std::vector<int>& heap, const std::vector<ArticulatedBody*>& systems,
                   const std::vector<Contact>& contacts, double h) noexcept;
  double asleep_energy() const noexcept;  // of the springs that hold what is asleep [J]
  // Loose contacts have keys from here on.
  static constexpr int kFirstKey = 1 << 24;
  // Those of points of triangles, so many for each pair of pieces.
  static constexpr int kFirstMeshKey = 1 << 26;
  static constexpr int kMeshKeysPerPair = 1 << 12;

 private:
  struct Piece {
    int system = -1;  // -1: fixed
    int link = 0;
    int sole = -1;
    bool solid_too = true;  // not only probes
    bool tile = false;      // only its top counts
    bool of_foot = false;   // its sole's corners touch for it
    Solid solid;
    std::shared_ptr<const ContactMesh> mesh;  // of a body of triangles, and of all that it may meet
    bool only_mesh = false;
    Eigen::Isometry3d in_link = Eigen::Isometry3d::Identity();
    ContactParams params;
    double per_area = 1.0;  // of contact patch: times the springs of a point [1/m^2]
    Eigen::Vector3d box_middle =
        Eigen::Vector3d::Zero();  // of it too: of a mesh that is a box, its own axes
    bool ball = false, hull = false;  // and of a loose one; of triangles, that nothing lies beyond one of them
    Eigen::Vector3d box_half = Eigen::Vector3d::Zero();  // zero: it is none
    std::vector<Probe> probes;  // in the solid's axes
    int first_key = 0;          // of its probes
    double radius = 0.0;        // about its middle [m]
    double thickness = 0.0;     // the least [m]; infinite: pushed out one way however deep
    // As placed.
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  // world
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // of its middle [m/s]
    double turning = 0.0;                              // nothing of it moves faster about its middle [m/s]
    double speed = 0.0;                                // nothing of it is faster [m/s]
  };
  struct Memory {
    int key;
    Eigen::Vector3d bristle;  // in B's axes: anchor, or stretch of a point that rolls
    Eigen::Vector3d force, turned;  // world; in B's axes, as Contact::turned
  };
  // Of a contact of what is asleep.
  struct Slept {
    Memory memory;
    int system;
    double energy;  // [J]
  };
  // Along x, with what it may move in a step.
  struct Span {
    double from, to;
    int piece;
  };
  // The pieces of a robot, and a box that none of them leaves in a step.
  struct Outline {
    int system = 0;
    std::size_t first = 0, end = 0;
    Eigen::AlignedBox3d box;
    bool fixed = false;        // nothing of it ever moves
    bool placed = false;       // then: where it is now
    Eigen::AlignedBox3d bare;  // and a box about it there
  };
  struct Search {
    const std::vector<ArticulatedBody*>& systems;
    double h;
    std::vector<Contact>& contacts;
    std::size_t cursor = 0;
  };

  void add_robot(const Model& model, const WorldConfig& config, int system, bool fixed_base);
  // Of a link of triangles.
  void add_hull(const Shape& shape, const Model& model, const ContactParams& params, Piece piece);
  bool may_meet(std::size_t a, std::size_t b) const noexcept;
  void find_once(Search& search, bool away) noexcept;
  bool lies(const Piece& piece) const noexcept { return piece.system < 0 || asleep(piece.system); }
  // Of the contacts from `first` on; false: nothing woke, and those with what is asleep are gone.
  bool wake_touched(std::size_t first, Search& search) noexcept;
  void wake(int heap) noexcept;
  void add(Piece piece);
  void sort_spans(double h) noexcept;
  // Which robots have nothing near them.
  void find_alone(double h) noexcept;
  template <class Reach>
  Eigen::AlignedBox3d box_of(const Outline& robot, const Reach& reach) const noexcept;
  void place_all(const std::vector<ArticulatedBody*>& systems) noexcept;
  void place(std::size_t first, std::size_t end, const std::vector<ArticulatedBody*>& systems) noexcept;  // of pieces_
  bool near(const Piece& a, const Piece& b, double h) const noexcept;
  void meet_ground(const Piece& piece, Search& search) noexcept;
  void meet_cylinder(const Piece& piece, Search& search) noexcept;
  // Probes of one in the solid of the other; turned: the probes are those of something fixed.
  void meet(const Piece& probes, std::size_t solid, bool turned, Search& search) noexcept;
  // In sim/objects/rigid_object_mesh.cpp.
  void give_meshes();
  // other: -1: the ground.
  void meet_mesh(std::size_t own, int other, Search& search) noexcept;
  // In sim/objects/rigid_object_patch.cpp.
  void give_sole_mesh(const Sole& sole, Piece& piece) const;
  void give_foot_mesh(const Model& model, Piece& piece) const;
  // False: of such a pair the points of the manifold are taken.
  bool meet_patch(std::size_t own, int other, Search& search) noexcept;
  // ahead: at the end of the step, as far as speeds say.
  bool presses(std::size_t own, int other, const Search& search, bool ahead, Patch& patch) noexcept;
  bool ball_presses(std::size_t own, int other, const Search& search, bool ahead,
                    Patch& patch) const noexcept;
  void press(const Patch& patch, std::size_t own, int other, bool ahead, bool round, Search& search) noexcept;
  // The least depth of two boxes, or how deep a sole is in the top of one.
  bool box_constraint(const Piece& a, const Piece& b, const Search& search, bool ahead,
                      Eigen::Vector3d& normal, double& depth) const noexcept;
  static Eigen::Vector3d up_from(const Piece& box, const Eigen::Vector3d& up) noexcept;
  Eigen::Isometry3d pose_at(const Piece& piece, const Search& search, bool ahead) const noexcept;
  void meet_probes(std::size_t own, std::size_t other, Search& search) noexcept;
  // Contacts of a pair of boxes from `before` on that will be deeper than the boxes overlap then [m].
  static void drop_false(std::size_t before, double overlap, Search& search) noexcept;
  static bool is_box(const Piece& piece) noexcept;  // and its corners meet others
  // end_a: where the first is at the end of the step.
  void meet_boxes(std::size_t own, std::size_t other, const Eigen::Isometry3d& end_a,
                  const BoxOverlap& overlap, Search& search) noexcept;
  Eigen::Isometry3d end_of(const Piece& piece, const Search& search) const noexcept;
  // Of a box, the face that bare points are nearest to being out of; -1: ask point by point.
  int face_between(const Piece& points, const Piece& box) const noexcept;
  void index_memory() noexcept;
  bool consider(Contact& found, Search& search) noexcept;  // true: it was added

  std::vector<Piece> pieces_;  // the loose bodies, the robot's, the fixed ones
  std::vector<Span> spans_;    // of all pieces, by where they begin
  std::vector<Span> near_;     // of these, but for robots that are alone
  std::size_t loose_ = 0, moving_ = 0;
  std::vector<Outline> robots_;
  std::vector<char> alone_;  // by system
  bool robots_meet_ = false, self_contact_ = false;
  bool patches_ = false;          // contact patch
  bool continuous_ = false;       // pushed out by the face of entry
  EntryFaces faces_;
  std::vector<LinkPairs> apart_;  // by system
  ContactParams ground_;
  ManifoldFinder finder_;
  Manifold manifold_;
  PatchFinder patch_finder_;
  int next_key_ = 0;
  double thinnest_ = std::numeric_limits<double>::infinity();  // of two pieces together [m]
  std::vector<int> heap_;               // by system: what it sleeps with, 0: awake
  std::vector<Slept> slept_;
  bool sleepers_ = false, placed_ = false;  // placed_: by away_from(), for the search that follows
  std::vector<char> woke_;  // by system
  std::vector<Memory> memory_, saved_;  // in the order of find()
  KeyIndex remembered_;                 // of memory_, by key
};

}  // namespace twinbus::sim
