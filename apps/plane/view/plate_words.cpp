#include "apps/plane/view/plate_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "apps/plane/view/case_shares.h"
#include "apps/plane/view/comparison.h"
#include "apps/plane/view/cut_panel.h"
#include "apps/plane/view/error_curve.h"
#include "apps/plane/view/field_picture.h"
#include "apps/plane/view/load_marks.h"
#include "apps/plane/view/mesh_marks.h"
#include "apps/plane/view/mesher_picture.h"
#include "apps/plane/view/path_load.h"
#include "apps/plane/view/plate_scene.h"
#include "apps/plane/view/probe_marks.h"
#include "apps/plane/view/probe_values.h"
#include "apps/plane/view/reaction_marks.h"
#include "apps/plane/view/singular_notice.h"
#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/plane/mesh/mesh_quality.h"

namespace plane {

namespace {

namespace fp = femoop::plane;

class PlateReport {
public:
    PlateReport(const PlateInput& input, const PlateOptions& options)
        : input_(input),
          options_(options),
          tr_(options.tr),
          units_(display_units(input.model, options)),
          mesh_(mesh_of(input))
    {
        if (input.result != nullptr) result_ = input.result;
        else if (input.results != nullptr && options.load_case.index < input.results->n_cases())
            result_ = &made_.emplace((*input.results)[options.load_case]);
    }

    std::string text()
    {
        if (!input_.model.title.empty()) line(input_.model.title);
        line(shown_mode(input_, options_) != nullptr ? state_and_mode(input_, options_)
                                                     : state_and_case(input_.model, options_));
        if (shows(PlateShow::Regions)) write_regions();
        if (shows(PlateShow::Geometry)) write_geometry();
        if (shows(PlateShow::Supports)) write_supports();
        if (shows(PlateShow::Loads)) write_loads();
        if (input_.player != nullptr) write_step();
        else if (shows(PlateShow::Mesh) && mesh_ != nullptr) write_mesh();
        if (result_ != nullptr) write_results();
        if (input_.modes != nullptr) write_modes();
        return text_;
    }

    /// Whatever its loads are.
    std::string body_text()
    {
        if (!input_.model.title.empty()) line(input_.model.title);
        write_regions();
        write_geometry();
        write_supports();
        if (mesh_ != nullptr) write_mesh();
        return text_;
    }

    std::string case_text()
    {
        line(state_and_case(input_.model, options_));
        write_loads();
        if (result_ != nullptr) write_results();
        return text_;
    }

    std::string results_text()
    {
        if (result_ != nullptr) write_results();
        return text_;
    }

private:
    bool shows(PlateShow item) const { return options_.show.set.contains(item); }
    void line(const std::string& sentence) { text_ += sentence + "\n"; }
    std::string value(double v, ui::Measure measure) const { return ui::with_minus_signs(units_.text(v, measure)); }
    /// The number, or 0 where it is rounding beside another.
    static double nothing(double v, double beside) { return std::abs(v) < 1e-9 * beside ? 0.0 : v; }
    std::string place(const Eigen::Vector2d& at) const
    {
        double largest = 0.0;
        for (const fp::PlanePoint& point : input_.model.points)
            largest = std::max({largest, std::abs(point.at[0].value()), std::abs(point.at[1].value())});
        return units_.place(nothing(at.x(), largest), nothing(at.y(), largest));
    }
    std::string area_text(double area) const
    {
        const ui::DisplayUnit length = units_.unit(ui::Measure::Length);
        return ui::number_text(area * length.factor * length.factor, options_.numbers) + " " + length.name + "²";
    }
    static std::string joined(const std::vector<std::string>& parts)
    {
        std::string text;
        for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
        return text;
    }

    void write_region(fp::RegionId region, double area)
    {
        const fp::PlaneRegion& entry = input_.model[region];
        if (entry.is_hole)
            return line(tr_("region {region}: a hole of {area}", {{"region", entry.id}, {"area", area_text(area)}}));
        line(tr_("region {region}: {area}, of {material}",
                 {{"region", entry.id}, {"area", area_text(area)}, {"material", input_.model[entry.material].id}}));
    }

    void write_regions()
    {
        std::vector<double> areas(input_.model.regions.size(), 0.0);
        double empty = 0.0;
        if (input_.drawing != nullptr) {
            for (const discretize::DrawnFace& face : input_.drawing->faces())
                (face.region ? areas[face.region->index] : empty) += face.area;
        } else {
            const std::vector<fp::RegionSize> sizes = fp::region_sizes(input_.model);
            for (std::size_t r = 0; r < sizes.size(); ++r) areas[r] = sizes[r].area;
        }
        for (std::size_t r = 0; r < areas.size(); ++r) write_region(fp::RegionId(r), areas[r]);
        if (empty > 0.0) line(tr_("faces that are left empty: {area}", {{"area", area_text(empty)}}));
    }

