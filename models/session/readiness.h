#pragma once

#include "engine/core/external_time.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <vector>

namespace carina
{

class PatientModel;

/// One thing that a session depends on, and how it stands.
struct ReadyLine {
    QString name{};
    /// A sentence behind its mark: ✓ ready, ○ not there and not needed, or not asked yet, ▲ look.
    QString state{};

    friend bool operator==(const ReadyLine&, const ReadyLine&) = default;
};

/// What is looked at.
struct ReadinessQuestion {
    QString site{};                        ///< file of the wizard; empty: none
    QString folder{};                      ///< that sessions are stored in
    const PatientModel* patient = nullptr; ///< the session's; null while it is made
    QDateTime today{};
};

/// Whether a time service sets the clock of this computer, and how well.
/// @param external as readDisciplinedClock() has it
[[nodiscard]] QString timeServiceText(const std::optional<ExternalTime>& external);

/// Tracker, registration with its error and age, disk and clock of this computer.
[[nodiscard]] std::vector<ReadyLine> readiness(const ReadinessQuestion& asked);

} // namespace carina
