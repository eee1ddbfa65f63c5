// The image behind a drawing, the tool that places it, and the commands about it.
#include "apps/plane/backdrop/backdrop.h"

#include "apps/plane/document/gallery/gallery.h"
#include "apps/plane/session/backdrop_commands.h"
#include "apps/plane/session/commands.h"
#include "apps/plane/session/drawing_commands.h"
#include "apps/plane/tools/align_tool.h"
#include "femoop/io/plane/plane_file.h"
#include "tests/folder.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

using namespace plane;
using doctest::Approx;

namespace {

/// An image of 40 x 30 pixels.
std::shared_ptr<const ui::Photo> photo_4_to_3()
{
    ui::Photo photo;
    photo.image = {.width = 40, .height = 30, .pixels = {}, .version = 1, .kind = ui::PixelKind::Color};
    photo.image.pixels.assign(4 * 40 * 30, 128);
    return std::make_shared<const ui::Photo>(photo);
}

void check_near(const FlatPoint& found, const FlatPoint& wanted)
{
    CHECK(found.x == Approx(wanted.x).epsilon(1e-12).scale(1.0));
    CHECK(found.y == Approx(wanted.y).epsilon(1e-12).scale(1.0));
}

/// Where a place of the image is, as shares of its width and height.
FlatPoint place_in(const Backdrop& backdrop, double x, double y)
{
    return backdrop.corner + (x * backdrop.across + y * backdrop.up());
}

std::string sketch() { return "examples/bracket_sketch.jpg"; }

/// An empty sheet with the sketch behind it, and the tool in the hand that places it.
Workspace with_sketch()
{
    Workspace workspace{Session()};
    REQUIRE(workspace.open_at_once(sketch()));
    return workspace;
}

void type(Workspace& workspace, const std::string& text)
{
    REQUIRE(workspace.hand.type(text));
    const Session& session = workspace.session;
    const auto place = workspace.hand.typed_place(session.model().units, session.units());
    REQUIRE(place);
    type_place(workspace, *place);
    workspace.hand.forget_typed();
}

} // namespace

TEST_SUITE_BEGIN("backdrop");

TEST_CASE("An image fits the drawing in its middle, upright and undistorted, whether it is wider or higher")
{
    const Backdrop wide = backdrop_within(photo_4_to_3(), "a.png", {10.0, 20.0}, {50.0, 120.0});
    check_near(wide.corners()[0], {10.0, 55.0});
    check_near(wide.corners()[2], {50.0, 85.0});
    const Backdrop high = backdrop_within(photo_4_to_3(), "a.png", {0.0, 0.0}, {400.0, 30.0});
    check_near(high.corners()[0], {180.0, 0.0});
    check_near(high.corners()[2], {220.0, 30.0});
}

TEST_CASE("Both places come where they are told, and angles and ratios of lengths stay")
{
    const Backdrop before = backdrop_within(photo_4_to_3(), "a.png", {0.0, 0.0}, {40.0, 30.0});
    const Alignment told{.from = {FlatPoint{3.0, 4.0}, FlatPoint{31.0, 25.0}},
                         .to = {FlatPoint{-7.0, 11.0}, FlatPoint{-20.0, 90.5}}};
    const Backdrop after = aligned(before, told);
    for (std::size_t i = 0; i < 2; ++i)
        check_near(place_in(after, told.from[i].x / 40.0, told.from[i].y / 30.0), told.to[i]);
    const double factor = distance(told.to[0], told.to[1]) / distance(told.from[0], told.from[1]);
    CHECK(length(after.across) == Approx(40.0 * factor));
    CHECK(length(after.up()) == Approx(30.0 * factor));
    CHECK(cross(after.across, after.up()) > 0.0); // never mirrored
}

TEST_CASE("Two places that stay where they are leave the image where it is")
{
    const Backdrop before = backdrop_within(photo_4_to_3(), "a.png", {0.0, 0.0}, {40.0, 30.0});
    const std::array places{FlatPoint{3.0, 4.0}, FlatPoint{31.0, 25.0}};
    CHECK(aligned(before, {.from = places, .to = places}) == before);
}

TEST_CASE("Two places are picked, then the first and the second are told")
{
    AlignTool tool;
    CHECK(tool.picks());
    CHECK_FALSE(tool.add({1.0, 2.0}));
    CHECK_FALSE(tool.add({1.0, 2.0})); // a second click at one place is none
    CHECK(tool.picks());
    CHECK_FALSE(tool.add({4.0, 6.0}));
    CHECK_FALSE(tool.picks());
    CHECK_FALSE(tool.add({0.0, 0.0}));
    CHECK_FALSE(tool.add({0.0, 0.0})); // the two cannot come to one place
    CHECK(tool.add({0.0, 50.0}) == Alignment{.from = {FlatPoint{1.0, 2.0}, FlatPoint{4.0, 6.0}},
                                             .to = {FlatPoint{0.0, 0.0}, FlatPoint{0.0, 50.0}}});
    CHECK_FALSE(tool.has_begun());
}

TEST_CASE("Where only the first place is told, the scale and the turn are kept")
{
    AlignTool tool;
    CHECK_FALSE(tool.finish());
    for (const FlatPoint& place : {FlatPoint{1.0, 2.0}, {4.0, 6.0}}) static_cast<void>(tool.add(place));
    CHECK_FALSE(tool.finish());
    static_cast<void>(tool.add({10.0, 10.0}));
    CHECK(tool.finish() == Alignment{.from = {FlatPoint{1.0, 2.0}, FlatPoint{4.0, 6.0}},
                                     .to = {FlatPoint{10.0, 10.0}, FlatPoint{13.0, 14.0}}});
}

