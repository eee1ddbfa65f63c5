// The combinations that codes ask for, as they are written on a board.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "femoop/load/design_code.h"

using namespace femoop;

namespace {

struct Typed {
    std::string load_case;
    std::string_view kind;
};

Model model_of(const std::vector<Typed>& cases)
{
    Model model;
    for (const Typed& one : cases) model.load_cases.push_back({.id = one.load_case});
    return model;
}

std::vector<CaseAction> actions_of(DesignCode code, const std::vector<Typed>& cases)
{
    std::vector<CaseAction> actions;
    for (std::size_t i = 0; i < cases.size(); ++i) actions.push_back({CaseId(i), find_action(code, cases[i].kind)});
    return actions;
}

std::set<std::string> written(DesignCode code, LimitState state, const std::vector<Typed>& cases)
{
    const Model model = model_of(cases);
    std::set<std::string> all;
    const std::vector<DesignCombination> made = design_combinations(code, actions_of(code, cases), {{state}});
    for (const DesignCombination& one : made) {
        CHECK(one.state == state);
        all.insert(formula(model, one, english));
    }
    CHECK(all.size() == made.size());
    return all;
}

using Set = std::set<std::string>;

const std::vector<Typed> office{{"G", "permanent"}, {"Q", "offices"}, {"W", "wind"}};

} // namespace

