#pragma once

#include "topology/halfedge/ids.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

#include <set>

namespace euler {

/// How a solid is drawn.
struct Look {
    bool faces = true;
    bool hatching = true; ///< of faces that are seen from inside
    bool half_edges = true;
    std::set<topology::EntityKind> names{topology::EntityKind::Vertex,
                                         topology::EntityKind::Face}; ///< which are written
    double explosion = 0.0; ///< 0 to 1: how far the faces stand away from one another
    ui::ThemeName theme = ui::ThemeName::Light;
    double size = 1.0; ///< > 0, of type, lines and symbols; 1 is the theme's own
    ui::Catalogue tr;  ///< language of the words

    ui::Theme full_theme() const { return ui::Theme(theme).scaled(size); }
};

} // namespace euler
