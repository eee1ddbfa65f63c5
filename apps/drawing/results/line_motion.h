#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/results/influence_picture.h"

namespace drawing {

inline constexpr std::array shares_of_piece{0.0, 0.25, 0.5, 0.75, 1.0}; ///< where a motion is looked at

/// The farthest that a place of the structure moves while the line is drawn by it; nothing where it is not drawn, since
/// the line would be flat beside its motion.
std::optional<double> drawn_motion(const InfluencePicture& picture);

/// What the line is drawn by, and where its motion is too large to be drawn that it is.
std::vector<std::string> motion_sentences(const femoop::Model& model, const InfluencePicture& picture,
                                          const ui::Catalogue& tr);

} // namespace drawing
