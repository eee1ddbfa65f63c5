#include "apps/drawing/draw_input.h"

namespace drawing {

std::optional<femoop::CaseId> ReferenceResults::counterpart(const femoop::Model& present, femoop::CaseId shown) const
{
    if (load_case) return load_case;
    if (shown.index >= present.n_cases()) return std::nullopt; // all were deleted
    const bool is_same_place = shown.index < model.n_cases() && model.case_name(shown) == present.case_name(shown);
    return is_same_place ? shown : model.find_case(present.case_name(shown));
}

} // namespace drawing
