#include "femoop/methods/cross/exercise/seeded.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "femoop/methods/cross/distribution.h"
#include "femoop/methods/dice.h"

namespace femoop::cross {

namespace {

/// A point load whose moments at held ends are short.
struct Eccentric {
    double length, at;
    int step; ///< of the force
};
constexpr std::array eccentric{Eccentric{4, 1, 16}, Eccentric{5, 2, 25},  Eccentric{6, 2, 9},
                               Eccentric{8, 2, 8},  Eccentric{10, 4, 25}, Eccentric{12, 4, 9}};

/// A uniform load whose q L2 / 24 is whole.
struct Uniform {
    double length;
    int step;
};
constexpr std::array uniform{Uniform{4, 3}, Uniform{5, 12}, Uniform{6, 2},
                             Uniform{8, 3}, Uniform{10, 6}, Uniform{12, 1}};

constexpr double least_moment = 15.0, most_moment = 130.0; // kN m, of a span held at both ends
constexpr double least_unbalance = 0.08;                   // of the largest fixed-end moment

class Maker {
public:
    explicit Maker(Dice& dice) : dice_(dice)
    {
        model_.add(Material{.id = "steel", .E = 2e8});
        model_.add(LoadCase{.id = "P"});
    }

    Model make(Difficulty difficulty)
    {
        switch (difficulty) {
        case Difficulty::FixedEnds: fixed_ends(); break;
        case Difficulty::PinnedEnd: pinned_end(); break;
        case Difficulty::Overhang: overhang(); break;
        case Difficulty::SeveralSpans: several_spans(); break;
        case Difficulty::Frame: frame(); break;
        case Difficulty::SwayFrame: sway_frame(); break;
        }
        return std::move(model_);
    }

private:
    using Kind = std::optional<SupportKind>;

    void fixed_ends()
    {
        node(0.0, 0.0, SupportKind::Fixed);
        span(SupportKind::Roller);
        span(SupportKind::Fixed);
        load(MemberId(0), Loads::Central);
        load(MemberId(1), Loads::Central);
    }

    void pinned_end()
    {
        const bool is_left = dice_.roll(0, 1) == 0.0, is_both = dice_.roll(0, 3) == 0.0;
        node(0.0, 0.0, is_left || is_both ? SupportKind::Pin : SupportKind::Fixed);
        span(SupportKind::Roller);
        span(is_left && !is_both ? SupportKind::Fixed : SupportKind::Roller);
        load(MemberId(0), Loads::Any);
        load(MemberId(1), Loads::Any);
    }

    void overhang()
    {
        node(0.0, 0.0, dice_.roll(0, 1) == 0.0 ? SupportKind::Pin : SupportKind::Fixed);
        span(SupportKind::Roller, 1);
        span(SupportKind::Roller, 2);
        load(MemberId(0), Loads::Any);
        load(MemberId(1), Loads::Any);
        const double arm = dice_.roll(1, 2), q = dice_.roll(8, 20, 4);
        beam(model_.nodes.back().at[0].value() + arm, 0.0, Kind{}, 1);
        if (dice_.roll(0, 1) == 0.0) add_uniform(MemberId(2), q);
        else add_force(NodeId(3), Dof::uy, -dice_.roll(10, 30, 5));
    }

    void several_spans()
    {
        const int n = static_cast<int>(dice_.roll(3, 4));
        const bool is_pinned = dice_.roll(0, 1) == 0.0;
        node(0.0, 0.0, is_pinned ? SupportKind::Pin : SupportKind::Fixed);
        for (int i = 1; i <= n; ++i) {
            const bool is_held = i == n && dice_.roll(0, 1) == 0.0;
            span(is_held ? SupportKind::Fixed : SupportKind::Roller, static_cast<int>(dice_.roll(1, 2)));
            load(MemberId(static_cast<std::size_t>(i - 1)), Loads::Any);
        }
        const auto twice = static_cast<std::size_t>(dice_.roll(0, n - 1));
        add_other(MemberId(twice));
    }

    /// A beam on a column, held sideways.
    void frame()
    {
        const double height = dice_.roll(3, 5);
        node(0.0, height, dice_.roll(0, 1) == 0.0 ? SupportKind::Pin : SupportKind::Fixed);
        span(Kind{}, static_cast<int>(dice_.roll(1, 2)));
        span(dice_.roll(0, 1) == 0.0 ? SupportKind::Roller : SupportKind::Fixed, static_cast<int>(dice_.roll(1, 2)));
        load(MemberId(0), Loads::Any);
        load(MemberId(1), Loads::Any);
        node(model_.nodes[1].at[0].value(), 0.0, dice_.roll(0, 2) == 0.0 ? SupportKind::Pin : SupportKind::Fixed);
        member(NodeId(3), NodeId(1), 1);
        if (dice_.roll(0, 1) == 0.0) add_moment(NodeId(1), dice_.sign() * dice_.roll(10, 30, 5));
    }

    void sway_frame()
    {
        const double left = dice_.roll(3, 5), right = dice_.roll(0, 1) == 0.0 ? left : left + dice_.roll(1, 2);
        const double width = random_length();
        const bool is_pinned = dice_.roll(0, 2) == 0.0;
        node(0.0, 0.0, SupportKind::Fixed);
        node(0.0, left, {});
        node(width, left, {});
        node(width, left - right, is_pinned ? SupportKind::Pin : SupportKind::Fixed);
        member(NodeId(0), NodeId(1), 1);
        member(NodeId(1), NodeId(2), static_cast<int>(dice_.roll(1, 3)));
        member(NodeId(3), NodeId(2), 1);
        load(MemberId(1), Loads::Any);
        if (dice_.roll(0, 1) == 0.0) add_force(NodeId(1), Dof::ux, dice_.roll(10, 40, 5));
    }

