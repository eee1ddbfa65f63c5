#include "apps/frame/influence/candidate_position.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace frame {

namespace {

using femoop::influence::SearchProof;
using Kind = CandidatePosition::Kind;

// The search looks at a reversed train as in a mirror, where the sides of a break change places.
Kind kind_of(const SearchProof::Entry& entry)
{
    using Found = femoop::influence::PositionFunction::Candidate::Kind;
    if (entry.candidate.kind == Found::Root) return Kind::Root;
    return (entry.candidate.kind == Found::BreakBefore) != entry.reversed ? Kind::BreakBefore : Kind::BreakAfter;
}

bool is_same_break(const CandidatePosition& a, const CandidatePosition& b)
{
    return a.kind != Kind::Root && b.kind != Kind::Root && a.reversed == b.reversed && a.position == b.position;
}

double largest(const std::vector<CandidatePosition>& all)
{
    double largest = 0.0;
    for (const CandidatePosition& one : all) largest = std::max(largest, std::abs(one.value));
    return largest;
}

// Where the effect does not jump both sides of a break are one.
std::vector<CandidatePosition> with_whole_breaks(const std::vector<CandidatePosition>& all)
{
    constexpr double rounding = 1e-9;
    const double near = rounding * largest(all);
    std::vector<CandidatePosition> whole;
    for (const CandidatePosition& one : all) {
        const bool is_other_side = !whole.empty() && is_same_break(whole.back(), one) &&
                                   std::abs(whole.back().value - one.value) <= near;
        if (is_other_side) whole.back().kind = Kind::Break;
        else whole.push_back(one);
    }
    return whole;
}

} // namespace

std::vector<CandidatePosition> candidate_positions(const femoop::influence::TrainSearch& search,
                                                   femoop::ExtremeKind kind)
{
    const SearchProof proof = search.proof(kind);
    std::vector<CandidatePosition> all;
    for (const SearchProof::Entry& entry : proof.entries)
        all.push_back({entry.candidate.x, entry.reversed, proof.sum(entry), kind_of(entry)});
    std::ranges::stable_sort(all, {}, [](const CandidatePosition& one) {
        return std::tuple(one.reversed, one.position, one.kind == Kind::BreakAfter);
    });
    return with_whole_breaks(all);
}

} // namespace frame
