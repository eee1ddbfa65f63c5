#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/plane/cut_sentences.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/io/plane/printed_sizes.h"
#include "femoop/io/results/result_units.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"
#include "femoop/tabular/table.h"

namespace femoop::plane {

namespace {

constexpr std::size_t table_indent = 2;
constexpr std::size_t most_points_shown = 60; // of a larger mesh the largest displacements alone

tabular::Column column(std::string_view what, const PrintedUnit& unit) { return {std::string(what), unit.name}; }

std::string titled(const std::string& title, const tabular::Table& table, const Translator& tr)
{
    return table.is_empty() ? std::string()
                            : "\n" + title + "\n" + tabular::plain_text(table, {table_indent, decimal_mark(tr)});
}

std::string analysis_words(StressState analysis, const Translator& tr)
{
    switch (analysis) {
    case StressState::PlaneStress: return tr("plane stress");
    case StressState::PlaneStrain: return tr("plane strain");
    default: return tr("axisymmetric");
    }
}

/// The tables of one case.
class PlaneCaseText {
public:
    PlaneCaseText(const PlaneResults& results, const PlaneCase& result, const ResultUnits& units, const Translator& tr)
        : model_(results.model()), results_(results), result_(result), units_(units), tr_(tr), most_(results, result)
    {}

    std::string text(const PlaneSelection& selection) const
    {
        std::string text = titled(tr_("Displacements of the points"),
                                  displacements(selection.points ? &*selection.points : nullptr), tr_);
        text += titled(tr_("Reactions of the supports on the body"), reactions(), tr_);
        text += titled(tr_("Extreme stresses of the regions (smoothed, tension positive)"), extremes(), tr_);
        text += titled(tr_("At the places asked for"), probes(selection.probes), tr_);
        text += titled(tr_("On the cuts (N positive in tension; V = dM/dx')"), cuts(selection.cuts), tr_);
        for (const std::string& sentence : cut_sentences(results_, result_, selection.cuts, units_, tr_))
            text += "  " + sentence + "\n";
        text += titled(tr_("Equilibrium (moments about the origin)"), equilibrium(), tr_);
        const std::string energy = number_text(to_six_digits(result_.energy() * units_.moment.factor)),
                          error = number_text(to_six_digits(100.0 * result_.error_estimate()));
        return text + "  " +
               fill(tr_("strain energy {0} {1}; estimated error of the stresses {2} %"),
                    {localized(energy, tr_), units_.moment.name, localized(error, tr_)}) +
               "\n";
    }

private:
    /// \param drawn  points of a drawing; nothing: those of the model
    tabular::Table displacements(const std::vector<ShownPoint>* drawn) const
    {
        const PrintedUnit& unit = units_.displacement;
        tabular::Table table({tr_("point"), column("ux", unit), column("uy", unit)});
        const auto add = [&](const std::string& id, const Eigen::Vector2d& u) {
            table.add_row({id, most_.moved(u.x()) * unit.factor, most_.moved(u.y()) * unit.factor});
        };
        if (drawn != nullptr) {
            for (const ShownPoint& point : *drawn)
                add(point.id, point.node ? result_.displacement(*point.node)
                                         : result_.displacement(results_.locator().find(point.at).front()));
            return table;
        }
        const bool is_small = model_.points.size() <= most_points_shown;
        for (std::size_t i = 0; i < model_.points.size(); ++i) {
            const Eigen::Vector2d u = result_.displacement(NodeId(i));
            if (is_small || is_largest(u)) add(model_.points[i].id, u);
        }
        return table;
    }
    bool is_largest(const Eigen::Vector2d& u) const
    {
        return u.norm() >= most_.displacement * (1.0 - 1e-12) && most_.displacement > 0.0;
    }

    void add_reaction(tabular::Table& table, const std::string& of, const std::vector<NodeId>& nodes) const
    {
        const Eigen::Vector2d force = result_.reaction(nodes);
        const double size = most_.force * static_cast<double>(nodes.size()), factor = units_.force.factor;
        table.add_row({of, without_rounding(force.x(), size) * factor, without_rounding(force.y(), size) * factor});
    }

    tabular::Table reactions() const
    {
        tabular::Table table({"", column("fx", units_.force), column("fy", units_.force)});
        for (std::size_t i = 0; i < model_.points.size(); ++i)
            if (model_.points[i].support)
                add_reaction(table, fill(tr_("point {0}"), {model_.points[i].id}), {NodeId(i)});
        for (std::size_t c = 0; c < model_.curves.size(); ++c)
            if (model_.curves[c].support)
                add_reaction(table, fill(tr_("curve {0}"), {model_.curves[c].id}),
                             nodes_along(result_.structure().curves().edges[c]));
        return table;
    }

