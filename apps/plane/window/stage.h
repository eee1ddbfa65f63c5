#pragma once

#include <string_view>

#include "apps/plane/window/application.h"
#include "apps/plane/window/expectation.h"
#include "ui/app/stage.h"

namespace plane {

/// The plane app as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      (30, 10) of the drawing | point A | pixel 400 300
///     arguments   file.open, file.save, file.export take a path; part.select "curve C1 and point A";
///                 part.set "thickness 12 mm"
class OffscreenStage final : public ui::OffscreenStage<Application> {
public:
    using ui::OffscreenStage<Application>::OffscreenStage;

    Found locate(std::string_view place) override;
};

} // namespace plane
