// Contacts of articulated bodies with the fixed world and with one another, solved at the end of
// the step.  A robot is such a body, a loose box is one of a single link.
//
// Stage 1, fold(): the law's tangent at the present velocity, or the foreseen one, becomes inertia of the touched links,
// so that one articulated-body pass solves a contact that keeps its mode.  Contacts between two
// bodies are left to stage 2.  Stage 2, solve(): where the law at the result disagrees, Newton on
// the wrenches z of the touched links of one island (bodies that touch one another),
//
//     rho(z) = z - sum J' [ f(v) - (f0 - G0 (v - v0)) ],   v = v0 + h J (a1 + B z)
//     (1 + H B) dz = -rho,                                  H = h sum J' (G - G0) J
//
// with J = [J_A, -J_B] where the other side moves too, B = Y' Y the inverse inertia of the touched
// links (never inverted), the exact unsymmetric tangent, and a line search on rho' B rho that also
// tries the kinks of the law.  Where that does not settle, the law is rounded off and sharpened in
// stages.  The forces applied are values of the law at the last velocity: inside the Coulomb cone
// whether the iteration has settled or not.

#pragma once

#include <vector>

#include "common/simd/block_solve.h"
#include "sim/articulated/aba.h"
#include "sim/contact/band_solve.h"
#include "sim/contact/contact_law.h"

namespace twinbus::inline sim {

enum class TieKind { kNone, kPoint, kLength };  // kLength: only along the normal

// One point of a link, A, against something fixed or a link B.
struct Contact {
  Contact() noexcept {}  // said, or all of it would be filled with zeros before this