    void write_modes()
    {
        for (std::size_t i = 0; i < input_.modes->modes.size(); ++i) {
            const ModeTexts texts = mode_texts(*input_.modes, i, options_.numbers);
            line(tr_("mode {n}: {frequency}, period {period}, {x} of the mass along x, {y} along y",
                     {{"n", std::to_string(i + 1)},
                      {"frequency", texts.frequency},
                      {"period", texts.period},
                      {"x", texts.shares[0]},
                      {"y", texts.shares[1]}}));
        }
    }

    void write_step()
    {
        line(mesher_note(*input_.player, options_, input_.model));
        if (const std::string sentence = step_sentence(*input_.player, tr_); !sentence.empty()) line(sentence);
    }

    void write_geometry()
    {
        if (input_.drawing == nullptr) return;
        const topology::PlanarCounts counts = input_.drawing->subdivision().counts();
        line(tr_("vertices: {vertices}, edges: {edges}, regions: {regions}, components: {components}",
                 {{"vertices", std::to_string(counts.vertices)},
                  {"edges", std::to_string(counts.edges)},
                  {"regions", std::to_string(counts.regions)},
                  {"components", std::to_string(counts.components)}}));
    }

    void write_supports()
    {
        std::vector<std::string> held;
        for (const fp::PlanePoint& point : input_.model.points)
            if (point.support) held.push_back(point.id);
        for (const fp::PlaneCurve& curve : input_.model.curves)
            if (curve.support) held.push_back(curve.id);
        if (!held.empty()) line(tr_("supported: {parts}", {{"parts", joined(held)}}));
    }

    std::string load_name(fp::CurveLoadKind kind) const
    {
        switch (kind) {
        case fp::CurveLoadKind::Traction: return tr_("traction");
        case fp::CurveLoadKind::Line: return tr_("force per length");
        case fp::CurveLoadKind::Pressure: break;
        }
        return tr_("pressure");
    }

    void write_curve_load(const fp::CurveLoad& load, double factor, const PlateOutline& outline)
    {
        const auto with_unit = [&](double v) { return value(v, measure_of(load.kind)); };
        const auto bare = [&](double v) { return ui::with_minus_signs(units_.number(v, measure_of(load.kind))); };
        for (const fp::CurveId curve : load.curves) {
            std::vector<double> sizes, across, up;
            const std::vector<CurvePath> paths = paths_of(outline, curve);
            for (const CurvePath& path : paths) {
                const PathLoad along{load, path, factor};
                for (int i = 0; i <= PathLoad::samples; ++i) {
                    const Eigen::Vector2d q = along.at(along.place(static_cast<double>(i) / PathLoad::samples));
                    sizes.push_back(q.norm());
                    across.push_back(q.x());
                    up.push_back(q.y());
                }
            }
            std::vector<std::string> parts;
            const double most = sizes.empty() ? 0.0 : *std::ranges::max_element(sizes);
            const auto add_part = [&](const char* symbol, std::vector<double>& values) {
                for (double& q : values)
                    if (std::abs(q) <= 1e-9 * most) q = 0.0;
                const bool acts = std::ranges::any_of(values, [](double q) { return q != 0.0; });
                if (acts) parts.push_back(symbol + range_text(values, with_unit, bare));
            };
            if (load.kind != fp::CurveLoadKind::Pressure) {
                add_part("qx = ", across);
                add_part("qy = ", up);
            }
            line(tr_("{curve}: {kind} {value}",
                     {{"curve", input_.model[curve].id},
                      {"kind", load_name(load.kind)},
                      {"value", parts.empty() ? range_text(sizes, with_unit, bare) : joined(parts)}}));
        }
    }

    void write_loads()
    {
        constexpr double tolerance = 1e-4; // of the body: only lengths along curves follow from it
        const PlateOutline outline = outline_of(input_, tolerance * extent());
        for (const PointForce& load : point_forces(input_.model, options_.load_case)) {
            const std::string& point = input_.model[load.point].id;
            if (load.force.x() != 0.0) line(point + ": fx = " + value(load.force.x(), ui::Measure::Force));
            if (load.force.y() != 0.0) line(point + ": fy = " + value(load.force.y(), ui::Measure::Force));
        }
        for (const auto& [load_case, factor] : shares_of(input_.model, options_.load_case)) {
            for (const fp::CurveLoad& load : load_case.curves) write_curve_load(load, factor, outline);
            if (!load_case.regions.empty() || !load_case.settlements.empty())
                line(tr_("{case}: loads of regions {regions}, settlements {settlements}",
                         {{"case", load_case.id},
                          {"regions", std::to_string(load_case.regions.size())},
                          {"settlements", std::to_string(load_case.settlements.size())}}));
        }
    }

