#include "apps/cli/output_file.h"

#include <string>
#include <system_error>

#include "apps/cli/console.h"
#include "femoop/files/whole_file.h"

namespace cli {

namespace {

namespace fs = std::filesystem;

UsageError cannot_write(const fs::path& path, const std::string& reason, const ui::Catalogue& tr)
{
    return UsageError(tr("cannot write {file}: {reason}", {{"file", path.string()}, {"reason", reason}}));
}

} // namespace

void require_writable(const fs::path& path, const ui::Catalogue& tr)
{
    std::error_code error;
    if (path.empty() || !path.has_filename()) throw cannot_write(path, tr("it names no file"), tr);
    if (fs::is_directory(path, error)) throw cannot_write(path, tr("it is a folder; add a file name"), tr);
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
        throw cannot_write(path, tr("there is no folder {folder}; make it first", {{"folder", folder.string()}}), tr);
}

void write_file(const fs::path& path, std::string_view text, const ui::Catalogue& tr)
{
    require_writable(path, tr);
    if (const std::error_code error = files::write_whole_file(path, text))
        throw cannot_write(path, tr(error.message()), tr);
}

void make_folder(const fs::path& folder, const ui::Catalogue& tr)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error))
        throw UsageError(
            tr("cannot make the folder {folder}: a file of that name stands there, or there is no permission",
               {{"folder", folder.string()}}));
}

void write_tables(const fs::path& folder, const std::vector<femoop::CsvFile>& tables, const Console& console)
{
    make_folder(folder, console.tr());
    for (const femoop::CsvFile& table : tables) {
        const fs::path path = folder / table.name;
        write_file(path, table.text, console.tr());
        console.message(console.tr()("written: {file}", {{"file", path.string()}}));
    }
}

} // namespace cli
