#include "apps/plane/tools/hand.h"

#include <utility>

#include "apps/drawing/place_typed.h"
#include "apps/plane/document/points.h"

namespace plane {

std::optional<CurveToolKind> curve_of(ToolKind tool)
{
    switch (tool) {
    case ToolKind::Line: return CurveToolKind::Line;
    case ToolKind::Polyline: return CurveToolKind::Polyline;
    case ToolKind::Arc: return CurveToolKind::Arc;
    case ToolKind::ArcCenter: return CurveToolKind::ArcCenter;
    case ToolKind::Circle: return CurveToolKind::Circle;
    case ToolKind::Ellipse: return CurveToolKind::Ellipse;
    case ToolKind::Bezier: return CurveToolKind::Bezier;
    case ToolKind::Spline: return CurveToolKind::Spline;
    case ToolKind::Select:
    case ToolKind::Point:
    case ToolKind::Erase:
    case ToolKind::Probe:
    case ToolKind::Cut:
    case ToolKind::Align: break;
    }
    return std::nullopt;
}

void Hand::select(ToolKind tool)
{
    tool_ = tool;
    typed_.clear();
    curve_tool_.reset();
    align_tool_.reset();
    cut_start_.reset();
    if (tool == ToolKind::Align) align_tool_.emplace();
    if (const auto curve = curve_of(tool)) curve_tool_.emplace(*curve);
}

bool Hand::has_begun() const
{
    return cut_start_ || (curve_tool_ && curve_tool_->has_begun()) || (align_tool_ && align_tool_->has_begun());
}

std::optional<CurveDraft> Hand::click(const Aim& aim)
{
    return curve_tool_->add({aim.snap.place, aim.snap.point}, aim.adds);
}

std::optional<std::array<FlatPoint, 2>> Hand::cut_to(const FlatPoint& place)
{
    if (!cut_start_) {
        cut_start_ = place;
        return std::nullopt;
    }
    const FlatPoint start = *cut_start_;
    if (start == place) return std::nullopt;
    cut_start_.reset();
    return std::array{start, place};
}

std::optional<Alignment> Hand::align_as_typed(const FlatPoint& place, const ui::DisplayUnits& shown)
{
    const bool counts_from_first = typed_.find_first_of("@<") != std::string::npos ||
                                   drawing::is_one_number(typed_, true, shown);
    return counts_from_first && !align_tool_->picks() ? align_tool_->add_second(place) : align_tool_->add(place);
}

bool Hand::escape()
{
    if (!typed_.empty()) {
        typed_.clear();
        return true;
    }
    if (std::exchange(cut_start_, std::nullopt)) return true;
    if (curve_tool_ && curve_tool_->escape()) return true;
    if (align_tool_ && align_tool_->escape()) return true;
    if (tool_ == ToolKind::Select) return false;
    select(ToolKind::Select);
    return true;
}

bool Hand::type(const std::string& letters)
{
    constexpr std::string_view beginnings = "0123456789.,-@+";
    bool was_one = false;
    for (const char letter : letters) {
        if (typed_.empty() && beginnings.find(letter) == std::string_view::npos) continue;
        typed_ += letter;
        was_one = true;
    }
    return was_one;
}

void Hand::backspace()
{
    while (!typed_.empty()) { // a letter may be of several bytes
        const auto byte = static_cast<unsigned char>(typed_.back());
        typed_.pop_back();
        if ((byte & 0xC0U) != 0x80U) break;
    }
}

std::optional<FlatPoint> Hand::typed_place(const femoop::Units& file, const ui::DisplayUnits& shown) const
{
    drawing::DrawingHand hand{
        .from = std::nullopt, .pointer = {aim_.snap.place.x, aim_.snap.place.y}, .file = file, .shown = shown};
    if (const auto from = curve_tool_ ? curve_tool_->from() : cut_start_) hand.from = {from->x, from->y};
    if (align_tool_ && !align_tool_->picks()) { // how far apart two places are needs no pointer
        hand.from = {align_tool_->from().x, align_tool_->from().y};
        hand.pointer = {align_tool_->towards().x, align_tool_->towards().y};
    }
    const auto place = drawing::place_typed(typed_, hand);
    if (!place || !place->allFinite()) return std::nullopt;
    return short_place({place->x(), place->y()});
}

std::optional<CurveDraft> Hand::preview() const
{
    return curve_tool_ ? curve_tool_->preview(aim_.snap.place, aim_.adds) : std::nullopt;
}

} // namespace plane
