#include "apps/cross/document/document.h"

#include <utility>

#include "femoop/methods/cross/symmetry.h"

namespace cross {

namespace fc = femoop::cross;

Document unworked(Document document)
{
    document.plays.clear();
    document.stage = 0;
    return document;
}

fc::Problem problem_of(const Document& document)
{
    const Method& method = document.method;
    fc::Problem whole = fc::problem_of(document.model, method.load_case, method.far_ends);
    const bool is_halved = method.extent == fc::Extent::Half && !document.pupil &&
                           !fc::why_not_by_halves(document.model, whole);
    return is_halved ? fc::by_halves(document.model, std::move(whole)) : whole;
}

bool is_same_task(const Document& a, const Document& b)
{
    return a.method == b.method && a.pupil == b.pupil && a.model == b.model;
}

} // namespace cross
