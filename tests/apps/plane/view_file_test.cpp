// The view file that keeps the image behind a drawing.
#include "apps/plane/backdrop/view_file.h"

#include "apps/plane/session/commands.h"
#include "femoop/files/whole_file.h"
#include "tests/folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using namespace plane;
namespace fs = std::filesystem;

namespace {

std::string sketch_text() { return files::read_whole_file("examples/bracket_sketch.jpg").text; }

/// A drawing over the sketch, which lies in the same folder.
Session drawn_over(const std::string& image)
{
    Session session;
    REQUIRE(session.insert_backdrop(image));
    REQUIRE_FALSE(session.change({"place", [](Document& document) {
                                      document.backdrop->corner = {-20.25, 7.5};
                                      document.backdrop->across = {150.0, -12.5};
                                      document.backdrop->opacity = 0.35;
                                  }}));
    return session;
}

std::string told(const Session& session) { return session.notice ? session.tr()(session.notice->sentence) : ""; }

} // namespace

TEST_SUITE_BEGIN("plane view file");

TEST_CASE("What lies behind a drawing is there again when its file is opened, wherever the folder has gone")
{
    const Folder folder;
    fs::create_directories(folder.path() / "a/images");
    const std::string image = folder.write("a/images/sketch.jpg", sketch_text()), model = folder.path("a/bracket.json");
    Session session = drawn_over(image);
    CHECK(session.is_dirty());
    REQUIRE(session.save(model));
    CHECK_FALSE(session.is_dirty());
    CHECK(folder.read("a/bracket.view.json").find("\"image\": \"images/sketch.jpg\"") != std::string::npos);
    const Backdrop kept = *session.document().backdrop;

    fs::rename(folder.path() / "a", folder.path() / "b");
    Session later;
    REQUIRE(later.open(folder.path("b/bracket.json")));
    CHECK_FALSE(later.is_dirty());
    REQUIRE(later.document().backdrop);
    const Backdrop& found = *later.document().backdrop;
    CHECK(found.file == folder.path() / "b/images/sketch.jpg");
    CHECK(found.corner == kept.corner);
    CHECK(found.across == kept.across);
    CHECK(found.opacity == kept.opacity);
    CHECK(found.photo->image.pixels == kept.photo->image.pixels);
    CHECK_FALSE(later.notice);
}

TEST_CASE("A drawing without an image has no view file, and one whose image is taken away has none any more")
{
    const Folder folder;
    const std::string image = folder.write("sketch.jpg", sketch_text()), model = folder.path("bracket.json");
    Session session = drawn_over(image);
    REQUIRE(session.save(model));
    CHECK(folder.has("bracket.view.json"));
    REQUIRE_FALSE(session.change({"remove", [](Document& document) { document.backdrop.reset(); }}));
    CHECK(session.is_dirty());
    REQUIRE(session.save(model));
    CHECK_FALSE(folder.has("bracket.view.json"));
}

TEST_CASE("Where the image is gone the drawing is open all the same, the notice names it, and saving loses nothing")
{
    const Folder folder;
    const std::string image = folder.write("sketch.jpg", sketch_text()), model = folder.path("bracket.json");
    REQUIRE(drawn_over(image).save(model));
    const std::string view = folder.read("bracket.view.json");
    fs::rename(image, folder.path("elsewhere.jpg"));
    Session session;
    REQUIRE(session.open(model));
    CHECK_FALSE(session.document().backdrop);
    CHECK(told(session).find("bracket.view.json was not opened") != std::string::npos);
    CHECK(told(session).find("sketch.jpg: No such file or directory") != std::string::npos);
    REQUIRE(session.save(model));
    CHECK(folder.read("bracket.view.json") == view);

    REQUIRE(session.insert_backdrop(folder.path("elsewhere.jpg"))); // another one takes its place
    REQUIRE(session.save(model));
    CHECK(folder.read("bracket.view.json.old") == view);
    CHECK(told(session).find("kept as bracket.view.json.old") != std::string::npos);
    CHECK(folder.read("bracket.view.json").find("elsewhere.jpg") != std::string::npos);
}

