// Trains on whole structures: where they are worst, the structure that stands under their axles says the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "femoop/analysis/linear_static.h"
#include "femoop/methods/influence/effect_name.h"
#include "femoop/methods/influence/influence_line.h"
#include "femoop/methods/influence/load_path.h"
#include "femoop/methods/influence/train/standing_train.h"
#include "femoop/methods/influence/train/train_analysis.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"
#include "tests/frame_maker.h"

using namespace femoop;
using namespace femoop::influence;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop train");

namespace {

/// A beam of three spans on a column at C, with 5 kN/m on its middle span.
Model bridge()
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 7, 0, SupportKind::Roller).node("C", 16.5, 0);
    made.node("D", 22.5, 0, SupportKind::Roller).node("E", 16.5, -5, SupportKind::Fixed);
    made.member("A", "B").member("B", "C").member("C", "D").member("E", "C");
    made.uniform("BC", -5);
    return made.model;
}

Train lorry()
{
    return {.id = "lorry",
            .path = std::vector{MemberId(0), MemberId(1), MemberId(2)},
            .axles = {60.0, 110.0, 130.0},
            .spacings = {3.2, 2.1},
            .both_directions = true};
}

MovingEffect moment(std::size_t member, double x)
{
    return {.quantity = ExpectedQuantity::SectionForce,
            .member = MemberId(member),
            .component = MemberComponent::Mz,
            .at = Quantity(x)};
}

MovingEffect shear(std::size_t member, double x)
{
    MovingEffect effect = moment(member, x);
    effect.component = MemberComponent::Vy;
    return effect;
}

const std::vector<MovingEffect> asked{moment(0, 3.1),
                                      shear(0, 0.0),
                                      shear(0, 3.1),
                                      shear(1, 0.0),
                                      shear(2, 4.0),
                                      moment(1, 4.4),
                                      moment(2, 0.0),
                                      moment(3, 2.5),
                                      {.quantity = ExpectedQuantity::Reaction, .node = NodeId(1), .dof = Dof::uy},
                                      {.quantity = ExpectedQuantity::Displacement, .node = NodeId(2), .dof = Dof::rz}};

/// The train as loads that stand where it was placed.
Model under(Model model, const Train& train, const MovingEffect& effect, const Placing& placing, ExtremeKind kind)
{
    const PathLayout path = lay_out(model, members_of(model, train.path));
    const NodeVector load = unit_load(model.analysis, train.load);
    const InfluenceLine line = InfluenceAnalysis(model).line(path, load, effect);
    model.load_cases = {standing_train("T", path, load, moving_train(train, effect), placing, line, kind)};
    return model;
}

double read(const CaseResult& result, const MovingEffect& effect)
{
    if (effect.quantity == ExpectedQuantity::Reaction) return result.reaction(*effect.node)[index(*effect.dof)];
    if (effect.node) return result.displacement(*effect.node)[index(*effect.dof)];
    const femoop::Curve curve = result.curve(*effect.member);
    const double x = std::get<Quantity>(*effect.at).value();
    return curve.value(*effect.component, x, x < curve.length() ? Side::After : Side::Before);
}

double solved(const Model& model, const MovingEffect& effect) { return read(analyse(model)[CaseId(0)], effect); }

} // namespace

TEST_CASE("Where a train is worst the structure under it has that effect")
{
    const Model model = bridge();
    Train train = lorry();
    SUBCASE("axles alone") {}
    SUBCASE("against its members") { train.path = std::vector{MemberId(2), MemberId(1), MemberId(0)}; }
    SUBCASE("with a uniform load where it adds, and single forces")
    {
        train.uniform = 9.0;
        train.impact = 1.3;
        train.concentrated = {{.for_moments = 80.0, .for_others = 115.0}, {.for_moments = 40.0, .for_others = {}}};
    }
    SUBCASE("with a uniform load before and behind it")
    {
        train.uniform = 9.0;
        train.uniform_extent = UniformExtent::Outside;
        train.gap = 2.5;
    }
    for (const TrainEffect& of : TrainAnalysis(model).effects(train, asked)) {
        CAPTURE(of.max.value);
        CAPTURE(of.min.value);
        REQUIRE(of.max.position);
        REQUIRE(of.min.position);
        const auto found = [&](const Placing& worst, ExtremeKind kind) {
            return solved(under(model, train, of.effect, worst, kind), of.effect);
        };
        CHECK(found(of.max, ExtremeKind::Max) == Approx(of.max.value).epsilon(1e-9));
        CHECK(found(of.min, ExtremeKind::Min) == Approx(of.min.value).epsilon(1e-9));
    }
}

