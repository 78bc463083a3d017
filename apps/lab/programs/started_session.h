#pragma once

#include "apps/lab/programs/watched_program.h"
#include "engine/net/entry/join_code.h"
#include "engine/sync/facts/fact_record.h"

#include <QTemporaryDir>

#include <functional>
#include <memory>
#include <vector>

namespace carina::lab
{

/// The programs of a session, as files.
struct SessionPrograms {
    QString console;
    QString trainee;

    /// Those in a folder with instructor/carina-instructor and trainee/carina-trainee; where it is
    /// empty, those built with this program.
    [[nodiscard]] static SessionPrograms in(const QString& folder);
};

/// A session of its own on this computer, on loopback: a console that hosts and runs it, and a
/// trainee with a simulated tracker, each in its window. Both end with it.
class StartedSession
{
public:
    /// How the trainee is called.
    static constexpr const char* kTrainee = "Trainee";

    /// Starts both programs; they come in meanwhile.
    /// @returns FileNotFound for a program that there is not; HostSilent where the console does not
    ///          say its codes; errors of reading them.
    [[nodiscard]] static Result<std::unique_ptr<StartedSession>>
    start(const SessionPrograms& programs);

    [[nodiscard]] std::uint16_t port() const { return m_port; }
    [[nodiscard]] const JoinCodes& codes() const { return m_codes; }
    /// Console, then trainee.
    [[nodiscard]] const std::vector<std::unique_ptr<WatchedProgram>>& programs() const
    {
        return m_programs;
    }
    /// HostSilent for a program that has ended.
    [[nodiscard]] std::optional<Error> fault() const;
    /// Ends both programs. @returns the log that the console stored; the errors of reading it
    [[nodiscard]] Result<std::vector<FactRecord>> end();

private:
    StartedSession();

    void run(const char* name, const QString& program, const QStringList& more);
    [[nodiscard]] Result<void> readCodes();

    QTemporaryDir m_folder;
    std::uint16_t m_port;
    QString m_codesFile;
    JoinCodes m_codes;
    std::vector<std::unique_ptr<WatchedProgram>> m_programs;
};

/// Works the event loop until something holds, a minute at most. @returns whether it came to hold
[[nodiscard]] bool waitFor(const std::function<bool()>& holds);

} // namespace carina::lab
