#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/plane/plane_output.h"
#include "femoop/io/results/result_units.h"
#include "femoop/io/results/results_csv.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/number_text.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "femoop/plane/result/cut_balance.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/plain_text.h"
#include "femoop/tabular/separated.h"
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

/// How large the numbers of a case are: what is far smaller is rounding.
struct PlaneMagnitudes {
    PlaneMagnitudes(const PlaneResults& results, const PlaneCase& result)
    {
        for (std::size_t i = 0; i < results.model().points.size(); ++i) {
            displacement = std::max(displacement, result.displacement(NodeId(i)).norm());
            force = std::max(force, result.reaction(NodeId(i)).norm());
            reach = std::max(reach, position(results.model().points[i]).norm());
        }
    }
    double moved(double u) const { return without_rounding(u, displacement); }

    double displacement = 0.0, force = 0.0, reach = 0.0; ///< of one node; from the origin
};

constexpr std::array plane_sums{Dof::ux, Dof::uy, Dof::rz};

/// The same of the sums of forces, and of moments by the reach of the farthest node.
class SizeOfSums {
public:
    explicit SizeOfSums(const PlaneCase& result)
    {
        for (const Eigen::Vector2d& at : result.structure().positions()) reach_ = std::max(reach_, at.norm());
        const Equilibrium sums = result.equilibrium();
        for (const NodeVector& of : {sums.sum_loads, sums.sum_reactions})
            force_ += std::abs(of[0]) + std::abs(of[1]) + std::abs(of[5]) / reach_;
    }
    double of(Dof dof) const { return is_rotation(dof) ? force_ * reach_ : force_; }

private:
    double reach_ = 0.0, force_ = 0.0;
};

CutForces without_rounding_of(const CutForces& forces, const Cut& cut)
{
    const double size = std::abs(forces.N) + std::abs(forces.V) + std::abs(forces.M) / cut.length();
    return {without_rounding(forces.N, size), without_rounding(forces.V, size),
            without_rounding(forces.M, size * cut.length())};
}

