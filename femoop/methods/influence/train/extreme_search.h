#pragma once

#include <functional>
#include <vector>

#include "femoop/methods/influence/train/section_lines.h"
#include "femoop/methods/influence/train/train_search.h"

namespace femoop::influence {

/// The worst of all sections of a member and all positions of a train together.
struct WorstSection {
    std::vector<double> sections; ///< along the member, ascending: all that have this value; a stretch by its two ends
    Placing placing;              ///< the first forwards of those, else the first reversed
    double section = 0.0;         ///< of the sections, that which the placing is worst for
    double inside = 0.0; ///< the same, at an end of the member by a hair within it where the value is the limit there
};

/// What stays beside a train, whose effect counts times a factor.
struct Permanent {
    std::function<double(double x)> value; ///< at a jump of it the worse side
    std::vector<double> breaks;            ///< along the member
    double factor = 1.0;                   ///< of the train, not 0
};

/// How long `worst_section` takes for both extremes, known before it is called: in pieces of polynomials that are gone
/// through, of which some 4e5 take a second. A dozen axles at fixed distances alone cost next to nothing.
/// \param n_members  of the path
double search_size(const MovingTrain& train, std::size_t n_members);

/// So near to an end of a member, within it, lies what counts as the limit there: far less than one section from another,
/// but no less than the shortest piece of a path.
double hair_within(double member_length, double path_length);

/// Between two axles a force depends on the section linearly, so that axles alone are worst with one of them at the
/// section, or at an end of the member: exact roots of one polynomial in x. With a uniform load, single forces or
/// spacings that vary the exact largest value at a section is a piecewise smooth function of x. Between sections it is
/// bounded from above by how sharply it bends; its peaks are closed in upon from both sides.
///
/// \param ends   of the path's members: 0, .., L
/// Accuracy  values to 1e-10 of the largest, places to 1e-8 of the member's length
WorstSection worst_section(const SectionLines& lines, const std::vector<double>& ends, const MovingTrain& train,
                           ExtremeKind kind, const Permanent* permanent = nullptr);

} // namespace femoop::influence
