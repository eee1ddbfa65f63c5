// What cremona_all.js calls: text in, text out. What a question has besides its document is a line "key=value" each.
#include <emscripten.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "apps/cli/argument.h"
#include "apps/cli/euler_json.h"
#include "apps/cli/mohr_problem.h"
#include "apps/cli/mohr_results.h"
#include "apps/cli/plane_input.h"
#include "apps/core/answer.h"
#include "apps/drawing/draw.h"
#include "apps/frame/view/motion_words.h"
#include "femoop/analysis/linear_static.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/io/any_model.h"
#include "femoop/io/cross/cross_block.h"
#include "femoop/io/cross/cross_json.h"
#include "femoop/io/cross/other_methods.h"
#include "femoop/io/plane/plane_output.h"
#include "femoop/io/plane/plane_verify.h"
#include "femoop/io/verify.h"
#include "femoop/plane/analysis/natural_modes.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "topology/text/line_error.h"
#include "ui/paint/paint_to_file.h"

namespace {

namespace fp = femoop::plane;
using cli::PlaneInput;

/// What a question has besides its document.
class Details {
public:
    /// \throws cli::UsageError for a key that is not one of these
    Details(std::string_view lines, std::initializer_list<std::string_view> keys)
    {
        while (!lines.empty()) {
            const std::string_view line = lines.substr(0, lines.find('\n'));
            lines.remove_prefix(std::min(line.size() + 1, lines.size()));
            const std::string key(line.substr(0, line.find('=')));
            if (std::find(keys.begin(), keys.end(), key) == keys.end())
                throw cli::unknown_choice("option", key, {keys.begin(), keys.end()}, {});
            values_[key] = line.substr(std::min(key.size() + 1, line.size()));
        }
    }

