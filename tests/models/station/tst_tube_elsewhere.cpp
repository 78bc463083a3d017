#include "engine/net/objects/remote_object.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/cpo_codec.h"
#include "models/station/intubation_watch.h"
#include "models/station/sent_shape.h"
#include "tests/engine/airway/tube/bent_lumen.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace carina::tube_elsewhere_test
{
namespace
{

using test::BentLumen;
using test::fed;
using namespace std::chrono_literals;

constexpr double kNear_m = 1e-3; ///< from the owner's at the same session time
constexpr SessionTime kBegin{100s};
constexpr Duration kLasts = 4s;
constexpr double kInside = 0.2; ///< metres of tube, when it is in
constexpr int kLostEach = 20;   ///< of the samples

const TubeSize& size()
{
    static const TubeSize it = tubeOfSize(millimetres(7.0)).value();
    return it;
}

/// Into the airway and back, with the greatest speed of this many metres in a second.
double insideAt(SessionTime t, double speed)
{
    const double phase = 2.0 * speed / kInside * toSeconds(t - kBegin);
    return 0.5 * kInside * (1.0 - std::cos(phase));
}

TissueAround still()
{
    return {[](const Vec3& p_A, AirwayTissue) { return p_A; }, {}};
}

/// Who has the tube: a fold of it, and what is sent of it.
class Owner
{
public:
    explicit Owner(double speed)
        : m_speed{speed},
          m_tube{shape(), std::make_shared<const AirwayLumen>(
                              BentLumen{}.lumenFor(0.5 * shape().outerDiameter))}
    {
    }

    [[nodiscard]] RigidTransform connectorAt(SessionTime t) const
    {
        return fed(size(), insideAt(t, m_speed));
    }
    void look(SessionTime now)
    {
        m_tube.follow(
            now - IntubationWatch::kBehind,
            [this](SessionTime t) { return std::optional{connectorAt(t)}; }, still());
        if (m_sent && now - m_sent->time < IntubationWatch::kShapeEach)
            return;
        const TubeAhead lies = drawnAt(now);
        const Length length = m_tube.tube().size().length;
        m_sent = toStream(
            formOf(lies.p_E, length, length - lies.depth, medianPlane(connectorAt(now))), now);
    }
    [[nodiscard]] TubeAhead drawnAt(SessionTime t) const
    {
        return m_tube.ahead(connectorAt(t), still());
    }
    [[nodiscard]] StreamCpo sample(SessionTime t) const
    {
        StreamCpo cpo;
        cpo.sequence = 1;
        cpo.time = t;
        cpo.X_AO = connectorAt(t);
        cpo.shape = m_sent;
        return cpo;
    }

private:
    static TubeShape shape()
    {
        TubeShape it;
        // Two arcs, as of a tube that was touched.
        it.p_E_centre = lineOf(
            {.length = size().length, .entry = size().length, .perMetre = {-6.2, -7.1}}, 200);
        it.p_E_tip = it.p_E_centre.back();
        it.outerDiameter = size().outer;
        it.fitsAirway = false;
        return it;
    }

    double m_speed;
    ElasticTube m_tube;
    std::optional<StreamShape> m_sent;
};

/// As it comes out of a datagram.
StreamCpo carried(const StreamCpo& cpo)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    writeStreamGroup(out, {ParticipantId{1}, 1, StationId{}, {cpo}});
    ByteReader in{bytes};
    return readStreamGroup(in).streams.front();
}

} // namespace

class TestTubeElsewhere : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liesAsItsOwnersAtTheSameSessionTime_data()
    {
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("latency_ms");
        QTest::newRow("slowly, near by") << 0.05 << 5;
        QTest::newRow("slowly, far away") << 0.05 << 60;
        QTest::newRow("fast, near by") << 0.15 << 5;
    }

    void liesAsItsOwnersAtTheSameSessionTime()
    {
        QFETCH(double, speed);
        QFETCH(int, latency_ms);
        Owner owner{speed};
        RemoteObject elsewhere;
        std::deque<StreamCpo> onTheWay;
        SessionTime nextTick = kBegin;
        int sent = 0;
        double most = 0.0;
        for (SessionTime now = kBegin; now < kBegin + kLasts; now += 1ms) {
            if ((now - kBegin) % IntubationWatch::kEach == 0ns)
                owner.look(now);
            if (now >= nextTick) {
                nextTick += StreamTick::kPeriod;
                if (++sent % kLostEach != 0)
                    onTheWay.push_back(carried(owner.sample(now)));
            }
            while (!onTheWay.empty() && onTheWay.front().time + latency_ms * 1ms <= now) {
                elsewhere.take(onTheWay.front(), now);
                onTheWay.pop_front();
            }
            if ((now - kBegin) % 17ms != 0ns || now < kBegin + 500ms)
                continue;
            const auto shape = elsewhere.shapeAt(now);
            QVERIFY(shape);
            const std::vector<Vec3> line = lineOf(*shape);
            const std::vector<Vec3> truth = owner.drawnAt(now).p_E;
            QCOMPARE(line.size(), truth.size());
            for (std::size_t i = 0; i < line.size(); ++i)
                most = std::max(most, (line[i] - truth[i]).norm());
        }
        QVERIFY2(most < kNear_m, qPrintable(QStringLiteral("%1 mm").arg(1e3 * most)));
    }
};

CARINA_TEST(TestTubeElsewhere)

} // namespace carina::tube_elsewhere_test

#include "tst_tube_elsewhere.moc"
