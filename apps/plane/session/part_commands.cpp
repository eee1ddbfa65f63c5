#include "apps/plane/session/part_commands.h"

#include <algorithm>
#include <array>
#include <memory>

#include "apps/drawing/quantity_typed.h"
#include "apps/plane/document/attributes.h"
#include "apps/plane/document/load_cases.h"
#include "apps/plane/document/regions.h"
#include "femoop/io/plane/field_text.h"
#include "ui/scenario/words.h"

namespace plane {

using femoop::plane::CurveLoadKind;
using ui::Key;
using ui::Message;
using ui::Reason;
using ui::translatable;
using Menu = ui::MenuBuilder<Workspace>;

namespace {

template <class Kind> std::vector<Kind> selected(const Workspace& workspace)
{
    return all_of_kind<Kind>(workspace.session.selection());
}

// ---- regions

std::optional<std::size_t> selected_face(const Workspace& workspace)
{
    const std::vector<FacePlace> places = selected<FacePlace>(workspace);
    return places.size() == 1 ? workspace.session.face_of(places.front()) : std::nullopt;
}

Reason needs_face(const Workspace& workspace)
{
    if (selected_face(workspace)) return std::nullopt;
    return translatable("select a face first");
}

bool is_hole(const Workspace& workspace)
{
    const auto region = workspace.session.selected_region();
    return region && workspace.session.model()[*region].is_hole;
}

void turn_hole(Workspace& workspace, bool is_on)
{
    const auto face = *selected_face(workspace);
    const std::shared_ptr<const Solution> solution = workspace.session.kept_solution();
    workspace.change({is_on ? translatable("Make a hole") : translatable("Fill a hole"),
                      [=](Document& document) { set_hole(document, *solution->drawing(), face, is_on); }});
}

Reason why_not_part_off(const Workspace& workspace)
{
    if (const Reason reason = needs_face(workspace)) return reason;
    const auto region = workspace.session.selected_region();
    if (region && faces_of_regions(*workspace.session.drawing())[region->index].size() > 1) return std::nullopt;
    return translatable("the face shares its region with no other");
}

void part_off_face(Workspace& workspace)
{
    const auto face = *selected_face(workspace);
    const std::shared_ptr<const Solution> solution = workspace.session.kept_solution();
    workspace.change({translatable("Make a region of its own"),
                      [=](Document& document) { part_off(document, *solution->drawing(), face); }});
}

void add_region_commands(CommandTable& table)
{
    Menu menu(table, translatable("Region"));
    menu.toggle({"region.hole", translatable("Hole"), {{Key::H, {}}}}, is_hole, turn_hole, needs_face);
    menu.step({"region.own", translatable("Make a region of its own"), {{Key::R, {}}}}, part_off_face,
              why_not_part_off);
}

// ---- supports

/// How all of the selection is held.
struct Held {
    std::optional<PlaneSupportKind> kind{}; ///< nothing: it is free
    bool differs = false;                   ///< some are held otherwise than others
    friend bool operator==(const Held&, const Held&) = default;
};

using SupportEntry = ui::Choice<Held>;
constexpr std::array support_entries{
    SupportEntry{{}, "support.none", translatable("Free"), {{Key::Digit0, {}}}},
    SupportEntry{{PlaneSupportKind::Fixed}, "support.fixed", translatable("Fixed"), {{Key::Digit1, {}}}},
    SupportEntry{{PlaneSupportKind::Roller}, "support.roller", translatable("Roller"), {{Key::Digit2, {}}}},
    SupportEntry{{PlaneSupportKind::Symmetry}, "support.symmetry", translatable("Symmetry"), {{Key::Digit3, {}}}},
    SupportEntry{{PlaneSupportKind::Custom}, "support.own", translatable("Own axes and springs"), {{Key::Digit4, {}}}},
};

Reason why_no_support(const Workspace& workspace)
{
    const auto& parts = workspace.session.selection();
    const bool are_held = std::ranges::none_of(
        parts, [](const Part& part) { return std::holds_alternative<FacePlace>(part); });
    if (!parts.empty() && are_held) return std::nullopt;
    return translatable("select points or curves first");
}

Held how_held(const Session& session, const Part& part)
{
    const PlaneSupport* const support = support_of(session, part);
    if (support == nullptr) return {};
    return {support->kind == PlaneSupportKind::Pin ? PlaneSupportKind::Fixed : support->kind};
}

Held how_selection_is_held(const Workspace& workspace)
{
    const std::vector<Part>& parts = workspace.session.selection();
    if (parts.empty()) return {};
    Held held = how_held(workspace.session, parts.front());
    for (const Part& part : parts) held.differs = held.differs || how_held(workspace.session, part) != Held{held.kind};
    return held;
}

void choose_support(Workspace& workspace, const Held& held)
{
    const std::vector<Part> parts = workspace.session.selection();
    workspace.change({translatable("Change the support"), [parts, kind = held.kind](Document& document) {
                          for (const Part& part : parts) {
                              if (const auto* const point = std::get_if<NodeId>(&part))
                                  set_support(document, *point, kind);
                              if (const auto* const curve = std::get_if<CurveId>(&part))
                                  set_support(document, *curve, kind);
                          }
                      }});
}

using TieEntry = ui::Choice<femoop::Dof>;
constexpr std::array tie_entries{
    TieEntry{femoop::Dof::ux, "support.tie_ux", translatable("One ux along the curve")},
    TieEntry{femoop::Dof::uy, "support.tie_uy", translatable("One uy along the curve")},
};

Reason why_no_tie(const Workspace& workspace)
{
    if (!selected<CurveId>(workspace).empty()) return std::nullopt;
    return translatable("select curves first");
}

bool are_tied(const Workspace& workspace, femoop::Dof dof)
{
    return !why_no_tie(workspace) && std::ranges::all_of(selected<CurveId>(workspace), [&](CurveId curve) {
        return workspace.session.model()[curve].tie.contains(dof);
    });
}

void tie(Workspace& workspace, femoop::Dof dof, bool is_tied)
{
    workspace.change(
        {translatable("Change the support"), [=, curves = selected<CurveId>(workspace)](Document& document) {
             for (const CurveId curve : curves) {
                 femoop::DofSet& tied = document.model.curves[curve.index].tie;
                 if (is_tied) tied.insert(dof);
                 else tied.erase(dof);
             }
         }});
}

// ---- loads

using LoadEntry = ui::Choice<CurveLoadKind>;
constexpr std::array load_entries{
    LoadEntry{CurveLoadKind::Traction, "load.traction", translatable("Add a traction")},
    LoadEntry{CurveLoadKind::Pressure, "load.pressure", translatable("Add a pressure")},
    LoadEntry{CurveLoadKind::Line, "load.line", translatable("Add a force per length")},
};

using RegionLoadEntry = ui::Choice<RegionLoadKind>;
constexpr std::array region_load_entries{
    RegionLoadEntry{RegionLoadKind::Body, "load.body", translatable("Add a body force")},
    RegionLoadEntry{RegionLoadKind::Temperature, "load.temperature", translatable("Add a rise of temperature")},
    RegionLoadEntry{RegionLoadKind::Rotation, "load.rotation", translatable("Add a steady rotation")},
};

Reason why_no_case(const Workspace& workspace)
{
    const std::size_t n = workspace.session.model().load_cases.size();
    if (workspace.session.load_case < std::max<std::size_t>(n, 1)) return std::nullopt;
    return translatable("loads belong to a load case; a combination is shown");
}

/// The names of those that a case has a factor in.
std::string combinations_with(const PlaneModel& model, femoop::CaseId id)
{
    std::string names;
    for (const femoop::Combination& each : model.combinations)
        if (std::ranges::any_of(each.terms, [id](const auto& term) { return term.of == id; }))
            names += (names.empty() ? "" : ", ") + each.id;
    return names;
}

Reason why_no_load(const Workspace& workspace)
{
    if (selected<CurveId>(workspace).empty()) return translatable("select curves first");
    return why_no_case(workspace);
}

Reason why_no_region_load(const Workspace& workspace)
{
    const std::vector<RegionId> regions = workspace.session.selected_regions();
    const auto is_empty = [&](RegionId region) { return workspace.session.model()[region].is_hole; };
    if (regions.empty() || std::ranges::any_of(regions, is_empty)) return translatable("select a region first");
    return why_no_case(workspace);
}

template <class Id, class Kind> void add_load_to(Workspace& workspace, const std::vector<Id>& holders, Kind kind)
{
    workspace.change({translatable("Add a load"), [=, load_case = workspace.session.load_case](Document& document) {
                          add_load(document, load_case, holders, kind);
                      }});
}

void add_load_commands(CommandTable& table)
{
    Menu menu(table, translatable("Loads"));
    for (const LoadEntry& entry : load_entries)
        menu.step(
            {entry.id, entry.label, {}},
            [kind = entry.value](Workspace& workspace) { add_load_to(workspace, selected<CurveId>(workspace), kind); },
            why_no_load);
    for (const RegionLoadEntry& entry : region_load_entries)
        menu.step(
            {entry.id, entry.label, {}},
            [kind = entry.value](Workspace& workspace) {
                add_load_to(workspace, workspace.session.selected_regions(), kind);
            },
            why_no_region_load);
    menu.step({"case.add", translatable("Add a load case")}, [](Workspace& workspace) {
        workspace.change({translatable("Add a load case"), add_load_case});
        workspace.session.load_case = workspace.session.model().load_cases.size() - 1;
    });
    menu.step(
        {"case.combination", translatable("Add a combination")},
        [](Workspace& workspace) {
            workspace.change({translatable("Add a combination"), add_combination});
            workspace.session.load_case = workspace.session.model().n_cases() - 1;
        },
        [](const Workspace& workspace) -> Reason {
            if (!workspace.session.model().load_cases.empty()) return std::nullopt;
            return translatable("there is no load case to combine yet");
        });
    menu.step(
            {"case.delete", translatable("Delete the load case or combination"), {}},
            [](Workspace& workspace) {
                const Session& session = workspace.session;
                const femoop::CaseId shown(session.load_case);
                const std::string combinations = combinations_with(session.model(), shown);
                workspace.change({Message(translatable("Delete: {part}"), {{"part", title(session, shown)}}),
                                  [shown](Document& document) { erase_case(document, shown); }});
                if (!combinations.empty())
                    workspace.notify(
                        {translatable("These combinations are without it now: {names}"), {{"names", combinations}}});
            },
            [](const Workspace& workspace) -> Reason {
                if (workspace.session.load_case < workspace.session.model().n_cases()) return std::nullopt;
                return translatable("there is no load case yet");
            })
        .live_label = [](const Workspace& workspace) {
        const Session& session = workspace.session;
        const femoop::CaseId shown(session.load_case);
        if (shown.index >= session.model().n_cases())
            return Message(translatable("Delete the load case or combination"));
        return Message(translatable("Delete: {part}"), {{"part", title(session, shown)}});
    };
    menu.step({"case.next", translatable("Next load case"), {{Key::PageDown, {}}}}, [](Workspace& workspace) {
        const std::size_t n = std::max<std::size_t>(workspace.session.model().n_cases(), 1);
        workspace.session.load_case = (workspace.session.load_case + 1) % n;
    });
}

// ---- the kind of analysis

using AnalysisEntry = ui::Choice<femoop::StressState>;
constexpr std::array analysis_entries{
    AnalysisEntry{femoop::StressState::PlaneStress, "analysis.plane_stress", translatable("Plane stress")},
    AnalysisEntry{femoop::StressState::PlaneStrain, "analysis.plane_strain", translatable("Plane strain")},
    AnalysisEntry{femoop::StressState::Axisymmetric, "analysis.axisymmetric", translatable("Axisymmetric")},
};

/// Thicknesses come and go with the kind: a plate needs them, a body of revolution has none.
void set_analysis(Document& document, femoop::StressState kind)
{
    PlaneModel& model = document.model;
    model.analysis = kind;
    for (auto& region : model.regions) {
        if (kind == femoop::StressState::Axisymmetric) region.thickness.reset();
        if (kind == femoop::StressState::PlaneStress && !region.thickness && !region.is_hole)
            region.thickness = femoop::Quantity(0.01 / femoop::metres(model.units.length), "10 mm");
    }
}

void add_analysis_commands(CommandTable& table)
{
    Menu(table, translatable("Region"))
        .choices(
            analysis_entries, [](const Workspace& workspace) { return workspace.session.model().analysis; },
            [](Workspace& workspace, femoop::StressState kind) {
                workspace.change({translatable("Change the kind of analysis"),
                                  [kind](Document& document) { set_analysis(document, kind); }});
            });
}

// ---- what a scenario gives

template <class Entries> std::optional<std::size_t> named(const Entries& entries, std::string_view name)
{
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (entries[i].id == name) return i;
    return std::nullopt;
}

/// "curve C1", "point A", "face 30 10"; several with "and" between them.
Reason select_named(Workspace& workspace, const ui::Argument& argument)
{
    const auto words = argument.words();
    Session& session = workspace.session;
    session.select_nothing();
    for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
        if (words[i] == "and") ++i;
        if (i + 1 >= words.size()) break;
        const auto point = words[i] == "point" ? named(session.model().points, words[i + 1]) : std::nullopt;
        const auto curve = words[i] == "curve" ? named(session.model().curves, words[i + 1]) : std::nullopt;
        if (point) session.toggle(NodeId(*point));
        else if (curve) session.toggle(CurveId(*curve));
        else return argument.wanted("point NAME or curve NAME, with \"and\" between several");
    }
    return std::nullopt;
}

/// What a face's panel shows besides: of the region's material and of the case.
void add_numbers_about(std::vector<Number>& all, const Session& session, RegionId region)
{
    const PlaneModel& model = session.model();
    const auto add = [&all](std::vector<Number> more) {
        for (Number& number : more) all.push_back(std::move(number));
    };
    if (!model[region].is_hole && model[region].material.index < model.materials.size())
        add(numbers(model, model[region].material));
    if (session.load_case < model.load_cases.size()) add(numbers(model, femoop::CaseId(session.load_case)));
}

template <class Id>
void add_numbers_of_loads(std::vector<Number>& all, const Session& session, const std::vector<Id>& holders)
{
    for (const LoadPlaces& places : loads_of_all(session.model(), session.load_case, holders))
        for (Number& number : numbers_of_load(session, holders, places)) all.push_back(std::move(number));
}

/// "thickness 12 mm": one of the numbers of something.
Reason set_one_of(Workspace& workspace, const Message& whose, const std::vector<Number>& all,
                  const ui::Argument& argument)
{
    const Number* meant = nullptr; // "qy end" rather than "qy"
    std::string known;
    for (const Number& number : all) {
        const bool is_meant = argument.text.starts_with(number.id + " ");
        if (is_meant && (meant == nullptr || number.id.size() > meant->id.size())) meant = &number;
        known += (known.empty() ? "" : ", ") + number.id;
    }
    if (meant != nullptr) return set_typed(workspace, whose, *meant, argument.text.substr(meant->id.size() + 1));
    return argument.wanted("one of " + known + " and a number");
}

/// A number of what is selected, of the first load too that has one of the name.
Reason set_of_selected(Workspace& workspace, const ui::Argument& argument)
{
    const std::vector<Part>& parts = workspace.session.selection();
    if (parts.empty()) return Message(translatable("nothing is selected"));
    std::vector<Number> all = numbers_of(workspace.session, parts);
    add_numbers_of_loads(all, workspace.session, selected<CurveId>(workspace));
    add_numbers_of_loads(all, workspace.session, workspace.session.selected_regions());
    if (const auto region = workspace.session.selected_region()) add_numbers_about(all, workspace.session, *region);
    return set_one_of(workspace, title(workspace.session, parts), all, argument);
}

/// "factor G 1.4": a number of the case that is shown.
Reason set_of_case(Workspace& workspace, const ui::Argument& argument)
{
    const Session& session = workspace.session;
    const femoop::CaseId shown(session.load_case);
    if (shown.index >= session.model().n_cases()) return Message(translatable("there is no load case yet"));
    return set_one_of(workspace, title(session, shown), numbers(session.model(), shown), argument);
}

} // namespace

