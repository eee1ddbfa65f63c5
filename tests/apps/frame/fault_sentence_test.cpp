// What is wrong, as the apps tell it: by names and labels, never in the words of the file.
#include "apps/frame/document/fault/field.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/document/fault/sentence.h"
#include "apps/frame/tables/columns.h"
#include "femoop/io/model_file.h"
#include "tests/femoop/io/bad_files.h"
#include "tests/source_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

using namespace frame;
using femoop::Fault;
using femoop::FaultKind;

namespace {

std::vector<BadFile> bad_files()
{
    std::vector<BadFile> all;
    for (const auto& files :
         {files_that_are_no_text(), files_that_are_no_json(), files_with_bad_keys(), files_with_bad_quantities(),
          files_with_bad_materials_and_sections(), files_with_bad_nodes(), files_with_bad_members(),
          files_with_bad_loads(), files_with_bad_expectations(), files_with_warnings()})
        all.insert(all.end(), files.begin(), files.end());
    return all;
}

/// These show what was typed: a piece of the file's text, or a name that cannot be shown as it is.
bool shows_what_was_typed(FaultKind kind)
{
    return femoop::pattern(kind).starts_with("line {0}, column {1}") || kind == FaultKind::ControlCharacterInId;
}

/// A key of the format in quotation marks, if the sentence has one.
std::string quoted_key(const std::string& sentence)
{
    for (const char* key :
         {"cremona",  "id",         "at",          "support",  "fixed",       "pin",        "roller",   "angle",
          "springs",  "spring",     "hinge",       "nodes",    "members",     "materials",  "sections", "material",
          "section",  "release",    "offset",      "theory",   "rigid",       "bar",        "up",       "foundation",
          "case",     "load_cases", "from",        "to",       "axes",        "projected",  "density",  "alpha",
          "h",        "A",          "Iz",          "E",        "nu",          "G",          "yc",       "shape",
          "profile",  "kind",       "qy",          "fx",       "self_weight", "factors",    "top",      "bottom",
          "notes",    "title",      "node",        "member",   "component",   "quantity",   "which",    "units",
          "analysis", "length",     "force",       "expected", "settlements", "elongation", "value",    "rtol",
          "max",      "min",        "inextensible"})
        if (sentence.find('"' + std::string(key) + '"') != std::string::npos) return key;
    return "";
}

const Fault temperature{FaultKind::MissingDepth, {"load_cases[3].members[0]", "column", "CD"}};

femoop::Model portal_with_temperature()
{
    femoop::Model model = femoop::read_model_file(source_folder() + "/examples/portal.json");
    model.load_cases.push_back({.id = "T", .members = {{femoop::MemberId(2), femoop::TemperatureLoad{}}}});
    return model;
}

/// Which this app never reads: it hears that a file is a plane model, and no more.
bool is_of_plane_models(FaultKind kind)
{
    return kind > FaultKind::PlaneModelElsewhere && kind <= FaultKind::RegionDeforms;
}

} // namespace

