# Made from lcmtypes/*.lcm by test/structure/python_test.py --write; for type checkers and editors.
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .lcm_types import Message

ALL: dict[str, type[Message]]


@dataclass(eq=False)
class arm_goal_t(Message):
    """Where a hand should go. The ground frame: origin midway between the soles, z up, x forward."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...
    goal_id: int = ...  # random, echoed in arm_path_t
    joint_mask: int = ...  # kind 1: bit per joint that q is for
    sequence: int = ...
    side: int = ...  # 1 left, 2 right, 3 third, 4 fourth, 5 fifth, 6 sixth, 7 seventh, 8 eighth
    kind: int = ...  # 0 cancel, 1 joints, 2 position (of the hand), 3 pose (of the hand)
    position: NDArray[np.float64] = ...  # [3] of the hand frame, in the ground frame [m]
    orientation: NDArray[np.float64] = ...  # [4] w x y z, in the ground frame
    q: NDArray[np.float64] = ...  # [48] kind 1 [rad]
    speed: float = ...  # share of the joint velocity limits, 0..1


@dataclass(eq=False)
class arm_path_t(Message):
    """One numbered piece of a timed arm motion; cubic Hermite between knots. Executed only when every piece is there."""
    utime: int = ...  # [us]
    planner_id: int = ...
    run_id: int = ...
    goal_id: int = ...  # the goal it answers
    path_id: int = ...  # random, one per path
    piece: int = ...  # 0 .. pieces - 1
    pieces: int = ...  # 0: no path, see status
    joint_count: int = ...  # columns in use
    knot_count: int = ...  # rows of this piece in use
    joint: NDArray[np.int16] = ...  # [12] model index of each column
    status: int = ...  # 0 ok, 1 unreachable "the hand cannot get there", 2 start in collision "the arm touches something already", 3 goal in collision "the arm would touch something there", 4 time limit "no way found in time", 5 cancelled, 6 bad goal "not a goal for this robot"
    link_a: int = ...  # status 2, 3: the pair, as model link indices
    link_b: int = ...
    miss: float = ...  # status 1: by how much [m]
    clearance: float = ...  # status 0: proved of every instant: no nearer to the body, and to the obstacles planned among [m]
    time: NDArray[np.float64] = ...  # [6] [s] from the start of the path
    q: NDArray[np.float64] = ...  # [6, 12] [rad]
    qd: NDArray[np.float32] = ...  # [6, 12] [rad/s]


@dataclass(eq=False)
class controller_request_t(Message):
    """Binds the gate of the active source to another controller."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...
    controller_id: int = ...
    sequence: int = ...


@dataclass(eq=False)
class controller_status_t(Message):
    """What the controller thinks, every tick, with the journal of what it consumed."""
    tick: int = ...  # the state tick
    run_id: int = ...
    controller_id: int = ...
    guard_tick: int = ...  # tick of the guard report in force
    arm_path_id: int = ...  # path being followed, 0 none
    term: int = ...
    mode_sequence: int = ...  # of the mode request in force
    walk_sequence: int = ...
    compute_ns: int = ...
    mode: int = ...  # as in mode_request_t
    motion: int = ...
    stopping: int = ...  # stop kind under way
    arm_state: int = ...  # 0 none, 1 following, 2 done, 3 stopped by the guard
    com: NDArray[np.float32] = ...  # [3] in the ground frame [m]
    com_velocity: NDArray[np.float32] = ...  # [3] [m/s]
    com_reference: NDArray[np.float32] = ...  # [3] [m]
    dcm: NDArray[np.float32] = ...  # [2] [m]
    zmp: NDArray[np.float32] = ...  # [2] measured, in the ground frame [m]
    zmp_reference: NDArray[np.float32] = ...  # [2] [m]
    zmp_margin: float = ...  # measured ZMP to the edge of the support polygon [m]
    base_position: NDArray[np.float32] = ...  # [3] estimate, world [m]
    base_attitude: NDArray[np.float32] = ...  # [4] w x y z, estimate
    base_velocity: NDArray[np.float32] = ...  # [3] [m/s]


