#include "engine/net/objects/remote_objects.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::remote_object_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kStart{1000s};
constexpr double kSpeed = 0.2;      // m/s along x
constexpr double kExact = 1e-12;    // m
constexpr double kTinyStep = 20e-6; // m: what 10 us of the blending below may move it, and more

StreamCpo movingAt(Duration after, double x, StreamValidity validity = StreamValidity::Tracked)
{
    StreamCpo cpo;
    cpo.time = kStart + after;
    cpo.X_AO = RigidTransform::translation(Vec3{x, 0.0, 0.0});
    cpo.motion = StreamMotion{Vec3{kSpeed, 0.0, 0.0}, Vec3::Zero()};
    cpo.validity = validity;
    cpo.error = 0.001;
    return cpo;
}

double xAt(const RemoteObject& object, Duration after)
{
    return object.at(kStart + after)->X_FO.translation().x();
}

} // namespace

class TestRemoteObject : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isNothingBeforeTheFirstSample()
    {
        RemoteObject object;
        QVERIFY(!object.at(kStart));
        QVERIFY(!object.newest());
        object.take(movingAt(0ms, 0.0), kStart);
        QVERIFY(!object.at(kStart - 1ns));
        QCOMPARE(object.at(kStart)->how, How::Exact);
    }

    void isCarriedOnFor150MillisecondsAndThenFades()
    {
        RemoteObject object;
        object.take(movingAt(0ms, 0.0), kStart);
        const PoseSample ahead = *object.at(kStart + 150ms);
        QCOMPARE(ahead.how, How::Predicted);
        QCOMPARE(ahead.time, kStart + 150ms);
        QCOMPARE(ahead.error, 0.001);
        QVERIFY(ahead.motion);
        QVERIFY(std::abs(ahead.X_FO.translation().x() - 0.150 * kSpeed) < kExact);
        QVERIFY(!object.at(kStart + 151ms)->motion);
        // Over 100 ms of fading the way is that of 50 ms.
        QVERIFY(std::abs(xAt(object, 250ms) - 0.200 * kSpeed) < kExact);
        QVERIFY(std::abs(xAt(object, 10s) - 0.200 * kSpeed) < kExact);
        QCOMPARE(object.at(kStart + 300ms)->validity, Validity::Tracked);
        QCOMPARE(object.at(kStart + 300ms + 1ns)->validity, Validity::Lost);
    }

    void nextSampleIsBlendedTo()
    {
        // It turns out to be 5 mm further than it was drawn when the sample came, 30 ms late.
        RemoteObject object;
        object.take(movingAt(0ms, 0.0), kStart);
        const double before = xAt(object, 50ms);
        object.take(movingAt(20ms, 0.020 * kSpeed + 0.005), kStart + 50ms);
        QVERIFY(std::abs(xAt(object, 50ms) - before) < kExact);
        for (Duration t = 50ms; t < 110ms; t += 10us)
            QVERIFY(std::abs(xAt(object, t + 10us) - xAt(object, t)) < kTinyStep);
        QVERIFY(std::abs(xAt(object, 100ms) - (0.100 * kSpeed + 0.005)) < kExact);
    }

    void pastIsWhatWasMeasured()
    {
        RemoteObject object;
        object.take(movingAt(0ms, 0.0), kStart);
        object.take(movingAt(20ms, 0.010), kStart + 25ms);
        QVERIFY(std::abs(xAt(object, 10ms) - 0.005) < kExact);
        QCOMPARE(object.at(kStart + 10ms)->how, How::Interpolated);
        QVERIFY(std::abs(xAt(object, 20ms) - 0.010) < kExact);
        QCOMPARE(object.newest()->time, kStart + 20ms);
    }

    /// Of an object that is not streamed any more only where it was last is kept.
    void pastIsGivenUpAndTheNewestIsNot()
    {
        RemoteObject object;
        object.take(movingAt(0ms, 0.0), kStart);
        object.take(movingAt(20ms, 0.010), kStart + 25ms);
        object.forgetPast(kStart + 20ms); // it is from no earlier
        QVERIFY(object.at(kStart));
        const double later = xAt(object, 5s);
        object.forgetPast(kStart + 20ms + 1ns);
        QVERIFY(!object.at(kStart));
        QCOMPARE(object.newest()->time, kStart + 20ms);
        QVERIFY(std::abs(xAt(object, 20ms) - 0.010) < kExact);
        QCOMPARE(xAt(object, 5s), later);
        QCOMPARE(object.at(kStart + 5s)->validity, Validity::Lost);
        object.take(movingAt(6s, 0.020), kStart + 6s);
        QVERIFY(std::abs(xAt(object, 6s) - 0.020) < kExact);
    }

    void objectsThatFallSilentGiveUpTheirPasts()
    {
        RemoteObjects objects;
        for (const ObjectId id : {ObjectId{1}, ObjectId{2}})
            objects.add(id, ParticipantId{3}, StationId{});
        const auto sample = [](ObjectId id, Duration after) {
            StreamSample sampled{ParticipantId{3}, 1, StationId{}, movingAt(after, 0.0)};
            sampled.cpo.object = id;
            return sampled;
        };
        for (const Duration after : {Duration{0ms}, Duration{20ms}})
            for (const ObjectId id : {ObjectId{1}, ObjectId{2}})
                objects.take(sample(id, after), kStart + after);
        for (Duration after = 1s; after <= 12s; after += 1s)
            objects.take(sample(ObjectId{2}, after), kStart + after);
        QVERIFY(!objects.find(ObjectId{1})->at(kStart));
        QVERIFY(objects.find(ObjectId{1})->newest());
        QVERIFY(objects.find(ObjectId{2})->at(kStart));
    }

    void lostObjectStaysWhereItWasSeen()
    {
        RemoteObject object;
        object.take(movingAt(0ms, 0.3, StreamValidity::Lost), kStart);
        const PoseSample shown = *object.at(kStart + 100ms);
        QCOMPARE(shown.validity, Validity::Lost);
        QVERIFY(!shown.motion);
        QVERIFY(std::abs(shown.X_FO.translation().x() - 0.3) < kExact);
    }

    /// As long as each sample says how.
    void bendsAsItsOwnerHasIt()
    {
        RemoteObject object;
        StreamCpo cpo = movingAt(0ms, 0.0);
        object.take(cpo, kStart);
        QVERIFY(!object.shapeAt(kStart));
        const auto bends = [&](Duration after, double perMetre) {
            cpo = movingAt(after, 0.0);
            cpo.shape = StreamShape{cpo.time, 0.3, 0.01, {}, {perMetre}};
            object.take(cpo, cpo.time);
        };
        bends(20ms, 1.0);
        bends(40ms, 3.0);
        QVERIFY(std::abs(object.shapeAt(kStart + 30ms)->times - 0.5) < kExact);
        // Two that are so near tell not how fast it goes on.
        QCOMPARE(object.shapeAt(kStart + 50ms)->from.perMetre[0], 3.0);
        QCOMPARE(object.shapeAt(kStart + 50ms)->to.perMetre[0], 3.0);
        object.take(movingAt(60ms, 0.0), kStart + 60ms);
        QVERIFY(!object.shapeAt(kStart + 60ms));
        bends(80ms, 1.0);
        cpo.time += 20ms;
        cpo.validity = StreamValidity::Lost;
        object.take(cpo, cpo.time);
        QVERIFY(!object.shapeAt(kStart + 100ms));
    }
};

CARINA_TEST(TestRemoteObject)

} // namespace carina::remote_object_test

#include "tst_remote_object.moc"
