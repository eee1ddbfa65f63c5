#include "apps/plane/session/look.h"

#include "ui/text/language_manner.h"

namespace plane {

bool needs_results(const Look& look)
{
    if (look.modes) return false;
    return look.deformed || look.principal || look.trajectories || look.vectors || look.error || look.reactions ||
           look.field || !look.readings.are_none();
}

bool needs_mesh(const Look& look) { return look.mesh || look.modes || needs_results(look); }

PlateOptions options_of(const Look& look, std::size_t load_case)
{
    PlateOptions options;
    options.show.set = {PlateShow::Geometry};
    const auto show = [&](bool is_on, PlateShow item) {
        if (is_on) options.show.set.insert(item);
    };
    show(look.regions, PlateShow::Regions);
    show(look.supports, PlateShow::Supports);
    show(look.loads, PlateShow::Loads);
    show(look.values, PlateShow::Values);
    show(look.names, PlateShow::Names);
    show(look.legend, PlateShow::Legend);
    show(look.mesh, PlateShow::Mesh);
    const bool has_results = !look.modes;
    show(has_results && look.deformed, PlateShow::Deformed);
    show(has_results && look.principal, PlateShow::Principal);
    show(has_results && look.trajectories, PlateShow::Trajectories);
    show(has_results && look.vectors, PlateShow::Vectors);
    show(has_results && look.error, PlateShow::Error);
    show(has_results && look.reactions, PlateShow::Reactions);
    if (has_results && look.field)
        options.show.fields = {{*look.field, look.lines ? FieldStyle::Contours : FieldStyle::Bands}};
    for (const FlatPoint& at : look.readings.probes) options.probes.emplace_back(at.x, at.y);
    for (const auto& [start, end] : look.readings.cuts) options.cuts.push_back({{start.x, start.y}, {end.x, end.y}});
    if (look.circle) options.circle = look.readings.told_probe();
    if (look.element_values) options.reading = femoop::plane::StressReading::Element;
    if (look.range && look.field == look.range->component) options.range = {look.range->low, look.range->high};
    options.load_case = femoop::CaseId(load_case);
    options.mode = look.mode;
    options.is_beside = look.beside;
    options.theme = look.theme;
    options.tr = look.tr;
    options.units = look.units;
    options.unit_choices = look.unit_choices;
    options.numbers = look.numbers;
    options.numbers.mark = ui::decimal_mark(look.tr.language());
    return options;
}

} // namespace plane