  int system = 0;         // body of A; 0 is the robot
  int link = -1;          // of it
  int other_system = -1;  // body of B; -1: fixed
  int other = -1;         // link of it
  int sole = -1;
  int key = -1;                  // says which contact of the next step is the same one
  TieKind tie = TieKind::kNone;  // sim/contact/ties.h
  bool material = false;         // the point is fixed in the link: its anchor is remembered
  ContactParams params;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // world [m]
  Eigen::Vector3d r = Eigen::Vector3d::Zero();        // about A's common point, world axes [m]
  Eigen::Vector3d other_r = Eigen::Vector3d::Zero();  // about B's
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   // from B to A, world, unit
  double depth = 0.0;                                 // [m]; below zero: not yet touching
  double stored = 0.0;  // of the springs, beyond what the depth says [J]
  double lead = 0.0;    // what the law adds to the depth [m]
  bool soft = false;    // sim/contact/soft_contact.h
  Eigen::Vector3d stretch = Eigen::Vector3d::Zero();  // of the bristle, world [m]
  Eigen::Vector3d v0 = Eigen::Vector3d::Zero();       // of A against B at the start [m/s]
  Eigen::Vector3d guess = Eigen::Vector3d::Zero();    // of the force, if B moves [N]
  bool foreseen = false;  // `gain` is that of the step before: about it a law that bends is taken for a line
  Eigen::Vector3d gain = Eigen::Vector3d::Zero();     // of v in a second [m/s^2]
  // Of the solve.
  int slot = -1, other_slot = -1, coupling = -1;
  Eigen::Vector3d f0 = Eigen::Vector3d::Zero();  // force and tangent folded in by stage 1
  Eigen::Matrix3d g0 = Eigen::Matrix3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  // of A against B at the end [m/s]
  ContactForce now;                             // on A
  // Of a contact with rolling or torsional friction.
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();  // its bristle at the start, world [rad]
  Eigen::Vector3d w0 = Eigen::Vector3d::Zero(), w = Eigen::Vector3d::Zero();  // of A against B at the start and at the end [rad/s]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  // on A [N m]; of no meaning while it is open
};

// Whether it resists to being turned: its law at c.w is then turning_of(), that at the end of the step in c.moment.
inline bool turns(const Contact& c) noexcept {
  return turns(c.params) && c.tie == TieKind::kNone && c.now.mode != ContactMode::kOpen;
}
TurningMoment turning_of(const Contact& c, double h) noexcept;
inline Eigen::Vector3d moment_of(const Contact& c) noexcept {
  return turns(c) ? c.moment : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

// Its law at c.v into c.now.
void find_force(Contact& c, double h, bool with_tangent, double smooth) noexcept;

struct SolveCounters {
  long steps = 0;        // islands solved
  long one_pass = 0;     // of them, done by stage 1
  long newton = 0;       // iterations
  long rounded = 0;      // solves that needed the rounded law
  long unconverged = 0;  // solves that did not settle, those that were taken again too; given up in a hurry, none
};

class ContactSolve {
 public:
  static constexpr double kAlmost = 1e-7;  // of 10 N + all forces: what is left for rounding

  // The bodies must outlive this.
  ContactSolve(std::vector<ArticulatedBody*> systems, int most_contacts);

  // Before inward().
  void fold(std::vector<Contact>& contacts, double h) noexcept;
  // After inward() and outward(), which are to follow again if true: the law bends with the speed, nothing came to touch, slip or let
  // go, and what is folded in is that of the speeds found.  Cheaper than solve(), which alone is right where this says false.
  bool refold(std::vector<Contact>& contacts, double h) noexcept;
  // After inward() and outward(); applies what is missing and runs outward() again if need be.
  void solve(std::vector<Contact>& contacts, double h) noexcept;
  // From now on a solve is given up, its contacts not settled, where what did not touch the fixed world comes to touch it,
  // or Newton's first attempt fails: for a step that is taken again in parts anyway.
  void hurry(bool yes) noexcept { hurries_ = yes; }
  bool gave_up() const noexcept { return gave_up_; }  // the last one

  const SolveCounters& counters() const noexcept { return counters_; }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Contacts = std::vector<Contact>;
  struct Slot {  // a touched link
    int system, link;
    int peer;     // next slot of the same branch of its body, in a ring
    bool curved;  // a row of H is not zero
    int row;      // of such, in the matrix of direction(); -1
    int rows;     // of the response
    int place;    // in its ring
    int blocks;   // of its row in blocks_
  };
  struct Coupling {  // H between two slots that touch
    int a, b;
    bool curved;
    Eigen::Vector3d apart;  // from B's common point to A's
    Matrix6 aa, ab, ba;
  };

  void make_islands(const Contacts& contacts) noexcept;
  int root_of(int system) noexcept;
  void solve_island(Contacts& contacts, double h) noexcept;
  bool stage_one_holds(Contacts& contacts, double h) const noexcept;
  bool come_to_touch(const Contacts& contacts) const noexcept;
  void find_slots(Contacts& contacts) noexcept;
  void find_sequence() noexcept;
  int walk(int from) noexcept;
  int slot_of(int system, int link) noexcept;
  int coupling_of(int a, int b) noexcept;
  void build_response() noexcept;
  void guess(const Contacts& contacts) noexcept;
  void apply() noexcept;
  void respond(const Eigen::VectorXd& wrench, Eigen::VectorXd& acceleration) const noexcept;
  const Matrix6& block(int s, int t) const noexcept {
    return blocks_[at(slots_[at(s)].blocks + slots_[at(t)].place)];
  }
  // rho at z; with_tangent also the tangents of the law.  Returns the merit rho' B rho.
  double evaluate(Contacts& contacts, double h, const Eigen::VectorXd& z,
                  bool with_tangent) noexcept;
  void resist_turning(Contact& c, double h) noexcept;
  void add_tangents(const Contacts& contacts, double h) noexcept;
  void add_row(int s, int t, const Matrix6& h) noexcept;
  template <class Touch>
  void each_touched(const Touch& touch) const noexcept;
  int reach_of_matrix() const noexcept;
  bool begin_pile(int rows) noexcept;
  bool solve_rows(int m) noexcept;
  double misfit() noexcept;
  void direction(const Contacts& contacts, double h) noexcept;
  bool newton(Contacts& contacts, double h, int limit, double loose, double& merit) noexcept;
  double line_search(Contacts& contacts, double h, double merit, double whole) noexcept;
  double slope_search(Contacts& contacts, double h, double downhill) noexcept;
  double merit_at(Contacts& contacts, double h, double t, bool with_tangent) noexcept;
  void find_kinks(const Contacts& contacts, double h) noexcept;
  Eigen::Vector3d velocity_of(const Contact& contact, const Eigen::VectorXd& acceleration,
                              double h) const noexcept;

  std::vector<ArticulatedBody*> systems_;
  std::vector<int> first_link_;  // of each body, in slot_of_link_
  std::vector<int> parent_;      // of the union of bodies that touch
  std::vector<int> island_of_;   // by body
  std::vector<long> moved_;      // by body: the last island in which it was
  std::vector<int> starts_;      // of the islands in members_
  std::vector<int> order_;       // contacts, by island
  const int* members_ = nullptr;
  int member_count_ = 0;

  bool hurries_ = false, gave_up_ = false;
  bool bends_ = false;             // a law folded in is no straight line of the speed
  int folds_ = 0;                  // again, in this step
  bool tied_ = false;              // there is a tie among the contacts
  int n_ = 0;                      // 6 per slot
  std::vector<int> slot_of_link_;  // -1: not touched
  std::vector<Slot> slots_;
  std::vector<Coupling> couplings_;
  std::vector<Matrix6> h_;                      // by slot
  std::vector<ResponseRow> rows_, other_rows_;  // of two slots
  int most_rows_ = 6;
  std::vector<Matrix6> blocks_;          // B: of two slots of one body
  std::vector<int> neighbours_, first_;  // of each slot: those it touches
  std::vector<int> sequence_;            // slots along the pile
  std::vector<char> seen_;
  Eigen::VectorXd a1_, a_, da_, z_, best_z_, rho_, dz_, trial_, b_rho_;
  BandSolve band_;
  BlockSolve pile_;
  bool by_slope_ = false;
  bool in_pile_ = false;  // which of the two has the matrix
  std::vector<double> right_;  // of direction()
  std::vector<double> kinks_;
  double smooth_ = 0.0;
  double scale_ = 1.0;  // sum of forces [N]
  SolveCounters counters_;
};

}  // namespace twinbus::sim