    bool has(const std::string& key) const { return values_.contains(key); }
    std::string operator[](const std::string& key) const
    {
        const auto found = values_.find(key);
        return found == values_.end() ? std::string() : found->second;
    }
    std::vector<std::string> list(const std::string& key) const
    {
        return has(key) ? cli::comma_list((*this)[key]) : std::vector<std::string>();
    }

private:
    std::map<std::string, std::string> values_;
};

std::string fault_alone(const std::string& sentence)
{
    femoop::JsonWriter json;
    json.begin_object().key("faults").begin_array();
    json.begin_object().member("severity", "error").member("message", sentence).end();
    json.end().end();
    return json.take();
}

const char* answer(const std::function<std::string()>& ask)
{
    return core::kept(core::unless_refused([&]() -> std::string {
        try {
            return ask();
        } catch (const cli::UsageError& error) {
            return fault_alone(error.what());
        } catch (const topology::LineError& error) {
            return fault_alone(error.sentence(femoop::english));
        }
    }));
}

/// Of a sound model of either kind.
template <class OfMembers, class OfPlane>
std::string of_model(std::string_view text, const OfMembers& of_members, const OfPlane& of_plane)
{
    femoop::AnyReading any = femoop::examine_any(text);
    if (auto* reading = std::get_if<fp::PlaneReading>(&any)) return of_plane(*reading);
    const auto& reading = std::get<femoop::ModelReading>(any);
    return reading.is_sound() ? of_members(reading.model) : core::faults_alone(reading.faults);
}

std::string plane_solved(fp::PlaneReading& reading)
{
    const PlaneInput input(reading);
    if (!reading.is_sound()) return core::faults_alone(reading.faults);
    fp::PlaneSelection selection;
    for (std::size_t i = 0; i < input.model().n_cases(); ++i) selection.cases.emplace_back(i);
    selection.points = input.points_in_material();
    selection.methods = input.methods();
    return fp::plane_results_json(fp::analyse(input.model()), selection);
}

std::string checked(std::string_view text)
{
    femoop::AnyReading any = femoop::examine_any(text);
    auto* const reading = std::get_if<fp::PlaneReading>(&any);
    if (!reading) return core::faults_alone(std::get<femoop::ModelReading>(any).faults);
    const bool has_material = std::any_of(reading->model.regions.begin(), reading->model.regions.end(),
                                          [](const auto& region) { return !region.is_hole; });
    const PlaneInput input(*reading, has_material ? PlaneInput::Depth::Mesh : PlaneInput::Depth::Drawing);
    return core::faults_alone(reading->faults);
}

std::string_view word(femoop::Verdict verdict)
{
    using enum femoop::Verdict;
    return verdict == Passed ? "passed" : verdict == Failed ? "failed" : "skipped";
}

std::string checks_json(const std::vector<femoop::CheckOutcome>& checks)
{
    const femoop::CheckCounts counts = femoop::count(checks);
    femoop::JsonWriter json;
    json.begin_object().member("cremona", 1).key("checks").begin_array();
    for (const femoop::CheckOutcome& check : checks) {
        json.begin_object().member("what", check.what).member("verdict", word(check.verdict));
        json.member("expected", check.expected);
        if (check.result) json.member("result", *check.result).member("tolerance", check.tolerance);
        json.end();
    }
    json.end().member("passed", counts.passed).member("failed", counts.failed).member("skipped", counts.skipped).end();
    return json.take();
}

std::string verified(const femoop::Model& model)
{
    std::optional<femoop::Results> results;
    if (femoop::needs_linear_analysis(model)) results = femoop::analyse(model);
    return checks_json(femoop::verify(model, results));
}

std::string plane_verified(fp::PlaneReading& reading)
{
    const std::size_t n_modes = fp::n_modes_needed(reading.model);
    const bool needs_results = fp::needs_linear_analysis(reading.model);
    const PlaneInput input(reading,
                           needs_results || n_modes > 0 ? PlaneInput::Depth::Mesh : PlaneInput::Depth::Drawing);
    if (!reading.is_sound()) return core::faults_alone(reading.faults);
    fp::PlaneFindings found;
    if (needs_results) found.results = fp::analyse(input.model());
    if (n_modes > 0) found.modes = fp::natural_modes(input.model(), n_modes);
    return checks_json(fp::verify(reading.model, found, input.checks(), femoop::english));
}

// ---- pictures

ui::ThemeName theme_of(const Details& details)
{
    if (!details.has("theme")) return ui::ThemeName::Light;
    if (const auto theme = ui::theme_named(details["theme"])) return *theme;
    throw cli::unknown_choice("theme", details["theme"], {"light", "dark", "print", "projector"}, {});
}

double side_of(const Details& details, const std::string& key, double usual)
{
    return details.has(key) ? static_cast<double>(cli::whole_number(key, details[key], {100, 16384}, {})) : usual;
}

/// {"svg": ...}
std::string svg_json(const Details& details, ui::Color background, const ui::Drawing& drawing)
{
    const std::filesystem::path file = "/picture.svg";
    ui::paint_to_svg(
        file,
        {.size = {side_of(details, "width", 1280.0), side_of(details, "height", 800.0)}, .background = background},
        drawing);
    std::ifstream in(file, std::ios::binary);
    femoop::JsonWriter json;
    json.begin_object().member("svg", std::string(std::istreambuf_iterator<char>(in), {})).end();
    return json.take();
}

std::string drawn(const femoop::Model& model, const Details& details)
{
    drawing::DrawOptions options;
    options.theme = theme_of(details);
    if (details.has("show")) options.show = drawing::parse_show(details["show"]);
    if (details.has("magnify")) options.deformation_scale = cli::positive_number("magnify", details["magnify"], {});
    options.is_envelope = details["case"] == "envelope" && !model.find_case("envelope") && model.n_cases() > 0;
    if (details.has("case") && !options.is_envelope)
        options.load_case = cli::find_case("case", model, details["case"], {});
    const auto picture = [&](const drawing::DrawInput& input) {
        return svg_json(details, drawing::background(options),
                        [&](ui::Painter& painter) { drawing::draw(painter, input, options); });
    };
    try {
        const femoop::Results results = femoop::analyse(model);
        return picture({.model = model, .results = &results});
    } catch (const femoop::MechanismError& error) {
        return picture({.model = model, .motion = frame::motion_choice(error.mechanisms(), 0, {})});
    }
}

::plane::PlateShown plate_shown(const std::string& list)
{
    ::plane::PlateShown all;
    for (const std::string& one : cli::comma_list(list)) {
        const auto shown = ::plane::plate_shown(one);
        if (!shown) throw cli::unknown_choice("show", one, ::plane::all_plate_words(), {});
        all = all | *shown;
    }
    return all;
}

std::string plane_drawn(fp::PlaneReading& reading, const Details& details)
{
    ::plane::PlateOptions options;
    options.theme = theme_of(details);
    if (details.has("show")) options.show = plate_shown(details["show"]);
    if (details.has("magnify")) options.deformation_scale = cli::positive_number("magnify", details["magnify"], {});
    const PlaneInput input(reading, options.show.needs_mesh() || options.show.needs_results()
                                        ? PlaneInput::Depth::Mesh
                                        : PlaneInput::Depth::Drawing);
    if (!reading.is_sound()) return core::faults_alone(reading.faults);
    if (details.has("case")) {
        const auto found = reading.model.find_case(details["case"]);
        if (!found) throw cli::UsageError("case: there is no \"" + details["case"] + "\"");
        options.load_case = *found;
    }
    ::plane::PlateInput shown{.model = reading.model, .drawing = input.drawing()};
    if (input.mesh() != nullptr) shown.mesh = &input.model();
    std::optional<fp::PlaneResults> results;
    if (options.show.needs_results()) shown.results = &results.emplace(fp::analyse(input.model()));
    return svg_json(details, ::plane::background(options),
                    [&](ui::Painter& painter) { ::plane::draw(painter, shown, options); });
}

// ---- methods by hand

std::string distributed(const femoop::Model& model, const Details& details)
{
    namespace fc = femoop::cross;
    const std::optional<fc::Block> block = fc::block_of(model);
    const std::string method = details.has("method") ? details["method"] : "cross";
    const femoop::CaseId load_case = details.has("case") ? cli::find_case("case", model, details["case"], {})
                                                         : fc::case_of(model, block);
    const fc::FarEnds ends = block ? fc::far_ends_of(model, load_case, *block) : fc::FarEnds::Modified;
    const fc::Problem problem = fc::problem_of(model, load_case, ends,
                                               method == "cross" ? fc::extent_of(block) : fc::Extent::Whole);
    if (method == "kani") return kani_json(model, problem, fc::kani(model, problem));
    if (method == "slope-deflection") return equations_json(model, problem, fc::slope_deflection(model, problem));
    if (method != "cross") throw cli::not_one_of("method", method, "cross, kani, slope-deflection", {});
    const fc::Procedure procedure = block ? fc::procedure_of(model, problem, *block) : fc::Procedure();
    const auto all = fc::superpose(model, problem, procedure);
    const auto comparison = fc::compare(model, problem, all.moments);
    return fc::sheet_json(fc::Worked{model, problem, procedure, all, comparison});
}

std::string circle(const Details& details)
{
    cli::MohrWords words;
    words.stress = details.list("stress");
    words.strain = details.list("strain");
    words.inertia = details.list("inertia");
    words.rosette_angles = details.list("rosetteAngles");
    words.rosette_readings = details.list("rosetteReadings");
    words.normal = details.list("normal");
    words.strength = details.list("strength");
    words.E = details["E"];
    words.nu = details["nu"];
    words.angle = details["angle"];
    words.criterion = details["criterion"];
    words.is_plane_strain = details["planeStrain"] == "true";
    const cli::MohrProblem problem = cli::mohr_problem(words, {});
    return cli::mohr_json(cli::mohr_results(problem), problem);
}

std::string no_members() { return fault_alone("wanted a structure of members; this is a plane model"); }

} // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE const char* core_solve(const char* model)
{
    return answer([&] { return of_model(model, core::solved, plane_solved); });
}

