#pragma once

#include "apps/drawing/loads/case_terms.h"
#include "apps/drawing/loads/load_stack.h"
#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// All loads of the case that is shown: arrows with values, several on one member on top of one another, settlements,
/// temperatures and misfits. Self-weight is a line of the legend.
void draw_loads(const Scene& scene);

/// The parts of the above. Values are those of the file times the case's factor.
struct LoadScale {
    LargestLoads largest;
    double factor = 1.0; ///< of the case in the combination
    Part load;           ///< whose arrows are drawn, for the hand that pulls them
};
void draw_line_load(const Scene& scene, femoop::MemberId member, const femoop::DistributedLoad& load,
                    const LoadScale& scale, LoadStack& stack);
void draw_point_load(const Scene& scene, femoop::MemberId member, const femoop::PointLoad& load, const LoadScale& scale,
                     const LoadStack& stack);
void draw_end_loads(const Scene& scene, femoop::MemberId member, const femoop::EndLoads& load, const LoadScale& scale);
void draw_node_load(const Scene& scene, const femoop::NodeLoad& load, const LoadScale& scale);
void draw_settlement(const Scene& scene, const femoop::Settlement& settlement, double factor);
void draw_temperature(const Scene& scene, femoop::MemberId member, const femoop::TemperatureLoad& load, double factor,
                      LoadStack& stack);
void draw_misfit(const Scene& scene, femoop::MemberId member, const femoop::Misfit& misfit, double factor);

} // namespace drawing
