#include "apps/cross/document/document.h"

#include "femoop/methods/cross/symmetry.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/memory_footprint.h"

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
    if (method.extent == fc::Extent::Whole || document.pupil) return whole;
    try {
        return fc::by_halves(document.model, whole);
    } catch (const femoop::ModelError&) {
        return whole; // the solution says why
    }
}

bool is_same_task(const Document& a, const Document& b)
{
    return a.method == b.method && a.pupil == b.pupil && a.model == b.model;
}

std::size_t memory_footprint(const Document& document)
{
    constexpr std::size_t one_turn = 64;
    std::size_t bytes = sizeof(Document) + femoop::memory_footprint(document.model) +
                        document.method.joints.size() * sizeof(std::string);
    for (const TurnTree& turn_tree : document.plays)
        bytes += sizeof(TurnTree) + (turn_tree.length() + turn_tree.n_ahead()) * one_turn;
    if (document.pupil) bytes += document.pupil->written.size() * sizeof(std::string);
    return bytes;
}

} // namespace cross
