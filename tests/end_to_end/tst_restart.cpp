#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QTemporaryDir>

namespace carina::restart_test
{

namespace
{

constexpr int kBackWithin_ms = 2'000;
constexpr double kSameClock_ms = 5.0;

double sessionLessLocal_ms(const QJsonObject& line)
{
    return 1e-6
           * double(line[QStringLiteral("session_ns")].toInteger()
                    - line[QStringLiteral("local_ns")].toInteger());
}

/// Everything in a journal's line that both programs must agree on: each has frames of its own, and
/// a console has no notice.
QJsonObject stateOf(QJsonObject line)
{
    for (const char* moving :
         {"local_ns", "session_ns", "right_lung_ml", "left_lung_ml", "notice", "frames"})
        line.remove(QLatin1String{moving});
    return line;
}

} // namespace

/// The two programs as people start them, killed without warning and started again.
class TestRestart : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        const QString port = portOfThisTest();
        const QStringList common{QStringLiteral("--port"), port, QStringLiteral("--patient"),
                                 QStringLiteral("child")};
        m_instructor = std::make_unique<Program>(
            QStringLiteral(CARINA_INSTRUCTOR),
            common
                + QStringList{QStringLiteral("--data"), m_folder->path(), QStringLiteral("--codes"),
                              m_folder->filePath(QStringLiteral("codes"))},
            m_folder->filePath(QStringLiteral("instructor.jsonl")));
        m_trainee = std::make_unique<Program>(
            QStringLiteral(CARINA_TRAINEE),
            common
                + QStringList{QStringLiteral("--as"), QStringLiteral("Trainee"),
                              QStringLiteral("--tracker"), QStringLiteral("simulated"),
                              QStringLiteral("--data"), m_folder->path(),
                              QStringLiteral("--code-file"),
                              m_folder->filePath(QStringLiteral("codes"))},
            m_folder->filePath(QStringLiteral("trainee.jsonl")));
        m_instructor->start({QStringLiteral("--start")});
        m_trainee->start();
        QTRY_VERIFY_WITH_TIMEOUT(bothAgree(), kPatience_ms);
    }

    void cleanup()
    {
        m_trainee.reset();
        m_instructor.reset();
    }

    void traineeComesBackToTheSameSession()
    {
        const QString session = m_instructor->shown()[QStringLiteral("session_id")].toString();
        m_trainee->kill();
        const qint64 before = m_instructor->shown()[QStringLiteral("session_ns")].toInteger();
        QTRY_VERIFY_WITH_TIMEOUT(
            m_instructor->shown()[QStringLiteral("session_ns")].toInteger() > before, kPatience_ms);
        m_trainee->start();
        comesBack(*m_trainee);
        QVERIFY(bothAgree());
        QCOMPARE(m_trainee->shown()[QStringLiteral("session_id")].toString(), session);
    }

    void traineeGoesOnWithoutTheInstructorWhoResumes()
    {
        const QJsonObject lastTold = m_trainee->shown();
        m_instructor->kill();
        // The trainee's lungs go on breathing by what was decided before.
        const qint64 second = 1'000'000'000;
        const qint64 from = m_trainee->shown()[QStringLiteral("session_ns")].toInteger();
        QTRY_VERIFY_WITH_TIMEOUT(m_trainee->shown()[QStringLiteral("session_ns")].toInteger()
                                     > from + second,
                                 kPatience_ms);
        QCOMPARE(m_trainee->shown()[QStringLiteral("phase")].toString(), QStringLiteral("running"));

        m_instructor->start();
        comesBack(*m_instructor);
        QVERIFY(bothAgree());
        QCOMPARE(m_instructor->shown()[QStringLiteral("session_id")],
                 lastTold[QStringLiteral("session_id")]);
        QVERIFY(std::abs(sessionLessLocal_ms(m_instructor->shown()) - sessionLessLocal_ms(lastTold))
                < kSameClock_ms);
    }

    /// The store is deleted while the session goes on; the host is killed and started again.
    void sessionOutlivesItsDeletedFile()
    {
        QDir folder{m_folder->path()};
        const QStringList stores{QStringLiteral("session-*.sqlite*")};
        const QStringList before = folder.entryList(stores);
        const QJsonValue session = m_instructor->shown()[QStringLiteral("session_id")];
        for (const QString& file : before)
            QVERIFY(folder.remove(file));
        QTRY_VERIFY_WITH_TIMEOUT(!folder.entryList(stores).isEmpty(), kBackWithin_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            !folder.entryList({QStringLiteral("session-*_2.secrets")}).isEmpty(), kBackWithin_ms);
        const qint64 facts = m_instructor->shown()[QStringLiteral("facts")].toInteger();
        m_instructor->kill();
        m_instructor->start();
        comesBack(*m_instructor);
        QCOMPARE(m_instructor->shown()[QStringLiteral("session_id")], session);
        QVERIFY(m_instructor->shown()[QStringLiteral("facts")].toInteger() > facts);
        QVERIFY(m_trainee->shown()[QStringLiteral("session_id")] == session);
    }

    /// From an icon nobody reads stderr: a damaged store is said in a window that waits.
    void damagedStoreIsSaidInAWindow_data()
    {
        QTest::addColumn<bool>("attended");
        QTest::newRow("from an icon") << true;
        QTest::newRow("from a script") << false;
    }
    void damagedStoreIsSaidInAWindow()
    {
        QFETCH(const bool, attended);
        const QTemporaryDir data;
        QFile empty{data.filePath(QStringLiteral("session-20260101-000000-000.sqlite"))};
        QVERIFY(empty.open(QIODevice::WriteOnly));
        QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
        around.remove(QStringLiteral("CARINA_UNATTENDED"));
        if (!attended)
            around.insert(QStringLiteral("CARINA_UNATTENDED"), QStringLiteral("1"));
        QProcess instructor;
        instructor.setProcessEnvironment(around);
        instructor.start(QStringLiteral(CARINA_INSTRUCTOR),
                         {QStringLiteral("--patient"), QStringLiteral("child"),
                          QStringLiteral("--data"), data.path()});
        QVERIFY(instructor.waitForStarted(kPatience_ms));
        QByteArray said;
        QTRY_VERIFY_WITH_TIMEOUT(
            (said += instructor.readAllStandardError()).contains("it is empty"), kPatience_ms);
        // It may have ended while its words were read.
        const bool hasEnded = instructor.state() == QProcess::NotRunning
                              || instructor.waitForFinished(kBackWithin_ms);
        QCOMPARE(hasEnded, !attended);
        if (hasEnded)
            QCOMPARE(instructor.exitCode(), 1);
        instructor.kill();
        QVERIFY(instructor.waitForFinished() || hasEnded);
        QCOMPARE(empty.size(), qint64{0});
    }

    void whoIsRefusedFailsToMeasure()
    {
        Program stranger{QStringLiteral(CARINA_TRAINEE),
                         {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--patient"),
                          QStringLiteral("child"), QStringLiteral("--as"),
                          QStringLiteral("Stranger"), QStringLiteral("--data"),
                          m_folder->filePath(QStringLiteral("stranger")), QStringLiteral("--code"),
                          QStringLiteral("AAAAA-BBBBB"), QStringLiteral("--measure"),
                          m_folder->filePath(QStringLiteral("measured")),
                          QStringLiteral("--seconds"), QStringLiteral("3")},
                         m_folder->filePath(QStringLiteral("stranger.jsonl"))};
        stranger.start();
        QTRY_VERIFY_WITH_TIMEOUT(stranger.hasEnded(), kPatience_ms);
        QCOMPARE(stranger.exitCode(), 1);
    }

private:
    [[nodiscard]] bool bothAgree() const
    {
        const QJsonObject instructor = m_instructor->shown();
        const QJsonObject trainee = m_trainee->shown();
        return instructor[QStringLiteral("phase")].toString() == QStringLiteral("running")
               && stateOf(instructor) == stateOf(trainee)
               && std::abs(sessionLessLocal_ms(instructor) - sessionLessLocal_ms(trainee))
                      < kSameClock_ms;
    }

    /// Both show the same within two seconds of the program's first picture of a session.
    void comesBack(const Program& program)
    {
        QTRY_VERIFY_WITH_TIMEOUT(!program.shown().isEmpty(), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(bothAgree(), kBackWithin_ms);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Program> m_instructor;
    std::unique_ptr<Program> m_trainee;
};

CARINA_TEST(TestRestart)

} // namespace carina::restart_test

#include "tst_restart.moc"
