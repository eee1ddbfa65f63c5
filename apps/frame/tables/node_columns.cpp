#include <algorithm>

#include "apps/drawing/measures.h"
#include "apps/frame/document/command.h"
#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/name_column.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

// The node of a row, of a const model and of another.
constexpr auto node_of = [](auto& model, const Part& part) -> auto&
{
    return model.nodes[std::get<NodeId>(part).index];
};

Column coordinate(std::size_t axis)
{
    static constexpr std::string_view axes[] = {"x", "y", "z"};
    Column column = field_column(axes[axis], Measure::Length,
                                 [axis](auto& model, const Part& part) { return &node_of(model, part).at[axis]; });
    column.need = Need::Required;
    return column;
}

struct SupportWord {
    std::optional<SupportKind> kind;
    std::string_view word, in_file;
};
constexpr std::array support_text{
    SupportWord{std::nullopt, translatable("Free"), "free"},
    SupportWord{SupportKind::Roller, translatable("Roller"), "roller"},
    SupportWord{SupportKind::Pin, translatable("Pinned"), "pin"},
    SupportWord{SupportKind::Fixed, translatable("Fixed"), "fixed"},
};

CellValue support_value(const Model& model, const Part& part)
{
    const std::optional<Support>& support = node_of(model, part).support;
    if (!support) return {};
    if (support->kind == SupportKind::Custom) return names_of(support->fixed);
    const auto* const known = std::ranges::find(support_text, std::optional(support->kind), &SupportWord::kind);
    return ui::Message(known->word);
}

// Springs stay where the directions that are held are named.
void hold(Document& document, NodeId node, DofSet held)
{
    const AnalysisKind kind = document.model.analysis;
    for (const Dof dof : all_dofs) {
        if (!dofs(kind).contains(dof)) continue;
        set_hold(document, node, dof, held.contains(dof) ? Hold::Blocked : Hold::Free);
    }
}

Refusal write_support(Document& document, const Part& part, const CellText& entry)
{
    const NodeId node = std::get<NodeId>(part);
    for (const SupportWord& known : support_text) {
        if (!says(entry, known.word) && entry.text != known.in_file) continue;
        set_support(document, node, known.kind);
        return std::nullopt;
    }
    const auto held = dofs_of(entry, dofs(document.model.analysis));
    if (std::holds_alternative<std::string>(held)) {
        const ui::Catalogue& tr = entry.manner.tr;
        return tr("\"{text}\" is no support; there are {words}, or directions such as {directions}",
                  {{"text", entry.text},
                   {"words", tr("Free") + ", " + tr("Roller") + ", " + tr("Pinned") + ", " + tr("Fixed")},
                   {"directions", names_of(dofs(document.model.analysis))}});
    }
    hold(document, node, std::get<DofSet>(held));
    return std::nullopt;
}

Column angle_column()
{
    return field_column(translatable("Angle"), Measure::Angle, [](auto& model, const Part& part) {
        auto& support = node_of(model, part).support;
        return support ? &support->angle : nullptr;
    });
}

std::vector<Spring>::iterator spring_at(std::vector<Spring>& springs, Dof dof)
{
    return std::ranges::find(springs, dof, &Spring::dof);
}

std::optional<Quantity> spring(const Model& model, const Part& part, Dof dof)
{
    const std::optional<Support>& support = node_of(model, part).support;
    if (!support) return std::nullopt;
    const auto found = std::ranges::find(support->springs, dof, &Spring::dof);
    return found != support->springs.end() ? std::optional(found->stiffness) : std::nullopt;
}

// A spring takes the place of a rigid hold on its degree of freedom.
Refusal set_spring(Document& document, const Part& part, Dof dof, const std::optional<Quantity>& stiffness)
{
    const NodeId node = std::get<NodeId>(part);
    std::optional<Support>& support = document.model.nodes[node.index].support;
    if (!stiffness) {
        if (support) std::erase_if(support->springs, [dof](const Spring& s) { return s.dof == dof; });
        const bool is_empty = support && support->kind == SupportKind::Custom && support->fixed.is_empty() &&
                              support->springs.empty();
        if (is_empty) support.reset();
        return std::nullopt;
    }
    if (!support) support = Support{};
    if (support->blocked(document.model.analysis).contains(dof)) {
        support->fixed = support->blocked(document.model.analysis);
        support->fixed.erase(dof);
        support->kind = SupportKind::Custom;
    }
    const auto found = spring_at(support->springs, dof);
    if (found != support->springs.end()) found->stiffness = *stiffness;
    else support->springs.push_back({dof, *stiffness});
    return std::nullopt;
}

Column spring_column(Dof dof)
{
    return number_column(ui::Message(translatable("Spring {dof}"), {{"dof", std::string(name(dof))}}),
                         spring_measures.of(dof),
                         {.get = [dof](const Model& model, const Part& part) { return spring(model, part, dof); },
                          .set = [dof](Document& document, const Part& part, const std::optional<Quantity>& value,
                                       const Manner&) { return set_spring(document, part, dof, value); }});
}

Column hinge_column()
{
    return word_column(
        translatable("Hinge"),
        {.words = {translatable("no"), translatable("yes")},
         .get = [](const Model& model, const Part& part) -> std::size_t { return node_of(model, part).hinge ? 1 : 0; },
         .set =
             [](Document& document, const Part& part, std::size_t word) {
                 set_joint(document, std::get<NodeId>(part), word == 1 ? Joint::Hinged : Joint::Rigid);
             }});
}

} // namespace

std::vector<Column> node_columns(const Model& model)
{
    std::vector<Column> all{name_column<NodeId>(translatable("Node"), &Model::nodes)};
    for (std::size_t i = 0; i < n_coordinates(model.analysis); ++i) all.push_back(coordinate(i));
    all.push_back({.heading = translatable("Support"), .read = support_value, .write = write_support});
    if (is_plane(model.analysis)) all.push_back(angle_column());
    if (!is_truss(model.analysis)) all.push_back(hinge_column());
    for (const Dof dof : all_dofs)
        if (dofs(model.analysis).contains(dof)) all.push_back(spring_column(dof));
    return all;
}

} // namespace frame