@dataclass(eq=False)
class estimate_t(Message):
    """Where the base is, how it moves and which feet carry it, from what the robot can measure; one per STATE, by the same source. World: z up, z = 0 the ground under the feet, origin and heading where the first STATE stood; goes on across a switch. Deviations are standard deviations along the axes of the world; a large one says: not known."""
    tick: int = ...  # of the STATE that it belongs to
    run_id: int = ...  # of that STATE
    base_position: NDArray[np.float64] = ...  # [3] origin of the base link, world [m]
    base_attitude: NDArray[np.float64] = ...  # [4] w x y z, base link in world
    base_velocity: NDArray[np.float32] = ...  # [3] of the origin of the base link, axes of the world [m/s]
    base_angular_velocity: NDArray[np.float32] = ...  # [3] of the base link, axes of the world [rad/s]
    velocity_in_base: NDArray[np.float32] = ...  # [3] of the origin of the base link, axes of the base link [m/s]
    angular_velocity_in_base: NDArray[np.float32] = ...  # [3] of the base link, axes of the base link [rad/s]
    imu_velocity: NDArray[np.float32] = ...  # [3] of the origin of the IMU's frame, axes of the IMU [m/s]
    position_deviation: NDArray[np.float32] = ...  # [3] [m]
    attitude_deviation: NDArray[np.float32] = ...  # [3] rotation about the axes of the world [rad]
    velocity_deviation: NDArray[np.float32] = ...  # [3] of base_velocity [m/s]
    angular_velocity_deviation: NDArray[np.float32] = ...  # [3] of base_angular_velocity [rad/s]
    foot_load: NDArray[np.float32] = ...  # [6] upward force on the foot, share of the robot's weight
    foot_certainty: NDArray[np.float32] = ...  # [6] that the foot stands: 0 surely not .. 1 surely
    foot_position: NDArray[np.float32] = ...  # [6, 3] centre of pressure, or of the foot where it is not known, world [m]
    foot_joint: NDArray[np.int16] = ...  # [6] index in STATE.q of the last joint before the foot; -1 none
    foot_count: int = ...  # rows in use: left foot, right foot, then the others in the order of the model
    foot_stands: NDArray[np.int8] = ...  # [6] 1: carries load
    load_from: int = ...  # 0 unknown, 1 forces (sensors of the feet), 2 torques (of the joints), 3 heights (of the feet)
    velocity_from: int = ...  # 0 unknown, 1 feet and accelerometer (feet that stand), 2 accelerometer (alone), 3 feet (that stand, alone), 4 fixed (the base is)


@dataclass(eq=False)
class event_t(Message):
    """A sentence for people. Control never listens."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...
    tick: int = ...
    sequence: int = ...
    code: int = ...  # for programs; 0 none
    severity: int = ...  # 0 information, 1 warning, 2 alarm
    kind: int = ...  # sender, as in heartbeat_t
    text: NDArray[np.int8] = ...  # [200] zero-terminated UTF-8


@dataclass(eq=False)
class gamepad_t(Message):
    """A gamepad or keyboard, 100 Hz even when nothing moves. Axes: dead zone removed, -1..1, forward and left positive."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...  # the source the operator looked at when he took hold
    sequence: int = ...
    buttons: int = ...  # bit per button: 0 A, 1 B, 2 X, 3 Y, 4 back, 5 guide, 6 start, 7-8 stick, 9-10 shoulder, 11-14 up down left right
    connected: int = ...
    deadman: int = ...  # 1 while held
    stop: int = ...  # 1: latched stop asked
    keyboard: int = ...  # 1: set-point keys, no stick
    left_x: float = ...  # left positive
    left_y: float = ...  # forward positive
    right_x: float = ...  # left positive
    right_y: float = ...  # up positive
    left_trigger: float = ...  # 0..1
    right_trigger: float = ...  # 0..1
    name: NDArray[np.int8] = ...  # [32] device, zero-terminated ASCII


@dataclass(eq=False)
class gap_t(Message):
    """Difference between the active source and a standby one."""
    utime: int = ...  # [us]
    run_id: int = ...  # active
    other_run_id: int = ...
    tick: int = ...
    joint_count: int = ...
    q: NDArray[np.float32] = ...  # [48] other minus active [rad]
    tau: NDArray[np.float32] = ...  # [48] [N m]
    foot_force: NDArray[np.float32] = ...  # [6, 3] of the feet in the order of estimate_t [N]
    tilt: NDArray[np.float32] = ...  # [2] roll, pitch [rad]


