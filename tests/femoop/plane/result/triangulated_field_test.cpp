// Fields of results as triangles, and the errors of elements.
#include <doctest/doctest.h>

#include <cmath>

#include "femoop/plane/result/iso_areas.h"
#include "femoop/plane/result/triangulated_field.h"
#include "tests/femoop/plane/result/plane_case.h"

using namespace femoop::plane;

TEST_CASE("Triangles of every kind of element cover the body, and a smoothed field goes on across their borders")
{
    for (const char* const name :
         {"CO-001-a", "CO-001-b", "CO-001-c", "CO-001-d", "CO-001-e", "CO-001-f", "CO-001-g"}) {
        CAPTURE(name);
        const PlaneResults results = plane_test::solved(name);
        const PlaneCase result = results[femoop::CaseId{}];
        const auto field = component_field(result, PlaneComponent::sx, StressReading::Smoothed);
        CHECK(field.area() == doctest::Approx(0.24 * 0.12));
        for (const std::uint32_t h : field.ends) CHECK(field.twins[h] == TriangulatedField::none);
        for (const auto& values : field.values)
            for (const double value : values) CHECK(value == doctest::Approx(4000.0 / 3.0));
    }
}

TEST_CASE("Bending stress has straight, evenly spaced lines over the height of a beam")
{
    const PlaneResults results = plane_test::solved("PB-001-Q8"); // sx = 150 at the fibres y = -1, 1
    const auto field = component_field(results[femoop::CaseId{}], PlaneComponent::sx, StressReading::Smoothed);
    for (const double level : {-120.0, -45.0, 30.0, 135.0}) {
        const auto lines = iso_lines(field, level);
        REQUIRE(lines.size() == 1);
        for (const auto& at : lines[0]) CHECK(std::abs(at.y()) == doctest::Approx(std::abs(level) / 150.0));
    }
}

TEST_CASE("Element values of triangles are constant and jump; bands of them are whole elements")
{
    const PlaneResults results = plane_test::solved("CO-001-a");
    const auto field = component_field(results[femoop::CaseId{}], PlaneComponent::ux, StressReading::Smoothed);
    const auto range = field_extremes(results[femoop::CaseId{}], PlaneComponent::ux, StressReading::Smoothed);
    CHECK(range.min.value == doctest::Approx(0.0)); // ux = 1e-3 (x + y / 2)
    CHECK(range.max.value == doctest::Approx(1e-3 * (0.24 + 0.06)));
    CHECK(range.max.at.x() == doctest::Approx(0.24));
    CHECK(loops_above(field, 1e-4).size() == 1);
}

TEST_CASE("The errors of elements sum to the estimate, and a body without error has none")
{
    const PlaneResults exact = plane_test::solved("PB-001-Q8");
    CHECK(exact[femoop::CaseId{}].error_estimate() < 1e-8);
    const PlaneResults rough = analyse(read_plane_model(plane_test::cantilever_text(4, 1)));
    double sum = 0.0;
    const PlaneCase of_case = rough[femoop::CaseId{}];
    for (const double error : of_case.element_errors()) sum += error * error;
    CHECK(std::sqrt(sum) == doctest::Approx(rough[femoop::CaseId{}].error_estimate()));
    CHECK(sum > 1e-6);
}
