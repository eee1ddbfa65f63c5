#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "ui/files/linked_copy.h"

namespace fs = std::filesystem;

namespace {

/// A program whose document is a text.
struct LinkedProgram {
    LinkedProgram(ui::Link link, const std::string& text) : document(text), copy(std::move(link), text) {}

    void tick()
    {
        copy.tick(0.6, {[this] { return document; }, [this](const std::string& other) { return other != document; }});
    }
    std::string offered() const { return copy.offered().value_or("nothing"); }

    std::string document;
    ui::LinkedCopy copy;
};

struct Pair {
    LinkedProgram giver{*ui::Link::made(), "10 kN"};
    LinkedProgram taker{ui::Link(giver.copy.folder()), "10 kN"};

    void tick()
    {
        giver.tick();
        taker.tick();
        giver.tick();
        taker.tick();
    }
};

} // namespace

TEST_SUITE("ui files")
{
    TEST_CASE("As long as nothing changes nothing is offered")
    {
        Pair pair;
        pair.tick();
        CHECK(pair.giver.offered() == "nothing");
        CHECK(pair.taker.offered() == "nothing");
    }

    TEST_CASE("A change of either end is offered to the other, and is not there before it is taken over")
    {
        Pair pair;
        pair.giver.document = "12 kN";
        pair.tick();
        CHECK(pair.taker.offered() == "12 kN");
        CHECK(pair.taker.document == "10 kN");
        pair.taker.document = pair.taker.copy.accept();
        pair.tick();
        CHECK(pair.giver.offered() == "nothing"); // no echo
        pair.taker.document = "7 kN";
        pair.tick();
        CHECK(pair.giver.offered() == "7 kN");
    }

    TEST_CASE("What was kept is offered again only as another change, the newest alone")
    {
        Pair pair;
        pair.giver.document = "12 kN";
        pair.tick();
        pair.taker.copy.keep();
        pair.tick();
        CHECK(pair.taker.offered() == "nothing");
        pair.giver.document = "13 kN";
        pair.tick();
        pair.giver.document = "14 kN";
        pair.tick();
        CHECK(pair.taker.offered() == "14 kN");
    }

    TEST_CASE("What is taken back at the other end is no longer offered")
    {
        Pair pair;
        pair.giver.document = "12 kN";
        pair.tick();
        pair.giver.document = "10 kN";
        pair.tick();
        CHECK(pair.taker.offered() == "nothing");
    }

    TEST_CASE("Where both ends have changed the offer would undo the own change, and only there")
    {
        Pair pair;
        pair.giver.document = "12 kN";
        pair.tick();
        CHECK_FALSE(pair.taker.copy.would_undo_own_change());
        pair.taker.document = "10 kN at 3 m";
        pair.tick();
        CHECK(pair.taker.copy.would_undo_own_change());
        CHECK(pair.giver.copy.would_undo_own_change());
        pair.taker.document = pair.taker.copy.accept();
        pair.tick();
        CHECK_FALSE(pair.giver.copy.offered());
        pair.giver.document = "13 kN";
        pair.tick();
        REQUIRE(pair.taker.offered() == "13 kN");
        CHECK_FALSE(pair.taker.copy.would_undo_own_change());
    }

    TEST_CASE("What has the own change and more undoes nothing")
    {
        Pair pair;
        pair.taker.document = "10 kN\nat 3 m";
        pair.tick();
        pair.giver.document = "12 kN\nat 3 m"; // taken over by another way, with a change of its own
        pair.tick();
        REQUIRE(pair.taker.copy.offered());
        CHECK_FALSE(pair.taker.copy.would_undo_own_change());
    }

    TEST_CASE("A program that has ended offers nothing any more")
    {
        Pair pair;
        pair.taker.document = "7 kN";
        pair.tick();
        REQUIRE(pair.giver.offered() == "7 kN");
        {
            const ui::LinkedCopy ended = std::move(pair.taker.copy);
        }
        pair.giver.tick();
        CHECK(pair.giver.offered() == "nothing");

        Pair other;
        other.giver.document = "12 kN";
        other.tick();
        REQUIRE(other.taker.offered() == "12 kN");
        {
            const ui::LinkedCopy ended = std::move(other.giver.copy);
        }
        other.taker.tick();
        CHECK(other.taker.offered() == "nothing");
    }

    TEST_CASE("Texts of one length that follow one another at once are both heard")
    {
        ui::Link giver = *ui::Link::made();
        ui::Link taker(giver.folder());
        for (int i = 1000; i < 1200; ++i) {
            CHECK_FALSE(giver.notify(std::to_string(i)));
            CHECK(taker.heard() == std::to_string(i));
            CHECK_FALSE(taker.heard());
        }
    }

    TEST_CASE("The folder of a link is its user's alone and goes with the giver; the taker says then that it is cut")
    {
        auto giver = ui::Link::made();
        ui::Link taker(giver->folder());
        CHECK((fs::status(giver->folder()).permissions() & (fs::perms::group_all | fs::perms::others_all)) ==
              fs::perms::none);
        CHECK_FALSE(taker.notify("7 kN"));
        CHECK(giver->heard() == "7 kN");
        const fs::path folder = giver->folder();
        giver.reset();
        CHECK_FALSE(fs::exists(folder));
        CHECK(taker.is_cut());
        CHECK(taker.notify("8 kN"));
        CHECK_FALSE(taker.heard());
    }

    TEST_CASE("A taker that ends leaves the giver's folder, and neither follows a link that another user has laid")
    {
        auto giver = ui::Link::made();
        {
            const ui::Link taker(giver->folder());
        }
        CHECK(fs::exists(giver->folder()));
        fs::create_symlink("/dev/zero", giver->folder() / "taker");
        CHECK_FALSE(giver->heard());
    }

    TEST_CASE("A folder whose program was killed is taken away by the next link, one in use is not")
    {
        const auto old_folder = [](const fs::path& folder) {
            fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::hours(1));
            return folder;
        };
        const fs::path left = fs::temp_directory_path() / "cremona-link-killed";
        fs::create_directory(left);
        std::ofstream(left / "giver") << "10 kN";
        old_folder(left);
        const ui::Link in_use = *ui::Link::made();
        CHECK(!fs::exists(left));
        const fs::path used = old_folder(in_use.folder());
        const ui::Link another = *ui::Link::made();
        CHECK(fs::exists(used));
    }
}
