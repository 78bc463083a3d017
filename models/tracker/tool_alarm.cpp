#include "models/tracker/tool_alarm.h"

namespace carina
{

bool isNeeded(ToolRole role, ToolUse use)
{
    switch (role) {
    case ToolRole::Stylus:
        return use == ToolUse::Registration;
    case ToolRole::Jaw:
    case ToolRole::Manikin:
        return true;
    case ToolRole::Head:
    case ToolRole::Tube:
    case ToolRole::Chest:
    case ToolRole::Hand:
    case ToolRole::Laryngoscope:
        return use == ToolUse::Session;
    case ToolRole::Other:
        break;
    }
    return false;
}

ToolAlarm::Change ToolAlarm::look(const std::vector<ToolStatus>& tools)
{
    Change change;
    for (const ToolStatus& tool : tools) {
        const auto known = m_unseen.find(tool.name);
        if (tool.isVisible) {
            const int unseen = known == m_unseen.end() ? 0 : known->second;
            m_unseen[tool.name] = 0;
            if (unseen < kLooksUntilLost)
                continue;
            change.back += tool.name;
            change.returnsNeeded = change.returnsNeeded || isNeeded(tool.role, m_use);
        } else if (known != m_unseen.end() && ++known->second == kLooksUntilLost) {
            change.lost += tool.name;
            change.losesNeeded = change.losesNeeded || isNeeded(tool.role, m_use);
        }
    }
    return change;
}

} // namespace carina
