#pragma once

#include "apps/plane/view/plate_picture.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"

namespace plane {

/// How a drawing is looked at.
struct Look {
    bool regions = true;
    bool supports = true;
    bool loads = true;
    bool values = true;
    bool names = false;
    bool legend = true;
    ui::ThemeName theme = ui::ThemeName::Light;
    ui::Catalogue tr;
};

/// What of a drawing its look shows, of a load case.
PlateOptions options_of(const Look& look, std::size_t load_case);

} // namespace plane
