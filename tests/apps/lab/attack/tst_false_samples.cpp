#include "apps/lab/attack/attackers/false_samples.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::false_samples_test
{
namespace
{

using namespace std::chrono_literals;
using lab::FalseSamples;
using lab::Measured;

constexpr ObjectId kOwn{7};
constexpr ObjectId kTrainees{1};
constexpr SessionTime kHostSent{30s};

bool isWithinBounds(const FalseSamples& samples)
{
    return std::ranges::all_of(samples.measured(1s), [](const Measured& each) {
        return each.figure >= each.least && each.figure <= each.most;
    });
}

StreamGroup groupOf(ObjectId object, SessionTime time)
{
    return {ParticipantId{3}, 1, StationId{0}, {FalseSamples::sample(object, 1, time)}};
}

} // namespace

class TestFalseSamples : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Beside one in time, as the attacker's own.
    void judgesWhatAnObserverWasSent_data()
    {
        QTest::addColumn<int>("object");
        QTest::addColumn<int>("ahead_ms");
        QTest::addColumn<bool>("isHeld");
        const int own = kOwn.value;
        QTest::newRow("in time, as its own") << own << -10 << true;
        QTest::newRow("as far ahead as a clock is uncertain") << own << 5 << true;
        QTest::newRow("ahead, as its own") << own << 7 << false;
        QTest::newRow("in the place of another's") << int{kTrainees.value} << -10 << false;
        QTest::newRow("ahead, in the place of another's") << int{kTrainees.value} << 200 << false;
    }
    void judgesWhatAnObserverWasSent()
    {
        QFETCH(const int, object);
        QFETCH(const int, ahead_ms);
        QFETCH(const bool, isHeld);
        FalseSamples samples;
        samples.see(groupOf(kOwn, kHostSent), kOwn, kHostSent);
        QVERIFY(isWithinBounds(samples));
        const SessionTime time = kHostSent + std::chrono::milliseconds{ahead_ms};
        samples.see(groupOf(ObjectId{static_cast<std::uint16_t>(object)}, time), kOwn, kHostSent);
        QCOMPARE(isWithinBounds(samples), isHeld);
    }

    void hasToReachTheObserver()
    {
        FalseSamples samples;
        QVERIFY(!isWithinBounds(samples));
        StreamGroup another = groupOf(kOwn, kHostSent);
        another.streams.front().X_AO = RigidTransform{};
        samples.see(another, kOwn, kHostSent); // of somebody else
        QVERIFY(!isWithinBounds(samples));
        samples.see(groupOf(kOwn, kHostSent), kOwn, kHostSent);
        QVERIFY(isWithinBounds(samples));
    }

    void hasNothingOfItsOwnBeforeItShared()
    {
        FalseSamples samples;
        samples.see(groupOf(kOwn, kHostSent), kOwn, kHostSent);
        samples.see(groupOf(kOwn, kHostSent), std::nullopt, kHostSent);
        QVERIFY(!isWithinBounds(samples));
    }
};

CARINA_TEST(TestFalseSamples)

} // namespace carina::false_samples_test

#include "tst_false_samples.moc"
