#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/plane/tools/align_tool.h"
#include "apps/plane/tools/curve_tool.h"
#include "apps/plane/tools/readings.h"
#include "apps/plane/tools/snap.h"
#include "femoop/model/quantity/units.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"

namespace plane {

enum class ToolKind : std::uint8_t {
    Select,
    Line,
    Polyline,
    Arc,
    ArcCenter,
    Circle,
    Ellipse,
    Bezier,
    Spline,
    Point,
    Erase,
    Probe,
    Cut,
    Align ///< places the backdrop
};

/// The curve that a tool draws; nothing for others.
std::optional<CurveToolKind> curve_of(ToolKind tool);

/// What the pointer points at.
struct Aim {
    FlatPoint pointer;                    ///< its own place [length]
    Snap snap;                            ///< the place that is meant
    std::optional<Part> under;            ///< the part under it
    std::optional<ReadingPart> reading{}; ///< the probe or the end of a cut under it
    double pixel = 0.01;                  ///< one logical pixel [length]
    bool adds = false;                    ///< Shift is held
};

/// The hand that works in the picture: the tool it holds, the curve that is begun, and a place that is being typed.
class Hand {
public:
    ToolKind tool() const { return tool_; }
    void select(ToolKind tool); ///< anew if it is the same: what was begun is given up
    bool reads() const { return tool_ == ToolKind::Probe || tool_ == ToolKind::Cut; }
    /// A click sets a place.
    bool draws() const { return curve_tool_ || align_tool_ || tool_ == ToolKind::Point || reads(); }
    const std::optional<CurveTool>& curve_tool() const { return curve_tool_; }
    const std::optional<AlignTool>& align_tool() const { return align_tool_; }
    bool has_begun() const;
    /// Where the cut begins that is being drawn.
    const std::optional<FlatPoint>& cut_start() const { return cut_start_; }
    /// The next place of a cut: both ends once they are two. \pre holds the tool of cuts
    std::optional<std::array<FlatPoint, 2>> cut_to(const FlatPoint& place);

    /// A click at the place that is meant: the curve that it ends. \pre draws a curve
    std::optional<CurveDraft> click(const Aim& aim);
    /// The next place is one of the backdrop, which nothing of the drawing draws to itself.
    bool picks_in_backdrop() const { return align_tool_ && align_tool_->picks(); }
    /// The next place of the backdrop, or of where it belongs. \pre holds the tool that places it
    std::optional<Alignment> align(const FlatPoint& place) { return align_tool_->add(place); }
    std::optional<Alignment> finish_aligning() { return align_tool_ ? align_tool_->finish() : std::nullopt; }
    /// The same of a place that is typed: one that counts from the first place is where the second belongs.
    std::optional<Alignment> align_as_typed(const FlatPoint& place, const ui::DisplayUnits& shown);
    std::optional<CurveDraft> finish() { return curve_tool_ ? curve_tool_->finish() : std::nullopt; }
    /// A curve of several places is begun, none of which is a step of the document yet.
    bool has_places_to_take_back() const { return tool_ != ToolKind::Line && curve_tool_ && curve_tool_->has_begun(); }
    void take_place_back() { curve_tool_->escape(); } ///< the last one. \pre there are some
    /// Gives up what is typed, else what is begun, else the tool. \returns false where there was none of these
    bool escape();

    const std::string& typed() const { return typed_; }
    /// Takes those of the letters that a place begins with, and once it is begun all. \returns whether there was one
    bool type(const std::string& letters);
    void backspace();
    /// The place that is typed, counted from where drawing began; nothing where it is none.
    std::optional<FlatPoint> typed_place(const femoop::Units& file, const ui::DisplayUnits& shown) const;
    void forget_typed() { typed_.clear(); }

    void point_at(const Aim& aim) { aim_ = aim; }
    const Aim& aim() const { return aim_; }
    std::optional<CurveDraft> preview() const;
    /// What is drawn so far, wherever the pointer is.
    std::optional<CurveDraft> begun() const { return curve_tool_ ? curve_tool_->begun() : std::nullopt; }

    bool snaps_to_grid = true, snaps_to_parts = true;

private:
    ToolKind tool_ = ToolKind::Select;
    std::optional<CurveTool> curve_tool_;
    std::optional<AlignTool> align_tool_;
    std::optional<FlatPoint> cut_start_;
    std::string typed_;
    Aim aim_;
};

} // namespace plane
