// Messages of lcm-gen <-> structs of lcmtypes/msg, with every check of an input.  The fields and their rules stand in the .lcm
// files; lcmtypes/generate.py makes the code.
//
// Refused whole: a number that is NaN, infinite or beyond 1e12; a count outside its array; an
// enumeration outside its list; an identifier outside 0 .. 2^53 - 1; a quaternion that is no
// rotation; a text without its end.  Entries beyond joint_count come out as zero.  Code behind this
// trusts its input, and still knows nothing of limits: those are the command gate's.

#pragma once

#include "lcmtypes/bus/message_of.h"  // made by lcmtypes/generate.py
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/status.h"

namespace twinbus::inline lcmtypes {

template <class T>
using Message = typename LcmClassOf<T>::type;

// Both directions check; the output is complete only when kOk comes back.
template <class T>
Status to_message(const T& value, Message<T>& message) noexcept;
template <class T>
Status from_message(const Message<T>& message, T& value) noexcept;

}  // namespace twinbus::lcmtypes
