#include "apps/frame/document/selected_members.h"

#include <variant>

namespace frame {

std::vector<femoop::MemberId> selected_members(const Selection& selection)
{
    std::vector<femoop::MemberId> members;
    for (const Part& part : selection.parts())
        if (const auto* const member = std::get_if<femoop::MemberId>(&part)) members.push_back(*member);
    return members;
}

} // namespace frame
