#pragma once

#include <cstddef>
#include <span>

#include "apps/drawing/draw_input.h"
#include "apps/frame/document/drawing_names.h"
#include "ui/text/catalogue.h"

namespace frame {

/// One of the motions of a structure that cannot be solved, with its sentence as the app says it. \pre shown <
/// all.size()
drawing::MotionChoice motion_choice(std::span<const femoop::Mechanism> all, std::size_t shown, const ui::Catalogue& tr);

} // namespace frame
