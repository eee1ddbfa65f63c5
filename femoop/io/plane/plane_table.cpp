#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "femoop/io/plane/plane_output.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "femoop/plane/result/cut_balance.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"
#include "femoop/tabular/table.h"

namespace femoop::plane {

namespace {

constexpr std::size_t table_indent = 2;
constexpr std::size_t most_points_shown = 60; // of a larger mesh the largest displacements alone

tabular::Column column(std::string_view what, Dimension dimension, const Units& units)
{
    return {std::string(what), printed_unit(dimension, units)};
}

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
    PlaneCaseText(const PlaneResults& results, const PlaneCase& result, const Translator& tr)
        : model_(results.model()), results_(results), result_(result), tr_(tr)
    {
        for (std::size_t i = 0; i < model_.points.size(); ++i) {
            most_moved_ = std::max(most_moved_, result.displacement(NodeId(i)).norm());
            most_force_ = std::max(most_force_, result.reaction(NodeId(i)).norm());
        }
    }

    std::string text(const PlaneSelection& selection) const
    {
        std::string text = titled(tr_("Displacements of the points"),
                                  displacements(selection.points ? &*selection.points : nullptr), tr_);
        text += titled(tr_("Reactions of the supports on the body"), reactions(), tr_);
        text += titled(tr_("Extreme stresses of the regions (smoothed, tension positive)"), extremes(), tr_);
        text += titled(tr_("At the places asked for"), probes(selection.probes), tr_);
        text += titled(tr_("On the cuts (N positive in tension; V = dM/dx')"), cuts(selection.cuts), tr_);
        text += cut_warnings(selection.cuts);
        text += titled(tr_("Equilibrium (moments about the origin)"), equilibrium(), tr_);
        const std::string energy = number_text(six_digits(result_.energy())),
                          error = number_text(six_digits(100.0 * result_.error_estimate()));
        return text + "  " +
               fill(tr_("strain energy {0} {1}; estimated error of the stresses {2} %"),
                    {localized(energy, tr_), printed_unit(dimension::moment, model_.units), localized(error, tr_)}) +
               "\n";
    }

private:
    /// \param drawn  points of a drawing; nothing: those of the model
    tabular::Table displacements(const std::vector<ShownPoint>* drawn) const
    {
        tabular::Table table({tr_("point"), column("ux", dimension::length, model_.units),
                              column("uy", dimension::length, model_.units)});
        const auto add = [&](const std::string& id, const Eigen::Vector2d& u) {
            table.add_row({id, without_rounding(u.x(), most_moved_), without_rounding(u.y(), most_moved_)});
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
        return u.norm() >= most_moved_ * (1.0 - 1e-12) && most_moved_ > 0.0;
    }

    void add_reaction(tabular::Table& table, const std::string& of, const std::vector<NodeId>& nodes) const
    {
        const Eigen::Vector2d force = result_.reaction(nodes);
        const double size = most_force_ * static_cast<double>(nodes.size());
        table.add_row({of, without_rounding(force.x(), size), without_rounding(force.y(), size)});
    }

    tabular::Table reactions() const
    {
        tabular::Table table(
            {"", column("fx", dimension::force, model_.units), column("fy", dimension::force, model_.units)});
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
        const tabular::Column x = column("x", dimension::length, model_.units),
                              y = column("y", dimension::length, model_.units);
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
                table.add_row({which == PlaneComponent::sx ? model_.regions[r].id : std::string(),
                               column(plane::name(which), dimension::stress, model_.units).label(),
                               without_rounding(max.value, size), max.at.x(), max.at.y(),
                               without_rounding(min.value, size), min.at.x(), min.at.y()});
            }
        }
        return table;
    }

    tabular::Table probes(const std::vector<Eigen::Vector2d>& places) const
    {
        const auto of = [&](std::string_view what, Dimension dimension) {
            return column(what, dimension, model_.units);
        };
        tabular::Table table({of("x", dimension::length), of("y", dimension::length), tr_("region"),
                              of("ux", dimension::length), of("uy", dimension::length), of("sx", dimension::stress),
                              of("sy", dimension::stress), of("txy", dimension::stress)});
        for (const Eigen::Vector2d& at : places)
            for (const Location& place : results_.locator().find(at)) {
                const Eigen::Vector2d u = result_.displacement(place);
                const PlaneStress s = result_.smoothed_stress(place);
                const std::string& region = model_[model_[place.element].region].id;
                if (!table.rows.empty() && table.rows.back().cells[0].number == at.x() &&
                    table.rows.back().cells[1].number == at.y() && table.rows.back().cells[2].shown == region)
                    continue;
                const double size = std::abs(s.sx) + std::abs(s.sy) + std::abs(s.txy);
                table.add_row({at.x(), at.y(), region, without_rounding(u.x(), most_moved_),
                               without_rounding(u.y(), most_moved_), without_rounding(s.sx, size),
                               without_rounding(s.sy, size), without_rounding(s.txy, size)});
            }
        return table;
    }

