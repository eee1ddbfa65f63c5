#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "apps/frame/document/clipping.h"
#include "apps/frame/tools/select_tool.h"
#include "apps/frame/tools/settings.h"

namespace frame {

enum class ToolKind : std::uint8_t {
    Select,
    Member,
    Node,
    Support,
    Load,
    Hinge,
    Dimension,
    Delete,
    Predict,
    Influence,
    FreeBody,
    Funicular,
    VirtualWork,
    Paste
};

/// The hand that works in the picture: the tool it holds, how the tools are set, and a place that is being typed.
class ToolController {
public:
    ToolController();

    ToolKind kind() const { return kind_; }
    Tool& tool() { return *tool_; }
    const Tool& tool() const { return *tool_; }
    /// Selects a tool, anew if it is the same: what was begun with the last one is given up.
    void select(ToolKind kind);
    /// Takes up what was copied, to put it down once. \pre the clipping holds structure
    void carry(std::shared_ptr<const Clipping> clipping, const femoop::Units& units);
    /// Goes back to the selecting tool from one that is done.
    void settle();
    /// Gives up what is typed, else what is begun, else the tool. \returns false where there was none of these
    bool escape();

    bool is_sketching() const { return !tool_->preview().stroke.empty(); } ///< the button is held

    /// The tool can use a place that is typed; what has been typed of it so far.
    bool can_type() const { return tool_->draws(); }
    const std::string& typed() const { return typed_; }
    /// Takes those of the letters that a place begins with, and once it is begun all. \returns whether there was one
    bool type(const std::string& letters);
    void backspace();
    /// Ends the typing: the change that the tool asks for at this place. What is no place, or one that the tool has no
    /// use for, stays to be mended.
    std::optional<Change> enter(const Work& work);
    /// Why what is typed is no place that can be used. \pre something is typed
    ui::Message why_not_enter(const Work& work) const;

    void point_at(const Aim& aim) { aim_ = aim; }
    const Aim& aim() const { return aim_; }

    ToolSettings& settings() { return *settings_; }
    const ToolSettings& settings() const { return *settings_; }

private:
    std::optional<Eigen::Vector2d> typed_place(const Work& work) const;
    std::optional<Eigen::Vector3d> typed_place_in_space(const Work& work) const;

    std::unique_ptr<ToolSettings> settings_; ///< the tools know where it is
    ToolKind kind_ = ToolKind::Select;
    std::unique_ptr<Tool> tool_;
    std::string typed_;
    Aim aim_;
};

} // namespace frame
