#include "models/tracker/tool_layout.h"

#include "engine/core/expects.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/tracker_file.h"

#include <limits>

namespace carina
{
namespace
{

constexpr std::size_t kNoState = std::numeric_limits<std::size_t>::max();

} // namespace

Result<void> ToolLayout::open(const std::filesystem::path& file)
{
    CARINA_EXPECTS(!isChanged());
    auto read = readToolDefinition(file);
    if (!read)
        return tl::unexpected(read.error());
    m_file = file;
    m_states = {*std::move(read)};
    m_at = 0;
    m_stored = 0;
    Q_EMIT changed();
    return {};
}

QString ToolLayout::title() const
{
    if (!isOpen())
        return {};
    const NdiToolDefinition& tool = m_states[m_at];
    const QString part = QString::fromStdString(tool.partNumber());
    const QString kind = QString::fromStdString(kindName(tool.kind()));
    const QString file = QString::fromStdString(m_file.filename().string());
    return part.isEmpty()
               ? tr("%1 in %2", "kind of tool; file").arg(kind, file)
               : tr("%1, %2, in %3", "part number; kind of tool; file").arg(part, kind, file);
}

std::vector<Vec3> ToolLayout::markers_mm() const
{
    std::vector<Vec3> places;
    if (!isOpen())
        return places;
    for (const ToolMarker& marker : m_states[m_at].markers())
        places.push_back(
            marker.p_OQ.unaryExpr([](double length) { return inMillimetres(metres(length)); }));
    return places;
}

Result<void> ToolLayout::move(std::size_t marker, const Vec3& p_mm)
{
    auto moved = m_states.at(m_at).withMarker(
        marker, p_mm.unaryExpr([](double mm) { return millimetres(mm).si; }));
    if (!moved)
        return tl::unexpected(moved.error());
    if (moved->bytes() == m_states[m_at].bytes())
        return {};
    if (m_stored != kNoState && m_stored > m_at)
        m_stored = kNoState;
    m_states.erase(m_states.begin() + std::ptrdiff_t(m_at) + 1, m_states.end());
    m_states.push_back(*std::move(moved));
    ++m_at;
    Q_EMIT changed();
    return {};
}

void ToolLayout::undo()
{
    if (!canUndo())
        return;
    --m_at;
    Q_EMIT changed();
}

void ToolLayout::redo()
{
    if (!canRedo())
        return;
    ++m_at;
    Q_EMIT changed();
}

Result<void> ToolLayout::saveAs(const std::filesystem::path& file)
{
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored))
        return fail(Errc::FileUnwritable,
                    file.string() + ": there is such a file; choose another name");
    const auto& bytes = m_states.at(m_at).bytes();
    return writeWholeFile(
               file, std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()})
        .map([&] {
            m_file = file;
            m_stored = m_at;
            Q_EMIT changed();
        });
}

} // namespace carina
