#include "apps/frame/window/named_set_rows.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <vector>

#include "apps/frame/window/number_row.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

using ui::translatable;

namespace {

bool is_support(const NamedSet& set) { return std::holds_alternative<femoop::Support>(set.value); }

std::vector<NamedSetPlace> sets_where(const Document& document, auto&& is_wanted)
{
    std::vector<NamedSetPlace> found;
    for (std::size_t i = 0; i < document.companion.sets.size(); ++i)
        if (is_wanted(document.companion.sets[i])) found.push_back({i});
    return found;
}

const std::string& name_of(const Session& session, NamedSetPlace set)
{
    return session.document().companion.sets[set.set].name;
}

// The kind of value that such a part has, though this one may have none: a free node can be given a support.
std::size_t kind_of(const Part& part)
{
    if (std::holds_alternative<femoop::NodeId>(part)) return SetValue(femoop::Support{}).index();
    if (std::holds_alternative<NodeLoadPlace>(part)) return SetValue(std::vector<femoop::Component>{}).index();
    return SetValue(MemberLoadValue{}).index();
}

bool can_have_name(const Part& part)
{
    return std::holds_alternative<femoop::NodeId>(part) || std::holds_alternative<NodeLoadPlace>(part) ||
           std::holds_alternative<MemberLoadPlace>(part);
}

struct Naming {
    std::vector<NamedSetPlace> sets; ///< of the parts' kind
    std::optional<NamedSetPlace> current;
    bool is_mixed;

    Naming(const Session& session, std::span<const Part> parts)
        : sets(sets_where(session.document(),
                          [&](const NamedSet& set) { return set.value.index() == kind_of(parts.front()); })),
          current(set_of(session.document(), parts.front())),
          is_mixed(
              std::ranges::any_of(parts, [&](const Part& part) { return set_of(session.document(), part) != current; }))
    {}
};

void choose_name(Session& session, std::span<const Part> parts, const Naming& naming)
{
    const ui::Catalogue& tr = session.view.tr;
    const std::string shown = naming.is_mixed ? tr("mixed") : naming.current ? name_of(session, *naming.current) : "–";
    if (!ImGui::BeginCombo("###named set", ui::shown_whole(shown).c_str(), ImGuiComboFlags_HeightLargest)) return;
    std::optional<NamedSetPlace> assigned, replaced;
    for (const NamedSetPlace set : naming.sets) {
        const std::string label = ui::item_label(name_of(session, set), std::to_string(set.set));
        if (ImGui::Selectable(label.c_str(), !naming.is_mixed && set == naming.current)) assigned = set;
    }
    const bool can_keep = !naming.is_mixed && !naming.current && !why_not_keep(session, parts);
    const bool is_kept = can_keep && ImGui::Selectable((tr("Keep under a name") + "###keep").c_str());
    for (const NamedSetPlace set : naming.sets) {
        const std::string label = tr("Replace: {name}", {{"name", name_of(session, set)}});
        const std::string id = "replace " + std::to_string(set.set);
        if (can_keep && ImGui::Selectable(ui::item_label(label, id).c_str())) replaced = set;
    }
    ImGui::EndCombo();
    if (assigned) assign(session, *assigned, parts);
    if (is_kept) keep_under_name(session, parts);
    if (replaced) replace(session, *replaced, parts);
}

void choose_load(Session& session, std::span<const Part> parts, const std::vector<NamedSetPlace>& loads)
{
    if (!ImGui::BeginCombo("###give load", session.view.tr("choose…").c_str(), ImGuiComboFlags_HeightLargest)) return;
    std::optional<NamedSetPlace> given;
    for (const NamedSetPlace set : loads) {
        const std::string label = ui::item_label(name_of(session, set), std::to_string(set.set));
        if (ImGui::Selectable(label.c_str())) given = set;
    }
    ImGui::EndCombo();
    if (given) give(session, *given, parts);
}

} // namespace

