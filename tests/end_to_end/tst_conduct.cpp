#include "models/errors/error_text.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::conduct_test
{

namespace
{

constexpr int kSoon_ms = 10'000;

QString noticeOf(const Program& program)
{
    return program.shown()[QStringLiteral("notice")].toString();
}

} // namespace

/// What an instructor decides about who takes part, by the controls of the console, as a trainee's
/// program shows it.
class TestConduct : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        const QString script = m_folder.filePath(QStringLiteral("script"));
        m_script.setFileName(script);
        QVERIFY(m_script.open(QIODevice::WriteOnly));
        m_console = std::make_unique<Program>(
            QStringLiteral(CARINA_INSTRUCTOR),
            common()
                + QStringList{QStringLiteral("--data"), folder(QStringLiteral("console")),
                              QStringLiteral("--codes"), codes(), QStringLiteral("--start"),
                              QStringLiteral("--script"), script},
            m_folder.filePath(QStringLiteral("console.jsonl")));
        m_console->start();
        QTRY_VERIFY_WITH_TIMEOUT(!m_console->shown().isEmpty(), kPatience_ms);
    }

    void init()
    {
        m_anna = trainee(QStringLiteral("Anna"));
        m_anna->start({QStringLiteral("--tracker"), QStringLiteral("simulated")});
        QTRY_COMPARE_WITH_TIMEOUT(phaseOf(*m_anna), QStringLiteral("running"), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(noticeOf(*m_anna), QString{}, kSoon_ms);
        work("choose table Anna");
    }
    void cleanup() { m_anna.reset(); }
    void cleanupTestCase() { m_console.reset(); }

    void mutedTraineeReadsThatItIs()
    {
        work("press mute");
        QTRY_COMPARE_WITH_TIMEOUT(noticeOf(*m_anna), errorText({Errc::Muted, {}}), kSoon_ms);
        work("press mute");
        QTRY_COMPARE_WITH_TIMEOUT(noticeOf(*m_anna), QString{}, kSoon_ms);
    }

    void removedTraineeReadsWhyAndCanComeAgain()
    {
        work("press remove");
        work("type reason too loud");
        work("press remove");
        QTRY_VERIFY_WITH_TIMEOUT(noticeOf(*m_anna).contains(QStringLiteral("too loud")), kSoon_ms);
        QCOMPARE(statusOfComingIn(QStringLiteral("Anna")), 0);
    }

    void bannedTraineeIsOutUntilLetBack()
    {
        work("press remove");
        work("press forGood");
        work("press remove");
        QTRY_VERIFY_WITH_TIMEOUT(!noticeOf(*m_anna).isEmpty(), kSoon_ms);
        work("press keep"); // a new code is offered
        m_anna.reset();
        QCOMPARE(statusOfComingIn(QStringLiteral("Anna")), 1);
        work("choose table Anna");
        work("press remove"); // lets back
        QTRY_COMPARE_WITH_TIMEOUT(statusOfComingIn(QStringLiteral("Anna")), 0, kPatience_ms);
    }

    void lockedSessionTakesNobodyNew()
    {
        const qint64 before = factsOf(*m_anna);
        work("press lock");
        QTRY_VERIFY_WITH_TIMEOUT(factsOf(*m_anna) > before, kSoon_ms);
        QCOMPARE(statusOfComingIn(QStringLiteral("Ben")), 1);
        QCOMPARE(noticeOf(*m_anna), QString{}); // who is in stays
        m_anna->kill();
        m_anna->start({QStringLiteral("--tracker"), QStringLiteral("simulated")}); // or comes back
        QTRY_COMPARE_WITH_TIMEOUT(noticeOf(*m_anna), QString{}, kPatience_ms);
        work("press lock");
        QTRY_COMPARE_WITH_TIMEOUT(statusOfComingIn(QStringLiteral("Ben")), 0, kPatience_ms);
    }

private:
    static QString phaseOf(const Program& program)
    {
        return program.shown()[QStringLiteral("phase")].toString();
    }
    static qint64 factsOf(const Program& program)
    {
        return program.shown()[QStringLiteral("facts")].toInteger();
    }

    /// Appends a line to the console's script.
    void work(const char* line)
    {
        m_script.write(line);
        m_script.write("\n");
        QVERIFY(m_script.flush());
    }

    /// Comes in, looks for two seconds and leaves. @returns the exit status
    int statusOfComingIn(const QString& name)
    {
        const auto program = trainee(name);
        program->start({QStringLiteral("--measure"), folder(QStringLiteral("measured")),
                        QStringLiteral("--seconds"), QStringLiteral("2")});
        return QTest::qWaitFor([&] { return program->hasEnded(); }, kPatience_ms)
                   ? program->exitCode()
                   : -1;
    }

    std::unique_ptr<Program> trainee(const QString& name)
    {
        return std::make_unique<Program>(
            QStringLiteral(CARINA_TRAINEE),
            common()
                + QStringList{QStringLiteral("--as"), name, QStringLiteral("--data"), folder(name),
                              QStringLiteral("--code-file"), codes()},
            m_folder.filePath(QStringLiteral("%1.jsonl").arg(++m_started))); // no old one's
    }

    static QStringList common()
    {
        return {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--patient"),
                QStringLiteral("child")};
    }
    [[nodiscard]] QString folder(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] QString codes() const { return m_folder.filePath(QStringLiteral("codes")); }

    QTemporaryDir m_folder;
    QFile m_script;
    std::unique_ptr<Program> m_console;
    std::unique_ptr<Program> m_anna;
    int m_started = 0; ///< trainees
};

CARINA_TEST(TestConduct)

} // namespace carina::conduct_test

#include "tst_conduct.moc"
