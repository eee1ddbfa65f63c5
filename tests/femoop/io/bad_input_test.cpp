#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

#include "femoop/io/model_file.h"
#include "femoop/model/check/check.h"
#include "tests/femoop/io/bad_files.h"

using namespace femoop;

namespace {

std::string lines(const std::vector<Fault>& faults)
{
    std::string text;
    for (const Fault& fault : faults) text += message(fault) + '\n';
    return text;
}

void check_all(const std::vector<BadFile>& files, Severity expected)
{
    for (const BadFile& file : files) {
        const std::string &text = file.text, &wanted = file.message; // clang 14 captures no bindings
        CAPTURE(text.substr(0, 2000));
        const ModelReading reading = examine_model(text);
        CHECK(lines(reading.faults) == wanted + '\n');
        if (reading.faults.empty()) continue;
        CHECK(severity(reading.faults.front().kind) == expected);
        CHECK(reading.is_sound() == (expected == Severity::Warning));
        if (expected == Severity::Error) CHECK_THROWS_WITH_AS(read_model(text), wanted.c_str(), ModelError);
        else CHECK_NOTHROW(read_model(text));
    }
}

std::string faults_of(const std::string& text) { return lines(examine_model(text).faults); }

} // namespace

TEST_CASE("The file that the bad ones are made of is sound") { CHECK(examine_model(File{}.text()).faults.empty()); }

TEST_CASE("What is not text is refused with line, column and byte")
{
    check_all(files_that_are_no_text(), Severity::Error);
}

TEST_CASE("What is not JSON is refused with line, column and a remedy")
{
    check_all(files_that_are_no_json(), Severity::Error);
}

TEST_CASE("A key, a type or a name that does not belong is refused with its place and a suggestion")
{
    check_all(files_with_bad_keys(), Severity::Error);
}

TEST_CASE("A quantity that cannot be read is refused with its place and both dimensions")
{
    check_all(files_with_bad_quantities(), Severity::Error);
}

TEST_CASE("A material or section out of its range is refused")
{
    check_all(files_with_bad_materials_and_sections(), Severity::Error);
}

TEST_CASE("A support, spring or mass that the analysis lacks is refused")
{
    check_all(files_with_bad_nodes(), Severity::Error);
}

TEST_CASE("A member that cannot be built is refused") { check_all(files_with_bad_members(), Severity::Error); }

TEST_CASE("A load that cannot act is refused") { check_all(files_with_bad_loads(), Severity::Error); }

TEST_CASE("A bad path or influence line is told with its place, its value and a remedy")
{
    check_all(files_with_bad_moving_loads(), Severity::Error);
}

TEST_CASE("An expected result that cannot be looked up is refused")
{
    check_all(files_with_bad_expectations(), Severity::Error);
}

TEST_CASE("What is odd but can be solved is a warning that names both parts")
{
    check_all(files_with_warnings(), Severity::Warning);
}

TEST_CASE("A member between two nodes at one place has no length, and the nodes are warned of")
{
    CHECK(faults_of(
              File{.nodes = R"([{"id": "A", "at": [2, 0], "support": "fixed"}, {"id": "B", "at": [2, 0]}])"}.text()) ==
          "members[0] \"AB\": length is 0 m because nodes \"A\" and \"B\" are both at (2, 0) m; "
          "move a node or delete the member\n"
          "nodes[1] \"B\": lies where node \"A\" lies, at (2, 0) m; "
          "the two are not joined: use one of them or move one\n");
}

TEST_CASE("A member so short that its square is nothing has no length")
{
    for (const char* place : {"1e-101", "1e-200", "4e-323"}) {
        CAPTURE(place);
        const std::string nodes =
            std::string(R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [)") + place + ", 0]}]";
        CHECK(faults_of(File{.nodes = nodes}.text()).find("because nodes \"A\" and \"B\" are both at (0, 0) m") !=
              std::string::npos);
    }
}

TEST_CASE("A load on a node without members is an error, the lonely node a warning")
{
    CHECK(
        faults_of(File{.nodes = R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0]}, {"id": "C", "at": [9, 0]}])",
                       .more = R"(, "load_cases": [{"id": "G", "nodes": [{"node": "C", "fy": -9}]}])"}
                      .text()) ==
        "load_cases[0].nodes[0]: node \"C\" carries a load but no member is joined to it; join one or move the load\n"
        "nodes[2] \"C\": no member is joined to this node; join one or delete the node\n");
}

