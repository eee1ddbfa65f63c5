#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "apps/euler/window/application.h"
#include "ui/app/headless.h"
#include "ui/context/offscreen.h"
#include "ui/scenario/player.h"

namespace euler {

/// The stepper as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      vertex v1 | edge v1 v2 | half-edge v1 v2 | face f1 | (2, 0) | pixel 400 300; of one solid of
///     several: s2 face f1 arguments   file.open, file.save, file.export take a path; step.go_to a number; step.apply a
///     line of a script;
///                 operator.choose an argument as it is typed
class OffscreenStage final : public ui::Stage {
public:
    using KeepPicture = std::function<void(std::string_view name, const ui::Pixels&)>;

    OffscreenStage(ui::Offscreen& context, Application& application, KeepPicture keep)
        : context_(context), application_(application), keep_(std::move(keep))
    {}

    Sought find(std::string_view place) override;
    std::optional<std::string> run_command(std::string_view id, std::string_view argument) override;
    std::optional<std::string> take_picture(std::string_view name) override;
    std::optional<std::string> expect(std::string_view words) override;

private:
    ui::Offscreen& context_;
    Application& application_;
    KeepPicture keep_;
};

} // namespace euler
