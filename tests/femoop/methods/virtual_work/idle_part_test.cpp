// What carries nothing has no row among the works.
#include <doctest/doctest.h>

#include <algorithm>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/virtual_work/virtual_work.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::virtual_work;

namespace {

/// A portal with a post on its corner and a bracket that nothing stands on.
FrameMaker portal_with_idle_parts()
{
    FrameMaker made;
    made.node("A", 0, 0.13, SupportKind::Fixed).node("B", 0.37, 3.1).node("C", 5.3, 2.7);
    made.node("D", 5.1, -0.2, SupportKind::Pin).node("E", 0.71, 5.9).node("F", 7.1, 3.3);
    made.member("A", "B").member("B", "C").member("C", "D").member("B", "E").member("C", "F");
    made.uniform("BC", -12.0).uniform("CF", -7.0).force("B", Dof::ux, 17.0);
    return made;
}

} // namespace

TEST_SUITE("virtual work")
{
    TEST_CASE("A member that either loading leaves idle does no work, not even that of round-off")
    {
        const Model model = portal_with_idle_parts().model;
        const MovingEffect sway{.quantity = ExpectedQuantity::Displacement, .node = NodeId(1), .dof = Dof::ux};
        const Work work = displacement_by_work(model, analyse(model), CaseId(0), sway).work;
        for (const char* const idle : {"BE", "CF"}) {
            CAPTURE(idle);
            const MemberId member = *model.find_member(idle);
            CHECK(std::ranges::none_of(work.integrals, [&](const auto& one) { return one.member == member; }));
        }
        CHECK(work.integrals.size() == 2 * 3); // N and M of the others
    }
}
