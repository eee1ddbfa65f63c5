#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/version.h"

namespace {

/// Ends without what libraries do at the end: OpenBLAS, which comes with CHOLMOD, waits there for a thread of its own,
/// which asks again and again for 128 MB where less is allowed.
[[noreturn]] void leave(cli::ExitStatus status) { std::_Exit(static_cast<int>(status)); }

} // namespace

int main(int argc, char** argv)
try {
#ifdef SIGPIPE
    std::signal(SIGPIPE, SIG_IGN); // a reader that goes away is met where the results are written
#endif
#ifdef SIGXFSZ
    std::signal(SIGXFSZ, SIG_IGN); // so is a file that must not grow further
#endif
    leave(cli::run(std::vector<std::string>(argv + 1, argv + argc), CREMONA_VERSION));
} catch (const std::exception& error) {
    std::cerr << "cremona: " << error.what() << '\n';
    leave(cli::ExitStatus::BadInput);
}
