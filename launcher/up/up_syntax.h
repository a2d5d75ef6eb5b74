// The options of `twinbus up`.

#pragma once

#include "common/process/arguments.h"

namespace twinbus {

Syntax up_syntax();

}  // namespace twinbus
