#include "tests/end_to_end/held_transfer.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QDir>
#include <QTemporaryDir>

namespace carina::anatomy_test
{

namespace
{

constexpr int kMeasured_s = 45; ///< long enough to make the own patient, and for the set to come
constexpr qint64 kPassed = 1'000'000; ///< bytes of the set, before its line stands still

/// The files of a cache that end so, in the folder of sets that were carried.
QFileInfoList carried(const QString& cache, const QString& ending)
{
    const QDir folder{cache + QStringLiteral("/carina/anatomy/carried")};
    return folder.entryInfoList({QStringLiteral("*.") + ending}, QDir::Files);
}

QProcessEnvironment withCacheAt(const QString& folder)
{
    QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
    around.insert(QStringLiteral("XDG_CACHE_HOME"), folder);
    return around;
}

} // namespace

/// The two programs, each with a cache folder of its own. The host imports a real set; the trainee
/// has none of it.
class TestAnatomy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        m_set = carina::test::testData("anatomy/bodyparts3d");
        if (!m_set)
            return;
        m_hostFolder = std::make_unique<QTemporaryDir>();
        m_port = portOfThisTest();
        m_instructor = std::make_unique<Program>(
            QStringLiteral(CARINA_INSTRUCTOR),
            QStringList{QStringLiteral("--port"), m_port, QStringLiteral("--data"),
                        m_hostFolder->path(), QStringLiteral("--codes"), codes(),
                        QStringLiteral("--anatomy"), QString::fromStdString(m_set->string()),
                        QStringLiteral("--start")},
            m_hostFolder->filePath(QStringLiteral("instructor.jsonl")));
        m_instructor->setEnvironment(withCacheAt(m_hostFolder->filePath(QStringLiteral("cache"))));
        m_instructor->start();
        QTRY_VERIFY_WITH_TIMEOUT(!drawn(*m_instructor).isEmpty(), kPatience_ms);
    }

    void init()
    {
        if (!m_set)
            QSKIP("anatomy/bodyparts3d is not here");
        m_folder = std::make_unique<QTemporaryDir>();
        m_name = QString::fromLatin1(QTest::currentTestFunction()); // each folder has its own token
    }
    void cleanup() { m_trainee.reset(); }
    void cleanupTestCase() { m_instructor.reset(); }

    void traineeDrawsTheHostsPatientAndSaysSo()
    {
        start(m_port, {QStringLiteral("--measure"), m_folder->path(), QStringLiteral("--seconds"),
                       QString::number(kMeasured_s)});
        QTRY_VERIFY_WITH_TIMEOUT(m_trainee->hasEnded(), kPatience_ms);
        QCOMPARE(m_trainee->exitCode(), 0);
        QCOMPARE(drawn(*m_trainee), drawn(*m_instructor));
        QFile file{m_folder->filePath(QStringLiteral("trainee.json"))};
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject summary = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(summary[QStringLiteral("anatomy_hash")].toString(), drawn(*m_instructor));
        QCOMPARE(summary[QStringLiteral("anatomy")].toString(), QStringLiteral("bodyparts3d"));
        QCOMPARE(carried(cache(), QStringLiteral("anatomy")).size(), 1);
        QVERIFY(carried(cache(), QStringLiteral("part")).isEmpty());
    }

    void traineeThatIsKilledUnderWayGoesOn()
    {
        {
            const HeldTransfer line{std::uint16_t(m_port.toUInt()), kPassed};
            start(line.port());
            QTRY_VERIFY_WITH_TIMEOUT(arrived() > kPassed / 2, kPatience_ms);
            m_trainee->kill();
        }
        const qint64 before = arrived();
        QVERIFY(carried(cache(), QStringLiteral("anatomy")).isEmpty());
        start(m_port);
        QTRY_COMPARE_WITH_TIMEOUT(drawn(*m_trainee), drawn(*m_instructor), kPatience_ms);
        const QFileInfoList whole = carried(cache(), QStringLiteral("anatomy"));
        QCOMPARE(whole.size(), 1);
        QVERIFY(whole[0].size() > before);
        QVERIFY(carried(cache(), QStringLiteral("part")).isEmpty());
    }

private:
    /// Bytes of a set that has come in part.
    [[nodiscard]] qint64 arrived() const
    {
        const QFileInfoList parts = carried(cache(), QStringLiteral("part"));
        return parts.isEmpty() ? 0 : parts[0].size();
    }

    void start(const QString& port, const QStringList& more = {})
    {
        m_trainee = std::make_unique<Program>(
            QStringLiteral(CARINA_TRAINEE),
            QStringList{QStringLiteral("--port"), port, QStringLiteral("--as"), m_name,
                        QStringLiteral("--tracker"), QStringLiteral("simulated"),
                        QStringLiteral("--data"), m_folder->path(), QStringLiteral("--code-file"),
                        codes()}
                + more,
            m_folder->filePath(QStringLiteral("trainee.jsonl")));
        m_trainee->setEnvironment(withCacheAt(cache()));
        m_trainee->start();
    }

    [[nodiscard]] QString codes() const { return m_hostFolder->filePath(QStringLiteral("codes")); }
    [[nodiscard]] QString cache() const { return m_folder->filePath(QStringLiteral("cache")); }
    static QString drawn(const Program& program)
    {
        return program.shown()[QStringLiteral("anatomy")].toString();
    }

    std::optional<std::filesystem::path> m_set;
    QString m_port;
    QString m_name; ///< of the trainee
    std::unique_ptr<QTemporaryDir> m_hostFolder;
    std::unique_ptr<Program> m_instructor;
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Program> m_trainee;
};

CARINA_TEST(TestAnatomy)

} // namespace carina::anatomy_test

#include "tst_anatomy.moc"
