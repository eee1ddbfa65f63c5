#include "apps/drawing/results/locked_scale.h"

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/results/deformed.h"
#include "apps/drawing/results/solved_case.h"
#include "femoop/result/components.h"

#include <algorithm>
#include <cstddef>

namespace drawing {

std::optional<LockedScale> locked_scale(const femoop::Model& model, const femoop::Results& results, femoop::CaseId id)
{
    const std::optional<SolvedCase> solved = solved_case(results, id);
    if (!solved) return std::nullopt;
    const double size = shape_of(model).size;
    LockedScale locked{.load_case = id, .displacement = largest_displacement(*solved).value};
    for (const femoop::MemberComponent component : femoop::section_force_components(model.analysis))
        locked.largest[static_cast<std::size_t>(component)] = largest_value(*solved, component, size);
    return locked;
}

double scaling_value(double locked, double now)
{
    constexpr double most_growth = 2.5;
    return locked > 0.0 ? std::max(locked, now / most_growth) : now;
}

} // namespace drawing