/// One place of each region that a place is in.
std::vector<std::pair<RegionId, Location>> places_at(const PlaneResults& results, const Eigen::Vector2d& at)
{
    std::vector<std::pair<RegionId, Location>> places;
    for (const Location& place : results.locator().find(at)) {
        const RegionId region = results.model()[place.element].region;
        if (std::ranges::find(places, region, &std::pair<RegionId, Location>::first) == places.end())
            places.emplace_back(region, place);
    }
    return places;
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
        text += cut_warnings(selection.cuts);
        text += titled(tr_("Equilibrium (moments about the origin)"), equilibrium(), tr_);
        const std::string energy = number_text(six_digits(result_.energy() * units_.moment.factor)),
                          error = number_text(six_digits(100.0 * result_.error_estimate()));
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

    /// What is to be said of cuts whose stresses do not balance what lies beyond them.
    std::string cut_warnings(const std::vector<Cut>& all) const
    {
        std::string text;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto warning = cut_warning(results_, result_, all[i]);
            if (!warning) continue;
            const CutForces by = without_rounding_of(warning->balanced, all[i]);
            const auto value = [&](double v, const PrintedUnit& unit) {
                return number_text(six_digits(v * unit.factor));
            };
            text += "  " +
                    fill(tr_("cut {0}: the stresses of the elements miss equilibrium by {1} % (digits that hold: {2}); "
                             "what lies beyond the cut gives N = {3}, V = {4}, M = {5}"),
                         {std::to_string(i + 1), number_text(six_digits(100.0 * warning->missed)),
                          std::to_string(warning->digits), value(by.N, units_.force), value(by.V, units_.force),
                          value(by.M, units_.moment)}) +
                    "\n";
        }
        return text;
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

/// The cases as separated values.
class PlaneCsv {
public:
    PlaneCsv(const PlaneResults& results, const PlaneSelection& selection)
        : results_(results),
          model_(results.model()),
          selection_(selection),
          length_(unit_text(dimension::length, model_.units)),
          force_(unit_text(dimension::force, model_.units)),
          moment_(unit_text(dimension::moment, model_.units)),
          stress_(unit_text(dimension::stress, model_.units)),
          regions_of_(regions_of_points(model_))
    {
        for (const CaseId id : selection.cases) {
            cases_.push_back(results[id]);
            most_.emplace_back(results, cases_.back());
        }
    }

    std::vector<CsvFile> files() const
    {
        std::vector<CsvFile> all{
            {"displacements.csv", displacements()}, {"reactions.csv", reactions()}, {"curves.csv", curves()},
            {"stresses.csv", stresses()},           {"extremes.csv", extremes()},   {"equilibrium.csv", equilibrium()}};
        if (!selection_.probes.empty()) all.push_back({"probes.csv", probes()});
        if (selection_.cuts.empty()) return all;
        all.push_back({"cuts.csv", cuts()});
        all.push_back({"stations.csv", stations()});
        return all;
    }

private:
    using Heading = std::pair<std::string_view, std::string_view>; ///< and its unit, empty where it has none
    static tabular::SeparatedText table(std::initializer_list<Heading> headings)
    {
        tabular::SeparatedText csv;
        for (const auto& [what, unit] : headings) csv << tabular::Column(std::string(what), std::string(unit)).label();
        return csv;
    }
    void add_stress_headings(tabular::SeparatedText& csv) const
    {
        for (const char* const what : {"sx", "sy", "sz", "txy", "s1", "s2"})
            csv << tabular::Column(what, stress_).label();
        csv << "angle [deg]" << tabular::Column("mises", stress_).label();
        csv.end_row();
    }
    static void add_stress(tabular::SeparatedText& csv, const PlaneStress& s)
    {
        const PrincipalStress p = principal(s);
        const double size = std::max({std::abs(s.sx), std::abs(s.sy), std::abs(s.sz), std::abs(s.txy)});
        for (const double value : {s.sx, s.sy, s.sz, s.txy, p.s1, p.s2}) csv << without_rounding(value, size);
        csv << p.angle * 180.0 / std::numbers::pi << von_mises(s);
        csv.end_row();
    }
    static void add_pair(tabular::SeparatedText& csv, const Eigen::Vector2d& of) { csv << of.x() << of.y(); }
    void add_point(tabular::SeparatedText& csv, const PlaneCase& result, std::size_t i) const
    {
        csv << result.name() << model_.points[i].id;
        add_pair(csv, position(model_.points[i]));
    }

    std::string displacements() const
    {
        auto csv = table(
            {{"case", {}}, {"point", {}}, {"x", length_}, {"y", length_}, {"ux", length_}, {"uy", length_}});
        csv.end_row();
        for (std::size_t c = 0; c < cases_.size(); ++c)
            for (std::size_t i = 0; i < model_.points.size(); ++i) {
                const Eigen::Vector2d u = cases_[c].displacement(NodeId(i));
                add_point(csv, cases_[c], i);
                csv << most_[c].moved(u.x()) << most_[c].moved(u.y());
                csv.end_row();
            }
        return csv.take();
    }

    std::string reactions() const
    {
        auto csv = table({{"case", {}}, {"point", {}}, {"x", length_}, {"y", length_}, {"fx", force_}, {"fy", force_}});
        csv.end_row();
        for (std::size_t c = 0; c < cases_.size(); ++c)
            for (std::size_t i = 0; i < model_.points.size(); ++i) {
                if (!cases_[c].is_supported(NodeId(i))) continue;
                const Eigen::Vector2d force = cases_[c].reaction(NodeId(i));
                add_point(csv, cases_[c], i);
                for (const double value : {force.x(), force.y()}) csv << without_rounding(value, most_[c].force);
                csv.end_row();
            }
        return csv.take();
    }

    std::string curves() const
    {
        auto csv = table({{"case", {}}, {"curve", {}}, {"fx", force_}, {"fy", force_}, {"mz", moment_}});
        csv.end_row();
        for (std::size_t k = 0; k < cases_.size(); ++k)
            for (std::size_t c = 0; c < model_.curves.size(); ++c) {
                if (!model_.curves[c].support) continue;
                const std::vector<NodeId> nodes = nodes_along(cases_[k].structure().curves().edges[c]);
                const Eigen::Vector2d force = cases_[k].reaction(nodes);
                const double size = most_[k].force * static_cast<double>(nodes.size());
                csv << cases_[k].name() << model_.curves[c].id;
                for (const double value : {force.x(), force.y()}) csv << without_rounding(value, size);
                csv << without_rounding(cases_[k].reaction_moment(nodes, {0.0, 0.0}), size * most_[k].reach);
                csv.end_row();
            }
        return csv.take();
    }

    std::string stresses() const
    {
        auto csv = table({{"case", {}}, {"point", {}}, {"x", length_}, {"y", length_}, {"region", {}}});
        add_stress_headings(csv);
        for (const PlaneCase& result : cases_)
            for (std::size_t i = 0; i < model_.points.size(); ++i)
                for (const RegionId region : regions_of_[i]) {
                    add_point(csv, result, i);
                    csv << model_[region].id;
                    add_stress(csv, result.smoothed_stress(NodeId(i), region));
                }
        return csv.take();
    }

    std::string extremes() const
    {
        auto csv = table({{"case", {}},
                          {"region", {}},
                          {"component", {}},
                          {"unit", {}},
                          {"max", {}},
                          {"x of max", length_},
                          {"y of max", length_},
                          {"min", {}},
                          {"x of min", length_},
                          {"y of min", length_}});
        csv.end_row();
        const std::vector<RegionSize> sizes = region_sizes(model_);
        for (const PlaneCase& result : cases_)
            for (std::size_t r = 0; r < model_.regions.size(); ++r) {
                if (sizes[r].n_elements == 0) continue;
                for (const PlaneComponent component : shown_extremes) {
                    const ExtremeQuestion largest{.component = component, .region = RegionId(r)};
                    ExtremeQuestion smallest = largest;
                    smallest.which = ExtremeKind::Min;
                    const std::array ends{extreme(result, largest), extreme(result, smallest)};
                    const double size = std::max(std::abs(ends[0].value), std::abs(ends[1].value));
                    csv << result.name() << model_.regions[r].id << plane::name(component) << stress_;
                    for (const PlaneExtreme& end : ends) {
                        csv << without_rounding(end.value, size);
                        add_pair(csv, end.at);
                    }
                    csv.end_row();
                }
            }
        return csv.take();
    }

    std::string equilibrium() const
    {
        auto csv = table(
            {{"case", {}}, {"sum of", {}}, {"fx", force_}, {"fy", force_}, {"mz", moment_}, {"residual", {}}});
        csv.end_row();
        for (const PlaneCase& result : cases_) {
            const Equilibrium sums = result.equilibrium();
            const SizeOfSums most(result);
            for (const bool is_load : {true, false}) {
                csv << result.name() << (is_load ? "loads" : "reactions");
                for (const Dof dof : plane_sums) {
                    const NodeVector& sum = is_load ? sums.sum_loads : sums.sum_reactions;
                    csv << without_rounding(sum[index(dof)], most.of(dof));
                }
                csv << sums.residual;
                csv.end_row();
            }
        }
        return csv.take();
    }

    std::string probes() const
    {
        auto csv = table(
            {{"case", {}}, {"x", length_}, {"y", length_}, {"region", {}}, {"ux", length_}, {"uy", length_}});
        add_stress_headings(csv);
        for (std::size_t c = 0; c < cases_.size(); ++c)
            for (const Eigen::Vector2d& at : selection_.probes)
                for (const auto& [region, place] : places_at(results_, at)) {
                    csv << cases_[c].name();
                    add_pair(csv, at);
                    const Eigen::Vector2d u = cases_[c].displacement(place);
                    csv << model_[region].id << most_[c].moved(u.x()) << most_[c].moved(u.y());
                    add_stress(csv, cases_[c].smoothed_stress(place));
                }
        return csv.take();
    }

    std::string cuts() const
    {
        auto csv = table({{"case", {}},
                          {"cut", {}},
                          {"x1", length_},
                          {"y1", length_},
                          {"x2", length_},
                          {"y2", length_},
                          {"N", force_},
                          {"V", force_},
                          {"M", moment_}});
        csv.end_row();
        for (const PlaneCase& result : cases_)
            for (std::size_t i = 0; i < selection_.cuts.size(); ++i) {
                const Cut& cut = selection_.cuts[i];
                const CutForces forces = without_rounding_of(result.forces(cut), cut);
                csv << result.name() << tabular::Cell(i + 1);
                add_pair(csv, cut.start);
                add_pair(csv, cut.end);
                csv << forces.N << forces.V << forces.M;
                csv.end_row();
            }
        return csv.take();
    }

    std::string stations() const
    {
        auto csv = table({{"case", {}},
                          {"cut", {}},
                          {"s", length_},
                          {"x", length_},
                          {"y", length_},
                          {"sx'", stress_},
                          {"sy'", stress_},
                          {"txy'", stress_}});
        csv.end_row();
        for (const PlaneCase& result : cases_)
            for (std::size_t i = 0; i < selection_.cuts.size(); ++i)
                for (const CutStation& station : result.stations(selection_.cuts[i])) {
                    const double size = std::abs(station.sx) + std::abs(station.sy) + std::abs(station.txy);
                    csv << result.name() << tabular::Cell(i + 1) << station.s;
                    add_pair(csv, station.at);
                    for (const double value : {station.sx, station.sy, station.txy})
                        csv << without_rounding(value, size);
                    csv.end_row();
                }
        return csv.take();
    }

    const PlaneResults& results_;
    const PlaneModel& model_;
    const PlaneSelection& selection_;
    std::string length_, force_, moment_, stress_;
    std::vector<std::vector<RegionId>> regions_of_; ///< of every point
    std::vector<PlaneCase> cases_;
    std::vector<PlaneMagnitudes> most_; ///< of them
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

std::vector<CsvFile> plane_results_csv(const PlaneResults& results, const PlaneSelection& selection)
{
    return PlaneCsv(results, selection).files();
}

} // namespace femoop::plane
