"""What is on each channel.  What for, from whom and when: lcmtypes/README.md and doc/protocol.md."""
from __future__ import annotations

from . import messages
from .lcm_types import Message

_NAMES = {'STATE': 'robot_state_t', 'STATE_SIM': 'robot_state_t', 'STATE_BRIDGE': 'robot_state_t', 'STATE_REPLAY': 'robot_state_t',
          'COMMAND': 'joint_command_t', 'STOP_PLAN': 'stop_plan_t', 'SOURCE_STATUS': 'source_status_t', 'SOURCE_REQUEST': 'source_request_t',
          'CONTROLLER_REQUEST': 'controller_request_t', 'MODE_REQUEST': 'mode_request_t', 'STOP': 'stop_t', 'ESTIMATE': 'estimate_t',
          'TRUTH': 'sim_truth_t', 'GUARD': 'guard_report_t', 'GAMEPAD': 'gamepad_t', 'WALK': 'walk_command_t', 'STEPS': 'step_list_t',
          'MOTION': 'motion_t',
          'SIM_REQUEST': 'sim_request_t', 'ARM_GOAL': 'arm_goal_t', 'ARM_PATH': 'arm_path_t', 'CONTROLLER_STATUS': 'controller_status_t',
          'GAP': 'gap_t', 'OBSTACLES': 'obstacles_t', 'HELD': 'obstacles_t', 'HEARTBEAT': 'heartbeat_t', 'MODEL_TEXT': 'model_text_t', 'EVENT': 'event_t',
          'JOURNAL': 'journal_t', 'TERRAIN': 'obstacles_t', 'LOOSE': 'obstacles_t', 'FOOTSTEPS': 'obstacles_t', 'CAMERA': 'model_text_t',
          'LOG_TEXT': 'model_text_t'}

TYPES: dict[str, type[Message]] = {channel: messages.ALL[name] for channel, name in _NAMES.items()}
"""Channel: message type.  A channel of your own: TYPES['POWER'] = message_type(...)."""