namespace {

// Nothing where the parts have no name and none can be given to them.
std::optional<Naming> naming_of(const Session& session, std::span<const Part> parts)
{
    if (!can_have_name(parts.front()) || !has(session.model(), parts.front())) return std::nullopt;
    Naming naming(session, parts);
    return naming.sets.empty() && why_not_keep(session, parts) ? std::nullopt : std::optional(std::move(naming));
}

void show_naming(Session& session, std::span<const Part> parts, const Rows& rows, const Naming& naming)
{
    const bool is_node = std::holds_alternative<femoop::NodeId>(parts.front());
    rows.name(session.view.tr(is_node ? translatable("Named support") : translatable("Named load")));
    choose_name(session, parts, naming);
}

} // namespace

void named_set_rows(Session& session, std::span<const Part> shown)
{
    if (shown.empty()) return;
    const std::vector<Part> parts(shown.begin(), shown.end()); // a change moves what they stand for
    const auto loads = sets_where(
        session.document(), [&](const NamedSet& set) { return !is_support(set) && suits(set.value, parts.front()); });
    const std::optional<Naming> naming = naming_of(session, parts);
    if (loads.empty() && !naming) return;
    const Rows rows("named sets");
    if (!rows.is_open()) return;
    if (naming) show_naming(session, parts, rows, *naming);
    if (loads.empty()) return;
    rows.name(session.view.tr("Give a load"));
    choose_load(session, parts, loads);
}

void NamedSetLists::show(Workspace& workspace)
{
    show_list(workspace, translatable("Named supports"), true);
    show_list(workspace, translatable("Named loads"), false);
}

void NamedSetLists::show_list(Workspace& workspace, std::string_view heading, bool of_supports)
{
    const Session& session = workspace.session;
    const auto sets = sets_where(session.document(),
                                 [&](const NamedSet& set) { return is_support(set) == of_supports; });
    if (chosen_ && chosen_->set >= session.document().companion.sets.size()) chosen_.reset();
    if (sets.empty()) return;
    const std::string label = session.view.tr(heading) + "  (" + std::to_string(sets.size()) + ")###" +
                              std::string(heading);
    if (!ImGui::CollapsingHeader(label.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) return;
    for (const NamedSetPlace set : sets) {
        const std::string n_users = "  (" + std::to_string(users(session.document(), set).size()) + ")";
        const std::string row = ui::item_label(name_of(session, set) + n_users, "named " + std::to_string(set.set));
        if (ImGui::Selectable(row.c_str(), chosen_ == set)) {
            chosen_ = chosen_ == set ? std::nullopt : std::optional(set);
            reason_.reset();
        }
        if (chosen_ == set) show_chosen(workspace);
        if (!chosen_ && session.document().companion.sets.size() <= set.set) return; // it is gone
    }
}

void NamedSetLists::show_chosen(Workspace& workspace)
{
    Session& session = workspace.session;
    const ui::Catalogue& tr = session.view.tr;
    const NamedSetPlace set = *chosen_;
    ImGui::Indent();
    ImGui::SetNextItemWidth(-1.0F);
    const bool is_confirmed = ImGui::InputText("###set name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
    if (is_confirmed || ImGui::IsItemDeactivatedAfterEdit()) reason_ = rename(session, set, name_);
    if (!ImGui::IsItemActive() && !is_confirmed) name_ = name_of(session, set);
    if (reason_) ui::wrapped_text(tr(*reason_));
    const bool selects = ui::wrapped_button(tr("Select who has it"), "select users");
    const std::string words = tr("Delete the name");
    ui::beside_if_room(ui::width_of_button(words), ImGui::GetStyle().ItemSpacing.x);
    const bool deletes = ui::wrapped_button(words, "delete name");
    ImGui::Unindent();
    if (selects) select_users(session, set);
    if (!deletes) return;
    erase(session, set);
    chosen_.reset();
}

} // namespace frame
