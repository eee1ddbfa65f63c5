#include "tests/femoop/io/bad_files.h"

std::string File::text() const
{
    std::string text = R"({"cremona": 1, "analysis": )" + std::string(analysis);
    const auto add = [&](const char* key, std::string_view value) {
        text += std::string(", \"") + key + "\": " + std::string(value);
    };
    add("units", units);
    add("materials", materials);
    add("sections", sections);
    add("nodes", nodes);
    add("members", members);
    return text + std::string(more) + '}';
}

namespace {

// Nodes and members of the smallest models of the other kinds.
constexpr std::string_view space_nodes =
    R"([{"id": "A", "at": [0, 0, 0], "support": "fixed"}, {"id": "B", "at": [6, 0, 0]}])";
constexpr std::string_view space_section = R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "Iy": 1e-4, "J": 3e-5}])";

File truss() { return {.analysis = R"("truss2d")"}; }
File grillage()
{
    return {.analysis = R"("grillage")", .sections = R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "J": 3e-5}])"};
}
File space(std::string_view member_keys, std::string_view more = "")
{
    static std::string members; // lives as long as the view: until the next call
    members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s")" + std::string(member_keys) + "}]";
    return {
        .analysis = R"("frame3d")", .sections = space_section, .nodes = space_nodes, .members = members, .more = more};
}

std::string with_section(std::string_view section) { return File{.sections = section}.text(); }
std::string with_nodes(std::string_view nodes) { return File{.nodes = nodes}.text(); }
std::string with_members(std::string_view members) { return File{.members = members}.text(); }

std::string with_member_keys(std::string_view keys)
{
    return with_members(R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", )" + std::string(keys) +
                        "}]");
}

/// Its section is an i whose flanges are 15 mm thick.
std::string with_tapered(std::string_view keys)
{
    const std::string members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", )" +
                                std::string(keys) + "}]";
    return File{.sections = R"([{"id": "s", "shape": "i", "h": 0.5, "bf": 0.2, "tf": 0.015, "tw": 0.01}])",
                .members = members}
        .text();
}

std::string with_support(std::string_view support)
{
    return with_nodes(R"([{"id": "A", "at": [0, 0], "support": )" + std::string(support) +
                      R"(}, {"id": "B", "at": [6, 0]}])");
}

std::string case_text(std::string_view keys) { return R"(, "load_cases": [{"id": "G", )" + std::string(keys) + "}]"; }
std::string with_case(std::string_view keys) { return File{.more = case_text(keys)}.text(); }
std::string with_load(std::string_view keys)
{
    return with_case(R"("members": [{"member": "AB", )" + std::string(keys) + "}]");
}

std::string with_loads(File file, std::string_view case_keys)
{
    const std::string more = case_text(case_keys);
    file.more = more;
    return file.text();
}

std::string with_check(std::string_view keys)
{
    const std::string more = R"(, "load_cases": [{"id": "G"}], "expected": [{)" + std::string(keys) +
                             R"(, "value": 7}])";
    return File{.more = more}.text();
}

} // namespace

std::vector<BadFile> files_that_are_no_text()
{
    return {
        {"", R"(the file is empty; a model file is a JSON object that begins {"cremona": 1, ...})"},
        {" \r\n\t", R"(the file is empty; a model file is a JSON object that begins {"cremona": 1, ...})"},
        {"\xef\xbb\xbf", R"(the file is empty; a model file is a JSON object that begins {"cremona": 1, ...})"},
        {"\xef\xbb\xbf\xef\xbb\xbf{\"cremona\": 1}",
         "the file begins with two byte-order marks (U+FEFF), wanted none or one; save it again as UTF-8"},
        {"{\"title\": \"S\xe3o Paulo\"}",
         "line 1, column 13: byte 0xE3 is not UTF-8 text; save the file as UTF-8 (a model file is plain text)"},
        {"\xff\xfe{",
         "line 1, column 1: byte 0xFF is not UTF-8 text; save the file as UTF-8 (a model file is plain text)"},
        {"{\n\xed\xa0\x80}",
         "line 2, column 1: byte 0xED is not UTF-8 text; save the file as UTF-8 (a model file is plain text)"},
        {"{\xc0\xaf}",
         "line 1, column 2: byte 0xC0 is not UTF-8 text; save the file as UTF-8 (a model file is plain text)"},
        {"{\xf5\x80\x80\x80}",
         "line 1, column 2: byte 0xF5 is not UTF-8 text; save the file as UTF-8 (a model file is plain text)"},
        {"{\xe2\x82",
         "line 1, column 2: byte 0xE2 is not UTF-8 text; save the file as UTF-8 (a model file is plain text)"},
        {std::string("PK\x03\x04\0", 5), "line 1, column 3: control character 0x03; a model file is plain text: "
                                         "is this another kind of file? Save it as UTF-8 text"},
        {"{\"title\": \"a\tb\"}", "line 1, column 13: control character 0x09; "
                                  "a model file is plain text: is this another kind of file? Save it as UTF-8 text"},
        {std::string("{\0}", 3), "line 1, column 2: control character 0x00; a model file is plain text: "
                                 "is this another kind of file? Save it as UTF-8 text"},
    };
}

