#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "ui/command/menu_builder.h"
#include "ui/text/display_units.h"

/// The commands for what numbers are shown in, of the apps whose numbers have units.
namespace ui::standard {

inline constexpr std::array unit_systems{
    Choice<UnitSystem>{UnitSystem::File, "view.units.file", translatable("Units of the file")},
    Choice<UnitSystem>{UnitSystem::Si, "view.units.si", translatable("N, m, MPa")},
    Choice<UnitSystem>{UnitSystem::KnM, "view.units.kn-m", translatable("kN, m, MPa")},
    Choice<UnitSystem>{UnitSystem::KnCm, "view.units.kn-cm", translatable("kN, cm")},
    Choice<UnitSystem>{UnitSystem::Us, "view.units.us", translatable("kip, ft, ksi")},
};

inline constexpr std::array digits{
    Choice<int>{3, "view.digits.3", translatable("3 digits")},
    Choice<int>{4, "view.digits.4", translatable("4 digits")},
    Choice<int>{5, "view.digits.5", translatable("5 digits")},
    Choice<int>{6, "view.digits.6", translatable("6 digits")},
    Choice<int>{8, "view.digits.8", translatable("8 digits")},
};

/// \param view  where the choices of a session are kept: `units`, `unit_choices`, `numbers`
/// \param open_window  opens the window in which units are chosen one by one (ui/widgets/unit_window.h)
template <class Workspace, class View, class OpenWindow>
void add_units(CommandTable<Workspace>& table, View view, OpenWindow open_window)
{
    MenuBuilder<Workspace> menu(table, translatable("Units"));
    menu.choices(
        unit_systems, [](const Workspace& workspace) { return workspace.session.units().system(); },
        [view](Workspace& workspace, UnitSystem system) { view(workspace).units = system; });
    menu.step({"view.units.quantities", translatable("Quantity by quantity…"), {{Key::U, shift}}}, open_window);
    // "moment kN·cm"; the quantity alone: the unit of the system again.
    table.with_argument("view.unit", [view](Workspace& workspace, const Argument& argument) -> Reason {
        const std::string_view text = argument.text, quantity = text.substr(0, text.find(' '));
        const std::string_view unit = text.substr(std::min(quantity.size() + 1, text.size()));
        if (view(workspace).unit_choices.choose(quantity, unit)) return std::nullopt;
        return translatable("there is no such quantity, or it has no such unit");
    });
    menu.choices(
        digits, [view](auto& workspace) -> auto& { return view(workspace).numbers.digits; });
}

} // namespace ui::standard
