#include "apps/frame/tools/tool.h"

namespace frame {

std::optional<Part> Aim::part() const
{
    if (node) return *node;
    if (cut) return cut->member;
    if (support) return support->node;
    if (grip) return grip->load;
    return std::nullopt;
}

} // namespace frame
