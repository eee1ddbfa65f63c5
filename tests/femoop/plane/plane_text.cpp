#include "tests/femoop/plane/plane_text.h"

std::string PlaneText::text() const
{
    std::string text = R"({"cremona": 1, "analysis": ")" + std::string(analysis) +
                       R"(", "units": {"length": "mm", "force": "N"})";
    const auto add = [&](const char* key, std::string_view value) {
        text += std::string(", \"") + key + "\": " + std::string(value);
    };
    add("materials", materials);
    add("points", points);
    add("curves", curves);
    add("regions", regions);
    add("elements", elements);
    add("load_cases", R"([{"id": "P")" + std::string(load_case) + "}]");
    return text + std::string(more) + "}";
}
