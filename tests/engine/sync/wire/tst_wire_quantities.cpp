#include "engine/geometry/rotation.h"
#include "engine/sync/wire/cpo_codec.h"
#include "engine/sync/wire/wire_quantities.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace carina::wire_quantities_test
{
namespace
{

const double kHalf = std::sqrt(0.5);

StreamCpo throughTheWire(const StreamCpo& stream)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    writeStreamGroup(out, StreamGroup{{}, 0, {}, {stream}});
    ByteReader in{bytes};
    return readStreamGroup(in).streams.at(0);
}

} // namespace

class TestWireQuantities : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void roundsToTheNearestStep()
    {
        QCOMPARE(quantise(0.0, 0.1, 100), 0);
        QCOMPARE(quantise(0.14, 0.1, 100), 1);
        QCOMPARE(quantise(0.16, 0.1, 100), 2);
        QCOMPARE(quantise(-0.16, 0.1, 100), -2);
    }

    void staysWithinTheLargestCode()
    {
        QCOMPARE(quantise(9.9, 0.1, 100), 99);
        QCOMPARE(quantise(10.0, 0.1, 100), 100);
        QCOMPARE(quantise(1e300, 0.1, 100), 100);
        QCOMPARE(quantise(-1e300, 0.1, 100), -100);
    }

    void errorsArePositiveAndSaturate()
    {
        QCOMPARE(packError(0.0), std::uint8_t{0});
        QCOMPARE(packError(-1.0), std::uint8_t{0});
        QCOMPARE(packError(0.00035), std::uint8_t{7});
        QCOMPARE(packError(0.01275), std::uint8_t{255});
        QCOMPARE(packError(5.0), std::uint8_t{255});
    }

    void axesOfRotationHaveExactCodes_data()
    {
        QTest::addColumn<Quat>("q");
        QTest::addColumn<int>("largest");
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::addColumn<int>("third");
        QTest::newRow("identity") << Quat{1, 0, 0, 0} << 3 << 0 << 0 << 0;
        QTest::newRow("identity, turned over") << Quat{-1, 0, 0, 0} << 3 << 0 << 0 << 0;
        QTest::newRow("half turn about x") << Quat{0, 1, 0, 0} << 0 << 0 << 0 << 0;
        QTest::newRow("half turn about -y") << Quat{0, 0, -1, 0} << 1 << 0 << 0 << 0;
        QTest::newRow("quarter turn about x") << Quat{kHalf, kHalf, 0, 0} << 0 << 0 << 0 << 32767;
        QTest::newRow("quarter turn about -z")
            << Quat{kHalf, 0, 0, -kHalf} << 2 << 0 << 0 << -32767;
        // 0.5 / (sqrt(1/2) / 32767) = 23169.8
        QTest::newRow("third of a turn")
            << Quat{-.5, .5, .5, -.5} << 0 << 23170 << -23170 << -23170;
    }

    void axesOfRotationHaveExactCodes()
    {
        QFETCH(Quat, q);
        QFETCH(int, largest);
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(int, third);
        const PackedRotation packed = packRotation(q);
        QCOMPARE(int{packed.largest}, largest);
        QCOMPARE(int{packed.others[0]}, first);
        QCOMPARE(int{packed.others[1]}, second);
        QCOMPARE(int{packed.others[2]}, third);
    }

    void unpackedRotationsAreOfUnitLength()
    {
        std::mt19937 random{3};
        std::normal_distribution<double> normal;
        for (int i = 0; i < 10000; ++i) {
            const Quat q =
                Quat{normal(random), normal(random), normal(random), normal(random)}.normalized();
            const auto back = unpackRotation(packRotation(q));
            QVERIFY(back);
            QVERIFY(std::abs(back->norm() - 1.0) < 1e-12);
            QVERIFY(angleBetween(*back, q).si <= 7.5e-5); // 4 sqrt(3) half steps
        }
    }

    void equalComponentsSurviveInEverySign()
    {
        for (int signs = 0; signs < 16; ++signs) {
            const auto half = [&](int bit) { return (signs >> bit & 1) != 0 ? -0.5 : 0.5; };
            const Quat q{half(0), half(1), half(2), half(3)};
            const auto back = unpackRotation(packRotation(q));
            QVERIFY(back);
            QVERIFY(angleBetween(*back, q).si <= 7.5e-5);
        }
    }

    void refusesCodesOfNoRotation()
    {
        // The largest component must be at least the others: at most 3/4 is left for their squares,
        // 1.5 * 32767^2 in codes. 23170 three times is within rounding of that, 23171 is not.
        QVERIFY(unpackRotation({3, {23170, 23170, 23170}}));
        QVERIFY(!unpackRotation({3, {23171, 23171, 23171}}));
        QVERIFY(!unpackRotation({0, {-32767, 32767, 0}}));
        QVERIFY(!unpackRotation({0, {-32767, 32767, 32767}}));
    }

    void farPositionsAreSentAsLost()
    {
        StreamCpo stream = goldenStream();
        stream.X_AO = RigidTransform::translation(Vec3{83.88607, -83.88607, 0.0});
        QCOMPARE(throughTheWire(stream).validity, StreamValidity::PartlyOccluded);
        stream.X_AO = RigidTransform::translation(Vec3{0.0, 0.0, -83.8861});
        const StreamCpo far = throughTheWire(stream);
        QCOMPARE(far.validity, StreamValidity::Lost);
        QVERIFY(std::abs(far.X_AO.translation().z() + 83.88607) < 1e-9);
    }

    void fastMotionIsSentAsTheFastest()
    {
        StreamCpo stream = goldenStream();
        stream.motion = StreamMotion{Vec3{10.0, -10.0, 0.0}, Vec3{0.0, 100.0, -100.0}};
        const auto motion = throughTheWire(stream).motion;
        QVERIFY(motion);
        const double fastest = 32767 * 0.02 * std::numbers::pi / 180.0;
        QVERIFY((motion->v_AO - Vec3{3.2767, -3.2767, 0.0}).norm() < 1e-12);
        QVERIFY((motion->w_AO - Vec3{0.0, fastest, -fastest}).norm() < 1e-12);
    }

    void timesRoundToTheNearestMicrosecond()
    {
        QCOMPARE(wireMicroseconds(SessionTime{Duration{1499}}), std::int64_t{1});
        QCOMPARE(wireMicroseconds(SessionTime{Duration{1501}}), std::int64_t{2});
        QCOMPARE(wireMicroseconds(SessionTime{Duration{-1501}}), std::int64_t{-2});
        QCOMPARE(fromWireMicroseconds(-2), SessionTime{Duration{-2000}});
    }

    void lowerBitsMeanTheNearestTime_data()
    {
        QTest::addColumn<std::int64_t>("base");
        QTest::addColumn<std::uint32_t>("low");
        QTest::addColumn<std::int64_t>("time");
        using I = std::int64_t;
        QTest::newRow("same") << I{5} << 5U << I{5};
        QTest::newRow("after") << I{5} << 9U << I{9};
        QTest::newRow("before") << I{5} << 1U << I{1};
        QTest::newRow("before zero") << I{5} << 0xFFFF'FFFFU << I{-1};
        QTest::newRow("over the wrap") << I{0x1'FFFF'FFFF} << 1U << I{0x2'0000'0001};
        QTest::newRow("back over the wrap") << I{0x2'0000'0001} << 0xFFFF'FFFFU << I{0x1'FFFF'FFFF};
        QTest::newRow("furthest on") << I{0} << 0x7FFF'FFFFU << I{0x7FFF'FFFF};
        QTest::newRow("furthest back") << I{0} << 0x8000'0000U << I{-0x8000'0000LL};
        QTest::newRow("negative base") << I{-0x1'0000'0000} << 2U << I{-0xFFFF'FFFELL};
    }

    void lowerBitsMeanTheNearestTime()
    {
        QFETCH(std::int64_t, base);
        QFETCH(std::uint32_t, low);
        QFETCH(std::int64_t, time);
        QCOMPARE(nearestTime(base, low), time);
    }

    void actionsGoOnByThemselves()
    {
        EventCpo event = goldenEvent();
        event.start = SessionTime{std::chrono::seconds{100}};
        const SessionTime later = event.start + std::chrono::seconds{2};
        const RigidTransform atStart{event.q_AO, event.p_AO};

        event.kind = ActionKind::Rotation; // 2 s at 1.5 rad/s about -y
        const ActedPose turned = evaluate(event, later);
        const Quat turn{std::cos(1.5), 0.0, -std::sin(1.5), 0.0};
        QVERIFY(angleBetween(turned.X_AO.rotation(), turn * event.q_AO).si < 1e-12);
        QVERIFY(turned.X_AO.translation() == event.p_AO);
        QCOMPARE(turned.scale, 2.0);

        event.kind = ActionKind::Translation; // 2 s at 1.5 m/s along -y
        const ActedPose moved = evaluate(event, later);
        QVERIFY((moved.X_AO.translation() - Vec3{1.0, -5.0, 0.5}).norm() < 1e-12);
        QVERIFY(angleBetween(moved.X_AO.rotation(), event.q_AO).si < 1e-12);

        event.kind = ActionKind::Scaling;
        const ActedPose grown = evaluate(event, later);
        QVERIFY(std::abs(grown.scale - 2.0 * std::exp(3.0)) < 1e-9);
        QVERIFY(grown.X_AO.matrix() == atStart.matrix());

        const ActedPose before = evaluate(event, event.start - std::chrono::seconds{2});
        QCOMPARE(before.scale, 2.0);
    }

    void readerStopsAtTheEndForGood()
    {
        const std::array bytes{std::byte{0x01}, std::byte{0x80}, std::byte{0xFF}};
        ByteReader in{bytes};
        QCOMPARE(in.number<std::int16_t>(), std::int16_t{-0x7FFF});
        QVERIFY(in.ok());
        QCOMPARE(in.number<std::uint16_t>(), std::uint16_t{0});
        QVERIFY(!in.ok());
        QCOMPARE(in.number<std::uint8_t>(), std::uint8_t{0});
        QCOMPARE(std::string{in.brokenRule()}, std::string{"length"});
        in.require(false, "another");
        QCOMPARE(std::string{in.brokenRule()}, std::string{"length"});
    }

    void keepsTheSignOf24Bits()
    {
        for (const std::int32_t value : {0, 1, -1, 8388607, -8388608, 0x123456}) {
            std::vector<std::byte> bytes;
            ByteWriter{bytes}.int24(value);
            QCOMPARE(bytes.size(), std::size_t{3});
            QCOMPARE(ByteReader{bytes}.int24(), value);
        }
    }
};

CARINA_TEST(TestWireQuantities)

} // namespace carina::wire_quantities_test

#include "tst_wire_quantities.moc"
