#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "apps/frame/window/application.h"
#include "ui/context/offscreen.h"
#include "ui/scenario/player.h"

namespace frame {

/// The frame app as scenarios see it, without a screen.
///
///     places        node B | member AB 50% | member AB 2.5 | (2, 0) model point | pixel 400 300 | TEXT of a widget: no
///     expectations  member AB M at 50% is -12.5 kN*m       within 4 digits
///                   undo "Change ..."   selection Node B   case ULS   problems 0   file portal.json
class OffscreenStage final : public ui::Stage {
public:
    using KeepPicture = std::function<void(std::string_view name, const ui::Pixels&, Application&)>;

    OffscreenStage(ui::Offscreen& context, Application& application, KeepPicture keep)
        : context_(context), application_(application), keep_(std::move(keep))
    {}

    std::optional<ui::PointerPlace> find(std::string_view place) override;
    std::optional<std::string> run_command(std::string_view id, std::string_view argument) override;
    std::optional<std::string> take_picture(std::string_view name) override;
    std::optional<std::string> expect(std::string_view words) override;

private:
    ui::Offscreen& context_;
    Application& application_;
    KeepPicture keep_;
};

/// Plays a script to its end. \throws ui::ScenarioError
void play(std::string_view script, ui::Offscreen& context, Application& application,
          const OffscreenStage::KeepPicture& keep);

} // namespace frame
