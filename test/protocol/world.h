// A small world for the explorer: two or three real Sources, one controller, an operator, and a
// network that may lose, double or delay.  Copyable, so that the explorer can try every
// continuation of a state.
//
// One step is one period.  Ghost variables remember what was asked for and delivered; they judge,
// nothing reads them to act.

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "bridge/source/source.h"
#include "lcmtypes/msg/stop_plan.h"
#include "lcmtypes/msg/state_admission.h"

namespace twinbus::protocol {

inline constexpr int kMaxSources = 3;
inline constexpr std::int64_t kPeriod = 20'000'000;  // [ns]: the silence of 0.1 s is five periods
inline constexpr std::int64_t kTimeoutPeriods = 4;   // a command is silent after so many
inline constexpr std::int64_t kResumePeriods = 10;   // in which a controller may end its own stop plan
inline constexpr std::int64_t kPlanPeriods = 15;     // from the first knot of a stop plan to the last
inline constexpr std::int64_t kStranger = 999;       // the run of a forged STATE

// A robot with one joint that stands still wherever it is.
class StillRobot final : public RobotAdaptor {
 public:
  StillRobot(bool simulator, double q) : simulator_(simulator), q_(q) {}
  Status open(const Model&, const AdaptorConfig&) override { return Status::kOk; }
  Status read(RobotState& state, double) override {
    state.q[0] = q_;
    state.sensor_flags = kEncodersValid;
    return Status::kOk;
  }
  Status write(const JointCommand&) override { return Status::kOk; }
  void close() override {}
  bool can_be_set() const override { return simulator_; }
  Status set_state(const ImposedState&) override {
    return simulator_ ? Status::kOk : Status::kUnsupported;
  }
  bool is_hardware() const override { return !simulator_; }

 private:
  bool simulator_;
  double q_;
};

// What does not change during an exploration.
struct Setting {
  Setting(int sources, bool target_is_hardware, double target_q, RuleSet rules_off, bool sends_plans = false);
  int sources;
  RuleSet off;
  bool plans = false;  // the controller sends a stop plan behind every command
  Model model;
  std::shared_ptr<const GateLimits> limits;
  std::vector<StillRobot> robots;
  HandoverConfig handover_config(int source, std::int64_t run_id) const;
  SourceConfig source_config(int source, std::int64_t run_id) const;
};

enum class Fate : std::uint8_t { kDelivered, kLost, kLate, kDoubled };

// One message of the period that does not simply arrive.
struct Fault {
  // Source, or sources for the controller's commands, +1 and +2 for the two pieces of its stop plan, +3 for both; -1: none.
  int from = -1;
  int to = -1;    // -1: every link of the period
  Fate fate = Fate::kDelivered;
};

enum class EventKind : std::uint8_t {
  kNone,
  kActivate,
  kSwitch,
  kSwitchElsewhere,
  kTrack,
  kShadow,
  kPark,
  kRepeatRequest,
  kStopHold,
  kStopOff,
  kClear,
  kOldClear,
  kCrash,
  kRestart,
  kControllerDies,
  kControllerReturns,
  kForgedState,
  kSecondController,
  kFutureCommand,
  kNoMorePlans,      // the controller sends commands alone
  kPlanOfOtherTerm,  // a stop plan for a term that is not
  kPlanOfOther,      // and one of a controller that is not obeyed
  kStaleCommand,     // a command from the beginning of a silence comes
};

struct Happening {
  EventKind kind = EventKind::kNone;
  int subject = 0;       // source
  int receivers = 0xff;  // bit per source
};

class World {
 public:
  explicit World(const Setting& setting);

  // One period.  order 1: the sources tick in reverse order, and what is late comes after them.
  void step(int order, const Fault& fault, const Happening& happening);
  void quiet(int periods) {
    for (int i = 0; i < periods && violation_.empty(); ++i) step(0, {}, {});
  }
  // Messages get through again: where does it end?  Fills violation().
  void judge_the_end();

  // Empty while every property holds.
  const std::string& violation() const { return violation_; }
  std::uint64_t digest() const;
  std::string describe() const;

