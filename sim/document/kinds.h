// Every kind of experiment, for those who ask which it is.
#pragma once

#include "sim/document/birotor_motion.h"
#include "sim/document/flight.h"
#include "sim/document/motor_bench.h"
#include "sim/document/motor_speed_run.h"
#include "sim/document/propeller_bench.h"
#include "sim/document/solver_comparison.h"
#include "sim/document/thrust_stand.h"