    // ---- parts

    double random_length() { return dice_.pick(uniform).length; }

    void node(double x, double y, Kind kind)
    {
        Node one{.id = std::string(1, static_cast<char>('A' + model_.nodes.size()))};
        one.at = {Quantity(x), Quantity(y), Quantity(0.0)};
        if (kind) one.support = Support{.kind = *kind};
        model_.add(std::move(one));
    }

    /// \param times  how many I
    SectionId section(int times)
    {
        const std::string name = (times == 1 ? "" : std::to_string(times)) + "I";
        const auto found = std::ranges::find(model_.sections, name, &Section::id);
        if (found != model_.sections.end()) return SectionId(static_cast<std::size_t>(found - model_.sections.begin()));
        return model_.add(Section{.id = name, .A = 0.01, .Iz = times * 1e-4});
    }

    void member(NodeId a, NodeId b, int multiple)
    {
        const SectionId own = section(multiple);
        model_.add(
            Member{.id = model_[a].id + model_[b].id, .nodes = {a, b}, .material = MaterialId(0), .section = own});
    }

    /// From the last node to a new one.
    void beam(double x, double y, Kind kind, int multiple)
    {
        node(x, y, kind);
        const std::size_t n = model_.nodes.size();
        member(NodeId(n - 2), NodeId(n - 1), multiple);
    }
    void span(Kind kind, int multiple = 1)
    {
        const Node& last = model_.nodes.back();
        beam(last.at[0].value() + random_length(), last.at[1].value(), kind, multiple);
    }

    double length(MemberId id) const
    {
        const auto& nodes = model_[id].nodes;
        return model_[nodes[1]].at[0].value() - model_[nodes[0]].at[0].value();
    }

    // ---- loads

    enum class Loads : std::uint8_t { Central, Any };

    void load(MemberId id, Loads kinds)
    {
        const double L = length(id);
        const int lot = static_cast<int>(dice_.roll(0, kinds == Loads::Any ? 2 : 1));
        if (lot == 0) return add_uniform(id, in_range(step_of_uniform(L), L * L / 12.0));
        if (lot == 1) return add_point(id, 0.5 * L, in_range(8, L / 8.0));
        const auto* const one = std::ranges::find(eccentric, L, &Eccentric::length);
        const double a = dice_.roll(0, 1) == 0.0 ? one->at : L - one->at, b = L - a;
        add_point(id, a, in_range(one->step, a * b * std::max(a, b) / (L * L)));
    }

    /// A load of another kind than the member has already.
    void add_other(MemberId id)
    {
        const bool has_point = std::holds_alternative<PointLoad>(model_.load_cases[0].members[id.index].load);
        const double L = length(id);
        if (has_point) add_uniform(id, in_range(step_of_uniform(L), L * L / 12.0));
        else add_point(id, 0.5 * L, in_range(8, L / 8.0));
    }

    static int step_of_uniform(double L) { return std::ranges::find(uniform, L, &Uniform::length)->step; }

    /// A multiple of the step whose moment is neither small nor large.
    double in_range(int step, double moment_of_one)
    {
        const int least = static_cast<int>(std::ceil(least_moment / (step * moment_of_one)));
        const int most = static_cast<int>(most_moment / (step * moment_of_one));
        return step * dice_.roll(std::max(1, least), std::max({1, least, most}));
    }

    void add_uniform(MemberId id, double q)
    {
        DistributedLoad load;
        load.values.push_back({.dof = Dof::uy, .start = Quantity(-q)});
        model_.load_cases[0].members.push_back({.member = id, .load = load});
    }
    void add_point(MemberId id, double at, double P)
    {
        const PointLoad load{.at = Quantity(at), .components = {{Dof::uy, Quantity(-P)}}};
        model_.load_cases[0].members.push_back({.member = id, .load = load});
    }
    void add_force(NodeId id, Dof dof, double value)
    {
        model_.load_cases[0].nodes.push_back({.node = id, .components = {{dof, Quantity(value)}}});
    }
    void add_moment(NodeId id, double value) { add_force(id, Dof::rz, value); }

    Dice& dice_;
    Model model_;
};

/// A joint is out of balance, and where there are several each has its turn by the time a hand stops.
bool has_work(const Model& model)
{
    const Problem problem = problem_of(model, CaseId(0));
    double largest = 0.0;
    for (const double moment : problem.loading.fixed_end) largest = std::max(largest, std::abs(moment));
    if (largest_unbalance(locked_state(problem, problem.loading)) < least_unbalance * largest) return false;
    const Procedure procedure{.joints = {}, .tolerance = 0.02 * largest, .balances = {}};
    return try_to_distribute(model, problem, problem.loading, procedure).steps.size() >= problem.joints.size();
}

} // namespace

Model seeded_model(Difficulty difficulty, std::uint32_t seed)
{
    Dice dice(seed);
    for (int i = 0; i < 4 + static_cast<int>(difficulty); ++i) dice.roll(0, 9); // near seeds are not alike
    constexpr int enough = 200;
    Model model = Maker(dice).make(difficulty);
    for (int i = 0; i < enough && !has_work(model); ++i) model = Maker(dice).make(difficulty);
    model.title = "Moment distribution, exercise " + std::to_string(static_cast<int>(difficulty)) + "." +
                  std::to_string(seed);
    return model;
}

} // namespace femoop::cross
