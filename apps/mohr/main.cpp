#include <cstdlib>
#include <exception>
#include <iostream>

#include "apps/mohr/window/options.h"
#include "apps/mohr/window/run.h"

int main(int argc, char** argv)
try {
    return mohr::run(mohr::parse_options(argc, argv));
} catch (const ui::OptionsEnd& end) {
    (end.status == 0 ? std::cout : std::cerr) << end.what() << '\n';
    return end.status;
} catch (const std::exception& error) {
    std::cerr << "mohr: " << error.what() << '\n';
    std::quick_exit(2); // without OpenBLAS, which waits at the end for memory where there is none
}
