#include "bridge/source/sim_obey.h"

#include <cstdio>

namespace twinbus::inline bridge {

namespace {

Eigen::Vector3d vector(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

}  // namespace

std::array<char, 160> obey_sim_request(const SimRequest& request, const Model& model,
                                       SimPace& clock, RobotAdaptor& adaptor) noexcept {
  std::array<char, 160> text{};
  const auto say = [&](const char* format, auto... values) {
    std::snprintf(text.data(), text.size(), format, values...);
  };
  switch (request.action) {
    case SimAction::kPause:
      clock.pause();
      say("%s", "the simulated world is paused");
      break;
    case SimAction::kGo:
      clock.go();
      say("the simulated world goes on, at %g times real time", clock.factor());
      break;
    case SimAction::kStep:
      if (clock.step(request.ticks)) {
        say("%d ticks, then the simulated world is paused", static_cast<int>(request.ticks));
      } else {
        say("refused: 1 to %d ticks at once", SimPace::kMostSteps);
      }
      break;
    case SimAction::kPace:
      if (clock.pace(static_cast<double>(request.pace))) {
        say("the simulated world runs at %g times real time", static_cast<double>(request.pace));
      } else {
        say("refused: a pace is %g to %g times real time", SimPace::kSlowest, SimPace::kFastest);
      }
      break;
    case SimAction::kPush: {
      if (request.model_hash != model.hash) {
        say("%s", "refused: a push for another robot");
        break;
      }
      const Eigen::Vector3d force = vector(request.force);
      const Status status = adaptor.push(request.link, force, vector(request.point),
                                         static_cast<double>(request.duration));
      if (status == Status::kOk) {
        say("%s is pushed with %.0f %.0f %.0f N for %g s",
            model.links[static_cast<std::size_t>(request.link)].name.c_str(), force.x(), force.y(),
            force.z(), static_cast<double>(request.duration));
      } else {
        say("%s", "refused: a push is at most 100000 N for 60 s on a link, eight at once");
      }
      break;
    }
    case SimAction::kNone:
      say("%s", "refused: a simulator knows no such request");
      break;
  }
  return text;
}

}  // namespace twinbus::bridge
