#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "apps/frame/window/application.h"
#include "apps/frame/window/expectation.h"
#include "ui/app/stage.h"

namespace frame {

/// The frame app as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      node B | member AB 50% | member AB 2.5 | (2, 0) model point | pixel 400 300
///     arguments   file.open, file.save, file.export, file.export_table take a path; template.VERB and section.VERB set
///                 a typical structure and a section that are being made; methods.VERB takes a path, and
///                 what the other program would get is written there
class OffscreenStage final : public ui::OffscreenStage<Application> {
public:
    using ui::OffscreenStage<Application>::OffscreenStage;

    Found locate(std::string_view place) override;
    std::optional<std::string> run_command(std::string_view id, std::string_view argument) override;
};

} // namespace frame
