#pragma once

#include <string>

#include "apps/mohr/view/scene.h"
#include "femoop/methods/mohr/plane_state.h"

namespace mohr {

/// The stress at a point of a body, whose circle stands beside another picture.
struct StressPoint {
    femoop::mohr::PlaneState state; ///< tension positive; in `unit`
    double third = 0.0;             ///< principal stress across the plane
    std::string unit;               ///< as it is printed: "N/mm²"
};

/// The scales that hold its circles, and those that hold the circles of two.
Frame frame_of(const StressPoint& point);
Frame united(const Frame& a, const Frame& b);

/// Its circle, with those of the third direction where the look has them. The plane that is looked at is left out.
void draw_stress_circle(ui::Painter& painter, const StressPoint& point, const Look& look, const Frame& frame,
                        const ui::Box& box);

} // namespace mohr