std::vector<BadFile> files_that_are_no_json()
{
    return {
        {R"({"cremona": 1, "nodes": [)", "line 1, column 26: the file ends here with brackets or quotation marks still "
                                         "open; is it cut off? Close them or fetch the whole file"},
        {"{\"cremona\": 1,\n \"title\": \"Por",
         "line 2, column 15: the file ends here with brackets or quotation marks still open; "
         "is it cut off? Close them or fetch the whole file"},
        {R"({"cremona": 1)", "line 1, column 14: the file ends here with brackets or quotation marks still open; is it "
                             "cut off? Close them or fetch the whole file"},
        {R"({"hinge": tr)", "line 1, column 13: the file ends here with brackets or quotation marks still open; is it "
                            "cut off? Close them or fetch the whole file"},
        {"{\"title\": \"Portal\n\"}",
         "line 1, column 18: text without a closing quotation mark; add the mark before the line ends"},
        {"{\"cremona\": 1, // format\n}", "line 1, column 16: found /; JSON has no comments: use \"notes\""},
        {"{'cremona': 1}", "line 1, column 2: found '; write text in double quotation marks"},
        {R"({"at": [0, 1,]})", "line 1, column 14: comma before ]; take the comma away"},
        {"{\"cremona\": 1,\n}", "line 2, column 1: comma before }; take the comma away"},
        {R"({"cremona": 1 "title": "x"})", "line 1, column 15: a comma is missing before \"title\"; add it"},
        {R"({"at": [0 1]})", "line 1, column 11: a comma is missing before 1; add it"},
        {R"([{"id": "A"} {"id": "B"}])", "line 1, column 14: a comma is missing before {; add it"},
        {R"({"E": NaN})", "line 1, column 7: found NaN; write a finite number"},
        {R"({"E": -Infinity})", "line 1, column 7: found -Infinity; write a finite number"},
        {R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"}, "nodes": [{"id": "A", )"
         R"("at": [-1e999, 1e400], "support": "rollr"}], "members": []})",
         "line 1, column 109: -1e999 is beyond the range of numbers (1.8e308); write a smaller one\n"
         "line 1, column 117: 1e400 is beyond the range of numbers (1.8e308); write a smaller one\n"
         "nodes[0].support: \"rollr\" is none of fixed, pin, roller; did you mean \"roller\"?"},
        {R"({"cremona": 1} {})",
         "line 1, column 16: found { after the end of the model; a file holds one JSON object: take the rest away"},
        {R"({"E": 0x1F})", "line 1, column 7: found 0x1F; write 31"},
        {R"({"E": .5})", "line 1, column 7: found .5; write 0.5"},
        {R"({"E": -.5})", "line 1, column 7: found -.5; write -0.5"},
        {R"({"E": 17.})", "line 1, column 7: found 17.; write 17"},
        {R"({"E": 17.e+08})", "line 1, column 7: found 17.e+08; write 17e08"},
        {R"({"E": -010})", "line 1, column 7: found -010; write -10"},
        {"{\"E\": \u22122.5}", "line 1, column 7: found \u22122.5; write -2.5"},
        {R"({"at": [007.20, 5]})", "line 1, column 9: found 007.20; write 7.20"},
        {R"({"E": +5})", "line 1, column 7: found +5; write 5"},
        {R"({"E": 2_000})", "line 1, column 7: found 2_000; write 2000"},
        {R"({"E": True})", "line 1, column 7: found True; write true"},
        {R"({"E": 2,05})", "line 1, column 7: found 2,05; write a decimal point: 2.05"},
        {R"({"E": 1.2.3})", "line 1, column 7: found 1.2.3, which is no number; write it like -12.5 or 3e-4"},
        {R"({"E": 7e})", "line 1, column 7: found 7e, which is no number; write it like -12.5 or 3e-4"},
        {R"({"E": 0xG})", "line 1, column 7: found 0xG; write a number with its unit in quotation marks, like "
                          "\"12.5 kN\""},
        {R"({"E": - })", "line 1, column 7: found -, which is no number; write it like -12.5 or 3e-4"},
        {R"({"fx": 5kN})",
         "line 1, column 8: found 5kN; write a number with its unit in quotation marks, like \"12.5 kN\""},
        {R"({"fx": 5 kN})",
         "line 1, column 8: found 5 kN; write a number with its unit in quotation marks, like \"12.5 kN\""},
        {R"({cremona: 1})", "line 1, column 2: found cremona; write keys and texts between two \" marks"},
        {"{\"id\": \u201cA\u201d}", "line 1, column 8: found \u201cA\u201d; write keys and texts between two \" marks"},
        {R"({"hinge": tru})", "line 1, column 11: found tru; write keys and texts between two \" marks"},
        {R"({"id": *})", "line 1, column 8: found *, which JSON does not allow here; take it away, or look for a "
                         "bracket or quotation mark that is missing before it"},
        {"{\"x\": " + std::string(64, '[') + std::string(64, ']') + "}",
         "line 1, column 70: brackets nest deeper than 64; "
         "no model file needs that: look for a bracket that is never closed"},
        {std::string(1'000'000, '['), "line 1, column 65: brackets nest deeper than 64; "
                                      "no model file needs that: look for a bracket that is never closed"},
        {"\xef\xbb\xbf{\"E\": \xc3\xa9}",
         "line 1, column 7: found \xc3\xa9; write keys and texts between two \" marks"},
    };
}

