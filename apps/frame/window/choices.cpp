#include "apps/frame/window/choices.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/document/dimensioning.h"
#include "apps/frame/window/number_row.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

/// Parts of one kind that are changed together.
template <class Id> struct Group {
    Session& session;
    std::vector<Id> ids;

    const Model& model() const { return session.model(); }
    const ui::Catalogue& tr() const { return session.view.tr; }

    /// One step of the history: the command for each of them.
    void change(std::string_view what, const std::function<void(Document&, Id)>& command) const
    {
        const std::vector<Part> parts(ids.begin(), ids.end());
        session.change({change_label(model(), what, parts), [&](Document& document) {
                            for (const Id id : ids) command(document, id);
                        }});
    }

    /// What they have in common; nothing where they differ.
    template <class Get> auto common(Get&& get) const
    {
        const auto first = get(ids.front());
        const bool is_common = std::ranges::all_of(ids, [&](Id id) { return get(id) == first; });
        return is_common ? std::optional(first) : std::nullopt;
    }
};

// A drop-down list; the entry that was chosen in this frame.
struct Choices {
    const char* id;
    std::vector<std::string> names;
    std::optional<std::size_t> current; ///< nothing: mixed
};
std::optional<std::size_t> choose(const Choices& choices, const ui::Catalogue& tr)
{
    std::optional<std::size_t> chosen;
    const std::string shown = choices.current ? choices.names.at(*choices.current) : tr("mixed");
    const ImGuiStyle& style = ImGui::GetStyle();
    const float needed = ImGui::CalcTextSize(shown.c_str()).x + 2.0F * style.FramePadding.x + ImGui::GetFrameHeight();
    const ImGuiComboFlags flags = ImGuiComboFlags_HeightLargest |
                                  (needed > ImGui::GetContentRegionAvail().x ? ImGuiComboFlags_NoArrowButton : 0);
    if (!ImGui::BeginCombo(choices.id, ui::shown_whole(shown).c_str(), flags)) return chosen;
    for (std::size_t i = 0; i < choices.names.size(); ++i) {
        const std::string label = ui::item_label(choices.names[i], std::to_string(i));
        if (ImGui::Selectable(label.c_str(), choices.current == i)) chosen = i;
    }
    ImGui::EndCombo();
    return chosen;
}

// A check box, with a bar for a tick where the parts differ; the state that it was switched to in this frame.
std::optional<Switch> tick(const std::string& label, std::string_view id, std::optional<bool> is_on)
{
    bool state = is_on.value_or(false);
    ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, !is_on);
    const bool is_clicked = ImGui::Checkbox(ui::label_beside_box(label, id).c_str(), &state);
    ImGui::PopItemFlag();
    if (!is_clicked) return std::nullopt;
    return state ? Switch::On : Switch::Off;
}

// Check boxes beside one another, in a further row where there is no room for the next.
class TickRow {
public:
    std::optional<Switch> tick(const std::string& label, std::optional<bool> is_on)
    {
        const ImGuiStyle& style = ImGui::GetStyle();
        const float width = ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label.c_str()).x;
        if (!std::exchange(is_first_, false)) ui::beside_if_room(width, style.ItemSpacing.x);
        return frame::tick(label, label, is_on);
    }

private:
    bool is_first_ = true;
};

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

// A support that was turned is still called by what it holds.
SupportKind kind_shown(const Support& support, AnalysisKind analysis)
{
    if (support.kind != SupportKind::Custom || !support.springs.empty()) return support.kind;
    for (const SupportKind kind : {SupportKind::Fixed, SupportKind::Pin, SupportKind::Roller})
        if (Support{.kind = kind}.blocked(analysis) == support.blocked(analysis)) return kind;
    return SupportKind::Custom;
}

std::size_t support_choice(const Node& node, AnalysisKind analysis)
{
    const std::optional<SupportKind> kind = node.support ? std::optional(kind_shown(*node.support, analysis))
                                                         : std::nullopt;
    const auto* const choice = std::ranges::find(support_choices, kind, &SupportChoice::kind);
    return static_cast<std::size_t>(choice - support_choices.begin());
}

void show_holds(const Group<NodeId>& nodes)
{
    const AnalysisKind kind = nodes.model().analysis;
    TickRow row;
    for (const Dof dof : all_dofs) {
        if (!dofs(kind).contains(dof)) continue;
        const auto is_held = nodes.common([&](NodeId id) {
            const std::optional<Support>& support = nodes.model()[id].support;
            return support && support->blocked(kind).contains(dof);
        });
        const std::optional<Switch> state = row.tick(std::string(name(dof)), is_held);
        if (!state) continue;
        const Hold hold = *state == Switch::On ? Hold::Blocked : Hold::Free;
        nodes.change(translatable("support"),
                     [=](Document& document, NodeId id) { set_hold(document, id, dof, hold); });
    }
}

