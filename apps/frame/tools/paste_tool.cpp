#include "apps/frame/tools/paste_tool.h"

#include <utility>

#include "apps/frame/document/drawing.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector2d;
using Eigen::Vector3d;
using femoop::Model;

namespace {

/// Nodes and members that were made since `before`.
std::vector<Preview::Carried> made_since(const Model& before, const Model& model)
{
    const femoop::MovedParts moved(before);
    const auto place_of = [&](femoop::NodeId node) { return femoop::position_of(model, node); };
    std::vector<Preview::Carried> made;
    for (const femoop::Member& member : model.members)
        if (!moved.former(member)) made.push_back({place_of(member.nodes[0]), place_of(member.nodes[1]), member.id});
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Vector3d place = place_of(femoop::NodeId(i));
        if (!moved.former(model.nodes[i])) made.push_back({place, place, model.nodes[i].id});
    }
    return made;
}

} // namespace

PasteTool::PasteTool(std::shared_ptr<const Clipping> clipping, const femoop::Units& units)
    : clipping_(std::move(clipping)), grip_(grip_of(*clipping_, units))
{}

std::optional<Change> PasteTool::move(const Work& work, const Aim& to)
{
    const Hold hold{to.place(), to.crossings()};
    if (!to.is_lost && !is_done_ && foreseen_for_ != hold) foresee(work, hold);
    return std::nullopt;
}

void PasteTool::foresee(const Work& work, const Hold& hold)
{
    Document next = work.document;
    const Change change = put(work, hold);
    Selection pasted;
    change.command(next);
    change.after_selecting(next, pasted);
    foreseen_ = made_since(work.document.model, next.model);
    foreseen_for_ = hold;
}

std::optional<Change> PasteTool::press(const Work& work, const Aim& at)
{
    if (at.is_lost) return std::nullopt;
    is_done_ = true;
    return put(work, {at.place(), at.crossings()});
}

std::optional<Change> PasteTool::type(const Work& work, const Vector2d& place)
{
    return type_in_space(work, {place.x(), place.y(), 0.0});
}

std::optional<Change> PasteTool::type_in_space(const Work& work, const Vector3d& place)
{
    is_done_ = true;
    return put(work, {place, femoop::Crossings::Cut});
}

Change PasteTool::put(const Work& work, const Hold& hold) const
{
    return {.label = ui::translatable("Paste"),
            .command = [clipping = clipping_,
                        place = hold.place](Document& document) { paste(document, *clipping, place); },
            .after_selecting =
                [before = work.document.model, crossings = hold.crossings](Document& document, Selection& pasted) {
                    join(document, pasted, before, {.crossings = crossings});
                }};
}

Preview PasteTool::preview() const
{
    Preview preview;
    if (!is_done_) preview.carried = foreseen_;
    return preview;
}

} // namespace frame