    tabular::Table cuts(const std::vector<Cut>& all) const
    {
        const auto of = [&](std::string_view what, Dimension dimension) {
            return column(what, dimension, model_.units);
        };
        tabular::Table table({of("x1", dimension::length), of("y1", dimension::length), of("x2", dimension::length),
                              of("y2", dimension::length), of("N", dimension::force), of("V", dimension::force),
                              of("M", dimension::moment)});
        for (const Cut& cut : all) {
            const CutForces forces = result_.forces(cut);
            const double size = std::abs(forces.N) + std::abs(forces.V) + std::abs(forces.M) / cut.length();
            table.add_row({cut.start.x(), cut.start.y(), cut.end.x(), cut.end.y(), without_rounding(forces.N, size),
                           without_rounding(forces.V, size), without_rounding(forces.M, size * cut.length())});
        }
        return table;
    }

    /// What is to be said of cuts whose stresses do not balance what lies beyond them.
    std::string cut_warnings(const std::vector<Cut>& all) const
    {
        std::string text;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto warning = cut_warning(results_, result_, all[i]);
            if (!warning) continue;
            const CutForces& by = warning->balanced;
            const double size = std::abs(by.N) + std::abs(by.V) + std::abs(by.M) / all[i].length();
            const auto value = [&](double v, double beside) {
                return number_text(six_digits(without_rounding(v, beside)));
            };
            text += "  " +
                    fill(tr_("cut {0}: the stresses of the elements miss equilibrium by {1} % (digits that hold: {2}); "
                             "what lies beyond the cut gives N = {3}, V = {4}, M = {5}"),
                         {std::to_string(i + 1), number_text(six_digits(100.0 * warning->missed)),
                          std::to_string(warning->digits), value(by.N, size), value(by.V, size),
                          value(by.M, size * all[i].length())}) +
                    "\n";
        }
        return text;
    }

    tabular::Table equilibrium() const
    {
        const Equilibrium sums = result_.equilibrium();
        tabular::Table table({"", column("fx", dimension::force, model_.units),
                              column("fy", dimension::force, model_.units),
                              column("mz", dimension::moment, model_.units)});
        double reach = 0.0; // turns moments into forces
        for (const Eigen::Vector2d& at : result_.structure().positions()) reach = std::max(reach, at.norm());
        double size = 0.0;
        for (const NodeVector& of : {sums.sum_loads, sums.sum_reactions})
            size += std::abs(of[0]) + std::abs(of[1]) + std::abs(of[5]) / reach;
        const auto add = [&](const std::string& of, auto&& value) {
            std::vector<tabular::Cell> row{of};
            for (const Dof dof : {Dof::ux, Dof::uy, Dof::rz})
                row.emplace_back(without_rounding(value(index(dof)), is_rotation(dof) ? size * reach : size));
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
    const Translator& tr_;
    double most_moved_ = 0.0, most_force_ = 0.0;
};

} // namespace

double six_digits(double value)
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

std::string plane_results_text(const PlaneResults& results, const PlaneSelection& selection, const Translator& tr)
{
    const PlaneModel& model = results.model();
    std::string text = heading(model, tr("linear static"), tr);
    for (const Fault& warning : results.warnings()) text += tr("warning") + ": " + message(warning, tr) + "\n";
    for (const CaseId id : selection.cases) {
        const PlaneCase result = results[id];
        const bool is_load_case = id.index < model.load_cases.size();
        const std::string title = fill(is_load_case ? tr("Load case {0}") : tr("Combination {0}"), {result.name()});
        text += "\n" + title + "\n" + std::string(tabular::shown_width(title), '=') + "\n";
        text += PlaneCaseText(results, result, tr).text(selection);
    }
    return text;
}

} // namespace femoop::plane
