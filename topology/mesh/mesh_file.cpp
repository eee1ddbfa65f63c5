#include "topology/mesh/mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "topology/text/words.h"

namespace topology {

namespace {

double coordinate(std::string_view word)
{
    if (const auto value = finite_number(word)) return *value;
    throw error(MeshFault::BadNumber, {std::string(word)});
}

/// An index as OBJ writes it, from 1 or backwards from the points read so far, before the first stroke.
std::uint32_t obj_index(std::string_view word, std::size_t n_points)
{
    const std::string_view digits = word.substr(0, word.find('/'));
    long long value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const auto n = static_cast<long long>(n_points);
    const long long index = value < 0 ? n + value : value - 1;
    if (result.ec != std::errc() || result.ptr != digits.data() + digits.size() || value == 0 || index < 0 ||
        index >= n)
        throw error(MeshFault::BadIndex, {std::string(word)});
    return static_cast<std::uint32_t>(index);
}

std::size_t whole(std::string_view word, std::size_t below)
{
    std::size_t value = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc() || result.ptr != word.data() + word.size() || value >= below)
        throw error(MeshFault::BadIndex, {std::string(word)});
    return value;
}

Point point(const std::vector<std::string_view>& words, std::size_t first)
{
    if (words.size() < first + 3) throw error(MeshFault::TooFewWords, {});
    return {coordinate(words[first]), coordinate(words[first + 1]), coordinate(words[first + 2])};
}

void read_obj_line(const std::vector<std::string_view>& words, Mesh& mesh)
{
    if (words[0] == "v") mesh.points.push_back(point(words, 1));
    if (words[0] != "f") return;
    std::vector<std::uint32_t>& polygon = mesh.polygons.emplace_back();
    for (std::size_t i = 1; i < words.size(); ++i) polygon.push_back(obj_index(words[i], mesh.points.size()));
}

/// The lines of an OFF file that say something, one after another.
class OffReader {
public:
    explicit OffReader(std::string_view text) : lines_(text) {}

    Mesh take()
    {
        const std::vector<std::string_view> header = next();
        if (header[0] != "OFF") throw placed(error(MeshFault::NoHeader, {}));
        const std::vector<std::string_view> counts = header.size() > 1 ? std::vector(header.begin() + 1, header.end())
                                                                       : next();
        try_line([&] { read_counts(counts); });
        for (std::size_t i = 0; i < n_points_; ++i) {
            const auto words = next();
            try_line([&] { mesh_.points.push_back(point(words, 0)); });
        }
        for (std::size_t i = 0; i < n_polygons_; ++i) {
            const auto words = next();
            try_line([&] { read_polygon(words); });
        }
        return std::move(mesh_);
    }

private:
    void read_counts(const std::vector<std::string_view>& words)
    {
        constexpr std::size_t most = 0x7FFFFFFFU;
        if (words.size() < 2) throw error(MeshFault::TooFewWords, {});
        n_points_ = whole(words[0], most);
        n_polygons_ = whole(words[1], most);
    }
    void read_polygon(const std::vector<std::string_view>& words)
    {
        const std::size_t n = whole(words[0], words.size());
        std::vector<std::uint32_t>& polygon = mesh_.polygons.emplace_back();
        for (std::size_t i = 1; i <= n; ++i)
            polygon.push_back(static_cast<std::uint32_t>(whole(words[i], mesh_.points.size())));
    }
    std::vector<std::string_view> next()
    {
        while (lines_.next())
            if (auto found = words(lines_.line()); !found.empty()) return found;
        throw error(MeshFault::CutOff, {});
    }
    LineError placed(const LineError& fault) const { return fault.at(lines_.number(), lines_.line()); }
    template <class Read> void try_line(const Read& read)
    {
        try {
            read();
        } catch (const LineError& fault) {
            throw placed(fault);
        }
    }

    Lines lines_;
    Mesh mesh_;
    std::size_t n_points_ = 0, n_polygons_ = 0;
};

std::string spaced(const Point& p) { return written(p.x) + " " + written(p.y) + " " + written(p.z); }

} // namespace

Mesh read_obj(std::string_view text)
{
    Mesh mesh;
    for (Lines lines(text); lines.next();) {
        const std::vector<std::string_view> found = words(lines.line());
        if (found.empty()) continue;
        try {
            read_obj_line(found, mesh);
        } catch (const LineError& fault) {
            throw fault.at(lines.number(), lines.line());
        }
    }
    return mesh;
}

Mesh read_off(std::string_view text) { return OffReader(text).take(); }

std::string write_obj(const Mesh& mesh)
{
    std::string text;
    for (const Point& p : mesh.points) text += "v " + spaced(p) + "\n";
    for (const std::vector<std::uint32_t>& polygon : mesh.polygons) {
        text += polygon.size() > 2 ? "f" : polygon.size() == 2 ? "l" : "p";
        for (const std::uint32_t i : polygon) text += " " + std::to_string(std::size_t{i} + 1);
        text += "\n";
    }
    return text;
}

std::string write_off(const Mesh& mesh)
{
    std::string text = "OFF\n" + std::to_string(mesh.points.size()) + " " + std::to_string(mesh.polygons.size()) +
                       " 0\n";
    for (const Point& p : mesh.points) text += spaced(p) + "\n";
    for (const std::vector<std::uint32_t>& polygon : mesh.polygons) {
        text += std::to_string(polygon.size());
        for (const std::uint32_t i : polygon) text += " " + std::to_string(i);
        text += "\n";
    }
    return text;
}

} // namespace topology