    double extent() const
    {
        std::vector<Eigen::Vector2d> ends;
        for (const OutlinedPiece& piece : outline_of(input_, std::numeric_limits<double>::infinity()).pieces)
            ends.insert(ends.end(), piece.line.begin(), piece.line.end());
        return std::max(fp::extent(ends), std::numeric_limits<double>::min());
    }

    void write_mesh()
    {
        line(tr_("mesh: {elements} elements, {nodes} nodes", {{"elements", std::to_string(mesh_->elements.size())},
                                                              {"nodes", std::to_string(mesh_->points.size())}}));
    }

    void write_field(const FieldShow& show)
    {
        const FieldPicture picture = field_picture(show, *result_, options_, units_);
        const auto with_unit = [&](double v) {
            return picture.number(v, units_) + (picture.unit.empty() ? "" : " " + picture.unit);
        };
        const std::string low = with_unit(picture.extremes->min.value), high = with_unit(picture.extremes->max.value);
        const std::string low_at = place(picture.extremes->min.at), high_at = place(picture.extremes->max.at);
        line(tr_("{component}: from {low} at {lowplace} to {high} at {highplace}", {{"component", picture.symbol},
                                                                                    {"low", low},
                                                                                    {"lowplace", low_at},
                                                                                    {"high", high},
                                                                                    {"highplace", high_at}}));
    }

    void write_error()
    {
        const std::vector<double>& errors = result_->element_errors();
        const auto worst = std::ranges::max_element(errors);
        const auto percent = [&](double share) {
            return ui::number_text(100.0 * share, {.digits = 3, .mark = options_.numbers.mark});
        };
        if (worst == errors.end()) return;
        line(tr_("estimated error {error} %, at most {most} % in element {element}",
                 {{"error", percent(result_->error_estimate())},
                  {"most", percent(*worst)},
                  {"element", mesh_->elements[static_cast<std::size_t>(worst - errors.begin())].id}}));
    }

    void write_cut_warning(const fp::CutWarning& warning, double size, const fp::Cut& cut)
    {
        const fp::CutForces& by = warning.balanced;
        const std::string percent = ui::number_text(100.0 * warning.missed,
                                                    {.digits = 2, .mark = options_.numbers.mark});
        line(tr_("misses equilibrium by {missed} %; digits that hold: {digits}",
                 {{"missed", percent}, {"digits", std::to_string(warning.digits)}}));
        line(tr_("by equilibrium N = {N}, V = {V}, M = {M}",
                 {{"N", value(nothing(by.N, size), ui::Measure::Force)},
                  {"V", value(nothing(by.V, size), ui::Measure::Force)},
                  {"M", value(nothing(by.M, size * cut.length()), ui::Measure::Moment)}}));
    }

    void write_cut(std::size_t n, const fp::Cut& cut)
    {
        const CutPicture picture = cut_picture(*input_.results, *result_, cut);
        if (picture.hindrance)
            return line(tr_("cut {n}: {reason}", {{"n", std::to_string(n)}, {"reason", tr_(*picture.hindrance)}}));
        const double size = std::max(
            {std::abs(picture.forces.N), std::abs(picture.forces.V), std::abs(picture.forces.M) / cut.length()});
        line(tr_("cut {n} from {start} to {end}: N = {N}, V = {V}, M = {M}",
                 {{"n", std::to_string(n)},
                  {"start", place(cut.start)},
                  {"end", place(cut.end)},
                  {"N", value(nothing(picture.forces.N, size), ui::Measure::Force)},
                  {"V", value(nothing(picture.forces.V, size), ui::Measure::Force)},
                  {"M", value(nothing(picture.forces.M, size * cut.length()), ui::Measure::Moment)}}));
        if (picture.warning) write_cut_warning(*picture.warning, size, cut);
        double sigma = 0.0, tau = 0.0, beam_sigma = 0.0, beam_tau = 0.0;
        for (const fp::CutStation& station : picture.stations) {
            sigma = std::max(sigma, std::abs(station.sx));
            tau = std::max(tau, std::abs(station.txy));
        }
        for (const auto& station : picture.theory.stations) {
            beam_sigma = std::max(beam_sigma, std::abs(station.sigma));
            beam_tau = std::max(beam_tau, std::abs(station.tau));
        }
        const double largest = std::max(sigma, tau);
        const auto stress = [&](double v) { return value(nothing(v, largest), ui::Measure::Stress); };
        line(tr_("largest on it: σ {sigma}, of beam theory {beamsigma}; τ {tau}, of beam theory {beamtau}",
                 {{"sigma", stress(sigma)},
                  {"beamsigma", stress(beam_sigma)},
                  {"tau", stress(tau)},
                  {"beamtau", stress(beam_tau)}}));
    }

