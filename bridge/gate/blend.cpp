#include "bridge/gate/blend.h"

#include <algorithm>

#include "common/math/index.h"
#include "common/math/quintic_fade.h"

namespace twinbus::inline bridge {

void OffsetBlend::start(const JointCommand& own, const JointCommand& client, std::int64_t mask,
                        double dt, double duration, double torque_duration) noexcept {
  for (int j = 0; j < kMaxJoints; ++j) {
    if ((mask & bit(j)) == 0) continue;
    const auto i = static_cast<std::size_t>(j);
    if (!(duration > 0.0)) {
      active &= ~bit(j);
      continue;
    }
    // The client where it was dt ago, so that both set-points belong to one instant.
    const double client_qd = static_cast<double>(client.qd[i]);
    q[i] = own.q[i] - (client.q[i] - client_qd * dt);
    qd[i] = static_cast<double>(own.qd[i]) - client_qd;
    tau[i] = own.tau[i] - client.tau[i];
    kp[i] = own.kp[i] - client.kp[i];
    kd[i] = own.kd[i] - client.kd[i];
    elapsed[i] = 0.0F;
    duration_s[i] = static_cast<float>(duration);
    torque_s[i] = static_cast<float>(torque_duration > 0.0 ? torque_duration : duration);
    active |= bit(j);
  }
}

float OffsetBlend::share_of_client() const noexcept {
  double most = 0.0;
  for (int j = 0; j < kMaxJoints; ++j) {
    if ((active & bit(j)) == 0) continue;
    const auto i = static_cast<std::size_t>(j);
    most = std::max(most, fade_left(static_cast<double>(elapsed[i]) / static_cast<double>(duration_s[i])));
  }
  return static_cast<float>(std::clamp(1.0 - most, 0.0, 1.0));
}

void OffsetBlend::advance_and_apply(double dt, int joint_count, JointCommand& command) noexcept {
  if (active == 0) return;
  for (int j = 0; j < joint_count; ++j) {
    if ((active & bit(j)) == 0) continue;
    const auto i = static_cast<std::size_t>(j);
    elapsed[i] += static_cast<float>(dt);
    const double total = static_cast<double>(duration_s[i]);
    const double s = static_cast<double>(elapsed[i]) / total;
    if (!(s < 1.0)) {
      active &= ~bit(j);
      continue;
    }
    const QuinticFade fade = quintic_fade(s);
    const auto left = static_cast<float>(fade.h0);
    command.q[i] += q[i] * fade.h0 + qd[i] * total * fade.h1;
    command.qd[i] += static_cast<float>(q[i] * (fade.h0_rate / total) + qd[i] * fade.h1_rate);
    const double torque_at = static_cast<double>(elapsed[i]) / static_cast<double>(torque_s[i]);
    command.tau[i] += tau[i] * static_cast<float>(fade_left(torque_at));
    command.kp[i] += kp[i] * left;
    command.kd[i] += kd[i] * left;
  }
}

}  // namespace twinbus::bridge
