#pragma once

#include <optional>

#include "apps/frame/document/named_sets.h"
#include "apps/frame/tools/settings.h"
#include "apps/frame/tools/tool.h"

namespace frame {

/// The force or moment that the tool is set to; nothing for a distributed load, and where a model of this kind has no
/// such force.
std::optional<femoop::Component> force_of(const ToolSettings& settings, femoop::AnalysisKind kind);

/// Where a load lies along a member: at one place, or from one to another, absent for the member's own end.
struct LoadReach {
    femoop::Position at = femoop::Percent{50.0};
    std::optional<femoop::Position> from{}, to{};
    bool grows = true; ///< a triangular load, towards `to`
};
/// The load on a member that the tool is set to; nothing where a model of this kind has none such.
std::optional<MemberLoadValue> member_load_of(const ToolSettings& settings, femoop::AnalysisKind kind,
                                              const LoadReach& reach);

/// Puts the chosen load on a node or a member that is clicked. A distributed load lies on the whole member, or on the
/// part along which the hand is drawn; a triangular one grows towards the end that was clicked nearer to, or to where
/// the hand was drawn.
class LoadTool : public Tool {
public:
    explicit LoadTool(const ToolSettings& settings) : settings_(settings) {}
    std::optional<Change> press(const Work& work, const Aim& at) override;
    std::optional<Change> move(const Work& work, const Aim& to) override;
    std::optional<Change> release(const Work& work, const Aim& at) override;
    bool escape() override;
    Preview preview() const override;

private:
    /// Along the member that was pressed, while the button is held.
    struct Stroke {
        femoop::MemberId member;
        double length = 0.0, start = 0.0, now = 0.0; ///< places along it
        double press = 0.0;                          ///< of the pointer's own place, rounded to nothing
        bool is_drawn = false;                       ///< so far that it is no click
        Eigen::Vector3d begin = Eigen::Vector3d::Zero(), end = Eigen::Vector3d::Zero();
    };
    std::optional<Change> put(const Work& work, femoop::MemberId member, const LoadReach& reach) const;

    const ToolSettings& settings_;
    std::optional<Stroke> stroke_;
};

} // namespace frame