@dataclass(eq=False)
class guard_report_t(Message):
    """Self-collision verdict of one tick. hold_mask is binding for the gate: those joints are braked to rest."""
    tick: int = ...  # the state tick it judges
    run_id: int = ...  # of the source
    guard_id: int = ...  # random, drawn at start
    hold_mask: int = ...  # bit per joint
    compute_ns: int = ...
    pairs_checked: int = ...
    pairs_near: int = ...  # rows in use below, at most 6
    verdict: int = ...  # 0 clear, 1 near, 2 will collide, 3 in collision
    stop_asked: int = ...  # 1: a leg hit, stop kind 1 was published
    link_a: NDArray[np.int16] = ...  # [6] model link indices
    link_b: NDArray[np.int16] = ...  # [6]
    distance: NDArray[np.float32] = ...  # [6] [m], 0 or below when touching
    time_to_contact: NDArray[np.float32] = ...  # [6] [s], at the present joint speeds
    point_a: NDArray[np.float32] = ...  # [6, 3] witness points in the base frame [m]
    point_b: NDArray[np.float32] = ...  # [6, 3]


@dataclass(eq=False)
class heartbeat_t(Message):
    """One per process and 0.1 s: alive, and how its bus and its loop are."""
    utime: int = ...  # [us]
    process_id: int = ...  # random, drawn at start (run_id, controller_id, guard_id ...)
    messages_received: int = ...  # admitted
    messages_rejected: int = ...  # wrong size, hash, address, tick or not finite
    messages_lost: int = ...  # gaps in ticks
    ticks: int = ...
    ticks_missed: int = ...
    ticks_stalled: int = ...  # of those, by the machine: a bare timer of higher priority stood still too
    timer_missed: int = ...  # ticks that the bare timer missed, -1 there is none
    allocations: int = ...  # by the loop since it started, -1 not counted
    pid: int = ...
    send_failures: int = ...
    rate: float = ...  # ticks per second
    age_us: float = ...  # of the newest input, median; a source: from STATE sent to COMMAND obeyed
    age_p99_us: float = ...
    tick_median_us: float = ...  # computation
    tick_p99_us: float = ...
    tick_max_us: float = ...
    wake_p99_us: float = ...  # lateness of waking up
    kind: int = ...  # 0 none "unknown", 1 simulator, 2 bridge, 3 replay, 4 controller, 5 guard, 6 planner, 7 viewer, 8 gamepad, 9 log, 10 launcher, 11 user
    realtime: int = ...  # 0 none, 1 FIFO priority, 2 FIFO and locked memory
    state: int = ...  # 0 starting, 1 ready, 2 running, 3 degraded
    channels: int = ...  # rows in use of what follows, one per channel that this process listens to
    channel: NDArray[np.int8] = ...  # [12] which: its row in the table of lcmtypes/bus/wire.cpp, counted from 1
    channel_received: NDArray[np.int32] = ...  # [12]
    channel_lost: NDArray[np.int32] = ...  # [12] gaps in the ticks or sequences of one sender
    channel_repeated: NDArray[np.int32] = ...  # [12] the same tick or sequence again
    channel_rejected: NDArray[np.int32] = ...  # [12] wrong size, type or numbers, or not admitted
    channel_age_ms: NDArray[np.float32] = ...  # [12] of the newest
    channel_jitter_us: NDArray[np.float32] = ...  # [12] by which the time between two deviates from its mean, on average


@dataclass(eq=False)
class joint_command_t(Message):
    """torque = tau + kp (q - q_measured) + kd (qd - qd_measured), per joint. Answers one STATE tick of one run and term."""
    tick: int = ...  # the state tick it answers
    run_id: int = ...  # the source it is for, as shown in STATE
    model_hash: int = ...
    controller_id: int = ...  # random, drawn at start
    term: int = ...
    joint_count: int = ...
    flags: int = ...  # 1 stopping (stop kind 1 under way), 2 not faded in
    q: NDArray[np.float64] = ...  # [48] [rad or m]
    qd: NDArray[np.float32] = ...  # [48] [rad/s or m/s]
    tau: NDArray[np.float32] = ...  # [48] feed-forward [N m or N]
    kp: NDArray[np.float32] = ...  # [48] [N m/rad or N/m]
    kd: NDArray[np.float32] = ...  # [48] [N m s/rad or N s/m]


