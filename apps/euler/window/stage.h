#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/euler/window/application.h"
#include "apps/euler/window/expectation.h"
#include "ui/app/stage.h"

namespace euler {

/// The stepper as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      vertex v1 | edge v1 v2 | half-edge v1 v2 | face f1 | (2, 0) | pixel 400 300;
///                 of one solid of several: s2 face f1
///     arguments   file.open, file.save, file.export take a path; step.go_to a number; step.apply a line of a script;
///                 operator.choose an argument as it is typed
class OffscreenStage final : public ui::OffscreenStage<Application> {
public:
    using ui::OffscreenStage<Application>::OffscreenStage;

    Found locate(std::string_view place) override;
};

} // namespace euler