std::vector<BadFile> files_with_bad_keys()
{
    return {
        {"[]", "file: found a list, wanted an object; write it like {\"...\": ...}"},
        {"17", "file: found a number, wanted an object; write it like {\"...\": ...}"},
        {"[1, 2]", "file: found a list, wanted an object; write it like {\"...\": ...}"},
        {with_nodes(R"([{"id": "A", "at": [0, 0], "suport": "fixed"}, {"id": "B", "at": [6, 0]}])"),
         "nodes[0].suport: unknown key; did you mean \"support\"?"},
        {with_nodes(R"([{"id": "A", "at": [0, 0], "colour": "red"}, {"id": "B", "at": [6, 0]}])"),
         "nodes[0].colour: unknown key; take it away or use one of id, at, support, hinge, mass"},
        {File{.more = R"(, "title": "a", "title": "b")"}.text(),
         "title: key is given twice in one object; keep one of them"},
        {with_nodes(R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0], "at": [6, 0]}])"),
         "nodes[1].at: key is given twice in one object; keep one of them"},
        {File{.more = R"(, "title": 3)"}.text(), "title: found a number, wanted a text; write it like \"...\""},
        {with_nodes(R"([{"id": "A", "at": [0, 0], "hinge": "yes"}, {"id": "B", "at": [6, 0]}])"),
         "nodes[0].hinge: found a text \"yes\", wanted true or false; write it like true"},
        {File{.more = R"(, "load_cases": "0123456789012345678901234567890123456789012345")"}.text(),
         "load_cases: found a text \"0123456789012345678901234567890123456789\", wanted a list; write it like [...]"},
        {File{.more = R"(, "load_cases": "012345678901234567890123456789012345678çã")"}.text(),
         "load_cases: found a text \"012345678901234567890123456789012345678ç\", wanted a list; write it like [...]"},
        {with_members(R"({"id": "AB"})"), "members: found an object, wanted a list; write it like [...]"},
        {File{.materials = R"([{"id": "m", "E": true}])"}.text(),
         "materials[0].E: found true or false, wanted a number, or a text with a unit; write it like \"1.5 kN/m^2\""},
        {File{.materials = R"([{"id": "m"}])"}.text(), "materials[0] \"m\": \"E\" is missing; add it"},
        {R"({"cremona": 1, "analysis": "frame2d", "nodes": [], "members": []})", "file: \"units\" is missing; add it"},
        {R"({"cremona": 2, "analysis": "frame2d", "units": {"length": "m", "force": "kN"}, "nodes": [], "members": []})",
         "cremona: found format 2, wanted 1; write \"cremona\": 1, or read this file with a newer program"},
        {File{.analysis = R"("frame2")"}.text(),
         "analysis: \"frame2\" is none of truss2d, frame2d, grillage, truss3d, frame3d; did you mean \"frame2d\"?"},
        {File{.units = R"({"length": "yard", "force": "kN"})"}.text(),
         "units.length: \"yard\" is none of m, mm, cm, km, in, ft; choose one of them"},
        {with_nodes(R"([{"id": "A", "at": [0, 0, 0]}, {"id": "B", "at": [6, 0]}])"),
         "nodes[0].at: found a list of 3, wanted 2 lengths in frame2d; give one per coordinate"},
        {with_members(R"([{"id": "AB", "nodes": ["A", "B", "A"], "material": "m", "section": "s"}])"),
         "members[0] \"AB\": found a list of 3, wanted the names of 2 nodes; name the first and the second"},
        {space(R"(, "up": [0, 1])").text(), "members[0].up: found a list of 2, wanted 3 numbers; give x, y and z"},
        {with_load(R"("kind": "distributed", "qy": [-1, -2, -3])"),
         "load_cases[0].members[0].qy: found a list of 3, "
         "wanted one number or two [value at \"from\", value at \"to\"]; leave out the others or add one"},
        {with_load(R"("kind": "point", "fy": -9, "at": "half%")"),
         "load_cases[0].members[0].at: cannot read \"half%\" as a percentage; write it like \"50%\""},
        {with_check(R"("quantity": "frequency", "analysis": "modal", "which": 1.5)"),
         "expected[0].which: found 1.5, wanted the number of a mode or the rank of a face (1, "
         "2, ...), \"max\" or \"min\"; write one of these"},
        {with_section(R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "bf": 0.2}])"),
         "sections[0] \"s\": \"bf\" is the size of a shape; add \"shape\" or take \"bf\" away"},
        {with_members(R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                          {"id": "BD", "nodes": ["B", "D"], "material": "m", "section": "s"}])"),
         "members[1] \"BD\": no node \"D\"; add the node or name another"},
        {with_case(R"("nodes": [{"node": "N", "fy": -9}])"),
         "load_cases[0].nodes[0]: no node \"N\"; add the node or name another"},
        {File{.nodes = R"([{"id": "left", "at": [0, 0], "support": "fixed"}, {"id": "right", "at": [6, 0]}])",
              .members = R"([{"id": "AB", "nodes": ["left", "rigth"], "material": "m", "section": "s"}])"}
             .text(),
         "members[0] \"AB\": no node \"rigth\"; did you mean \"right\"?"},
        {with_members(R"([{"id": "AB", "nodes": ["A", "B"], "material": "wood", "section": "s"}])"),
         "members[0] \"AB\": no material \"wood\"; add the material or name another"},
        {File{.materials = R"([{"id": "steel", "E": 2e8}])",
              .members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "Steel", "section": "s"}])"}
             .text(),
         "members[0] \"AB\": no material \"Steel\"; did you mean \"steel\"?"},
        {with_members(R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "thick"}])"),
         "members[0] \"AB\": no section \"thick\"; add the section or name another"},
        {File{.sections = R"([{"id": "IPE 300", "A": 0.0054, "Iz": 8.4e-5}])",
              .members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "IPE300"}])"}
             .text(),
         "members[0] \"AB\": no section \"IPE300\"; did you mean \"IPE 300\"?"},
        {with_case(R"("members": [{"member": "XY", "kind": "misfit", "elongation": "2 mm"}])"),
         "load_cases[0].members[0]: no member \"XY\"; add the member or name another"},
        {File{
             .members = R"([{"id": "beam", "nodes": ["A", "B"], "material": "m", "section": "s"}])",
             .more =
                 R"(, "load_cases": [{"id": "G", "members": [{"member": "baem", "kind": "misfit", "elongation": "2 mm"}]}])"}
             .text(),
         "load_cases[0].members[0]: no member \"baem\"; did you mean \"beam\"?"},
        {File{.more = R"(, "load_cases": [{"id": "G"}], "combinations": [{"id": "U", "factors": {"Q": 1.5}}])"}.text(),
         "combinations[0] \"U\": no load case or combination \"Q\"; add it or name another"},
        {File{.more = R"(, "load_cases": [{"id": "dead"}], "combinations": [{"id": "U", "factors": {"daed": 1.5}}])"}
             .text(),
         "combinations[0] \"U\": no load case or combination \"daed\"; did you mean \"dead\"?"},
    };
}

std::vector<BadFile> files_with_bad_quantities()
{
    const auto with_E = [](const std::string& E) {
        return File{.materials = R"([{"id": "m", "E": ")" + E + R"("}])"}.text();
    };
    return {
        {with_E("steel"),
         "materials[0].E: \"steel\" does not begin with a number; write a number and its unit, like \"12.5 kN/m^2\""},
        {with_E("205"),
         "materials[0].E: \"205\" has no unit; write \"12.5 kN/m^2\" for example, or a number without quotation marks"},
        {with_E("2,05 GPa"), "materials[0].E: \"2,05 GPa\" has a comma; write a decimal point"},
        {with_E("205 GPa GPa"), "materials[0].E: \"205 GPa GPa\": cannot read the unit at \"GPa\"; "
                                "join units with * / and ^, like kN*m/rad or cm^4"},
        {with_E("205 bar"), "materials[0].E: \"205 bar\": no unit \"bar\"; there are m mm cm km in ft, "
                            "N kN MN lbf kip tf kgf, Pa kPa MPa GPa psi ksi, kg g t lb, s ms Hz, deg rad, K degC degF"},
        {with_E("205 Gpa"), "materials[0].E: \"205 Gpa\": no unit \"Gpa\"; did you mean \"GPa\"?"},
        {with_E("205 kN"),
         "materials[0].E: \"205 kN\" measures force, wanted stress or force per area, in kN/m^2 for example"},
        {File{.materials = R"([{"id": "m", "E": 2e8, "nu": "0.3 m"}])"}.text(),
         "materials[0].nu: \"0.3 m\" measures length, wanted a plain number; take the unit away"},
        {with_E("1e305 GPa"),
         "materials[0].E: \"1e305 GPa\" is beyond the range of numbers; write one that is nearer to 1, or 0 where nothing is meant"},
        {with_nodes(R"([{"id": "A", "at": [0, "5 kN"], "support": "fixed"}, {"id": "B", "at": [6, 0]}])"),
         "nodes[0].at[1]: \"5 kN\" measures force, wanted length, in m for example"},
        {with_support(R"({"fixed": ["ux", "uy"], "angle": "30 m"})"),
         "nodes[0].support.angle: \"30 m\" measures length, wanted angle, in deg for example"},
    };
}

