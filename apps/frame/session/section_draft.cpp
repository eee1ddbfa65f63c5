#include "apps/frame/session/section_draft.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "apps/frame/document/number.h"
#include "apps/frame/document/selected_members.h"
#include "femoop/edit/naming.h"
#include "femoop/section/profile.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

std::optional<SectionId> selected_section(const Session& session)
{
    for (const Part& part : session.selection.parts()) {
        if (const auto* const section = std::get_if<SectionId>(&part)) return *section;
        const auto* const member = std::get_if<MemberId>(&part);
        if (member != nullptr && session.model()[*member].section) return session.model()[*member].section;
    }
    return std::nullopt;
}

} // namespace

void SectionDraft::open(Session& session)
{
    if (!is_open_) begin(session, selected_section(session));
}

void SectionDraft::open_new(Session& session)
{
    if (!is_open_) begin(session, std::nullopt);
}

void SectionDraft::begin(Session& session, std::optional<SectionId> existing)
{
    session.settle();
    is_open_ = true;
    existing_ = existing;
    target_ = SectionTarget::This;
    members_ = selected_members(session.selection);
    selected_ = session.selection;
    const Model& model = session.model();
    section_ = existing ? model[*existing] : Section{.id = fresh_id(model.sections, "s1")};
    if (!existing) choose_shape(session, SectionShapeKind::I);
}

void SectionDraft::accept(Session& session)
{
    session.settle();
    is_open_ = false;
}

void SectionDraft::cancel(Session& session)
{
    session.cancel();
    session.selection = selected_;
    is_open_ = false;
}

void SectionDraft::choose_shape(Session& session, SectionShapeKind kind)
{
    if (section_.shape && section_.shape->kind == kind) return;
    section_ = Section{.id = section_.id, .shape = usual_shape(kind, session.model().units), .turned = section_.turned};
    show(session);
}

void SectionDraft::choose_profile(Session& session, std::string_view name)
{
    section_ = Section{.id = section_.id, .profile = std::string(name), .turned = section_.turned};
    show(session);
}

void SectionDraft::set_turned(Session& session, bool turned)
{
    section_.turned = turned;
    show(session);
}

std::optional<ui::Message> SectionDraft::set_dimension(Session& session, const ShapeDimension& dimension,
                                                       const Quantity& value)
{
    Section next = section_;
    (*next.shape).*dimension.value = value;
    if (const auto fault = why_not(*next.shape)) return sentence_of(*fault, session.units());
    section_ = std::move(next);
    show(session);
    return std::nullopt;
}

std::optional<ui::Message> SectionDraft::set_name(Session& session, std::string_view name)
{
    const Model& before = session.history().settled().model;
    const std::size_t none = before.sections.size();
    const SectionId place = target() == SectionTarget::This ? *existing_ : SectionId(none);
    if (auto reason = why_not_rename(before, place, name)) return reason;
    section_.id = name;
    show(session);
    return std::nullopt;
}

void SectionDraft::set_target(Session& session, SectionTarget target)
{
    if (!existing_ || target == target_) return;
    target_ = target;
    const Model& before = session.history().settled().model;
    section_.id = target == SectionTarget::This ? before[*existing_].id : fresh_id(before.sections, section_.id);
    show(session);
}

void SectionDraft::show(Session& session)
{
    const ui::Message::Argument id{"id", section_.id};
    if (target() == SectionTarget::This)
        session.change({{translatable("Change section {id}"), {id}},
                        [this](Document& document) { put_section(document, *existing_, section_); },
                        Step::Drag});
    else
        session.change({{translatable("New section {id}"), {id}},
                        [this](Document& document) { add_section(document, section_, members_); },
                        Step::Drag});
    session.selection = selected_;
}

std::optional<std::string> SectionDraft::run_command(Session& session, std::string_view verb, std::string_view argument)
{
    const ui::Catalogue english;
    if (!is_open_) return "no section is being made; begin with edit.section";
    if (verb == "shape") {
        const auto kinds = section_shape_kinds();
        const auto kind = std::ranges::find_if(kinds, [&](SectionShapeKind k) { return name(k) == argument; });
        if (kind == kinds.end()) return "no shape \"" + std::string(argument) + "\"";
        choose_shape(session, *kind);
    } else if (verb == "profile") {
        if (find_profile(argument) == nullptr) return "no profile \"" + std::string(argument) + "\"";
        choose_profile(session, argument);
    } else if (verb == "turned") {
        if (!section_.shape && !section_.profile) return "the section has neither a shape nor a profile";
        set_turned(session, argument != "no");
    } else if (verb == "name") {
        if (const auto reason = set_name(session, argument)) return english(*reason);
    } else if (verb == "set") {
        return set_named(session, argument);
    } else if (verb == "new") {
        set_target(session, SectionTarget::New);
    } else if (verb == "accept") {
        accept(session);
    } else if (verb == "cancel") {
        cancel(session);
    } else {
        return "cannot \"" + std::string(verb) +
               "\" it; known are shape, profile, turned, name, set, new, accept, cancel";
    }
    return std::nullopt;
}

std::optional<std::string> SectionDraft::set_named(Session& session, std::string_view argument)
{
    const std::size_t blank = std::min(argument.find(' '), argument.size());
    const std::string_view key = argument.substr(0, blank);
    const std::string_view text = argument.substr(std::min(blank + 1, argument.size()));
    const auto typed = quantity_typed(text, ui::Measure::SectionLength, session.model().units, session.units());
    const auto* const value = std::get_if<Quantity>(&typed);
    if (value == nullptr) return "no length in \"" + std::string(argument) + "\"";
    if (!section_.shape) return "the section has no shape";
    for (const ShapeDimension& dimension : dimensions(section_.shape->kind)) {
        if (dimension.key != key) continue;
        const auto reason = set_dimension(session, dimension, *value);
        return reason ? std::optional(ui::Catalogue()(*reason)) : std::nullopt;
    }
    return "no dimension \"" + std::string(key) + "\"";
}

} // namespace frame
