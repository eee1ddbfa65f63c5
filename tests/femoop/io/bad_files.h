#pragma once

#include <string>
#include <string_view>
#include <vector>

/// A file with one fault, and the sentence that it gets. A warning counts as a fault here.
struct BadFile {
    std::string text;
    std::string message;
};

/// A sound file, of which a case replaces a part: a clamped member of 6 m with nothing special about it.
struct File {
    std::string_view analysis = R"("frame2d")";
    std::string_view units = R"({"length": "m", "force": "kN"})";
    std::string_view materials = R"([{"id": "m", "E": "205 GPa"}])";
    std::string_view sections = R"([{"id": "s", "A": 0.012, "Iz": 2e-4}])";
    std::string_view nodes = R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [6, 0]}])";
    std::string_view members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}])";
    std::string_view more = ""; ///< ", \"key\": value"

    std::string text() const;
};

std::vector<BadFile> files_that_are_no_text();
std::vector<BadFile> files_that_are_no_json();
std::vector<BadFile> files_with_bad_keys();
std::vector<BadFile> files_with_bad_quantities();
std::vector<BadFile> files_with_bad_materials_and_sections();
std::vector<BadFile> files_with_bad_nodes();
std::vector<BadFile> files_with_bad_members();
std::vector<BadFile> files_with_bad_loads();
std::vector<BadFile> files_with_bad_expectations();
std::vector<BadFile> files_with_bad_moving_loads();
std::vector<BadFile> files_with_warnings();
