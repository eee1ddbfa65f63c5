#pragma once

#include "apps/drawing/cut.h"
#include "apps/drawing/results/envelope_band.h"
#include "apps/drawing/results/ordinates.h"
#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/model/moving_load.h"

#include <vector>

namespace drawing {

/// One kind of section force, drawn along every member.
struct Diagram {
    femoop::MemberComponent component = femoop::MemberComponent::Mz;
    double largest = 0.0;         ///< absolute value in the structure
    double pixels_per_unit = 0.0; ///< of the ordinates

    bool is_zero() const { return pixels_per_unit == 0.0; }
};

/// The number of the results at a section; at the ends it stays with them where the member becomes longer.
femoop::MovingEffect number_at_section(const Cut& cut, femoop::MemberComponent component, double length);

/// The number of the results that is a member's value at a place. The greater extreme between its ends is asked for as
/// such: it stays the extreme where loads move.
femoop::MovingEffect number_on_diagram(femoop::MemberId id, const femoop::Curve& curve,
                                       femoop::MemberComponent component, double x, double value);

/// The diagram at a height that suits the members and the panel; where the scale is locked the largest value of then
/// would get it, unless the diagram would become many times as high.
Diagram make_diagram(const Scene& scene, const SolvedCase& solved, femoop::MemberComponent component, ui::Size panel);
/// \param largest  absolute value in the structure
Diagram make_diagram(const Scene& scene, femoop::MemberComponent component, double largest, ui::Size panel);

/// Filled and hatched ordinates along all members with values at ends, jumps and extremes, signs where the side alone
/// does not tell them. In trusses N is a band as broad as the force is large.
///
/// Sides  N, V, T   positive on the upper side of the member (in plane models; +y' in space, Vz on +z')
///        M         on the side that it stretches, or on the other (DrawOptions::moment_side)
void draw_diagram(const Scene& scene, const SolvedCase& solved, const Diagram& diagram);

/// Marks the section of a force that is asked for: its ordinate, and its value where the diagram has not written it.
/// \pre the effect is a section force with a place, of the diagram's component
void mark_effect(const Scene& scene, const SolvedCase& solved, const Diagram& diagram,
                 const femoop::MovingEffect& effect);

/// The members of a former structure that lie elsewhere now, or are gone, faint: what its diagrams stand on.
void draw_reference_members(const Scene& former, const Scene& present);

/// The outlines of the diagram alone, faint and without values: a former solution behind the present one. The scene is
/// that of the former structure. \param part  of the diagram's scale, 1 or `part_of_scale`
void draw_reference(const Scene& scene, const SolvedCase& solved, const Diagram& diagram, double part);

/// A former value that is much larger than the present one is drawn to a part of its scale, so that this one is still
/// read: the part's denominator, one of 1, 2, 5, 10, 20 .. \pre present > 0
int part_of_scale(double former, double present);

/// The largest and the least value along every member, as a band, with the extremes of each member.
void draw_envelope(const Scene& scene, const EnvelopePicture& envelope, const Diagram& diagram);

/// How high the largest ordinate is drawn, as a share of the room that the panel has [logical pixels].
double ordinate_height(const Scene& scene, double share, ui::Size panel);

ui::Role role_of(femoop::MemberComponent component);
ui::Measure measure_of(femoop::MemberComponent component);

} // namespace drawing
