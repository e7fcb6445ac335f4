#pragma once

// The SCIP 2.0 protocol, both ends of it: the driver asks, the simulated sensor answers.
#include "robot/laser/core/scip_encoding.hpp"
#include "robot/laser/core/scip_reply.hpp"
#include "robot/laser/core/scip_request.hpp"
#include "robot/laser/core/scip_sensor.hpp"
