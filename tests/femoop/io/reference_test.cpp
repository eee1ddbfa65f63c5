#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/model_file.h"
#include "tests/text_of.h"

using namespace femoop;

namespace {

/// The fenced blocks of JSON in a page of the reference.
std::vector<std::string> json_blocks(const std::string& page)
{
    const std::string text = text_of_source("courseware/reference/" + page);
    const std::string opening = "```json\n", closing = "```";
    std::vector<std::string> blocks;
    for (std::size_t begin = text.find(opening); begin != std::string::npos; begin = text.find(opening, begin)) {
        begin += opening.size();
        blocks.push_back(text.substr(begin, text.find(closing, begin) - begin));
    }
    return blocks;
}

} // namespace

TEST_CASE("Every model shown in the reference of the model file is sound and can be solved")
{
    const auto blocks = json_blocks("model-file.md");
    REQUIRE(blocks.size() == 4);
    for (const std::string& block : blocks) {
        CAPTURE(block);
        const ModelReading reading = examine_model(block);
        for (const Fault& fault : reading.faults) FAIL_CHECK(message(fault));
        CHECK_NOTHROW(analyse(reading.model));
    }
}
