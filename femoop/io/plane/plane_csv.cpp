#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/plane/plane_output.h"
#include "femoop/io/plane/printed_sizes.h"
#include "femoop/model/quantity/dimension.h"
#include "femoop/model/quantity/unit_signs.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "femoop/result/magnitudes.h"
#include "femoop/tabular/separated.h"
#include "femoop/tabular/table.h"

namespace femoop::plane {

namespace {

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

    std::string in_one_table() const
    {
        auto csv = table({{"case", {}},
                          {"part", {}},
                          {"id", {}},
                          {"region", {}},
                          {"x", length_},
                          {"y", length_},
                          {"component", {}},
                          {"value", {}},
                          {"unit", {}}});
        csv.end_row();
        for (std::size_t c = 0; c < cases_.size(); ++c) {
            add_points(csv, c);
            add_curves(csv, c);
            add_extremes(csv, cases_[c]);
            add_sums(csv, cases_[c]);
        }
        return csv.take();
    }

private:
    /// What a row of the one table is of.
    struct Subject {
        std::string_view part, id, region{};
        std::optional<Eigen::Vector2d> at{};
    };
    struct NamedValue {
        std::string_view component;
        double value = 0.0;
        std::string_view unit;
    };
    static void add_rows(tabular::SeparatedText& csv, const PlaneCase& result, const Subject& of,
                         std::initializer_list<NamedValue> values)
    {
        for (const auto& [component, value, unit] : values) {
            csv << result.name() << of.part << of.id << of.region;
            if (of.at) add_pair(csv, *of.at);
            else
                csv << ""
                    << "";
            csv << component << value << unit;
            csv.end_row();
        }
    }

    void add_points(tabular::SeparatedText& csv, std::size_t c) const
    {
        const PlaneCase& result = cases_[c];
        for (std::size_t i = 0; i < model_.points.size(); ++i) {
            Subject point{.part = "point", .id = model_.points[i].id, .at = position(model_.points[i])};
            const Eigen::Vector2d u = result.displacement(NodeId(i)), force = result.reaction(NodeId(i));
            add_rows(csv, result, point,
                     {{"ux", most_[c].moved(u.x()), length_}, {"uy", most_[c].moved(u.y()), length_}});
            if (result.is_supported(NodeId(i)))
                add_rows(csv, result, point,
                         {{"fx", without_rounding(force.x(), most_[c].force), force_},
                          {"fy", without_rounding(force.y(), most_[c].force), force_}});
            for (const RegionId region : regions_of_[i]) {
                point.region = model_[region].id;
                const PlaneStress s = result.smoothed_stress(NodeId(i), region);
                const PrincipalStress p = principal(s);
                const double size = size_of(s);
                const auto stress = [&](std::string_view component, double value) {
                    return NamedValue{component, without_rounding(value, size), stress_};
                };
                add_rows(csv, result, point,
                         {stress("sx", s.sx), stress("sy", s.sy), stress("sz", s.sz), stress("txy", s.txy),
                          stress("s1", p.s1), stress("s2", p.s2), stress("mises", von_mises(s))});
            }
        }
    }

    void add_curves(tabular::SeparatedText& csv, std::size_t c) const
    {
        for (std::size_t i = 0; i < model_.curves.size(); ++i) {
            if (!model_.curves[i].support) continue;
            const auto [fx, fy, mz] = curve_reaction(c, i);
            const Subject curve{.part = "curve", .id = model_.curves[i].id};
            add_rows(csv, cases_[c], curve, {{"fx", fx, force_}, {"fy", fy, force_}});
            if (model_.analysis != StressState::Axisymmetric) add_rows(csv, cases_[c], curve, {{"mz", mz, moment_}});
        }
    }

    void add_extremes(tabular::SeparatedText& csv, const PlaneCase& result) const
    {
        for_extremes(result, [&](const PlaneRegion& region, PlaneComponent component, const auto& ends) {
            for (const std::size_t k : {0U, 1U})
                add_rows(csv, result,
                         {.part = k == 0 ? "largest" : "smallest", .id = {}, .region = region.id, .at = ends[k].at},
                         {{plane::name(component), ends[k].value, stress_}});
        });
    }

    void add_sums(tabular::SeparatedText& csv, const PlaneCase& result) const
    {
        const Equilibrium sums = result.equilibrium();
        const SizeOfSums most(result);
        for (const bool is_load : {true, false}) {
            const NodeVector& sum = is_load ? sums.sum_loads : sums.sum_reactions;
            for (const Dof dof : plane_sums)
                add_rows(csv, result, {.part = is_load ? "loads" : "reactions", .id = {}},
                         {{force_name(dof), without_rounding(sum[index(dof)], most.of(dof)),
                           is_rotation(dof) ? moment_ : force_}});
        }
    }

    /// fx, fy and mz about the origin of the supports of a curve.
    std::array<double, 3> curve_reaction(std::size_t c, std::size_t curve) const
    {
        const PlaneCase& result = cases_[c];
        const std::vector<NodeId> nodes = nodes_along(result.structure().curves().edges[curve]);
        const Eigen::Vector2d force = result.reaction(nodes);
        const double size = most_[c].force * static_cast<double>(nodes.size());
        return {without_rounding(force.x(), size), without_rounding(force.y(), size),
                without_rounding(result.reaction_moment(nodes, {0.0, 0.0}), size * most_[c].reach)};
    }

    /// Calls use(region, component, [largest, smallest]) for regions that have elements.
    template <class Use> void for_extremes(const PlaneCase& result, const Use& use) const
    {
        const std::vector<RegionSize> sizes = region_sizes(model_);
        for (std::size_t r = 0; r < model_.regions.size(); ++r) {
            if (sizes[r].n_elements == 0) continue;
            for (const PlaneComponent component : shown_extremes) {
                const ExtremeQuestion largest{.component = component, .region = RegionId(r)};
                ExtremeQuestion smallest = largest;
                smallest.which = ExtremeKind::Min;
                std::array ends{extreme(result, largest), extreme(result, smallest)};
                const double size = std::max(std::abs(ends[0].value), std::abs(ends[1].value));
                for (PlaneExtreme& end : ends) end.value = without_rounding(end.value, size);
                use(model_.regions[r], component, ends);
            }
        }
    }

    static double size_of(const PlaneStress& s)
    {
        return std::max({std::abs(s.sx), std::abs(s.sy), std::abs(s.sz), std::abs(s.txy)});
    }

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
        const double size = size_of(s);
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
                csv << cases_[k].name() << model_.curves[c].id;
                for (const double value : curve_reaction(k, c)) csv << value;
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
        for (const PlaneCase& result : cases_)
            for_extremes(result, [&](const PlaneRegion& region, PlaneComponent component, const auto& ends) {
                csv << result.name() << region.id << plane::name(component) << stress_;
                for (const PlaneExtreme& end : ends) {
                    csv << end.value;
                    add_pair(csv, end.at);
                }
                csv.end_row();
            });
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

std::vector<CsvFile> plane_results_csv(const PlaneResults& results, const PlaneSelection& selection)
{
    return PlaneCsv(results, selection).files();
}

std::string plane_long_csv(const PlaneResults& results)
{
    PlaneSelection every_case;
    for (std::size_t i = 0; i < results.model().n_cases(); ++i) every_case.cases.emplace_back(i);
    return PlaneCsv(results, every_case).in_one_table();
}

} // namespace femoop::plane
