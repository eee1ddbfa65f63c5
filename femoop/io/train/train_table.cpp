#include "femoop/io/train/train_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/six_digits.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"

namespace femoop::influence {

namespace {

using CandidateKind = PositionFunction::Candidate::Kind;

constexpr std::size_t table_indent = 2;

class TrainReport {
public:
    TrainReport(const Model& model, const ResultUnits& units, const Translator& tr)
        : model_(model), units_(units), tr_(tr), shortest_(std::numeric_limits<double>::infinity())
    {
        for (const Member& member : model.members) shortest_ = std::min(shortest_, geometry_of(model, member).length);
    }

    std::string text(const TrainResults& results) const
    {
        std::string text = fill(results.is_envelope ? tr_("Envelope {0}") : tr_("Train {0}"), {results.id}) + "\n";
        for (const auto& component : components(results.effects)) text += effect_table(results, component);
        if (results.effects.size() == 1) text += details(results.effects.front());
        for (std::size_t i = 0; i < results.proofs.size(); ++i) text += proof(results.effects[i], results.proofs[i]);
        if (!results.extremes.empty()) text += extreme_tables(results);
        return text;
    }

private:
    std::string number(double value) const { return six_digits(value, tr_); }

    std::string component(const MovingEffect& effect) const { return component_name(model_.analysis, effect); }
    bool is_of_member(const MovingEffect& effect) const { return effect.member.has_value(); }
    std::string unit(const MovingEffect& effect) const { return unit_of(units_, effect).name; }
    double shown(double value, const MovingEffect& effect) const { return value * unit_of(units_, effect).factor; }
    std::string length_unit() const { return units_.length.name; }
    /// A place is found to the square root of rounding where an extreme is flat.
    double length(double value) const
    {
        constexpr double nowhere = 1e-6; // of the shortest member
        return std::abs(value) < nowhere * shortest_ ? 0.0 : value * units_.length.factor;
    }
    std::string length_text(double value) const { return number(length(value)); }

    template <class Entry> std::vector<MovingEffect> components(const std::vector<Entry>& entries) const
    {
        std::vector<MovingEffect> found;
        for (const Entry& entry : entries)
            if (std::ranges::none_of(found, [&](const MovingEffect& one) { return is_alike(one, entry.effect); }))
                found.push_back(entry.effect);
        return found;
    }

    bool is_alike(const MovingEffect& a, const MovingEffect& b) const
    {
        return component(a) == component(b) && is_of_member(a) == is_of_member(b);
    }

    /// The leading axle first; with an arrow where it runs backwards.
    std::string axle_places(const Placing& placing, const Train& train) const
    {
        if (train.axles.empty()) return "-";
        if (!placing.position) return tr_("away");
        std::vector<double> places{*placing.position};
        for (const double spacing : placing.spacings)
            places.push_back(places.back() + (placing.reversed ? spacing : -spacing));
        return list(places) + (placing.reversed ? " <" : " >");
    }

    std::vector<tabular::Column> place_columns(const MovingEffect& effect) const
    {
        if (!is_of_member(effect)) return {tr_("node")};
        return {tr_("member"), {"x", length_unit()}};
    }

    std::vector<tabular::Cell> place_cells(const MovingEffect& effect) const
    {
        if (!effect.member) return {model_[*effect.node].id};
        const double L = geometry_of(model_, model_[*effect.member]).length;
        return {model_[*effect.member].id, effect.at ? tabular::Cell(length(along(*effect.at, L))) : tabular::Cell()};
    }

