#pragma once

#include <optional>

#include "apps/frame/tools/tool.h"

namespace frame {

/// Asks for influence lines: press at a section, a support or a node; while the button is held the section goes along.
class InfluenceTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool snaps() const override { return false; }

private:
    std::optional<femoop::MemberId> held_; ///< whose section the hand moves
};

} // namespace frame
