#include "engine/io/fact_store/sql_fact_store.h"
#include "models/session/session_model.h"
#include "models/session/stored_sessions.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>

namespace carina::stored_sessions_test
{
namespace
{

using test::ScratchFolder;
using test::soon;

const char* const kEarly = "session-20260102-101112-000.sqlite";
const char* const kLate = "session-20260103-101112-000.sqlite";

Result<AccessKey> noKey(const JoinCode&, const SessionKey&) { return AccessKey{}; }

std::unique_ptr<SessionNode> hostIn(const QString& file, const char* name)
{
    auto store = openFactStore(file.toStdString());
    if (!store)
        return nullptr;
    auto node = SessionNode::host({.sessionName = name, .participantName = "Ina", .derive = noKey},
                                  *std::move(store));
    return node ? *std::move(node) : nullptr;
}

/// Begins a session with an adult, and leaves it in this phase.
bool makeSession(const QString& file, const char* name, SessionPhase phase)
{
    const auto node = hostIn(file, name);
    if (!node)
        return false;
    node->propose(StationId{0}, fact::AnatomyChosen{"builtin-adult-12", "Adult"});
    node->propose(kNoStation, fact::PhaseChanged{SessionPhase::Running});
    if (phase != SessionPhase::Running)
        node->propose(kNoStation, fact::PhaseChanged{phase});
    return soon([&] {
        const auto now = node->now();
        return now && node->state()->phaseAt(*now) == phase;
    });
}

} // namespace

class TestStoredSessions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsWhatASessionWas()
    {
        const ScratchFolder folder;
        QVERIFY(makeSession(folder.filePath(kEarly), "Ward 3", SessionPhase::Paused));
        const StoredSession session = storedSession(folder.filePath(kEarly));
        QCOMPARE(session.name, QStringLiteral("Ward 3"));
        QCOMPARE(session.patient, QStringLiteral("Adult"));
        QCOMPARE(session.anatomyHash, std::string{"builtin-adult-12"});
        QCOMPARE(session.began, (QDateTime{{2026, 1, 2}, {10, 11, 12}, Qt::UTC}));
        QVERIFY(!session.hasEnded && session.fault.isEmpty() && session.people.isEmpty());
    }

    /// The last one first; one that has ended is not gone on with.
    void listsWhatCanBeResumed()
    {
        const ScratchFolder folder;
        QVERIFY(makeSession(folder.filePath(kEarly), "Early", SessionPhase::Paused));
        QVERIFY(makeSession(folder.filePath(kLate), "Late", SessionPhase::Running));
        QVERIFY(makeSession(folder.filePath("session-20260104-101112-000.sqlite"), "Over",
                            SessionPhase::Ended));
        StoredSessionsModel sessions{folder.path()};
        QVERIFY(soon([&] { return sessions.isComplete(); }));
        QCOMPARE(sessions.rowCount(), 2);
        QCOMPARE(sessions.at(0).name, QStringLiteral("Late"));
        QCOMPARE(sessions.at(1).name, QStringLiteral("Early"));
        QVERIFY(sessions.index(0).data().toString().contains(QStringLiteral("Late")));
        QVERIFY(sessions.flags(sessions.index(0)) & Qt::ItemIsSelectable);
    }

    /// However many ended since.
    void listsAllThatCanBeResumed()
    {
        const ScratchFolder folder;
        QVERIFY(makeSession(folder.filePath(kEarly), "Early", SessionPhase::Paused));
        const QString ended = folder.filePath("session-20260104-000000-000.sqlite");
        QVERIFY(makeSession(ended, "Over", SessionPhase::Ended));
        for (int day = 1; day < 30; ++day) {
            const QString name = QStringLiteral("session-202602%1-000000-000.sqlite")
                                     .arg(day, 2, 10, QLatin1Char{'0'});
            QVERIFY(QFile::copy(ended, QDir{folder.path()}.filePath(name)));
        }
        StoredSessionsModel sessions{folder.path()};
        QVERIFY(soon([&] { return sessions.isComplete(); }));
        QCOMPARE(sessions.rowCount(), 1);
        QCOMPARE(sessions.at(0).name, QStringLiteral("Early"));
    }

    /// What was to be begun could not be.
    void looksAnew()
    {
        const ScratchFolder folder;
        QVERIFY(makeSession(folder.filePath(kEarly), "Early", SessionPhase::Paused));
        StoredSessionsModel sessions{folder.path()};
        sessions.stop();
        QVERIFY(!sessions.isComplete());
        QVERIFY(makeSession(folder.filePath(kLate), "Late", SessionPhase::Running));
        sessions.read();
        QVERIFY(soon([&] { return sessions.isComplete(); }));
        QCOMPARE(sessions.rowCount(), 2); // each once
        sessions.read();
        QVERIFY(!sessions.isComplete());
        QVERIFY(soon([&] { return sessions.isComplete(); }));
        QCOMPARE(sessions.rowCount(), 2);
    }

    void keepsWhoCouldJoin()
    {
        const ScratchFolder folder;
        QVERIFY(makeSession(folder.filePath(kEarly), "Ward 3", SessionPhase::Running));
        QVERIFY(storedSession(folder.filePath(kEarly)).reach == SessionReach::ThisComputer);
        for (const SessionReach reach :
             {SessionReach::ByLink, SessionReach::Network, SessionReach::ThisComputer}) {
            keepReach(folder.filePath(kEarly), reach);
            QVERIFY(storedSession(folder.filePath(kEarly)).reach == reach);
        }
        folder.write("session-20260102-101112-000.reach", "everybody");
        QVERIFY(storedSession(folder.filePath(kEarly)).reach == SessionReach::ThisComputer);
    }

    void saysWhichOneIsDamaged()
    {
        const ScratchFolder folder;
        folder.write(kEarly, "no database");
        StoredSessionsModel sessions{folder.path()};
        QVERIFY(soon([&] { return sessions.isComplete(); }));
        QCOMPARE(sessions.rowCount(), 1);
        QVERIFY(!sessions.at(0).fault.isEmpty());
        QVERIFY(!(sessions.flags(sessions.index(0)) & Qt::ItemIsEnabled));
    }

    /// A file is open to one program at a time: afterwards the session can be hosted.
    void letsGoOfTheFiles()
    {
        const ScratchFolder folder;
        QVERIFY(makeSession(folder.filePath(kEarly), "Ward 3", SessionPhase::Running));
        StoredSessionsModel sessions{folder.path()};
        sessions.stop();
        QVERIFY(hostIn(folder.filePath(kEarly), "Ward 3"));
    }
};

CARINA_TEST(TestStoredSessions)

} // namespace carina::stored_sessions_test

#include "tst_stored_sessions.moc"