@dataclass(eq=False)
class journal_t(Message):
    """What a controller or guard consumed for one answer, in its order: with the messages themselves in a log, enough to compute the answer again bit for bit (log rerun)."""
    process_id: int = ...  # controller_id or guard_id
    page: int = ...  # counts up by one per journal message of this process
    step: int = ...  # answers before this one
    run_id: int = ...  # of the state
    tick: int = ...  # of the state
    now_ns: int = ...  # the steady clock given to the step
    state_hash: int = ...  # of the encoded STATE
    answer_hash: int = ...  # of the encoded COMMAND or GUARD (with compute_ns 0); 0: no answer
    report_hash: int = ...  # of the encoded CONTROLLER_STATUS with compute_ns 0
    input_hash: NDArray[np.int64] = ...  # [24] of the encoded messages consumed since the last page
    input_ns: NDArray[np.int64] = ...  # [24] the steady clock when each was consumed
    setting: NDArray[np.float64] = ...  # [4] controller: first mode, guard in the loop; guard: margin [m]
    inputs: int = ...  # rows in use
    kind: int = ...  # 4 controller, 5 guard
    whole: int = ...  # 0: the inputs go on in the next page, which has the step
    input: NDArray[np.int8] = ...  # [24] 1 mode, 2 walk, 3 gamepad, 4 path, 5 goal, 6 stop, 7 guard, 8 obstacles, 9 take obstacles (no message: the collected ones become those of the guard), 10 command, 11 steps, 12 motion, 13 held


@dataclass(eq=False)
class mode_request_t(Message):
    """An operator asks the controller for a mode."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...  # the source the controller is expected to follow
    at_tick: int = ...  # takes effect at this state tick; 0 at once
    joint_mask: int = ...  # pose: bit per joint that q is for
    sequence: int = ...
    mode: int = ...  # 1 idle, 2 hold, 3 pose, 4 balance, 5 walk, 6 stop
    motion: int = ...  # balance: 0 none, 1 sway, 2 squat, 3 played (by a policy that has a motion; our controller plays those of MOTION)
    duration: float = ...  # pose: time to get there [s]
    amplitude: float = ...  # sway, squat [m]
    frequency: float = ...  # sway, squat [Hz]
    q: NDArray[np.float64] = ...  # [48] pose: target [rad or m]


@dataclass(eq=False)
class model_text_t(Message):
    """A numbered piece of the robot description (URDF, then SRDF, then robot.yaml), again and again at 1 Hz."""
    utime: int = ...  # [us]
    run_id: int = ...
    model_hash: int = ...
    size: int = ...  # of the whole text [bytes]
    piece: int = ...
    pieces: int = ...
    count: int = ...  # bytes of this piece in use
    kind: int = ...  # 1 URDF, 2 SRDF, 3 robot.yaml, 4 scene
    text: NDArray[np.int8] = ...  # [1300]


@dataclass(eq=False)
class motion_t(Message):
    """Some frames of a motion, said a little before they are played; a cubic B-spline goes through them. The joints of joint_mask follow it, the legs of a balancing robot carry its centre of mass as com says. Begins with frame 0, from wherever the robot stands."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...
    motion_id: int = ...  # random, one per motion
    joint_mask: int = ...  # bit per joint on the bus that moves; never a leg's of a robot that balances
    sequence: int = ...
    frames: int = ...  # of the whole motion
    first: int = ...  # number of the first frame here
    joint_count: int = ...  # columns in use
    count: int = ...  # rows in use
    period: float = ...  # between frames, at least 0.005 [s]
    depth: float = ...  # the deepest that com goes below standing, in the whole motion [m]
    com: NDArray[np.float32] = ...  # [6, 3] of the centre of mass, from where it stands, ground frame [m]
    tilt: NDArray[np.float32] = ...  # [6, 2] of the base, roll and pitch, from upright [rad]
    q: NDArray[np.float32] = ...  # [6, 48] [rad or m]


@dataclass(eq=False)
class obstacles_t(Message):
    """Part of the obstacles of a scene; poses in the ground frame at the start (arm_goal_t)."""
    utime: int = ...  # [us]
    scene_id: int = ...  # changes with the scene
    piece: int = ...
    pieces: int = ...
    count: int = ...  # rows in use
    shape: NDArray[np.int8] = ...  # [12] 1 box, 2 sphere, 3 cylinder
    size: NDArray[np.float32] = ...  # [12, 3] box: full edges; sphere: radius; cylinder: radius, length [m]
    position: NDArray[np.float32] = ...  # [12, 3] [m]
    attitude: NDArray[np.float32] = ...  # [12, 4] w x y z


