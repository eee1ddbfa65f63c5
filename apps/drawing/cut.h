#pragma once

#include "femoop/model/ids.h"

namespace drawing {

/// A section of a member.
struct Cut {
    femoop::MemberId member;
    double x = 0.0; ///< from the first end of its flexible part, in the model's unit of length

    friend bool operator==(const Cut&, const Cut&) = default;
};

} // namespace drawing
