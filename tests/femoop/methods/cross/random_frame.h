#pragma once

#include "femoop/model/model.h"

/// A continuous beam or a plane frame of orthogonal and inclined members made at random, stable in every case: members
/// of different EI, Timoshenko and semi-rigid ones, hinges, overhangs, springs, settlements, heat and loads of every
/// kind.
femoop::Model random_beam(unsigned seed);
femoop::Model random_frame(unsigned seed); ///< with sways
