#pragma once

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// The keys of `vessel`, errors collected in `in`.
monitor::BodyConfig loadVessel(ParameterReader in);

/// The keys of `vehicle`, errors collected in `in`.
void loadVehicle(ParameterReader in, monitor::Config& config);

/// The constants of a simulated body among the keys of `in`, errors collected there. Its attachment is not read.
core::RigidBody loadRigidBody(ParameterReader& in);

}  // namespace tether_monitor::params
