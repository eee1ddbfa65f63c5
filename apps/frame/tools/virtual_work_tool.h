#pragma once

#include <optional>

#include "apps/frame/tools/tool.h"
#include "apps/frame/virtual_work/asked_work.h"

namespace frame {

/// Asks for a displacement by virtual work: of the node that is clicked, or of the section of a member, which goes along
/// with the hand while the button is held.
class VirtualWorkTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override; ///< a drag: the displacement is as it was when the button went down
    bool takes_hold(const Work& work, const Aim& at) const override;
    bool snaps() const override { return false; }

private:
    std::optional<femoop::MemberId> held_; ///< whose section the hand moves
    AskedWork* pressed_ = nullptr;         ///< while it does
    AskedWork before_;                     ///< it as the button went down
};

} // namespace frame
