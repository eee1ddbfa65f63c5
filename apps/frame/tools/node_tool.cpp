#include "apps/frame/tools/node_tool.h"

#include "apps/frame/document/drawing.h"
#include "ui/text/catalogue.h"

namespace frame {

std::optional<Change> NodeTool::type(const Work&, const Eigen::Vector2d& place)
{
    return Change{ui::translatable("Add a node"), [place](Document& document) { add_node(document, place); }};
}

} // namespace frame
