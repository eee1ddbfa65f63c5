#include <doctest/doctest.h>

#include <cstddef>
#include <ctime>
#include <string>

#include "femoop/io/model_file.h"

using namespace femoop;

namespace {

/// A plane frame of `n` bays and `n` storeys, with a load on every beam.
std::string frame_text(int n)
{
    const auto node = [](int i, int j) { return "\"N" + std::to_string(i) + "." + std::to_string(j) + '"'; };
    std::string nodes, members, loads;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const std::string at = "[" + std::to_string(6 * i) + ", " + std::to_string(3 * j) + "]";
            nodes += (nodes.empty() ? "" : ",\n") + std::string("{\"id\": ") + node(i, j) + ", \"at\": " + at +
                     (j == 0 ? ", \"support\": \"fixed\"}" : "}");
        }
    const auto add = [&](const std::string& id, const std::string& a, const std::string& b) {
        members += (members.empty() ? "" : ",\n") + std::string("{\"id\": \"") + id + "\", \"nodes\": [" + a + ", " +
                   b + "], \"material\": \"steel\", \"section\": \"s\"}";
    };
    for (int j = 1; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) add("C" + std::to_string(i) + '.' + std::to_string(j), node(i, j - 1), node(i, j));
        for (int i = 0; i < n; ++i) {
            const std::string id = "B" + std::to_string(i) + '.' + std::to_string(j);
            add(id, node(i, j), node(i + 1, j));
            loads += (loads.empty() ? "" : ",\n") + std::string("{\"member\": \"") + id +
                     "\", \"kind\": \"distributed\", \"qy\": \"-20 kN/m\"}";
        }
    }
    return R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
        "materials": [{"id": "steel", "E": "210 GPa"}], "sections": [{"id": "s", "A": 0.01, "Iz": 1e-4}],
        "nodes": [)" +
           nodes + "],\n\"members\": [" + members + "],\n\"load_cases\": [{\"id\": \"G\", \"members\": [" + loads +
           "]}]}";
}

/// Of the processor, to read and check a sound file of such a frame.
double seconds_to_examine(int n, std::size_t n_members)
{
    const std::string text = frame_text(n);
    const std::clock_t begin = std::clock();
    const ModelReading reading = examine_model(text);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    CHECK(reading.model.members.size() == n_members);
    CHECK(reading.faults.empty());
    return seconds;
}

} // namespace

TEST_CASE("A file of four times as many members is read and checked in less than eight times as long")
{
    const double quarter = seconds_to_examine(112, 25'200), whole = seconds_to_examine(224, 100'576);
    MESSAGE("100 576 members are read and checked in " << whole << " s of the processor");
    CHECK(whole < 8.0 * quarter); // with the square of their number it would be sixteen
}
