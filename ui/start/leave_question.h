#pragma once

#include <QString>

#include <cstdint>

class QWidget;

namespace carina
{

enum class Leaving : std::uint8_t {
    Stay,
    CloseForNow,
    ToStartPage, ///< closed, too
    EndForAll
};

/// Asks what is to become of a session whose window is being closed.
/// @param whoLosesWhat as leavingText says it @param canEnd whether it can be ended
[[nodiscard]] Leaving askBeforeLeaving(const QString& whoLosesWhat, bool canEnd, QWidget* parent);

} // namespace carina
