#include "apps/frame/window/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/reading.h"
#include "apps/drawing/sketch/scene.h"
#include "apps/frame/session/edit_commands.h"
#include "apps/frame/session/tabs.h"
#include "femoop/io/derivation/derivation_text.h"
#include "femoop/methods/influence/effect_name.h"
#include "ui/app/expectation.h"
#include "ui/app/headless.h"
#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace frame {

namespace {

using ui::compared;
using ui::joined;
using ui::Mismatch;
using ui::words_of;

// "50%" or a length from the start.
std::optional<double> along(std::string_view text, double length)
{
    if (text.ends_with('%')) {
        const auto percent = ui::number_typed(text.substr(0, text.size() - 1));
        return percent ? std::optional(0.01 * *percent * length) : std::nullopt;
    }
    return ui::number_typed(text);
}

// member AB M at 50% is -12.5 kN·m
Mismatch value(const Application& application, std::string_view text)
{
    constexpr const char* form =
        "value: wanted member NAME QUANTITY at PLACE is VALUE, such as \"member AB M at 50% is -12.5 kN·m\"";
    const std::vector<std::string> words = words_of(text);
    const bool is_understood = words.size() >= 7 && words[0] == "member" && words[3] == "at" && words[5] == "is";
    if (!is_understood) return form;
    const Session& session = application.session();
    const auto cut = cut_at(session.model(), words[1], words[4]);
    if (!cut) return "value: found no place " + words[4] + " of a member \"" + words[1] + "\"";
    if (!session.shown_results()) return "value: found no results; expect problems 0 to see why";
    std::string names;
    for (const ReadingLine& line : reading(session.model(), *session.shown_results(), session.view, *cut)) {
        if (line.name == words[2]) return compared(line.name, line.value, with_minus(joined(words, 6)));
        names += (names.empty() ? "" : ", ") + line.name;
    }
    return "value: found \"" + words[2] + "\", wanted one of " + names;
}

// Where a node lies in the window; half a pixel is nothing.
Mismatch at_pixel(const Application& application, femoop::NodeId node, const ui::PointerPlace& wanted)
{
    const femoop::Model& model = application.session().model();
    const std::string what = "node " + model[node].id;
    const auto drawn = application.canvas().in_window(shape_of(model)[node]);
    if (!drawn) return what + ": found no picture yet";
    const ui::Point found = application.gui().in_window(*drawn);
    if (std::hypot(found.x - wanted.x, found.y - wanted.y) <= 0.5) return std::nullopt;
    std::ostringstream words;
    words << what << ": found at pixel " << found.x << ' ' << found.y << ", wanted pixel " << wanted.x << ' '
          << wanted.y;
    return words.str();
}

// B at (2, 4), or B at pixel 302 609
Mismatch node(const Application& application, std::string_view text)
{
    const std::vector<std::string> words = words_of(text);
    const femoop::Model& model = application.session().model();
    const auto id = words.empty() ? std::nullopt : model.find_node(words[0]);
    if (!id) return "node: found no node \"" + (words.empty() ? "" : words[0]) + "\" in the model";
    const std::string place_text = words.size() >= 3 && words[1] == "at" ? joined(words, 2) : "";
    const Eigen::Vector3d found = shape_of(model)[*id];
    if (const auto pixel = ui::pixel_place(place_text)) return at_pixel(application, *id, *pixel);
    const auto wanted = point_in(place_text);
    if (!wanted) return "node: wanted NAME at (X, Y) or NAME at pixel X Y";
    constexpr double tolerance = 1e-3; // places are written with few digits
    if ((found - *wanted).norm() <= tolerance) return std::nullopt;
    std::ostringstream place;
    place << '(' << found.x() << ", " << found.y();
    if (femoop::n_coordinates(model.analysis) == 3) place << ", " << found.z();
    return "node " + words[0] + ": found at " + place.str() + "), wanted " + joined(words, 2);
}

std::string selection_text(const Session& session)
{
    const ui::Catalogue english;
    std::string text;
    for (const Part& part : session.selection.parts())
        text += (text.empty() ? "" : ", ") + english(title(session.document(), part));
    return text.empty() ? "nothing" : text;
}

std::string sentence_or_nothing(const std::optional<ui::Message>& message)
{
    return message ? ui::Catalogue()(*message) : "nothing";
}

std::string tool_in(const ToolController& tool_controller)
{
    if (tool_controller.kind() == ToolKind::Paste) return "edit.paste";
    return std::string(std::ranges::find(tools(), tool_controller.kind(), &ToolEntry::value)->id);
}

// "5 of 24, nested-dissection"
std::string front_of(const Workspace& workspace)
{
    if (!workspace.bottom.shows(BottomContent::Solver) || workspace.solver.n_steps() == 0) return "nothing";
    return std::to_string(workspace.solver.step() + 1) + " of " + std::to_string(workspace.solver.n_steps()) + ", " +
           std::string(name(workspace.solver.ordering()));
}

// "3 of 9, M(BC, 50%)"
std::string derivation_of(const Workspace& workspace)
{
    const femoop::derivation::Derivation* const derivation = workspace.derivation.derivation();
    if (!workspace.bottom.shows(BottomContent::Derivation) || derivation == nullptr) return "nothing";
    const femoop::Model& model = workspace.derivation.model(workspace.session);
    return std::to_string(workspace.derivation.step() + 1) + " of " + std::to_string(workspace.derivation.n_steps()) +
           ", " +
           femoop::derivation::number_name(*derivation, femoop::influence::effect_name(model, derivation->effect));
}

std::size_t n_loads(const femoop::Model& model)
{
    std::size_t n = 0;
    for (const femoop::LoadCase& load_case : model.load_cases) n += load_case.nodes.size() + load_case.members.size();
    return n;
}

std::string blank_in(const Session& session)
{
    std::string names;
    for (const BlankCase& one : session.solution().blank)
        names += (names.empty() ? "" : ", ") + session.model().case_name(one.id);
    return names.empty() ? "nothing" : names;
}

using Fact = ui::Fact<Application>;
const ui::Facts<Application>& facts()
{
    static const ui::Facts<Application> all(
        {
            Fact{"nodes", [](const Application& a) { return std::to_string(a.session().model().nodes.size()); }},
            Fact{"members", [](const Application& a) { return std::to_string(a.session().model().members.size()); }},
            Fact{"dimensions",
                 [](const Application& a) {
                     return std::to_string(a.session().document().companion.dimensions.size());
                 }},
            Fact{"loads", [](const Application& a) { return std::to_string(n_loads(a.session().model())); }},
            Fact{"undo", [](const Application& a) { return sentence_or_nothing(a.session().history().undo_label()); }},
            Fact{"redo", [](const Application& a) { return sentence_or_nothing(a.session().history().redo_label()); }},
            Fact{"selection", [](const Application& a) { return selection_text(a.session()); }},
            Fact{"case",
                 [](const Application& a) { return a.session().model().case_name(a.session().view.load_case); }},
            Fact{"problems", [](const Application& a) { return std::to_string(a.session().solution().faults.size()); }},
            Fact{"blank", [](const Application& a) { return blank_in(a.session()); }},
            Fact{"cell", [](const Application& a) { return a.tables().cell(a.workspace()).value_or("nothing"); }},
            Fact{"tool", [](const Application& a) { return tool_in(a.workspace().tool_controller); }},
            Fact{"typed",
                 [](const Application& a) {
                     const std::string& typed = a.workspace().tool_controller.typed();
                     return typed.empty() ? "nothing" : typed;
                 }},
            Fact{"front", [](const Application& a) { return front_of(a.workspace()); }},
            Fact{"derivation", [](const Application& a) { return derivation_of(a.workspace()); }},
            Fact{"tabs", [](const Application& a) { return std::to_string(n_tabs(a.workspace())); }},
            Fact{"started",
                 [](const Application& a) { return a.handed() ? a.handed()->program : std::string("nothing"); }},
        },
        ", value, node");
    return all;
}

} // namespace

std::optional<Cut> cut_at(const femoop::Model& model, const std::string& member, std::string_view at)
{
    const auto id = model.find_member(member);
    if (!id) return std::nullopt;
    const auto x = along(at, shape_of(model)[*id].length);
    return x ? std::optional(Cut{*id, *x}) : std::nullopt;
}

std::optional<Eigen::Vector3d> point_in(std::string_view text)
{
    if (text.size() < 5 || text.front() != '(' || text.back() != ')') return std::nullopt;
    std::istringstream stream{std::string(text.substr(1, text.size() - 2))};
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    std::string coordinate;
    Eigen::Index i = 0;
    for (; i < 3 && std::getline(stream, coordinate, ','); ++i) {
        const auto value = ui::number_typed(coordinate);
        if (!value) return std::nullopt;
        point[i] = *value;
    }
    return i >= 2 ? std::optional(point) : std::nullopt;
}

std::optional<std::string> why_not(std::string_view expectation, const Application& application)
{
    const auto [what, rest] = ui::first_word(expectation);
    if (what == "value") return value(application, rest);
    if (what == "node") return node(application, rest);
    return facts().mismatch(expectation, application);
}

} // namespace frame
