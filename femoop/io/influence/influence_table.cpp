#include <string>
#include <vector>

#include "femoop/io/influence/influence_json.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::influence {

namespace {

constexpr std::size_t indent = 2;

/// Of an ordinate: the effect's per force, or per moment of a couple.
Dimension ordinate_dimension(AnalysisKind kind, const InfluenceLineDefinition& line)
{
    const NodeVector load = unit_load(kind, line.load);
    const bool is_couple = load[0] == 0.0 && load[1] == 0.0 && load[2] == 0.0;
    Dimension d = dimension_of(line.effect);
    d.force = static_cast<std::int8_t>(d.force - 1);
    if (is_couple) d.length = static_cast<std::int8_t>(d.length - 1);
    return d;
}

std::string places_text(const LineExtreme& extreme, const Translator& tr)
{
    std::string text;
    for (std::size_t i = 0; i < extreme.positions.size(); ++i) {
        text += six_digits(extreme.positions[i], tr);
        if (i + 1 < extreme.positions.size()) text += extreme.is_level_after[i] ? " .. " : ", ";
    }
    return text;
}

/// What the tables of one line have in common.
struct LineTables {
    const Model& model;
    const InfluenceLine& line;
    std::string length_unit, unit;
    const Translator& tr;

    std::string text(const tabular::Table& table) const
    {
        return tabular::plain_text(table, {indent, decimal_mark(tr)});
    }

    tabular::Table pieces() const
    {
        tabular::Table table(
            {tr("member"), {tr("from"), length_unit}, {tr("to"), length_unit}, "1", "t", "t^2", "t^3"});
        for (const LineStretch& stretch : line.stretches) {
            std::vector<tabular::Cell> row{model[stretch.member].id, stretch.from, stretch.to};
            const std::vector<double>& c = line.ordinates.pieces[stretch.first_piece].coefficients;
            for (std::size_t i = 0; i < 4; ++i) {
                if (!stretch.is_series) row.emplace_back(i < c.size() ? six_digits(c[i], tr) : "0");
                else row.emplace_back(i == 0 ? tr("closed form, a power series") : "");
            }
            table.add_row(std::move(row));
        }
        return table;
    }

    tabular::Table ordinates(std::size_t n) const
    {
        tabular::Table table({{"s", length_unit}, {"η", unit}});
        const double size = line.ordinates.largest();
        for (const LineStation& station : stations(line, n))
            table.add_row({station.s, without_rounding(station.value, size)});
        return table;
    }

    tabular::Table summary() const
    {
        const double size = line.ordinates.largest();
        tabular::Table table({"", {"η", unit}, {"s", length_unit}});
        const auto add = [&](const std::string& what, const LineExtreme& extreme) {
            table.add_row({what, six_digits(without_rounding(extreme.value, size), tr), places_text(extreme, tr)});
        };
        add(tr("max"), line.ordinates.max());
        add(tr("min"), line.ordinates.min());
        return table;
    }

    std::string areas() const
    {
        const LineAreas areas = line.ordinates.areas();
        return "  " +
               fill(tr("areas: {0} positive, {1} negative"),
                    {six_digits(areas.positive, tr), six_digits(areas.negative, tr)}) +
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

std::string lines_text(const Model& model, std::span<const InfluenceLineDefinition> definitions,
                       std::span<const InfluenceLine> lines, std::size_t n_stations, const Translator& tr)
{
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const InfluenceLineDefinition& definition = definitions[i];
        const Dimension d = ordinate_dimension(model.analysis, definition);
        const LineTables tables{.model = model,
                                .line = lines[i],
                                .length_unit = unit_text(dimension::length, model.units),
                                .unit = printed_unit(d, model.units),
                                .tr = tr};
        text += text.empty() ? "" : "\n";
        text += fill(tr("Influence line {0}: {1}, unit load along {2}"),
                     {definition.id, effect_name(model, definition.effect), path_text(model, definition.path)}) +
                "\n\n" + tables.text(tables.summary()) + tables.areas() + "\n" + tr("Pieces, t = s - from") + "\n" +
                tables.text(tables.pieces()) + "\n" + tr("Ordinates") + "\n" +
                tables.text(tables.ordinates(n_stations));
    }
    return text;
}

} // namespace femoop::influence