    tabular::Table extremes() const
    {
        const tabular::Column x = column("x", units_.length), y = column("y", units_.length);
        tabular::Table table({tr_("region"), "", tr_("largest"), x, y, tr_("smallest"), x, y});
        const std::vector<RegionSize> sizes = region_sizes(model_);
        for (std::size_t r = 0; r < model_.regions.size(); ++r) {
            if (sizes[r].n_elements == 0) continue;
            for (const PlaneComponent which :
                 {PlaneComponent::sx, PlaneComponent::sy, PlaneComponent::txy, PlaneComponent::Mises}) {
                ExtremeQuestion question{.component = which, .region = RegionId(r)};
                const PlaneExtreme max = extreme(result_, question);
                question.which = ExtremeKind::Min;
                const PlaneExtreme min = extreme(result_, question);
                const double size = std::max(std::abs(max.value), std::abs(min.value));
                std::vector<tabular::Cell> row{which == PlaneComponent::sx ? model_.regions[r].id : std::string(),
                                               column(plane::name(which), units_.stress).label()};
                for (const PlaneExtreme& end : {max, min}) {
                    row.emplace_back(without_rounding(end.value, size) * units_.stress.factor);
                    row.emplace_back(end.at.x() * units_.length.factor);
                    row.emplace_back(end.at.y() * units_.length.factor);
                }
                table.add_row(std::move(row));
            }
        }
        return table;
    }

    tabular::Table probes(const std::vector<Eigen::Vector2d>& places) const
    {
        const PrintedUnit &length = units_.length, &moved = units_.displacement, &stress = units_.stress;
        tabular::Table table({column("x", length), column("y", length), tr_("region"), column("ux", moved),
                              column("uy", moved), column("sx", stress), column("sy", stress), column("txy", stress)});
        for (const Eigen::Vector2d& at : places)
            for (const auto& [region, place] : places_at(results_, at)) {
                const Eigen::Vector2d u = result_.displacement(place);
                const PlaneStress s = result_.smoothed_stress(place);
                const double size = std::abs(s.sx) + std::abs(s.sy) + std::abs(s.txy);
                std::vector<tabular::Cell> row{at.x() * length.factor, at.y() * length.factor, model_[region].id};
                for (const double value : {u.x(), u.y()}) row.emplace_back(most_.moved(value) * moved.factor);
                for (const double value : {s.sx, s.sy, s.txy})
                    row.emplace_back(without_rounding(value, size) * stress.factor);
                table.add_row(std::move(row));
            }
        return table;
    }

    tabular::Table cuts(const std::vector<Cut>& all) const
    {
        const PrintedUnit& length = units_.length;
        tabular::Table table({column("x1", length), column("y1", length), column("x2", length), column("y2", length),
                              column("N", units_.force), column("V", units_.force), column("M", units_.moment)});
        for (const Cut& cut : all) {
            std::vector<tabular::Cell> row;
            for (const double place : {cut.start.x(), cut.start.y(), cut.end.x(), cut.end.y()})
                row.emplace_back(place * length.factor);
            const CutForces forces = without_rounding_of(result_.forces(cut), cut);
            for (const double force : {forces.N, forces.V}) row.emplace_back(force * units_.force.factor);
            row.emplace_back(forces.M * units_.moment.factor);
            table.add_row(std::move(row));
        }
        return table;
    }

    tabular::Table equilibrium() const
    {
        const Equilibrium sums = result_.equilibrium();
        tabular::Table table({"", column("fx", units_.force), column("fy", units_.force), column("mz", units_.moment)});
        const SizeOfSums most(result_);
        const auto add = [&](const std::string& of, auto&& value) {
            std::vector<tabular::Cell> row{of};
            for (const Dof dof : plane_sums)
                row.emplace_back(without_rounding(value(index(dof)), most.of(dof)) * units_.of_force(dof).factor);
            table.add_row(std::move(row));
        };
        add(tr_("loads"), [&](std::size_t i) { return sums.sum_loads[i]; });
        add(tr_("reactions"), [&](std::size_t i) { return sums.sum_reactions[i]; });
        add(tr_("sum"), [&](std::size_t i) { return sums.sum_loads[i] + sums.sum_reactions[i]; });
        return table;
    }

    const PlaneModel& model_;
    const PlaneResults& results_;
    const PlaneCase& result_;
    const ResultUnits& units_;
    const Translator& tr_;
    PlaneMagnitudes most_;
};

} // namespace

double to_six_digits(double value)
{
    std::array<char, 32> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.6g", value));
    return std::strtod(text.data(), nullptr);
}

std::string heading(const PlaneModel& model, const std::string& what, const Translator& tr)
{
    std::string text = model.title.empty() ? std::string() : printable(model.title) + "\n";
    text += fill(tr("Analysis: {0}, {3}; lengths in {1}, forces in {2}"),
                 {analysis_words(model.analysis, tr), std::string(name(model.units.length)),
                  std::string(name(model.units.force)), what}) +
            "\n";
    return text +
           fill(tr("Mesh: {0} nodes, {1} elements"),
                {std::to_string(model.points.size()), std::to_string(model.elements.size())}) +
           "\n";
}

std::string plane_heading_text(const PlaneResults& results, const Translator& tr)
{
    std::string text = heading(results.model(), tr("linear static"), tr);
    for (const Fault& warning : results.warnings()) text += tr("warning") + ": " + message(warning, tr) + "\n";
    return text;
}

std::string plane_cases_text(const PlaneResults& results, const PlaneSelection& selection, const ResultUnits& units,
                             const Translator& tr)
{
    std::string text;
    for (const CaseId id : selection.cases) {
        const PlaneCase result = results[id];
        const bool is_load_case = id.index < results.model().load_cases.size();
        const std::string title = fill(is_load_case ? tr("Load case {0}") : tr("Combination {0}"), {result.name()});
        text += "\n" + title + "\n" + std::string(tabular::shown_width(title), '=') + "\n";
        text += PlaneCaseText(results, result, units, tr).text(selection);
    }
    return text;
}

} // namespace femoop::plane
