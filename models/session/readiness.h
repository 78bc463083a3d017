#pragma once

#include <QDateTime>
#include <QString>

#include <vector>

namespace carina
{

class PatientModel;

/// One thing that a session depends on, and how it stands.
struct ReadyLine {
    QString name{};
    QString state{}; ///< a sentence behind its mark: ✓ ready, ○ not there and not needed, ▲ look

    friend bool operator==(const ReadyLine&, const ReadyLine&) = default;
};

/// What is looked at.
struct ReadinessQuestion {
    QString site{};                        ///< file of the wizard; empty: none
    QString folder{};                      ///< that sessions are stored in
    const PatientModel* patient = nullptr; ///< the session's; null while it is made
    QDateTime today{};
};

/// Tracker, registration with its error and age, disk and clock of this computer.
[[nodiscard]] std::vector<ReadyLine> readiness(const ReadinessQuestion& asked);

} // namespace carina
