#include "engine/io/mesh/surface_check.h"
#include "engine/io/mesh/surface_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <vector>

namespace carina
{
namespace
{

constexpr double kLooseShareTolerated = 0.01;

/// Walks the lines of an OBJ once. Faces may name vertices that follow, so that the largest index
/// is judged at the end.
class ObjWalk
{
public:
    Result<void> line(std::string_view text)
    {
        ++m_line;
        const std::string_view key = takeWord(text);
        if (key == "v")
            return vertex(text);
        if (key == "f")
            return face(text);
        return {};
    }

    Result<void> end(bool lastLineEnded) const
    {
        if (m_used.size() > m_vertices)
            return fail(Errc::FileMalformed, "a face names vertex " + std::to_string(m_used.size())
                                                 + " of " + std::to_string(m_vertices));
        const auto used = static_cast<std::size_t>(std::count(m_used.begin(), m_used.end(), true));
        const auto loose = static_cast<double>(m_vertices - used);
        if (used == 0)
            return fail(Errc::FileMalformed, "no triangles");
        const double tolerated = lastLineEnded ? kLooseShareTolerated * double(m_vertices) : 0.0;
        if (loose > tolerated)
            return fail(Errc::FileMalformed, "truncated: " + std::to_string(m_vertices - used)
                                                 + " of " + std::to_string(m_vertices)
                                                 + " vertices belong to no face");
        return {};
    }

private:
    Result<void> vertex(std::string_view text)
    {
        for (int axis = 0; axis < 3; ++axis) {
            std::string_view word = takeWord(text);
            if (word.starts_with('+'))
                word.remove_prefix(1);
            double value = 0.0;
            const char* last = word.data() + word.size();
            const auto read = std::from_chars(word.data(), last, value);
            if (read.ec == std::errc::invalid_argument || read.ptr != last)
                return malformed("a vertex without three coordinates");
            if (read.ec != std::errc{} || !std::isfinite(static_cast<float>(value)))
                return fail(Errc::NotFinite, place() + "a coordinate that is not finite");
        }
        ++m_vertices;
        return {};
    }

    Result<void> face(std::string_view text)
    {
        int corners = 0;
        for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text)) {
            if (word == "\\")
                return {}; // goes on in the next line
            std::int64_t index = 0;
            const char* last = word.data() + word.size();
            const auto read = std::from_chars(word.data(), last, index);
            if (read.ec != std::errc{} || (read.ptr != last && *read.ptr != '/'))
                return malformed("a face with a corner that is no number");
            const std::int64_t vertex =
                index < 0 ? static_cast<std::int64_t>(m_vertices) + index : index - 1;
            if (vertex < 0 || vertex >= kMostVertices)
                return malformed("a face that names vertex " + std::to_string(index));
            if (vertex >= static_cast<std::int64_t>(m_used.size()))
                m_used.resize(static_cast<std::size_t>(vertex) + 1, false);
            m_used[static_cast<std::size_t>(vertex)] = true;
            ++corners;
        }
        return corners < 3 ? malformed("a face with fewer than three corners") : Result<void>{};
    }

    std::string place() const { return "line " + std::to_string(m_line) + ": "; }
    Result<void> malformed(const std::string& fault) const
    {
        return fail(Errc::FileMalformed, place() + fault);
    }

    static constexpr std::int64_t kMostVertices = 1 << 28; ///< bounds what m_used may take
    std::size_t m_line = 0;
    std::size_t m_vertices = 0;
    std::vector<bool> m_used;
};

} // namespace

Result<void> checkObj(std::string_view bytes)
{
    ObjWalk walk;
    for (std::string_view rest = bytes; !rest.empty();)
        if (auto good = walk.line(takeLine(rest)); !good)
            return good;
    return walk.end(bytes.ends_with('\n'));
}

} // namespace carina