void add_part_commands(CommandTable& table)
{
    add_region_commands(table);
    add_analysis_commands(table);
    Menu supports(table, translatable("Support"));
    supports.choices(support_entries, how_selection_is_held, choose_support, why_no_support);
    supports.toggles(tie_entries, are_tied, tie, why_no_tie);
    add_load_commands(table);
    table.with_argument("part.select", select_named);
    table.with_argument("part.set", set_of_selected);
    table.with_argument("case.set", set_of_case);
}

Message title(const Session& session, const Part& part)
{
    const PlaneModel& model = session.model();
    if (const auto* const point = std::get_if<NodeId>(&part))
        return {translatable("Point {id}"), {{"id", model[*point].id}}};
    if (const auto* const curve = std::get_if<CurveId>(&part))
        return {translatable("Curve {id}"), {{"id", model[*curve].id}}};
    const auto region = session.region_of(part);
    if (!region) return translatable("Face without a region");
    return {model[*region].is_hole ? translatable("Hole {id}") : translatable("Region {id}"),
            {{"id", model[*region].id}}};
}

Message title(const Session& session, const std::vector<Part>& parts)
{
    if (parts.size() == 1) return title(session, parts.front());
    std::string_view words = translatable("Selected: {count}");
    if (!all_of_kind<NodeId>(parts).empty()) words = translatable("{count} points");
    if (!all_of_kind<CurveId>(parts).empty()) words = translatable("{count} curves");
    if (!all_of_kind<FacePlace>(parts).empty()) words = translatable("{count} faces");
    return {words, {{"count", std::to_string(parts.size())}}};
}