std::vector<BadFile> files_with_bad_materials_and_sections()
{
    const auto with_material = [](const std::string& keys) {
        return File{.materials = R"([{"id": "m", )" + keys + "}]"}.text();
    };
    return {
        {File{.materials = R"([{"id": "m", "E": 2e8}, {"id": "m", "E": 3e8}])"}.text(),
         "materials[1] \"m\": the id is taken by materials[0] already; choose another"},
        {with_material(R"("E": 0)"), "materials[0] \"m\": E is 0 kN/m^2; give a value greater than 0"},
        {with_material(R"("E": "-205 GPa")"), "materials[0] \"m\": E is -205 GPa; give a value greater than 0"},
        {with_material(R"("E": 2e8, "G": 0)"), "materials[0] \"m\": G is 0 kN/m^2; give a value greater than 0"},
        {with_material(R"("E": 2e8, "fy": -1)"), "materials[0] \"m\": fy is -1 kN/m^2; give a value greater than 0"},
        {with_material(R"("E": 2e8, "density": "-7850 kg/m^3")"),
         "materials[0] \"m\": density is -7850 kg/m^3; give 0 or a positive value"},
        {with_material(R"("E": 2e8, "nu": 0.51)"),
         "materials[0] \"m\": nu is 0.51; give a value greater than -1 and at most 0.5"},
        {with_material(R"("E": 2e8, "nu": -1)"),
         "materials[0] \"m\": nu is -1; give a value greater than -1 and at most 0.5"},
        {with_section(R"([{"id": "s", "A": 0, "Iz": 2e-4}])"),
         "sections[0] \"s\": A is 0 m^2; give a value greater than 0"},
        {with_section(R"([{"id": "s", "A": 0.012, "Iz": "-9 cm^4"}])"),
         "sections[0] \"s\": Iz is -9 cm^4; give a value greater than 0"},
        {with_section(R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "Asy": -0.01}])"),
         "sections[0] \"s\": Asy is -0.01 m^2; give a value greater than 0"},
        {with_section(R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "h": 0}])"),
         "sections[0] \"s\": h is 0 m; give a value greater than 0"},
        {with_section(R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "yc": -0.1}])"),
         "sections[0] \"s\": yc is -0.1 m; give 0 or a positive value"},
        {with_section(R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "h": "30 cm", "yc": "31 cm"}])"),
         "sections[0] \"s\": yc is 31 cm, more than the depth h = 30 cm; measure it from the -y' fibre"},
        {with_section(R"([{"id": "s", "A": 0.012}])"),
         "sections[0] \"s\": Iz is missing, which frame2d needs for member \"AB\"; add it, a shape or a profile"},
        {File{.analysis = R"("truss2d")", .sections = R"([{"id": "s", "Iz": 2e-4}])"}.text(),
         "sections[0] \"s\": A is missing, which truss2d needs for member \"AB\"; add it, a shape or a profile"},
        {File{.analysis = R"("grillage")"}.text(),
         "sections[0] \"s\": J is missing, which grillage needs for member \"AB\"; add it, a shape or a profile"},
        {File{.analysis = R"("frame3d")",
              .sections = R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "J": 3e-5}])",
              .nodes = space_nodes}
             .text(),
         "sections[0] \"s\": Iy is missing, which frame3d needs for member \"AB\"; add it, a shape or a profile"},
        {with_section(R"([{"id": "s", "shape": "circle", "d": 0.2, "profile": "IPE 300"}])"),
         "sections[0] \"s\": has both a shape and a profile; keep one"},
        {with_section(R"([{"id": "s", "A": 0.01, "Iz": 2e-4, "turned": true}])"),
         "sections[0] \"s\": \"turned\" is for a shape or a profile, and this section is given by numbers; exchange Iy and Iz, "
         "and Asy and Asz, or take it away"},
        {with_section(R"([{"id": "s", "shape": "box", "b": 0.2, "h": 0.3}])"),
         "sections[0] \"s\": shape box needs b h t; add \"t\""},
        {with_section(R"([{"id": "s", "shape": "rectangle", "b": 0.2, "h": 0.3, "tw": 0.01}])"),
         "sections[0] \"s\": shape rectangle has no \"tw\"; take it away: its sizes are b h"},
        {with_section(R"([{"id": "s", "shape": "rectangle", "b": 0, "h": 0.3}])"),
         "sections[0] \"s\": b is 0 m; give a value greater than 0"},
        {with_section(R"([{"id": "s", "shape": "tube", "d": 0.2, "t": 0.15}])"),
         "sections[0] \"s\": t is 0.15 m, which is not less than d/2 = 0.1 m; make it thinner"},
        {with_section(R"([{"id": "s", "shape": "triangle", "b": 0.2}])"),
         "sections[0].shape: \"triangle\" is none of rectangle, circle, tube, box, i, t, l, c; choose one of them"},
        {with_section(R"([{"id": "s", "profile": "IPE 310"}])"),
         "sections[0] \"s\": no profile \"IPE 310\"; did you mean \"IPE300\"?"},
        {with_section(R"([{"id": "s", "profile": "rail"}])"),
         "sections[0] \"s\": no profile \"rail\"; there are IPE, HEA, HEB, HEM, UPN, W (AISC and BR), HP, L, CHS, SHS and RHS: "
         "name one of these, or give the section's shape or properties"},
    };
}