@dataclass(eq=False)
class robot_state_t(Message):
    """What a robot can measure, from whichever source is active. One per tick; doc/protocol.md section 2."""
    tick: int = ...  # counts up by one per period, goes on across a switch
    time_ns: int = ...  # advances by period_ns per tick, goes on across a switch
    source_time_ns: int = ...  # the source's own clock
    run_id: int = ...  # random, drawn at start, below 2^53
    model_hash: int = ...  # of the nominal model, below 2^53
    grant_run_id: int = ...  # 0, or the run that may take over
    grant_tick: int = ...  # the first tick that run may publish
    enabled: int = ...  # bit per joint: servo on
    plan_tick: int = ...  # first tick at which a stop plan was followed instead of commands; 0 none is followed
    term: int = ...  # counts activations; a higher one is believed only by the rules
    period_ns: int = ...
    stop_nonce: int = ...  # what a clear must echo
    plan_number: int = ...  # of that plan; 0 none is followed
    sensor_flags: int = ...  # bit per sensor: valid this tick (0 encoders, 1 IMU, wrenches: 2-3 of feet 0 and 1, 4-5 of the hands, 6-9 of feet 2 to 5)
    joint_count: int = ...  # actuated, non-mimic joints in model order; at most 48
    source: int = ...  # 1 simulator, 2 bridge "robot", 3 replay
    role: int = ...  # 1 parked, 2 active, 3 releasing, 4 standby track "track", 5 standby shadow "shadow", 6 stopped
    stop_kind: int = ...  # 0 none, 1 balanced, 2 hold, 3 off
    wrench_kind: NDArray[np.int8] = ...  # [8] 0 absent, 1 measured, 2 estimated (no sensor of the robot says it: a switch does not compare it)
    q: NDArray[np.float64] = ...  # [48] [rad or m]
    qd: NDArray[np.float32] = ...  # [48] [rad/s or m/s]
    tau: NDArray[np.float32] = ...  # [48] [N m or N]
    attitude: NDArray[np.float32] = ...  # [4] w x y z, IMU link in world (heading arbitrary)
    gyro: NDArray[np.float32] = ...  # [3] in the IMU frame [rad/s]
    accel: NDArray[np.float32] = ...  # [3] specific force in the IMU frame [m/s^2]
    wrench: NDArray[np.float32] = ...  # [8, 6] force [N] then torque [N m] on the robot, in the sensor frame: six feet as in estimate_t (left, right, then the others), left hand, right hand


