// Every struct that goes over the bus.

#pragma once

#include "lcmtypes/msg/estimate.h"
#include "lcmtypes/msg/full_heartbeat.h"
#include "lcmtypes/msg/journal.h"
#include "lcmtypes/msg/motion_piece.h"
#include "lcmtypes/msg/pieces.h"
#include "lcmtypes/msg/reports.h"
#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/sim_request.h"
#include "lcmtypes/msg/status.h"
#include "lcmtypes/msg/step_list.h"
#include "lcmtypes/msg/stop_plan.h"
