#pragma once

#include "ui/context/gl.h"

namespace ui::gl {

/// A Loader of an OpenGL that draws nothing and finds everything in order: for tests of what is drawn as words and
/// numbers, where there is no renderer or its pictures are not wanted.
Proc empty_function(const char* name);

} // namespace ui::gl
