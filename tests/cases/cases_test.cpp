#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "femoop/analysis/linear_static.h"
#include "femoop/io/any_model.h"
#include "femoop/io/model_file.h"
#include "femoop/io/plane/plane_verify.h"
#include "femoop/io/verify.h"
#include "femoop/plane/analysis/plane_analysis.h"
#include "tests/source_folder.h"

using namespace femoop;

namespace {

std::vector<std::filesystem::path> cases_in(const std::string& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/tests/cases/" + folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Compares every expected value of a model with what one solver gives.
CheckCounts verify_with(SolverKind solver, const Model& model)
{
    CAPTURE(name(solver));
    const auto results = needs_linear_analysis(model) ? std::optional(analyse(model, {.solver = solver}))
                                                      : std::nullopt;
    const auto outcomes = verify(model, results);
    for (const CheckOutcome& outcome : outcomes) {
        CAPTURE(outcome.what);
        CAPTURE(outcome.expected);
        CAPTURE(outcome.result.value_or(0.0));
        CHECK(outcome.verdict != Verdict::Failed);
    }
    return count(outcomes);
}

/// Of a folder's files, with every solver.
CheckCounts verify_folder(const std::string& folder)
{
    CheckCounts counts;
    for (const auto& file : cases_in(folder)) {
        CAPTURE(file.filename().string());
        const Model model = read_model_file(file);
        for (const SolverKind solver : available_solvers())
            if (const CheckCounts of_one = verify_with(solver, model); solver == SolverKind::Automatic)
                counts += of_one;
    }
    return counts;
}

/// Every check of a folder counts: a file that is lost, or a check that is no longer made, changes these.
void check_folder(const std::string& folder, int n_passed, int n_skipped)
{
    CAPTURE(folder);
    const CheckCounts counts = verify_folder(folder);
    CHECK(counts.passed == n_passed);
    CHECK(counts.skipped == n_skipped);
}

} // namespace

TEST_CASE("Patch tests are passed to rounding, and a slender beam of few elements is as wrong as it must be")
{
    int n_passed = 0;
    for (const auto& file : cases_in("plane")) {
        CAPTURE(file.filename().string());
        const plane::PlaneReading reading = std::get<plane::PlaneReading>(examine_any_file(file));
        REQUIRE(reading.is_sound());
        for (const SolverKind solver : available_solvers()) {
            CAPTURE(name(solver));
            const auto outcomes = plane::verify(reading.model,
                                                {.results = plane::analyse(reading.model, {.solver = solver})}, {});
            for (const CheckOutcome& outcome : outcomes) {
                CAPTURE(outcome.what);
                CAPTURE(outcome.expected);
                CAPTURE(outcome.result.value_or(0.0));
                CHECK(outcome.verdict == Verdict::Passed);
            }
            if (solver == SolverKind::Automatic) n_passed += count(outcomes).passed;
        }
    }
    CHECK(n_passed == 78);
}

// Skipped are 10 checks of P-delta, 5 of buckling and 12 of modes, which no analysis gives yet.
TEST_CASE("Published beams, frames, trusses and grillages come out as published") { check_folder("members", 90, 27); }

TEST_CASE("Frames and sheets of moment distribution come out as published") { check_folder("cross", 102, 0); }

TEST_CASE("Influence lines and trains come out as published") { check_folder("influence", 174, 0); }

TEST_CASE(
    "What only closed forms tell: rigid and inextensible members, offsets, joints, misfits, shapes, profiles, ...")
{
    check_folder("own", 954, 0);
}
