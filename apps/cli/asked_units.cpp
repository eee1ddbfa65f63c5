#include "apps/cli/asked_units.h"

#include <algorithm>
#include <charconv>

#include "apps/cli/argument.h"
#include "apps/drawing/sketch/counted_units.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/drawing/sketch/table_units.h"
#include "apps/plane/view/plate_picture.h"
#include "apps/plane/view/plate_scene.h"
#include "femoop/io/train/train_table.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/quantity/in_units.h"

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

void AskedUnits::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option(
            "--unit", words_,
            tr("units of single quantities, separated by commas, such as moment=kN*cm,length=cm; the others' follow "
               "from the file's"))
        .option_text("QUANTITY=UNIT");
}

UsageError units_of_file(std::string_view option, const ui::Catalogue& tr)
{
    return UsageError(tr("{option} counts in the units of the file; leave out --unit, or write the file in other units "
                         "with cremona convert --units",
                         {{"option", option}}));
}

std::string units_line(const std::vector<femoop::PrintedUnit>& units, const ui::Catalogue& tr)
{
    std::vector<std::string> names;
    std::string list;
    for (const femoop::PrintedUnit& unit : units) {
        if (std::ranges::find(names, unit.name) != names.end()) continue;
        list += (list.empty() ? "" : ", ") + unit.name;
        names.push_back(unit.name);
    }
    return tr("Units of the tables: {units}", {{"units", list}}) + "\n";
}

namespace {

bool is_bare_number(std::string_view text)
{
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stopped == end;
}

drawing::DrawOptions in_units_of_file(const ui::UnitChoices& choices)
{
    drawing::DrawOptions options;
    options.units = ui::UnitSystem::File;
    options.unit_choices = choices;
    return options;
}

/// "moment=kN·cm, displacement=mm"
std::string list(const ui::UnitChoices& choices)
{
    std::string text;
    for (const ui::QuantityUnits& quantity : ui::chosen_quantities())
        if (const std::string_view unit = choices.of(quantity.measure); !unit.empty())
            text += (text.empty() ? "" : ", ") + std::string(quantity.code) + "=" + std::string(unit);
    return text;
}

} // namespace

std::string with_unit(std::string_view words, std::string_view unit, std::string_view sign)
{
    std::string text;
    for (const std::string& word : comma_list(words)) {
        const std::size_t before = sign.empty() ? 0 : word.rfind(sign);
        const bool has_number = before != std::string::npos &&
                                is_bare_number(std::string_view(word).substr(before + sign.size()));
        text += (text.empty() ? "" : ",") + word + (has_number ? " " + std::string(unit) : "");
    }
    return text;
}

ui::UnitChoices AskedUnits::choices(const ui::Catalogue& tr) const
{
    ui::UnitChoices choices;
    std::vector<std::string> chosen;
    for (const std::string& words : words_)
        for (const std::string& word : comma_list(words)) {
            choose(choices, word, tr);
            const std::string quantity = word.substr(0, word.find('='));
            if (std::ranges::find(chosen, quantity) != chosen.end())
                throw femoop::ModelError({femoop::Fault{femoop::FaultKind::RepeatedComponent, {"--unit", quantity}}});
            chosen.push_back(quantity);
        }
    return choices;
}

femoop::ResultUnits AskedUnits::of_results(const femoop::Model& model, const ui::Catalogue& tr) const
{
    return drawing::table_units(drawing::display_units(model, in_units_of_file(choices(tr))));
}

femoop::ResultUnits AskedUnits::of_results(const femoop::plane::PlaneModel& model, const ui::Catalogue& tr) const
{
    if (!are_given()) return femoop::result_units(model.units);
    ::plane::PlateOptions options;
    options.unit_choices = choices(tr);
    return drawing::table_units(::plane::display_units(model, options));
}

femoop::influence::LineUnits AskedUnits::of_line(const femoop::Model& model,
                                                 const femoop::InfluenceLineDefinition& line,
                                                 const ui::Catalogue& tr) const
{
    if (!are_given()) return femoop::influence::line_units(model, line);
    const bool is_couple = femoop::influence::is_couple(femoop::influence::unit_load(model.analysis, line.load));
    const ui::DisplayUnits units = drawing::display_units(model, in_units_of_file(choices(tr)));
    const femoop::ResultUnits per_load = drawing::table_units(
        units.per(is_couple ? ui::Measure::Moment : ui::Measure::Force));
    return {.length = drawing::table_units(units).length,
            .ordinate = femoop::influence::unit_of(per_load, line.effect)};
}

drawing::DrawOptions AskedUnits::of_pictures(drawing::DrawOptions options) const
{
    options.unit_choices = choices(options.tr);
    return options;
}

femoop::Model AskedUnits::in_one_system(const femoop::Model& model, std::string_view option,
                                        const ui::Catalogue& tr) const
{
    const ui::UnitChoices chosen = choices(tr);
    std::vector<ui::Measure> measures;
    for (const ui::QuantityUnits& quantity : ui::chosen_quantities()) measures.push_back(quantity.measure);
    femoop::Model counted = model;
    counted.extra.clear();
    if (const auto units = drawing::base_units_of(measures, model.units, in_units_of_file(chosen)))
        return *units == model.units ? counted : femoop::in_units(counted, *units);
    throw UsageError(
        tr("{option} counts in one unit of length and one of force, and {units} do not follow from any two; "
           "leave one of them out",
           {{"option", option}, {"units", list(chosen)}}));
}

} // namespace cli
