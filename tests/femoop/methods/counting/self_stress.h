#pragma once

#include "femoop/model/model.h"

/// How many independent sets of forces hold a plane frame in equilibrium without loads: unknowns less the rank of the
/// equations of equilibrium, dense. It shares nothing with the counting that it judges.
///
/// Unknowns   N, V and M at the first end of each member, a reaction for each way that a support or its spring holds
/// Equations  three of each node with members; of each release that the force there is none
int n_self_stresses(const femoop::Model& model);
