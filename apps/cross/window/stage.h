#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/cross/window/application.h"
#include "apps/cross/window/expectation.h"
#include "ui/app/stage.h"

namespace cross {

/// Moment distribution as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      joint B | joint B in structure | ... deformed | ... moments | ... sheet | node B |
///                 load 1 | end right | at 2 0 | pixel 400 300 |
///                 cell factor BA | cell balance 1 BA (cell_names.h)
///     arguments   file.open, file.save, file.export take a path; work.balance a joint; work.jump a number of turns;
///                 work.sheet 0 for the loads, then the sways; method.case a name; method.digits, method.tolerance;
///                 exercise.new a difficulty and a number; exercise.fill how many cells get what belongs there
class OffscreenStage final : public ui::OffscreenStage<Application> {
public:
    using ui::OffscreenStage<Application>::OffscreenStage;

    Found locate(std::string_view place) override;
};

} // namespace cross
