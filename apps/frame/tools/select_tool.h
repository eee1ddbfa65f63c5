#pragma once

#include <cstdint>

#include "apps/frame/tools/tool.h"

namespace frame {

/// Selects: a click one part, with Shift more; a window drawn to the right what lies inside it, one drawn to the left
/// what it touches, as they are seen. A drag of a selected part moves the selection, one of a load's arrow changes its
/// value or, along the member, the place of a point load, one of a support's symbol turns the support, one of a
/// dimension line changes its distance; a model that is seen in space is turned by a drag, so these are for the others.
class SelectTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override;
    std::span<const femoop::NodeId> moving() const override { return moving_; }
    Preview preview() const override;

private:
    enum class Gesture : std::uint8_t { None, Move, Pull, Carry, Turn, Slide, Window };

    Change moved(const Work& work, const Aim& to) const;
    Change pulled(const Work& work, const Aim& to) const;
    bool goes_along_member(const femoop::Model& model, const Aim& to) const;
    Change carried(const Work& work, const Aim& to) const;
    Change turned(const Work& work, const Aim& to) const;
    Change slid(const Work& work, const Aim& to) const;
    Gesture gesture_at(const Aim& at) const;
    void select_window(const Work& work) const;

    Gesture gesture_ = Gesture::None;
    Aim start_, now_;
    Selection grabbed_; ///< what a gesture moves; the selection itself follows what is joined in passing
    std::vector<femoop::NodeId> moving_;
    bool is_dragging_ = false;  ///< the hand has gone so far that the gesture is no click
    bool was_selected_ = false; ///< before the press
};

} // namespace frame
