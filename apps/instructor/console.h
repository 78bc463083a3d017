#pragma once

#include "apps/instructor/console_session.h"
#include "apps/program/control_script.h"
#include "ui/start/end_page.h"
#include "ui/start/start_page.h"

#include <QObject>

namespace carina
{

/// The console for as long as its program runs: the start page, one session after another, and
/// after each what happened in it. One of the three is shown at a time.
class Console : public QObject
{
    Q_OBJECT

public:
    /// @pre the parser outlives this.
    Console(const QCommandLineParser& parser, ConsoleOptions options, ConsoleTracker tracker);
    ~Console() override;

    /// Begins with the start page, or at once with the session of the options.
    /// @returns the errors of making that session.
    [[nodiscard]] Result<void> begin();

    /// The session that is shown; null before the first and after an end.
    [[nodiscard]] ConsoleSession* session() { return m_session.get(); }

private:
    [[nodiscard]] Result<void> beginByOptions();
    void showStart();
    void import(const QString& folder);
    void beginNew(const SessionPlan& plan);
    void resume(const QString& file, SessionReach reach);
    [[nodiscard]] Result<void> host(const HostRequest& request,
                                    const std::optional<program::ChosenPatient>& laid);
    [[nodiscard]] Result<void> open(HostedSession hosted,
                                    const std::optional<program::ChosenPatient>& laid);
    void showEnd();
    void goToStart();
    void leaveStart();
    [[nodiscard]] QWidget& shown();

    const QCommandLineParser& m_parser;
    ConsoleOptions m_options;
    SessionPlan m_plan; ///< what was filled in last
    std::unique_ptr<StoredSessionsModel> m_stored;
    std::unique_ptr<PlannedPatient> m_patient;
    std::unique_ptr<StartPage> m_start;
    ConsoleTracker m_tracker;
    std::unique_ptr<ConsoleSession> m_session;
    std::unique_ptr<EndPage> m_end;
    std::unique_ptr<program::ControlScript> m_script;
};

} // namespace carina
