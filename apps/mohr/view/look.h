#pragma once

#include "femoop/methods/mohr/plane_state.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/language_manner.h"
#include "ui/text/number_format.h"

namespace mohr {

/// How a state is drawn.
struct Look {
    femoop::mohr::ShearRule rule = femoop::mohr::ShearRule::ClockwiseUp;
    bool pole = true;        ///< and its lines
    bool plane = true;       ///< the plane that is looked at
    bool special = true;     ///< principal and largest-shear elements beside the element
    bool space = true;       ///< circles of the third direction, in the plane
    bool envelope = true;    ///< of the criterion, and the circle at failure
    bool both_rules = false; ///< of the shear's sign: the circle twice
    ui::ThemeName theme = ui::ThemeName::Light;
    double size = 1.0; ///< > 0, of type, lines and symbols; 1 is the theme's own
    ui::Catalogue tr;

    ui::Theme full_theme() const { return ui::Theme(theme).scaled(size); }
    ui::NumberFormat format() const { return {4, ui::decimal_mark(tr.language())}; }
    std::string number(double value) const { return ui::with_minus_signs(ui::number_text(value, format())); }
};

} // namespace mohr
