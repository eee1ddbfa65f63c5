#include <doctest/doctest.h>

#include <string>

#include "femoop/files/whole_file.h"
#include "femoop/io/any_model.h"
#include "femoop/io/file_text.h"
#include "femoop/io/plane/plane_file.h"
#include "tests/femoop/plane/plane_text.h"
#include "tests/source_folder.h"

using namespace femoop;
using namespace femoop::plane;

namespace {

std::string everything() { return file_text(source_folder() + "/tests/femoop/plane/everything_plane.json").text; }

} // namespace

TEST_CASE("A plane model that is written reads back bit for bit, and is written the same again")
{
    const PlaneReading reading = examine_plane_model(everything());
    for (const Fault& fault : reading.faults) FAIL_CHECK(message(fault));
    const std::string written = write_plane_model(reading.model);
    CHECK(read_plane_model(written) == reading.model);
    CHECK(write_plane_model(read_plane_model(written)) == written);
    CHECK(written == everything());
}

TEST_CASE("A file says by its analysis whether it is a plane model or a structure of members")
{
    CHECK(std::holds_alternative<PlaneReading>(examine_any(PlaneText{}.text())));
    CHECK(std::holds_alternative<ModelReading>(examine_any(R"({"cremona": 1, "analysis": "frame2d"})")));
    CHECK(std::holds_alternative<ModelReading>(examine_any("{")));
}

TEST_CASE("Who wants a structure of members and gets a plane model is told so, and nothing else")
{
    CHECK(examine_model(PlaneText{}.text()).faults ==
          std::vector{Fault{FaultKind::PlaneModelElsewhere, {"analysis", "plane_stress"}}});
}

TEST_CASE("A drawing that is written reads back bit for bit, and is written the same again")
{
    const std::string drawn = file_text(source_folder() + "/tests/femoop/plane/everything_drawn.json").text;
    const PlaneReading reading = examine_plane_model(drawn);
    for (const Fault& fault : reading.faults) FAIL_CHECK(message(fault));
    CHECK(reading.model.is_drawn);
    CHECK(reading.model.curves.size() == 9);
    CHECK(read_plane_model(write_plane_model(reading.model)) == reading.model);
    CHECK(write_plane_model(reading.model) == drawn);
}

TEST_CASE("Middle nodes of edges may stand in a curve or be left out")
{
    constexpr std::string_view points =
        R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [3, 0]}, {"id": "C", "at": [0, 2]},
        {"id": "ab", "at": [1.5, 0]}, {"id": "bc", "at": [1.5, 1]}, {"id": "ca", "at": [0, 1]}])";
    constexpr std::string_view elements =
        R"([{"id": "1", "kind": "T6", "points": ["A", "B", "C", "ab", "bc", "ca"], "region": "web"}])";
    constexpr std::string_view region = R"([{"id": "web", "material": "m", "thickness": 0.4}])";
    for (const std::string_view curve : {R"([{"id": "c", "kind": "edges", "points": ["A", "ab", "B", "C"]}])",
                                         R"([{"id": "c", "kind": "edges", "points": ["A", "B", "bc", "C"]}])"}) {
        CAPTURE(curve);
        CHECK(examine_plane_model(
                  PlaneText{.points = points, .curves = curve, .regions = region, .elements = elements}.text())
                  .faults.empty());
    }
    const PlaneText wrong{.points = points,
                          .curves = R"([{"id": "c", "kind": "edges", "points": ["A", "bc", "B"]}])",
                          .regions = region,
                          .elements = elements};
    CHECK(examine_plane_model(wrong.text()).faults ==
          std::vector{Fault{FaultKind::CurveWithoutEdge, {"curves[0] \"c\"", "A", "bc"}}});
}
