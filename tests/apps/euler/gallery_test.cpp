#include <doctest/doctest.h>

#include <map>
#include <string>

#include "apps/euler/document/gallery/gallery.h"
#include "apps/euler/document/stepper.h"
#include "tests/text_of.h"
#include "topology/halfedge/check/validate.h"
#include "ui/text/catalogue.h"

using namespace euler;

TEST_SUITE("gallery")
{
    TEST_CASE("The program holds the scripts of the examples, byte for byte")
    {
        for (const GalleryItem& item : gallery()) {
            CAPTURE(item.name);
            CHECK(item.script == text_of_source("examples/" + std::string(item.name) + ".eul"));
        }
    }

    TEST_CASE("Every lesson ends with the counts that its title promises")
    {
        using topology::EulerCounts;
        const std::map<std::string_view, EulerCounts> known{{"cube", {8, 12, 6, 6, 1, 0}},
                                                            {"tetrahedron", {4, 6, 4, 4, 1, 0}},
                                                            {"through_hole", {16, 24, 10, 12, 1, 1}},
                                                            {"torus_by_rotation", {16, 32, 16, 16, 1, 1}},
                                                            {"void", {16, 24, 12, 12, 2, 0}},
                                                            {"hoffmann", {24, 36, 16, 18, 2, 1}},
                                                            {"torus", {1, 2, 1, 1, 1, 1}},
                                                            {"shell_and_hole", {24, 36, 16, 18, 1, 0}}};
        REQUIRE(gallery().size() == known.size());
        for (const GalleryItem& item : gallery()) {
            CAPTURE(item.name);
            const Stepper lesson(item.script);
            CHECK(lesson.report(lesson.n_steps()).after == known.at(item.name));
            CHECK_FALSE(lesson.heading().sentence.empty());
        }
    }

    TEST_CASE("A lesson subtracts with minus signs")
    {
        const auto has_hyphen = [](const ui::Message& said) {
            for (const ui::Language language : ui::all_languages)
                if (ui::Catalogue(language)(said).find(" - ") != std::string::npos) return true;
            return false;
        };
        for (const GalleryItem& item : gallery()) {
            const Stepper lesson(item.script);
            CAPTURE(item.name);
            CHECK_FALSE(has_hyphen(lesson.heading()));
            for (std::size_t step = 1; step <= lesson.n_steps(); ++step) {
                CAPTURE(step);
                CHECK_FALSE(has_hyphen(lesson.report(step).meaning));
                CHECK_FALSE(has_hyphen(lesson.report(step).explanation));
            }
        }
    }

    TEST_CASE("A cube takes one MVFS, seven MEV and five MEF")
    {
        const Stepper lesson(gallery().front().script);
        std::map<std::string, int> n;
        for (std::size_t step = 1; step <= lesson.n_steps(); ++step) ++n[lesson.report(step).name];
        CHECK(n == std::map<std::string, int>{{"MVFS", 1}, {"MEV", 7}, {"MEF", 5}});
    }

    TEST_CASE("The lesson of MSG passes through the counts of Hoffmann's figure and comes back")
    {
        const Stepper lesson(gallery().back().script);
        const std::size_t end = lesson.n_steps();
        CHECK(lesson.report(end - 2).after == topology::EulerCounts{24, 36, 16, 18, 2, 1});
        CHECK(deltas(lesson.report(end - 3)) == "MFKRH: 0 0 +1 0 +1 0");
        CHECK(deltas(lesson.report(end - 2)) == "KFMRH: 0 0 -1 0 0 +1");
        CHECK(lesson.report(end - 4).after == lesson.report(end).after);
    }

    TEST_CASE("The counts told of each step are those of the solid, and every step has a meaning in Portuguese")
    {
        const ui::Catalogue tr(ui::Language::Portuguese);
        for (const GalleryItem& item : gallery()) {
            CAPTURE(item.name);
            Stepper lesson(item.script);
            for (std::size_t i = lesson.n_steps(); i > 0; --i) {
                CAPTURE(i);
                const StepReport& step = lesson.report(i);
                const topology::Solid& solid = lesson.runner().solids()[step.solid].solid;
                CHECK(step.after == topology::euler_counts(solid));
                CHECK_FALSE(topology::why_not_valid(solid));
                CHECK(tr.has(step.meaning.sentence));
                CHECK(tr(step.meaning).find('{') == std::string::npos);
                lesson.go_to(i - 1);
                CHECK(step.before == topology::euler_counts(solid));
            }
        }
    }
}
