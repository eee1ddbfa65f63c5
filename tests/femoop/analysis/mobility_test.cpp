#include <doctest/doctest.h>

#include <cstdlib>
#include <iostream>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/model_file.h"
#include "tests/femoop/analysis/mobility.h"
#include "tests/femoop/analysis/random_structure.h"

using namespace femoop;

TEST_SUITE("mobility")
{
    TEST_CASE("A structure is refused if and only if its geometry lets it move")
    {
        const char* n = std::getenv("MOB_N");
        const unsigned from = n ? std::atoi(std::getenv("MOB_FROM")) : 0, to = n ? from + std::atoi(n) : 60;
        int counts[3] = {};
        for (const AnalysisKind kind : every_model)
            for (unsigned seed = from; seed < to; ++seed) {
                const Model model = random_linkage(kind, seed);
                const Mobility expected = mobility(model);
                if (n && std::getenv("MOB_DUMP")) write_model_file(model, "/tmp/snd/" + std::string(name(kind)) + ".json");
                if (!expected.is_clear) {
                    ++counts[2];
                    continue;
                }
                bool moves = false;
                std::string words;
                try {
                    analyse(model);
                } catch (const MechanismError& error) {
                    moves = true;
                    words = error.what();
                } catch (const ModelError& error) {
                    if (n) {
                        std::cerr << name(kind) << ' ' << seed << " ModelError " << error.what() << '\n';
                    }
                    continue;
                }
                CAPTURE(name(kind));
                CAPTURE(seed);
                if (n && words.find("strain:  ") != std::string::npos)
                    std::cerr << "NOSUBJ " << name(kind) << ' ' << seed << '\n';
                if (n && moves != (expected.n_mechanisms > 0))
                    std::cerr << name(kind) << ' ' << seed << " expected " << expected.n_mechanisms << " free "
                              << expected.n_free << " moves " << moves << ' ' << words.substr(0, 230) << '\n';
                else if (!n) CHECK(moves == (expected.n_mechanisms > 0));
                ++counts[moves];
            }
        if (n) std::cerr << counts[0] << " sound " << counts[1] << " mech " << counts[2] << " unclear\n";
    }
}