TEST_CASE("Escape takes back one place after the other")
{
    AlignTool tool;
    for (const FlatPoint& place : {FlatPoint{1.0, 2.0}, {4.0, 6.0}, {0.0, 0.0}}) static_cast<void>(tool.add(place));
    CHECK(tool.escape());
    CHECK_FALSE(tool.first_target());
    CHECK_FALSE(tool.picks());
    CHECK(tool.escape());
    CHECK(tool.picks());
    CHECK(tool.escape());
    CHECK_FALSE(tool.has_begun());
    CHECK_FALSE(tool.escape());
}

TEST_CASE("A typed length is the distance of the two places, whatever the pointer does, and the first one stays")
{
    Workspace workspace = with_sketch();
    const Backdrop before = *workspace.session.document().backdrop;
    for (const FlatPoint& place : {FlatPoint{60.0, 40.0}, {90.0, 80.0}}) workspace.align(workspace.hand.align(place));
    workspace.hand.point_at({.pointer = {-500.0, 7.0}, .snap = {{-500.0, 7.0}, SnapKind::Free, {}}, .under = {}});
    type(workspace, "12 cm");
    const Backdrop after = *workspace.session.document().backdrop;
    CHECK(after == aligned(before, {.from = {FlatPoint{60.0, 40.0}, FlatPoint{90.0, 80.0}},
                                    .to = {FlatPoint{60.0, 40.0}, FlatPoint{132.0, 136.0}}}));
    CHECK(workspace.hand.tool() == ToolKind::Select);
    workspace.session.undo();
    CHECK(workspace.session.document().backdrop == before);
}

TEST_CASE("A typed place is the first one's, the next typed place or length the second one's")
{
    for (const auto& each : {std::pair("120, 0", FlatPoint{120.0, 0.0}), std::pair("@0, 120", FlatPoint{0.0, 120.0}),
                             std::pair("40<180", FlatPoint{-40.0, 0.0}), std::pair("100", FlatPoint{60.0, 80.0})}) {
        const auto& [second, at] = each;
        CAPTURE(each.first);
        Workspace workspace = with_sketch();
        const Backdrop before = *workspace.session.document().backdrop;
        for (const FlatPoint& place : {FlatPoint{60.0, 40.0}, {90.0, 80.0}})
            workspace.align(workspace.hand.align(place));
        type(workspace, "0, 0");
        CHECK(workspace.session.document().backdrop == before);
        type(workspace, second);
        const Backdrop wanted = aligned(
            before, {.from = {FlatPoint{60.0, 40.0}, FlatPoint{90.0, 80.0}}, .to = {FlatPoint{0.0, 0.0}, at}});
        const Backdrop& after = *workspace.session.document().backdrop;
        check_near(after.corner, wanted.corner);
        check_near(after.corner + after.across, wanted.corner + wanted.across);
    }
}

TEST_CASE("An image is a step of its own that leaves the drawing, its results and its file alone")
{
    Workspace workspace(Session(gallery_document(0)));
    Session& session = workspace.session;
    session.look.mesh = true;
    session.analyse_what_is_shown();
    const Analysed* const before = session.analysed();
    REQUIRE(before != nullptr);
    const std::string file = femoop::plane::write_plane_model(session.model());
    REQUIRE(workspace.insert_backdrop(sketch()));
    REQUIRE(session.document().backdrop);
    CHECK(session.document().backdrop->file.filename() == "bracket_sketch.jpg");
    CHECK(session.analysed() == before);
    CHECK(femoop::plane::write_plane_model(session.model()) == file);
    CHECK(session.input().backdrop);
    session.look.backdrop = false;
    CHECK_FALSE(session.input().backdrop);
    session.undo();
    CHECK_FALSE(session.document().backdrop);
}

TEST_CASE("What is no image, or is not there, is refused with the reason and changes nothing")
{
    const Folder folder;
    const std::string fake = folder.write("fake.png", "no image"), gone = folder.path("gone.jpg");
    Workspace workspace{Session()};
    for (const auto& each : {std::pair(fake, "it is no PNG and no JPEG image"), std::pair(gone, "")}) {
        const auto& [path, reason] = each;
        CAPTURE(each.first);
        CHECK_FALSE(workspace.open_at_once(path));
        CHECK_FALSE(workspace.session.document().backdrop);
        CHECK_FALSE(workspace.session.history().can_undo());
        REQUIRE(workspace.session.notice);
        CHECK(workspace.session.tr()(workspace.session.notice->sentence).find(reason) != std::string::npos);
        CHECK(workspace.hand.tool() == ToolKind::Select);
    }
}

TEST_CASE("Without an image nothing can be placed, taken away or made paler, and each says why")
{
    Workspace workspace{Session()};
    const CommandTable commands = command_table();
    const ui::Reason reason = run(*commands.find("tool.background"), workspace);
    CHECK(workspace.hand.tool() == ToolKind::Select);
    REQUIRE(reason);
    CHECK(workspace.session.tr()(*reason) == "there is no image behind the drawing; the menu File has one from a file");
    CHECK(why_not(*commands.find("background.remove"), workspace));
}

TEST_CASE("An image is taken away with the tool that places it")
{
    Workspace workspace = with_sketch();
    CHECK(workspace.hand.tool() == ToolKind::Align);
    const CommandTable commands = command_table();
    run(*commands.find("background.remove"), workspace);
    CHECK_FALSE(workspace.session.document().backdrop);
    CHECK(workspace.hand.tool() == ToolKind::Select);
}

TEST_SUITE_END();
