// The scripts of examples/ are right side out and as large as they look.
#include <doctest/doctest.h>

#include <map>
#include <string>

#include "tests/text_of.h"
#include "topology/modeling/mass_properties.h"
#include "topology/script/script_runner.h"

using namespace topology;

TEST_CASE("The scripts of the examples make solids of the volume that their coordinates say")
{
    const std::map<std::string, double> volumes{{"cube", 1.0},
                                                {"tetrahedron", 1.0 / 6.0},
                                                {"through_hole", 32.0 - 8.0},
                                                {"void", 64.0 - 8.0},
                                                {"hoffmann", 128.0 - 16.0 - 8.0},
                                                {"torus_by_rotation", 18.0 - 8.0},
                                                {"shell_and_hole", 64.0 - 8.0 + 4.0}};
    for (const auto& known : volumes) {
        CAPTURE(known.first);
        const std::string text = text_of_source("examples/" + known.first + ".eul");
        ScriptRunner runner;
        run_script(runner, text, {});
        REQUIRE(runner.solids().size() == 1);
        CHECK(mass_properties(runner.solids().front().solid).volume == doctest::Approx(known.second));
    }
}
