#include "femoop/io/plane/curve_runs.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "femoop/plane/mesh/edge_table.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace femoop::plane {

namespace {

/// The part of a curve that a new curve is.
struct Run {
    CurveId curve; ///< the new one
    double start = 0.0, length = 0.0, whole = 0.0;
};

Field part_of(const Field& field, const Run& run)
{
    Field part = field;
    if (const auto* ends = std::get_if<Field::Ends>(&field.form)) {
        const auto at = [&](double s) { return ends->start + s / run.whole * (ends->end - ends->start); };
        part.form = Field::Ends{at(run.start), at(run.start + run.length)};
    } else if (auto* table = std::get_if<Field::Table>(&part.form);
               table != nullptr && table->along == Field::Along::s) {
        for (auto& [place, value] : table->rows) place = place - run.start;
    }
    return part;
}

class RunSplitter {
public:
    explicit RunSplitter(const PlaneModel& model) : model_(model), result_(model), runs_(model.curves.size())
    {
        for (const PlaneCurve& curve : model.curves) names_.insert(curve.id);
    }

    PlaneModel run()
    {
        const EdgeTable edges(model_);
        for (std::size_t i = 0; i < model_.curves.size(); ++i) {
            if (!model_.curves[i].reach) continue;
            split(i, CurveGeometry(model_, edges_along(model_, edges, model_.curves[i]).edges, model_.curves[i].reach));
        }
        for (PlaneLoadCase& load_case : result_.load_cases) {
            load_case.curves = split(load_case.curves, [](CurveLoad& load, const Run& run) {
                for (auto* const field : {&load.qx, &load.qy, &load.value})
                    if (*field) *field = part_of(**field, run);
            });
            load_case.settlements = split(load_case.settlements, [](PlaneSettlement& settlement, const Run& run) {
                for (auto* const field : {&settlement.ux, &settlement.uy})
                    if (*field) *field = part_of(**field, run);
            });
        }
        return std::move(result_);
    }

private:
    std::string free_name(const std::string& id, std::size_t number)
    {
        std::string name = id + " " + std::to_string(number);
        while (!names_.insert(name).second) name += "'";
        return name;
    }

    void split(std::size_t index, const CurveGeometry& geometry)
    {
        const PlaneCurve& curve = model_.curves[index];
        const std::vector<CurveReach::Run>& runs = curve.reach->runs;
        for (std::size_t k = 0; k < runs.size(); ++k) {
            const std::size_t end = k + 1 < runs.size() ? runs[k + 1].first : curve.points.size();
            PlaneCurve part = curve;
            part.reach.reset();
            part.points.assign(curve.points.begin() + static_cast<std::ptrdiff_t>(runs[k].first),
                               curve.points.begin() + static_cast<std::ptrdiff_t>(end));
            double reached = runs[k].start;
            for (const CurveNode& node : geometry.nodes())
                if (node.node == part.points.back() && node.s >= reached) reached = node.s;
            const auto made = k == 0 ? CurveId(index) : CurveId(result_.curves.size());
            runs_[index].push_back({.curve = made,
                                    .start = runs[k].start,
                                    .length = reached - runs[k].start,
                                    .whole = curve.reach->length});
            if (k == 0) {
                result_.curves[index] = std::move(part);
            } else {
                part.id = free_name(curve.id, k + 1);
                result_.curves.push_back(std::move(part));
            }
        }
    }

    /// One entry for the curves that are whole, one for each run of the others.
    template <class Part, class Change>
    std::vector<Part> split(const std::vector<Part>& parts, const Change& change) const
    {
        std::vector<Part> result;
        for (const Part& part : parts) {
            Part whole = part;
            whole.curves.clear();
            for (const CurveId curve : part.curves)
                if (runs_[curve.index].empty()) whole.curves.push_back(curve);
            if (!whole.curves.empty() || part.curves.empty()) result.push_back(whole);
            for (const CurveId curve : part.curves)
                for (const Run& run : runs_[curve.index]) {
                    Part of_run = part;
                    of_run.curves = {run.curve};
                    change(of_run, run);
                    result.push_back(std::move(of_run));
                }
        }
        return result;
    }

    const PlaneModel& model_;
    PlaneModel result_;
    std::vector<std::vector<Run>> runs_; ///< of each curve; none of whole ones
    std::set<std::string> names_;
};

} // namespace

PlaneModel with_runs_as_curves(const PlaneModel& model) { return RunSplitter(model).run(); }

} // namespace femoop::plane
