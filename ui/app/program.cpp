#include "ui/app/program.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include "ui/app/app_options.h"
#include "ui/text/catalogue.h"
#include "ui/text/printable.h"
#include "ui/text/standard_output.h"

namespace ui {

namespace {

constexpr int done = 0, failed = 2;

/// On stderr: what was typed may stand in it, control characters too.
void report(std::string_view text) { std::cerr << printable(std::string(text)) << '\n'; }

/// What the options ask for, on stdout.
int answer(std::string_view name, const std::string& text)
{
    const std::optional<Message> fault = print(text + "\n");
    if (!fault) return done;
    report(std::string(name) + ": " + Catalogue()(*fault));
    return failed;
}

int status_of(std::string_view name, const std::function<int()>& run)
try {
    return run();
} catch (const OptionsEnd& end) {
    if (end.status == done) return answer(name, end.what());
    report(end.what());
    return end.status;
} catch (const std::exception& error) {
    report(std::string(name) + ": " + error.what());
    return failed;
}

} // namespace

void run_program(std::string_view name, const std::function<int()>& run)
{
    // Without OpenBLAS, which waits at the end for memory where there is none.
    std::_Exit(status_of(name, run));
}

} // namespace ui
