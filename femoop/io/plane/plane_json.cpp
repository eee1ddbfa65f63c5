#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/json/json_writer.h"
#include "femoop/io/json/model_json.h"
#include "femoop/io/plane/mesh_json.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/plane/analysis/result_reader.h"
#include "femoop/plane/mesh/mesh_quality.h"
#include "femoop/plane/result/cut_balance.h"

namespace femoop::plane {

namespace {

using Layout = JsonWriter::Layout;

void write_pair(JsonWriter& json, std::string_view key, const Eigen::Vector2d& value)
{
    json.key(key).begin_array().value(value.x()).value(value.y()).end();
}

void write_vector(JsonWriter& json, std::string_view key, std::array<std::string_view, 2> names,
                  const Eigen::Vector2d& value)
{
    json.key(key).begin_object().member(names[0], value.x()).member(names[1], value.y()).end();
}

void write_stress(JsonWriter& json, const std::string& region, const PlaneStress& s)
{
    const PrincipalStress p = principal(s);
    json.key(region).begin_object();
    json.member("sx", s.sx).member("sy", s.sy).member("sz", s.sz).member("txy", s.txy);
    json.member("s1", p.s1).member("s2", p.s2).member("angle", p.angle * 180.0 / std::numbers::pi);
    json.member("mises", von_mises(s)).end();
}

/// Writes the cases of one model.
class PlaneCaseWriter {
public:
    PlaneCaseWriter(JsonWriter& json, const PlaneResults& results, const PlaneSelection& selection)
        : json_(json),
          results_(results),
          model_(results.model()),
          selection_(selection),
          regions_of_(regions_of_points(model_))
    {}

    void write(const PlaneCase& result)
    {
        json_.key(result.name()).begin_object(Layout::Block);
        json_.key("points").begin_object(Layout::Block);
        if (selection_.points && !selection_.is_full)
            for (const ShownPoint& point : *selection_.points) write_point(result, point);
        else
            for (std::size_t i = 0; i < model_.points.size(); ++i) write_point(result, NodeId(i));
        json_.end();
        write_curves(result);
        write_regions(result);
        if (!selection_.probes.empty()) write_probes(result);
        if (!selection_.cuts.empty()) write_cuts(result);
        json_.member("energy", result.energy()).member("error_estimate", result.error_estimate());
        write_equilibrium(result.equilibrium());
        json_.end();
    }

private:
    void write_point(const PlaneCase& result, NodeId node) { write_point(result, node, model_[node].id); }
    void write_point(const PlaneCase& result, NodeId node, const std::string& id)
    {
        json_.key(id).begin_object();
        write_vector(json_, "u", {"ux", "uy"}, result.displacement(node));
        if (result.is_supported(node)) write_vector(json_, "reaction", {"fx", "fy"}, result.reaction(node));
        json_.key("stress").begin_object();
        for (const RegionId region : regions_of_[node.index])
            write_stress(json_, model_[region].id, result.smoothed_stress(node, region));
        json_.end().end();
    }

    /// A point of a drawing that is no node has what its place has.
    void write_point(const PlaneCase& result, const ShownPoint& point)
    {
        if (point.node) return write_point(result, *point.node, point.id);
        json_.key(point.id).begin_object();
        write_state(result, results_.locator().find(point.at));
        json_.end();
    }

    void write_state(const PlaneCase& result, const std::vector<Location>& places)
    {
        write_vector(json_, "u", {"ux", "uy"}, result.displacement(places.front()));
        json_.key("stress").begin_object();
        std::vector<RegionId> seen;
        for (const Location& place : places) {
            const RegionId region = model_[place.element].region;
            if (std::ranges::find(seen, region) != seen.end()) continue;
            seen.push_back(region);
            write_stress(json_, model_[region].id, result.smoothed_stress(place));
        }
        json_.end();
    }

    void write_curves(const PlaneCase& result)
    {
        json_.key("curves").begin_object(Layout::Block);
        for (std::size_t c = 0; c < model_.curves.size(); ++c) {
            if (!model_.curves[c].support) continue;
            const std::vector<NodeId> nodes = nodes_along(result.structure().curves().edges[c]);
            const Eigen::Vector2d force = result.reaction(nodes);
            json_.key(model_.curves[c].id).begin_object().key("reaction").begin_object();
            json_.member("fx", force.x()).member("fy", force.y());
            json_.member("mz", result.reaction_moment(nodes, {0.0, 0.0})).end().end();
        }
        json_.end();
    }

    void write_extreme(const PlaneCase& result, const ExtremeQuestion& question, std::string_view key)
    {
        const PlaneExtreme found = extreme(result, question);
        json_.key(key).begin_object();
        write_pair(json_, "at", found.at);
        json_.member("value", found.value).end();
    }

