// The headers that the header of every block needs.
#pragma once

#include "cobot_command/blocks/shared/error_table.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/goal_traits.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/blocks/shared/planning_scene.h"
