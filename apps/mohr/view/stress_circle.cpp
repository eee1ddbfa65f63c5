#include "apps/mohr/view/stress_circle.h"

#include <algorithm>

#include "apps/mohr/view/circle_picture.h"

namespace mohr {

namespace fm = femoop::mohr;

namespace {

Document stress_document()
{
    Document document;
    document.subject = Subject::PlaneStress;
    return document;
}

Solution solution_of(const StressPoint& point, fm::ShearRule rule)
{
    Solution s;
    s.state = fm::plane_state(fm::Kind::PlaneStress, point.state.x, point.state.y, point.state.xy);
    s.unit = point.unit;
    s.rule = rule;
    static_cast<fm::PointResults&>(s) = fm::point_results({.state = s.state, .rule = rule});
    s.space = fm::SpaceState{.x = point.state.x, .y = point.state.y, .z = point.third, .xy = point.state.xy};
    s.space_principal = fm::principal(*s.space);
    return s;
}

} // namespace

Frame frame_of(const StressPoint& point)
{
    Frame frame = fitting_frame(stress_document(), solution_of(point, fm::ShearRule::ClockwiseUp), Content::Circles);
    frame.low = std::min(frame.low, point.third);
    frame.high = std::max(frame.high, point.third);
    const auto& [centre, radius] = fm::circle(point.state);
    const double low = std::min(centre - radius, point.third), high = std::max(centre + radius, point.third);
    frame.reach = std::max(frame.reach, 0.5 * (high - low));
    return frame;
}

Frame united(const Frame& a, const Frame& b)
{
    return {std::min(a.low, b.low), std::max(a.high, b.high), std::max(a.reach, b.reach),
            std::max(a.largest, b.largest)};
}

void draw_stress_circle(ui::Painter& painter, const StressPoint& point, const Look& look, const Frame& frame,
                        const ui::Box& box)
{
    const Document document = stress_document();
    const Solution solution = solution_of(point, look.rule);
    Look without_plane = look;
    without_plane.plane = false;
    Drawn not_held;
    draw_circle(painter, {document, solution, without_plane, frame}, box, not_held);
}

} // namespace mohr
