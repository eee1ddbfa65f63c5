#pragma once

#include <optional>

#include "apps/frame/free_body/asked_body.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// Lifts parts out of the structure: a click on a node or a member, with Shift more members; a line drawn across members
/// as they are seen cuts them and lifts what lies to its left. The point of moments is dragged, to nodes and places of
/// forces where it is near: in a plane or a grillage in this, in space in that of the planes xy, xz and yz through it
/// that is seen most from the front. With Shift the hand turns a model in space.
class FreeBodyTool : public Tool {
public:
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool takes_hold(const Work&, const Aim& at) const override { return !at.adds; }
    bool escape() override;
    bool snaps() const override { return false; }
    Preview preview() const override;

private:
    static bool is_at_moment_point(const AskedBody& body, const Aim& at);
    static Eigen::Vector3d moment_point(const Work& work, const Aim& at);
    static void lift(const Work& work, const Aim& at);
    AskedBody::CutLine line_to(const Aim& at) const;

    std::optional<Aim> press_;
    Eigen::Vector3d now_ = Eigen::Vector3d::Zero(); ///< where the cut has come to
    bool holds_moment_point_ = false;
    bool is_dragged_ = false;
    AskedBody* pressed_ = nullptr; ///< that may be changed until the button is released
    AskedBody before_;             ///< as it was when it was pressed
};

} // namespace frame
