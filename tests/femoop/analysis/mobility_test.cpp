#include <doctest/doctest.h>

#include <optional>

#include "femoop/analysis/linear_static.h"
#include "tests/femoop/analysis/mobility.h"
#include "tests/femoop/analysis/random_structure.h"
#include "tests/samples.h"

using namespace femoop;

namespace {

std::optional<MechanismError> refusal(const Model& model)
{
    try {
        analyse(model);
    } catch (const MechanismError& error) {
        return error;
    }
    return std::nullopt;
}

} // namespace

TEST_SUITE("mobility")
{
    TEST_CASE("A structure is refused if and only if its geometry lets it move")
    {
        constexpr unsigned n_seeds = samples(120, 30);
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = 0; seed < n_seeds; ++seed) {
                const Model model = random_linkage(kind, seed);
                const Mobility expected = mobility(model);
                if (!expected.is_clear) continue;
                const std::optional<MechanismError> error = refusal(model);
                CAPTURE(name(kind));
                CAPTURE(seed);
                CAPTURE(expected.n_free);
                if (expected.n_mechanisms > 0) CHECK(error);
                else if (error) CHECK_FALSE(error->causes().empty()); // a spin that supports let, not joints
                if (error) CHECK(std::string(error->what()).find("strain:  ") == std::string::npos);
            }
    }
}
