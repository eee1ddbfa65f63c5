#pragma once

#include <string>

#include "femoop/io/plane/plane_file.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "tests/text_of.h"

namespace plane_test {

/// A case of tests/cases/plane, solved.
inline femoop::plane::PlaneResults solved(const std::string& name)
{
    return femoop::plane::analyse(
        femoop::plane::read_plane_model(text_of_source("tests/cases/plane/" + name + ".json")));
}

/// A cantilever of n x m Q8 elements under a shear at its end, as the text of its file.
///
///      |+-----------------+ |
///      |                  | v   length 10, height 2, thickness 0.5, q = 3 downwards over the end
///      |+-----------------+
inline std::string cantilever_text(int n, int m)
{
    std::string points, elements, left, right;
    const auto id = [](int i, int j) { return "\"n" + std::to_string(i) + "_" + std::to_string(j) + "\""; };
    const auto join = [](std::string& list, const std::string& one) { list += (list.empty() ? "" : ", ") + one; };
    for (int j = 0; j <= 2 * m; ++j)
        for (int i = 0; i <= 2 * n; ++i) {
            if (i % 2 == 1 && j % 2 == 1) continue;
            join(points, "{\"id\": " + id(i, j) + ", \"at\": [" + std::to_string(5.0 * i / n) + ", " +
                             std::to_string(1.0 * j / m - 1.0) + "]}");
        }
    for (int j = 0; j < 2 * m; j += 2)
        for (int i = 0; i < 2 * n; i += 2)
            join(elements, "{\"id\": \"e" + std::to_string(i) + "_" + std::to_string(j) +
                               "\", \"kind\": \"Q8\", \"region\": \"beam\", \"points\": [" + id(i, j) + ", " +
                               id(i + 2, j) + ", " + id(i + 2, j + 2) + ", " + id(i, j + 2) + ", " + id(i + 1, j) +
                               ", " + id(i + 2, j + 1) + ", " + id(i + 1, j + 2) + ", " + id(i, j + 1) + "]}");
    for (int j = 0; j <= 2 * m; j += 2) {
        join(left, id(0, 2 * m - j));
        join(right, id(2 * n, j));
    }
    return R"({"cremona": 1, "title": "A cantilever", "analysis": "plane_stress", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "m", "E": 30000, "nu": 0.2}],
      "regions": [{"id": "beam", "material": "m", "thickness": 0.5}], "points": [)" +
           points + "], \"elements\": [" + elements + R"(], "curves": [{"id": "left", "kind": "edges", "points": [)" +
           left + R"(], "support": "fixed"}, {"id": "right", "kind": "edges", "points": [)" + right +
           R"(]}], "load_cases": [{"id": "P", "curves": [{"curve": "right", "kind": "traction", "qy": -3}]}]})";
}

} // namespace plane_test
