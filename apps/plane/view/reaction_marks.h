#pragma once

#include <string>
#include <vector>

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// The reactions of a case as a table and a picture say them.
struct ReactionTable {
    struct Row {
        std::string name;       ///< "Curve wall", "loads", "sum"; to be read
        std::string fx, fy, mz; ///< with their units; mz about the middle of the support, of sums about the origin
    };
    std::vector<Row> supports; ///< each as its resultant
    Row loads, reactions, sum;
};
/// Around an axis radial forces sum to nothing that could be told: fx and mz are left empty.
ReactionTable reaction_table(const femoop::plane::PlaneCase& result, const ui::DisplayUnits& units,
                             const ui::Catalogue& tr);

/// "ΣFx = −200 + 200 = 0 N": loads, reactions and their sum, one sentence each for x, y and moments about the origin.
std::vector<std::string> equilibrium_lines(const femoop::plane::PlaneCase& result, const ui::DisplayUnits& units);

/// The resultant of each support as arrows along x and y at its middle, with its moment about there.
void draw_reactions(const PlateScene& scene);

} // namespace plane