TEST_CASE("All errors of a file come in one list: what cannot be read and what is wrong with the rest")
{
    CHECK(faults_of(File{.materials = R"([{"id": "m", "E": -1, "densty": 7.85}])",
                         .nodes = R"([{"id": "A", "at": [0], "support": "fixd"}, {"id": "B", "at": [6, 0]}])",
                         .members = R"([{"id": "AB", "nodes": ["A", "D"], "material": "m", "section": "s"},
                                        {"id": "BA", "nodes": ["B", "A"], "material": "m", "section": "s", "foundation": {"y": -4}}])"}
                        .text()) ==
          "materials[0].densty: unknown key; did you mean \"density\"?\n"
          "nodes[0].at: found a list of 1, wanted 2 lengths in frame2d; give one per coordinate\n"
          "nodes[0].support: \"fixd\" is none of fixed, pin, roller; did you mean \"fixed\"?\n"
          "members[0] \"AB\": no node \"D\"; add the node or name another\n"
          "materials[0] \"m\": E is -1 kN/m^2; give a value greater than 0\n"
          "members[1] \"BA\": foundation is -4 kN/m^2; give a value greater than 0\n");
}

TEST_CASE("A fault in an entry hides no other fault of the same entry")
{
    const auto loaded = [](std::string_view more) { return File{.more = more}.text(); };
    CHECK(faults_of(File{.materials = R"([{"id": "m", "E": "2 kN", "nu": 0.9, "density": -3}])"}.text()) ==
          "materials[0].E: \"2 kN\" measures force, wanted stress or force per area, in kN/m^2 for example\n"
          "materials[0] \"m\": density is -3 kN*s^2/m^4; give 0 or a positive value\n"
          "materials[0] \"m\": nu is 0.9; give a value greater than -1 and at most 0.5\n");
    CHECK(faults_of(File{.sections = R"([{"id": "s", "shape": "box", "b": true, "h": -2, "tw": 3}])"}.text()) ==
          "sections[0].b: found true or false, wanted a number, or a text with a unit; write it like \"1.5 m\"\n"
          "sections[0] \"s\": h is -2 m; give a value greater than 0\n"
          "sections[0] \"s\": shape box has no \"tw\"; take it away: its sizes are b h t\n");
    CHECK(
        faults_of(loaded(R"(, "load_cases": [{"id": "G", "nodes": [{"node": "Q", "fz": 3}],
            "settlements": [{"node": "A", "uz": 1, "ux": "1 kN"}],
            "members": [{"member": "XY", "kind": "point", "at": 2, "fz": 3},
                        {"member": "AB", "kind": "point", "at": 9, "fy": [1]}]}])")) ==
        "load_cases[0].nodes[0]: no node \"Q\"; add the node or name another\n"
        "load_cases[0].settlements[0].ux: \"1 kN\" measures force, wanted length, in m for example\n"
        "load_cases[0].members[0]: no member \"XY\"; add the member or name another\n"
        "load_cases[0].members[1].fy: found a list, wanted a number, or a text with a unit; write it like \"1.5 kN\"\n"
        "load_cases[0].nodes[0]: fz works on uz, which frame2d does not have there; take it away: there are ux uy rz\n"
        "load_cases[0].settlements[0]: uz works on uz, which frame2d does not have there; "
        "take it away: there are ux uy rz\n"
        "load_cases[0].members[0]: fz works on uz, which frame2d does not have there; "
        "take it away: there are ux uy rz\n"
        "load_cases[0].members[1]: \"at\" is 9 m, beyond the end of member \"AB\"; give a length from 0 to 6 m\n");
    CHECK(faults_of(loaded(R"(, "load_cases": [{"id": "G"}], "combinations": [{"id": "G", "factors": {"X": 1}}])")) ==
          "combinations[0] \"G\": no load case or combination \"X\"; add it or name another\n"
          "combinations[0] \"G\": the id is taken by load_cases[0] already; choose another\n");
}

