#include "engine/net/objects/pose_stream.h"
#include "engine/net/objects/publications.h"
#include "engine/net/objects/remote_objects.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::shared_poses_test
{
namespace
{

using namespace std::chrono_literals;

constexpr ParticipantId kOwner{2};
constexpr ParticipantId kAnna{1};
constexpr StationId kStation{0};
constexpr SessionTime kStart{1000s};

StreamCpo cpoAt(Duration after, const Vec3& p_AO, StreamValidity validity = StreamValidity::Tracked)
{
    StreamCpo cpo;
    cpo.object = ObjectId{1};
    cpo.time = kStart + after;
    cpo.X_AO = RigidTransform::translation(p_AO);
    cpo.validity = validity;
    return cpo;
}

/// As its owner sends it.
StreamSample sampleOf(const StreamCpo& cpo) { return {kOwner, 1, kStation, cpo}; }

/// A session that knows what Anna shares.
SessionState stateWith(std::initializer_list<fact::ObjectShared> objects)
{
    SessionState state;
    std::uint64_t number = 0;
    const auto apply = [&](FactBody body) {
        Fact fact;
        fact.number = FactNumber{++number};
        fact.body = std::move(body);
        state.apply(fact);
    };
    apply(fact::SessionCreated{"Course", "00"});
    apply(fact::StationAdded{"Station 1"});
    apply(fact::ParticipantJoined{kAnna, Role::Trainee, "Anna"});
    for (const auto& object : objects)
        apply(object);
    return state;
}

const fact::ObjectShared kTube{ObjectId{7}, kAnna, ObjectKind::Tube, "Tube"};

} // namespace

class TestSharedPoses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesSurviveTheWayThereAndBack()
    {
        PoseSample sample;
        sample.time = kStart;
        sample.X_FO = RigidTransform{Quat{0.0, 1.0, 0.0, 0.0}, Vec3{0.1, 0.2, 0.3}};
        sample.motion = Motion{Vec3{1.0, 2.0, 3.0}, Vec3{4.0, 5.0, 6.0}};
        sample.error = 0.00035;
        for (const Validity validity :
             {Validity::Tracked, Validity::PartlyOccluded, Validity::Lost}) {
            sample.validity = validity;
            const PoseSample back = fromStream(toStream(sample));
            QCOMPARE(back.validity, validity);
            QCOMPARE(back.time, sample.time);
            QVERIFY(back.X_FO.matrix() == sample.X_FO.matrix());
            QVERIFY(back.motion->v_FO == sample.motion->v_FO);
            QVERIFY(back.motion->w_FO == sample.motion->w_FO);
            QCOMPARE(back.error, sample.error);
        }
        sample.motion.reset();
        QVERIFY(!fromStream(toStream(sample)).motion);
    }

    void driftIsHowFarANewSampleMovesThePicture()
    {
        RemoteObjects objects;
        objects.add(ObjectId{1}, kOwner, kStation);
        QVERIFY(objects.reports(kStart).empty()); // nothing came yet
        StreamCpo cpo = cpoAt(0ms, Vec3::Zero());
        cpo.motion = StreamMotion{Vec3{0.1, 0.0, 0.0}, Vec3::Zero()};
        objects.take(sampleOf(cpo), cpo.time);
        cpo = cpoAt(20ms, Vec3{0.005, 0.0, 0.0});
        cpo.X_AO =
            RigidTransform{Quat{std::cos(0.05), 0.0, 0.0, std::sin(0.05)}, cpo.X_AO.translation()};
        objects.take(sampleOf(cpo), cpo.time);
        const ObjectReport report = objects.reports(kStart + 50ms).at(0);
        QCOMPARE(report.object, ObjectId{1});
        QCOMPARE(report.age, Duration{30ms});
    }

    void tellsHowFastAnObjectMovesAndHowOftenWordOfItComes()
    {
        RemoteObjects objects;
        objects.add(ObjectId{1}, kOwner, kStation);
        StreamCpo cpo = cpoAt(0ms, Vec3::Zero());
        objects.take(sampleOf(cpo), cpo.time);
        QVERIFY(!objects.reports(kStart)[0].turnDegPerS); // its owner does not say
        QVERIFY(!objects.reports(kStart)[0].moveMmPerS);
        QVERIFY(!objects.analysis().actionFrequency(kOwner, 1, kStart)); // not over
        for (int i = 1; i < 60; ++i) {
            cpo = cpoAt(Duration{1s} * i / 60, Vec3::Zero());
            cpo.motion = StreamMotion{Vec3{0.03, 0.04, 0.0}, Vec3{0.0, 0.0, -2.0}};
            objects.take(sampleOf(cpo), cpo.time);
        }
        const ObjectReport report = objects.reports(kStart + 1s).at(0);
        QVERIFY(std::abs(report.moveMmPerS.value() - 50.0) < 1e-9);
        QVERIFY(std::abs(report.turnDegPerS.value() - inDegrees(radians(2.0))) < 1e-9);
        QCOMPARE(objects.analysis().actionFrequency(kOwner, 1, kStart + 1s), std::optional{60.0});
        cpo.time = kStart + 1s;
        cpo.validity = StreamValidity::Lost;
        objects.take(sampleOf(cpo), cpo.time);
        QVERIFY(!objects.reports(kStart + 1s)[0].turnDegPerS);
        objects.remove(ObjectId{1});
        objects.add(ObjectId{1}, kOwner, kStation);
        objects.take(sampleOf(cpoAt(5s, Vec3::Zero())), kStart + 5s);
        QVERIFY(!objects.analysis().actionFrequency(kOwner, 1, kStart + 5s)); // counted anew
    }

    void posesGoStaleAfter300Milliseconds()
    {
        RemoteObjects objects;
        objects.add(ObjectId{1}, kOwner, kStation);
        objects.take(sampleOf(cpoAt(0ms, Vec3::Zero())), kStart + 0ms);
        const auto poses = objects.find(ObjectId{1});
        QCOMPARE(poses->at(kStart + 300ms)->validity, Validity::Tracked);
        QCOMPARE(poses->at(kStart + 301ms)->validity, Validity::Lost);
    }

    void addingAgainKeepsWhatCame()
    {
        RemoteObjects objects;
        objects.add(ObjectId{1}, kOwner, kStation);
        objects.take(sampleOf(cpoAt(0ms, Vec3::Zero())), kStart + 0ms);
        objects.add(ObjectId{1}, kOwner, kStation);
        QVERIFY(objects.find(ObjectId{1})->newest());
        objects.remove(ObjectId{1});
        QVERIFY(!objects.find(ObjectId{1}));
        objects.take(sampleOf(cpoAt(10ms, Vec3::Zero())),
                     kStart + 10ms); // of an object that is not there: nothing
        objects.add(ObjectId{1}, kOwner, kStation);
        QVERIFY(!objects.find(ObjectId{1})->newest());
        objects.clear();
        QVERIFY(!objects.find(ObjectId{1}));
    }

    void unknownObjectsAreToldOfOnce()
    {
        Publications publications;
        publications.add(ObjectKind::Tube, "Tube", [] { return std::nullopt; });
        const SessionState empty = stateWith({});
        const auto wanted = publications.takeUnknown(empty, kAnna);
        QCOMPARE(wanted.size(), std::size_t{1});
        QVERIFY(
            (wanted[0].object == fact::ObjectShared{ObjectId{}, kAnna, ObjectKind::Tube, "Tube"}));
        QVERIFY(publications.takeUnknown(empty, kAnna).empty());
        publications.forget();
        QCOMPARE(publications.takeUnknown(empty, kAnna).size(), std::size_t{1});
        // After a restart the session may know it already.
        publications.forget();
        QVERIFY(publications.takeUnknown(stateWith({kTube}), kAnna).empty());
    }

    void newSamplesAreSentOnce()
    {
        Publications publications;
        QCOMPARE(publications.nextTick(), LocalTime::max());
        std::optional<PoseSample> newest;
        publications.add(ObjectKind::Tube, "Tube", [&] { return newest; });
        const SessionState state = stateWith({kTube});
        LocalTime now{1s};
        const auto tick = [&] {
            now = std::max(now, publications.nextTick());
            return publications.sample(state, kAnna, now);
        };
        QVERIFY(tick().empty());
        newest = PoseSample{};
        newest->time = kStart;
        auto sent = tick();
        QCOMPARE(sent.size(), std::size_t{1});
        QCOMPARE(sent[0].station, kStation);
        QCOMPARE(sent[0].cpo.object, ObjectId{7});
        QCOMPARE(sent[0].cpo.time, kStart);
        const std::uint16_t sequence = sent[0].cpo.sequence;
        QVERIFY(tick().empty()); // the same sample
        newest->time = kStart + 16ms;
        QVERIFY(publications.sample(state, kAnna, now).empty()); // not before the next tick
        sent = tick();
        QCOMPARE(sent.size(), std::size_t{1});
        QCOMPARE(int{sent[0].cpo.sequence}, sequence + 1);
    }

    void othersObjectsAreNotOurs()
    {
        Publications publications;
        publications.add(ObjectKind::Tube, "Tube", [] { return PoseSample{}; });
        publications.add(ObjectKind::Jaw, "Tube", [] { return PoseSample{}; });
        publications.add(ObjectKind::Tube, "Other", [] { return PoseSample{}; });
        const SessionState state = stateWith({kTube});
        QVERIFY(publications.sample(state, ParticipantId{2}, LocalTime{1s}).empty());
        QCOMPARE(publications.sample(state, kAnna, LocalTime{2s}).size(), std::size_t{1});
        QCOMPARE(publications.takeUnknown(state, kAnna).size(), std::size_t{2});
    }
};

CARINA_TEST(TestSharedPoses)

} // namespace carina::shared_poses_test

#include "tst_shared_poses.moc"
