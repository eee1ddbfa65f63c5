#include "femoop/io/plane/modes_output.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"
#include "femoop/tabular/table.h"

namespace femoop::plane {

namespace {

tabular::Table table_of_modes(const NaturalModes& found, const Translator& tr)
{
    const tabular::Column share_x{tr("effective mass along x"), "%"}, share_y{tr("effective mass along y"), "%"};
    tabular::Table table({tr("mode"),
                          {tr("frequency"), "Hz"},
                          {"\u03c9", "rad/s"},
                          {tr("period"), "s"},
                          tr("participation x"),
                          tr("participation y"),
                          share_x,
                          share_y});
    const auto share = [&](double mass) { return without_rounding(100.0 * mass / found.total_mass, 100.0); };
    for (std::size_t i = 0; i < found.modes.size(); ++i) {
        const NaturalMode& mode = found.modes[i];
        table.add_row({std::to_string(i + 1), mode.frequency(), mode.omega,
                       mode.omega > 0.0 ? tabular::Cell(1.0 / mode.frequency()) : tabular::Cell("\u221e"),
                       without_rounding(mode.participation.x(), 1.0), without_rounding(mode.participation.y(), 1.0),
                       share(mode.effective_mass.x()), share(mode.effective_mass.y())});
    }
    return table;
}

} // namespace

std::string natural_modes_text(const NaturalModes& found, const Translator& tr)
{
    constexpr std::size_t table_indent = 2;
    std::string text = heading(found.model(), tr("natural modes, consistent mass"), tr);
    for (const Fault& warning : found.warnings) text += tr("warning") + ": " + message(warning, tr) + "\n";
    text += "\n" + tr("Natural modes") + "\n" +
            tabular::plain_text(table_of_modes(found, tr), {table_indent, decimal_mark(tr)});
    return text + "  " +
           fill(tr("total mass {0} {1}"), {localized(number_text(to_six_digits(found.total_mass)), tr),
                                           printed_unit(dimension::mass, found.model().units)}) +
           "\n";
}

} // namespace femoop::plane
