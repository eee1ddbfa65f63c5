#pragma once

#include "apps/drawing/loads/load_stack.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/load/load_components.h"

namespace drawing {

/// All loads of the case that is shown: arrows with values, several on one member on top of one another, settlements,
/// temperatures and misfits. Self-weight is a line of the legend.
void draw_loads(const Scene& scene);

/// What the arrows of a case are measured by: the largest of each kind.
struct LargestLoads {
    double per_length = 0.0;
    double force = 0.0;
};

/// The parts of the above. Values are those of the file times the case's factor.

/// A component of a load on a member, with that factor in it.
struct ShownLoad {
    femoop::MemberId member;
    femoop::LoadComponent component;
    Part part;              ///< whose arrows are drawn, for the hand that pulls them
    bool is_repeat = false; ///< it goes on with the same value from a member whose value is written
};
void draw_line_load(const Scene& scene, const ShownLoad& load, const LargestLoads& largest, LoadStack& stack);
/// Of a point or an end of the member; one that acts where another does stands behind it.
/// \param points  those of the member that are drawn already
void draw_point_load(const Scene& scene, const ShownLoad& load, const LargestLoads& largest, const LoadStack& stack,
                     LoadStack& points);

struct LoadScale {
    LargestLoads largest;
    double factor = 1.0; ///< of the case in the combination
    Part load;           ///< as above
};
/// \param points  those of the node that are drawn already
void draw_node_load(const Scene& scene, const femoop::NodeLoad& load, const LoadScale& scale, LoadStack& points);
void draw_settlement(const Scene& scene, const femoop::Settlement& settlement, double factor);
void draw_temperature(const Scene& scene, femoop::MemberId member, const femoop::TemperatureLoad& load, double factor,
                      LoadStack& stack);
void draw_misfit(const Scene& scene, femoop::MemberId member, const femoop::Misfit& misfit, double factor);

} // namespace drawing
