#pragma once

#include <string>
#include <string_view>

/// A sound file of a plane model, of which a case replaces a part: two Q4 side by side, the left one clamped.
///
///      D---E---F        AD is the curve `left`, CF `right`, BE `middle`; each element is in a region of its own
///      |web|rib|
///      A---B---C
struct PlaneText {
    std::string_view analysis = "plane_stress";
    std::string_view materials = R"([{"id": "m", "E": 71e3, "nu": 0.27, "alpha": 2.3e-5, "density": 2.7e-9}])";
    std::string_view points = R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [7, 0]},
        {"id": "D", "at": [0, 2]}, {"id": "E", "at": [3, 2]}, {"id": "F", "at": [7, 2]}])";
    std::string_view curves = R"([{"id": "left", "kind": "edges", "points": ["D", "A"], "support": "fixed"},
        {"id": "middle", "kind": "edges", "points": ["B", "E"]}, {"id": "right", "kind": "edges", "points": ["C", "F"]}])";
    std::string_view regions = R"([{"id": "web", "material": "m", "thickness": 0.4},
        {"id": "rib", "material": "m", "thickness": 0.4}])";
    std::string_view elements = R"([{"id": "1", "kind": "Q4", "points": ["A", "B", "E", "D"], "region": "web"},
        {"id": "2", "kind": "Q4", "points": ["B", "C", "F", "E"], "region": "rib"}])";
    std::string_view load_case = ""; ///< ", \"key\": value" of the one case P
    std::string_view more = "";      ///< ", \"key\": value"

    std::string text() const;
};
