#include "ui/app/program.h"

#include <cstdlib>
#include <exception>
#include <iostream>

#include "ui/app/app_options.h"

namespace ui {

int run_program(std::string_view name, const std::function<int()>& run)
try {
    return run();
} catch (const OptionsEnd& end) {
    (end.status == 0 ? std::cout : std::cerr) << end.what() << '\n';
    return end.status;
} catch (const std::exception& error) {
    constexpr int failed = 2;
    std::cerr << name << ": " << error.what() << '\n';
    std::quick_exit(failed); // without OpenBLAS, which waits at the end for memory where there is none
}

} // namespace ui
