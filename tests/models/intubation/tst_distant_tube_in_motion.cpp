#include "engine/airway/monitor/intubation_monitor.h"
#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/rotation.h"
#include "engine/net/objects/remote_object.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/cpo_codec.h"
#include "models/intubation/distant_tube.h"
#include "models/intubation/intubation_watch.h"
#include "models/patient/laryngoscopy.h"
#include "models/patient/patient_source.h"
#include "tests/engine/airway/tube/feeding_hand.h"
#include "tests/models/patient/lumen_of.h"
#include "tests/support/simulated_link.h"
#include "tests/support/test_class.h"

#include <QEventLoop>

#include <algorithm>
#include <cmath>

namespace carina::distant_tube_in_motion_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kBegin{100s};
constexpr Duration kPicture = 33ms;
constexpr Duration kAtFirst = 300ms;  ///< until samples have arrived
constexpr Duration kRests = 1500ms;   ///< at the end
constexpr Duration kSettles = 1000ms; ///< of that, before it counts as at rest
constexpr Length kInner = millimetres(7.0);
constexpr double kInFront_m = 0.05;     ///< of the teeth, where it begins
constexpr double kAboveCarina_m = 0.19; ///< behind them, where it ends
constexpr double kInBronchus_m = 0.24;
constexpr Length kAtRest = millimetres(0.5);   ///< of both lines, the greatest distance
constexpr Length kPushedOn = millimetres(0.7); ///< likewise, held up while the hand goes on
constexpr Length kNear = millimetres(1.0);     ///< the goal, also in motion

const PatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

/// Curved as tubes are that are sold.
TubeRest rest()
{
    return {tubeOfSize(kInner)->length, {1.0 / 0.14, 1.0 / 0.14}, outerDiameterOf(kInner)};
}

const PatientModel& childWithTube()
{
    static const PatientModel made =
        child().withTube(centrelineOfTube(rest()), rest().outerDiameter);
    return made;
}

const std::shared_ptr<const AirwayLumen>& lumen()
{
    static const auto measured = test::lumenOf(childWithTube());
    return measured;
}

/// The tissue before a blade that is lifted.
struct Lifted {
    Laryngoscopy laryngoscopy = Laryngoscopy::of(child(), bladeOf(kUsualBlade)).value();
    LaryngoscopyPose pose = laryngoscopy.pose(LaryngoscopyStep::Full, kUsualLift);
    AirwayField changes;
    FollowingThroat throat = child().throat(pose.X_AJ);
    BladeField blade = laryngoscopy.tissueAt(pose.X_AL, throat);

    [[nodiscard]] TissueAround tissue() const { return tissueAround(changes, throat, blade); }
};

const Lifted& lifted()
{
    static const Lifted it;
    return it;
}

test::Mouth mouth()
{
    const TissueAround tissue = lifted().tissue();
    return test::mouthOf(moved(*lumen(), tissue.motion, tissue.push));
}

/// Who has the tube: a fold of it, and what is sent of it.
class Owner
{
public:
    Owner(double speed, double until) : m_speed{speed}, m_until{until} {}

    [[nodiscard]] Duration lasts() const { return fromSeconds((m_until + kInFront_m) / m_speed); }
    [[nodiscard]] RigidTransform connectorAt(SessionTime t) const
    {
        return test::fed(m_mouth, rest(),
                         std::min(m_speed * toSeconds(t - kBegin) - kInFront_m, m_until));
    }
    void look(SessionTime now)
    {
        m_tube.follow(now - kReadBehind, seen(), lifted().tissue());
        if (!m_shape || now - m_shape->time >= IntubationWatch::kShapeEach)
            m_shape = toStream(atRest(childWithTube().tube()), childWithTube().ownTube(),
                               drawnAt(now), now);
    }
    [[nodiscard]] std::vector<Vec3> drawnAt(SessionTime t) const
    {
        return m_tube.ahead(t, connectorAt(t), seen(), lifted().tissue());
    }
    /// From now on it has no time for forms; its poses go on.
    void stall() { m_isStalled = true; }
    [[nodiscard]] const TubeTip& tip() const { return m_tube.tube().tip(); }
    [[nodiscard]] std::vector<std::byte> sampleAt(SessionTime t)
    {
        constexpr double kEach_s = 0.01;
        const RigidTransform before = connectorAt(t - fromSeconds(kEach_s));
        StreamCpo cpo;
        cpo.sequence = ++m_sequence;
        cpo.time = t;
        cpo.X_AO = connectorAt(t);
        cpo.motion = StreamMotion{
            (cpo.X_AO.translation() - before.translation()) / kEach_s,
            rotationVector(cpo.X_AO.rotation() * before.rotation().conjugate()) / kEach_s};
        if (!m_isStalled)
            cpo.shape = m_shape;
        std::vector<std::byte> bytes;
        ByteWriter out{bytes};
        writeStreamGroup(out, {ParticipantId{1}, 1, StationId{}, {cpo}});
        return bytes;
    }

private:
    [[nodiscard]] ElasticTube::ConnectorAt seen() const
    {
        return [this](SessionTime t) { return std::optional{connectorAt(t)}; };
    }

