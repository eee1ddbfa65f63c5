#include "femoop/model/check/check.h"

#include <utility>

#include "femoop/model/check/check_parts.h"
#include "femoop/model/check/checker.h"

namespace femoop {

std::vector<Fault> check_readable(const Model& model, const Unreadable& unreadable, Thoroughness thoroughness)
{
    return Checker(model, unreadable).run(thoroughness);
}

std::vector<Fault> check(const Model& model) { return check_readable(model, {}); }

void require_sound(const Model& model)
{
    std::vector<Fault> errors;
    for (Fault& fault : check_readable(model, {}, Thoroughness::Errors))
        if (severity(fault.kind) == Severity::Error) errors.push_back(std::move(fault));
    if (!errors.empty()) throw ModelError(std::move(errors));
}

} // namespace femoop
