#include "apps/frame/session/distribution_check.h"

#include <cstddef>
#include <string>
#include <utility>

#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/session/other_programs.h"
#include "femoop/methods/cross/problem.h"
#include "femoop/model/fault/fault.h"

namespace frame {

using ui::translatable;

namespace {

constexpr std::size_t most_members = 200;

bool is_of_held_ends(const femoop::Fault& fault)
{
    return fault.kind == femoop::FaultKind::CrossHeldElongation || fault.kind == femoop::FaultKind::CrossHeldSettlement;
}

/// The first reason, and how many there are.
ui::Message reason_of(const std::vector<femoop::Fault>& faults, const ui::Catalogue& tr)
{
    const std::string first = sentence(faults.front(), tr);
    if (faults.size() == 1) return {"{reason}", {{"reason", first}}};
    return {translatable("First of {count} problems: {sentence}"),
            {{"count", std::to_string(faults.size())}, {"sentence", first}}};
}

/// What is held because of members that were left out is no fault of the model.
ui::Message with_cuts(ui::Message reason, const std::string& held)
{
    return {translatable("{reason}; where members were left out the nodes are held fixed ({nodes}): select more, "
                         "or nothing for the whole structure"),
            {{"reason", std::move(reason)}, {"nodes", held}}};
}

ui::Reason found(const Session& session, const std::vector<femoop::MemberId>& members)
{
    const femoop::Model model = structure_handed(session, members, session.view.load_case);
    try {
        femoop::cross::problem_of(model, session.view.load_case);
    } catch (const femoop::ModelError& error) {
        const std::vector<femoop::Fault> faults = named(error.faults(), model);
        const std::string held = held_nodes(session);
        ui::Message reason = reason_of(faults, session.tr());
        const bool is_of_cuts = !held.empty() && is_of_held_ends(faults.front());
        return is_of_cuts ? with_cuts(std::move(reason), held) : std::move(reason);
    }
    return std::nullopt;
}

} // namespace

ui::Reason DistributionCheck::why_not(const Session& session) const
{
    if (session.model().members.empty()) return ui::Message(translatable("the model has no members"));
    std::vector<femoop::MemberId> members = chosen_members(session);
    if (members.size() > most_members) return std::nullopt;
    Question now{session.number(), session.generation(), session.tr().language(), session.view.load_case,
                 std::move(members)};
    if (asked_ == now) return answer_;
    answer_ = found(session, now.members);
    asked_ = std::move(now);
    return answer_;
}

} // namespace frame
