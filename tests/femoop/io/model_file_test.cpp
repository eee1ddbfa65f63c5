#include "femoop/io/any_model.h"
#include "femoop/io/model_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "tests/femoop/io/bad_files.h"
#include "tests/folder.h"
#include "tests/source_folder.h"
#include "tests/text_of.h"

using namespace femoop;

namespace {

std::vector<std::filesystem::path> files_under(const std::string& folder)
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

void check_round_trip(const Model& model)
{
    const std::string text = write_model(model);
    const Model again = read_model(text);
    CHECK(again == model);
    CHECK(write_model(again) == text);
}

/// Every key of the format, laid out as the writer lays it out. The schema's test reads it too.
std::string everything() { return text_of_source("tests/femoop/io/everything.json"); }

} // namespace

TEST_CASE("A file that says everything is read and written to the letter")
{
    const std::string text = everything();
    const ModelReading reading = examine_model(text);
    for (const Fault& fault : reading.faults) CHECK(severity(fault.kind) == Severity::Warning);
    CHECK(write_model(reading.model) == text);
    check_round_trip(reading.model);
}

TEST_CASE("Quantities keep the text that was typed and carry the value in the base units")
{
    const Model model = read_model(everything());
    CHECK(model.materials[0].E.text() == "29000 ksi");
    CHECK(model.materials[0].E.value() == 29000.0 * 144.0);
    CHECK(model.nodes[1].at[0].value() == 10.0);
    CHECK(model.nodes[2].support->angle.value() == 30.0);
    CHECK(model.sections[0].h->value() == 1.0);
    CHECK_FALSE(model.nodes[1].at[1].has_text());
    CHECK(model.nodes[1].at[1].value() == 0.1);
    CHECK(std::signbit(model.nodes[0].at[1].value()));
}

TEST_CASE("A verification case or example written and read back is the same model bit for bit")
{
    auto files = files_under("/tests/cases");
    const auto examples = files_under("/examples");
    files.insert(files.end(), examples.begin(), examples.end());
    REQUIRE(files.size() > 50);
    for (const auto& file : files) {
        CAPTURE(file.string());
        const AnyReading reading = examine_any_file(file);
        if (const auto* plane = std::get_if<plane::PlaneReading>(&reading))
            CHECK(plane::read_plane_model(plane::write_plane_model(plane->model)) == plane->model);
        else check_round_trip(std::get<ModelReading>(reading).model);
    }
}

TEST_CASE("Models of every kind survive writing and reading")
{
    for (const char* const analysis : {"truss2d", "frame2d", "grillage", "truss3d", "frame3d"}) {
        CAPTURE(analysis);
        const bool is_3d = std::string(analysis).back() != 'e' && std::string(analysis).find("3d") != std::string::npos;
        const std::string kind = '"' + std::string(analysis) + '"';
        const File file{
            .analysis = kind,
            .sections = R"([{"id": "s", "A": 0.012, "Iz": 2e-4, "Iy": 1e-4, "J": 3e-5}])",
            .nodes = is_3d ? R"([{"id": "A", "at": [0, 0, 1], "support": "pin"}, {"id": "B", "at": [6, 0, 2]}])"
                           : R"([{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [6, 0]}])"};
        check_round_trip(read_model(file.text()));
    }
}

TEST_CASE("A byte-order mark is read over and not written")
{
    const Model model = read_model("\xef\xbb\xbf" + File{}.text());
    CHECK(model == read_model(File{}.text()));
    CHECK(write_model(model).front() == '{');
}

TEST_CASE("The order of keys in a file does not matter to references")
{
    const Model model = read_model(R"({"members": [{"section": "s", "nodes": ["A", "B"], "id": "AB", "material": "m"}],
        "nodes": [{"at": [0, 0], "id": "A"}, {"at": [6, 0], "id": "B"}], "sections": [{"Iz": 2e-4, "A": 0.012, "id": "s"}],
        "units": {"force": "kN", "length": "m"}, "analysis": "frame2d", "materials": [{"E": 2e8, "id": "m"}], "cremona": 1})");
    CHECK(model.members[0].nodes[1] == NodeId(1));
}

TEST_CASE("Nesting as deep as 64 is read, and kept in a block that others read")
{
    const std::string deep = std::string(63, '[') + std::string(63, ']');
    const std::string more = ", \"train\": " + deep;
    const Model model = read_model(File{.more = more}.text());
    CHECK(model.extra[0].json == deep);
    check_round_trip(model);
}

TEST_CASE("A file is written whole and read back; a file that is not there is refused by name")
{
    const Folder folder;
    const Model model = read_model(everything());
    write_model_file(model, folder.path("model.json"));
    CHECK(read_model_file(folder.path("model.json")) == model);
    CHECK(folder.n_entries() == 1);
    const std::string missing = folder.path("missing.json"), check_name = "; check the name and that you may read it";
    CHECK_THROWS_WITH_AS(read_model_file(missing),
                         ("cannot read " + missing + ": No such file or directory" + check_name).c_str(), ModelError);
    CHECK_THROWS_WITH_AS(read_model_file(folder.path()),
                         ("cannot read " + folder.path().string() + ": Is a directory" + check_name).c_str(),
                         ModelError);
    const std::string nowhere = folder.path("none/model.json");
    CHECK_THROWS_WITH_AS(
        write_model_file(model, nowhere),
        ("cannot write " + nowhere + ": No such file or directory; choose another folder or name").c_str(), ModelError);
}

TEST_CASE("What has no end is not read: a device, or a pipe that nobody writes to")
{
    const Folder folder;
    const std::string pipe = folder.path("pipe.json");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    for (const std::string& path : {std::string("/dev/zero"), pipe}) {
        CAPTURE(path);
        const ModelReading reading = examine_model_file(path);
        REQUIRE(reading.faults.size() == 1);
        CHECK(reading.faults[0] == Fault{FaultKind::FileUnreadable, {path, "Not a regular file"}});
    }
}

TEST_CASE("A file that is there and cannot be read through is told as such")
{
    const std::string memory = "/proc/self/mem"; // its beginning is nobody's
    if (!std::filesystem::exists(memory)) return;
    CHECK(examine_model_file(memory).faults ==
          std::vector{Fault{FaultKind::FileUnreadable, {memory, "Input/output error"}}});
}

TEST_CASE("A file longer than a gigabyte is refused before it is read")
{
    const Folder folder;
    const std::string path = folder.path("long.json");
    write_model_file(read_model(everything()), path);
    std::filesystem::resize_file(path, (std::uintmax_t{1} << 30U) + 1U); // the rest is a hole
    CHECK(examine_model_file(path).faults == std::vector{Fault{FaultKind::FileUnreadable, {path, "File too large"}}});
}

TEST_CASE("A stream is read like a text")
{
    std::istringstream stream(everything());
    CHECK(read_model(stream) == read_model(everything()));
}

TEST_CASE("The depth of a shape is written once, as the shape's")
{
    Model model = read_model(File{}.text());
    model.sections[0].shape = SectionShape{.kind = SectionShapeKind::Rectangle, .b = 0.2, .h = 0.3};
    model.sections[0].h = 0.5;
    CHECK(read_model(write_model(model)).sections[0].shape->h->value() == 0.3);
}

TEST_CASE("A model with a number that is not finite cannot be written")
{
    Model model = read_model(File{}.text());
    model.nodes[0].at[0] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(write_model(model), std::invalid_argument);
}
