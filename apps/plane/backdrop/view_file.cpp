#include "apps/plane/backdrop/view_file.h"

#include <array>
#include <cstdint>
#include <utility>

#include "femoop/files/whole_file.h"
#include "femoop/io/file_text.h"
#include "femoop/io/json/json_document.h"
#include "femoop/io/json/json_writer.h"
#include "femoop/io/reader/value_reader.h"
#include "femoop/model/fault/translator.h"
#include "ui/files/view_file.h"
#include "ui/paint/photo_file.h"

namespace plane {

using namespace femoop;
namespace fs = std::filesystem;

namespace {

constexpr double view_format = 1.0;
constexpr Keys<2> file_keys{{"cremona_view", "background"}, 1};
constexpr Keys<4> background_keys{{"image", "corner", "across", "opacity"}, 3};
constexpr std::uintmax_t most_image_bytes = 100'000'000;

std::string_view words_of(ui::PhotoFault fault)
{
    switch (fault) {
    case ui::PhotoFault::NoImage: return translatable("it is no PNG and no JPEG image");
    case ui::PhotoFault::Damaged: return translatable("the image in it is damaged");
    case ui::PhotoFault::TooLarge: break;
    }
    return translatable(
        "it has more than 8192 pixels along a side or 50 million in all; a smaller copy of it can be read");
}

class ViewReader {
public:
    ViewReader(const JsonReading& json, const fs::path& folder) : folder_(folder)
    {
        for (const Fault& fault : json.faults)
            reader_.add(fault.kind == FaultKind::FileEmpty ? Fault{FaultKind::MissingKey, {"file", "cremona_view"}}
                                                           : fault);
        if (json.document) read(json.document->root());
    }

    ViewReading take()
    {
        ViewReading reading{.backdrop = std::move(backdrop_), .faults = reader_.collect_faults()};
        if (!reading.faults.empty()) reading.backdrop.reset();
        return reading;
    }

private:
    void read(JsonValue file)
    {
        const Place top;
        const auto [version, background] = reader_.fields(file, file_keys, top);
        const auto found = reader_.number(version, top);
        if (found && *found != view_format)
            reader_.add({FaultKind::UnknownChoice, {top.text("cremona_view"), compact_json(version), "1"}});
        if (background.is_present()) read_background(background, top.key("background"));
    }

    void read_background(JsonValue value, const Place& place)
    {
        const auto [image, corner, across, opacity] = reader_.fields(value, background_keys, place);
        const auto name = reader_.text(image, place);
        const auto at = pair(corner, place.key("corner")), side = pair(across, place.key("across"));
        Backdrop backdrop;
        if (at) backdrop.corner = {(*at)[0], (*at)[1]};
        if (side) backdrop.across = {(*side)[0], (*side)[1]};
        if (side && !(length(backdrop.across) > 0.0))
            wanted(across, place, translatable("two numbers that are not both 0"), "[120, 0]");
        backdrop.opacity = reader_.number(opacity, place).value_or(backdrop.opacity);
        if (backdrop.opacity < least_opacity || backdrop.opacity > 1.0)
            wanted(opacity, place, translatable("a number from 0.05 to 1"), "0.6");
        if (!name || !at || !side) return;
        backdrop.file = (folder_ / *name).lexically_normal();
        ImageReading read = read_image(backdrop.file);
        if (read.fault) return reader_.add(*std::move(read.fault));
        backdrop.photo = std::move(read.photo);
        backdrop_ = std::move(backdrop);
    }

    std::optional<std::array<double, 2>> pair(JsonValue list, const Place& place)
    {
        if (!reader_.is_list(list, place)) return std::nullopt;
        std::vector<double> numbers;
        for (const JsonValue entry : list) {
            const auto number = reader_.number(entry, place.entry(numbers.size()));
            if (!number) return std::nullopt;
            numbers.push_back(*number);
        }
        if (numbers.size() == 2) return std::array{numbers[0], numbers[1]};
        reader_.add({FaultKind::WrongType,
                     {place.text(), compact_json(list), std::string(translatable("two numbers")), "[120, 0]"}});
        return std::nullopt;
    }

    void wanted(JsonValue value, const Place& place, std::string_view what, std::string example)
    {
        reader_.add({FaultKind::WrongType,
                     {place.text(value.key()), compact_json(value), std::string(what), std::move(example)}});
    }

    const fs::path& folder_;
    ValueReader reader_;
    std::optional<Backdrop> backdrop_;
};

/// From the folder of the model file, where there is a way.
std::string image_path(const Backdrop& backdrop, const fs::path& model_file)
{
    std::error_code unknown;
    const fs::path folder = fs::absolute(ui::view_path(model_file), unknown).parent_path();
    const fs::path near = backdrop.file.lexically_proximate(folder.lexically_normal());
    return near.generic_string();
}

} // namespace

ViewReading read_view(std::string_view text, const fs::path& folder)
{
    return ViewReader(parse_json(text), folder).take();
}

ViewReading read_view_of(const fs::path& model_file)
{
    std::error_code unknown;
    const fs::path path = fs::absolute(ui::view_path(model_file), unknown);
    if (!fs::exists(path, unknown) && !unknown) return {};
    FileText file = file_text(path);
    if (file.fault) return {.faults = {*std::move(file.fault)}};
    return read_view(file.text, path.parent_path());
}

std::string view_text(const Backdrop& backdrop, const fs::path& model_file)
{
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::Block).member("cremona_view", 1);
    json.key("background").begin_object().member("image", image_path(backdrop, model_file));
    json.key("corner").begin_array().value(backdrop.corner.x).value(backdrop.corner.y).end();
    json.key("across").begin_array().value(backdrop.across.x).value(backdrop.across.y).end();
    json.member("opacity", backdrop.opacity).end().end();
    return json.take();
}

std::error_code write_view_of(const fs::path& model_file, const std::optional<Backdrop>& backdrop)
{
    const fs::path path = ui::view_path(model_file);
    if (backdrop) return files::write_whole_file(path, view_text(*backdrop, model_file));
    std::error_code hindrance;
    fs::remove(path, hindrance);
    return hindrance;
}

SavedView save_view_of(const fs::path& model_file, const std::optional<Backdrop>& backdrop)
{
    if (read_view_of(model_file).faults.empty()) return {.hindrance = write_view_of(model_file, backdrop)};
    if (!backdrop) return {};
    const fs::path path = ui::view_path(model_file);
    SavedView saved{.put_aside = ui::free_old_path(path)};
    fs::rename(path, *saved.put_aside, saved.hindrance);
    if (!saved.hindrance) saved.hindrance = write_view_of(model_file, backdrop);
    return saved;
}

ImageReading read_image(const fs::path& file)
{
    files::WholeFile whole = files::read_whole_file(file, most_image_bytes);
    if (whole.hindrance)
        return {.fault = file_fault(FaultKind::FileUnreadable, file, std::errc(whole.hindrance.value()))};
    const ui::PhotoReading reading = ui::read_photo(std::move(whole.text));
    if (reading.photo) return {.photo = reading.photo};
    return {.fault = Fault{FaultKind::FileUnreadable, {file.string(), std::string(words_of(*reading.fault))}}};
}

} // namespace plane