std::vector<BadFile> files_with_bad_nodes()
{
    const std::string truss_roller =
        File{.analysis = R"("truss3d")",
             .nodes = R"([{"id": "A", "at": [0, 0, 0], "support": "roller"}, {"id": "B", "at": [6, 0, 0]}])"}
            .text();
    return {
        {with_nodes(
             R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [6, 0], "support": "pinned"}])"),
         "nodes[1].support: \"pinned\" is none of fixed, pin, roller; choose one of them"},
        {with_nodes(R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": ["4e160 m", 0]}])"),
         "nodes[1] \"B\": x is 4e160 m, too far for stiffnesses to be reckoned with; "
         "give a length up to 1e100 m, and check its unit"},
        {truss_roller,
         "nodes[0] \"A\": \"roller\" is for truss2d and frame2d, this is truss3d; use {\"fixed\": [...]}"},
        {File{
             .analysis = R"("frame3d")",
             .sections = space_section,
             .nodes =
                 R"([{"id": "A", "at": [0, 0, 0], "support": {"fixed": ["ux"], "angle": 30}}, {"id": "B", "at": [6, 0, 0]}])"}
             .text(),
         "nodes[0] \"A\": \"angle\" is for truss2d and frame2d, this is frame3d; take it away"},
        {with_support(R"({"fixed": ["ux", "uz"]})"),
         "nodes[0] \"A\": fixes uz, which frame2d does not have; take it away: there are ux uy rz"},
        {with_support(R"({"fixed": ["ux", "vy"]})"),
         "nodes[0].support.fixed[1]: \"vy\" is none of ux, uy, uz, rx, ry, rz; choose one of them"},
        {with_support(R"({"springs": {"ry": 5}})"),
         "nodes[0] \"A\": has a spring for ry, which frame2d does not have; take it away: there are ux uy rz"},
        {with_support(R"({"fixed": ["ux"], "springs": {"ux": 5}})"),
         "nodes[0] \"A\": ux is fixed and has a spring; keep one"},
        {with_support(R"({"fixed": ["ux"], "springs": {"rz": "0 kN*m/rad"}})"),
         "nodes[0] \"A\": spring rz is 0 kN*m/rad, which holds nothing; take it away or give a value greater than 0"},
        {with_support(R"({"fixed": ["ux"], "springs": {"rz": -7}})"),
         "nodes[0] \"A\": spring rz is -7 kN*m/rad; give a value greater than 0"},
        {with_support(R"({"fixed": ["ux", "rz", "uy", "rz"]})"),
         "nodes[0].support.fixed[3]: \"rz\" stands at nodes[0].support.fixed[1] already; keep one of them"},
        {with_support(R"({"springs": 5})"),
         "nodes[0].support.springs: found a number, wanted an object; write it like {\"...\": ...}"},
        {File{.nodes = R"([{"id": "A\u001b[2J", "at": [0, 0]}, {"id": "B", "at": [6, 0]}])",
              .members = R"([{"id": "AB", "nodes": ["A\u001b[2J", "B"], "material": "m", "section": "s"}])"}
             .text(),
         "nodes[0] \"A\\u001b[2J\": the id has a control character, such as a line break or a tab; "
         "use letters, digits and blanks"},
        {with_members(R"([{"id": "AB", "nodes": ["A", "B\r\u007f"], "material": "m", "section": "s"}])"),
         "members[0] \"AB\": no node \"B\\u000d\\u007f\"; add the node or name another"},
        {with_nodes(R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0], "mass": {"uz": 5}}])"),
         "nodes[1] \"B\": has a mass for uz, which frame2d does not have; take it away: there are ux uy rz"},
        {with_nodes(R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0], "mass": {"ux": -5}}])"),
         "nodes[1] \"B\": mass ux is -5 kN*s^2/m; give 0 or a positive value"},
        {with_nodes("[{\"id\": \"A\", \"at\": [\"\u22123 cm\", 0]}, {\"id\": \"B\", \"at\": [6, 0]}]"),
         "nodes[0].at[0]: \"\u22123 cm\" begins with a dash, wanted a number and its unit; "
         "write the minus as a hyphen: \"-3 cm\""},
        {with_nodes(R"([{"id": "A", "at": ["zero", 0]}, {"id": "B", "at": [6, 0]}])"),
         "nodes[0].at[0]: \"zero\" does not begin with a number; write a number and its unit, like \"12.5 m\""},
    };
}

std::vector<BadFile> files_with_bad_members()
{
    return {
        {with_members(R"([{"id": "", "nodes": ["A", "B"], "material": "m", "section": "s"}])"),
         "members[0]: \"id\" is empty; give it a name"},
        {with_members(R"([{"id": "AA", "nodes": ["A", "A"], "material": "m", "section": "s"},
                          {"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"}])"),
         "members[0] \"AA\": goes from node \"A\" to itself; name two different nodes"},
        {File{.materials = "[]", .members = R"([{"id": "AB", "nodes": ["A", "B"], "section": "s"}])"}.text(),
         "members[0] \"AB\": has no material; name one (only a rigid member needs none)"},
        {File{.sections = "[]", .members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m"}])"}.text(),
         "members[0] \"AB\": has no section; name one (only a rigid member needs none)"},
        {with_member_keys(R"("start": {"offset": [3, 0]}, "end": {"offset": [-3, 0]})"),
         "members[0] \"AB\": its offsets leave nothing of the 6 m between its nodes; shorten them"},
        {with_member_keys(R"("start": {"offset": [4, 0]}, "end": {"offset": [-4, 0]})"),
         "members[0] \"AB\": its offsets leave nothing of the 6 m between its nodes; shorten them"},
        {with_member_keys(R"("start": {"offset": [0, -3e101]})"),
         "members[0] \"AB\": start offset is -3e101 m, too far for stiffnesses to be reckoned with; "
         "give a length up to 1e100 m, and check its unit"},
        {with_member_keys(R"("start": {"offset": [1, 0, 0]})"),
         "members[0].start.offset: found a list of 3, wanted 2 lengths in frame2d; give one per coordinate"},
        {File{
             .analysis = R"("truss2d")",
             .members =
                 R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", "end": {"offset": [-0.5, 0.25]}}])"}
             .text(),
         "members[0] \"AB\": end offset (-0.5, 0.25) m lies 0.25 m across the member, whose "
         "moment no node of a truss can take; give the part along the member, (-0.5, 0) m, or use frame2d with bars"},
        {with_member_keys(R"("start": {"release": ["ry"]})"),
         "members[0] \"AB\": releases ry at its start, which a member of frame2d does not have; "
         "take it away: there are ux uy rz"},
        {with_member_keys(R"("end": {"spring": {"uz": 5}})"),
         "members[0] \"AB\": has a spring for uz at its end, which a member of frame2d does not have; "
         "take it away: there are ux uy rz"},
        {with_member_keys(R"("end": {"spring": {"rz": -5}})"),
         "members[0] \"AB\": end spring rz is -5 kN*m/rad; give a value greater than 0"},
        {with_member_keys(R"("end": {"release": ["rz"], "spring": {"rz": "8000 kN*m/rad"}})"),
         "members[0] \"AB\": rz at its end is released and has a spring; keep one"},
        {File{
             .nodes = R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [6, 0], "hinge": true}])",
             .members =
                 R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", "end": {"spring": {"rz": 8000}}}])"}
             .text(),
         "members[0] \"AB\": rz at its end has a spring, but node \"B\" is a hinge, which releases it; take one away"},
        {with_member_keys(R"("tension_only": true, "compression_only": true)"),
         "members[0] \"AB\": takes tension only and compression only, so nothing; keep one"},
        {with_member_keys(R"("foundation": {"y": 0})"),
         "members[0] \"AB\": foundation is 0 kN/m^2, which holds nothing; take it away or give a value greater than 0"},
        {with_member_keys(R"("foundation": {"y": 1e300})"),
         "members[0] \"AB\": foundation y 1e300 kN/m^2 is too stiff for the member of 6 m; "
         "give 1e25 kN/m^2 or less, or hold its nodes by supports instead"},
        {with_member_keys(R"("foundation": 5000)"),
         "members[0].foundation: found a number, wanted an object; write it like {\"...\": ...}"},
        {with_member_keys(R"("start": "hinge")"),
         "members[0].start: found a text, wanted an object; write it like {\"...\": ...}"},
        {with_member_keys(R"("end": {"spring": {"rz": "0 kN*m/rad"}})"),
         "members[0] \"AB\": end spring rz is 0 kN*m/rad, which is a full release; "
         "write \"release\": [\"rz\"] or give a value greater than 0"},
        {with_member_keys(R"("end": {"release": ["rz", "rz"]})"),
         "members[0].end.release[1]: \"rz\" stands at members[0].end.release[0] already; keep one of them"},
        {File{.analysis = R"("truss2d")",
              .members =
                  R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", "foundation": {"y": 5000}}])"}
             .text(),
         "members[0] \"AB\": has a foundation but carries axial force only; "
         "take the foundation away or use a frame member"},
        {with_member_keys(R"("bar": true, "foundation": {"y": 5000})"),
         "members[0] \"AB\": has a foundation but carries axial force only; "
         "take the foundation away or use a frame member"},
        {with_member_keys(R"("depths": ["60 cm"])"),
         "members[0].depths: found a list of 1 depths, wanted 2; give that at the first end and that at the second"},
        {with_tapered(R"("depths": [0.6, 0])"), "members[0] \"AB\": depths is 0 m; give a value greater than 0"},
        {with_member_keys(R"("depths": ["60 cm", "30 cm"])"),
         "members[0] \"AB\": its depths cannot vary the section \"s\"; give it a shape rectangle, box, i or c by its "
         "dimensions alone, not turned"},
        {with_tapered(R"("bar": true, "depths": [0.6, 0.3])"),
         "members[0] \"AB\": has depths and bar, which do not go together yet; take one of them away"},
        {with_tapered(R"("foundation": {"y": 5000}, "depths": [0.6, 0.3])"),
         "members[0] \"AB\": has depths and foundation, which do not go together yet; take one of them away"},
        {with_tapered(R"("depths": [0.6, 0.03])"),
         "members[0] \"AB\": depth 0.03 m leaves no room between the flanges of section \"s\"; give more than 0.03 m"},
        {with_tapered(R"("depths": [30, 0.5])"),
         "members[0] \"AB\": depths 30 m and 0.5 m differ too much for one member; divide it, or give at most 50 times "
         "the smaller"},
        {File{
             .analysis = R"("truss2d")",
             .members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", "depths": [0.6, 0.3]}])"}
             .text(),
         "members[0] \"AB\": has depths, which are for members of frame2d; this is truss2d: take them away"},
        {with_member_keys(R"("theory": "bernoulli")"),
         "members[0].theory: \"bernoulli\" is none of euler-bernoulli, timoshenko; choose one of them"},
        {with_member_keys(R"("up": [0, 0, 1])"),
         "members[0] \"AB\": \"up\" is for 3D models, this is frame2d; take it away"},
        {space(R"(, "up": [0, 0, 0])").text(), "members[0] \"AB\": \"up\" is the zero vector; give a direction"},
        {space(R"(, "up": [-2, 0, 0])").text(),
         "members[0] \"AB\": \"up\" points along the member; give another direction"},
    };
}