Message title(const Session& session, femoop::CaseId id)
{
    const bool is_load_case = id.index < session.model().load_cases.size();
    return {is_load_case ? translatable("Load case {id}") : translatable("Combination {id}"),
            {{"id", session.model().case_name(id)}}};
}

std::vector<Number> numbers_of(const Session& session, const Part& part)
{
    const PlaneModel& model = session.model();
    if (const auto* const point = std::get_if<NodeId>(&part)) return numbers(model, *point, session.load_case);
    if (const auto* const curve = std::get_if<CurveId>(&part)) return numbers(model, *curve, session.load_case);
    const auto region = session.region_of(part);
    return region ? numbers(model, *region) : std::vector<Number>{};
}

std::vector<Number> numbers_of(const Session& session, const std::vector<Part>& parts)
{
    std::vector<std::vector<Number>> each;
    for (const Part& part : parts)
        if (part.index() == parts.front().index()) each.push_back(numbers_of(session, part));
    return each.size() == parts.size() ? numbers_of_all(each) : std::vector<Number>{};
}

Change change_of(const Message& whose, const Number& number, const std::optional<femoop::Quantity>& value, Step step)
{
    return {Message(translatable("Change {number}: {part}"), {{"number", number.label}, {"part", whose}}),
            [set = number.set, value](Document& document) { set(document, value); }, step};
}

