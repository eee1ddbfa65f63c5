#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/mohr/window/application.h"
#include "apps/mohr/window/expectation.h"
#include "ui/app/stage.h"

namespace mohr {

/// Mohr's circle as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      face x | face y | plane | centre | first | second | third | arrow x | arrow y | arrow shear |
///                 turn | cursor | normal | fibre | circle (50, -40) | pixel 400 300
///     arguments   file.open, file.save, file.export take a path; state.set a name and a number: sigma_x 12 MPa, as the
///                 files' places count: 1 12 MPa; plane.turn degrees; plane.normal three numbers; state.principal
///                 three; construction.step a number; exercise.answer the question's number and the answer
class OffscreenStage final : public ui::OffscreenStage<Application> {
public:
    using ui::OffscreenStage<Application>::OffscreenStage;

    Found locate(std::string_view place) override;
};

} // namespace mohr