@dataclass(eq=False)
class sim_request_t(Message):
    """An operator asks a simulator for something that only a simulated world can do. A robot behind the bridge never listens."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...  # the simulator it is for
    model_hash: int = ...  # push: of the robot whose link is meant
    sequence: int = ...
    ticks: int = ...  # step: so many, then it pauses
    link: int = ...  # push: model link index
    action: int = ...  # 1 pause, 2 go (on), 3 step, 4 pace, 5 push
    pace: float = ...  # pace: times real time, 0.01 to 10
    duration: float = ...  # push [s]
    force: NDArray[np.float32] = ...  # [3] push: world [N]
    point: NDArray[np.float32] = ...  # [3] push: where on the link, in its frame [m]


@dataclass(eq=False)
class sim_truth_t(Message):
    """What only a simulator knows. Control never reads it."""
    tick: int = ...
    run_id: int = ...
    sim_time: float = ...  # [s]
    base_position: NDArray[np.float64] = ...  # [3] world [m]
    base_attitude: NDArray[np.float64] = ...  # [4] w x y z, world
    base_velocity: NDArray[np.float64] = ...  # [3] world [m/s]
    base_angular_velocity: NDArray[np.float64] = ...  # [3] world [rad/s]
    com: NDArray[np.float32] = ...  # [3] world [m]
    com_velocity: NDArray[np.float32] = ...  # [3] world [m/s]
    zmp: NDArray[np.float32] = ...  # [2] world [m]
    zmp_margin: float = ...  # [m]
    foot_position: NDArray[np.float32] = ...  # [6, 3] of the feet in the order of estimate_t: sole frames, or where a foot without a sole is lowest, world [m]
    foot_attitude: NDArray[np.float32] = ...  # [6, 4] of the sole frame, or of its link: w x y z
    foot_force: NDArray[np.float32] = ...  # [6, 3] world [N]
    foot_slip: NDArray[np.float32] = ...  # [6] speed of that place along the ground [m/s]
    penetration: float = ...  # deepest contact [m]
    push_force: NDArray[np.float32] = ...  # [3] applied by the scene, world [N]
    push_point: NDArray[np.float32] = ...  # [3] world [m]
    contact_point: NDArray[np.float32] = ...  # [8, 3] world [m]
    contact_force: NDArray[np.float32] = ...  # [8, 3] world [N]
    realtime_factor: float = ...
    contact_count: int = ...  # rows in use, at most 8
    foot_count: int = ...  # feet in use
    fell: int = ...
    last_doubt: int = ...  # of the newest physics step that the engine itself does not trust: 1 unconverged "contacts that did not settle", 2 unsettled "a joint on a wrong piece of its law", 3 energy gained, 4 first seen deep "a contact first seen too deep", 5 tunnelling, 6 too coarse "a step that is too coarse"
    doubted: NDArray[np.int32] = ...  # [6] such steps since the simulated world began, by that number less one; one step may have several
    doubted_steps: int = ...  # with any
    doubted_since: float = ...  # sim_time of the first of them [s]; 0: there is none


@dataclass(eq=False)
class source_request_t(Message):
    """An operator asks a source for something. Activation: run_id 0 is allowed when no source is active."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...  # the active source this is meant for (switch), or the run addressed itself (other actions)
    target_run_id: int = ...  # the run that is to become active, standby or parked
    sequence: int = ...  # counts up by one per message of this sender
    action: int = ...  # 0 none "something unknown", 1 activate "activation", 2 switch, 3 standby track "standby (track)", 4 standby shadow "standby (shadow)", 5 park "parking"
    policy: int = ...  # switch: 1 now, 2 when safe
    align: int = ...  # switch: 1 moves the target robot to the posture first


@dataclass(eq=False)
class source_status_t(Message):
    """How a source is, 10 Hz and on change. One slot per run_id at the receiver."""
    utime: int = ...  # [us]
    run_id: int = ...
    model_hash: int = ...
    tick: int = ...
    controller_id: int = ...  # the controller its gate is bound to, 0 none
    successor_run_id: int = ...  # while granting: to whom
    commands_accepted: int = ...
    commands_rejected: int = ...
    commands_late: int = ...
    clamped: int = ...  # numbers cut to a limit
    ticks_missed: int = ...
    plans_accepted: int = ...  # whole stop plans that were taken
    plans_refused: int = ...  # stop plans that were not
    plans_followed: int = ...  # times that commands were missing and a stop plan was followed
    terms_ignored: int = ...  # STATE messages that claimed a term they could not have
    term: int = ...
    period_ns: int = ...
    stop_nonce: int = ...
    refusal_sequence: int = ...  # sequence of the request the refusal below answers
    faded_in: float = ...  # share of the commands of controller_id in what the robot obeys: 0 none yet .. 1 they act as they are
    source: int = ...  # as in robot_state_t
    role: int = ...
    stop_kind: int = ...
    stop_reason: int = ...
    adaptor_status: int = ...  # 0 ok, else lcmtypes/msg/status.h
    pace: int = ...  # 1 real time, 2 lock-step, 3 free run, 4 paused, 5 slowed or hurried, 6 real time but for the time it waits for late commands
    can_be_set: int = ...  # 1: a state can be imposed (simulators)
    hardware: int = ...  # 1: moves a real robot
    plan_refusal: int = ...  # why the last refused stop plan was; 0 none: robot/stop_plan/plan_assembler.h
    refusal: int = ...  # Last refusal: 0 none, 1 not addressed (run_id is not the active source), 2 unknown target (not heard on its own channel), 3 model hash, 4 period, 5 stale (either side is older than the state timeout), 6 stopped, 7 posture (a joint differs by more than 0.05 rad), 8 velocity (a joint differs by more than 0.5 rad/s), 9 attitude (roll or pitch differs by more than 0.05 rad), 10 gyro (angular velocity differs by more than 0.3 rad/s), 11 feet (not the same feet loaded), 12 load (total foot force differs by more than 20 %), 13 unstable (a real robot would be left while not statically stable), 14 busy (a switch is under way, or came too soon after the last), 15 already active, 16 another active (activation while a source is active), 17 pace (leaving lock-step towards hardware), 18 cannot be set (track asked of an adaptor without set_state), 19 not standby (the target is neither set-able nor in standby), 20 device (the adaptor of the target reports an error)


