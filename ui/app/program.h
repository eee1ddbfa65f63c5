#pragma once

#include <functional>
#include <string_view>

namespace ui {

/// What the `main` of a program does: reads its options and runs, by `run`, tells on stderr what else ends it, and
/// ends the program. Its exit status is what `run` returns, what an OptionsEnd has, 2 where an exception ends it.
/// \param name  what its sentences begin with
[[noreturn]] void run_program(std::string_view name, const std::function<int()>& run);

} // namespace ui
