// Requests of pages on their way from the server's thread to the viewer's loop.

#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "robot/description/named_hands.h"
#include "robot/kinematics/pose_request.h"
#include "viewer_log/server/page_request.h"
#include "viewer_log/view/frame.h"
#include "viewer_log/view/setup_desk.h"

namespace twinbus::inline viewer_log {

// A stop has a place of its own, so it is never crowded out.
class PageInbox {
 public:
  std::string on_message(const Model& model, const std::string& run_folder, const std::string& text,
                         bool trusted) {
    PageRequest request;
    std::string problem;
    if (!read_page_request(text, trusted, request, problem)) return note_frame(problem);
    if (request.what == PageRequest::What::kHello) return hello_frame(model, trusted);
    if (request.what == PageRequest::What::kSetup) {
      const std::string refusal = lay_wish(run_folder, request.setup);
      return note_frame(!refusal.empty() ? refusal : request.saves ? "Saving …" : "Starting anew …");
    }
    if (request.what == PageRequest::What::kReset) {
      const std::string refusal = lay_wish(run_folder, "{\"again\": true}");
      return note_frame(refusal.empty() ? "The simulated world begins anew …" : refusal);
    }
    if (request.sim.action == SimAction::kPush && model.find_link(request.link) < 0)
      return note_frame("push: the robot has no link of that name");
    if (request.what == PageRequest::What::kReach && hand_called(model, request.hand) == nullptr) {
      const std::string names = hand_names(model);
      return note_frame("reach: the robot has no arm called " + request.hand + (names.empty() ? "" : "; it has " + names));
    }
    if (request.what == PageRequest::What::kPose) {
      for (const auto& [name, q] : request.joints) {
        problem = add_joint(model, name, q, request.pose);
        if (!problem.empty()) return note_frame("pose: " + problem);
      }
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    if (request.what == PageRequest::What::kStop) {
      if (request.stop > stop_) stop_ = request.stop;
    } else if (requests_.size() < kMostRequests) {
      requests_.push_back(request);
    }
    return {};
  }

  StopKind take(std::vector<PageRequest>& requests) {
    const std::lock_guard<std::mutex> lock(mutex_);
    requests.swap(requests_);
    requests_.clear();
    return std::exchange(stop_, StopKind::kNone);
  }

 private:
  static constexpr std::size_t kMostRequests = 32;  // waiting
  std::mutex mutex_;
  std::vector<PageRequest> requests_;
  StopKind stop_ = StopKind::kNone;
};

}  // namespace twinbus::viewer_log