TEST_CASE("One cause gets one message: what follows from a fault is not told again")
{
    const auto count_faults = [](const File& file) { return examine_model(file.text()).faults.size(); };
    const auto with_loads = [](File file) {
        file.more = R"(, "load_cases": [{"id": "G", "nodes": [{"node": "A", "fx": 3}, {"node": "B", "fx": 3}],
            "members": [{"member": "AB", "kind": "point", "at": 2, "fy": -9},
                        {"member": "AB", "kind": "distributed", "from": 2, "to": 4, "qy": -9}]}])";
        return file;
    };
    const std::vector<File> files{
        {.nodes = R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6]}])"},
        {.nodes = R"([{"id": "A", "at": [0, 0]}, {"id": 7, "at": [6, 0]}])"},
        {.nodes = R"([{"id": "A", "at": [0, 0]}, {"id": "", "at": [6, 0]}])"},
        {.nodes = R"([{"id": "A", "at": [0, 0]}, {"at": [6, 0]}])"},
        {.nodes = R"([{"id": "A", "at": [0, 0]}, {"id": "A", "at": [6, 0]}])"},
        {.nodes = R"({"A": [0, 0], "B": [6, 0]})"},
        {.materials = R"([{"id": null, "E": 2e8}])"},
        {.sections = R"([{"id": ["s"], "A": 0.012, "Iz": 2e-4}])"},
        {.members = R"([{"id": true, "nodes": ["A", "B"], "material": "m", "section": "s"}])"},
        {.members = R"([{"id": "AB", "nodes": ["A", "A"], "material": "m", "section": "s"}])"},
        {.members = R"("AB")"}};
    for (const File& file : files) {
        CAPTURE(file.text());
        CHECK(count_faults(with_loads(file)) == 1);
    }
    CHECK(count_faults(
              {.more = R"(, "load_cases": [{"id": 7}], "combinations": [{"id": "U", "factors": {"G": 2}}])"}) == 1);
    CHECK(count_faults({.more = R"(, "load_cases": [{"id": ""}, {"id": "Q"}])"}) == 1);
}

TEST_CASE("An entry without a name excuses one unknown name, not two")
{
    CHECK(faults_of(File{.nodes = R"([{"id": "A", "at": [0, 0]}, {"at": [6, 0]}, {"id": "C", "at": [9, 2]}])",
                         .members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                                        {"id": "BC", "nodes": ["B", "C"], "material": "m", "section": "s"},
                                        {"id": "CD", "nodes": ["C", "D"], "material": "m", "section": "s"}])"}
                        .text()) == "nodes[1]: \"id\" is missing; add it\n"
                                    "members[2] \"CD\": no node \"D\"; add the node or name another\n");
}

TEST_CASE("A file without its needed keys hears of each of them")
{
    CHECK(faults_of("{}") == "file: \"cremona\" is missing; add it\n"
                             "file: \"analysis\" is missing; add it\n"
                             "file: \"units\" is missing; add it\n"
                             "file: \"nodes\" is missing; add it\n"
                             "file: \"members\" is missing; add it\n");
}

TEST_CASE("A bar takes moments square to its axis and refuses any that turn it, in whatever axes they are given")
{
    const auto count_faults = [](const char* load) {
        const std::string more = std::string(R"(, "load_cases": [{"id": "G", "members": [{"member": "AB", )") + load +
                                 "}]}]";
        return examine_model(
                   File{.analysis = R"("grillage")",
                        .sections = R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "J": 3e-5}])",
                        .nodes = R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [3, 4]}])",
                        .members =
                            R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", "bar": true}])",
                        .more = more}
                       .text())
            .faults.size();
    };
    CHECK(count_faults(R"("kind": "point", "at": 2, "mx": 4, "my": -3)") == 0);
    CHECK(count_faults(R"("kind": "point", "at": 2, "mx": 4)") == 1);
    CHECK(count_faults(R"("kind": "ends", "end_mx": 4, "axes": "local")") == 1);
    CHECK(count_faults(R"("kind": "ends", "end_mz": 4, "axes": "local")") == 0);
    CHECK(count_faults(R"("kind": "distributed", "mx": [0, 4])") == 1);
    CHECK(count_faults(R"("kind": "distributed", "mx": [0, 4], "my": [0, -3])") == 0);
}