    std::string effect_table(const TrainResults& results, const MovingEffect& of) const
    {
        std::vector<tabular::Column> columns = place_columns(of);
        for (const std::string_view which : {translatable("max"), translatable("min")}) {
            columns.emplace_back(tr_(which), unit(of));
            columns.emplace_back(tr_("axles at s"), length_unit());
            if (results.is_envelope) columns.emplace_back(tr_("train"));
        }
        tabular::Table table(columns);
        double size = 0.0; // beside which some values are nothing but rounding
        for (const TrainEffect& effect : results.effects)
            if (is_alike(effect.effect, of))
                size = std::max({size, std::abs(effect.max.value), std::abs(effect.min.value)});
        for (const TrainEffect& effect : results.effects) {
            if (!is_alike(effect.effect, of)) continue;
            std::vector<tabular::Cell> row = place_cells(effect.effect);
            const double unit = unit_of(units_, of).factor;
            add(row, effect.max, {size, unit}, *effect.max_train, results.is_envelope);
            add(row, effect.min, {size, unit}, *effect.min_train, results.is_envelope);
            table.add_row(std::move(row));
        }
        return "\n" + component(of) + "\n" + tabular::plain_text(table, {table_indent, decimal_mark(tr_)});
    }

    /// How a value is written: beside what it may be rounding, and times what.
    struct Written {
        double size, unit;
        double operator()(double value) const { return without_rounding(value, size) * unit; }
    };

    void add(std::vector<tabular::Cell>& row, const Placing& placing, const Written& written, const Train& train,
             bool names_train) const
    {
        row.emplace_back(written(placing.value));
        row.emplace_back(axle_places(placing, train));
        if (names_train) row.emplace_back(train.id);
    }

    std::string extreme_tables(const TrainResults& results) const
    {
        std::string text = "\n" + tr_("Over all sections of a member") + "\n";
        for (const MovingEffect& of : components(results.extremes)) text += extreme_table(results, of);
        return text;
    }

    std::string extreme_table(const TrainResults& results, const MovingEffect& of) const
    {
        std::vector<tabular::Column> columns{tr_("member")};
        for (const std::string_view which : {translatable("max"), translatable("min")}) {
            columns.emplace_back(tr_(which), unit(of));
            columns.emplace_back(tr_("at x"), length_unit(), tabular::Alignment::Left);
            columns.emplace_back(tr_("axles at s"), length_unit());
            if (results.is_envelope) columns.emplace_back(tr_("train"));
        }
        tabular::Table table(columns);
        double size = 0.0; // beside which some values are nothing but rounding
        for (const TrainExtreme& extreme : results.extremes)
            if (is_alike(extreme.effect, of))
                size = std::max({size, std::abs(extreme.max.placing.value), std::abs(extreme.min.placing.value)});
        for (const TrainExtreme& extreme : results.extremes) {
            if (!is_alike(extreme.effect, of)) continue;
            std::vector<tabular::Cell> row{model_[*extreme.effect.member].id};
            const double unit = unit_of(units_, of).factor;
            add(row, extreme.max, {size, unit}, *extreme.max_train, results.is_envelope);
            add(row, extreme.min, {size, unit}, *extreme.min_train, results.is_envelope);
            table.add_row(std::move(row));
        }
        return "\n" + component(of) + "\n" + tabular::plain_text(table, {table_indent, decimal_mark(tr_)});
    }

    void add(std::vector<tabular::Cell>& row, const WorstSection& worst, const Written& written, const Train& train,
             bool names_train) const
    {
        std::string sections;
        for (const double x : worst.sections) sections += (sections.empty() ? "" : "; ") + length_text(x);
        row.emplace_back(written(worst.placing.value));
        row.emplace_back(sections);
        row.emplace_back(axle_places(worst.placing, train));
        if (names_train) row.emplace_back(train.id);
    }

    std::string details(const TrainEffect& effect) const
    {
        return "\n" + detail(tr_("max"), effect.max, *effect.max_train) +
               detail(tr_("min"), effect.min, *effect.min_train);
    }