@dataclass(eq=False)
class step_list_t(Message):
    """Footsteps one after the other, each in the frame of the sole that stands then (x forward, y left); the feet take turns."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...
    sequence: int = ...
    count: int = ...  # entries in use
    first_foot: int = ...  # that moves first: 1 left, 2 right
    x: NDArray[np.float32] = ...  # [32] [m]
    y: NDArray[np.float32] = ...  # [32] [m]
    yaw: NDArray[np.float32] = ...  # [32] [rad]


@dataclass(eq=False)
class stop_plan_t(Message):
    """One numbered piece of a stop plan: where the motion leads if the controller falls silent now. A source follows it from the first tick without a command, and only when every piece is there. doc/protocol.md section 5."""
    run_id: int = ...  # the source it is for, as shown in STATE
    model_hash: int = ...
    controller_id: int = ...
    tick: int = ...  # the state tick of knot 0: that of a command
    joints: int = ...  # bit per joint that the plan moves; the others are brought to rest
    term: int = ...
    number: int = ...  # counts up by one per plan of a controller
    piece: int = ...  # 0 .. pieces - 1; knot k is row k - 5 piece of its piece
    pieces: int = ...
    knot_count: int = ...  # of the whole plan
    spacing: int = ...  # ticks from knot to knot
    joint_count: int = ...
    walks: int = ...  # 1: the robot is on its feet, and phase, balance and the five numbers below count
    omega: float = ...  # of the linear pendulum [1/s]
    mass: float = ...  # that the feet carry [kg]
    sole_low: NDArray[np.float32] = ...  # [2] where the ZMP may be under a sole: forward, left [m]
    sole_high: NDArray[np.float32] = ...  # [2]
    sole_zmp: NDArray[np.float32] = ...  # [2] where it is under a sole that carries alone: forward, inward [m]
    phase: NDArray[np.int8] = ...  # [5] bit 0: one foot carries, bit 1: it is the right one
    q: NDArray[np.int16] = ...  # [5, 48] [2e-4 rad or m]
    tau: NDArray[np.int16] = ...  # [5, 48] feed-forward [0.05 N m or N]
    balance: NDArray[np.int16] = ...  # [5, 16] [1e-4 m, rad, 1], frame of the left sole in knot 0, z up: DCM x y, centre of mass x y, ZMP x y, rotation vector of the base, load share of the left foot, left sole x y yaw, right sole x y yaw


@dataclass(eq=False)
class stop_t(Message):
    """A request to stop, or to clear a stop. Handled one by one, never newest-wins: doc/protocol.md section 6."""
    utime: int = ...  # sender's clock [us]
    sender_id: int = ...  # random, drawn at start
    sequence: int = ...  # counts up by one per message of this sender
    stop_nonce: int = ...  # clear only: the nonce shown in STATE
    kind: int = ...  # 0 clear, 1 balanced, 2 hold, 3 off
    reason: int = ...  # for people: 0 none, 1 operator "the operator", 2 gamepad "the gamepad", 3 viewer "the viewer", 4 guard "the guard", 5 launcher "the launcher", 6 controller "the controller", 7 command timeout "missing commands" (drawn by the gate itself), 8 device "a device error" (the adaptor failed), 9 switch "a switch" (the active source asks for rest; gates do not latch it), 10 fallen "a fall" (drawn by the source: its robot lies)


@dataclass(eq=False)
class walk_command_t(Message):
    """Walking velocity in the robot's heading frame; times out on the receiver's clock."""
    utime: int = ...  # [us]
    sender_id: int = ...
    run_id: int = ...
    sequence: int = ...
    vx: float = ...  # forward [m/s]
    vy: float = ...  # left [m/s]
    wz: float = ...  # turn left [rad/s]
    timeout: float = ...  # [s]