EMSCRIPTEN_KEEPALIVE const char* core_check(const char* model)
{
    return answer([&] { return checked(model); });
}

EMSCRIPTEN_KEEPALIVE const char* core_verify(const char* model)
{
    return answer([&] { return of_model(model, verified, plane_verified); });
}

EMSCRIPTEN_KEEPALIVE const char* core_render(const char* model, const char* details)
{
    return answer([&] {
        const Details read(details, {"show", "case", "theme", "magnify", "width", "height"});
        try {
            return of_model(
                model, [&](const femoop::Model& members) { return drawn(members, read); },
                [&](fp::PlaneReading& plane) { return plane_drawn(plane, read); });
        } catch (const drawing::ShowError& error) {
            return fault_alone(error.what());
        }
    });
}

EMSCRIPTEN_KEEPALIVE const char* core_cross(const char* model, const char* details)
{
    return answer([&] {
        const Details read(details, {"method", "case"});
        return of_model(
            model, [&](const femoop::Model& members) { return distributed(members, read); },
            [&](fp::PlaneReading&) { return no_members(); });
    });
}

EMSCRIPTEN_KEEPALIVE const char* core_mohr(const char* details)
{
    return answer([&] {
        return circle(Details(details, {"stress", "strain", "inertia", "rosetteAngles", "rosetteReadings", "normal",
                                        "strength", "E", "nu", "angle", "criterion", "planeStrain"}));
    });
}

EMSCRIPTEN_KEEPALIVE const char* core_euler(const char* script)
{
    return answer([&] {
        topology::ScriptRunner runner;
        run_script(runner, script, {});
        return cli::euler_json(cli::living_solids(runner), runner.n_steps());
    });
}

} // extern "C"
