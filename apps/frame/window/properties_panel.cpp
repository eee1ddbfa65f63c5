#include "apps/frame/window/properties_panel.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "apps/frame/document/command.h"
#include "apps/frame/window/number_row.h"

namespace frame {

using namespace femoop;
using ui::Phrase;
using ui::translatable;

namespace {

// A click on a choice of a part: one step of the history.
void click(Session& session, const Part& part, std::string_view what, const std::function<void(Document&)>& command)
{
    session.change(
        Step::Click,
        {translatable("Change {number}: {part}"), {{"number", Phrase(what)}, {"part", title(session.model(), part)}}},
        command);
}

// A drop-down list; the entry that was chosen in this frame.
template <class Name>
std::optional<std::size_t> choose(const char* id, const std::string& current, std::size_t n, Name&& name)
{
    std::optional<std::size_t> chosen;
    if (!ImGui::BeginCombo(id, current.c_str())) return chosen;
    for (std::size_t i = 0; i < n; ++i) {
        const std::string label = name(i) + "###" + std::to_string(i);
        if (ImGui::Selectable(label.c_str(), name(i) == current)) chosen = i;
    }
    ImGui::EndCombo();
    return chosen;
}

// A check box; the state that it was switched to in this frame.
std::optional<Switch> tick(const std::string& label, bool is_on)
{
    bool state = is_on;
    if (!ImGui::Checkbox(label.c_str(), &state)) return std::nullopt;
    return state ? Switch::On : Switch::Off;
}

// ---- nodes ----

struct SupportChoice {
    std::optional<SupportKind> kind;
    std::string_view label;
};
constexpr std::array support_choices{
    SupportChoice{std::nullopt, translatable("Free")},
    SupportChoice{SupportKind::Roller, translatable("Roller")},
    SupportChoice{SupportKind::Pin, translatable("Pinned")},
    SupportChoice{SupportKind::Fixed, translatable("Fixed")},
    SupportChoice{SupportKind::Custom, translatable("By direction")},
};

std::string_view support_label(const Node& node)
{
    for (const SupportChoice& choice : support_choices) {
        const bool is_it = node.support ? choice.kind == node.support->kind : !choice.kind;
        if (is_it) return choice.label;
    }
    return support_choices.front().label;
}

void show_holds(Session& session, NodeId id)
{
    // Copies: a click replaces the document while the loop runs.
    const AnalysisKind kind = session.model().analysis;
    const std::optional<Support> support = session.model()[id].support;
    const DofSet blocked = support ? support->blocked(kind) : DofSet{};
    for (const Dof dof : all_dofs) {
        if (!dofs(kind).contains(dof)) continue;
        const std::optional<Switch> state = tick(std::string(name(dof)), blocked.contains(dof));
        ImGui::SameLine();
        if (!state) continue;
        const Hold hold = *state == Switch::On ? Hold::Blocked : Hold::Free;
        click(session, id, translatable("support"), [=](Document& document) { set_hold(document, id, dof, hold); });
    }
    ImGui::NewLine();
}

void show_choices(Session& session, NodeId id)
{
    const ui::Catalogue& tr = session.view.tr;
    const Rows rows("choices");
    if (!rows.is_open()) return;
    rows.name(tr("Support"));
    const auto chosen = choose("###support", tr(support_label(session.model()[id])), support_choices.size(),
                               [&](std::size_t i) { return tr(support_choices[i].label); });
    if (chosen) {
        const std::optional<SupportKind> kind = support_choices[*chosen].kind;
        click(session, id, translatable("support"), [=](Document& document) { set_support(document, id, kind); });
    }
    rows.name(tr("Holds"));
    show_holds(session, id);
    rows.name(tr("Hinge"));
    if (const auto state = tick(tr("all members are released") + "###hinge", session.model()[id].hinge)) {
        const Joint joint = *state == Switch::On ? Joint::Hinged : Joint::Rigid;
        click(session, id, translatable("hinge"), [=](Document& document) { set_joint(document, id, joint); });
    }
}

// ---- members ----

struct TraitLabel {
    MemberTrait trait;
    std::string_view label;
};
constexpr std::array traits{
    TraitLabel{MemberTrait::Bar, translatable("Bar (N only)")},
    TraitLabel{MemberTrait::Inextensible, translatable("Inextensible")},
    TraitLabel{MemberTrait::Unshearable, translatable("No shear strain")},
    TraitLabel{MemberTrait::Rigid, translatable("Rigid")},
};

void show_traits(Session& session, MemberId id)
{
    for (const TraitLabel& entry : traits) {
        const auto state = tick(session.view.tr(entry.label), has_trait(session.model()[id], entry.trait));
        if (!state) continue;
        click(session, id, entry.label, [&](Document& document) { set_trait(document, id, entry.trait, *state); });
    }
}

// The ways in which an end can be released: in a plane frame along, across and rotation.
void show_releases(Session& session, MemberId id, MemberEndName end)
{
    const AnalysisKind kind = session.model().analysis; // copies, as above
    const Member& member = session.model()[id];
    const DofSet release = end == MemberEndName::Start ? member.start.release : member.end.release;
    ImGui::PushID(static_cast<int>(end));
    for (const Dof dof : all_dofs) {
        if (!dofs(kind).contains(dof)) continue;
        const auto state = tick(std::string(name(dof)), release.contains(dof));
        ImGui::SameLine();
        if (!state) continue;
        click(session, id, translatable("releases"),
              [=](Document& document) { set_release(document, id, end, dof, *state); });
    }
    ImGui::NewLine();
    ImGui::PopID();
}

void show_materials(const Rows& rows, Session& session, MemberId id)
{
    const Model& model = session.model();
    const auto name_of = [](const auto& list, const auto& chosen) {
        return chosen ? list[chosen->index].id : std::string("–");
    };
    rows.name(session.view.tr("Material"));
    const auto material = choose("###material", name_of(model.materials, model[id].material), model.materials.size(),
                                 [&](std::size_t i) { return model.materials[i].id; });
    rows.name(session.view.tr("Section"));
    const auto section = choose("###section", name_of(model.sections, model[id].section), model.sections.size(),
                                [&](std::size_t i) { return model.sections[i].id; });
    if (material)
        click(session, id, translatable("Material"),
              [&](Document& document) { set_material(document, id, MaterialId(*material)); });
    if (section)
        click(session, id, translatable("Section"),
              [&](Document& document) { set_section(document, id, SectionId(*section)); });
}

void show_choices(Session& session, MemberId id)
{
    const ui::Catalogue& tr = session.view.tr;
    const Rows rows("choices");
    if (!rows.is_open()) return;
    show_materials(rows, session, id);
    if (is_truss(session.model().analysis)) return;
    rows.name(tr("Theory"));
    static constexpr std::array theories{translatable("Euler-Bernoulli"), translatable("Timoshenko")};
    const auto current = static_cast<std::size_t>(session.model()[id].theory);
    if (const auto theory = choose("###theory", tr(theories[current]), theories.size(),
                                   [&](std::size_t i) { return tr(theories[i]); }))
        click(session, id, translatable("Theory"),
              [&](Document& document) { set_theory(document, id, static_cast<BeamTheory>(*theory)); });
    rows.name(tr("Releases, start"));
    show_releases(session, id, MemberEndName::Start);
    rows.name(tr("Releases, end"));
    show_releases(session, id, MemberEndName::End);
    rows.name(tr("Idealized"));
    show_traits(session, id);
}

// ---- loads ----

void show_axes(Session& session, const MemberLoadPlace& place, LoadAxes axes)
{
    const ui::Catalogue& tr = session.view.tr;
    const Rows rows("choices");
    if (!rows.is_open()) return;
    rows.name(tr("Axes"));
    static constexpr std::array names{translatable("Global"), translatable("Local")};
    if (const auto chosen = choose("###axes", tr(names[static_cast<std::size_t>(axes)]), names.size(),
                                   [&](std::size_t i) { return tr(names[i]); }))
        click(session, place, translatable("Axes"),
              [&](Document& document) { set_load_axes(document, place, static_cast<LoadAxes>(*chosen)); });
}

void show_choices(Session& session, const MemberLoadPlace& place)
{
    const MemberLoad load = session.model().load_cases[place.load_case].members[place.load]; // a copy, as above
    if (const auto* const point = std::get_if<PointLoad>(&load.load)) show_axes(session, place, point->axes);
    if (const auto* const ends = std::get_if<EndLoads>(&load.load)) show_axes(session, place, ends->axes);
    const auto* const distributed = std::get_if<DistributedLoad>(&load.load);
    if (distributed == nullptr) return;
    show_axes(session, place, distributed->axes);
    if (const auto state = tick(session.view.tr("Per unit of projected length"), distributed->projected))
        click(session, place, translatable("Axes"),
              [&](Document& document) { set_projected(document, place, *state); });
}

template <class PlaceType> void show_choices(Session&, const PlaceType&) {} // materials, sections, cases: numbers alone

void show_part(Desk& desk, ui::NumberFields& fields, const Part& part)
{
    show_numbers(desk, fields, part);
    std::visit([&](const auto& id) { show_choices(desk.session, id); }, part);
}

// Which case a load belongs to, so that equal loads of two cases are told apart.
std::string case_of(const Model& model, const Part& load)
{
    if (const auto* const p = std::get_if<NodeLoadPlace>(&load)) return model.load_cases[p->load_case].id;
    if (const auto* const p = std::get_if<SettlementPlace>(&load)) return model.load_cases[p->load_case].id;
    if (const auto* const p = std::get_if<MemberLoadPlace>(&load)) return model.load_cases[p->load_case].id;
    return "";
}

void show_loads_on(Desk& desk, ui::NumberFields& fields, const Part& part)
{
    int i = 0;
    for (const Part& load : loads_on(desk.session.model(), part)) {
        if (!has(desk.session.model(), load)) return;
        ImGui::PushID(++i);
        const std::string heading = desk.session.view.tr(title(desk.session.model(), load)) + " · " +
                                    case_of(desk.session.model(), load);
        if (ImGui::CollapsingHeader((heading + "###load").c_str(), ImGuiTreeNodeFlags_DefaultOpen))
            show_part(desk, fields, load);
        ImGui::PopID();
    }
}

// ---- nothing selected: the list of parts ----

void show_list(Desk& desk, std::string_view heading, const std::vector<Part>& list)
{
    const ui::Catalogue& tr = desk.session.view.tr;
    const std::string label = tr(heading) + "  (" + std::to_string(list.size()) + ")###" + std::string(heading);
    if (list.empty() || !ImGui::CollapsingHeader(label.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID(heading.data());
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(list.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Part& part = list[static_cast<std::size_t>(i)];
            const std::string name = tr(title(desk.session.model(), part)) + "###" + std::to_string(i);
            if (ImGui::Selectable(name.c_str())) desk.session.selection = part;
        }
    }
    ImGui::PopID();
}

template <class... Types> std::vector<Part> of_type(const std::vector<Part>& all)
{
    std::vector<Part> chosen;
    for (const Part& part : all) {
        if ((std::holds_alternative<Types>(part) || ...)) chosen.push_back(part);
    }
    return chosen;
}

void show_lists(Desk& desk)
{
    const std::vector<Part> all = parts(desk.session.model());
    ImGui::TextWrapped("%s", desk.session.view.tr("Click a part in the picture or in this list to change it.").c_str());
    ImGui::Spacing();
    show_list(desk, translatable("Members"), of_type<MemberId>(all));
    show_list(desk, translatable("Nodes"), of_type<NodeId>(all));
    show_list(desk, translatable("Materials"), of_type<MaterialId>(all));
    show_list(desk, translatable("Sections"), of_type<SectionId>(all));
    show_list(desk, translatable("Load cases"), of_type<LoadCasePlace>(all));
    show_list(desk, translatable("Loads"), of_type<NodeLoadPlace, SettlementPlace, MemberLoadPlace>(all));
    show_list(desk, translatable("Combinations"), of_type<CombinationPlace>(all));
}

// From a member to its material and section, so that their numbers are one click away.
void show_ways_on(Session& session, const Part& part)
{
    const auto* const id = std::get_if<MemberId>(&part);
    if (id == nullptr) return;
    const Member& member = session.model()[*id];
    const ui::Catalogue& tr = session.view.tr;
    ImGui::Spacing();
    if (member.section && ImGui::Button((tr("Edit the section") + "###edit section").c_str()))
        session.selection = *member.section;
    ImGui::SameLine();
    if (member.material && ImGui::Button((tr("Edit the material") + "###edit material").c_str()))
        session.selection = *member.material;
}

} // namespace

void properties_panel(Desk& desk, ui::NumberFields& fields)
{
    Session& session = desk.session;
    if (!session.selection) {
        show_lists(desk);
        return;
    }
    const Part part = *session.selection;
    const ui::Catalogue& tr = session.view.tr;
    if (ImGui::SmallButton((tr("All parts") + "###all").c_str())) session.selection.reset();
    ImGui::SameLine();
    ImGui::TextUnformatted(tr(title(session.model(), part)).c_str());
    ImGui::Separator();
    show_part(desk, fields, part);
    show_ways_on(session, part);
    if (has(session.model(), part)) show_loads_on(desk, fields, part);
}

} // namespace frame
