#include "ui/workbench/open_document.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "tests/folder.h"
#include "ui/workbench/file_sentences.h"

namespace {

/// A session of a text; one that begins with "bad" is none.
class Note : public ui::OpenDocument<std::string> {
public:
    Note() : OpenDocument("") {}

    std::string text;
    const ui::Catalogue& tr() const override { return tr_; }
    std::string told() const { return notice ? tr_(notice->sentence) : ""; }

private:
    std::optional<ui::Notice> read(const std::filesystem::path& path) override
    {
        std::ifstream file(path);
        const std::string found{std::istreambuf_iterator<char>(file), {}};
        if (!file || found.starts_with("bad"))
            return ui::lasting(ui::not_opened(path, ui::Message("it holds nothing good")));
        text = found;
        begin(text);
        set_partial(found.starts_with("part"));
        return std::nullopt;
    }
    const std::string& current() const override { return text; }
    std::string file_text() const override { return text; }
    std::string about(const ui::Catalogue&) const override { return std::to_string(text.size()); }

    ui::Catalogue tr_;
};

} // namespace

TEST_SUITE("ui workbench")
{
    TEST_CASE("A document is dirty until it is saved, and again when it differs from what was saved")
    {
        const Folder folder;
        Note note;
        CHECK(note.file_name() == "Untitled");
        CHECK_FALSE(note.is_dirty());
        note.text = "first";
        CHECK(note.is_dirty());
        REQUIRE(note.save(folder.path("a.txt")));
        CHECK(note.told() == "a.txt was saved");
        CHECK(folder.read("a.txt") == "first");
        CHECK_FALSE(note.is_dirty());
        note.text = "second";
        CHECK(note.is_dirty());
        note.text = "first";
        CHECK_FALSE(note.is_dirty());
    }

    TEST_CASE("A file that cannot be read leaves document and file as they were and says why")
    {
        const Folder folder;
        Note note;
        REQUIRE(note.open(folder.write("good.txt", "good")));
        CHECK_FALSE(note.open(folder.write("broken.txt", "bad")));
        CHECK(note.told() == "broken.txt was not opened: it holds nothing good");
        CHECK(note.file_name() == "good.txt");
        CHECK(note.text == "good");
    }

    TEST_CASE("What cannot be saved stays dirty, under the file that it had")
    {
        const Folder folder;
        Note note;
        REQUIRE(note.open(folder.write("good.txt", "good")));
        note.text = "better";
        CHECK_FALSE(note.save(folder.path("no folder/a.txt")));
        CHECK(note.told().starts_with("a.txt was not saved: "));
        CHECK(note.is_dirty());
        CHECK(note.file_name() == "good.txt");
    }

    TEST_CASE("A file of which the document has a part alone keeps its name and is not written over")
    {
        const Folder folder;
        Note note;
        REQUIRE(note.open(folder.write("long.txt", "part of it")));
        CHECK(note.file_name() == "long.txt");
        CHECK_FALSE(note.path());
        CHECK_FALSE(note.unsaved().original);
        REQUIRE(note.save(folder.path("other.txt")));
        CHECK(note.path() == folder.path("other.txt"));
    }

    TEST_CASE("What went wrong with a file is told until it is closed")
    {
        const Folder folder;
        Note note;
        CHECK_FALSE(note.open(folder.write("broken.txt", "bad")));
        ui::tick(note.notice, 3600.0);
        CHECK(note.notice);
    }

    TEST_CASE("A copy has no file, and a draft has that of the document whose work it is and is not saved")
    {
        const Folder folder;
        Note note;
        REQUIRE(note.open_copy(folder.write("example.txt", "good")));
        CHECK_FALSE(note.path());
        CHECK_FALSE(note.is_dirty());
        REQUIRE(note.recover(folder.write("draft", "work"), folder.path("mine.txt")));
        CHECK(note.file_name() == "mine.txt");
        CHECK(note.is_dirty());
        CHECK(note.unsaved().about(ui::Catalogue()) == "4");
        CHECK(note.unsaved().original == folder.path("mine.txt"));
    }

    TEST_CASE("Why a picture was not written is told in the user's language")
    {
        const std::error_code denied = std::make_error_code(std::errc::permission_denied);
        const ui::Message told = ui::not_written("/a/b.svg",
                                                 std::system_error(denied, "file b.svg: cannot be written"));
        CHECK(ui::Catalogue()(told) == "b.svg was not written: Permission denied");
        CHECK(ui::Catalogue(ui::Language::Portuguese)(told) == "b.svg não foi gravado: permissão negada");
    }

    TEST_CASE("A notice goes when it has been read, unless it waits to be closed")
    {
        std::optional<ui::Notice> passing = ui::Notice{ui::Message("a")};
        std::optional<ui::Notice> lasting = ui::Notice{ui::Message("b"), std::nullopt};
        for (auto* const notice : {&passing, &lasting}) ui::tick(*notice, 5.0);
        CHECK(passing);
        for (auto* const notice : {&passing, &lasting}) ui::tick(*notice, 1.5);
        CHECK_FALSE(passing);
        CHECK(lasting);
    }
}