std::vector<BadFile> files_with_bad_loads()
{
    return {
        {with_case(R"("nodes": [{"node": "B", "fz": 5}])"),
         "load_cases[0].nodes[0]: fz works on uz, which frame2d does not have there; take it away: there are ux uy rz"},
        {with_loads(truss(), R"("nodes": [{"node": "B", "mz": 5}])"),
         "load_cases[0].nodes[0]: mz works on rz, which truss2d does not have there; take it away: there are ux uy"},
        {with_loads(grillage(), R"("members": [{"member": "AB", "kind": "distributed", "qy": -5}])"),
         "load_cases[0].members[0]: qy works on uy, which grillage does not have there; "
         "take it away: there are uz rx ry"},
        {with_loads(grillage(), R"("members": [{"member": "AB", "kind": "distributed", "qz": -5, "axes": "local"}])"),
         "load_cases[0].members[0]: qz works on uz, which grillage does not have there; "
         "take it away: there are uy rx rz"},
        {with_load(R"("kind": "ends", "start_mx": 5)"), "load_cases[0].members[0]: start_mx works on rx, which frame2d "
                                                        "does not have there; take it away: there are ux uy rz"},
        {with_case(R"("settlements": [{"node": "B", "uy": "-10 mm"}])"),
         "load_cases[0].settlements[0]: uy of node \"B\" is free, so it cannot be made to settle; "
         "fix it, give it a spring, or use a load"},
        {with_case(R"("settlements": [{"node": "A", "uz": "-10 mm"}])"),
         "load_cases[0].settlements[0]: uz works on uz, which frame2d does not have there; "
         "take it away: there are ux uy rz"},
        {with_case(R"("self_weight": 1)"),
         "load_cases[0] \"G\": self_weight needs the density of material \"m\" (member \"AB\"); add \"density\""},
        {File{.analysis = R"("grillage")",
              .materials = R"([{"id": "m", "E": 2e8, "density": 7.85}])",
              .sections = R"([{"id": "s", "Iz": 2e-4, "J": 3e-5}])",
              .more = R"(, "load_cases": [{"id": "G", "self_weight": 1}])"}
             .text(),
         "load_cases[0] \"G\": self_weight needs the area of section \"s\" (member \"AB\"); add \"A\""},
        {with_load(R"("kind": "point", "fy": -40, "at": 6.1)"),
         "load_cases[0].members[0]: \"at\" is 6.1 m, beyond the end of member \"AB\"; give a length from 0 to 6 m"},
        {with_load(R"("kind": "point", "fy": -40, "at": "101%")"),
         "load_cases[0].members[0]: \"at\" is 101%, beyond the end of member \"AB\"; give a length from 0 to 6 m"},
        {with_load(R"("kind": "point", "fy": -40, "at": "-1 mm")"),
         "load_cases[0].members[0]: \"at\" is -1 mm, before the start of member \"AB\"; give a length from 0 to 6 m"},
        {with_load(R"("kind": "distributed", "qy": -4, "from": 2, "to": "700 cm")"),
         "load_cases[0].members[0]: \"to\" is 700 cm, beyond the end of member \"AB\"; give a length from 0 to 6 m"},
        {with_load(R"("kind": "distributed", "qy": -4, "from": 4, "to": "50%")"),
         "load_cases[0].members[0]: goes from 4 m to 3 m; \"from\" has to be less than \"to\""},
        {with_load(R"("kind": "distributed", "qy": -4, "projected": true, "axes": "local")"),
         "load_cases[0].members[0]: a projected load has global axes; take \"axes\" or \"projected\" away"},
        {space(R"(, "bar": true)", case_text(R"("members": [{"member": "AB", "kind": "point", "at": 2, "mx": 3}])"))
             .text(),
         "load_cases[0].members[0]: turns member \"AB\" about its own axis, which a bar does not resist; "
         "take the torque away, or take \"bar\" from the member"},
        {with_load(R"("kind": "distributed", "mz": -4, "projected": true)"),
         "load_cases[0].members[0]: mz is a moment, which has no projected length; give it in a load of its own"},
        {with_load(R"("kind": "temperature", "top": 10, "bottom": 10)"),
         "load_cases[0].members[0]: "
         "material \"m\" of member \"AB\" has no coefficient of thermal expansion; add \"alpha\""},
        {File{
             .materials = R"([{"id": "m", "E": 2e8, "alpha": 1.2e-5}])",
             .more =
                 R"(, "load_cases": [{"id": "G", "members": [{"member": "AB", "kind": "temperature", "top": 10, "bottom": 30}]}])"}
             .text(),
         "load_cases[0].members[0]: top and bottom differ, "
         "which needs the depth of section \"s\" (member \"AB\"); add \"h\""},
        {File{
             .materials = "[]",
             .sections = "[]",
             .members = R"([{"id": "AB", "nodes": ["A", "B"], "rigid": true}])",
             .more =
                 R"(, "load_cases": [{"id": "G", "members": [{"member": "AB", "kind": "temperature", "top": 10, "bottom": 10}]}])"}
             .text(),
         "load_cases[0].members[0]: "
         "member \"AB\" has no material and section that could be warmed; load another member"},
        {with_loads(grillage(), R"("members": [{"member": "AB", "kind": "misfit", "elongation": "2 mm"}])"),
         "load_cases[0].members[0]: a misfit works along the member, which a grillage cannot feel; take the load away"},
        {with_load(R"("kind": "temperature", "top": 10)"), "load_cases[0].members[0]: \"bottom\" is missing; add it"},
        {with_load(R"("kind": "distribute", "qy": -4)"),
         "load_cases[0].members[0].kind: \"distribute\" is none of distributed, point, ends, temperature, misfit; "
         "did you mean \"distributed\"?"},
        {with_load(R"("qy": -4)"), "load_cases[0].members[0]: \"kind\" is missing; add it"},
        {with_load(R"("kind": "point", "fy": -4)"), "load_cases[0].members[0]: \"at\" is missing; add it"},
        {with_load(R"("kind": "point", "qy": -4, "at": 1)"),
         "load_cases[0].members[0].qy: unknown key; take it away or use one of member, "
         "kind, at, fx, fy, fz, mx, my, mz, axes"},
        {File{.more = R"(, "load_cases": [{"id": "G"}], "combinations": [{"id": "G", "factors": {"G": 1.35}}])"}.text(),
         "combinations[0] \"G\": the id is taken by load_cases[0] already; choose another"},
        {File{.more = R"(, "combinations": [{"id": "U", "factors": {"V": 1}}, {"id": "V", "factors": {"U": 1}}])"}
             .text(),
         "combinations[0] \"U\": names itself: U -> V -> U; break the circle"},
        {File{.more = R"(, "combinations": [{"id": "U", "factors": {"U": 1}}])"}.text(),
         "combinations[0] \"U\": names itself: U -> U; break the circle"},
    };
}

