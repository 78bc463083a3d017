#include "engine/net/entry/session_identity.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/engine/net/secure/transports.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QTemporaryDir>

namespace carina::node_recovery_test
{

class TestNodeRecovery : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hostThatComesBackIsFoundWithItsTime()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        const LocalTime moment = monotonicNow();
        const SessionTime before = *instructor->sessionTime(moment);
        const std::string id = instructor->state()->sessionId();

        instructor.reset();
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*anna), LinkState::Away, kPatience_ms);
        QVERIFY(anna->now().has_value()); // the clock runs on
        instructor = host(disk, port);
        QVERIFY(instructor);
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*anna), LinkState::Connected, kPatience_ms);
        QCOMPARE(instructor->state()->sessionId(), id);
        QCOMPARE(*instructor->sessionTime(moment), before);
        QTRY_COMPARE_WITH_TIMEOUT(anna->state()->lastApplied(), instructor->state()->lastApplied(),
                                  kPatience_ms);
        QVERIFY(apart(*anna, *instructor) < kClockTolerance);
    }

    void restartedHostHasItsActions()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        instructor->propose(kStation,
                            fact::ObjectShared{{}, instructor->self(), ObjectKind::Jaw, "jaw"});
        QTRY_VERIFY_WITH_TIMEOUT(!anna->state()->objects().empty(), kPatience_ms);
        const ObjectId jaw = anna->state()->objects().begin()->first;
        instructor->act(jaw, {ActionKind::Rotation, Vec3::UnitZ(), 0.5, {}});
        QTRY_VERIFY_WITH_TIMEOUT(anna->shown(jaw, *anna->now()), kPatience_ms);
        instructor.reset();
        instructor = host(disk, port);
        QVERIFY(instructor);
        const SessionTime t = *instructor->now() + 1s;
        QTRY_VERIFY_WITH_TIMEOUT(instructor->shown(jaw, t), kPatience_ms);
        QVERIFY(instructor->shown(jaw, t)->acted.X_AO.matrix()
                == anna->shown(jaw, t)->acted.X_AO.matrix());
        // It goes on from there.
        instructor->act(jaw, {ActionKind::Rotation, Vec3::UnitZ(), 0.0, {}});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->shown(jaw, t + 1s)->acted.X_AO.matrix()
                                     == instructor->shown(jaw, t)->acted.X_AO.matrix(),
                                 kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(anna->shown(jaw, t)->acted.X_AO.matrix()
                                     == instructor->shown(jaw, t)->acted.X_AO.matrix(),
                                 kPatience_ms);
    }

    void proposalWhileTheHostIsAwayArrivesOnce()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto second = join(*instructor, "Dr Rolland", Role::Instructor);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*second), kPatience_ms);
        instructor.reset();
        second->propose(kStation, fact::BreathingRateSet{perMinute(30.0)});
        QTRY_COMPARE_WITH_TIMEOUT(second->pending().size(), std::size_t{1}, kPatience_ms);
        QVERIFY(second->pending().front() == FactBody{fact::BreathingRateSet{perMinute(30.0)}});
        const std::size_t facts = disk.facts.size();
        instructor = host(disk, port);
        QTRY_VERIFY_WITH_TIMEOUT(second->pending().empty(), kPatience_ms);
        QCOMPARE(ratePerMinute(*instructor), 30.0);
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*second), 30.0, kPatience_ms);
        instructor.reset();
        QCOMPARE(disk.facts.size(), facts + 2); // the host came in again, and the rate
    }

    void restartedTraineeIsTheSameParticipant()
    {
        MemoryDisk disk;
        const QTemporaryDir tokens;
        const auto instructor = host(disk);
        JoinSettings settings = joinSettings(*instructor, "Anna");
        settings.tokens = tokens.path().toStdString();
        auto anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!QDir{tokens.path()}.isEmpty(), kPatience_ms);
        const ParticipantId id = anna->self();
        const auto present = [&] { return instructor->state()->participants().at(id).present; };
        QVERIFY(present());
        anna.reset();
        QTRY_VERIFY_WITH_TIMEOUT(!present(), kPatience_ms);
        // Her name and the code of her role are known to others, too.
        const auto impostor = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(impostor->refusal(), kPatience_ms);
        QCOMPARE(impostor->refusal()->code, Errc::NameTaken);
        anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        QCOMPARE(anna->self(), id);
        QCOMPARE(impostor->self(), kNobody);
        QTRY_VERIFY_WITH_TIMEOUT(present(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(anna->state()->lastApplied(), instructor->state()->lastApplied(),
                                  kPatience_ms);
    }

    /// A path over which nobody comes in is closed; one that somebody came in over stays.
    void pathsWithoutAHelloAreClosed()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        const AccessKey key = *cheapKey(instructor->joinCodes().at(Role::Observer),
                                        sessionKey(instructor->state()->sessionId()));
        RawClient silent{instructor->port(),
                         "observer:" + instructor->state()->sessionId() + ":new", key};
        QTRY_VERIFY_WITH_TIMEOUT(silent.isIn(), kPatience_ms);
        const std::size_t answers = silent.answers.size();
        QTRY_COMPARE_WITH_TIMEOUT(silent.answers.size(), answers + 1, kPatience_ms); // close_notify
        QVERIFY(isIn(*anna));
    }

    void participantsWhoDoNotReturnToARestartedHostAreGone()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        auto anna = join(*instructor, "Anna");
        const auto ben = join(*instructor, "Ben");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && isIn(*ben), kPatience_ms);
        const ParticipantId annaId = anna->self();
        instructor.reset();
        anna.reset();
        instructor = host(disk, port);
        const auto present = [&](ParticipantId id) {
            return instructor->state()->participants().at(id).present;
        };
        QVERIFY(present(annaId));
        QTRY_VERIFY_WITH_TIMEOUT(!present(annaId), kPatience_ms); // three seconds of grace
        QVERIFY(present(ben->self()));
    }

    void namesAreTakenWhileTheirOwnersLive()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        const auto other = join(*instructor, "Anna");
        const auto usurper = join(*instructor, "Dr Hall", Role::Instructor);
        QTRY_VERIFY_WITH_TIMEOUT(other->refusal() && usurper->refusal(), kPatience_ms);
        QCOMPARE(other->refusal()->code, Errc::NameTaken);
        QCOMPARE(usurper->refusal()->code, Errc::NameTaken);
        QCOMPARE(other->self(), kNobody);
        QCOMPARE(linkOf(*other), LinkState::Connecting);
        const auto mimic = join(*instructor, "\u0410nna", Role::Observer); // Cyrillic
        QTRY_VERIFY_WITH_TIMEOUT(mimic->refusal(), kPatience_ms);
        QCOMPARE(mimic->refusal()->code, Errc::NameUnclear);
        const auto watcher = join(*instructor, "Otto", Role::Observer);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*watcher), kPatience_ms);
    }

    void posesGoOnAfterTheHostComesBack()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const auto anna = join(*instructor, "Anna");
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*instructor) && onlyObject(*instructor)->newest(),
                                 kPatience_ms);
        instructor.reset();
        instructor = host(disk, port);
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*instructor)->newest().has_value(), kPatience_ms);
        QCOMPARE(instructor->state()->objects().size(), std::size_t{1});
    }
};

CARINA_TEST(TestNodeRecovery)

} // namespace carina::node_recovery_test

#include "tst_node_recovery.moc"
