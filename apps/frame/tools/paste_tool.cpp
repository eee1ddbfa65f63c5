#include "apps/frame/tools/paste_tool.h"

#include <utility>

#include "apps/frame/document/drawing.h"
#include "ui/text/catalogue.h"

namespace frame {

using Eigen::Vector2d;

PasteTool::PasteTool(std::shared_ptr<const Clipping> clipping, const femoop::Units& units)
    : clipping_(std::move(clipping)), grip_(grip_of(*clipping_, units)), outline_(outline_of(*clipping_, units))
{}

std::optional<Change> PasteTool::move(const Work&, const Aim& to)
{
    hand_ = to.snap.place;
    return std::nullopt;
}

std::optional<Change> PasteTool::press(const Work& work, const Aim& at)
{
    return put(work, at.snap.place, at.crossings());
}

std::optional<Change> PasteTool::type(const Work& work, const Vector2d& place)
{
    return put(work, place, femoop::Crossings::Cut);
}

Change PasteTool::put(const Work& work, const Vector2d& place, femoop::Crossings crossings)
{
    is_done_ = true;
    return {.label = ui::translatable("Paste"),
            .command = [clipping = clipping_, place](Document& document) { paste(document, *clipping, place); },
            .after_selecting = [before = work.document.model,
                                crossings](Document& document) { join(document, before, {.crossings = crossings}); }};
}

Preview PasteTool::preview() const
{
    Preview preview;
    for (const auto& [start, end] : outline_)
        if (hand_ && !is_done_) preview.carried.emplace_back(*hand_ + start, *hand_ + end);
    return preview;
}

} // namespace frame
