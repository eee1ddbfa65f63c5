#include "apps/frame/tools/tool_controller.h"

#include <utility>

#include "apps/frame/tools/dimension_tool.h"
#include "apps/frame/tools/free_body_tool.h"
#include "apps/frame/tools/funicular_tool.h"
#include "apps/frame/tools/influence_tool.h"
#include "apps/frame/tools/load_tool.h"
#include "apps/frame/tools/member_tool.h"
#include "apps/frame/tools/node_tool.h"
#include "apps/frame/tools/part_tools.h"
#include "apps/frame/tools/paste_tool.h"
#include "apps/frame/tools/predict_tool.h"
#include "apps/frame/tools/typed_place.h"
#include "apps/frame/tools/virtual_work_tool.h"
#include "ui/text/catalogue.h"

namespace frame {

namespace {

std::unique_ptr<Tool> tool_of(ToolKind kind, const ToolSettings& settings)
{
    switch (kind) {
    case ToolKind::Paste: // comes with what it carries
    case ToolKind::Select: break;
    case ToolKind::Member: return std::make_unique<MemberTool>();
    case ToolKind::Node: return std::make_unique<NodeTool>();
    case ToolKind::Support: return std::make_unique<SupportTool>(settings);
    case ToolKind::Load: return std::make_unique<LoadTool>(settings);
    case ToolKind::Hinge: return std::make_unique<HingeTool>();
    case ToolKind::Dimension: return std::make_unique<DimensionTool>();
    case ToolKind::Delete: return std::make_unique<DeleteTool>();
    case ToolKind::Predict: return std::make_unique<PredictTool>(settings);
    case ToolKind::FreeBody: return std::make_unique<FreeBodyTool>();
    case ToolKind::Funicular: return std::make_unique<FunicularTool>();
    case ToolKind::VirtualWork: return std::make_unique<VirtualWorkTool>();
    case ToolKind::Influence: return std::make_unique<InfluenceTool>();
    }
    return std::make_unique<SelectTool>();
}

// What a place begins with; then a unit or a calculation may follow.
constexpr std::string_view first_letters = "0123456789+-.@(";
bool is_printed(char letter) { return static_cast<unsigned char>(letter) >= ' ' && letter != '\x7f'; }

} // namespace

ToolController::ToolController() : settings_(std::make_unique<ToolSettings>()), tool_(tool_of(kind_, *settings_)) {}

void ToolController::select(ToolKind kind)
{
    kind_ = kind;
    tool_ = tool_of(kind, *settings_);
    typed_.clear();
}

void ToolController::carry(std::shared_ptr<const Clipping> clipping, const femoop::Units& units)
{
    kind_ = ToolKind::Paste;
    tool_ = std::make_unique<PasteTool>(std::move(clipping), units);
    typed_.clear();
}

void ToolController::settle()
{
    if (tool_->is_done()) select(ToolKind::Select);
}

bool ToolController::escape()
{
    if (!std::exchange(typed_, {}).empty() || tool_->escape()) return true;
    if (kind_ == ToolKind::Select) return false;
    select(ToolKind::Select);
    return true;
}

bool ToolController::type(const std::string& letters)
{
    if (!can_type()) return false;
    const std::size_t before = typed_.size();
    for (const char letter : letters) {
        const bool begins = first_letters.find(letter) != std::string_view::npos;
        if (typed_.empty() ? begins : is_printed(letter)) typed_ += letter;
    }
    return typed_.size() > before;
}

void ToolController::backspace()
{
    const auto is_continued = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; };
    while (!typed_.empty() && is_continued(typed_.back())) typed_.pop_back(); // the later bytes of a sign such as °
    if (!typed_.empty()) typed_.pop_back();
}

std::optional<Eigen::Vector2d> ToolController::typed_place(const Work& work) const
{
    return place_typed(
        typed_,
        {.from = tool_->from(), .pointer = aim_.snap.place, .file = work.document.model.units, .shown = work.units});
}

std::optional<Eigen::Vector3d> ToolController::typed_place_in_space(const Work& work) const
{
    return place_typed_in_space(typed_, {.from = tool_->from_in_space(),
                                         .pointer = aim_.is_lost ? std::nullopt : aim_.in_space,
                                         .plane = settings_->plane,
                                         .file = work.document.model.units,
                                         .shown = work.units});
}

ui::Message ToolController::why_not_enter(const Work& work) const
{
    if (femoop::is_3d(work.document.model.analysis))
        return {ui::translatable("{text} is no place; type 6,4,3 or @0,0,3, or 6,4 in the working plane"),
                {{"text", typed_}}};
    const auto place = typed_place(work);
    const auto reason = place ? tool_->why_not_type(work, *place) : std::nullopt;
    return reason.value_or(
        ui::Message(ui::translatable("{text} is no place; type 6,4 or @3,2 or 4<30"), {{"text", typed_}}));
}

std::optional<Change> ToolController::enter(const Work& work)
{
    if (femoop::is_3d(work.document.model.analysis)) {
        const auto place = typed_place_in_space(work);
        if (!place) return std::nullopt;
        typed_.clear();
        std::optional<Change> change = tool_->type_in_space(work, *place);
        settle();
        return change;
    }
    const auto place = typed_place(work);
    if (!place || tool_->why_not_type(work, *place)) return std::nullopt;
    typed_.clear();
    std::optional<Change> change = tool_->type(work, *place);
    settle();
    return change;
}

} // namespace frame
