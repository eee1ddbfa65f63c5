// Staged sheets of a file's `cross` block: props that the file chooses, sways alone, and every number that must be
// right.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "femoop/io/cross/cross_check.h"
#include "femoop/io/model_file.h"
#include "tests/source_folder.h"

using namespace femoop;
using nlohmann::json;

namespace {

json file_of(const std::string& path)
{
    return json::parse(write_model(read_model_file(source_folder() + "/" + path)));
}

CheckCounts verified(const json& file) { return count(cross::check_block(read_model(file.dump()))); }

/// Every number inside a value, one after the other.
void each_number(json& value, const std::function<void(json&)>& visit)
{
    if (value.is_number()) return visit(value);
    if (value.is_structured())
        for (json& one : value) each_number(one, visit);
}

/// The sentence that refuses the file.
std::string refusal(const json& file)
{
    try {
        verified(file);
    } catch (const ModelError& error) {
        return error.what();
    }
    return "";
}

const std::string staged_portal = "tests/cases/own/staged-portal.json",
                  storeys = "tests/cases/own/staged-two-storeys.json";

} // namespace

TEST_CASE("Any number of a staged sheet that is a thousandth off fails")
{
    for (const std::string& path : {staged_portal, storeys}) {
        CAPTURE(path);
        json file = file_of(path);
        REQUIRE(verified(file).failed == 0);
        for (const char* const key : {"stages", "factors", "final"}) {
            CAPTURE(key);
            each_number(file["cross"][key], [&](json& number) {
                const double right = number.get<double>();
                CAPTURE(right);
                number = right == 0.0 ? 0.01 : 1.001 * right;
                CHECK(verified(file).failed > 0);
                number = right;
            });
        }
    }
}

TEST_CASE("A prop whose reaction is not told is a prop all the same")
{
    json file = file_of(staged_portal);
    const int n_before = verified(file).passed;
    file["cross"]["stages"][0]["prop"].erase("reaction");
    CHECK(verified(file).passed == n_before - 1);
    CHECK(verified(file).failed == 0);
    std::swap(file["cross"]["stages"][0], file["cross"]["stages"][1]);
    CHECK(verified(file).failed == 0); // the prop comes second and is still one
}

TEST_CASE("Each node of a storey holds its sway, with the same force")
{
    json file = file_of(storeys);
    for (const char* const node : {"C", "D"}) {
        file["cross"]["stages"][0]["props"][0]["node"] = node;
        file["cross"]["stages"][1]["sway"]["node"] = node;
        CHECK(verified(file).failed == 0);
    }
}

namespace {

/// The portal with an overhang from C.
json with_overhang(double dx, double dy)
{
    json file = file_of(staged_portal);
    const auto corner = std::ranges::find(file["nodes"], "C", [](const json& node) { return node["id"]; });
    const double x = (*corner)["at"][0], y = (*corner)["at"][1];
    json member = file["members"][0];
    member["id"] = "CE";
    member["nodes"] = {"C", "E"};
    file["nodes"].push_back({{"id", "E"}, {"at", {x + dx, y + dy}}});
    file["members"].push_back(member);
    return file;
}

} // namespace

TEST_CASE("A prop at the tip of an overhang holds the sway where it acts along the overhang")
{
    json file = with_overhang(1.5, 0.0);
    const int n_before = verified(file).passed;
    file["cross"]["stages"][0]["prop"]["node"] = "E";
    file["cross"]["stages"][1]["sway"]["node"] = "E";
    CHECK(verified(file).failed == 0);
    CHECK(verified(file).passed == n_before);
    file = with_overhang(0.0, 1.5); // a prop there would hold the joint's rotation too
    file["cross"]["stages"][0]["prop"]["node"] = "E";
    CHECK(refusal(file).starts_with("cross.stages[0].prop: \"E ux\" is none of B ux, C ux"));
}

TEST_CASE("A prop that no sway moves is refused with those that would do")
{
    json file = file_of(staged_portal);
    json& prop = file["cross"]["stages"][0]["prop"];
    prop["node"] = "A";
    CHECK(refusal(file) == "cross.stages[0].prop: \"A ux\" is none of B ux, C ux; choose one of them");
    prop = {{"node", "B"}, {"dof", "uy"}};
    CHECK(refusal(file).starts_with("cross.stages[0].prop: \"B uy\" is none of B ux, C ux"));
    prop = {{"node", "B"}, {"dof", "rz"}};
    CHECK(refusal(file).starts_with("cross.stages[0].prop.dof: \"rz\" is none of ux, uy"));
    prop = "B";
    CHECK(refusal(file).starts_with("cross.stages[0].prop: "));
    file = file_of(staged_portal);
    file["cross"]["stages"][1]["sway"]["node"] = "D";
    CHECK(refusal(file).starts_with("cross.stages[1].sway: \"D ux\" is none of B ux, C ux"));
}

TEST_CASE("Props that leave a sway free, or hold one twice, are refused")
{
    json file = file_of(storeys);
    file["cross"]["stages"][0]["props"][1]["node"] = "C";
    CHECK(refusal(file).starts_with("cross.stages[0].props: \"D ux + C ux\" is none of "));
    file["cross"]["stages"][0]["props"].erase(1);
    CHECK(refusal(file).starts_with("cross.stages[0].props: \"D ux\" is none of "));
}

TEST_CASE("A cell of a sheet that is no number is refused")
{
    json file = file_of(staged_portal);
    file["cross"]["stages"][0]["sheet"][1]["BA"] = "-12";
    CHECK(refusal(file).find("\"-12\"") != std::string::npos);
}
