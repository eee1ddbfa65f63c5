#include "apps/cross/view/stiffness.h"

#include <algorithm>
#include <cmath>

#include "ui/text/number_format.h"

namespace cross {

double stiffness_of(const Task& task, femoop::MemberId member)
{
    const femoop::cross::MemberAction& action = task.problem.members[member.index];
    return action.is_tapered ? 0.0 : action.EI_over_L * action.length;
}

double smallest_stiffness(const Task& task)
{
    double smallest = 0.0;
    for (std::size_t m = 0; m < task.problem.members.size(); ++m)
        if (const double EI = stiffness_of(task, femoop::MemberId(m)); EI > 0.0)
            smallest = smallest > 0.0 ? std::min(smallest, EI) : EI;
    return smallest;
}

std::string stiffness_text(const Task& task, femoop::MemberId member, const ui::NumberFormat& format)
{
    if (task.problem.members[member.index].is_tapered) return "EI(x)";
    constexpr double same = 1e-6;
    const double EI = stiffness_of(task, member), smallest = smallest_stiffness(task);
    if (!(EI > 0.0)) return "";
    const double times = EI / smallest;
    return (std::abs(times - 1.0) < same ? "" : ui::number_text(times, {3, format.mark})) + "EI";
}

} // namespace cross