TEST_CASE(
    "Under ten thousand random trains at random places the ordinates times the axles sum up to what the bridge does")
{
    constexpr std::size_t n_trains = 10000, n_at_once = 500;
    Model model = bridge();
    const PathLayout path = lay_out(model, {MemberId(0), MemberId(1), MemberId(2)});
    InfluenceAnalysis analysis(model);
    const std::vector<InfluenceLine> lines = analysis.lines(path, unit_load(model.analysis, {}), asked);
    std::mt19937 dice(7);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(dice);
    };
    double worst = 0.0;
    for (std::size_t done = 0; done < n_trains; done += n_at_once) {
        model.load_cases.clear();
        std::vector<std::vector<double>> sums;
        for (std::size_t i = 0; i < n_at_once; ++i) {
            auto& load_case = model.load_cases.emplace_back();
            load_case.id = std::to_string(i);
            std::vector<double>& sum = sums.emplace_back(asked.size(), 0.0);
            const auto n_axles = std::uniform_int_distribution<int>(1, 8)(dice);
            double s = between(-10.0, path.length()); // of the last axle
            for (int axle = 0; axle < n_axles; ++axle, s += between(0.5, 6.0)) {
                const double force = between(5.0, 200.0);
                if (s < 0.0 || s > path.length()) continue;
                const PathPlace place = path.place(s);
                load_case.members.push_back(
                    {place.member, PointLoad{.at = Quantity(place.x), .components = {{Dof::uy, -force}}}});
                for (std::size_t k = 0; k < asked.size(); ++k) sum[k] += force * lines[k].ordinates.value(s);
            }
        }
        const Results results = analyse(model);
        for (std::size_t i = 0; i < n_at_once; ++i)
            for (std::size_t k = 0; k < asked.size(); ++k) {
                const double wanted = read(results[CaseId(i)], asked[k]);
                worst = std::max(worst, std::abs(sums[i][k] - wanted) / (8.0 * 200.0 * lines[k].ordinates.largest()));
            }
    }
    CHECK(worst < 1e-10);
}

TEST_CASE("An envelope is the case that stays and, with its factor, the train where it is worst")
{
    Model model = bridge();
    model.moving_loads.trains.push_back(lorry());
    const MovingEnvelope envelope{.id = "E", .trains = {TrainId(0)}, .with = CaseId(0), .factor = 1.35};
    TrainAnalysis analysis(model);
    const std::vector<TrainEffect> alone = analysis.effects(model.moving_loads.trains[0], asked);
    const std::vector<TrainEffect> together = analysis.effects(envelope, asked);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        CAPTURE(i);
        const double stays = solved(model, asked[i]);
        CHECK(together[i].max.value == Approx(stays + 1.35 * alone[i].max.value).epsilon(1e-12));
        CHECK(together[i].min.value == Approx(stays + 1.35 * alone[i].min.value).epsilon(1e-12));
    }
}

TEST_CASE("Along a member an envelope has at every section what it has there alone, and nothing beyond its extremes")
{
    Model model = bridge();
    model.moving_loads.trains.push_back(lorry());
    model.load_cases[0].members.push_back(
        {MemberId(1), PointLoad{.at = Quantity(3.7), .components = {{Dof::uy, -40.0}}}});
    const MovingEnvelope envelope{.id = "E", .trains = {TrainId(0)}, .with = CaseId(0), .factor = 1.35};
    TrainAnalysis analysis(model);
    for (const MemberComponent component : {MemberComponent::Vy, MemberComponent::Mz}) {
        const MovingEffect extreme{
            .quantity = ExpectedQuantity::Extreme, .member = MemberId(1), .component = component};
        const MemberEnvelope found = analysis.along_member(envelope, extreme, 8);
        CHECK(found.sections.size() >= 10); // eight, and both sides of the force
        double most = 0.0, least = 0.0;
        for (const TrainEffect& section : found.sections) {
            CAPTURE(std::get<Quantity>(*section.effect.at).value());
            const TrainEffect alone = analysis.effects(envelope, std::array{section.effect}).front();
            CHECK(section.max.value == Approx(alone.max.value).epsilon(1e-12));
            CHECK(section.min.value == Approx(alone.min.value).epsilon(1e-12));
            most = std::max(most, section.max.value);
            least = std::min(least, section.min.value);
        }
        CHECK(most == Approx(found.extreme.max.placing.value).epsilon(1e-6)); // the ends lie by a hair inside
        CHECK(least == Approx(found.extreme.min.placing.value).epsilon(1e-6));
    }
}