std::string reason_of(const Session& session, const femoop::Fault& fault)
{
    std::string reason = femoop::message(fault, [&](std::string_view words) { return session.tr()(words); });
    if (reason.starts_with(": ")) reason.erase(0, 2); // the place, which the field itself shows
    return reason;
}

namespace {

/// What is typed, or what is wrong with it.
std::variant<std::optional<femoop::Quantity>, Message> read_number(const Session& session, const Number& number,
                                                                   std::string_view text)
{
    const bool is_empty = text.find_first_not_of(' ') == std::string_view::npos;
    if (is_empty) return std::optional<femoop::Quantity>();
    const auto typed = drawing::quantity_typed(text, number.measure, session.model().units, session.units());
    if (const auto* const quantity = std::get_if<femoop::Quantity>(&typed)) return std::optional(*quantity);
    return Message(reason_of(session, std::get<femoop::Fault>(typed)));
}

/// What is typed as files have it: `[1, 3]` or an object.
bool is_field_typed(const Number& number, std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(' ');
    return number.set_field && begin != std::string_view::npos && (text[begin] == '[' || text[begin] == '{');
}

std::optional<Message> set_field_typed(Session& session, const Message& whose, const Number& number,
                                       std::string_view text)
{
    const auto read = femoop::plane::read_field(text, drawing::dimension_measured(number.measure),
                                                session.model().units);
    if (const auto* const faults = std::get_if<std::vector<femoop::Fault>>(&read))
        return Message(reason_of(session, faults->front()));
    return session.change(
        {Message(translatable("Change {number}: {part}"), {{"number", number.label}, {"part", whose}}),
         [set = number.set_field, field = std::get<femoop::plane::Field>(read)](Document& document) {
             set(document, field);
         }});
}

} // namespace

