#include "apps/frame/document/command.h"
#include "femoop/section/tapered_section.h"

#include <stdexcept>
#include <type_traits>
#include <utility>

namespace frame {

using namespace femoop;

namespace {

Node& at(Document& document, NodeId id) { return document.model.nodes.at(id.index); }
Member& at(Document& document, MemberId id) { return document.model.members.at(id.index); }
MemberLoad& at(Document& document, const MemberLoadPlace& p)
{
    return document.model.load_cases.at(p.load_case).members.at(p.load);
}

bool& flag(Member& member, MemberTrait trait)
{
    switch (trait) {
    case MemberTrait::Inextensible: return member.inextensible;
    case MemberTrait::Unshearable: return member.unshearable;
    case MemberTrait::Rigid: return member.rigid;
    case MemberTrait::Bar: break;
    }
    return member.bar;
}

// A node without a support has no reaction that could be checked.
void drop_support(Document& document, NodeId node)
{
    at(document, node).support.reset();
    std::erase_if(document.model.expected, [node](const Expected& check) {
        return check.quantity == ExpectedQuantity::Reaction && check.node == node;
    });
    std::erase_if(document.model.moving_loads.influence_lines, [node](const femoop::InfluenceLineDefinition& line) {
        return line.effect.quantity == ExpectedQuantity::Reaction && line.effect.node == node;
    });
}

} // namespace

void set_support(Document& document, NodeId node, std::optional<SupportKind> kind)
{
    if (!kind) return drop_support(document, node);
    std::optional<Support>& support = at(document, node).support;
    Support next = support.value_or(Support{});
    if (*kind == SupportKind::Custom) next.fixed = next.blocked(document.model.analysis);
    if (*kind != SupportKind::Custom) next = Support{};
    next.kind = *kind;
    support = std::move(next);
}

void set_support_angle(Document& document, NodeId node, double degrees)
{
    Support& support = at(document, node).support.value();
    if (support.angle == Quantity(degrees)) return;
    support.fixed = support.blocked(document.model.analysis);
    support.kind = SupportKind::Custom;
    support.angle = Quantity(degrees);
}

void set_hold(Document& document, NodeId node, Dof dof, Hold hold)
{
    std::optional<Support>& support = at(document, node).support;
    Support next = support.value_or(Support{});
    next.fixed = next.blocked(document.model.analysis);
    next.kind = SupportKind::Custom;
    if (hold == Hold::Free) {
        next.fixed.erase(dof);
    } else {
        next.fixed.insert(dof);
        std::erase_if(next.springs, [dof](const Spring& spring) { return spring.dof == dof; });
    }
    if (next.fixed.is_empty() && next.springs.empty()) return drop_support(document, node);
    support = std::move(next);
}

void set_spring(Document& document, NodeId node, const Spring& spring)
{
    std::optional<Support>& support = at(document, node).support;
    Support next = support.value_or(Support{});
    next.fixed = next.blocked(document.model.analysis);
    next.kind = SupportKind::Custom;
    next.fixed.erase(spring.dof);
    std::erase_if(next.springs, [&](const Spring& there) { return there.dof == spring.dof; });
    next.springs.push_back(spring);
    support = std::move(next);
}

void set_joint(Document& document, NodeId node, Joint joint) { at(document, node).hinge = joint == Joint::Hinged; }

void set_material(Document& document, MemberId member, MaterialId material)
{
    (void)document.model.materials.at(material.index);
    at(document, member).material = material;
}

void set_section(Document& document, MemberId member, SectionId section)
{
    (void)document.model.sections.at(section.index);
    at(document, member).section = section;
}

void set_theory(Document& document, MemberId member, BeamTheory theory) { at(document, member).theory = theory; }

bool can_taper(const Model& model, const Member& member)
{
    return model.analysis == AnalysisKind::Frame2d && member.section && femoop::can_taper(model[*member.section]);
}

void taper(Document& document, MemberId member)
{
    Member& changed = at(document, member);
    const Quantity depth = *document.model[*changed.section].shape->h;
    changed.depths = {depth, depth};
}

void make_prismatic(Document& document, MemberId member) { at(document, member).depths.clear(); }

void set_trait(Document& document, MemberId member, MemberTrait trait, Switch state)
{
    flag(at(document, member), trait) = state == Switch::On;
}

bool has_trait(const Member& member, MemberTrait trait)
{
    switch (trait) {
    case MemberTrait::Inextensible: return member.inextensible;
    case MemberTrait::Unshearable: return member.unshearable;
    case MemberTrait::Rigid: return member.rigid;
    case MemberTrait::Bar: break;
    }
    return member.bar;
}

void set_release(Document& document, MemberId member, MemberEndName end, Dof dof, Switch state)
{
    Member& changed = at(document, member);
    MemberEnd& side = end == MemberEndName::Start ? changed.start : changed.end;
    if (state == Switch::Off) {
        side.release.erase(dof);
        return;
    }
    side.release.insert(dof);
    std::erase_if(side.springs, [dof](const Spring& spring) { return spring.dof == dof; });
}

void set_load_axes(Document& document, const MemberLoadPlace& place, LoadAxes axes)
{
    std::visit(
        [&](auto& load) {
            using Kind = std::remove_reference_t<decltype(load)>;
            if constexpr (std::is_same_v<Kind, TemperatureLoad> || std::is_same_v<Kind, Misfit>) {
                throw std::invalid_argument("this load has no axes");
            } else {
                load.axes = axes;
                if constexpr (std::is_same_v<Kind, DistributedLoad>)
                    load.projected = load.projected && axes == LoadAxes::Global;
            }
        },
        at(document, place).load);
}

void set_projected(Document& document, const MemberLoadPlace& place, Switch state)
{
    auto* const load = std::get_if<DistributedLoad>(&at(document, place).load);
    if (load == nullptr) throw std::invalid_argument("only distributed loads can be projected");
    load->projected = state == Switch::On;
    if (load->projected) load->axes = LoadAxes::Global;
}

void set_title(Document& document, std::string title) { document.model.title = std::move(title); }

void set_notes(Document& document, std::string notes) { document.model.notes = std::move(notes); }

} // namespace frame