void show(const Rows& rows, const Group<NodeId>& nodes)
{
    const ui::Catalogue& tr = nodes.tr();
    rows.name(tr("Support"));
    std::vector<std::string> names;
    for (const SupportChoice& choice : support_choices) names.push_back(tr(choice.label));
    const AnalysisKind analysis = nodes.model().analysis;
    const auto current = nodes.common([&](NodeId id) { return support_choice(nodes.model()[id], analysis); });
    if (const auto chosen = choose({"###support", names, current}, tr); chosen && chosen != current) {
        const std::optional<SupportKind> kind = support_choices[*chosen].kind;
        nodes.change(translatable("support"), [=](Document& document, NodeId id) { set_support(document, id, kind); });
    }
    rows.name(tr("Holds"));
    show_holds(nodes);
    rows.name(tr("Hinge"));
    const auto is_hinge = nodes.common([&](NodeId id) { return nodes.model()[id].hinge; });
    if (const auto state = tick(tr("of all members"), "hinge", is_hinge)) {
        const Joint joint = *state == Switch::On ? Joint::Hinged : Joint::Rigid;
        nodes.change(translatable("hinge"), [=](Document& document, NodeId id) { set_joint(document, id, joint); });
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

void show_traits(const Group<MemberId>& members)
{
    for (const TraitLabel& entry : traits) {
        const auto is_on = members.common([&](MemberId id) { return has_trait(members.model()[id], entry.trait); });
        const auto state = tick(members.tr()(entry.label), entry.label, is_on);
        if (!state) continue;
        members.change(entry.label,
                       [&](Document& document, MemberId id) { set_trait(document, id, entry.trait, *state); });
    }
}

void show_taper(const Group<MemberId>& members)
{
    const Model& model = members.model();
    const bool is_possible = std::ranges::all_of(
        members.ids, [&](MemberId id) { return !model[id].depths.empty() || can_taper(model, model[id]); });
    if (!is_possible) return;
    constexpr std::string_view label = translatable("Tapered");
    const auto is_on = members.common([&](MemberId id) { return !model[id].depths.empty(); });
    const auto state = tick(members.tr()(label), label, is_on);
    if (!state) return;
    members.change(label, [&](Document& document, MemberId id) {
        if (*state == Switch::Off) make_prismatic(document, id);
        else if (model[id].depths.empty()) taper(document, id);
    });
}

// The ways in which an end can be released: in a plane frame along, across and rotation.
void show_releases(const Group<MemberId>& members, MemberEndName end)
{
    const auto release = [&](MemberId id) {
        const Member& member = members.model()[id];
        return end == MemberEndName::Start ? member.start.release : member.end.release;
    };
    ImGui::PushID(static_cast<int>(end));
    TickRow row;
    for (const Dof dof : all_dofs) {
        if (!member_dofs(members.model().analysis).contains(dof)) continue;
        const auto is_released = members.common([&](MemberId id) { return release(id).contains(dof); });
        const auto state = row.tick(std::string(name(dof)), is_released);
        if (!state) continue;
        members.change(translatable("releases"),
                       [=](Document& document, MemberId id) { set_release(document, id, end, dof, *state); });
    }
    ImGui::PopID();
}

// The materials or sections of the model, and which one the members have.
template <class Entry, class Get>
std::optional<std::size_t> choose_property(const Group<MemberId>& members, const char* id,
                                           const std::vector<Entry>& list, Get&& get)
{
    Choices choices{id, {}, std::nullopt};
    for (const Entry& entry : list) choices.names.push_back(entry.id);
    choices.names.emplace_back("–");
    choices.current = members.common([&](MemberId member) {
        const auto property = get(members.model()[member]);
        return property ? property->index : list.size();
    });
    const auto chosen = choose(choices, members.tr());
    return chosen && *chosen < list.size() ? chosen : std::nullopt;
}

void show_properties(const Rows& rows, const Group<MemberId>& members)
{
    const Model& model = members.model();
    rows.name(members.tr()("Material"));
    const auto material = choose_property(members, "###material", model.materials,
                                          [](const Member& member) { return member.material; });
    rows.name(members.tr()("Section"));
    const auto section = choose_property(members, "###section", model.sections,
                                         [](const Member& member) { return member.section; });
    if (material)
        members.change(translatable("Material"),
                       [&](Document& document, MemberId id) { set_material(document, id, MaterialId(*material)); });
    if (section)
        members.change(translatable("Section"),
                       [&](Document& document, MemberId id) { set_section(document, id, SectionId(*section)); });
}

void show_theory(const Rows& rows, const Group<MemberId>& members)
{
    const ui::Catalogue& tr = members.tr();
    rows.name(tr("Theory"));
    const auto current = members.common(
        [&](MemberId id) { return static_cast<std::size_t>(members.model()[id].theory); });
    const std::vector<std::string> names{tr("Euler-Bernoulli"), tr("Timoshenko")};
    if (const auto theory = choose({"###theory", names, current}, tr))
        members.change(translatable("Theory"), [&](Document& document, MemberId id) {
            set_theory(document, id, static_cast<BeamTheory>(*theory));
        });
}

void show(const Rows& rows, const Group<MemberId>& members, const std::function<void(const Rows&)>& show_depths_below)
{
    const ui::Catalogue& tr = members.tr();
    show_properties(rows, members);
    if (is_truss(members.model().analysis)) return;
    show_taper(members);
    show_depths_below(rows);
    show_theory(rows, members);
    rows.name(tr("Releases, start"));
    show_releases(members, MemberEndName::Start);
    rows.name(tr("Releases, end"));
    show_releases(members, MemberEndName::End);
    rows.name(tr("Idealized"));
    show_traits(members);
}

// ---- loads ----

const MemberLoad& load_at(const Model& model, const MemberLoadPlace& place)
{
    return model.load_cases[place.load_case].members[place.load];
}

std::optional<LoadAxes> axes_of(const MemberLoad& load)
{
    if (const auto* const point = std::get_if<PointLoad>(&load.load)) return point->axes;
    if (const auto* const ends = std::get_if<EndLoads>(&load.load)) return ends->axes;
    if (const auto* const distributed = std::get_if<DistributedLoad>(&load.load)) return distributed->axes;
    return std::nullopt;
}

void show(const Rows& rows, const Group<MemberLoadPlace>& loads)
{
    const ui::Catalogue& tr = loads.tr();
    const auto axes = [&](const MemberLoadPlace& place) { return axes_of(load_at(loads.model(), place)); };
    if (!std::ranges::all_of(loads.ids, [&](const auto& place) { return axes(place).has_value(); })) return;
    rows.name(tr("Axes"));
    const auto current = loads.common([&](const auto& place) { return static_cast<std::size_t>(*axes(place)); });
    if (const auto chosen = choose({"###axes", {tr("Global"), tr("Local")}, current}, tr))
        loads.change(translatable("Axes"), [&](Document& document, const MemberLoadPlace& place) {
            set_load_axes(document, place, static_cast<LoadAxes>(*chosen));
        });
    const auto distributed = [&](const MemberLoadPlace& place) {
        return std::get_if<DistributedLoad>(&load_at(loads.model(), place).load);
    };
    if (!std::ranges::all_of(loads.ids, [&](const auto& place) { return distributed(place) != nullptr; })) return;
    const auto is_projected = loads.common([&](const auto& place) { return distributed(place)->projected; });
    rows.name(tr("Per unit of projected length"));
    if (const auto state = tick("", "projected", is_projected))
        loads.change(translatable("Axes"),
                     [&](Document& document, const MemberLoadPlace& place) { set_projected(document, place, *state); });
}

// ---- dimension lines ----

// The nodes that it can go from or to: all but those that it has besides.
void show_end(const Rows& rows, const Group<DimensionPlace>& lines, std::string_view name, std::size_t n)
{
    const std::vector<std::string>& nodes =
        lines.session.document().companion.dimensions[lines.ids.front().dimension].nodes;
    const std::string id = "###" + std::string(name);
    Choices choices{id.c_str(), {}, {}};
    for (const Node& node : lines.model().nodes) {
        if (node.id == nodes[n]) choices.current = choices.names.size();
        if (node.id == nodes[n] || std::ranges::find(nodes, node.id) == nodes.end()) choices.names.push_back(node.id);
    }
    rows.name(lines.tr()(name));
    const auto chosen = choose(choices, lines.tr());
    if (!chosen) return;
    lines.change(
        name, [&](Document& document, DimensionPlace place) { set_node(document, place, n, choices.names[*chosen]); });
}

void show(const Rows& rows, const Group<DimensionPlace>& lines)
{
    const ui::Catalogue& tr = lines.tr();
    if (lines.ids.size() == 1) {
        const auto& line = lines.session.document().companion.dimensions[lines.ids.front().dimension];
        const std::size_t last = line.nodes.size() - 1;
        show_end(rows, lines, translatable("From node"), 0);
        show_end(rows, lines, translatable("To node"), last);
    }
    rows.name(tr("Direction"));
    const auto current = lines.common([&](DimensionPlace place) {
        return static_cast<std::size_t>(lines.session.document().companion.dimensions[place.dimension].direction);
    });
    const std::vector<std::string> names{tr("Aligned"), tr("Horizontal"), tr("Vertical")};
    if (const auto chosen = choose({"###direction", names, current}, tr))
        lines.change(translatable("Direction"), [&](Document& document, DimensionPlace place) {
            set_direction(document, place, static_cast<DimensionDirection>(*chosen));
        });
}

template <class Id, class... More> void show_group(Session& session, std::span<const Part> parts, const More&... more)
{
    if (!std::holds_alternative<Id>(parts.front())) return;
    Group<Id> group{session, {}};
    for (const Part& part : parts) group.ids.push_back(std::get<Id>(part));
    const Rows rows("choices");
    if (rows.is_open()) show(rows, group, more...);
}

} // namespace

void show_choices(Workspace& workspace, ui::NumberFields& fields, std::span<const Part> parts)
{
    if (parts.empty()) return;
    Session& session = workspace.session;
    const auto depths = [&](const Rows& rows) { show_depths(rows, workspace, fields, parts); };
    show_group<NodeId>(session, parts);
    show_group<MemberId>(session, parts, std::function<void(const Rows&)>(depths));
    show_group<MemberLoadPlace>(session, parts);
    show_group<DimensionPlace>(session, parts);
}

} // namespace frame