TEST_SUITE("design codes")
{
    TEST_CASE(
        "EN 1990: each variable action leads in its turn, with the others or without, permanent ones large or small")
    {
        CHECK(written(DesignCode::EN1990, LimitState::Ultimate, office) ==
              Set{"1.35 G", "1.35 G + 1.5 Q + 0.9 W", "1.35 G + 1.5 Q", "G + 1.5 Q + 0.9 W", "G + 1.5 Q",
                  "1.35 G + 1.05 Q + 1.5 W", "1.35 G + 1.5 W", "G + 1.05 Q + 1.5 W", "G + 1.5 W"});
        CHECK(written(DesignCode::EN1990, LimitState::Rare, office) ==
              Set{"G + Q + 0.6 W", "G + Q", "G + 0.7 Q + W", "G + W"});
        CHECK(written(DesignCode::EN1990, LimitState::Frequent, office) ==
              Set{"G + 0.5 Q", "G + 0.3 Q + 0.2 W", "G + 0.2 W"});
        CHECK(written(DesignCode::EN1990, LimitState::QuasiPermanent, office) == Set{"G + 0.3 Q"});
    }

    TEST_CASE("Of three variable actions each may be away, not only all beside the leading one")
    {
        const std::vector<Typed> heated{{"G", "permanent"}, {"Q", "offices"}, {"W", "wind"}, {"T", "temperature"}};
        const Set ultimate = written(DesignCode::EN1990, LimitState::Ultimate, heated);
        for (const char* const one :
             {"1.35 G + 1.5 Q + 0.9 W + 0.9 T", "1.35 G + 1.5 Q + 0.9 W", "1.35 G + 1.5 Q + 0.9 T", "1.35 G + 1.5 Q",
              "G + 0.9 W + 1.5 T", "G + 1.05 Q + 1.5 T"})
            CHECK_MESSAGE(ultimate.contains(one), one);
        CHECK(ultimate.size() == 1 + 2 * (3 * 1 + 3 * 2 + 1 * 3)); // alone, in pairs, all three: as many as may lead
        CHECK(written(DesignCode::EN1990, LimitState::Rare, heated).size() == 3 * 1 + 3 * 2 + 1 * 3);
        CHECK(written(DesignCode::NBR8681, LimitState::QuasiPermanent,
                      {{"G", "permanent"}, {"Q", "live"}, {"T", "temperature"}}) ==
              Set{"G + 0.3 Q + 0.3 T", "G + 0.3 Q", "G + 0.3 T"});
    }

    TEST_CASE("EN 1990: the imposed load on a roof acts neither with snow nor with wind")
    {
        const std::vector<Typed> roof{{"G", "permanent"}, {"H", "roof"}, {"S", "snow"}, {"W", "wind"}};
        CHECK(written(DesignCode::EN1990, LimitState::Ultimate, roof) ==
              Set{"1.35 G", "1.35 G + 1.5 H", "1.35 G + 1.5 S + 0.9 W", "1.35 G + 1.5 S", "1.35 G + 0.75 S + 1.5 W",
                  "1.35 G + 1.5 W", "G + 1.5 H", "G + 1.5 S + 0.9 W", "G + 1.5 S", "G + 0.75 S + 1.5 W", "G + 1.5 W"});
    }

    TEST_CASE("A limit state is called what the code calls it: characteristic, rare, allowable stress")
    {
        CHECK(short_name(DesignCode::EN1990, LimitState::Rare) == "SLS characteristic");
        CHECK(short_name(DesignCode::NBR8681, LimitState::Rare) == "SLS rare");
        CHECK(short_name(DesignCode::ASCE7, LimitState::Rare) == "ASD");
        CHECK(short_name(DesignCode::ASCE7, LimitState::Ultimate) == "LRFD");
        CHECK(short_name(DesignCode::NBR8681, LimitState::QuasiPermanent) == "SLS quasi-permanent");
    }

    TEST_CASE("NBR 8681: a building has 1.4 G + 1.4 (Q + 0.6 W), and 1.4 G + 1.4 (W + 0.5 Q)")
    {
        const std::vector<Typed> building{{"G", "permanent"}, {"Q", "live"}, {"W", "wind"}};
        CHECK(written(DesignCode::NBR8681, LimitState::Ultimate, building) ==
              Set{"1.4 G", "1.4 G + 1.4 Q + 0.84 W", "1.4 G + 1.4 Q", "G + 1.4 Q + 0.84 W", "G + 1.4 Q",
                  "1.4 G + 0.7 Q + 1.4 W", "1.4 G + 1.4 W", "G + 0.7 Q + 1.4 W", "G + 1.4 W"});
        CHECK(written(DesignCode::NBR8681, LimitState::Rare, building) ==
              Set{"G + Q + 0.3 W", "G + Q", "G + 0.4 Q + W", "G + W"});
        CHECK(written(DesignCode::NBR8681, LimitState::QuasiPermanent, building) == Set{"G + 0.3 Q"});
    }

    TEST_CASE("ASCE 7: the basic combinations, with the roof's live load or the snow, never both")
    {
        const std::vector<Typed> hall{{"D", "permanent"}, {"L", "live"}, {"Lr", "roof"}, {"S", "snow"}, {"W", "wind"}};
        CHECK(written(DesignCode::ASCE7, LimitState::Ultimate, hall) ==
              Set{"1.4 D", "1.2 D + 1.6 L + 0.5 Lr", "1.2 D + 1.6 L + 0.5 S", "1.2 D + L + 1.6 Lr", "1.2 D + L + 1.6 S",
                  "1.2 D + 1.6 Lr + 0.5 W", "1.2 D + 1.6 S + 0.5 W", "1.2 D + L + 0.5 Lr + W", "1.2 D + L + 0.5 S + W",
                  "0.9 D + W"});
        CHECK(written(DesignCode::ASCE7, LimitState::Rare, {{"D", "permanent"}, {"W", "wind"}}) ==
              Set{"D", "D + 0.6 W", "D + 0.45 W", "0.6 D + 0.6 W"});
    }

    TEST_CASE("Wind from two sides never blows from both, floors act together, and a case without a kind stays out")
    {
        const std::vector<Typed> cases{{"G1", "permanent"}, {"G2", "permanent"}, {"Q1", "offices"}, {"Q2", "offices"},
                                       {"W+", "wind"},      {"W-", "wind"},      {"erection", ""}};
        const Set made = written(DesignCode::EN1990, LimitState::Ultimate, cases);
        CHECK(made.contains("1.35 G1 + 1.35 G2 + 1.5 Q1 + 1.5 Q2 + 0.9 W+"));
        CHECK(made.contains("G1 + G2 + 1.5 W-"));
        for (const std::string& one : made) {
            CAPTURE(one);
            const auto has = [&](const char* name) { return one.find(name) != std::string::npos; };
            CHECK_FALSE((has("W+") && has("W-")));
            CHECK(has("Q1") == has("Q2"));
            CHECK(has("G2"));
            CHECK_FALSE(has("erection"));
        }
    }

    TEST_CASE("A place lies below 1000 m or above: the two kinds of snow never act together, whichever leads")
    {
        const std::vector<Typed> cases{{"G", "permanent"}, {"S", "snow"}, {"H", "snow-high"}, {"W", "wind"}};
        for (const LimitState state : limit_states(DesignCode::EN1990))
            for (const std::string& one : written(DesignCode::EN1990, state, cases)) {
                CAPTURE(one);
                CHECK_FALSE((one.find('S') != std::string::npos && one.find('H') != std::string::npos));
            }
        CHECK(written(DesignCode::EN1990, LimitState::Ultimate, cases) ==
              Set{"1.35 G", "1.35 G + 1.5 S", "1.35 G + 1.5 S + 0.9 W", "1.35 G + 1.5 W", "1.35 G + 0.75 S + 1.5 W",
                  "1.35 G + 1.5 H", "1.35 G + 1.5 H + 0.9 W", "1.35 G + 1.05 H + 1.5 W", "G + 1.5 S",
                  "G + 1.5 S + 0.9 W", "G + 1.5 W", "G + 0.75 S + 1.5 W", "G + 1.5 H", "G + 1.5 H + 0.9 W",
                  "G + 1.05 H + 1.5 W"});
    }

    TEST_CASE("In Portuguese the factors of a combination's name have a comma")
    {
        const Model model = model_of(office);
        const auto portuguese = [](std::string_view text) { return text == "." ? "," : std::string(text); };
        const auto made = design_combinations(DesignCode::EN1990, actions_of(DesignCode::EN1990, office),
                                              {{LimitState::Ultimate}});
        CHECK(combination_name(DesignCode::EN1990, model, made[1], portuguese) == "ULS 1,35 G + 1,5 Q + 0,9 W");
    }

    TEST_CASE("So many alternatives that nobody would look through their combinations are told beforehand")
    {
        std::vector<Typed> cases{{"G", "permanent"}};
        for (const std::string_view kind : {"offices", "wind", "snow", "temperature"})
            for (int i = 0; i < 4; ++i) cases.push_back({std::string(kind) + std::to_string(i), kind});
        const auto are_too_many = [&] {
            return are_too_many_combinations(DesignCode::EN1990, actions_of(DesignCode::EN1990, cases),
                                             limit_states(DesignCode::EN1990));
        };
        CHECK_FALSE(are_too_many());
        CHECK(written(DesignCode::EN1990, LimitState::Ultimate, cases).size() < most_design_combinations);
        for (int i = 4; i < 70; ++i)
            for (const std::string_view kind : {"wind", "snow", "temperature"})
                cases.push_back({std::string(kind) + std::to_string(i), kind});
        CHECK(are_too_many());
    }

    TEST_CASE("Without variable actions each limit state has the permanent ones alone, without any actions nothing")
    {
        CHECK(written(DesignCode::EN1990, LimitState::Ultimate, {{"G", "permanent"}}) == Set{"1.35 G"});
        CHECK(written(DesignCode::NBR8681, LimitState::Frequent, {{"G", "permanent"}}) == Set{"G"});
        for (const DesignCode code : design_codes()) CHECK(written(code, LimitState::Ultimate, {{"G", ""}}).empty());
    }

    TEST_CASE("In every code psi0 >= psi1 >= psi2, all of them between 0 and 1, and a permanent action has no psi")
    {
        for (const DesignCode code : design_codes()) {
            CHECK(design_code(id(code)) == code);
            for (const ActionKind& kind : action_kinds(code)) {
                CAPTURE(kind.label);
                CHECK(find_action(code, kind.id) == &kind);
                CHECK(kind.psi0 >= kind.psi1);
                CHECK(kind.psi1 >= kind.psi2);
                CHECK(kind.psi0 <= 1.0);
                CHECK((!kind.is_permanent || kind.psi0 == 0.0));
                CHECK(kind.unfavourable >= kind.favourable);
            }
        }
        CHECK_FALSE(design_code("EN1991"));
    }

    TEST_CASE("Combinations come behind the others under their formula, and a second time they add nothing")
    {
        Model model = model_of(office);
        model.combinations.push_back({"mine", {{CaseId(std::size_t{0}), 2.0}}});
        const std::vector<DesignCombination> made = design_combinations(
            DesignCode::EN1990, actions_of(DesignCode::EN1990, office), limit_states(DesignCode::EN1990));
        CHECK(add_combinations(DesignCode::EN1990, model, made, english) == made.size());
        CHECK(model.combinations.front().id == "mine");
        CHECK(model.combinations[1].id == "ULS 1.35 G");
        CHECK(model.combinations.back().id == "SLS quasi-permanent G + 0.3 Q");
        CHECK(add_combinations(DesignCode::EN1990, model, made, english) == 0);
    }
}
