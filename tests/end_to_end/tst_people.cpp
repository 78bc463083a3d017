#include "engine/core/units.h"
#include "engine/session/facts/facts.h"
#include "evaluation/scene/drawn_scene.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>

namespace carina::people_test
{

namespace
{

constexpr int kWatched_ms = 60'000;
constexpr double kLongestGap = 0.6; ///< seconds between two frames of an owner's program

/// Of the comparisons within their bound, and of the frames that have everybody; the rest is for
/// what a program does late that shares its processor. docs/synchronisation.md, "Several people".
constexpr double kLeastWithin = 0.99;
constexpr double kLeastDrawn = 0.95;

} // namespace

/// A console and three trainees with simulated trackers at one station, for a minute.
class TestPeople : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        const QString port = portOfThisTest();
        const QString codes = m_folder.filePath(QStringLiteral("codes"));
        const QStringList common{QStringLiteral("--port"), port, QStringLiteral("--patient"),
                                 QStringLiteral("child")};
        add("instructor", QStringLiteral(CARINA_INSTRUCTOR),
            common
                + QStringList{QStringLiteral("--data"), m_folder.path(), QStringLiteral("--codes"),
                              codes, QStringLiteral("--start")});
        m_programs.back()->start();
        QTRY_VERIFY_WITH_TIMEOUT(!m_programs.back()->shown().isEmpty(), kPatience_ms);
        for (const char* name : {"Tom", "Tess", "Tim"}) {
            add(name, QStringLiteral(CARINA_TRAINEE),
                common
                    + QStringList{QStringLiteral("--as"), QString::fromLatin1(name),
                                  QStringLiteral("--code-file"), codes, QStringLiteral("--tracker"),
                                  QStringLiteral("simulated")});
            m_programs.back()->start();
            QTRY_VERIFY_WITH_TIMEOUT(!m_programs.back()->shown().isEmpty(), kPatience_ms);
        }
        QTRY_VERIFY_WITH_TIMEOUT(std::ranges::all_of(m_programs, seesAll), kPatience_ms);
        const auto now = [this] {
            return 1e-9
                   * double(m_programs.front()->shown()[QStringLiteral("session_ns")].toInteger());
        };
        m_from = now();
        QTest::qWait(kWatched_ms);
        m_until = now();
        m_programs.clear();
        std::vector<DrawnScene> drawn;
        for (std::size_t who = 0; who < m_journals.size(); ++who)
            drawn.push_back({.participant = int(who),
                             .hasTools = who > 0,
                             .frames = drawnFramesIn(m_journals[who])});
        // They hold names.
        for (const QString& journal : m_journals)
            QCOMPARE(QFile::permissions(journal) & (QFile::ReadGroup | QFile::ReadOther),
                     QFile::Permissions{});
        m_compared = compareScenes(drawn, m_from, m_until, {.longestGap = kLongestGap});
    }

    /// Everybody draws heads, hands and tubes of all others: the console those of three, and each
    /// of these those of two.
    void everyProgramDrawsEverybodyElse()
    {
        constexpr int kKinds = 3;
        QCOMPARE(m_compared.pairs, kKinds * (kTrainees + kTrainees * (kTrainees - 1)));
        QVERIFY2(m_compared.leastShare >= kLeastDrawn,
                 qPrintable(QString::number(m_compared.leastShare)));
    }

    void everyObjectIsWhereItsOwnersProgramHasIt()
    {
        const SceneDifference& off = m_compared.near;
        QVERIFY(off.distances.size() > std::size_t{1000});
        const double median_mm = inMillimetres(metres(quantileOf(off.distances, 0.5)));
        const double median_deg = inDegrees(radians(quantileOf(off.angles, 0.5)));
        const double worst95_mm = inMillimetres(metres(quantileOf(off.distances, 0.95)));
        const double worst95_deg = inDegrees(radians(quantileOf(off.angles, 0.95)));
        const QString told = QStringLiteral("%1 compared: %2 mm, %3 deg (median), %4 mm, %5 deg "
                                            "(95 %)")
                                 .arg(off.distances.size())
                                 .arg(median_mm)
                                 .arg(median_deg)
                                 .arg(worst95_mm)
                                 .arg(worst95_deg);
        qInfo("%s", qPrintable(told));
        const double within = 1.0 - double(off.beyond) / double(off.distances.size());
        QVERIFY2(within >= kLeastWithin, qPrintable(QString::number(within)));
        QVERIFY2(isWithin(off, kBoundsOnTheSpot), qPrintable(told));
    }

    void noObjectEverChangesItsOwner()
    {
        QCOMPARE(m_compared.ownerChanges, 0);
        QVERIFY(m_compared.recognisable > std::size_t{1000});
        QCOMPARE(m_compared.mistaken, std::size_t{0});
    }

private:
    static constexpr int kTrainees = 3; ///< with the numbers 1 to 3; the console is 0

    void add(const char* name, const QString& path, const QStringList& arguments)
    {
        m_journals.push_back(
            m_folder.filePath(QString::fromLatin1(name) + QStringLiteral(".jsonl")));
        m_programs.push_back(std::make_unique<Program>(path, arguments, m_journals.back()));
    }

    /// Whether the last frame of a program draws a tube of each trainee.
    static bool seesAll(const std::unique_ptr<Program>& program)
    {
        const QJsonArray frames = program->shown()[QStringLiteral("frames")].toArray();
        if (frames.isEmpty())
            return false;
        int tubes = 0;
        for (const QJsonValue& object : frames.last()[QStringLiteral("objects")].toArray())
            tubes += object[QStringLiteral("kind")].toInt() == int(ObjectKind::Tube) ? 1 : 0;
        return tubes == kTrainees;
    }

    QTemporaryDir m_folder;
    std::vector<QString> m_journals;
    std::vector<std::unique_ptr<Program>> m_programs;
    SceneComparison m_compared;
    double m_from = 0.0;
    double m_until = 0.0;
};

CARINA_TEST(TestPeople)

} // namespace carina::people_test

#include "tst_people.moc"