TEST_CASE("At a free end on a foundation the shear is the axle that stands there")
{
    FrameMaker made;
    made.node("A", 0, 0).node("B", 40, 0).node("C", 80, 0).member("A", "B").member("B", "C");
    made.model.nodes[1].support.emplace().fixed = {Dof::ux};
    for (Member& member : made.model.members) member.foundation = 20000.0;
    made.model.moving_loads.trains.push_back(
        {.id = "one", .path = std::vector{MemberId(0), MemberId(1)}, .axles = {100.0}});
    const MovingEnvelope envelope{.id = "all", .trains = {TrainId(0)}, .factor = 1.0};
    MovingEffect along = shear(0, 0.0);
    along.quantity = ExpectedQuantity::Extreme;
    along.at.reset();
    TrainAnalysis analysis(made.model);
    const MemberEnvelope found = analysis.along_member(envelope, along, 11);
    const WorstSection& worst = found.extreme.min;
    CHECK(worst.placing.value == Approx(-100.0).epsilon(1e-9));
    CHECK(worst.section == 0.0);
    CHECK(worst.placing.position == 0.0);
    CHECK(found.sections.front().min.value == Approx(-100.0).epsilon(1e-5));
    const std::array there{at_section(along, worst.inside, 40.0)};
    CHECK(analysis.effects(envelope, there).front().min.value == Approx(-100.0).epsilon(1e-5));
    CHECK(told_place(made.model, MemberId(0), worst.inside) == 0.0);
}

TEST_CASE("Of sections that are equally bad the position is that of the one that is told with it")
{
    FrameMaker made;
    made.node("A", 0, 0, SupportKind::Pin).node("B", 20, 0, SupportKind::Roller).member("A", "B");
    made.model.moving_loads.trains.push_back({.id = "two",
                                              .path = std::vector{MemberId(0)},
                                              .axles = {100.0, 60.0},
                                              .spacings = {4.0},
                                              .both_directions = true});
    MovingEffect along = moment(0, 0.0);
    along.quantity = ExpectedQuantity::Extreme;
    along.at.reset();
    TrainAnalysis analysis(made.model);
    const Train& train = made.model.moving_loads.trains[0];
    const WorstSection worst = analysis.extreme(train, along).max;
    REQUIRE(worst.sections.size() == 2);
    const std::array there{at_section(along, worst.section, 20.0)};
    const Placing own = analysis.effects(train, there).front().max;
    CHECK(own.value == Approx(worst.placing.value).epsilon(1e-9));
    REQUIRE(own.position);
    CHECK(*own.position == Approx(*worst.placing.position).epsilon(1e-6));
    CHECK(own.reversed == worst.placing.reversed);
}

TEST_CASE("An axle above a support brings exactly 0 to what it cannot bring anything to, also among the candidates")
{
    const Model model = bridge();
    const Train axle{.id = "axle", .path = std::vector{MemberId(0), MemberId(1)}, .axles = {60.0}};
    TrainAnalysis analysis(model);
    for (const MovingEffect& effect : {moment(0, 3.1), shear(0, 3.1), moment(1, 4.4), shear(1, 4.4), moment(2, 1.3)}) {
        const TrainSearch search = analysis.search(axle, effect);
        for (const double support : {0.0, 7.0})
            for (const ExtremeKind kind : {ExtremeKind::Max, ExtremeKind::Min})
                CHECK(search.at({.position = support}, kind).value == 0.0);
        const SearchProof proof = search.proof(ExtremeKind::Max);
        for (const SearchProof::Entry& entry : proof.entries) {
            CAPTURE(entry.candidate.x);
            if (entry.candidate.x == 0.0 || entry.candidate.x == 7.0) CHECK(proof.sum(entry) == 0.0);
        }
    }
}

