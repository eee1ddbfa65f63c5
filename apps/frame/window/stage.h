#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "apps/frame/window/application.h"
#include "ui/app/headless.h"
#include "ui/context/offscreen.h"
#include "ui/scenario/player.h"

namespace frame {

/// The frame app as scenarios see it, without a screen. What can be expected of it: expectation.h.
///
///     places      node B | member AB 50% | member AB 2.5 | (2, 0) model point | pixel 400 300
///     arguments   file.open, file.save, file.export, file.export_table take a path; template.VERB and section.VERB set
///                 a typical structure and a section that are being made
class OffscreenStage final : public ui::Stage {
public:
    using KeepPicture = std::function<void(std::string_view name, const ui::Pixels&, Application&)>;

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

/// Plays a script to its end; `film` is given every frame. \throws ui::ScenarioError
void play(std::string_view script, ui::Offscreen& context, Application& application,
          const OffscreenStage::KeepPicture& keep, const ui::Film& film = {});

} // namespace frame
