// What the page can plot: the numbers of the newest messages, by channel and field.
//
//   {"type":"signals","time":s,"STATE":{"q":[...],...},"COMMAND":{...},"TRACKING":{"q":[...]},...}
//
// Arrays are in bus order.  TRACKING is COMMAND less STATE, DIFFERENCE is the standby source less
// STATE; the newest of each is taken, so they may be a tick apart.

#pragma once

#include <cstdint>
#include <string>

#include "viewer_log/view/frame.h"
#include "viewer_log/view/stack_view.h"

namespace twinbus::inline viewer_log {

// Of a recording also OTHER, the other log, and RESIDUAL, the other less this one.
// What a row of wrenches is called: left_foot, right_foot, left_hand, right_hand, a foot without a sole by its link.
std::string limb_name(const StackView& view, std::size_t limb);

std::string signals_frame(const StackView& view, std::int64_t now_ns,
                          const Recorded* recorded = nullptr);

}  // namespace twinbus::viewer_log
