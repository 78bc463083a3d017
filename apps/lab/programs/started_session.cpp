#include "apps/lab/programs/started_session.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/entry/psk_identity.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QThread>
#include <QUdpSocket>

namespace carina::lab
{
namespace
{

constexpr Duration kPatience = std::chrono::seconds{60};
constexpr unsigned long kWaitTurn_ms = 20;

std::uint16_t freePort()
{
    QUdpSocket probe;
    probe.bind(QHostAddress::LocalHost);
    return probe.localPort();
}

} // namespace

bool waitFor(const std::function<bool()>& holds)
{
    const LocalTime deadline = monotonicNow() + kPatience;
    while (!holds() && monotonicNow() < deadline) {
        QCoreApplication::processEvents();
        QThread::msleep(kWaitTurn_ms);
    }
    return holds();
}

SessionPrograms SessionPrograms::in(const QString& folder)
{
    const QDir programs{
        folder.isEmpty() ? QCoreApplication::applicationDirPath() + QStringLiteral("/..") : folder};
    return {.console = programs.filePath(QStringLiteral("instructor/carina-instructor")),
            .trainee = programs.filePath(QStringLiteral("trainee/carina-trainee"))};
}

StartedSession::StartedSession()
    : m_port{freePort()}, m_codesFile{m_folder.filePath(QStringLiteral("codes"))}
{
}

Result<std::unique_ptr<StartedSession>> StartedSession::start(const SessionPrograms& programs)
{
    for (const QString& program : {programs.console, programs.trainee})
        if (!QFile::exists(program))
            return fail(Errc::FileNotFound, program.toStdString());
    std::unique_ptr<StartedSession> session{new StartedSession};
    session->run("console", programs.console,
                 {QStringLiteral("--new"), QStringLiteral("--start"), QStringLiteral("--codes"),
                  session->m_codesFile});
    if (const auto read = session->readCodes(); !read)
        return tl::unexpected(read.error());
    session->run("trainee", programs.trainee,
                 {QStringLiteral("--as"), QString::fromLatin1(kTrainee),
                  QStringLiteral("--tracker"), QStringLiteral("simulated"),
                  QStringLiteral("--code-file"), session->m_codesFile});
    return session;
}

std::optional<Error> StartedSession::fault() const
{
    for (const auto& program : m_programs)
        if (program->hasEnded())
            return Error{Errc::HostSilent, "the " + program->name() + " ended before the time"};
    return std::nullopt;
}

Result<std::vector<FactRecord>> StartedSession::end()
{
    m_programs.clear();
    const QDir folder{m_folder.path()};
    const QStringList stores = folder.entryList({QStringLiteral("session-*.sqlite")}, QDir::Files);
    if (stores.isEmpty())
        return fail(Errc::FileNotFound,
                    folder.filePath(QStringLiteral("session-*.sqlite")).toStdString());
    auto store = openFactStore(folder.filePath(stores.first()).toStdString());
    return store ? (*store)->load() : tl::unexpected(store.error());
}

void StartedSession::run(const char* name, const QString& program, const QStringList& more)
{
    const QStringList words{program, QStringLiteral("--port"), QString::number(m_port),
                            QStringLiteral("--data"), m_folder.path()};
    m_programs.push_back(std::make_unique<WatchedProgram>(name, words + more));
}

Result<void> StartedSession::readCodes()
{
    const bool isOver = waitFor([&] { return QFile::exists(m_codesFile) || fault(); });
    if (const auto ended = fault(); ended || !isOver)
        return tl::unexpected(ended ? *ended : Error{Errc::HostSilent, "the console is silent"});
    const auto text = readWholeFile(m_codesFile.toStdString(), kCredentialLimit);
    if (!text)
        return tl::unexpected(text.error());
    for (const QString& line : QString::fromStdString(*text).split(QLatin1Char('\n'))) {
        const auto role = roleOfWord(line.section(QLatin1Char(' '), 0, 0).toStdString());
        const auto code = JoinCode::parse(line.section(QLatin1Char(' '), 1).toStdString());
        if (role && code)
            m_codes.emplace(*role, *code);
    }
    return {};
}

} // namespace carina::lab
