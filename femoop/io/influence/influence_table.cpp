#include <string>
#include <vector>

#include "femoop/io/influence/influence_json.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::influence {

namespace {

constexpr std::size_t indent = 2;

Dimension ordinate_dimension(AnalysisKind kind, const InfluenceLineDefinition& line)
{
    Dimension d = dimension_of(line.effect);
    d.force = static_cast<std::int8_t>(d.force - 1);
    if (is_couple(unit_load(kind, line.load))) d.length = static_cast<std::int8_t>(d.length - 1);
    return d;
}

std::string places_text(const LineExtreme& extreme, const PrintedUnit& length, const Translator& tr)
{
    std::string text;
    for (std::size_t i = 0; i < extreme.positions.size(); ++i) {
        text += six_digits(extreme.positions[i] * length.factor, tr);
        if (i + 1 < extreme.positions.size()) text += extreme.is_level_after[i] ? " .. " : ", ";
    }
    return text;
}

/// What the tables of one line have in common.
struct LineTables {
    const Model& model;
    const InfluenceLine& line;
    const LineUnits& units;
    const Translator& tr;

    double place(double s) const { return s * units.length.factor; }
    double ordinate(double value) const { return value * units.ordinate.factor; }

    std::string text(const tabular::Table& table) const
    {
        return tabular::plain_text(table, {indent, decimal_mark(tr)});
    }

    tabular::Table pieces() const
    {
        tabular::Table table(
            {tr("member"), {tr("from"), units.length.name}, {tr("to"), units.length.name}, "1", "t", "t^2", "t^3"});
        for (const LineStretch& stretch : line.stretches) {
            std::vector<tabular::Cell> row{model[stretch.member].id, place(stretch.from), place(stretch.to)};
            const std::vector<double>& c = line.ordinates.pieces[stretch.first_piece].coefficients;
            double unit = units.ordinate.factor; // of the coefficient of t^i
            for (std::size_t i = 0; i < 4; ++i, unit /= units.length.factor) {
                if (!stretch.is_series) row.emplace_back(i < c.size() ? six_digits(c[i] * unit, tr) : "0");
                else row.emplace_back(i == 0 ? tr("closed form, a power series") : "");
            }
            table.add_row(std::move(row));
        }
        return table;
    }

    tabular::Table ordinates(std::size_t n) const
    {
        tabular::Table table({{"s", units.length.name}, {"η", units.ordinate.name}});
        const double size = line.ordinates.largest();
        for (const LineStation& station : stations(line, n))
            table.add_row({place(station.s), ordinate(without_rounding(station.value, size))});
        return table;
    }

    tabular::Table summary() const
    {
        const double size = line.ordinates.largest();
        tabular::Table table({"", {"η", units.ordinate.name}, {"s", units.length.name}});
        const auto add = [&](const std::string& what, const LineExtreme& extreme) {
            table.add_row({what, six_digits(ordinate(without_rounding(extreme.value, size)), tr),
                           places_text(extreme, units.length, tr)});
        };
        add(tr("max"), line.ordinates.max());
        add(tr("min"), line.ordinates.min());
        return table;
    }

    std::string areas() const
    {
        const LineAreas areas = line.ordinates.areas();
        const double unit = units.ordinate.factor * units.length.factor;
        return "  " +
               fill(tr("areas: {0} positive, {1} negative"),
                    {six_digits(areas.positive * unit, tr), six_digits(areas.negative * unit, tr)}) +
               "\n";
    }
};

std::string path_text(const Model& model, const LoadPathReference& path)
{
    std::string text;
    for (const MemberId member : members_of(model, path)) text += (text.empty() ? "" : ", ") + model[member].id;
    return text;
}

} // namespace

LineUnits line_units(const Model& model, const InfluenceLineDefinition& line)
{
    return {.length = {unit_text(dimension::length, model.units)},
            .ordinate = {printed_unit(ordinate_dimension(model.analysis, line), model.units)}};
}

std::string lines_text(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                       std::span<const InfluenceLine> lines, std::span<const LineUnits> units, std::size_t n_stations,
                       const Translator& tr)
{
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const InfluenceLineDefinition& definition = definitions[i];
        const LineTables tables{.model = model, .line = lines[i], .units = units[i], .tr = tr};
        text += text.empty() ? "" : "\n";
        text += fill(tr("Influence line {0}: {1}, unit load along {2}"),
                     {definition.id, effect_name(model, definition.effect, tr), path_text(model, definition.path)}) +
                "\n\n" + tables.text(tables.summary()) + tables.areas() + "\n" + tr("Pieces, t = s - from") + "\n" +
                tables.text(tables.pieces()) + "\n" + tr("Ordinates") + "\n" +
                tables.text(tables.ordinates(n_stations));
    }
    return text;
}

} // namespace femoop::influence
