#include "apps/drawing/sketch/scene.h"

#include <algorithm>
#include <array>
#include <optional>

namespace drawing {

namespace {

bool is_of_forces_or_lengths(ui::Measure measure)
{
    constexpr std::array all{ui::Measure::Length, ui::Measure::Force, ui::Measure::Moment, ui::Measure::ForcePerLength,
                             ui::Measure::MomentPerLength};
    return std::ranges::find(all, measure) != all.end();
}

} // namespace

std::string with_minus(const std::string& text) { return text.starts_with('-') ? "−" + text.substr(1) : text; }

std::string Scene::number(double value, ui::Measure measure) const { return with_minus(units.number(value, measure)); }

std::string Scene::text(double value, ui::Measure measure) const
{
    if (units_stand == UnitsStand::InTitle && is_of_forces_or_lengths(measure)) return number(value, measure);
    return with_minus(units.text(value, measure));
}

bool Scene::explains() const
{
    for (const Show item :
         {Show::N, Show::V, Show::M, Show::T, Show::Vy, Show::Vz, Show::My, Show::Mz, Show::Deformed, Show::Thrust})
        if (shows(item)) return false;
    return shows(Show::Values);
}

const LockedScale* Scene::locked_scale() const
{
    const std::optional<LockedScale>& locked = state.locked_scale;
    const bool serves = locked && !options.is_envelope && locked->load_case == options.load_case;
    return serves ? &*locked : nullptr;
}

ui::DisplayUnits display_units(const femoop::Model& model, const DrawOptions& options)
{
    const femoop::Units& units = model.units;
    const ui::BaseUnits base{.length = std::string(femoop::name(units.length)),
                             .metres = femoop::metres(units.length),
                             .force = std::string(femoop::name(units.force)),
                             .newtons = femoop::newtons(units.force)};
    return {options.units.value_or(ui::preferred_system(base)), base, options.numbers, options.unit_choices};
}

} // namespace drawing
