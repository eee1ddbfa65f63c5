#include "femoop/solver/one_thread.h"

#include <doctest/doctest.h>

#include <optional>

#include "femoop/solver/blas.h"
#include "femoop/solver/loaded_function.h"

using namespace femoop;

namespace {

int allowed_levels()
{
    const auto levels = loaded_function<int()>("omp_get_max_active_levels");
    return levels != nullptr ? levels() : 0;
}

} // namespace

TEST_CASE("OpenMP's loops are serial while a guard lives, and what they were after it")
{
    const int before = allowed_levels();
    {
        const SerialLoops serial;
        CHECK(allowed_levels() == 0);
    }
    CHECK(allowed_levels() == before);
}

TEST_CASE("The BLAS has one thread until the last guard goes, in whatever order they go")
{
    const int before = blas().threads;
    std::optional<SerialBlas> first(std::in_place);
    std::optional<SerialBlas> second(std::in_place);
    CHECK(blas().threads == 1);
    first.reset();
    CHECK(blas().threads == 1);
    second.reset();
    CHECK(blas().threads == before);
}
