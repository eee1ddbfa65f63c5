#include "apps/cli/asked_units.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "apps/cli/argument.h"
#include "apps/drawing/sketch/scene.h"

namespace cli {

namespace {

void choose(ui::UnitChoices& choices, const std::string& word, const ui::Catalogue& tr)
{
    const std::size_t sign = std::min(word.find('='), word.size());
    const std::string quantity = word.substr(0, sign), unit = word.substr(std::min(sign + 1, word.size()));
    if (!unit.empty() && choices.choose(quantity, unit)) return;
    std::vector<std::string> quantities, units;
    for (const ui::QuantityUnits& known : ui::chosen_quantities()) {
        quantities.emplace_back(known.code);
        if (known.code == quantity) units.assign(known.names.begin(), known.names.end());
    }
    if (units.empty()) throw unknown_choice("--unit", quantity, quantities, tr);
    throw unknown_choice("--unit " + quantity, unit, units, tr);
}

} // namespace

void AskedUnits::declare(CLI::App& app, const ui::Catalogue& tr)
{
    app.add_option(
           "--unit", words_,
           tr("units of single quantities, separated by commas, such as moment=kN*cm,length=cm; the others' follow "
              "from the file's"))
        ->option_text("QUANTITY=UNIT");
}

UsageError units_of_file(std::string_view option, const ui::Catalogue& tr)
{
    return UsageError(tr("{option} counts in the units of the file; leave out --unit, or write the file in other units "
                         "with cremona convert --units",
                         {{"option", option}}));
}

ui::UnitChoices AskedUnits::choices(const ui::Catalogue& tr) const
{
    ui::UnitChoices choices;
    for (const std::string& words : words_)
        for (const std::string& word : comma_list(words)) choose(choices, word, tr);
    return choices;
}

femoop::ResultUnits AskedUnits::of_results(const femoop::Model& model, const ui::Catalogue& tr) const
{
    drawing::DrawOptions options;
    options.units = ui::UnitSystem::File;
    options.unit_choices = choices(tr);
    const ui::DisplayUnits units = drawing::display_units(model, options);
    const auto unit = [&](ui::Measure measure) {
        const ui::DisplayUnit found = units.unit(measure);
        return femoop::PrintedUnit{found.name, found.factor};
    };
    return {.length = unit(ui::Measure::Length),
            .displacement = unit(ui::Measure::Displacement),
            .rotation = unit(ui::Measure::Rotation),
            .force = unit(ui::Measure::Force),
            .moment = unit(ui::Measure::Moment)};
}

} // namespace cli
