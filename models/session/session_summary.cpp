#include "models/session/session_summary.h"

#include <QCoreApplication>
#include <QStringList>

namespace carina
{
namespace
{

class SummaryWords
{
    Q_DECLARE_TR_FUNCTIONS(carina::SessionSummary)

public:
    static QString person(const Participant& who)
    {
        const QString name = QString::fromStdString(who.name);
        switch (who.role) {
        case Role::Instructor:
            return tr("%1 (instructor)").arg(name);
        case Role::Trainee:
            return name;
        case Role::Observer:
            return tr("%1 (observer)").arg(name);
        }
        return name;
    }
};

QStringList patientsOf(const SessionState& state)
{
    QStringList patients;
    for (const auto& [id, station] : state.stations())
        if (!station.anatomyName.empty())
            patients += SummaryWords::tr("%1: %2", "station: its patient")
                            .arg(QString::fromStdString(station.name),
                                 QString::fromStdString(station.anatomyName));
    return patients;
}

/// Who took part besides the one who tells; or only those who are there now.
QStringList othersIn(const SessionState& state, ParticipantId self, bool onlyPresent)
{
    QStringList others;
    for (const auto& [id, who] : state.participants())
        if (id != self && (who.present || !onlyPresent))
            others += SummaryWords::person(who);
    return others;
}

} // namespace

std::vector<SummaryLine> summaryOf(const SessionState& state, SessionTime now, ParticipantId self,
                                   const QString& file)
{
    const auto seconds = std::chrono::floor<std::chrono::seconds>(state.runningTime(now)).count();
    const QStringList others = othersIn(state, self, false);
    return {{SummaryWords::tr("Session"), QString::fromStdString(state.name())},
            {SummaryWords::tr("Patient"), patientsOf(state).join(QLatin1Char('\n'))},
            {SummaryWords::tr("Running time"),
             SummaryWords::tr("%1 min %2 s").arg(seconds / 60).arg(seconds % 60)},
            {SummaryWords::tr("Took part"), others.isEmpty() ? SummaryWords::tr("nobody but you")
                                                             : others.join(QStringLiteral(", "))},
            {SummaryWords::tr("Stored"), SummaryWords::tr("%n decisions and events, in %1", nullptr,
                                                          int(state.lastApplied().value))
                                             .arg(file)}};
}

QString leavingText(const SessionState& state, SessionTime now, ParticipantId self)
{
    const SessionPhase phase = state.phaseAt(now);
    const QStringList others = othersIn(state, self, true);
    const bool goesOn = phase == SessionPhase::Running || phase == SessionPhase::Paused;
    if (phase == SessionPhase::Ended || (!goesOn && others.isEmpty()))
        return {};
    const QString kept =
        SummaryWords::tr("All that was decided is stored, and the session can be resumed.");
    if (others.isEmpty())
        return SummaryWords::tr("Nobody else is in the session. %1").arg(kept);
    return SummaryWords::tr("%1: in the session without you. If you close this window and do not "
                            "end it, they see the patient go on as it is, nothing changes any "
                            "more, and they come back by themselves when you resume it. If you "
                            "end it, it is over for them. %2",
                            "names of those present")
        .arg(others.join(QStringLiteral(", ")), kept);
}

} // namespace carina