std::vector<BadFile> files_with_bad_expectations()
{
    return {
        {File{.more = R"(, "load_cases": [{"id": "G"}, {"id": "Q"}],
                 "expected": [{"quantity": "displacement", "node": "B", "component": "uy", "value": 7}])"}
             .text(),
         "expected[0]: which case? the file has 2 load cases and combinations; add \"case\""},
        {with_check(R"("quantity": "displacement", "component": "uy")"),
         "expected[0]: a check of a displacement needs \"node\"; add it"},
        {with_check(R"("quantity": "reaction", "node": "A")"),
         "expected[0]: a check of a reaction needs \"component\"; add it"},
        {with_check(R"("quantity": "section_force", "member": "AB", "component": "M")"),
         "expected[0]: a check of a section_force needs \"at\"; add it"},
        {with_check(R"("quantity": "extreme", "member": "AB", "component": "M")"),
         "expected[0]: a check of a extreme needs \"which\"; add it"},
        {with_check(R"("quantity": "load_factor", "analysis": "buckling")"),
         "expected[0]: a check of a load_factor needs \"which\"; add it"},
        {with_check(R"("quantity": "displacement", "node": "B", "member": "AB", "component": "v", "at": 1)"),
         "expected[0]: names a node and a member; keep one"},
        {with_check(R"("quantity": "displacement", "node": "B", "component": "uz")"),
         "expected[0]: component uz does not exist in frame2d; name another"},
        {with_check(R"("quantity": "section_force", "member": "AB", "component": "Mz", "at": 1)"),
         "expected[0].component: \"Mz\" is none of N, V, M, u, v; choose one of them"},
        {with_check(R"("quantity": "reaction", "node": "B", "component": "fy")"),
         "expected[0]: node \"B\" has no support, so no reaction; name a supported node"},
        {with_check(R"("quantity": "section_force", "member": "AB", "component": "M", "at": 7)"),
         "expected[0]: \"at\" is 7 m, beyond the end of member \"AB\"; give a length from 0 to 6 m"},
        {with_check(R"("quantity": "displacement", "node": "B", "component": "uy", "rtol": -1)"),
         "expected[0]: rtol is -1; give 0 or a positive value"},
        {with_check(R"("quantity": "displacement", "node": "B", "component": "uy", "case": "H")"),
         "expected[0]: no load case or combination \"H\"; add it or name another"},
    };
}

namespace {

/// A path along AB, and an influence line with these keys.
std::string with_line(std::string_view keys)
{
    return File{.more = R"(, "paths": [{"id": "deck", "members": ["AB"]}], "influence_lines": [{"id": "L", )" +
                        std::string(keys) + "}]"}
        .text();
}

} // namespace