    /// "max: leading axle at s = 64; spacings 14; 14; uniform load on 0 to 100"
    std::string detail(const std::string& which, const Placing& placing, const Train& train) const
    {
        std::vector<std::string> parts;
        if (!train.axles.empty()) parts.push_back(leading_axle(placing));
        if (!placing.spacings.empty()) parts.push_back(fill(tr_("spacings {0}"), {list(placing.spacings)}));
        if (train.uniform) parts.push_back(uniform(placing));
        for (const auto& place : placing.concentrated)
            parts.push_back(place ? fill(tr_("single force at s = {0}"), {length_text(*place)})
                                  : tr_("single force away"));
        std::string text;
        for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
        return "  " + which + ": " + text + "\n";
    }

    std::string leading_axle(const Placing& placing) const
    {
        if (!placing.position) return tr_("no axle on the path");
        return fill(placing.reversed ? tr_("leading axle at s = {0}, reversed") : tr_("leading axle at s = {0}"),
                    {length_text(*placing.position)});
    }

    /// Of many the first, how many there are between, and the last.
    std::string list(const std::vector<double>& lengths) const
    {
        constexpr std::size_t most_named = 12;
        const std::size_t n = lengths.size();
        if (n > most_named)
            return length_text(lengths.front()) + "; " + fill(tr_("{0} more"), {std::to_string(n - 2)}) + "; " +
                   length_text(lengths.back());
        std::string text;
        for (const double one : lengths) text += (text.empty() ? "" : "; ") + length_text(one);
        return text;
    }

    std::string uniform(const Placing& placing) const
    {
        if (placing.uniform.empty()) return tr_("uniform load nowhere");
        std::string text;
        for (const Stretch& stretch : placing.uniform)
            text += (text.empty() ? "" : "; ") +
                    fill(tr_("{0} to {1}"), {length_text(stretch.from), length_text(stretch.to)});
        return fill(tr_("uniform load on {0}"), {text});
    }

    std::string proof(const TrainEffect& effect, const TrainResults::Proof& proof) const
    {
        return proof_table(effect.effect, tr_("max"), proof.max) + proof_table(effect.effect, tr_("min"), proof.min);
    }

    std::string proof_table(const MovingEffect& effect, const std::string& which, const SearchProof& proof) const
    {
        tabular::Table table({{tr_("leading axle at s"), length_unit()},
                              {tr_("direction")},
                              {tr_("candidate")},
                              {component(effect), unit(effect)}});
        for (const SearchProof::Entry& entry : proof.entries)
            table.add_row({length(entry.candidate.x), entry.reversed ? tr_("reversed") : tr_("forwards"),
                           name(entry.candidate.kind), shown(entry.candidate.value, effect)});
        std::string text = "\n" + fill(tr_("{0} {1}: candidates"), {which, effect_name(model_, effect, tr_)}) + "\n";
        if (!proof.entries.empty()) text += tabular::plain_text(table, {table_indent, decimal_mark(tr_)});
        if (proof.uniform != 0.0)
            text += "  + " + fill(tr_("{0} of the uniform load"), {number(shown(proof.uniform, effect))}) + "\n";
        if (proof.concentrated != 0.0)
            text += "  + " + fill(tr_("{0} of the single forces"), {number(shown(proof.concentrated, effect))}) + "\n";
        return text;
    }

    std::string name(CandidateKind kind) const
    {
        if (kind == CandidateKind::Root) return tr_("root of the derivative");
        return kind == CandidateKind::BreakBefore ? tr_("break, - side") : tr_("break, + side");
    }

    const Model& model_;
    const ResultUnits& units_;
    const Translator& tr_;
    double shortest_; ///< length of a member
};

} // namespace

const PrintedUnit& unit_of(const ResultUnits& units, const MovingEffect& effect)
{
    if (effect.component) return units.of(*effect.component);
    return effect.quantity == ExpectedQuantity::Reaction ? units.of_force(*effect.dof)
                                                         : units.of_displacement(*effect.dof);
}

std::string trains_text(const Model& model, const std::vector<TrainResults>& results, const ResultUnits& units,
                        const Translator& tr)
{
    std::string text;
    for (const TrainResults& one : results)
        text += (text.empty() ? "" : "\n") + TrainReport(model, units, tr).text(one);
    return text;
}

} // namespace femoop::influence
