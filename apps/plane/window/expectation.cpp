#include "apps/plane/window/expectation.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "apps/plane/document/load_cases.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/view/plate_scene.h"
#include "apps/plane/view/probe_values.h"
#include "femoop/io/plane/field_text.h"
#include "ui/app/expectation.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace plane {

namespace {

void append(std::string& text, const std::string& more) { text += (text.empty() ? "" : ", ") + more; }
std::string or_nothing(std::string text) { return text.empty() ? "nothing" : text; }

const PlaneModel& model(const Application& application) { return application.session().model(); }

std::string faces(const Application& application)
{
    const auto* const drawing = application.session().drawing();
    return drawing != nullptr ? std::to_string(drawing->faces().size()) : "nothing";
}

std::string empty_faces(const Application& application)
{
    const auto* const drawing = application.session().drawing();
    if (drawing == nullptr) return "nothing";
    return std::to_string(std::ranges::count_if(drawing->faces(), [](const auto& face) { return !face.region; }));
}

std::string regions(const Application& application)
{
    std::string text;
    for (const auto& region : model(application).regions)
        append(text, region.id + ": " + (region.is_hole ? "hole" : model(application)[region.material].id));
    return or_nothing(text);
}

std::string areas(const Application& application)
{
    std::string text;
    if (const auto* const drawing = application.session().drawing())
        for (const auto& face : drawing->faces()) text += (text.empty() ? "" : " ") + ui::number_text(face.area);
    return or_nothing(text);
}

std::string selection(const Application& application)
{
    std::string text;
    for (const Part& part : application.session().selection())
        append(text, ui::Catalogue()(title(application.session(), part)));
    return or_nothing(text);
}

std::string supports(const Application& application)
{
    std::string text;
    for (const auto& point : model(application).points)
        if (point.support) append(text, point.id);
    for (const auto& curve : model(application).curves)
        if (curve.support) append(text, curve.id);
    return or_nothing(text);
}

/// "2: 12.3 Hz"
std::string mode(const Application& application)
{
    const Session& session = application.session();
    const auto* const modes = session.modes();
    if (modes == nullptr || session.look.mode >= modes->modes.size()) return "nothing";
    return std::to_string(session.look.mode + 1) + ": " +
           mode_texts(*modes, session.look.mode, session.options().numbers).frequency;
}

/// " qx 100", or a field as files have it; nothing where it is not given.
std::string given(const Number& number, std::string_view name)
{
    const std::string before = " " + std::string(name) + " ";
    if (number.field) return before + femoop::plane::field_text(*number.field);
    return number.value ? before + ui::number_text(*number.value) : "";
}

std::string loads(const Application& application)
{
    const Session& session = application.session();
    if (session.load_case >= session.model().load_cases.size()) return "nothing";
    std::string text;
    const auto add = [&](std::size_t load, const auto& parts, auto first) {
        std::string names;
        for (const auto part : parts) names += (names.empty() ? "" : "+") + session.model()[part].id;
        if (names.empty()) names = "all";
        const std::vector<std::size_t> on_first = loads_on(session.model(), session.load_case, first);
        const auto nth = static_cast<std::size_t>(std::ranges::find(on_first, load) - on_first.begin());
        for (const Number& number : numbers(session.model(), session.load_case, nth, first))
            names += given(number, number.id);
        append(text, names);
    };
    const femoop::plane::PlaneLoadCase& shown = session.model().load_cases[session.load_case];
    for (std::size_t i = 0; i < shown.curves.size(); ++i)
        add(i, shown.curves[i].curves, shown.curves[i].curves.front());
    for (std::size_t i = 0; i < shown.regions.size(); ++i) { // one without regions is of all
        const std::vector<RegionId>& regions = shown.regions[i].regions;
        add(i, regions, regions.empty() ? RegionId(0U) : regions.front());
    }
    return or_nothing(text);
}

// "C factor G 1.4 factor Q 1": the case that is shown
std::string shown_case(const Application& application)
{
    const Session& session = application.session();
    const femoop::CaseId shown(session.load_case);
    if (shown.index >= session.model().n_cases()) return "nothing";
    std::string text = session.model().case_name(shown);
    for (const Number& number : numbers(session.model(), shown)) text += given(number, number.id);
    return text;
}

// "bottom uy 0.25": of the case that is shown
std::string settlements(const Application& application)
{
    const Session& session = application.session();
    const auto of_part = [](const std::string& id, const std::vector<Number>& numbers) {
        constexpr std::string_view settlement = "settlement ";
        std::string values;
        for (const Number& number : numbers)
            if (number.id.starts_with(settlement))
                values += given(number, std::string_view(number.id).substr(settlement.size()));
        return values.empty() ? values : id + values;
    };
    std::string text;
    const auto add = [&](const std::string& more) {
        if (!more.empty()) append(text, more);
    };
    const PlaneModel& shown = session.model();
    for (std::size_t i = 0; i < shown.points.size(); ++i)
        add(of_part(shown.points[i].id, numbers(shown, NodeId(i), session.load_case)));
    for (std::size_t i = 0; i < shown.curves.size(); ++i)
        add(of_part(shown.curves[i].id, numbers(shown, CurveId(i), session.load_case)));
    return or_nothing(text);
}

std::string gap(const Application& application)
{
    const auto found = told_gap(application.workspace());
    return found ? ui::number_text(found->width) : "nothing";
}

std::string dispute(const Application& application)
{
    const auto& found = application.session().solution().dispute();
    return found ? model(application)[found->first].id + ", " + model(application)[found->second].id : "nothing";
}

std::string mesh_size(const Application& application)
{
    const Analysed* const found = application.session().analysed();
    return found != nullptr && found->mesh() != nullptr ? std::to_string(found->mesh()->elements.size()) : "nothing";
}

std::string why_unsolved(const Application& application)
{
    const auto why = application.session().why_no_results();
    return why ? ui::Catalogue()(*why) : "nothing";
}

std::string range(const Application& application)
{
    const auto& kept = application.session().look.range;
    return kept ? ui::number_text(kept->low) + " " + ui::number_text(kept->high) : "nothing";
}

std::string table(const Application& application)
{
    const auto shown = application.workspace().table;
    return shown ? std::string(std::ranges::find(tables(), *shown, &TableEntry::value)->id) : "nothing";
}

// "12 of 340"
std::string mesher_step(const Application& application)
{
    const discretize::MeshPlayer* const player = application.session().player();
    return player != nullptr ? std::to_string(player->place()) + " of " + std::to_string(player->n_steps()) : "nothing";
}

// "12.9 7.4 4.6": the errors of the meshes of a cycle, in percent
std::string cycle_errors(const Application& application)
{
    const discretize::ErrorCycle* const cycle = application.session().cycle();
    std::string errors;
    if (cycle != nullptr)
        for (const discretize::MeshError& mesh : cycle->meshes())
            errors += (errors.empty() ? "" : " ") + ui::number_text(100.0 * mesh.error, {.digits = 2});
    return or_nothing(errors);
}

std::string tool(const Application& application)
{
    return std::string(std::ranges::find(tools(), application.workspace().hand.tool(), &ToolEntry::value)->id);
}

// "bracket.jpg 0 0 to 120 5": the image behind the drawing, and both ends of its bottom side
std::string background(const Application& application)
{
    const auto& backdrop = application.session().document().backdrop;
    if (!backdrop) return "nothing";
    const auto place = [](const FlatPoint& p) { return ui::number_text(p.x) + " " + ui::number_text(p.y); };
    return backdrop->file.filename().string() + " " + place(backdrop->corner) + " to " +
           place(backdrop->corner + backdrop->across);
}

// "A 70 30"
ui::Mismatch place(const Application& application, std::string_view text)
{
    const auto words = ui::words_of(text);
    const auto& points = model(application).points;
    const auto point = words.empty() ? points.end()
                                     : std::ranges::find(points, words[0], &femoop::plane::PlanePoint::id);
    if (point == points.end()) return "at: found no such point, wanted NAME X Y";
    const std::string found = point->id + " " + ui::number_text(point->at[0]) + " " + ui::number_text(point->at[1]);
    return ui::compared("at", found, std::string(text));
}

// "1 σx 99.7": a value of a probe, smoothed
ui::Mismatch probed(const Application& application, std::string_view text)
{
    const Session& session = application.session();
    const auto words = ui::words_of(text);
    const PlateInput input = session.input();
    const std::size_t n = words.empty() ? 0 : static_cast<std::size_t>(std::atoi(std::string(words[0]).c_str()));
    const auto& probes = session.look.readings.probes;
    if (words.size() < 2 || n < 1 || n > probes.size()) return "probed: found no such probe, wanted N SYMBOL VALUE";
    std::string found = std::string(words[0]) + " " + std::string(words[1]) + " nothing";
    const auto state = input.result != nullptr
                           ? probe_state(*input.results, *input.result, {probes[n - 1].x, probes[n - 1].y})
                           : std::nullopt;
    if (state)
        for (const ProbeValue& value : state->values)
            if (value.symbol == words[1])
                found = std::string(words[0]) + " " + value.symbol + " " + ui::number_text(value.smoothed);
    return ui::compared("probed", found, std::string(text));
}

// "1 N 0 V -1000 M 2e5": of a cut, to two digits
ui::Mismatch cut_forces(const Application& application, std::string_view text)
{
    const Session& session = application.session();
    const PlateInput input = session.input();
    const auto words = ui::words_of(text);
    const std::size_t n = words.empty() ? 0 : static_cast<std::size_t>(std::atoi(std::string(words[0]).c_str()));
    const auto cuts = session.options().cuts;
    if (n < 1 || n > cuts.size() || input.result == nullptr) return "cut: found no such cut, wanted N N V M";
    const auto forces = input.result->forces(cuts[n - 1]);
    const double size = std::max({std::abs(forces.N), std::abs(forces.V), std::abs(forces.M) / cuts[n - 1].length()});
    const auto number = [&](double v, double beside) {
        return ui::number_text(std::abs(v) < 5e-3 * beside ? 0.0 : v, {.digits = 2});
    };
    const std::string found = std::to_string(n) + " N " + number(forces.N, size) + " V " + number(forces.V, size) +
                              " M " + number(forces.M, size * cuts[n - 1].length());
    return ui::compared("cut", found, std::string(text));
}

const ui::Facts<Application>& facts()
{
    static const ui::Facts<Application> all(
        {
            {"points", [](const Application& a) { return std::to_string(model(a).points.size()); }},
            {"curves", [](const Application& a) { return std::to_string(model(a).curves.size()); }},
            {"faces", faces},
            {"empty", empty_faces},
            {"regions", regions},
            {"areas", areas},
            {"selection", selection},
            {"supports", supports},
            {"loads", loads},
            {"case", shown_case},
            {"settlements", settlements},
            {"problems", [](const Application& a) { return std::to_string(a.session().solution().faults().size()); }},
            {"gap", gap},
            {"dispute", dispute},
            {"elements", mesh_size},
            {"reason", why_unsolved},
            {"step", mesher_step},
            {"mode", mode},
            {"cycle", cycle_errors},
            {"probes", [](const Application& a) { return std::to_string(a.session().look.readings.probes.size()); }},
            {"cuts", [](const Application& a) { return std::to_string(a.session().look.readings.cuts.size()); }},
            {"range", range},
            {"table", table},
            {"tool", tool},
            {"background", background},
            {"typed", [](const Application& a) { return or_nothing(a.workspace().hand.typed()); }},
        },
        ", at, probed, cut");
    return all;
}

} // namespace

std::optional<std::string> why_not(std::string_view expectation, const Application& application)
{
    const auto [what, rest] = ui::first_word(expectation);
    if (what == "at") return place(application, rest);
    if (what == "probed") return probed(application, rest);
    if (what == "cut") return cut_forces(application, rest);
    return facts().mismatch(expectation, application);
}

} // namespace plane
