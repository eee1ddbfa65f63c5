#include <doctest/doctest.h>

#include <vector>

#include "apps/frame/document/document.h"
#include "apps/frame/predict/prediction.h"
#include "apps/frame/tools/predict_tool.h"

using namespace frame;
using Eigen::Vector2d;
using femoop::MemberId;

namespace {

constexpr MemberId column{0}, beam{1}; ///< of the portal A(0,0) B(0,4) C(6,4) D(6,0)
using Path = std::vector<Vector2d>;

const femoop::Model& portal()
{
    static const femoop::Model model = starting_document().model;
    return model;
}

Aim at(double x, double y) { return {.pointer = {x, y}, .on_sheet = {100.0 * x, -100.0 * y}, .pixel = 0.01}; }

/// A portal, a pencil and what it has drawn.
struct Workspace {
    Document document = starting_document();
    Selection selection{};
    Prediction prediction{};
    ToolSettings settings{};
    PredictTool tool{settings};

    Work work() { return {document, selection, &prediction}; }
    void draw(const Path& path)
    {
        tool.press(work(), at(path.front().x(), path.front().y()));
        for (const Vector2d& place : path) tool.move(work(), at(place.x(), place.y()));
        tool.release(work(), at(path.back().x(), path.back().y()));
    }
};

} // namespace

TEST_SUITE("frame model")
{
    TEST_CASE("A stroke belongs to the member that it keeps nearest to, though it begins at the corner of two")
    {
        const std::array both{beam, column};
        CHECK(member_beside(portal(), both, Path{{0.0, 5.0}, {1.0, 4.2}, {3.0, 3.0}, {6.0, 5.0}}) == beam);
        CHECK(member_beside(portal(), both, Path{{-1.0, 4.0}, {-0.5, 2.0}, {0.3, 0.0}}) == column);
        CHECK(!member_beside(portal(), both, Path{{40.0, 40.0}, {41.0, 40.0}}));
        CHECK(!member_beside(portal(), both, Path{}));
        CHECK(!member_beside(portal(), std::array{column}, Path{{2.0, 4.0}, {5.0, 4.0}}));
        CHECK(!member_beside({}, {}, Path{{0.0, 0.0}, {1.0, 0.0}}));
    }

    TEST_CASE("An ordinate on the stretched side is positive, and both are lengths of the member")
    {
        const Path below{{1.5, 3.4}};
        const auto along = [](MemberId member, MomentSide side, const Path& path) {
            const femoop::MemberGeometry line = femoop::geometry_of(portal(), portal()[member]);
            return stroke_along(line, moment_side(line, side), path);
        };
        const auto stretched = along(beam, MomentSide::Tension, below);
        CHECK(stretched.at(0).x == doctest::Approx(0.25));
        CHECK(stretched.at(0).value == doctest::Approx(0.1)); // 0.6 below, of 6
        CHECK(along(beam, MomentSide::Compression, below).at(0).value == doctest::Approx(-0.1));
        // The column goes up, so that its y' points to the left.
        CHECK(along(column, MomentSide::Tension, Path{{1.0, 1.0}}).at(0).value == doctest::Approx(0.25));
    }

    TEST_CASE("An ordinate that is drawn down from a rafter belongs to the place above it")
    {
        const femoop::MemberGeometry rafter = femoop::member_geometry(femoop::AnalysisKind::Frame2d, {1.0, 1.0, 0.0},
                                                                      {5.0, 4.0, 0.0}, Eigen::Vector3d::Zero());
        const auto stroke = stroke_along(rafter, {0.0, -1.0, 0.0}, Path{{2.0, 1.25}, {3.0, 3.0}});
        CHECK(stroke.at(0).x == doctest::Approx(0.25));
        CHECK(stroke.at(0).value == doctest::Approx(0.1)); // 0.5 below (2, 1.75), of 5
        CHECK(stroke.at(1).x == doctest::Approx(0.5));
        CHECK(stroke.at(1).value == doctest::Approx(-0.1));
    }

    TEST_CASE("In space an ordinate counts along the image of its side, however the model is turned")
    {
        const femoop::MemberGeometry girder = femoop::member_geometry(femoop::AnalysisKind::Grillage, {1.0, 2.0, 0.0},
                                                                      {4.0, 6.0, 0.0}, Eigen::Vector3d::Zero());
        const Eigen::Vector3d down(0.0, 0.0, -1.0);
        ui::OrbitCamera camera;
        for (const double elevation : {0.3, 1.0}) {
            CAPTURE(elevation);
            camera.look(0.6, elevation);
            const drawing::Projection seen{drawing::Camera(camera)};
            const PencilView view(seen);
            const Path path{view.place(girder.start + 0.3 * (girder.end - girder.start) + 0.7 * down)};
            const auto stroke = stroke_along(girder, down, path, view);
            REQUIRE(stroke.size() == 1);
            CHECK(stroke[0].x == doctest::Approx(0.3));
            CHECK(stroke[0].value == doctest::Approx(0.14)); // 0.7 of 5
        }
    }

    TEST_CASE("Seen from straight above a grillage's ordinates have no length, and no stroke has a meaning")
    {
        const femoop::MemberGeometry girder = femoop::member_geometry(femoop::AnalysisKind::Grillage, {1.0, 2.0, 0.0},
                                                                      {4.0, 6.0, 0.0}, Eigen::Vector3d::Zero());
        ui::OrbitCamera camera;
        camera.look(ui::StandardView::Top);
        const PencilView view{drawing::Projection(drawing::Camera(camera))};
        CHECK(stroke_along(girder, {0.0, 0.0, -1.0}, Path{{10.0, 10.0}}, view).empty());
    }

    TEST_CASE("The tool draws on the prediction and changes nothing of the document")
    {
        Workspace workspace;
        const Document before = workspace.document;
        workspace.draw({{0.0, 5.0}, {3.0, 3.0}, {6.0, 5.0}});
        REQUIRE(workspace.prediction.on(beam) != nullptr);
        CHECK(workspace.prediction.on(beam)->largest() == doctest::Approx(1.0 / 6.0));
        CHECK((*workspace.prediction.on(beam))[120] == doctest::Approx(1.0 / 6.0));
        CHECK((*workspace.prediction.on(beam))[0] == doctest::Approx(-1.0 / 6.0));
        CHECK(workspace.prediction.on(column) == nullptr);
        CHECK(workspace.document == before);
    }

    TEST_CASE("Esc gives up the stroke that is being drawn, and a click alone draws nothing")
    {
        Workspace workspace;
        workspace.tool.press(workspace.work(), at(0.0, 5.0));
        workspace.tool.move(workspace.work(), at(3.0, 5.0));
        CHECK(!workspace.tool.preview().stroke.empty());
        CHECK(workspace.tool.escape());
        CHECK(!workspace.tool.escape());
        workspace.tool.release(workspace.work(), at(3.0, 5.0));
        workspace.draw({{3.0, 3.0}});
        CHECK(workspace.prediction.is_empty());
    }

    TEST_CASE("While the results are seen nothing can be drawn")
    {
        Workspace workspace;
        const Work seen{workspace.document, workspace.selection};
        workspace.tool.press(seen, at(0.0, 5.0));
        workspace.tool.move(seen, at(6.0, 5.0));
        workspace.tool.release(seen, at(6.0, 5.0));
        CHECK(workspace.prediction.is_empty());
        CHECK(!workspace.tool.preview().member);
    }
}