    void write_regions(const PlaneCase& result)
    {
        json_.key("regions").begin_object(Layout::Block);
        const std::vector<RegionSize> sizes = region_sizes(model_);
        for (std::size_t r = 0; r < model_.regions.size(); ++r) {
            if (sizes[r].n_elements == 0) continue;
            json_.key(model_.regions[r].id).begin_object().key("extremes").begin_object(Layout::Block);
            for (const PlaneComponent component : shown_extremes) {
                ExtremeQuestion question{.component = component, .region = RegionId(r)};
                json_.key(plane::name(component)).begin_object();
                write_extreme(result, question, "max");
                question.which = ExtremeKind::Min;
                write_extreme(result, question, "min");
                json_.end();
            }
            json_.end().end();
        }
        json_.end();
    }

    void write_probes(const PlaneCase& result)
    {
        json_.key("probes").begin_array(Layout::Block);
        for (const Eigen::Vector2d& at : selection_.probes) {
            const std::vector<Location> places = results_.locator().find(at);
            json_.begin_object();
            write_pair(json_, "at", at);
            write_state(result, places);
            json_.end();
        }
        json_.end();
    }

    void write_cuts(const PlaneCase& result)
    {
        json_.key("cuts").begin_array(Layout::Block);
        for (const Cut& cut : selection_.cuts) {
            const CutForces forces = result.forces(cut);
            json_.begin_object(Layout::Block).key("cut").begin_array();
            for (const Eigen::Vector2d& end : {cut.start, cut.end})
                json_.begin_array().value(end.x()).value(end.y()).end();
            json_.end().member("N", forces.N).member("V", forces.V).member("M", forces.M);
            if (const auto balance = cut_balance(results_, result, cut); balance && balance->is_exact(cut)) {
                const CutForces by = balance->mean();
                json_.key("balance").begin_object().member("N", by.N).member("V", by.V).member("M", by.M).end();
            }
            json_.key("stations").begin_array(Layout::Block);
            for (const CutStation& station : result.stations(cut)) {
                json_.begin_object().member("s", station.s);
                write_pair(json_, "at", station.at);
                json_.member("sx'", station.sx).member("sy'", station.sy).member("txy'", station.txy).end();
            }
            json_.end().end();
        }
        json_.end();
    }

    void write_equilibrium(const Equilibrium& sums)
    {
        json_.key("equilibrium").begin_object().member("residual", sums.residual);
        for (const auto& [key, sum] :
             {std::pair{"sum_loads", &sums.sum_loads}, {"sum_reactions", &sums.sum_reactions}}) {
            json_.key(key).begin_array();
            for (const Dof dof : {Dof::ux, Dof::uy, Dof::rz}) json_.value((*sum)[index(dof)]);
            json_.end();
        }
        json_.end();
    }

    JsonWriter& json_;
    const PlaneResults& results_;
    const PlaneModel& model_;
    const PlaneSelection& selection_;
    std::vector<std::vector<RegionId>> regions_of_; ///< of every point
};

void write_region_sizes(JsonWriter& json, const PlaneModel& model, const std::vector<std::string>& methods)
{
    const std::vector<RegionSize> sizes = region_sizes(model);
    json.key("regions").begin_object(Layout::Block);
    for (std::size_t r = 0; r < sizes.size(); ++r) {
        json.key(model.regions[r].id).begin_object();
        json.member("area", sizes[r].area).member("elements", sizes[r].n_elements);
        if (!methods.empty()) json.member("method", methods[r]);
        json.end();
    }
    json.end();
}

} // namespace

std::vector<std::vector<RegionId>> regions_of_points(const PlaneModel& model)
{
    std::vector<std::vector<RegionId>> regions(model.points.size());
    for (const PlaneElement& element : model.elements)
        for (const NodeId node : element.points)
            if (auto& here = regions[node.index]; std::ranges::find(here, element.region) == here.end())
                here.push_back(element.region);
    return regions;
}

std::string plane_results_json(const PlaneResults& results, const PlaneSelection& selection)
{
    const PlaneModel& model = results.model();
    JsonWriter json;
    begin_output(json, model.units);
    json.member("analysis", name(model.analysis));
    write_mesh(json, model, selection.is_full);
    write_region_sizes(json, model, selection.methods);
    if (!results.warnings().empty()) {
        json.key("warnings").begin_array(Layout::Block);
        for (const Fault& warning : results.warnings()) json.value(message(warning));
        json.end();
    }
    json.key("cases").begin_object(Layout::Block);
    PlaneCaseWriter writer(json, results, selection);
    for (const CaseId id : selection.cases) writer.write(results[id]);
    json.end().end();
    return json.take();
}

} // namespace femoop::plane
