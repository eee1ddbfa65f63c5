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
    return 2;
}
