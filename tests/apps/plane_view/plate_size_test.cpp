// How large files of pictures become.
#include <doctest/doctest.h>

#include "tests/apps/plane_view/plate_subject.h"
#include "tests/femoop/plane/result/plane_case.h"
#include "tests/folder.h"
#include "ui/paint/paint_to_file.h"

TEST_CASE("Bands and mesh of 20 000 elements are an SVG of less than 5 MB")
{
    const PlateSubject plate(plane_test::cantilever_text(200, 100));
    REQUIRE(plate.model().elements.size() == 20000);
    const Folder folder;
    for (const auto reading : {femoop::plane::StressReading::Smoothed, femoop::plane::StressReading::Element}) {
        plane::PlateOptions options;
        options.reading = reading;
        options.show = options.show | plane::plate_shown("bands:mises").value() | plane::plate_shown("mesh").value();
        const std::string path = folder.path("plate.svg");
        ui::paint_to_svg(path, {}, [&](ui::Painter& painter) { plane::draw(painter, plate.input(), options); });
        CHECK(std::filesystem::file_size(path) < 5'000'000);
        CHECK(std::filesystem::file_size(path) > 100'000);
    }
}