TEST_CASE("A draft has the image beside it, and one that is taken away does not come back with it")
{
    const Folder folder;
    const std::string image = folder.write("sketch.jpg", sketch_text()), draft = folder.path("7-0.json");
    Session session = drawn_over(image);
    const std::uint64_t state = session.unsaved().state;
    REQUIRE_FALSE(session.unsaved().copy()(draft));
    Session recovered;
    REQUIRE(recovered.recover(draft, std::nullopt));
    REQUIRE(recovered.document().backdrop);
    CHECK(recovered.document().backdrop->corner == FlatPoint{-20.25, 7.5});
    REQUIRE_FALSE(session.change({"remove", [](Document& document) { document.backdrop.reset(); }}));
    CHECK(session.unsaved().state != state);
    REQUIRE_FALSE(session.unsaved().copy()(draft));
    REQUIRE(recovered.recover(draft, std::nullopt));
    CHECK_FALSE(recovered.document().backdrop);
}

TEST_CASE("A drawing is not saved under the name of a view file")
{
    const Folder folder;
    Session session;
    CHECK_FALSE(session.save(folder.path("bracket.view.json")));
    CHECK(told(session).find("is the name of a view file") != std::string::npos);
    CHECK(folder.n_entries() == 0);
}

TEST_CASE("The example of the reference page is read and written as it stands")
{
    const std::string page = files::read_whole_file("courseware/reference/view-file.md").text;
    const std::size_t begin = page.rfind("```json\n");
    REQUIRE(begin != std::string::npos);
    const std::string text = page.substr(begin + 8, page.find("```", begin + 8) - begin - 8);
    const ViewReading reading = read_view(text, fs::absolute("examples"));
    REQUIRE(reading.backdrop);
    CHECK(view_text(*reading.backdrop, "examples/bracket.json") == text);
}

TEST_CASE("Each fault of a view file is told with its place, what was found, what is wanted and an example")
{
    const Folder folder;
    folder.write("sketch.jpg", sketch_text());
    folder.write("torn.png", "\x89PNG\r\n\x1a\n");
    const auto background = [](const std::string& keys) {
        return R"({"cremona_view": 1, "background": {)" + keys + "}}";
    };
    const std::string image = R"("image": "sketch.jpg")", corner = R"("corner": [0, 0])",
                      across = R"("across": [1, 0])";
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "cremona_view"},
        {"{", "line 1"},
        {"[]", "found"},
        {R"({"cremona_view": 2})", "cremona_view"},
        {R"({"cremona_view": 1, "dimensions": []})", "dimensions"},
        {R"({"cremona_view": 1, "background": 7})", "background"},
        {background(corner + "," + across), "image"},
        {background(image + "," + across), "corner"},
        {background(image + "," + corner), "across"},
        {background(image + R"(,"corner": [0],)" + across), "background.corner: found [0], wanted two numbers"},
        {background(image + R"(,"corner": [0, "x"],)" + across), "background.corner[1]"},
        {background(image + "," + corner + R"(,"across": [0, 0])"), "two numbers that are not both 0"},
        {background(image + "," + corner + "," + across + R"(,"opacity": 0)"), "a number from 0.05 to 1"},
        {background(image + "," + corner + "," + across + R"(,"opacity": 1e9)"), "a number from 0.05 to 1"},
        {background(R"("image": "gone.jpg",)" + corner + "," + across), "No such file or directory"},
        {background(R"("image": "torn.png",)" + corner + "," + across), "the image in it is damaged"},
        {background(R"("image": ".",)" + corner + "," + across), "cannot read"},
    };
    for (const auto& each : cases) {
        const auto& [text, wanted] = each;
        CAPTURE(each.first);
        const ViewReading reading = read_view(text, folder.path());
        CHECK_FALSE(reading.backdrop);
        REQUIRE_FALSE(reading.faults.empty());
        CHECK(femoop::message(reading.faults.front()).find(wanted) != std::string::npos);
    }
    CHECK(read_view(background(image + "," + corner + "," + across), folder.path()).faults.empty());
}

TEST_SUITE_END();