std::optional<Message> set_typed(Workspace& workspace, const Message& whose, const Number& number,
                                 std::string_view text)
{
    Session& session = workspace.session;
    if (is_field_typed(number, text)) return set_field_typed(session, whose, number, text);
    const auto read = read_number(session, number, text);
    if (const auto* const reason = std::get_if<Message>(&read)) return *reason;
    const auto& value = std::get<std::optional<femoop::Quantity>>(read);
    Document tried = session.document();
    if (auto objection = number.set(tried, value)) return objection;
    return session.change(change_of(whose, number, value, Step::Click));
}

const PlaneSupport* support_of(const Session& session, const Part& part)
{
    const auto address = [](const std::optional<PlaneSupport>& support) { return support ? &*support : nullptr; };
    if (const auto* const point = std::get_if<NodeId>(&part)) return address(session.model()[*point].support);
    if (const auto* const curve = std::get_if<CurveId>(&part)) return address(session.model()[*curve].support);
    return nullptr;
}

void change_supports(Workspace& workspace, const std::vector<Part>& parts, const Message& label,
                     const std::function<void(PlaneSupport&)>& command)
{
    workspace.change({label, [parts, command](Document& document) {
                          PlaneModel& model = document.model;
                          for (const Part& part : parts) {
                              if (const auto* const point = std::get_if<NodeId>(&part))
                                  command(model.points[point->index].support.value());
                              if (const auto* const curve = std::get_if<CurveId>(&part))
                                  command(model.curves[curve->index].support.value());
                          }
                      }});
}

} // namespace plane
