#pragma once

#include <functional>
#include <string_view>

namespace ui {

/// What the `main` of a program does: reads its options and runs, by `run`, and tells on stderr what else ends it.
/// \param name  what its sentences begin with. \returns the exit status: what `run` returns, what an OptionsEnd has,
/// 2 where an exception ends it
int run_program(std::string_view name, const std::function<int()>& run);

} // namespace ui
