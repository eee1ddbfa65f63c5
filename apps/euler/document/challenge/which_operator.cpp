#include "apps/euler/document/challenge/which_operator.h"

#include <algorithm>
#include <array>
#include <random>

#include "apps/euler/document/gallery/gallery.h"
#include "topology/geometry/vector.h"
#include "topology/text/words.h"
#include "ui/text/catalogue.h"

namespace euler {

namespace {

constexpr std::size_t n_choices = 4;
constexpr std::array<std::string_view, 14> all_names{"MVFS", "KVFS", "MEV",   "KEV",   "MEF", "KEF",  "KEMR",
                                                     "MEKR", "MVR",  "KFMRH", "MFKRH", "KVR", "SEMV", "JEKV"};

/// SEMV is a case of MEV, and JEKV one of KEV: the two never stand side by side.
bool are_too_alike(std::string_view a, std::string_view b)
{
    const auto are = [&](std::string_view x, std::string_view y) { return (a == x && b == y) || (a == y && b == x); };
    return a == b || are("MEV", "SEMV") || are("KEV", "JEKV");
}

std::vector<std::string> shuffled_choices(const std::string& right, std::mt19937& random)
{
    std::vector<std::string> choices{right};
    while (choices.size() < n_choices) {
        const std::string_view name = all_names[random() % all_names.size()];
        const auto clashes = [&](const std::string& other) { return are_too_alike(name, other); };
        if (std::none_of(choices.begin(), choices.end(), clashes)) choices.emplace_back(name);
    }
    std::swap(choices.front(), choices[random() % n_choices]);
    return choices;
}

/// A step of a lesson that is one operator.
std::size_t any_step(const Stepper& lesson, std::mt19937& random)
{
    while (true)
        if (const std::size_t step = 1 + random() % lesson.n_steps(); lesson.n_operators(step) == 1) return step;
}

/// No lesson of the gallery splits an edge, so here one more step does.
std::size_t split_edge(Stepper& lesson, std::mt19937& random)
{
    lesson.go_to(2 + random() % (lesson.n_steps() - 1));
    const topology::NamedSolid& in = lesson.runner().solids().front();
    std::vector<topology::EdgeId> edges;
    for (const topology::EdgeId e : in.solid.edges()) edges.push_back(e);
    const topology::HalfEdgeId h = in.solid.plus(edges[random() % edges.size()]);
    const topology::Point &a = in.solid.point(in.solid.start(h)), &b = in.solid.point(in.solid.end(h));
    const topology::Point middle = a + 0.5 * (b - a);
    std::string line = "semv " + in.name + " " + in.names.vertices.of(in.solid.start(h)) + " %" +
                       std::to_string(h.index + 1) + " " + in.names.vertices.unused("n", in.solid);
    for (const double x : {middle.x, middle.y, middle.z}) line += " " + topology::written(x);
    lesson.apply(line);
    return lesson.place();
}

std::string differences(StepSummary seen, bool is_forward)
{
    seen.name.clear();
    if (!is_forward) std::swap(seen.before, seen.after);
    return deltas(seen).substr(2); // without the ": " after no name
}

} // namespace

WhichOperator which_operator(std::uint32_t seed)
{
    std::mt19937 random(seed);
    const std::vector<GalleryItem> items = gallery();
    WhichOperator asked;
    asked.lesson = Stepper(items[random() % items.size()].script);
    constexpr std::uint32_t one_in = 8;
    const bool splits = seed % one_in == one_in - 1;
    const std::size_t step = splits ? split_edge(asked.lesson, random) : any_step(asked.lesson, random);
    const bool is_forward = random() % 2 == 0;
    asked.before = is_forward ? step - 1 : step;
    asked.after = is_forward ? step : step - 1;
    const topology::OperatorKind kind = asked.lesson.report(step).changes.front().kind;
    const std::string right(name(is_forward ? kind : inverse(kind)));
    asked.choices = shuffled_choices(right, random);
    asked.answer = static_cast<std::size_t>(std::find(asked.choices.begin(), asked.choices.end(), right) -
                                            asked.choices.begin());
    asked.hint = {ui::translatable("V, E, F, L, S and G change by {numbers}"),
                  {{"numbers", differences(asked.lesson.summary(step), is_forward)}}};
    asked.lesson.go_to(asked.before);
    return asked;
}

} // namespace euler
