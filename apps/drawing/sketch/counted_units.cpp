#include "apps/drawing/sketch/counted_units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "apps/drawing/sketch/scene.h"
#include "femoop/model/quantity/in_units.h"

namespace drawing {

namespace {

/// Pairs of base units, those first that have most in common with the present ones.
std::vector<femoop::Units> base_units_from(const femoop::Units& present)
{
    std::vector<femoop::Units> all;
    for (int length = 0; length <= static_cast<int>(femoop::LengthUnit::ft); ++length)
        for (int force = 0; force <= static_cast<int>(femoop::ForceUnit::kgf); ++force)
            all.push_back({static_cast<femoop::LengthUnit>(length), static_cast<femoop::ForceUnit>(force)});
    const auto differences = [&](const femoop::Units& units) {
        return (units.length != present.length ? 1 : 0) + (units.force != present.force ? 1 : 0);
    };
    std::ranges::stable_sort(all, {}, differences);
    return all;
}

/// What was chosen for these measures is what follows from the base units.
bool follow(const femoop::Units& units, const DrawOptions& options, std::span<const ui::Measure> measures)
{
    constexpr double rounding = 1e-9;
    femoop::Model nothing;
    nothing.units = units;
    DrawOptions of_file = options;
    of_file.units = ui::UnitSystem::File;
    const ui::DisplayUnits shown = display_units(nothing, of_file);
    return std::ranges::all_of(measures, [&](ui::Measure measure) {
        return options.unit_choices.of(measure).empty() || std::abs(shown.unit(measure).factor - 1.0) < rounding;
    });
}

} // namespace

std::optional<femoop::Units> base_units_of(std::span<const ui::Measure> measures, const femoop::Units& present,
                                           const DrawOptions& options)
{
    for (const femoop::Units& units : base_units_from(present))
        if (follow(units, options, measures)) return units;
    return std::nullopt;
}

CountedUnits counted_units(const femoop::Model& model, const DrawOptions& options, ui::Measure result)
{
    const CountedUnits usual = counted_units(model, options);
    const std::array measures{result, ui::Measure::Length, ui::Measure::Force};
    const auto units = base_units_of(measures, usual.units, options);
    if (!units) return usual;
    return {*units, femoop::metres(model.units.length) / femoop::metres(units->length),
            femoop::newtons(model.units.force) / femoop::newtons(units->force)};
}

CountedUnits counted_units(const femoop::Model& model, const DrawOptions& options)
{
    const ui::DisplayUnits shown = display_units(model, options);
    const ui::DisplayUnit length = shown.unit(ui::Measure::Length), force = shown.unit(ui::Measure::Force);
    const auto length_unit = femoop::find_length_unit(length.name);
    const auto force_unit = femoop::find_force_unit(force.name);
    if (!length_unit || !force_unit) return {model.units};
    return {{*length_unit, *force_unit}, length.factor, force.factor};
}

femoop::Model counted_in(const CountedUnits& units, femoop::Model model)
{
    if (units.units == model.units) return model;
    model.extra.clear();
    return femoop::in_units(model, units.units);
}

} // namespace drawing