TEST_CASE("A position up to 1e-9 L beyond an end counts as the end")
{
    const auto at = [](const char* x) {
        const std::string more =
            std::string(
                R"(, "load_cases": [{"id": "G", "members": [{"member": "AB", "kind": "point", "fy": -4, "at": )") +
            x + "}]}]";
        return examine_model(File{.more = more}.text()).faults.size();
    };
    CHECK(at("6.000000005") == 0);
    CHECK(at("6.000000007") == 1);
    CHECK(at("-0.000000005") == 0);
    CHECK(at("-0.000000007") == 1);
}

TEST_CASE("Every kind of fault has a file that shows it")
{
    std::set<FaultKind> shown;
    for (const auto& files :
         {files_that_are_no_text(), files_that_are_no_json(), files_with_bad_keys(), files_with_bad_quantities(),
          files_with_bad_materials_and_sections(), files_with_bad_nodes(), files_with_bad_members(),
          files_with_bad_loads(), files_with_bad_expectations(), files_with_bad_moving_loads(), files_with_warnings()})
        for (const BadFile& file : files)
            for (const Fault& fault : examine_model(file.text).faults) shown.insert(fault.kind);
    // Shown by tests of their own, or impossible to write in a file.
    for (const FaultKind kind : {FaultKind::FileUnreadable,     FaultKind::FileUnwritable,
                                 FaultKind::DanglingReference,  FaultKind::NotFinite,
                                 FaultKind::RepeatedComponent,  FaultKind::ZeroLength,
                                 FaultKind::OffsetSize,         FaultKind::UpSize,
                                 FaultKind::CoincidentNodes,    FaultKind::LoadedNodeWithoutMembers,
                                 FaultKind::MoreCrossings,      FaultKind::InaccurateCase,
                                 FaultKind::IllConditionedCase, FaultKind::InaccurateBody,
                                 FaultKind::IllConditionedBody, FaultKind::NothingHasMass,
                                 FaultKind::RegionWithoutMass,  FaultKind::MasslessMotion,
                                 FaultKind::TooFewModes,        FaultKind::ModeLostInRounding,
                                 FaultKind::InaccurateMode,     FaultKind::ModesNotCounted,
                                 FaultKind::InaccurateLines,    FaultKind::IllConditionedLine,
                                 FaultKind::LineBeyondRange})
        shown.insert(kind);
    // What moment distribution cannot do is shown by its own tests.
    for (auto kind = static_cast<int>(FaultKind::CrossNeedsPlaneFrame);
         kind <= static_cast<int>(FaultKind::CrossSkewSway); ++kind)
        shown.insert(static_cast<FaultKind>(kind));
    // So are the blocks of verification cases, what the command line asks for, and trains.
    for (const FaultKind kind :
         {FaultKind::NoSuchLine, FaultKind::NoSuchLineNear, FaultKind::PathMissing, FaultKind::PositionOffPath,
          FaultKind::BadPathPosition, FaultKind::WrongValueCount, FaultKind::NoSuchTrain, FaultKind::NoSuchTrainNear,
          FaultKind::NoSuchEnvelope, FaultKind::NoSuchEnvelopeNear, FaultKind::TrainWithoutLoad,
          FaultKind::AxlesAndSpacings, FaultKind::RangeOfNoSpacing, FaultKind::RangeReversed, FaultKind::WrongRangeSize,
          FaultKind::EnvelopeWithoutTrains})
        shown.insert(kind);
    // And what the force method cannot release.
    for (auto kind = static_cast<int>(FaultKind::RedundantNoForce); kind <= static_cast<int>(FaultKind::PrimaryMoves);
         ++kind)
        shown.insert(static_cast<FaultKind>(kind));
    // And what plane models have of their own, by tests/femoop/plane.
    for (auto kind = static_cast<int>(FaultKind::PlaneModelElsewhere);
         kind <= static_cast<int>(FaultKind::RegionDeforms); ++kind)
        shown.insert(static_cast<FaultKind>(kind));
    // The kinds before these are the analysis's.
    for (auto kind = static_cast<int>(FaultKind::FileUnreadable); !pattern(static_cast<FaultKind>(kind)).empty();
         ++kind) {
        CAPTURE(pattern(static_cast<FaultKind>(kind)));
        CHECK(shown.contains(static_cast<FaultKind>(kind)));
    }
}
