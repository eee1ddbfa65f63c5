#pragma once

namespace drawing {}

namespace frame {

/// What the drawing names, such as its parts, what it shows and dimension lines, the whole app calls by the same name.
using namespace drawing;

} // namespace frame
