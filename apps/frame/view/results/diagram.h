#pragma once

#include "apps/frame/view/results/solved_case.h"
#include "apps/frame/view/sketch/scene.h"

namespace frame {

/// One kind of section force, drawn along every member.
struct Diagram {
    femoop::MemberComponent component = femoop::MemberComponent::Mz;
    double largest = 0.0;         ///< absolute value in the structure
    double pixels_per_unit = 0.0; ///< of the ordinates

    bool is_zero() const { return pixels_per_unit == 0.0; }
};

/// The diagram at a height that suits the members and the panel; it is the largest value of `scaled_by` that would get
/// it, unless the diagram would become many times as high.
Diagram make_diagram(const Scene& scene, const SolvedCase& solved, const SolvedCase& scaled_by,
                     femoop::MemberComponent component, ui::Size panel);

/// Filled and hatched ordinates along all members with values at ends, jumps and extremes, signs where the side alone
/// does not tell them. In trusses N is a band as broad as the force is large.
///
/// Sides  N, V, T   positive on the upper side of the member (in plane models; +y' in space, Vz on +z')
///        M         on the side that it stretches, or on the other (ViewOptions::moment_side)
void draw_diagram(const Scene& scene, const SolvedCase& solved, const Diagram& diagram);

ui::Role role_of(femoop::MemberComponent component);
ui::Measure measure_of(femoop::MemberComponent component);
bool is_moment(femoop::MemberComponent component); ///< bending, not torsion

} // namespace frame
