#include "engine/geometry/rotation.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/support/test_class.h"

namespace carina::codec_edges_test
{
namespace
{

/// One record there and back through the bytes of a datagram.
Result<Datagram> thereAndBack(const WireRecord& record)
{
    const std::array records{record};
    const auto datagrams = packDatagrams(records, [] { return BundleHeader{}; });
    return decodeDatagram(datagrams.front());
}

} // namespace

/// What lies just inside the rules of the wire must pass.
class TestCodecEdges : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void carriesRotationsWhicheverComponentIsLargest_data()
    {
        QTest::addColumn<int>("largest");
        QTest::newRow("x") << 0;
        QTest::newRow("y") << 1;
        QTest::newRow("z") << 2;
        QTest::newRow("w") << 3;
    }

    void carriesRotationsWhicheverComponentIsLargest()
    {
        QFETCH(int, largest);
        Eigen::Vector4d coefficients{0.1, -0.2, 0.15, -0.05}; // x y z w
        coefficients[largest] = 0.9;
        StreamCpo stream;
        stream.X_AO = RigidTransform{Quat{coefficients}, Vec3{0.1, -0.2, 0.3}};
        const auto decoded = thereAndBack(StreamGroup{ParticipantId{1}, 1, StationId{}, {stream}});
        QVERIFY2(decoded.has_value(), decoded ? "" : decoded.error().detail.c_str());
        const auto& group = std::get<StreamGroup>(decoded->records.front());
        // Three components of steps of sqrt(2) / (2^16 - 1): at most 2 sqrt(3) half steps of angle.
        const Angle quantisation = radians(std::sqrt(3.0) * std::sqrt(2.0) / 65535.0);
        QVERIFY(angleBetween(group.streams.front().X_AO.rotation(), stream.X_AO.rotation())
                <= quantisation);
    }

    void carriesBodiesOfOneByteAndOfTheMost_data()
    {
        QTest::addColumn<std::size_t>("bytes");
        QTest::newRow("one") << std::size_t{1};
        QTest::newRow("the most") << kLargestFactBody;
    }

    void carriesBodiesOfOneByteAndOfTheMost()
    {
        QFETCH(std::size_t, bytes);
        FactRecord fact;
        fact.number = FactNumber{1};
        fact.body.assign(bytes, std::byte{0x5A});
        const auto decoded = thereAndBack(fact);
        QVERIFY2(decoded.has_value(), decoded ? "" : decoded.error().detail.c_str());
        QVERIFY(std::get<FactRecord>(decoded->records.front()) == fact);
    }
};

CARINA_TEST(TestCodecEdges)

} // namespace carina::codec_edges_test

#include "tst_codec_edges.moc"
