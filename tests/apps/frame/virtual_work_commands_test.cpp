// The displacement that is looked at as virtual work: how it is asked for, and how it follows what changes.
#include "apps/frame/session/virtual_work_commands.h"

#include <doctest/doctest.h>

#include <string>

#include "apps/frame/document/command.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "tests/apps/frame/example_workspace.h"

using namespace frame;
using frame_test::run;
using frame_test::workspace_with;

namespace {

const femoop::virtual_work::VirtualWork& worked(const Session& session)
{
    const drawing::WorkPicture* const picture = shown_work(session);
    REQUIRE(picture != nullptr);
    return picture->work;
}

femoop::MemberId member(const Session& session, const std::string& name) { return *session.model().find_member(name); }

} // namespace

TEST_SUITE("frame session")
{
    TEST_CASE(
        "The middle of a member that is selected is asked for at once, and its work is the analysis' displacement")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        CHECK(run(workspace, "view.virtual_work.next") ==
              "no virtual work is shown; press Shift+P and click a node or a member");
        session.selection = Part(member(session, "BC"));
        CHECK_FALSE(run(workspace, "draw.virtual_work"));
        CHECK(worked(session).displacement.component == femoop::MemberComponent::v);
        CHECK(worked(session).sum == doctest::Approx(worked(session).value));
        CHECK(worked(session).unit_model.load_cases.size() == 1);
        CHECK_FALSE(run(workspace, "view.virtual_work.next"));
        CHECK(worked(session).displacement.component == femoop::MemberComponent::u); // round from the last one
        CHECK_FALSE(run(workspace, "view.virtual_work.close"));
        CHECK(shown_work(session) == nullptr);
    }

    TEST_CASE("What is found by virtual work follows the document and the case, and is told in words")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.virtual_work.ask(session.model(), *session.model().find_node("C"));
        session.virtual_work.choose(session.virtual_work.choices(session.model()).front());
        const double sway = worked(session).sum;
        session.view.load_case = *session.model().find_case("W");
        CHECK(worked(session).sum != doctest::Approx(sway));
        CHECK(worked(session).sum == doctest::Approx(worked(session).value));
        CHECK(description(session).find("ux(C) = ") != std::string::npos);
        session.change({"", [](Document& document) { document.model.nodes[2].at[0] = femoop::Quantity(9.3); }});
        CHECK(worked(session).sum == doctest::Approx(worked(session).value));
        session.hidden = ShowSet{};
        CHECK(shown_work(session) == nullptr);
    }

    TEST_CASE("Of virtual work and a truss by hand the one that is begun last is seen")
    {
        Workspace workspace = workspace_with("truss.json");
        Session& session = workspace.session;
        CHECK_FALSE(run(workspace, "view.joints"));
        CHECK_FALSE(run(workspace, "draw.virtual_work"));
        session.virtual_work.ask(session.model(), *session.model().find_node("B"));
        CHECK(shown_work(session) != nullptr);
        CHECK_FALSE(session.truss.is_on());
        CHECK_FALSE(run(workspace, "view.joints"));
        CHECK(shown_work(session) == nullptr);
        CHECK(session.truss.is_on());
        CHECK(workspace.tool_controller.kind() == ToolKind::Select);
    }

    TEST_CASE("Giving up ends the counting, which keeps loads and results from sight")
    {
        Workspace workspace = workspace_with("portal.json");
        CHECK_FALSE(run(workspace, "view.show.counting"));
        CHECK(workspace.session.view.show.contains(Show::Counting));
        CHECK_FALSE(run(workspace, "edit.deselect"));
        CHECK_FALSE(workspace.session.view.show.contains(Show::Counting));
    }

    TEST_CASE("By symmetry the middle of a beam does not move along it, and no rounding is told of it")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.virtual_work.ask(session.model(), drawing::Cut{member(session, "BC"), 4.0});
        session.virtual_work.choose(session.virtual_work.choices(session.model()).front());
        const std::string sentence = work_sentences(*shown_work(session), session.model(), session.units(), {}).front();
        CHECK(sentence == "1 · u(BC, 4 m) = the sum of the work = 0 mm; the analysis has 0 mm");
        for (const tabular::Row& row : work_table(worked(session), session.model(), ui::Catalogue(), 100).rows)
            for (const tabular::Cell& cell : row.cells) CHECK(cell.shown.find("e-1") == std::string::npos);
    }

    TEST_CASE("A couple on a node that nothing keeps from turning has no virtual work, and it is said why")
    {
        Workspace workspace = workspace_with("gerber_beam.json");
        Session& session = workspace.session;
        session.virtual_work.ask(session.model(), *session.model().find_node("E"));
        session.virtual_work.choose(session.virtual_work.choices(session.model()).back());
        CHECK(shown_work(session) == nullptr);
        CHECK_FALSE(session.virtual_work.why_none().empty());
        CHECK(description(session).find("No virtual work: ") != std::string::npos);
    }

    TEST_CASE("The table of a sheet has the exact product and its integral in every row, and all of the sum")
    {
        Workspace workspace = workspace_with("portal.json");
        Session& session = workspace.session;
        session.virtual_work.ask(session.model(), drawing::Cut{member(session, "BC"), 4.0});
        const auto whole = work_table(worked(session), session.model(), ui::Catalogue(), 100);
        const std::size_t n_parts = worked(session).work.integrals.size();
        CHECK(whole.rows.size() == n_parts + 1);
        for (std::size_t i = 0; i < n_parts; ++i) {
            const auto& one = worked(session).work.integrals[i];
            const double L = one.to - one.from;
            const auto product = femoop::virtual_work::product(one);
            REQUIRE(product);
            double integral = 0.0, power = L;
            for (std::size_t k = 0; k < product->n_terms(); ++k, power *= L)
                integral += (*product)[k] * power / static_cast<double>(k + 1);
            CHECK(one.value == doctest::Approx(one.flexibility * integral));
            CHECK(integral_of_product(one) == doctest::Approx(integral));
        }
        const auto few = work_table(worked(session), session.model(), ui::Catalogue(), 3);
        CHECK(few.rows.size() == 4); // two that work most, the rest of them, and the sum
        CHECK(few.rows[2].cells.front().shown == std::to_string(n_parts - 2) + " more that work less");
        CHECK(few.rows.back().cells == whole.rows.back().cells);
    }
}
