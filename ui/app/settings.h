#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ui/paint/geometry.h"
#include "ui/paint/theme.h"
#include "ui/text/catalogue.h"
#include "ui/text/display_units.h"

namespace ui {

/// How a person left an app, which is how it begins the next time. What nobody chose is absent.
struct Settings {
    static constexpr double smallest_side = 200.0, largest_side = 16384.0; ///< of a window [logical pixels]

    std::optional<ThemeName> theme{};
    std::optional<Language> language{};
    std::optional<UnitSystem> units{}; ///< absent: those that go with the document
    std::optional<UnitChoices> unit_choices{};
    std::optional<bool> has_panels{};
    std::optional<Size> window{};       ///< [logical pixels]
    std::optional<std::string> tools{}; ///< how the app's own tools are set, a line in its own words

    /// These, and of others what they lack.
    Settings or_else(const Settings& others) const;

    friend bool operator==(const Settings&, const Settings&) = default;
};

/// A line for each that is there: "theme dark", "window 1280 800".
std::string settings_text(const Settings& settings);
/// A line that is not understood, such as a later version's, counts for nothing.
Settings settings_of(std::string_view text);
/// Those that are kept in a file; none where there is no file.
Settings read_settings(const std::filesystem::path& file);

/// Tells what a person chose from what the command line asked for: that is of one run, until it is changed there.
class ChosenSettings {
public:
    ChosenSettings() = default;
    ChosenSettings(Settings kept, Settings asked_for) : chosen_(std::move(kept)), asked_for_(std::move(asked_for)) {}

    /// \returns what is to be kept of an app that is like this now
    const Settings& update(const Settings& now);

private:
    template <class Value> void update(std::optional<Value> Settings::*setting, const Settings& now);

    Settings chosen_, asked_for_;
};

/// An app's workspace begins as it was left: with its panels, or with the whole window for the picture, as on the
/// projector.
/// \pre theme and panels are there
template <class Workspace> void begin_as_left(Workspace& workspace, const Settings& settings)
{
    workspace.has_panels = *settings.has_panels;
    if constexpr (requires { workspace.take_up_tools(""); })
        if (settings.tools) workspace.take_up_tools(*settings.tools);
    if (!workspace.has_panels && *settings.theme == ThemeName::Projector) workspace.set_panels_visible(false);
}

} // namespace ui
