#include "apps/lab/attack/attacks.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTimer>
#include <QUdpSocket>

#include <algorithm>
#include <memory>
#include <string_view>

namespace carina::attackers_test
{
namespace
{

using lab::Attack;
using lab::AttackKind;
using lab::Measured;
using lab::Target;

/// A session with a trainee.
struct Course {
    MemoryDisk disk;
    std::unique_ptr<SessionNode> instructor = host(disk);
    std::unique_ptr<SessionNode> anna = join(*instructor, "Anna");

    [[nodiscard]] Target target() const
    {
        return {instructor->port(), instructor->joinCodes(), cheapKey, "Anna", "Mallory"};
    }
};

/// An attack that has a turn in each millisecond.
class UnderWay
{
public:
    UnderWay(std::string_view name, const Target& target)
        : m_attack{std::ranges::find(lab::attackKinds(), name, &AttackKind::name)->begin(target)}
    {
        m_turn.callOnTimeout([this] { m_attack->step(); });
        m_turn.start(1);
    }

    /// Whether what it measures by itself is within its bounds.
    [[nodiscard]] bool isHeld() const
    {
        const auto all = m_attack->measured(monotonicNow() - m_began);
        return !all.empty() && std::ranges::all_of(all, [](const Measured& each) {
            return each.figure >= each.least && each.figure <= each.most;
        });
    }
    const Attack* operator->() const { return m_attack.get(); }

private:
    std::unique_ptr<Attack> m_attack;
    LocalTime m_began = monotonicNow();
    QTimer m_turn;
};

} // namespace

/// Attackers against a host in this program, which holds: each does what it is for.
class TestAttackers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void falseTubeReachesAnObserverAsTheAttackersOwn()
    {
        Course course;
        course.anna->publish(ObjectKind::Tube, "Tube", stillTube(*course.anna));
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*course.instructor), kPatience_ms);
        const UnderWay attack{"false-tube", course.target()};
        QTRY_VERIFY_WITH_TIMEOUT(attack.isHeld(), kPatience_ms);
        QVERIFY(attack->sent() > 0);
    }

    void falseTokensAreOfferedAndRefused()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*course.anna), kPatience_ms);
        const UnderWay attack{"false-token", course.target()};
        QTRY_VERIFY_WITH_TIMEOUT(attack.isHeld(), kPatience_ms);
        QVERIFY(!attack->isTakenForAnother());
    }

    void idlePathsAreCountedOnceTheyAreOpen_data()
    {
        QTest::addColumn<QString>("from");
        QTest::newRow("from the address of all") << QStringLiteral("127.0.0.1");
        QTest::newRow("from elsewhere") << QStringLiteral("127.0.0.2");
    }
    void idlePathsAreCountedOnceTheyAreOpen()
    {
        QFETCH(const QString, from);
        Course course;
        Target target = course.target();
        target.from = QHostAddress{from};
        const UnderWay attack{"paths", target};
        QTRY_VERIFY_WITH_TIMEOUT(attack->sent() > 2, kPatience_ms);
        QVERIFY(attack->mostPaths() > 0);
        QVERIFY(attack->mostPaths() <= attack->sent());
    }

    /// Nothing came of it where nobody answers.
    void attemptsDoNotCount_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"paths", "strangers", "names", "impostor", "false-token"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void attemptsDoNotCount()
    {
        QFETCH(const QString, name);
        Course course;
        QUdpSocket silent;
        QVERIFY(silent.bind(QHostAddress::LocalHost));
        Target target = course.target();
        target.port = silent.localPort();
        const UnderWay attack{name.toStdString(), target};
        QTRY_VERIFY_WITH_TIMEOUT(silent.hasPendingDatagrams(), kPatience_ms); // it was tried
        QCOMPARE(attack->sent(), std::int64_t{0});
        QCOMPARE(attack->mostPaths(), std::int64_t{0});
    }

    void newNamesComeInAsFastAsTheHostLetsThem()
    {
        Course course;
        const UnderWay attack{"names", course.target()};
        QTRY_VERIFY_WITH_TIMEOUT(attack.isHeld(), kPatience_ms);
    }

    void countsThePatientsThatAnInstructorHadLaid()
    {
        Course course;
        const UnderWay attack{"instructing", course.target()};
        QTRY_VERIFY_WITH_TIMEOUT(attack->patientsLaid() > 1, kPatience_ms);
    }
};

CARINA_TEST(TestAttackers)

} // namespace carina::attackers_test

#include "tst_attackers.moc"
