#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

namespace carina::whole_sessions_test
{
namespace
{

constexpr int kFoundWithin_ms = 5'000;
const QString kAdult = QStringLiteral("builtin-adult-12");

QString valueOf(const Program& program, const char* key)
{
    return program.shown()[QLatin1String{key}].toString();
}

bool isAtWork(const Program& program)
{
    return valueOf(program, "phase") == QStringLiteral("running");
}

} // namespace

/// Sessions from their beginning to the end and the next, by the console's own controls; and those
/// who were in one and wait for it.
class TestWholeSessions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_console =
            std::make_unique<Program>(QStringLiteral(CARINA_INSTRUCTOR),
                                      QStringList{QStringLiteral("--data"), inFolder("host"),
                                                  QStringLiteral("--codes"), inFolder("codes")},
                                      inFolder("console.jsonl"));
    }

    void cleanup()
    {
        m_trainee.reset();
        m_console.reset();
    }

    /// By the start page: a session with an adult; it ends; another one begins.
    void beginsEndsAndBeginsAnother()
    {
        m_console->start(
            {QStringLiteral("--start-page"), QStringLiteral("--script"), inFolder("script")});
        work("type name Ward 3\nchoose patient Man of 30 years, 175 cm\npress begin\n"
             "press start\n");
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(*m_console), kPatience_ms);
        QCOMPARE(valueOf(*m_console, "anatomy"), kAdult);
        const QString first = valueOf(*m_console, "session_id");
        work(
            "press end\npause 1\npress end\npress another\nchoose patient Man of 30 years, 175 cm\n"
            "press begin\npress start\n");
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(*m_console) && valueOf(*m_console, "session_id") != first,
                                 kPatience_ms);
    }

    /// Started again without naming a patient.
    void resumedSessionKeepsItsPatient()
    {
        m_console->start(
            {QStringLiteral("--patient"), QStringLiteral("adult"), QStringLiteral("--start")});
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(*m_console), kPatience_ms);
        const QString session = valueOf(*m_console, "session_id");
        m_console->kill();
        m_console->start({QStringLiteral("--port"), QStringLiteral("0")});
        QTRY_VERIFY_WITH_TIMEOUT(!m_console->shown().isEmpty(), kPatience_ms);
        QCOMPARE(valueOf(*m_console, "session_id"), session);
        QCOMPARE(m_console->shownFirst()[QStringLiteral("anatomy")].toString(), kAdult);
    }

    /// The console is killed, and comes back at a port that nobody was told of.
    void traineeFindsTheConsoleAtAnotherPort()
    {
        const QString port = portOfThisTest();
        m_console->start({QStringLiteral("--start"), QStringLiteral("--port"), port});
        startTrainee(port);
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(*m_trainee) && isAtWork(*m_console), kPatience_ms);
        m_console->kill();
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(*m_trainee, "notice").contains(QStringLiteral("Connecting")), kPatience_ms);
        m_console->start({QStringLiteral("--port"), QStringLiteral("0")});
        QTRY_VERIFY_WITH_TIMEOUT(!m_console->shown().isEmpty(), kPatience_ms);
        QElapsedTimer waited;
        waited.start();
        QTRY_VERIFY_WITH_TIMEOUT(
            !valueOf(*m_trainee, "notice").contains(QStringLiteral("Connecting")), kPatience_ms);
        QVERIFY2(waited.elapsed() < kFoundWithin_ms, qPrintable(QString::number(waited.elapsed())));
        QTRY_COMPARE_WITH_TIMEOUT(m_trainee->shown()[QStringLiteral("facts")],
                                  m_console->shown()[QStringLiteral("facts")], kPatience_ms);
    }

    /// It ends for everyone; who was in it is offered another one.
    void traineeOfAnEndedSessionIsOfferedAnother()
    {
        const QString port = portOfThisTest();
        m_console->start({QStringLiteral("--start"), QStringLiteral("--port"), port,
                          QStringLiteral("--script"), inFolder("script")});
        startTrainee(port);
        QTRY_VERIFY_WITH_TIMEOUT(isAtWork(*m_trainee) && isAtWork(*m_console), kPatience_ms);
        work("press end\npause 1\npress end\n");
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(*m_trainee, "notice").contains(QStringLiteral("join another")), kPatience_ms);
        m_console->kill();
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(*m_trainee, "notice").contains(QStringLiteral("join another")), kPatience_ms);
    }

private:
    [[nodiscard]] QString inFolder(const char* name) const
    {
        return m_folder->filePath(QLatin1String{name});
    }
    void work(const QByteArray& lines) const
    {
        QFile script{inFolder("script")};
        QVERIFY(script.open(QIODevice::Append));
        script.write(lines);
    }
    void startTrainee(const QString& port)
    {
        m_trainee = std::make_unique<Program>(
            QStringLiteral(CARINA_TRAINEE),
            QStringList{QStringLiteral("--port"), port, QStringLiteral("--as"),
                        QStringLiteral("Tom"), QStringLiteral("--tracker"),
                        QStringLiteral("simulated"), QStringLiteral("--data"), inFolder("tom"),
                        QStringLiteral("--code-file"), inFolder("codes")},
            inFolder("tom.jsonl"));
        m_trainee->start();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Program> m_console;
    std::unique_ptr<Program> m_trainee;
};

CARINA_TEST(TestWholeSessions)

} // namespace carina::whole_sessions_test

#include "tst_whole_sessions.moc"
