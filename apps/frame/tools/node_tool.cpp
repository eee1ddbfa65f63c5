#include "apps/frame/tools/node_tool.h"

#include "apps/frame/document/drawing.h"
#include "ui/text/catalogue.h"

namespace frame {

std::optional<Change> NodeTool::press(const Work& work, const Aim& at)
{
    return at.is_lost ? std::nullopt : type_in_space(work, at.place());
}

std::optional<Change> NodeTool::type(const Work& work, const Eigen::Vector2d& place)
{
    return type_in_space(work, {place.x(), place.y(), 0.0});
}

std::optional<Change> NodeTool::type_in_space(const Work&, const Eigen::Vector3d& place)
{
    return Change{ui::translatable("Add a node"), [place](Document& document) { add_node_in_space(document, place); }};
}

} // namespace frame
