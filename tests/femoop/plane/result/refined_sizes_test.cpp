// The sizes that elements should have by their errors.
#include <doctest/doctest.h>

#include <cmath>

#include "femoop/plane/result/refined_sizes.h"
#include "tests/femoop/plane/result/plane_case.h"

using namespace femoop::plane;

TEST_CASE("An element with its share of the error that is aimed at keeps its size, one with four times as much has a "
          "half of it")
{
    const PlaneModel mesh = read_plane_model(plane_test::cantilever_text(7, 2));
    const auto n = static_cast<double>(mesh.elements.size());
    constexpr double eta = 0.03;
    std::vector<double> errors(mesh.elements.size(), eta / std::sqrt(n));
    errors[3] *= 4.0; // Q8: the error goes with h^2
    errors[5] *= 1000.0;
    errors[6] = 0.0;
    const std::vector<RefinedSize> sizes = refined_sizes(mesh, errors, eta);
    // a quadrilateral of 10/7 by 1 is two equilateral triangles of 5/7
    const double size = std::sqrt(4.0 / std::sqrt(3.0) * 5.0 / 7.0);
    CHECK(sizes[0].size == doctest::Approx(size).epsilon(1e-5)); // the places have 6 decimals
    CHECK(sizes[0].at.x() == doctest::Approx(5.0 / 7.0).epsilon(1e-5));
    CHECK(sizes[0].wanted == doctest::Approx(sizes[0].size));
    CHECK(sizes[3].wanted == doctest::Approx(sizes[3].size / 2.0));
    CHECK(sizes[5].wanted == doctest::Approx(sizes[5].size / 4.0));
    CHECK(sizes[6].wanted == doctest::Approx(sizes[6].size * 1.5));
    CHECK(growth_of_mesh(sizes) == doctest::Approx((n - 3.0 + 4.0 + 16.0 + 1.0 / 2.25) / n));
}
