#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

namespace carina::ways_back_test
{
namespace
{

constexpr int kFoundWithin_ms = 5'000;
const QByteArray kBegin = "choose patient Man of 30 years, 175 cm\npress begin\npress start\n";
/// The second press, after a pause, is meant.
const QByteArray kEnd = "press end\npause 1\npress end\n";

QString valueOf(const Program& program, const char* key)
{
    return program.shown()[QLatin1String{key}].toString();
}

bool isRunning(const Program& program)
{
    return valueOf(program, "phase") == QStringLiteral("running");
}

QString sessionOf(const Program& program) { return valueOf(program, "session_id"); }

/// A program with a script that works its controls.
struct Worked {
    Worked(const QTemporaryDir& folder, const char* path, const QString& name,
           const QStringList& arguments)
        : script{folder.filePath(name + QStringLiteral(".script"))},
          program{QLatin1String{path},
                  arguments
                      + QStringList{QStringLiteral("--data"), folder.filePath(name),
                                    QStringLiteral("--script"), script},
                  folder.filePath(name + QStringLiteral(".jsonl"))}
    {
    }
    void work(const QByteArray& lines) const
    {
        QFile file{script};
        QVERIFY(file.open(QIODevice::Append));
        file.write(lines);
    }

    QString script;
    Program program;
};

} // namespace

/// From one session into another, and back into one from which a program was cut off.
class TestWaysBack : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_console =
            std::make_unique<Worked>(*m_folder, CARINA_INSTRUCTOR, QStringLiteral("console"),
                                     QStringList{QStringLiteral("--codes"), codes()});
        m_trainee = std::make_unique<Worked>(*m_folder, CARINA_TRAINEE, QStringLiteral("tom"),
                                             QStringList{});
    }

    void cleanup()
    {
        m_trainee.reset();
        m_console.reset();
    }

    /// Closed to the start page, a session goes on later, with its trainee, and another one did
    /// meanwhile.
    void consoleGoesBackToTheStartPageAndResumes()
    {
        QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
        around.remove(QStringLiteral("CARINA_UNATTENDED")); // somebody answers what it asks
        m_console->program.setEnvironment(around);
        m_console->program.start({QStringLiteral("--start-page")});
        m_console->work("type name Ward 3\n" + kBegin);
        QTRY_VERIFY_WITH_TIMEOUT(isRunning(m_console->program), kPatience_ms);
        const QString first = sessionOf(m_console->program);
        joinByWindow();
        QTRY_COMPARE_WITH_TIMEOUT(sessionOf(m_trainee->program), first, kPatience_ms);

        m_console->work("close\npress toStartPage\ntype name Ward 4\n" + kBegin);
        QTRY_VERIFY_WITH_TIMEOUT(
            isRunning(m_console->program) && sessionOf(m_console->program) != first, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isAlone(), kPatience_ms);
        m_console->work("close\npress toStartPage\nchoose earlier Ward 3\npress resume\n");
        QTRY_COMPARE_WITH_TIMEOUT(sessionOf(m_console->program), first, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!isAlone(), kFoundWithin_ms);
        QTRY_VERIFY_WITH_TIMEOUT(seesTheSame(), kPatience_ms);
    }

    /// The session ended; the console begins another one, and the trainee joins that.
    void traineeJoinsAnotherSession()
    {
        m_console->program.start({QStringLiteral("--start-page")});
        m_console->work(kBegin);
        QTRY_VERIFY_WITH_TIMEOUT(isRunning(m_console->program), kPatience_ms);
        joinByWindow();
        QTRY_VERIFY_WITH_TIMEOUT(seesTheSame(), kPatience_ms);
        const QString first = sessionOf(m_console->program);
        const QByteArray before = traineesCode();

        m_console->work(kEnd);
        QTRY_VERIFY_WITH_TIMEOUT(
            valueOf(m_trainee->program, "notice").contains(QStringLiteral("join another")),
            kPatience_ms);
        m_trainee->work("press another\n");
        m_console->work("press another\n" + kBegin);
        QTRY_VERIFY_WITH_TIMEOUT(
            isRunning(m_console->program) && sessionOf(m_console->program) != first, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(traineesCode() != before, kPatience_ms);
        m_trainee->work("type code " + traineesCode() + "\npress join\n");
        QTRY_COMPARE_WITH_TIMEOUT(sessionOf(m_trainee->program), sessionOf(m_console->program),
                                  kPatience_ms);
        QVERIFY(!m_trainee->program.hasEnded());
    }

    /// Both are killed; the trainee's program is there first, by the same words but without a code.
    void startedAgainItFindsTheConsoleAtAnotherPort()
    {
        const QString port = portOfThisTest();
        const QStringList known{QStringLiteral("--port"), port, QStringLiteral("--as"),
                                QStringLiteral("Tom")};
        m_console->program.start({QStringLiteral("--start"), QStringLiteral("--port"), port,
                                  QStringLiteral("--add-station"), QStringLiteral("Room 5")});
        m_trainee->program.start(known
                                 + QStringList{QStringLiteral("--code-file"), codes(),
                                               QStringLiteral("--station"),
                                               QStringLiteral("Room 5")});
        QTRY_COMPARE_WITH_TIMEOUT(valueOf(m_trainee->program, "station"), QStringLiteral("Room 5"),
                                  kPatience_ms);
        killBoth();
        m_trainee->program.start(known);
        comesBack({});
        QCOMPARE(valueOf(m_trainee->program, "station"), QStringLiteral("Room 5"));
    }

    /// It was joined by its link, and nobody finds it by searching; from an icon the program has no
    /// words at all.
    void startedFromItsIconItFindsASessionThatIsJoinedByLink()
    {
        const QString port = portOfThisTest();
        m_console->program.start({QStringLiteral("--start"), QStringLiteral("--by-link"),
                                  QStringLiteral("--port"), port});
        m_trainee->program.start({QStringLiteral("--port"), port, QStringLiteral("--as"),
                                  QStringLiteral("Tom"), QStringLiteral("--code-file"), codes()});
        QTRY_VERIFY_WITH_TIMEOUT(seesTheSame(), kPatience_ms);
        killBoth();
        m_trainee->program.start();
        m_trainee->work("press join\n"); // everything else is filled in
        comesBack({QStringLiteral("--by-link")});
    }

private:
    [[nodiscard]] QString codes() const { return m_folder->filePath(QStringLiteral("codes")); }
    [[nodiscard]] QByteArray traineesCode() const
    {
        QFile file{codes()};
        if (!file.open(QIODevice::ReadOnly))
            return {};
        for (const QByteArray& line : file.readAll().split('\n'))
            if (line.startsWith("trainee "))
                return line.mid(8).trimmed();
        return {};
    }
    /// As somebody who has heard the code does, with the only session chosen already.
    void joinByWindow()
    {
        m_trainee->program.start({QStringLiteral("--tracker"), QStringLiteral("simulated")});
        m_trainee->work("type name Tom\ntype code " + traineesCode() + "\npress join\n");
    }
    [[nodiscard]] bool isAlone() const
    {
        return valueOf(m_trainee->program, "notice").contains(QStringLiteral("Connecting"))
               || valueOf(m_trainee->program, "notice").contains(QStringLiteral("does not answer"));
    }
    [[nodiscard]] bool seesTheSame() const
    {
        return isRunning(m_trainee->program)
               && m_trainee->program.shown()[QStringLiteral("facts")]
                      == m_console->program.shown()[QStringLiteral("facts")];
    }
    void killBoth()
    {
        m_session = sessionOf(m_trainee->program);
        m_trainee->program.kill();
        m_console->program.kill();
    }
    /// The console comes back at a port that nobody was told of, and the trainee is in its session.
    void comesBack(const QStringList& reach)
    {
        m_console->program.start(reach
                                 + QStringList{QStringLiteral("--port"), QStringLiteral("0")});
        QTRY_COMPARE_WITH_TIMEOUT(sessionOf(m_console->program), m_session, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(sessionOf(m_trainee->program), m_session, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(seesTheSame(), kPatience_ms);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Worked> m_console;
    std::unique_ptr<Worked> m_trainee;
    QString m_session;
};

CARINA_TEST(TestWaysBack)

} // namespace carina::ways_back_test

#include "tst_ways_back.moc"
