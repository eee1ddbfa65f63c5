#include "femoop/model/check/check.h"

#include <utility>

#include "femoop/model/check/check_parts.h"
#include "femoop/model/check/checker.h"
#include "femoop/model/fault/errors_among.h"

namespace femoop {

std::vector<Fault> check_readable(const Model& model, const Unreadable& unreadable, Thoroughness thoroughness)
{
    return Checker(model, unreadable).run(thoroughness);
}

std::vector<Fault> check(const Model& model) { return check_readable(model, {}); }

void require_sound(const Model& model)
{
    std::vector<Fault> errors = errors_among(check_readable(model, {}, Thoroughness::Errors));
    if (!errors.empty()) throw ModelError(std::move(errors));
}

} // namespace femoop
