#include "engine/io/files/confinement.h"

#include "engine/core/byte_buffer.h"
#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/io/mesh/surface_reader_exit.h"
#include "tests/engine/io/mesh/texture_files.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <array>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace carina::confinement_test
{
namespace
{

namespace fs = std::filesystem;

constexpr qint64 kMebibyte = 1 << 20;
constexpr qint64 kMemory = 256 * kMebibyte;
constexpr const char* kWithoutLandlock =
    "this kernel has no Landlock: what lies outside the folder is not kept from who was taken over";

/// How a program ended: its code, or the signal; and what it said.
struct End {
    bool bySignal = false;
    int code = 0;
    QByteArray words;
};

} // namespace

/// Programs that confine themselves and then try what they must not be able to do.
class TestConfinement final : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_temporary;
    fs::path m_outside;
    fs::path m_folder;

    QStringList arguments(const QString& deed, const QString& argument = QStringLiteral("-"),
                          int seconds = 20, qint64 parent = 0) const
    {
        return {QString::fromStdString(m_folder.string()),
                QString::number(kMemory),
                QString::number(seconds),
                QString::number(parent),
                deed,
                argument};
    }

    static End run(const QStringList& arguments)
    {
        QProcess program;
        program.start(QStringLiteral(CARINA_CONFINED), arguments);
        if (!program.waitForFinished(kPatience_ms))
            return {true, 0, "it did not end"};
        return {program.exitStatus() == QProcess::CrashExit, program.exitCode(),
                program.readAllStandardOutput()};
    }

    QString at(const char* name) const
    {
        return QString::fromStdString((m_folder / name).string());
    }

    static void request(QProcess& reader, const fs::path& file)
    {
        const std::string path = file.string();
        std::vector<std::byte> bytes;
        ByteWriter{bytes}.number(static_cast<std::uint64_t>(path.size()));
        reader.write(reinterpret_cast<const char*>(bytes.data()), qint64(bytes.size()));
        reader.write(path.data(), qint64(path.size()));
    }

    static Result<MeshFile> answerOf(QProcess& reader)
    {
        QByteArray answer;
        std::uint64_t length = 0;
        while (length == 0 || std::uint64_t(answer.size()) < sizeof length + length) {
            if (!reader.waitForReadyRead(kPatience_ms))
                return fail(Errc::Cancelled, "no answer");
            answer += reader.readAllStandardOutput();
            const auto bytes = std::as_bytes(std::span{answer.constData(), sizeof length});
            if (std::size_t(answer.size()) >= sizeof length)
                length = ByteReader{bytes}.number<std::uint64_t>();
        }
        const QByteArray message = answer.mid(sizeof length);
        auto decoded = decodeMeshFile(
            std::as_bytes(std::span{message.constData(), std::size_t(message.size())}));
        return decoded ? *decoded : tl::unexpected(decoded.error());
    }

    static QByteArray lineFrom(int pipe)
    {
        QByteArray line;
        for (char byte = 0; byte != '\n' && ::read(pipe, &byte, 1) == 1;)
            line += byte;
        return line;
    }

    /// Whether the last that could write into a pipe ends within the time.
    static bool endsWithin(int pipe, int patience_ms)
    {
        pollfd end{pipe, POLLIN, 0};
        return poll(&end, 1, patience_ms) == 1 && (end.revents & POLLHUP) != 0;
    }

    void startReader(QProcess& reader, qint64 parent, qint64 memory = kMemory) const
    {
        reader.start(QStringLiteral(CARINA_SURFACE_READER),
                     {QString::fromStdString(m_folder.string()), QString::number(memory),
                      QStringLiteral("20"), QString::number(parent)});
    }

private Q_SLOTS:
    void initTestCase()
    {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("a sanitizer needs what confinement takes away");
#endif
        m_outside = m_temporary.path().toStdString();
        m_folder = m_outside / "set";
        test::writeFile(m_folder / "inside.obj", test::objOf({}));
        test::writeFile(m_folder / "below" / "deep.obj", test::objOf({}));
        test::writeFile(m_outside / "outside.obj", test::objOf({}));
        fs::create_symlink("../outside.obj", m_folder / "link.obj");
    }

    void whatAReaderNeedsIsAllowed_data()
    {
        QTest::addColumn<QString>("deed");
        QTest::addColumn<QString>("argument");
        QTest::newRow("a file of the folder") << QStringLiteral("read") << at("inside.obj");
        QTest::newRow("a file below it") << QStringLiteral("read") << at("below/deep.obj");
        QTest::newRow("some memory") << QStringLiteral("memory") << QString::number(kMemory / 2);
    }

    void whatAReaderNeedsIsAllowed()
    {
        QFETCH(QString, deed);
        QFETCH(QString, argument);
        const End end = run(arguments(deed, argument));
        QCOMPARE(end.words, QByteArray{"confined\ndone\n"});
        QCOMPARE(end.code, 0);
    }

    void whatChangesOrLeavesTheFolderIsDenied_data()
    {
        QTest::addColumn<QString>("deed");
        QTest::addColumn<QString>("argument");
        QTest::addColumn<bool>("byLandlock");
        const auto row = [](const char* name, const char* deed, const QString& argument,
                            bool byLandlock = false) {
            QTest::newRow(name) << QString::fromLatin1(deed) << argument << byLandlock;
        };
        row("a file outside", "read", at("../outside.obj"), true);
        row("a file of the system", "read", QStringLiteral("/etc/passwd"), true);
        row("a link that leads out", "read", at("link.obj"), true);
        row("writing a file", "write", at("inside.obj"));
        row("a new file", "create", at("new.obj"));
        row("removing a file", "remove", at("inside.obj"));
        row("a new link", "link", at("new"));
        row("other permissions", "permissions", at("inside.obj"));
        row("many files", "read-many", at("inside.obj"));
        row("memory that holds code", "code", {});
        row("more memory than its share", "memory", QString::number(2 * kMemory));
        row("another limit of memory", "more-memory", {});
    }

    void whatChangesOrLeavesTheFolderIsDenied()
    {
        QFETCH(QString, deed);
        QFETCH(QString, argument);
        QFETCH(bool, byLandlock);
        if (byLandlock && !hasLandlock())
            QSKIP(kWithoutLandlock);
        const End end = run(arguments(deed, argument));
        QCOMPARE(end.words, QByteArray{"confined\ndenied\n"});
        QVERIFY(fs::exists(m_folder / "inside.obj"));
    }

    void whatReachesOtherProgramsEndsIt_data()
    {
        QTest::addColumn<QString>("deed");
        for (const char* deed :
             {"socket", "local-socket", "io-uring", "fork", "clone3", "run", "kill", "trace"})
            QTest::newRow(deed) << QString::fromLatin1(deed);
    }

    void whatReachesOtherProgramsEndsIt()
    {
        QFETCH(QString, deed);
        const End end = run(arguments(deed));
        QCOMPARE(end.words, QByteArray{"confined\n"});
        QVERIFY(end.bySignal);
        QCOMPARE(end.code, SIGSYS);
    }

    void aFaultOfItsOwnIsStillAFault()
    {
        const End end = run(arguments(QStringLiteral("abort")));
        QVERIFY(end.bySignal);
        QCOMPARE(end.code, SIGABRT);
    }

    void processorTimeIsLimited()
    {
        const End end = run(arguments(QStringLiteral("compute"), QStringLiteral("-"), 1));
        QVERIFY(end.bySignal);
        QCOMPARE(end.code, SIGXCPU);
    }

    void descriptorsOfTheParentAreClosed()
    {
        const int file = open("/dev/zero", O_RDONLY); // stays open when another program is run
        const End end = run(arguments(QStringLiteral("inherited"), QString::number(file)));
        close(file);
        QCOMPARE(end.words, QByteArray{"confined\ndenied\n"});
    }

    void itEndsWithItsParent()
    {
        std::array<int, 2> output{};
        QCOMPARE(pipe(output.data()), 0);
        const std::string folder = m_folder.string();
        const pid_t parent = fork();
        if (parent == 0) {
            dup2(output[1], STDOUT_FILENO);
            close(output[0]);
            close(output[1]);
            execl(CARINA_CONFINED, CARINA_CONFINED, folder.c_str(), "0", "60", "0", "child", "-",
                  nullptr);
            _exit(1);
        }
        close(output[1]);
        QCOMPARE(lineFrom(output[0]), QByteArray{"child\n"});
        // Only the child still holds the other end of the pipe; it computes for 60 s if it is let.
        QVERIFY(!endsWithin(output[0], 0));
        kill(parent, SIGKILL);
        const bool ended = endsWithin(output[0], kPatience_ms);
        waitpid(parent, nullptr, 0);
        close(output[0]);
        QVERIFY(ended);
    }

    void oneWhoseParentEndedBeforeDoesNotBegin()
    {
        const End end = run(arguments(QStringLiteral("nothing"), QStringLiteral("-"), 20, 1));
        QCOMPARE(end.words, QByteArray{"its parent has ended\n"});
        QCOMPARE(end.code, 3);
    }

    void theReaderOfSurfacesIsConfined()
    {
        QProcess reader;
        startReader(reader, getpid());
        request(reader, m_folder / "inside.obj");
        QVERIFY(answerOf(reader).has_value());
        QFile status{QStringLiteral("/proc/%1/status").arg(reader.processId())};
        QVERIFY(status.open(QIODevice::ReadOnly));
        const QByteArray lines = status.readAll();
        QVERIFY(lines.contains("NoNewPrivs:\t1\n"));
        QVERIFY(lines.contains("Seccomp:\t2\n"));
        request(reader, m_folder / "link.obj");
        const auto answer = answerOf(reader);
        QVERIFY(!answer);
        QCOMPARE(answer.error().code, Errc::FileUnreadable);
        reader.closeWriteChannel();
        QVERIFY(reader.waitForFinished(kPatience_ms));
        QCOMPARE(reader.exitCode(), 0);
    }

    void theReaderOfSurfacesReadsNothingOutside()
    {
        if (!hasLandlock())
            QSKIP(kWithoutLandlock);
        QProcess reader;
        startReader(reader, getpid());
        request(reader, m_outside / "outside.obj");
        const auto answer = answerOf(reader);
        QVERIFY(!answer);
        QCOMPARE(answer.error().code, Errc::FileUnreadable);
    }

    /// 48 million pixels of one colour are small in a file.
    void theReaderOfSurfacesSaysThatItsMemoryIsTooLittle()
    {
        constexpr int kSide = 7000;
        const std::vector<test::Pixel> pixels(std::size_t(kSide) * kSide, test::Pixel{1, 2, 3});
        test::writeFile(m_folder / "face.png", test::pngOf(kSide, pixels));
        test::writeFile(m_folder / "skin.mtl", "newmtl face\nmap_Kd face.png\n");
        test::writeFile(m_folder / "skin.obj",
                        test::texturedBallObj(1.0, 0.0, "mtllib skin.mtl\nusemtl face\n"));
        QProcess reader;
        startReader(reader, getpid());
        request(reader, m_folder / "skin.obj");
        QVERIFY(reader.waitForFinished(kPatience_ms));
        QCOMPARE(reader.exitStatus(), QProcess::NormalExit);
        QCOMPARE(reader.exitCode(), reader_exit::kOutOfMemory);
    }

    void theReaderOfSurfacesDoesNotBeginUnconfined()
    {
        QProcess reader;
        startReader(reader, 1);
        QVERIFY(reader.waitForFinished(kPatience_ms));
        QCOMPARE(reader.exitCode(), reader_exit::kNotConfined);
    }
};

CARINA_TEST(TestConfinement)

} // namespace carina::confinement_test

#include "tst_confinement.moc"
