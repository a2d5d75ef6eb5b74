// The options of `twinbus up`.

#pragma once

#include "launcher/arguments.h"

namespace twinbus {

Syntax up_syntax();

}  // namespace twinbus