    double m_speed;
    double m_until;
    test::Mouth m_mouth = mouth();
    ElasticTube m_tube{childWithTube().tube(), lumen()};
    std::optional<StreamShape> m_shape;
    std::uint16_t m_sequence = 0;
    bool m_isStalled = false;
};

/// Who draws it elsewhere, of the same patient with another tube.
class Elsewhere
{
public:
    Elsewhere() { m_tube.lieIn(child()); }

    void take(const std::vector<std::byte>& bytes, SessionTime now)
    {
        ByteReader in{bytes};
        const StreamCpo cpo = readStreamGroup(in).streams.front();
        if (cpo.sequence <= m_newest)
            return;
        m_newest = cpo.sequence;
        m_poses->take(cpo, now);
    }
    [[nodiscard]] std::vector<Vec3> drawnAt(SessionTime t)
    {
        StationMoment moment;
        moment.time = t;
        moment.tube = m_poses->at(t);
        moment.tubePoses = m_poses;
        moment.tubeShape = m_poses->shapeAt(t);
        return m_tube.at(moment, lifted().tissue()).p_E;
    }
    void awaitLumen() const
    {
        QEventLoop until;
        QObject::connect(&m_tube.lumen(), &PatientLumen::measured, &until, &QEventLoop::quit);
        until.exec();
    }

private:
    std::shared_ptr<RemoteObject> m_poses = std::make_shared<RemoteObject>();
    std::uint16_t m_newest = 0;
    DistantTube m_tube;
};

double farthest(std::span<const Vec3> a, std::span<const Vec3> b)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

} // namespace

/// How far the tube of another lies from where its owner draws it at the same session time, in the
/// frame of its connector: from in front of the teeth to above the carina or beyond it, before a
/// lifted blade.
class TestDistantTubeInMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liesAsItsOwnersAtTheSameSessionTime_data();
    void liesAsItsOwnersAtTheSameSessionTime();
    void staysInTheAirwayForAWhileWithoutAForm();
    void liesInTheSameWayWhereItIsSeenLate();
};

void TestDistantTubeInMotion::liesAsItsOwnersAtTheSameSessionTime_data()
{
    QTest::addColumn<double>("until");
    QTest::addColumn<double>("speed_mm_s");
    QTest::addColumn<int>("delay_ms");
    QTest::addColumn<int>("jitter_ms");
    QTest::addColumn<double>("loss");
    QTest::addColumn<double>("missed"); // share of the pictures beyond kNear in motion, at most
    QTest::addColumn<double>("most_mm");
    QTest::newRow("slowly, near by") << kAboveCarina_m << 20.0 << 5 << 1 << 0.01 << 0.01 << 2.0;
    QTest::newRow("as usual, near by") << kAboveCarina_m << 50.0 << 5 << 1 << 0.01 << 0.05 << 2.0;
    QTest::newRow("as usual, far away") << kAboveCarina_m << 50.0 << 60 << 5 << 0.05 << 0.07 << 3.5;
    QTest::newRow("fast, near by") << kAboveCarina_m << 100.0 << 5 << 1 << 0.01 << 0.05 << 2.5;
    QTest::newRow("into a bronchus, near by")
        << kInBronchus_m << 50.0 << 5 << 1 << 0.01 << 0.09 << 3.5;
    QTest::newRow("into a bronchus, far away")
        << kInBronchus_m << 50.0 << 60 << 5 << 0.05 << 0.09 << 5.0;
    // They are held up at its end, at other moments, and lie in other ways until the form tells.
    QTest::newRow("fast into a bronchus, near by")
        << kInBronchus_m << 100.0 << 5 << 1 << 0.01 << 0.15 << 4.0;
    QTest::newRow("fast into a bronchus, far away")
        << kInBronchus_m << 100.0 << 60 << 5 << 0.05 << 0.30 << 9.0;
}

