#pragma once

#include "models/station/tool_status.h"

#include <QStringList>

#include <map>

namespace carina
{

/// What tools are used for.
enum class ToolUse : std::uint8_t {
    Session,      ///< intubating: all with a role but the stylus, which may lie anywhere
    Registration, ///< stylus, and the probes that chin and manikin wear
};

/// Whether a tool of this role is missed where it is not seen.
[[nodiscard]] bool isNeeded(ToolRole role, ToolUse use);

/// Which tools a tracker lost, and which are back. One that is hidden for a single look is not
/// lost, and one that was never seen cannot be.
class ToolAlarm
{
public:
    static constexpr int kLooksUntilLost = 2;

    /// What is new since the look before.
    struct Change {
        QStringList lost{};
        QStringList back{};
        bool losesNeeded = false;   ///< one of the lost is needed
        bool returnsNeeded = false; ///< one of those that are back is
    };

    explicit ToolAlarm(ToolUse use) : m_use{use} {}

    /// @param tools as they are seen at this look
    [[nodiscard]] Change look(const std::vector<ToolStatus>& tools);

private:
    ToolUse m_use;
    std::map<QString, int> m_unseen; ///< looks since a tool was seen, by name
};

} // namespace carina