std::vector<BadFile> files_with_bad_moving_loads()
{
    constexpr std::string_view nodes = R"([{"id": "A", "at": [0, 0], "support": "fixed"}, {"id": "B", "at": [6, 0]},
                                           {"id": "C", "at": [8, 0]}, {"id": "D", "at": [9, 0]}])";
    constexpr std::string_view members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                                             {"id": "BC", "nodes": ["B", "C"], "material": "m", "section": "s"},
                                             {"id": "CD", "nodes": ["C", "D"], "material": "m", "section": "s"}])";
    return {
        {with_line(R"("path": "dek", "quantity": "reaction", "node": "A", "component": "fy")"),
         "influence_lines[0] \"L\": no path \"dek\"; did you mean \"deck\"?"},
        {with_line(R"("path": "way", "quantity": "reaction", "node": "A", "component": "fy")"),
         "influence_lines[0] \"L\": no path \"way\"; add it to paths or name another"},
        {with_line(R"("path": [], "quantity": "reaction", "node": "A", "component": "fy")"),
         "influence_lines[0] \"L\": has no members, so nothing moves along it; name some"},
        {with_line(R"("path": ["AC"], "quantity": "reaction", "node": "A", "component": "fy")"),
         "influence_lines[0].path[0]: no member \"AC\"; add the member or name another"},
        {with_line(R"("path": 3, "quantity": "reaction", "node": "A", "component": "fy")"),
         "influence_lines[0].path: found a number, wanted the id of a path, or a list of members; write it like [\"AB\", \"BC\"]"},
        {with_line(R"("path": "deck", "quantity": "load_factor", "member": "AB", "component": "M", "at": 1)"),
         "influence_lines[0].quantity: \"load_factor\" is no effect of a moving load; ask for displacement, "
         "reaction, section_force"},
        {with_line(R"("path": "deck", "quantity": "section_force", "member": "AB", "component": "M")"),
         "influence_lines[0] \"L\": a check of a section_force needs \"at\"; add it"},
        {with_line(R"("path": "deck", "quantity": "section_force", "member": "AB", "component": "M", "at": 7)"),
         "influence_lines[0] \"L\": \"at\" is 7 m, beyond the end of member \"AB\"; give a length from 0 to 6 m"},
        {with_line(R"("path": "deck", "quantity": "reaction", "node": "B", "component": "fy")"),
         "influence_lines[0] \"L\": node \"B\" has no support, so no reaction; name a supported node"},
        {with_line(R"("path": "deck", "quantity": "displacement", "node": "B", "component": "uz")"),
         "influence_lines[0] \"L\": component uz does not exist in frame2d; name another"},
        {with_line(R"("path": "deck", "quantity": "reaction", "node": "A", "component": "fy", "load": {"fy": 0})"),
         "influence_lines[0] \"L\": the unit load has no direction; give a component that is not 0, or leave the load "
         "out: it is down"},
        {with_line(R"("path": "deck", "quantity": "reaction", "node": "A", "component": "fy", "load": {"fz": -1})"),
         "influence_lines[0] \"L\": fz works on uz, which frame2d does not have there; take it away: there are ux uy rz"},
        {File{.nodes = nodes, .members = members, .more = R"(, "paths": [{"id": "deck", "members": ["AB", "CD"]}])"}
             .text(),
         "paths[0] \"deck\": member \"CD\" (C - D) does not begin where member \"AB\" (A - B) ends; name members that "
         "follow one another, node by node"},
        {File{.more = R"(, "paths": [{"id": "d", "members": ["AB"]}, {"id": "d", "members": ["AB"]}])"}.text(),
         "paths[1] \"d\": the id is taken by paths[0] already; choose another"},
    };
}

std::vector<BadFile> files_with_warnings()
{
    constexpr std::string_view cross =
        R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0]}, {"id": "C", "at": [2, -1]}, {"id": "D", "at": [2, 1]}])";
    constexpr std::string_view two = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                                         {"id": "CD", "nodes": ["C", "D"], "material": "m", "section": "s"}])";
    return {
        {File{.materials = R"([{"id": "m", "E": 2e8}, {"id": "wood", "E": 1e7}])"}.text(),
         "materials[1] \"wood\": no member uses this material; use it or delete it"},
        {File{.sections = R"([{"id": "s", "A": 0.012, "Iz": 2e-4}, {"id": "t", "A": 0.02}])"}.text(),
         "sections[1] \"t\": no member uses this section; use it or delete it"},
        {with_nodes(R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0]}, {"id": "C", "at": [9, 0]}])"),
         "nodes[2] \"C\": no member is joined to this node; join one or delete the node"},
        {R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"}, "nodes": [], "members": []})",
         "the model has no members: there is nothing to analyse; add some"},
        {File{.nodes = cross, .members = two}.text(),
         "members[1] \"CD\": crosses member \"AB\" at (2, 0) m without a node; "
         "if they are joined there, add a node and split both"},
        {File{
             .nodes =
                 R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0]}, {"id": "C", "at": [2, 0]}, {"id": "D", "at": [2, 1]}])",
             .members = two}
             .text(),
         "members[0] \"AB\": passes node \"C\" at (2, 0) m without being joined to it; "
         "if it is joined there, split it at the node"},
        {File{
             .nodes =
                 R"([{"id": "A", "at": [0, 0]}, {"id": "B", "at": [6, 0]}, {"id": "C", "at": [2, 0]}, {"id": "D", "at": [8, 0]}])",
             .members = two}
             .text(),
         "members[1] \"CD\": lies on member \"AB\" around (4, 0) m; delete one, or split them where they part"},
        {with_members(R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s"},
                          {"id": "BA", "nodes": ["B", "A"], "material": "m", "section": "s"}])"),
         "members[1] \"BA\": lies on member \"AB\" around (3, 0) m; delete one, or split them where they part"},
        {File{.members = R"([{"id": "AB", "nodes": ["A", "B"], "material": "m", "section": "s", "bar": true}])",
              .more = R"(, "paths": [{"id": "d", "members": ["AB"]}])"}
             .text(),
         "paths[0] \"d\": what stands between the nodes of AB is carried to these as by a simple beam, since a bar takes "
         "axial force only"},
        {with_member_keys(R"("tension_only": true)"),
         "members[0] \"AB\": takes tension only or compression only, which the linear analysis cannot follow: "
         "it counts as an ordinary member there"},
        {with_case(R"("nodes": [{"node": "B"}])"),
         "load_cases[0].nodes[0]: does nothing: it has no component; give one or delete it"},
        {with_load(R"("kind": "distributed", "from": 1)"),
         "load_cases[0].members[0]: does nothing: it has no component; give one or delete it"},
        {with_section(R"([{"id": "s", "shape": "l", "h": "100 mm", "b": "75 mm", "t": "10 mm"}])"),
         "sections[0] \"s\": shape l bends about y' and z' through its centroid: Iyz and the shear "
         "centre's distance are left out; expect this where the member is held against bending sideways and twisting"},
        {with_section(R"([{"id": "s", "profile": "L 100x75x10"}])"),
         "sections[0] \"s\": shape l bends about y' and z' through its centroid: Iyz and the shear "
         "centre's distance are left out; expect this where the member is held against bending sideways and twisting"},
    };
}