TEST_SUITE("frame fault sentence")
{
    TEST_CASE("A fault names case, member, section and the field to fill in")
    {
        const auto faults = named({temperature}, portal_with_temperature());
        CHECK(sentence(faults[0], ui::Catalogue()) ==
              "Case T, load on member CD: top and bottom differ, which needs the depth of section column (member CD); "
              "fill in Depth h (Sections)");
        CHECK(sentence(faults[0], ui::Catalogue(ui::Language::Portuguese)) ==
              "Caso T, carga na barra CD: topo e base diferem, o que exige a altura da seção column (barra CD); "
              "preencha Altura h (Seções)");
        CHECK(femoop::message(temperature) == "load_cases[3].members[0]: top and bottom differ, "
                                              "which needs the depth of section \"column\" (member \"CD\"); add \"h\"");
    }

    TEST_CASE("Without the model a part is told by its number")
    {
        CHECK(sentence(temperature, ui::Catalogue()).starts_with("Case #4, load on member #1: "));
        CHECK(sentence({FaultKind::NotPositive, {"sections[1]", "Iz", "-3"}}, ui::Catalogue()) ==
              "Section #2: Iz is −3; give a value greater than 0");
    }

    TEST_CASE("Numbers have true minus signs and the language's decimal mark, and what was typed stays")
    {
        const Fault crossing{FaultKind::MembersCross, {"AB", "CD-2", "(-0.6667, 1) m"}};
        const Fault negative{FaultKind::NotPositive, {"sections[1]", "Iz", "-3.5e-5 m^4"}};
        const Fault typed{FaultKind::QuantityWithComma, {"Load", "-3,5"}};
        const ui::Catalogue english, portuguese(ui::Language::Portuguese);
        CHECK(sentence(crossing, english).find("(−0.6667, 1) m") != std::string::npos);
        CHECK(sentence(crossing, portuguese).find("(−0,6667; 1) m") != std::string::npos);
        CHECK(sentence(crossing, english).find("CD-2") != std::string::npos);
        CHECK(sentence(negative, english).find("−3.5e−5 m^4") != std::string::npos);
        CHECK(sentence(negative, portuguese).find("−3,5e−5 m^4") != std::string::npos);
        CHECK(sentence(typed, portuguese).find("\"-3,5\"") != std::string::npos);
        const Fault spring{FaultKind::NotPositive, {"sections[1]", "rz", "-7 kN*m/rad"}};
        CHECK(sentence(spring, english).find("−7 kN·m/rad") != std::string::npos);
        const Fault bare{FaultKind::QuantityWithoutNumber, {"", "kN", "12.5 kN*m"}};
        CHECK(sentence(bare, english).find("\"12.5 kN·m\"") != std::string::npos);
    }

    TEST_CASE("A calculation without a value is told as such, not as a unit that cannot be read")
    {
        for (const char* typed : {"1/0", "3 / (2-2) kN", "0/0"})
            CHECK(sentence({FaultKind::QuantityBadUnit, {"Load", typed, "0"}}, ui::Catalogue()) ==
                  "Load: \"" + std::string(typed) + "\" divides by zero; write another divisor");
        CHECK(sentence({FaultKind::QuantityBadUnit, {"Load", "5 kN/", ""}}, ui::Catalogue())
                  .find("cannot read the unit") != std::string::npos);
    }

    TEST_CASE("No fault is told in the words of the file, in either language")
    {
        for (const ui::Language language : ui::all_languages) {
            const ui::Catalogue tr(language);
            for (const BadFile& file : bad_files()) {
                const femoop::ModelReading reading = femoop::examine_model(file.text);
                for (const Fault& fault : named(reading.faults, reading.model)) {
                    const std::string words = sentence(fault, tr);
                    CAPTURE(words);
                    if (shows_what_was_typed(fault.kind)) continue;
                    CHECK(words.find('[') == std::string::npos);
                    const std::string key = quoted_key(words);
                    const bool is_name = key == "A" || key == "bar"; // of a node, and a unit that somebody typed
                    CHECK((key.empty() || is_name));
                }
            }
        }
    }

    TEST_CASE("No kind of fault has a bracket or a key of the file in its own words, in either language")
    {
        for (const ui::Language language : ui::all_languages) {
            const ui::Catalogue tr(language);
            for (int i = 0; !femoop::pattern(static_cast<FaultKind>(i)).empty(); ++i) {
                if (is_of_plane_models(static_cast<FaultKind>(i))) continue;
                const std::string words = tr(spoken_pattern(static_cast<FaultKind>(i)));
                CAPTURE(words);
                CHECK(!words.empty());
                CHECK(words.find('[') == std::string::npos);
                CHECK(words.find('_') == std::string::npos);
                CHECK(quoted_key(words).empty());
                for (const char* kind : {"truss2d", "frame2d", "truss3d", "frame3d"})
                    CHECK(words.find(kind) == std::string::npos);
            }
        }
    }

    TEST_CASE("The field to fill in is a column of a table")
    {
        const ui::Catalogue english;
        for (const BadFile& file : bad_files()) {
            const femoop::ModelReading reading = femoop::examine_model(file.text);
            for (const Fault& fault : reading.faults) {
                const std::optional<Field> field = field_of(remedy_of(fault));
                const auto place = place_of(fault);
                if (!field || !place || !part_at(*place, reading.model)) continue;
                std::set<std::string> headings;
                for (const femoop::AnalysisKind kind : {femoop::AnalysisKind::Frame2d, femoop::AnalysisKind::Frame3d}) {
                    femoop::Model model = reading.model;
                    model.analysis = kind;
                    for (const TableKind table : all_table_kinds)
                        if (!is_result(table))
                            for (const Column& column : columns(model, table)) headings.insert(english(column.heading));
                }
                CAPTURE(femoop::message(fault));
                CAPTURE(english(field->heading));
                CHECK(headings.contains(english(field->heading)));
            }
        }
    }

    TEST_CASE("A place is read as it is written, whatever a name consists of")
    {
        for (const char* text : {"load_cases[3] \"T\".members[0] \"CD\".at", "members[2] \"B].C\"", "nodes[0] \"a\"b\"",
                                 "nodes[3] \"D\".support.fixed[1]", "units.length", "file"}) {
            const auto place = place_of({FaultKind::UnknownKey, {text, ""}});
            REQUIRE(place);
            CHECK(place->text() == text);
        }
        for (const char* text : {"nodes[", "nodes[x]", "nodes[1]]", ""})
            CHECK(!place_of({FaultKind::UnknownKey, {text, ""}}));
        CHECK(!place_of({FaultKind::MechanismNodeTurns, {"nodes[1]", "rz"}}));
    }
}
