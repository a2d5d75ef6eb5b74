// What the page is sent to draw: JSON texts made from a StackView.  What can be plotted is in
// signals.h.
//
//   live    60 Hz   posture, base pose, forces, ZMP, centre of mass, support polygon, guard pairs,
//                   postures of the ghosts
//   status  5 Hz    health, sources, processes, rates, mode, events
//   scene   on change  obstacles, terrain, loose bodies, what hands hold: scene_frame.h
//   path    on change  the planned motion of an arm, as joint angles
//
// Numbers are rounded to what a screen can show; a number that is not finite becomes null.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "viewer_log/view/stack_view.h"

namespace twinbus::inline viewer_log {

// What a frame of a recording has besides: where in the log it is, and another log to be shown as a ghost.
struct Recorded {
  double seconds = 0.0;              // from the first event of the log
  const StackView* other = nullptr;  // may be none
  std::int64_t other_now_ns = 0;
  // From the world of each view to the one that is drawn.
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d other_place = Eigen::Isometry3d::Identity();
};

std::string live_frame(const StackView& view, std::int64_t now_ns,
                       const Recorded* recorded = nullptr);
std::string status_frame(const StackView& view, std::int64_t now_ns);
std::string path_frame(const StackView& view);

// The answer to a page that says hello: the robot's joints in bus order, and whether it may act.
std::string hello_frame(const Model& model, bool trusted);

}  // namespace twinbus::viewer_log