void TestDistantTubeInMotion::liesAsItsOwnersAtTheSameSessionTime()
{
    QFETCH(double, until);
    QFETCH(double, speed_mm_s);
    QFETCH(int, delay_ms);
    QFETCH(int, jitter_ms);
    QFETCH(double, loss);
    QFETCH(double, missed);
    QFETCH(double, most_mm);
    Owner owner{1e-3 * speed_mm_s, until};
    Elsewhere elsewhere;
    bool isMeasured = false;
    SimulatedLink link{{.delay = delay_ms * 1ms, .jitter = jitter_ms * 1ms, .loss = loss}, 25};
    SessionTime nextTick = kBegin;
    double atRest = 0.0;
    std::vector<double> inMotion;
    for (SessionTime now = kBegin; now < kBegin + owner.lasts() + kRests; now += 1ms) {
        if ((now - kBegin) % IntubationWatch::kEach == 0ns)
            owner.look(now);
        if (now >= nextTick) {
            nextTick += StreamTick::kPeriod;
            link.send(owner.sampleAt(now), now - kBegin);
        }
        while (const auto bytes = link.receive(now - kBegin))
            elsewhere.take(*bytes, now);
        if ((now - kBegin) % kPicture != 0ns || now < kBegin + kAtFirst)
            continue;
        const std::vector<Vec3> line = elsewhere.drawnAt(now);
        if (!std::exchange(isMeasured, true))
            elsewhere.awaitLumen();
        const std::vector<Vec3> truth = owner.drawnAt(now);
        QCOMPARE(line.size(), truth.size());
        const double apart = farthest(line, truth);
        if (now > kBegin + owner.lasts() + kSettles)
            atRest = std::max(atRest, apart);
        else
            inMotion.push_back(apart);
    }
    const auto beyond = std::ranges::count_if(inMotion, [](double it) { return it > kNear.si; });
    const double share = double(beyond) / double(inMotion.size());
    const double farthest_mm = 1e3 * std::ranges::max(inMotion);
    const QString told = QStringLiteral("at rest %1 mm, in motion %2 mm, %3 % beyond 1 mm")
                             .arg(1e3 * atRest, 0, 'f', 2)
                             .arg(farthest_mm, 0, 'f', 1)
                             .arg(100.0 * share, 0, 'f', 1);
    qInfo("%s", qPrintable(told));
    QVERIFY(isThroughCords(owner.tip().seat));
    QCOMPARE(isInMainBronchus(owner.tip().seat), until == kInBronchus_m);
    const bool isPushedOn = until == kInBronchus_m;
    QVERIFY2(atRest < (isPushedOn ? kPushedOn : kAtRest).si, qPrintable(told));
    QVERIFY2(share <= missed && farthest_mm < most_mm, qPrintable(told));
}

/// A computer that does much else has a form now and then: the tube does not leave the airway
/// meanwhile.
void TestDistantTubeInMotion::staysInTheAirwayForAWhileWithoutAForm()
{
    Owner owner{0.05, kAboveCarina_m};
    Elsewhere elsewhere;
    const SessionTime rests = kBegin + owner.lasts() + kRests;
    bool isMeasured = false;
    double farthestStalled = 0.0;
    for (SessionTime now = kBegin; now < rests + DistantTube::kKeptWithout; now += 20ms) {
        owner.look(now);
        if (now >= rests)
            owner.stall();
        elsewhere.take(owner.sampleAt(now), now);
        const std::vector<Vec3> line = elsewhere.drawnAt(now);
        if (!std::exchange(isMeasured, true))
            elsewhere.awaitLumen();
        if (now < rests)
            continue;
        QCOMPARE(line.size(), owner.drawnAt(now).size());
        farthestStalled = std::max(farthestStalled, farthest(line, owner.drawnAt(now)));
    }
    QVERIFY2(farthestStalled < kAtRest.si, qPrintable(QString::number(farthestStalled)));
    const SessionTime later = rests + 2 * DistantTube::kKeptWithout;
    elsewhere.take(owner.sampleAt(later), later);
    QVERIFY(elsewhere.drawnAt(later).empty());
}

/// One who comes later finds it in the bronchus that it went to, though its curve at rest has its
/// tip nearer to another way.
void TestDistantTubeInMotion::liesInTheSameWayWhereItIsSeenLate()
{
    Owner owner{0.1, kInBronchus_m};
    Elsewhere elsewhere;
    const SessionTime rests = kBegin + owner.lasts() + kRests;
    for (SessionTime now = kBegin; now < rests; now += 20ms)
        owner.look(now);
    double apart = 0.0;
    bool isMeasured = false;
    for (SessionTime now = rests; now < rests + kRests; now += 20ms) {
        owner.look(now);
        elsewhere.take(owner.sampleAt(now), now);
        const std::vector<Vec3> line = elsewhere.drawnAt(now);
        if (!std::exchange(isMeasured, true))
            elsewhere.awaitLumen();
        else
            apart = farthest(line, owner.drawnAt(now));
    }
    QVERIFY(isInMainBronchus(owner.tip().seat));
    QVERIFY2(apart < kPushedOn.si, qPrintable(QString::number(1e3 * apart)));
}

CARINA_TEST(TestDistantTubeInMotion)

} // namespace carina::distant_tube_in_motion_test

#include "tst_distant_tube_in_motion.moc"
