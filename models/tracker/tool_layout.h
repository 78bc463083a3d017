#pragma once

#include "engine/core/result.h"
#include "engine/tracking/ndi/tool_definition.h"

#include <QObject>

#include <filesystem>
#include <optional>
#include <vector>

namespace carina
{

/// The markers of a tool definition of NDI (.rom) while a person looks at them and moves them.
/// Every move can be undone; the file that was opened is never written to.
class ToolLayout : public QObject
{
    Q_OBJECT

public:
    /// @pre not isChanged(): what was moved would be lost.
    /// @returns the errors of readToolDefinition; what was open before stays.
    [[nodiscard]] Result<void> open(const std::filesystem::path& file);
    [[nodiscard]] bool isOpen() const { return !m_states.empty(); }
    /// "8700340, pointer, in 8700340.rom"; empty while nothing is open.
    [[nodiscard]] QString title() const;

    /// In the frame of the tool, millimetres.
    [[nodiscard]] std::vector<Vec3> markers_mm() const;
    /// @pre there is such a marker.
    /// @returns the errors of NdiToolDefinition::withMarker.
    [[nodiscard]] Result<void> move(std::size_t marker, const Vec3& p_mm);

    [[nodiscard]] bool canUndo() const { return m_at > 0; }
    [[nodiscard]] bool canRedo() const { return m_at + 1 < m_states.size(); }
    void undo();
    void redo();
    /// Whether something was moved that is in no file.
    [[nodiscard]] bool isChanged() const { return m_at != m_stored; }

    /// @pre isOpen().
    /// @returns FileUnwritable, also where there is such a file already: none is replaced.
    [[nodiscard]] Result<void> saveAs(const std::filesystem::path& file);

Q_SIGNALS:
    void changed();

private:
    std::filesystem::path m_file;
    std::vector<NdiToolDefinition> m_states; ///< one after another move
    std::size_t m_at = 0;                    ///< the present one
    std::size_t m_stored = 0;                ///< the one in the file; none once it was undone
};

} // namespace carina
