// Contacts of one robot with the fixed world, solved at the end of the step.
//
// Stage 1, fold(): the law's tangent at the present velocity becomes inertia of the touched links,
// so that one articulated-body pass solves a contact that keeps its mode.  Stage 2, solve(): where
// the law at the result disagrees, Newton on the wrenches z of the touched links,
//
//     rho(z) = z - sum J' [ f(v) - (f0 - G0 (v - v0)) ],   v = v0 + h J (a1 + B z)
//     (1 + H B) dz = -rho,                                  H = h sum J' (G - G0) J
//
// with B = Y' Y the inverse inertia of the touched links (never inverted), the exact unsymmetric
// tangent, and a line search on rho' B rho that also tries the kinks of the law.  Where that does
// not settle, the law is rounded off and sharpened in stages.  The forces applied are values of the
// law at the last velocity: inside the Coulomb cone whether the iteration has settled or not.

#pragma once

#include <vector>

#include "sim/articulated_body.h"
#include "sim/contact_law.h"

namespace twinbus {

// One point of a link against something fixed.
struct Contact {
  int link = -1;
  int sole = -1;
  int key = -1;           // says which contact of the next step is the same one
  bool material = false;  // the point is fixed in the link: its anchor is remembered
  ContactParams params;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // world [m]
  Eigen::Vector3d r = Eigen::Vector3d::Zero();      // about the body's common point, world axes [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   // out of the fixed thing, world, unit
  double depth = 0.0;                                 // [m]; below zero: not yet touching
  Eigen::Vector3d stretch = Eigen::Vector3d::Zero();  // of the bristle, world [m]
  Eigen::Vector3d v0 = Eigen::Vector3d::Zero();       // velocity at the start [m/s]
  // Of the solve.
  Eigen::Vector3d f0 = Eigen::Vector3d::Zero();  // force and tangent folded in by stage 1
  Eigen::Matrix3d g0 = Eigen::Matrix3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();  // velocity at the end [m/s]
  ContactForce now;
};

struct SolveCounters {
  long steps = 0;        // solve() with contacts
  long one_pass = 0;     // of them, done by stage 1
  long newton = 0;       // iterations
  long rounded = 0;      // solves that needed the rounded law
  long unconverged = 0;  // solves that did not settle
};

class ContactSolve {
 public:
  ContactSolve(const ArticulatedBody& body, int most_contacts);

  // Before inward().
  void fold(ArticulatedBody& body, std::vector<Contact>& contacts, double h) noexcept;
  // After inward() and outward(); applies what is missing and runs outward() again if need be.
  void solve(ArticulatedBody& body, std::vector<Contact>& contacts, double h) noexcept;

  const SolveCounters& counters() const noexcept { return counters_; }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Contacts = std::vector<Contact>;

  bool stage_one_holds(const ArticulatedBody& body, Contacts& contacts, double h) const noexcept;
  void find_slots(const ArticulatedBody& body, const Contacts& contacts) noexcept;
  void build_response(const ArticulatedBody& body) noexcept;
  // rho at z; with_tangent also H.  Returns the merit rho' B rho.
  double evaluate(Contacts& contacts, double h, const Eigen::VectorXd& z,
                  bool with_tangent) noexcept;
  void direction() noexcept;
  bool newton(Contacts& contacts, double h, int limit, double loose, double& merit) noexcept;
  double line_search(Contacts& contacts, double h, double merit) noexcept;
  double merit_at(Contacts& contacts, double h, double t) noexcept;
  void find_kinks(const Contacts& contacts, double h) noexcept;
  Eigen::Vector3d velocity_of(const Contact& contact, const Eigen::VectorXd& acceleration,
                              double h) const noexcept;

  int slots_ = 0;                  // touched links
  int n_ = 0;                      // 6 slots
  std::vector<int> slot_of_link_;  // -1: not touched
  std::vector<int> link_of_slot_;
  std::vector<Matrix6> h_;    // by slot
  std::vector<char> curved_;  // by slot: H is not zero
  std::vector<int> curved_slots_;
  std::vector<ResponseRow> rows_;  // by slot, most_rows each
  std::vector<int> row_count_;
  Eigen::MatrixXd b_;
  Eigen::VectorXd a1_, a_, da_, z_, best_z_, rho_, dz_, trial_, b_rho_;
  std::vector<double> matrix_, right_;  // of direction()
  std::vector<double> kinks_;
  double smooth_ = 0.0;
  double scale_ = 1.0;  // sum of forces [N]
  SolveCounters counters_;
};

}  // namespace twinbus