TEST_CASE("No position of a train goes beyond its envelope")
{
    Model model = bridge();
    model.moving_loads.trains.push_back(lorry());
    const Train& train = model.moving_loads.trains[0];
    const MovingEnvelope envelope{.id = "E", .trains = {TrainId(0)}, .with = {}, .factor = 1.0};
    TrainAnalysis analysis(model);
    const MovingEffect extreme{
        .quantity = ExpectedQuantity::Extreme, .member = MemberId(2), .component = MemberComponent::Mz};
    constexpr int n_positions = 97;
    for (const TrainEffect& section : analysis.along_member(envelope, extreme, 6).sections) {
        const TrainSearch search = analysis.search(train, section.effect);
        const double tolerance = 1e-9 * (section.max.value - section.min.value);
        for (const bool reversed : {false, true}) {
            const Stretch along = search.positions(reversed);
            for (int i = 0; i <= n_positions; ++i) {
                const double position = along.from + (along.to - along.from) * i / n_positions;
                const double value = search.at({.position = position, .reversed = reversed}, ExtremeKind::Max).value;
                CHECK(value <= section.max.value + tolerance);
                CHECK(value >= section.min.value - tolerance);
            }
        }
    }
}

TEST_CASE("No section of a member goes beyond its extreme, whatever stays and whatever goes along with the axles")
{
    std::mt19937 generator(7);
    const auto one_of = [&](const std::vector<double>& all) {
        return all[std::uniform_int_distribution<std::size_t>(0, all.size() - 1)(generator)];
    };
    for (int i = 0; i < 8; ++i) {
        CAPTURE(i);
        Model model = bridge();
        Train train = lorry();
        for (Quantity& axle : train.axles) axle = Quantity(one_of({40.0, 90.0, 160.0, 200.0}));
        train.spacings = {Quantity(one_of({1.2, 2.0, 4.3})), Quantity(one_of({2.7, 4.3}))};
        if (i % 2 == 0) train.uniform = Quantity(one_of({4.0, 15.0}));
        if (i % 4 == 0) train.uniform_extent = UniformExtent::WholeSpans;
        model.moving_loads.trains.push_back(train);
        const MovingEnvelope envelope{
            .id = "E", .trains = {TrainId(0)}, .with = CaseId(0), .factor = one_of({1.0, 1.35, 2.0})};
        TrainAnalysis analysis(model);
        for (std::size_t member = 0; member < 3; ++member) {
            MovingEffect along = moment(member, 0.0);
            along.at.reset();
            const TrainExtreme extreme = analysis.extreme(envelope, along);
            std::vector<MovingEffect> sections;
            const double length = geometry_of(model, model.members[member]).length;
            for (int k = 0; k <= 120; ++k) sections.push_back(at_section(along, length * k / 120.0, length));
            const double rounding = 1e-9 * (extreme.max.placing.value - extreme.min.placing.value);
            for (const TrainEffect& of : analysis.effects(envelope, sections)) {
                CHECK(of.max.value <= extreme.max.placing.value + rounding);
                CHECK(of.min.value >= extreme.min.placing.value - rounding);
            }
        }
    }
}

TEST_CASE("An envelope whose factor takes it beyond the range of numbers is refused by its name")
{
    Model model = bridge();
    model.moving_loads.trains.push_back(lorry());
    const MovingEnvelope envelope{.id = "E", .trains = {TrainId(0)}, .with = CaseId(0), .factor = 1e308};
    MovingEffect along = moment(0, 0.0);
    along.at.reset();
    CHECK_THROWS_AS(TrainAnalysis(model).extreme(envelope, along), ModelError);
    CHECK_THROWS_AS(TrainAnalysis(model).effects(envelope, asked), ModelError);
}

TEST_CASE("A train beyond the range of numbers is refused, not left out")
{
    const Model model = bridge();
    TrainAnalysis analysis(model);
    for (const double axle : std::array{1e308, -1e308, 1e120}) {
        Train train = lorry();
        train.axles[1] = axle;
        CHECK_THROWS_AS(analysis.effects(train, asked), ModelError);
        CHECK_THROWS_AS(analysis.extreme(train, moment(1, 0.0)), ModelError);
    }
}

TEST_SUITE_END();