    void write_reactions()
    {
        for (const ReactionTable::Row& row : reaction_table(*result_, units_, tr_).supports) {
            std::vector<std::string> parts;
            if (!row.fx.empty()) parts.push_back("Rx = " + row.fx);
            parts.push_back("Ry = " + row.fy);
            if (!row.mz.empty()) parts.push_back("M = " + row.mz);
            line(tr_("reaction of {support}: {values}", {{"support", row.name}, {"values", joined(parts)}}));
        }
        for (const std::string& equation : equilibrium_lines(*result_, units_)) line(equation);
    }

    /// What the panel of a probe says besides.
    void write_elements_at(const Eigen::Vector2d& at)
    {
        const auto state = probe_state(*input_.results, *result_, at);
        if (!state) return;
        std::vector<std::string> means, jumps;
        for (const ProbeValue& of : state->values) {
            if (of.element) means.push_back(of.symbol + " = " + value(*of.element, of.measure));
            if (of.jump) jumps.push_back(of.symbol + " " + value(*of.jump, of.measure));
        }
        line(tr_("of elements: {values}", {{"values", joined(means)}}));
        if (!jumps.empty())
            line(tr_("jump between {n} elements: {values}",
                     {{"n", std::to_string(state->n_elements)}, {"values", joined(jumps)}}));
    }

    void write_results()
    {
        if (shows(PlateShow::Deformed)) {
            const std::string scale = ui::number_text(magnification(input_, *result_, options_), options_.numbers);
            line(tr_("displacements × {scale}", {{"scale", scale}}));
        }
        for (const FieldShow& show : options_.show.fields) write_field(show);
        if (shows(PlateShow::Error)) write_error();
        if (input_.drawing != nullptr && shows_stresses(options_))
            if (const auto notice = singular_notice(*input_.drawing, options_)) line(*notice);
        if (input_.is_compared())
            for (const std::string& sentence : comparison_sentences(input_, options_)) line(sentence);
        if (input_.cycle != nullptr)
            for (const std::string& sentence : sentences(*input_.cycle, input_.model, options_)) line(sentence);
        if (shows(PlateShow::Reactions)) write_reactions();
        for (std::size_t i = 0; i < options_.probes.size(); ++i) {
            const Eigen::Vector2d& at = options_.probes[i];
            std::vector<std::string> state = state_lines(*input_.results, *result_, at, options_, units_);
            if (state.empty()) continue;
            const std::string where = state.front();
            state.erase(state.begin());
            line(tr_("at {place}: {state}", {{"place", where}, {"state", joined(state)}}));
            if (options_.circle == i) write_elements_at(at);
        }
        for (std::size_t i = 0; i < options_.cuts.size(); ++i) write_cut(i + 1, options_.cuts[i]);
    }

    const PlateInput& input_;
    const PlateOptions& options_;
    const ui::Catalogue& tr_;
    ui::DisplayUnits units_;
    const fp::PlaneModel* mesh_;
    const fp::PlaneCase* result_ = nullptr;
    std::optional<fp::PlaneCase> made_;
    std::string text_;
};

} // namespace

std::string results_in_words(const PlateInput& input, const PlateOptions& options)
{
    return PlateReport(input, options).results_text();
}

std::string cases_in_words(const PlateInput& input, PlateOptions options, const std::vector<femoop::CaseId>& cases)
{
    options.show = {.set = {PlateShow::Error, PlateShow::Reactions}, .fields = {}};
    for (const fp::PlaneComponent component :
         {fp::PlaneComponent::ux, fp::PlaneComponent::uy, fp::PlaneComponent::sx, fp::PlaneComponent::sy,
          fp::PlaneComponent::txy, fp::PlaneComponent::Mises})
        options.show.fields.push_back({component, FieldStyle::Bands});
    std::string text = PlateReport(input, options).body_text();
    for (const femoop::CaseId id : cases) {
        options.load_case = id;
        text += "\n" + PlateReport(input, options).case_text();
    }
    return text;
}

std::string in_words(const PlateInput& input, const PlateOptions& options)
{
    return PlateReport(input, options).text();
}

} // namespace plane
