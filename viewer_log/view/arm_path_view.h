// The newest planned arm motion, put together from its pieces.
//
// Pieces are repeated and may come in any order; a path is shown once it is complete.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline viewer_log {

class ArmPathView {
 public:
  struct Knot {
    double time = 0.0;  // [s]
    std::array<double, kArmJoints> q{};
  };

  void on_piece(const ArmPathPiece& piece);

  // Grows whenever another path, or another refusal, is complete.
  std::int64_t version() const { return version_; }
  std::int64_t id() const { return shown_id_; }
  const char* status_text() const;                            // "ok", or why there is no path
  const std::vector<int>& joints() const { return joints_; }  // model indices
  const std::vector<Knot>& knots() const { return knots_; }
  double duration() const { return knots_.empty() ? 0.0 : knots_.back().time; }

 private:
  void finish();

  std::vector<ArmPathPiece> pieces_;
  std::uint64_t have_ = 0;  // bit per piece
  std::int64_t collecting_ = 0, shown_id_ = 0, shown_goal_ = 0, version_ = 0;
  ArmPathStatus status_ = ArmPathStatus::kOk;
  std::vector<int> joints_;
  std::vector<Knot> knots_;
};

}  // namespace twinbus::viewer_log
