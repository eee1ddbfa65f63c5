#include "tests/golden/gallery.h"

#include "tests/golden/comparison.h"
#include "tests/golden/webp.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace golden {

namespace fs = std::filesystem;

namespace {

constexpr const char* endings[] = {".new.png", ".new.webp", ".reference.png", ".difference.png", ".new.txt", ".html"};

std::optional<std::string> text_of(const fs::path& path)
{
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string escaped(const std::string& text)
{
    std::string html;
    for (const char c : text) {
        if (c == '&') html += "&amp;";
        else if (c == '<') html += "&lt;";
        else html += c;
    }
    return html;
}

constexpr const char* page_head =
    "<!doctype html><meta charset=\"utf-8\"><style>body{font-family:sans-serif;margin:2em}img{border:1px "
    "solid #888;max-width:100%}figure{margin:0 0 2em}</style>\n";

} // namespace

fs::path Gallery::reference(const std::string& name, const char* ending) const { return references_ / (name + ending); }
fs::path Gallery::failure(const std::string& name, const char* ending) const { return failures_ / (name + ending); }

std::string Gallery::fault_of_text(const Exhibit& exhibit) const
{
    const auto wanted = text_of(reference(exhibit.name, ".txt"));
    if (!wanted) return "there is no reference text";
    return first_difference(exhibit.text, *wanted);
}

std::string Gallery::fault_of_pixels(const Exhibit& exhibit) const
{
    if (!exhibit.pixels) return {};
    const fs::path wanted = reference(exhibit.name, ".webp");
    if (!fs::exists(wanted)) return "there is no reference picture";
    const auto result = compare(*exhibit.pixels, read_webp(wanted));
    if (result.is_same()) return {};
    if (!result.has_same_size) return "the picture has another size than its reference";
    return std::to_string(result.n_differing) + " pixels differ, by " + std::to_string(result.largest) + " at most";
}

Verdict Gallery::judge(const Exhibit& exhibit) const
{
    std::string words = fault_of_text(exhibit);
    const std::string of_pixels = fault_of_pixels(exhibit);
    if (!words.empty() && !of_pixels.empty()) words += "; ";
    words += of_pixels;
    if (words.empty()) {
        forget(exhibit.name);
        return {true, {}};
    }
    keep(exhibit, words);
    return {false, exhibit.name + ": " + words + "; see " + failure(exhibit.name, ".html").string() +
                       ", and run tests/accept_golden " + exhibit.name + " if it is meant to look so"};
}

void Gallery::keep(const Exhibit& exhibit, const std::string& words) const
{
    fs::create_directories(failures_);
    forget(exhibit.name);
    std::ofstream(failure(exhibit.name, ".new.txt"), std::ios::binary) << exhibit.text;
    if (exhibit.pixels) {
        ui::write_png(failure(exhibit.name, ".new.png"), *exhibit.pixels);
        write_webp(failure(exhibit.name, ".new.webp"), *exhibit.pixels);
    }
    const fs::path wanted = reference(exhibit.name, ".webp");
    if (exhibit.pixels && fs::exists(wanted)) {
        const ui::Pixels before = read_webp(wanted);
        ui::write_png(failure(exhibit.name, ".reference.png"), before);
        if (before.size == exhibit.pixels->size)
            ui::write_png(failure(exhibit.name, ".difference.png"), difference_picture(*exhibit.pixels, before));
    }
    write_page(exhibit.name, words);
    write_index();
}

void Gallery::forget(const std::string& name) const
{
    bool was_there = false;
    for (const char* ending : endings) was_there = fs::remove(failure(name, ending)) || was_there;
    if (was_there) write_index();
}

void Gallery::write_page(const std::string& name, const std::string& words) const
{
    std::ofstream page(failure(name, ".html"));
    page << page_head << "<title>" << name << "</title><h1>" << name << "</h1><p>" << escaped(words) << "</p>\n";
    for (const char* kind : {"difference", "new", "reference"}) {
        const std::string picture = name + "." + kind + ".png";
        if (fs::exists(failures_ / picture))
            page << "<figure><figcaption>" << kind << "</figcaption><img src=\"" << picture << "\" alt=\"" << kind
                 << "\"></figure>\n";
    }
    page << "<h2>new text</h2><pre>" << escaped(text_of(failure(name, ".new.txt")).value_or("")) << "</pre>\n";
    page << "<h2>reference text</h2><pre>" << escaped(text_of(reference(name, ".txt")).value_or("")) << "</pre>\n";
}

void Gallery::write_index() const
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(failures_))
        if (entry.path().extension() == ".html" && entry.path().stem() != "index") names.push_back(entry.path().stem());
    std::sort(names.begin(), names.end());
    std::ofstream page(failures_ / "index.html");
    page << page_head << "<title>Pictures that differ</title><h1>Pictures that differ: " << names.size() << "</h1>\n";
    for (const auto& name : names) page << "<p><a href=\"" << name << ".html\">" << name << "</a></p>\n";
}

} // namespace golden
