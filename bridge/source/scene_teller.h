// What a source tells of itself and its scene again and again, for whoever comes late: robot description, obstacles,
// terrain once a second, loose bodies 50 times; spread so that no tick sends many.  The first round is one message a tick: a
// controller that is there before knows the robot before the first STATE.

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "bridge/adaptor/adaptor.h"
#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"

namespace twinbus::inline bridge {

class SceneTeller {
 public:
  // run_id: of the source, whose world terrain and loose bodies are in.
  SceneTeller(std::vector<ModelTextPiece> texts, std::vector<ObstaclesPiece> obstacles,
              std::vector<ObstaclesPiece> terrain, std::int64_t run_id)
      : texts_(std::move(texts)),
        obstacles_(std::move(obstacles)),
        terrain_(std::move(terrain)),
        run_id_(run_id) {
    for (ObstaclesPiece& piece : terrain_) piece.scene_id = run_id_;
  }

  // At most one message; on has text(), obstacles() and terrain() with a piece each.
  template <class On>
  void repeat(std::int64_t now_ns, On& on) noexcept {
    const std::size_t total = texts_.size() + obstacles_.size() + terrain_.size();
    if (total == 0 || now_ns < next_ns_) return;
    if (told_ < total) ++told_;
    next_ns_ = told_ < total ? now_ns : now_ns + kSecond_ns / static_cast<std::int64_t>(total);
    next_ = (next_ + 1) % total;
    std::size_t i = next_;
    if (i < texts_.size()) return on.text(texts_[i]);
    i -= texts_.size();
    if (i < obstacles_.size()) return on.obstacles(obstacles_[i]);
    on.terrain(terrain_[i - obstacles_.size()]);
  }

  // At most one message: on.loose().
  template <class On>
  void tell_loose(std::int64_t now_ns, const RobotAdaptor& adaptor, On& on) noexcept {
    if (now_ns < next_loose_ns_) return;
    loose_piece_ = loose_piece_ + 1 < loose_pieces_ ? loose_piece_ + 1 : 0;
    loose_pieces_ = adaptor.loose(loose_piece_, loose_);
    next_loose_ns_ = now_ns + kLooseEvery_ns / (loose_pieces_ > 0 ? loose_pieces_ : 1);
    if (loose_pieces_ == 0) return;
    loose_.scene_id = run_id_;
    on.loose(loose_);
  }

  // on.held() of each hand, at once when it grips or lets go, else each second.
  template <class On>
  void tell_held(std::int64_t now_ns, const RobotAdaptor& adaptor, On& on) noexcept {
    ObstaclesPiece piece;
    for (int hand = 0; hand < kMostHands; ++hand) {
      if (!adaptor.held(hand, piece)) continue;
      Held& told = held_[static_cast<std::size_t>(hand)];
      const bool same = piece.scene_id == told.scene_id;
      if (same && now_ns < told.next_ns) continue;
      told = {piece.scene_id, now_ns + (same ? kSecond_ns : kSoon_ns)};
      piece.scene_id += run_id_ % kMostRuns * kMostChanges;
      on.held(piece);
    }
  }

 private:
  static constexpr std::int64_t kSecond_ns = 1'000'000'000, kLooseEvery_ns = 20'000'000, kSoon_ns = 100'000'000;
  static constexpr std::int64_t kMostChanges = 1000, kMostRuns = std::int64_t{1} << 42;  // an id of each change of each run

  std::vector<ModelTextPiece> texts_;
  std::vector<ObstaclesPiece> obstacles_, terrain_;
  std::int64_t run_id_;
  std::int64_t next_ns_ = 0, next_loose_ns_ = 0;
  std::size_t next_ = 0, told_ = 0;
  struct Held {
    std::int64_t scene_id = 0, next_ns = 0;
  };
  std::array<Held, kMostHands> held_{};
  ObstaclesPiece loose_;
  int loose_piece_ = 0, loose_pieces_ = 0;
};

}  // namespace twinbus::bridge
