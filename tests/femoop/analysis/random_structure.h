#pragma once

#include <array>
#include <random>

#include "femoop/model/model.h"

/// A stable structure of a model, made at random: skew members of several kinds, tapers, releases, springs, hinges, offsets,
/// inclined supports, a foundation, and two load cases "P" and "Q" with loads of every kind.
femoop::Model random_structure(femoop::AnalysisKind kind, unsigned seed);

/// Gives its tapered members the first section instead.
void make_prismatic(femoop::Model& model);

/// All five models.
inline constexpr std::array every_model{femoop::AnalysisKind::Truss2d, femoop::AnalysisKind::Frame2d,
                                        femoop::AnalysisKind::Grillage, femoop::AnalysisKind::Truss3d,
                                        femoop::AnalysisKind::Frame3d};
