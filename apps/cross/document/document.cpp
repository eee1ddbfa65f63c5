#include "apps/cross/document/document.h"

namespace cross {

Document unworked(Document document)
{
    document.plays.clear();
    document.stage = 0;
    return document;
}

bool is_same_task(const Document& a, const Document& b)
{
    return a.method == b.method && a.pupil == b.pupil && a.model == b.model;
}

} // namespace cross
