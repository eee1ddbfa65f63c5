#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "femoop/model/dof.h"
#include "femoop/model/expected.h"
#include "femoop/model/ids.h"
#include "femoop/result/results.h"

namespace femoop {

/// A value and the load case or combination that makes it; of equal ones the first.
struct Governing {
    double value = 0.0;
    CaseId load_case;
};
struct GoverningRange {
    Governing max, min;
};

/// Of what `value(i)` is in the i-th of the cases. \pre there is one
template <class Value> GoverningRange governing_range(const std::vector<CaseId>& cases, const Value& value)
{
    GoverningRange range;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const double here = value(i);
        if (i == 0 || here > range.max.value) range.max = {here, cases[i]};
        if (i == 0 || here < range.min.value) range.min = {here, cases[i]};
    }
    return range;
}

/// The same along a member: the place too.
struct GoverningExtreme {
    double value = 0.0;
    CaseId load_case;
    double x = 0.0; ///< from the member's first end
};
struct GoverningExtremes {
    GoverningExtreme max, min;
};

/// A place along a member and the range of every component asked for there.
struct EnvelopeStation {
    double x = 0.0;
    Side side = Side::After;
    std::vector<GoverningRange> ranges;
};

/// Largest and smallest of every result over several load cases and combinations, with the one that governs.
///
/// Accuracy  each case's own exact extremes are compared; stations are the load points of all cases and evenly spaced
class Envelope {
public:
    explicit Envelope(Results results); ///< over all load cases and combinations
    /// \throws std::invalid_argument for an empty list
    Envelope(Results results, std::vector<CaseId> cases);

    const std::vector<CaseId>& cases() const { return cases_; }
    GoverningRange displacement(NodeId node, Dof dof) const; ///< global axes
    GoverningRange reaction(NodeId node, Dof dof) const;     ///< global axes
    GoverningExtremes extremes(MemberId member, MemberComponent component) const;
    /// At a place along a member, where it jumps on the side that is asked for.
    GoverningRange at(MemberId member, MemberComponent component, double x, Side side = Side::After) const;

    /// `n` evenly spaced stations and the load points of every case; a jump in any case gives two at one x.
    std::vector<EnvelopeStation> stations(MemberId member, const std::vector<MemberComponent>& components,
                                          std::size_t n) const;

private:
    template <class Value> GoverningRange range(const Value& value) const;

    Results results_;
    std::vector<CaseId> cases_;
};

} // namespace femoop
