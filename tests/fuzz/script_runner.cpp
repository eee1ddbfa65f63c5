// Whatever the bytes, a script runs or is refused with a reason, every solid stays sound, and all of it can be undone.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/script/script_runner.h"
#include "topology/script/script_writer.h"
#include "topology/text/line_error.h"
#include "topology/text/words.h"

namespace {

using topology::NamedSolid;
using topology::ScriptRunner;

[[noreturn]] void fail(std::string_view what, std::string_view line)
{
    std::cerr << what << " after the line\n" << line << '\n';
    std::abort();
}

void require_sound(const ScriptRunner& runner, std::string_view line)
{
    for (const NamedSolid& solid : runner.solids()) {
        if (const auto breach = topology::why_not_valid(solid.solid)) fail(topology::sentence(*breach), line);
        if (topology::euler_counts(solid.solid).formula() != 0) fail("the formula does not hold", line);
    }
}

void run(ScriptRunner& runner, std::string_view line)
{
    try {
        runner.run_line(line);
    } catch (const topology::LineError& fault) {
        if (std::string_view(fault.what()).empty()) fail("no reason is given", line);
    }
}

/// What is left comes out as a script that makes it again.
void require_written(const ScriptRunner& runner)
{
    for (const NamedSolid& solid : runner.solids()) {
        const std::string script = topology::construction_script(solid);
        ScriptRunner again;
        topology::run_script(again, script, {});
        if (!solid.is_alive()) continue;
        if (!(topology::euler_counts(again.solids().front().solid) == topology::euler_counts(solid.solid)))
            fail("the solid changed when it was written as", script);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    ScriptRunner runner;
    for (topology::Lines lines({reinterpret_cast<const char*>(data), size}); lines.next();) {
        run(runner, lines.line());
        require_sound(runner, lines.line());
    }
    require_written(runner);
    while (runner.n_steps() != 0) runner.run_line("undo");
    for (const NamedSolid& solid : runner.solids())
        if (!(solid.solid == topology::Solid())) fail("something is left of " + solid.name, "undo");
    return 0;
}
