#include <csignal>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "apps/cli/command_line.h"

int main(int argc, char** argv)
try {
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN); // a reader that goes away is met where the results are written
#endif
    return static_cast<int>(cli::run(std::vector<std::string>(argv + 1, argv + argc)));
} catch (const std::exception& error) {
    std::cerr << "cremona: " << error.what() << '\n';
    return static_cast<int>(cli::ExitStatus::BadInput);
}