  int holders() const;
  const Source& source(int i) const { return nodes_[static_cast<std::size_t>(i)].core; }
  bool alive(int i) const { return nodes_[static_cast<std::size_t>(i)].alive; }
  bool controller_alive() const { return controller_alive_; }
  int message_faults = 0;
  int interventions = 0;  // happenings other than requests

 private:
  struct Node {
    explicit Node(Source c) : core(std::move(c)) {}
    Source core;
    bool alive = true;
    std::int64_t run_id = 0;
    // ghosts
    std::int64_t born_ns = 0;
    std::int64_t heard_state_ns = -1;  // STATE of another run was delivered
    std::int32_t highest_term = 0;     // delivered, or held
    std::int64_t accepted = 0;
    std::int64_t fed_ns = 0;  // last accepted command, or start of the term
    std::int64_t last_accepted_tick = -1;
    std::int32_t last_accepted_term = 0;
    std::int64_t last_grant_ns = -1;
    int activations_asked = 0;
    StopKind must_stop = StopKind::kNone;
    std::int64_t stopped_ns = 0;  // the last stop delivered
    Role role_before = Role::kParked;
    std::int32_t term_before = 0;
    std::int64_t refusals_before = 0;
    // of stop plans
    struct HeardPlan {
      StopPlanHead head;
      int pieces = 0;  // bit per piece that was delivered
    };
    std::array<HeardPlan, 4> plans{};  // by number
    std::int32_t newest_whole = -1;    // delivered in this term
    std::int32_t followed = 0;         // the number of the plan that is followed
    std::int64_t usual_age = 0;        // of the last accepted command [ticks]
    std::int64_t fed_tick = -1;        // of the source then
    bool fed = false;                  // a command was accepted since the last period ended
    bool cleared = false;              // a stop, and nobody was obeyed since
    bool plan_stopped = false;         // a stop was delivered while it was followed
    std::int64_t switch_addressed_elsewhere = 0;
  };
  struct Letter {  // a message that comes one period late
    bool command = false;
    bool plan = false;
    bool on_state = false;
    int piece = 0;
    int to = 0;
    RobotState state;
    JointCommand body;
    StopPlanHead head = {};
  };

  void add_node(int i);
  void deliver_state(int to, const RobotState& state, bool on_state);
  void deliver_command(int to, const JointCommand& command);
  void deliver_plan(int to, const StopPlanHead& head, int piece);
  void send_plan(const RobotState& state, const Fault& fault);
  StopPlanHead plan_for(const RobotState& state) const;
  void check_plan(Node& node);
  void controller_hears(const RobotState& state, const Fault& fault);
  void apply(const Happening& happening);
  void send_request(SourceRequest request, int receivers, bool again);
  void send_stop(StopKind kind, int receivers);
  void send_clear(std::int32_t nonce, std::int64_t born_ns, int receivers);
  void after_tick(int i);
  void check_period();
  void fail(const std::string& what) {
    if (violation_.empty()) violation_ = what;
  }
  Fate fate_of(const Fault& fault, int from, int to) const;
  int index_of(std::int64_t run) const;

  const Setting* setting_;
  std::int64_t now_ns_ = kPeriod;
  std::vector<Node> nodes_;
  std::vector<Letter> late_;
  StateAdmission admission_;
  std::int64_t believed_tick_ = 0, believed_ns_ = 0, believed_grant_ = 0;
  bool controller_alive_ = true, plans_ = true;
  std::int32_t sequence_ = 0;
  std::int64_t next_run_ = 100;
  SourceRequest last_request_{};
  std::int32_t known_nonce_ = 0;  // what the operator's last clear echoed
  std::int64_t known_nonce_ns_ = 0;
  std::array<std::int64_t, 64> run_of_term_{};  // whose commands were obeyed in it
  struct Grant {
    std::int64_t run = 0, tick = 0;
    std::int32_t term = 0;
  };
  std::array<Grant, 8> grants_{};
  unsigned next_grant_ = 0;
  bool stop_reached_holder_ = false;
  bool ever_active_ = false, holder_crashed_ = false, gave_way_ = false, double_activation_ = false;
  std::string violation_;
};

}  // namespace twinbus::protocol
